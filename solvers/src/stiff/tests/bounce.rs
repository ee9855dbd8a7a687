//! A mass that falls on a contact of 1e9 N/m: events with a stiff method.

use crate::hybrid::{Hybrid, Modes, Motion, march};
use crate::problem::{Equations, Refused, Scene, Span};
use crate::registry::{Method, Settings};
use crate::scalar::Scalar;
use crate::shape::{Direction, EventEntry};
use crate::shape::{ModeEntry, Quantity, Shape, Unit};

/// Mass 1 kg, height `x`; in contact a spring and a damper act on it.
#[derive(Clone, Copy)]
struct Ball {
    stiffness: f64,
    damping: f64,
}

/// The ball in flight (0) or in contact (1).
#[derive(Clone, Copy)]
struct Moving<S> {
    stiffness: S,
    damping: S,
    mode: usize,
}

impl<S: Scalar> Moving<S> {
    /// Force of the contact.
    fn force(&self, state: &[S; 2]) -> S {
        match self.mode {
            0 => S::ZERO,
            _ => -(self.stiffness * state[0]) - self.damping * state[1],
        }
    }
}

impl<S: Scalar> Equations<S> for Moving<S> {
    type State = [S; 2];
    type Instant = S;

    fn states(&self) -> usize {
        2
    }

    fn instant(&self, time: S) -> S {
        time
    }

    fn instants<const K: usize>(&self, times: [S; K]) -> [S; K] {
        times
    }

    fn derivative(&self, _instant: &S, state: &[S; 2], rate: &mut [S; 2]) {
        *rate = [state[1], self.force(state) - S::from_f64(9.81)];
    }

    fn variation(
        &self,
        instant: &S,
        state: &[S; 2],
        rate: &mut [S; 2],
        _columns: &[[S; 2]],
        products: &mut [[S; 2]],
    ) {
        self.derivative(instant, state, rate);
        products.fill([S::from_f64(f64::NAN); 2]);
    }

    fn jacobian(&self, _instant: &S, _state: &[S; 2], columns: &mut [[S; 2]]) {
        columns[0] = [S::ZERO, self.force(&[S::ONE, S::ZERO])];
        columns[1] = [S::ONE, self.force(&[S::ZERO, S::ONE])];
    }

    fn outputs(&self, _time: S, _state: &[S; 2], _values: &mut [S]) {}

    fn drivers(&self, _time: S, _values: &mut [S]) {}
}

impl<S: Scalar> Modes<S> for Moving<S> {
    fn mode(&self) -> usize {
        self.mode
    }

    fn enter(&mut self, mode: usize) {
        self.mode = mode;
    }

    fn side(&mut self, _surface: usize, _side: S) {}

    fn guards(&self, _instant: &S, state: &[S; 2], values: &mut [S], rates: &mut [S]) {
        (values[0], rates[0]) = (state[0], state[1]);
    }

    fn permits(&self, _event: usize, _instant: &S, _state: &[S; 2]) -> bool {
        true
    }

    fn jump(&self, _event: usize, _instant: &S, state: &[S; 2], after: &mut [S; 2]) {
        *after = *state;
    }
}

impl Scene for Ball {
    type Equations<S: Scalar> = Moving<S>;
    fn shape() -> &'static Shape {
        const STATES: &[Quantity] = &[
            Quantity::new("x", "", Unit::NONE),
            Quantity::new("dot(x)", "", Unit::NONE),
        ];
        const MODES: &[ModeEntry] = &[
            ModeEntry::new(
                "flight",
                "",
                &[EventEntry::new(
                    1,
                    "when x falls to 0",
                    Direction::Falls,
                    "m",
                    1.0,
                    1,
                )],
            ),
            ModeEntry::new(
                "contact",
                "",
                &[EventEntry::new(
                    2,
                    "when x rises to 0",
                    Direction::Rises,
                    "m",
                    1.0,
                    0,
                )],
            ),
        ];
        const {
            &Shape::named("ball")
                .states(STATES, &[1.0, 1.0])
                .modes(MODES, 0)
        }
    }

    fn prepare<S: Scalar>(&self) -> Moving<S> {
        Moving {
            stiffness: S::from_f64(self.stiffness),
            damping: S::from_f64(self.damping),
            mode: 0,
        }
    }

    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }

    fn span(&self) -> Span {
        Span::Run(0.0, 10.0)
    }

    fn start(&self) -> Vec<f64> {
        vec![1.0, 0.0]
    }
}

impl Hybrid for Ball {
    type Modal<S: Scalar> = Moving<S>;

    fn modal<S: Scalar>(&self) -> Moving<S> {
        self.prepare()
    }
}

fn fall(ball: Ball, method: Method, rtol: f64, end: f64) -> Motion {
    let settings = Settings::new(method, rtol);
    march(&ball, (0.0, end), &[1.0, 0.0], &settings).unwrap()
}

/// Without damping every bounce is like the first: from the height `H` it lasts
/// `2 √(2H/g) + 2 (π - arctan(v/(g/ω))) / ω`, with `v = √(2gH)`.
#[test]
fn a_stiff_contact_gives_the_ball_back() {
    let ball = Ball {
        stiffness: 1e9,
        damping: 0.0,
    };
    let (g, omega) = (9.81, 1e9_f64.sqrt());
    let fall_time = (2.0 / g).sqrt();
    let contact = 2.0 * (std::f64::consts::PI - (omega * (2.0 * g).sqrt() / g).atan()) / omega;
    for method in [Method::Radau, Method::Rosenbrock, Method::Auto] {
        let motion = fall(ball, method, 1e-10, 4.0);
        println!("{method:?} {:?}", motion.statistics);
        for (number, event) in motion.events.iter().enumerate() {
            let bounce = (number / 2) as f64 * (2.0 * fall_time + contact);
            let expected = fall_time + bounce + (number % 2) as f64 * contact;
            let error = (event.time - expected).abs();
            assert!(error < 1e-6, "{method:?} {number} {error:e}");
            assert!(event.guard.abs() < 1e-12, "{method:?} {event:?}");
        }
        assert_eq!(motion.events.len(), 8);
    }
}

/// A contact that absorbs: the ball comes to rest in it, where its equations are as stiff as ever.
#[test]
fn rest_in_a_stiff_contact_costs_nothing() {
    let ball = Ball {
        stiffness: 1e9,
        damping: 2e4,
    };
    let naive = fall(ball, Method::Dop853, 1e-6, 10.0).statistics;
    assert!(naive.evaluations > 100_000, "{naive:?}");
    for method in [Method::Radau, Method::Rosenbrock, Method::Auto] {
        let motion = fall(ball, method, 1e-6, 10.0);
        let switches: Vec<_> = motion.switches().collect();
        println!("{method:?} {:?} {switches:?}", motion.statistics);
        assert_eq!(motion.mode, 1);
        assert!((motion.end[0] + 9.81e-9).abs() < 1e-6, "{:?}", motion.end);
        assert!(motion.statistics.evaluations < 10_000);
        assert_eq!(switches.is_empty(), method != Method::Auto);
    }
}

/// The same, a hundred times stiffer than any contact.
#[test]
fn the_rigid_limit_is_no_harder() {
    let work = [1e9, 1e11].map(|stiffness: f64| {
        let damping = 0.6 * stiffness.sqrt();
        let ball = Ball { stiffness, damping };
        let work = [Method::Radau, Method::Rosenbrock]
            .map(|method| fall(ball, method, 1e-6, 10.0).statistics.evaluations);
        println!("{stiffness:e} {work:?}");
        work
    });
    assert!(work[1][0] < 3 * work[0][0] && work[1][1] < 3 * work[0][1]);
}
