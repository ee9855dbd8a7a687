//! The presser foot by hand for the solvers of Assur: what the macro emits from `presser_foot.eqn`, scene `elliptic`, as
//! an engineer would write it. So the emitted code is compared with hand-written code in the same loop.

use assur::problem::{Equations, Events, Phase, Refused, Reports, Scene, Span};
use assur::scalar::Scalar;
use assur::shape::{Direction, EventEntry, ModeEntry, Quantity, Shape, Unit};

use crate::foot::{PERIOD, START};

/// On the fabric, and in the air.
const CONTACT: usize = 0;
const FLIGHT: usize = 1;

/// The scene; its values are those of `Foot`.
#[derive(Clone, Copy, Debug)]
pub struct HandFoot;

/// The equations. Forces are divided by the mass.
#[derive(Clone, Copy, Debug)]
pub struct Moving<S> {
    c2: S,
    c3: S,
    mu2: S,
    c1: S,
    mu1: S,
    preload: S,
    omega: S,
    edge: S,
    height: S,
}

/// The height of the rack above the plate with two rates.
#[derive(Clone, Copy, Debug)]
pub struct Rack<S> {
    y: S,
    dy: S,
    ddy: S,
}

impl<S: Scalar> Rack<S> {
    /// Height and first rate from a row.
    #[inline(always)]
    fn of(row: &[S]) -> Self {
        Self { y: row[0], dy: row[1], ddy: S::ZERO }
    }
}

impl<S: Scalar> Moving<S> {
    #[inline(always)]
    fn rack(&self, (sine, cosine): (S, S)) -> Rack<S> {
        let speed = self.height * self.omega;
        // The shaft is half a turn behind.
        Rack {
            y: self.height * (-cosine - self.edge),
            dy: speed * sine,
            ddy: speed * self.omega * cosine,
        }
    }

    /// What the fabric lies on: the rack where it is above the plate. The side says where it is, or 0 its height.
    #[inline(always)]
    fn ground(&self, rack: &Rack<S>, side: S) -> Rack<S> {
        let height = S::select(S::equal(side, S::ZERO), rack.y, side);
        let on = |value| S::select(S::less(S::ZERO, height), value, S::ZERO);
        Rack { y: on(rack.y), dy: on(rack.dy), ddy: on(rack.ddy) }
    }

    /// `w''` without the fabric.
    #[inline(always)]
    fn free(&self, y: &[S; 2]) -> S {
        -(self.mu1 * y[1] + (self.c1 * y[0] + self.preload))
    }

    /// The force of the fabric with its rate, where the speed changes by `rate`.
    #[inline(always)]
    fn fabric(&self, ground: &Rack<S>, y: &[S; 2], rate: S) -> (S, S) {
        let (delta, slope) = (ground.y - y[0], ground.dy - y[1]);
        let square = self.c3 * delta * delta;
        (
            (self.c2 + square) * delta + self.mu2 * slope,
            (self.c2 + S::from_f64(3.0) * square) * slope + self.mu2 * (ground.ddy - rate),
        )
    }
}

impl<S: Scalar> Equations<S> for Moving<S> {
    #[inline(always)]
    fn states(&self) -> usize {
        2
    }

    #[inline(always)]
    fn instant(&self) -> usize {
        2
    }

    #[inline(always)]
    fn instants(&self, phase: Phase<'_, S>, times: &[S], rows: &mut [S]) {
        if phase.mode == FLIGHT || S::holds(S::less(phase.side(0), S::ZERO)) {
            return;
        }
        let (rows, _) = rows.as_chunks_mut::<2>();
        for (times, rows) in times.chunks(4).zip(rows.chunks_mut(4)) {
            let mut angles = [S::ZERO; 4];
            for (k, angle) in angles.iter_mut().enumerate() {
                *angle = self.omega * times[k.min(times.len() - 1)];
            }
            let (sines, cosines) = S::sin_cos_all(angles);
            for (k, row) in rows.iter_mut().enumerate() {
                let rack = self.rack((sines[k], cosines[k]));
                *row = [rack.y, rack.dy];
            }
        }
    }

    #[inline(always)]
    fn rates(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], rates: &mut [S]) {
        let (Some(y), Some(rate)) = (state.first_chunk(), rates.first_chunk_mut()) else {
            return;
        };
        let free = self.free(y);
        *rate = match phase.mode {
            FLIGHT => [y[1], free],
            _ => {
                let ground = self.ground(&Rack::of(instant), phase.side(0));
                [y[1], self.fabric(&ground, y, S::ZERO).0 + free]
            }
        };
    }

    fn variation(
        &self,
        phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        self.rates(phase, instant, state, rates);
        let mut slopes = [S::ZERO; 4];
        self.jacobian(phase, instant, state, &mut slopes);
        for (column, product) in columns.chunks(2).zip(products.chunks_mut(2)) {
            product[0] = column[1];
            product[1] = slopes[1] * column[0] + slopes[3] * column[1];
        }
    }

    fn jacobian(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], columns: &mut [S]) {
        let [stiffness, damping] = match phase.mode {
            FLIGHT => [S::ZERO; 2],
            _ => {
                let delta = self.ground(&Rack::of(instant), phase.side(0)).y - state[0];
                let stiffness = self.c2 + S::from_f64(3.0) * self.c3 * delta * delta;
                [stiffness, self.mu2]
            }
        };
        let slopes = [-self.c1 - stiffness, -self.mu1 - damping];
        columns.copy_from_slice(&[S::ZERO, slopes[0], S::ONE, slopes[1]]);
    }
}

impl<S: Scalar> Reports<S> for Moving<S> {
    fn drivers(&self, time: S, values: &mut [S]) {
        values[0] = self.omega * time;
    }
}

impl<S: Scalar> Events<S> for Moving<S> {
    fn guards(&self, phase: Phase<'_, S>, time: S, state: &[S], values: &mut [S], rates: &mut [S]) {
        let Some(y) = state.first_chunk() else {
            return;
        };
        let angle = self.omega * time;
        let rack = self.rack(S::sin_cos(angle));
        let (ground, free) = (self.ground(&rack, S::ZERO), self.free(y));
        let turn = (angle, self.omega);
        let pairs = match phase.mode {
            FLIGHT => {
                let (force, rate) = self.fabric(&ground, y, free);
                [(ground.y - y[0], ground.dy - y[1]), (force, rate), (rack.y, rack.dy), turn]
            }
            _ => {
                let (force, _) = self.fabric(&ground, y, S::ZERO);
                let rate = self.fabric(&ground, y, force + free).1;
                [(force, rate), (rack.y, rack.dy), turn, turn]
            }
        };
        for ((value, rate), (one, change)) in values.iter_mut().zip(rates).zip(pairs) {
            (*value, *rate) = (one, change);
        }
    }

    fn permits(&self, phase: Phase<'_, S>, event: usize, time: S, state: &[S]) -> bool {
        let Some(y) = state.first_chunk().filter(|_| phase.mode == FLIGHT) else {
            return true;
        };
        let rack = self.rack(S::sin_cos(self.omega * time));
        let ground = self.ground(&rack, S::ZERO);
        let other = match event {
            0 => self.fabric(&ground, y, S::ZERO).0,
            _ => ground.y - y[0],
        };
        S::holds(S::less(S::ZERO, other))
    }
}

impl Scene for HandFoot {
    type Equations<S: Scalar> = Moving<S>;

    type Unreduced = Self;
    const SMOOTH: bool = false;

    fn shape(&self) -> &'static Shape {
        const STATES: &[Quantity] =
            &[Quantity::new("w", "", Unit::NONE), Quantity::new("dot(w)", "", Unit::NONE)];
        const DRIVERS: &[Quantity] = &[Quantity::new("phi", "", Unit::NONE)];
        const { &Shape::named("foot").drivers(DRIVERS).states(STATES, &[1e-3; 2]).modes(MODES, CONTACT) }
    }

    fn prepare<S: Scalar>(&self) -> Moving<S> {
        let m = 0.15;
        let edge = 60f64.to_radians().cos();
        let number = S::from_f64;
        Moving {
            c2: number(1e5 / m),
            c3: S::ZERO,
            mu2: number(30.0 / m),
            c1: number(2000.0 / m),
            mu1: number(2.0 / m),
            preload: number(40.0 / m + 9.80665),
            omega: number(300.0),
            edge: number(edge),
            height: number(1e-3 / (1.0 - edge)),
        }
    }

    fn events<S: Scalar>(equations: &Moving<S>) -> Option<&dyn Events<S>> {
        Some(equations)
    }

    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }

    fn span(&self) -> Span {
        Span::Periodic(PERIOD)
    }

    fn start(&self) -> Vec<f64> {
        START.to_vec()
    }
}

/// An event of the foot.
const fn event(text: &'static str, direction: Direction, target: usize, line: u32) -> EventEntry {
    EventEntry::new(line, text, direction, "", 1.0, target)
}

const MODES: &[ModeEntry] = &[
    ModeEntry::new(
        "contact",
        "",
        &[
            event("the force falls to zero", Direction::Falls, FLIGHT, 1),
            event("the rack passes the plate", Direction::Crosses, CONTACT, 4).surface(0),
        ],
    )
    .bends(0, 1),
    ModeEntry::new(
        "flight",
        "",
        &[
            event("the fabric is reached", Direction::Rises, CONTACT, 2).conditional(),
            event("the force rises", Direction::Rises, CONTACT, 3).conditional(),
        ],
    )
    .bends(1, 1),
];
