//! A mass that falls on a contact of 1e9 N/m: events with a stiff method.

use crate::hybrid::{Motion, march};
use crate::problem::{Equations, Events, Phase, Refused, Reports, Scene, Span};
use crate::scalar::Scalar;
use crate::settings::{Method, Settings};
use crate::shape::{Direction, EventEntry};
use crate::shape::{ModeEntry, Quantity, Shape, Unit};

/// Mass 1 kg, height `x`; in contact a spring and a damper act on it.
#[derive(Clone, Copy)]
struct Ball {
    stiffness: f64,
    damping: f64,
}

/// The ball in flight (0) or in contact (1).
struct Moving<S> {
    stiffness: S,
    damping: S,
}

impl<S: Scalar> Moving<S> {
    /// Force of the contact.
    fn force(&self, phase: Phase<'_, S>, state: [S; 2]) -> S {
        match phase.mode {
            0 => S::ZERO,
            _ => -(self.stiffness * state[0]) - self.damping * state[1],
        }
    }
}

impl<S: Scalar> Equations<S> for Moving<S> {
    fn states(&self) -> usize {
        2
    }

    fn rates(&self, phase: Phase<'_, S>, _instant: &[S], state: &[S], rates: &mut [S]) {
        let force = self.force(phase, [state[0], state[1]]);
        rates.copy_from_slice(&[state[1], force - S::from_f64(9.81)]);
    }

    fn variation(
        &self,
        phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        _columns: &[S],
        products: &mut [S],
    ) {
        self.rates(phase, instant, state, rates);
        products.fill(S::from_f64(f64::NAN));
    }

    fn jacobian(&self, phase: Phase<'_, S>, _instant: &[S], _state: &[S], columns: &mut [S]) {
        let by_place = self.force(phase, [S::ONE, S::ZERO]);
        let by_speed = self.force(phase, [S::ZERO, S::ONE]);
        columns.copy_from_slice(&[S::ZERO, by_place, S::ONE, by_speed]);
    }
}

impl<S: Scalar> Reports<S> for Moving<S> {}

impl<S: Scalar> Events<S> for Moving<S> {
    fn guards(
        &self,
        _phase: Phase<'_, S>,
        _time: S,
        state: &[S],
        values: &mut [S],
        rates: &mut [S],
    ) {
        (values[0], rates[0]) = (state[0], state[1]);
    }
}

impl Scene for Ball {
    type Equations<S: Scalar> = Moving<S>;

    type Unreduced = Self;
    const SMOOTH: bool = false;

    fn shape(&self) -> &'static Shape {
        const STATES: &[Quantity] =
            &[Quantity::new("x", "", Unit::NONE), Quantity::new("dot(x)", "", Unit::NONE)];
        const MODES: &[ModeEntry] = &[
            ModeEntry::new(
                "flight",
                "",
                &[EventEntry::new(1, "when x falls to 0", Direction::Falls, "m", 1.0, 1)],
            ),
            ModeEntry::new(
                "contact",
                "",
                &[EventEntry::new(2, "when x rises to 0", Direction::Rises, "m", 1.0, 0)],
            ),
        ];
        const { &Shape::named("ball").states(STATES, &[1.0, 1.0]).modes(MODES, 0) }
    }

    fn prepare<S: Scalar>(&self) -> Moving<S> {
        Moving { stiffness: S::from_f64(self.stiffness), damping: S::from_f64(self.damping) }
    }

    fn events<S: Scalar>(equations: &Moving<S>) -> Option<&dyn Events<S>> {
        Some(equations)
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

fn fall(ball: Ball, method: Method, rtol: f64, end: f64) -> Motion {
    let settings = Settings::new(method).rtol(rtol);
    march(&ball, (0.0, end), &[1.0, 0.0], &settings).unwrap()
}

/// Without damping every bounce is like the first: from the height `H` it lasts
/// `2 √(2H/g) + 2 (π - arctan(v/(g/ω))) / ω`, with `v = √(2gH)`.
#[test]
fn a_stiff_contact_gives_the_ball_back() {
    let ball = Ball { stiffness: 1e9, damping: 0.0 };
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
    let ball = Ball { stiffness: 1e9, damping: 2e4 };
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
