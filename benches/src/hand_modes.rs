//! The presser foot by hand for the solvers of Assur: what the macro emits from `presser_foot.eqn`, scene `elliptic`, as
//! an engineer would write it. So the emitted code is compared with hand-written code in the same loop.

use assur::shape::{ModeEntry, Quantity, Shape, Unit};
use assur::hybrid::{Hybrid, Modes};
use assur::shape::{Direction, EventEntry};
use assur::problem::{Equations, Refused, Scene, Span};
use assur::scalar::Scalar;

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
    mode: usize,
    /// On which side of the plate the rack is, 0 where its height says it.
    side: S,
}

/// The angle of the shaft, and the height of the rack above the plate with two rates.
#[derive(Clone, Copy, Debug)]
pub struct Rack<S> {
    angle: S,
    y: S,
    dy: S,
    ddy: S,
}

impl<S: Scalar> Moving<S> {
    #[inline(always)]
    fn rack(&self, angle: S, (sine, cosine): (S, S)) -> Rack<S> {
        let speed = self.height * self.omega;
        // The shaft is half a turn behind.
        Rack {
            angle,
            y: self.height * (-cosine - self.edge),
            dy: speed * sine,
            ddy: speed * self.omega * cosine,
        }
    }

    /// What the fabric lies on: the rack where it is above the plate.
    #[inline(always)]
    fn ground(&self, rack: &Rack<S>, side: S) -> Rack<S> {
        let height = S::select(S::equal(side, S::ZERO), rack.y, side);
        let on = |value| S::select(S::less(S::ZERO, height), value, S::ZERO);
        Rack {
            angle: rack.angle,
            y: on(rack.y),
            dy: on(rack.dy),
            ddy: on(rack.ddy),
        }
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
    type State = [S; 2];
    type Instant = Rack<S>;

    fn states(&self) -> usize {
        2
    }

    fn instant(&self, time: S) -> Rack<S> {
        let angle = self.omega * time;
        self.rack(angle, S::sin_cos(angle))
    }

    #[inline(always)]
    fn instants<const K: usize>(&self, times: [S; K]) -> [Rack<S>; K] {
        let nothing = Rack {
            angle: S::ZERO,
            y: S::ZERO,
            dy: S::ZERO,
            ddy: S::ZERO,
        };
        let mut racks = [nothing; K];
        if self.mode == FLIGHT || S::holds(S::less(self.side, S::ZERO)) {
            return racks;
        }
        let angles = times.map(|time| self.omega * time);
        let (sines, cosines) = S::sin_cos_all(angles);
        for (k, rack) in racks.iter_mut().enumerate() {
            *rack = self.rack(angles[k], (sines[k], cosines[k]));
        }
        racks
    }

    #[inline(always)]
    fn derivative(&self, rack: &Rack<S>, y: &[S; 2], rate: &mut [S; 2]) {
        let free = self.free(y);
        let ground = self.ground(rack, self.side);
        *rate = match self.mode {
            FLIGHT => [y[1], free],
            _ => [y[1], self.fabric(&ground, y, S::ZERO).0 + free],
        };
    }

    fn variation(
        &self,
        rack: &Rack<S>,
        y: &[S; 2],
        rate: &mut [S; 2],
        columns: &[[S; 2]],
        products: &mut [[S; 2]],
    ) {
        self.derivative(rack, y, rate);
        let mut slopes = [[S::ZERO; 2]; 2];
        self.jacobian(rack, y, &mut slopes);
        for (column, product) in columns.iter().zip(products) {
            *product = [
                column[1],
                slopes[0][1] * column[0] + slopes[1][1] * column[1],
            ];
        }
    }

    fn jacobian(&self, rack: &Rack<S>, y: &[S; 2], columns: &mut [[S; 2]]) {
        let delta = self.ground(rack, self.side).y - y[0];
        let stiffness = self.c2 + S::from_f64(3.0) * self.c3 * delta * delta;
        let [stiffness, damping] = match self.mode {
            FLIGHT => [S::ZERO; 2],
            _ => [stiffness, self.mu2],
        };
        columns[0] = [S::ZERO, -self.c1 - stiffness];
        columns[1] = [S::ONE, -self.mu1 - damping];
    }

    fn outputs(&self, _time: S, _state: &[S; 2], _values: &mut [S]) {}

    fn drivers(&self, time: S, values: &mut [S]) {
        values[0] = self.omega * time;
    }
}

impl<S: Scalar> Modes<S> for Moving<S> {
    fn mode(&self) -> usize {
        self.mode
    }

    fn enter(&mut self, mode: usize) {
        self.mode = mode;
    }

    fn side(&mut self, _surface: usize, side: S) {
        self.side = side;
    }

    #[inline(always)]
    fn guards(&self, rack: &Rack<S>, y: &[S; 2], values: &mut [S], rates: &mut [S]) {
        let (ground, free) = (self.ground(rack, S::ZERO), self.free(y));
        let turn = (rack.angle, self.omega);
        let pairs = match self.mode {
            FLIGHT => {
                let (force, rate) = self.fabric(&ground, y, free);
                [
                    (ground.y - y[0], ground.dy - y[1]),
                    (force, rate),
                    (rack.y, rack.dy),
                    turn,
                ]
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

    fn permits(&self, event: usize, rack: &Rack<S>, y: &[S; 2]) -> bool {
        if self.mode == CONTACT {
            return true;
        }
        let ground = self.ground(rack, S::ZERO);
        let other = match event {
            0 => self.fabric(&ground, y, S::ZERO).0,
            _ => ground.y - y[0],
        };
        S::holds(S::less(S::ZERO, other))
    }

    fn jump(&self, _event: usize, _rack: &Rack<S>, y: &[S; 2], after: &mut [S; 2]) {
        *after = *y;
    }
}

impl Scene for HandFoot {
    type Equations<S: Scalar> = Moving<S>;

    fn shape() -> &'static Shape {
        const STATES: &[Quantity] = &[Quantity::new("w", "", Unit::NONE), Quantity::new("dot(w)", "", Unit::NONE)];
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
            mode: CONTACT,
            side: S::ZERO,
        }
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
    ModeEntry::new("contact", "", &[
        event("the force falls to zero", Direction::Falls, FLIGHT, 1),
        event("the rack passes the plate", Direction::Crosses, CONTACT, 4).surface(0),
    ])
    .bends(0, 1),
    ModeEntry::new("flight", "", &[
        event("the fabric is reached", Direction::Rises, CONTACT, 2).conditional(),
        event("the force rises", Direction::Rises, CONTACT, 3).conditional(),
    ])
    .bends(1, 1),
];

impl Hybrid for HandFoot {
    type Modal<S: Scalar> = Moving<S>;

    fn modal<S: Scalar>(&self) -> Moving<S> {
        self.prepare()
    }
}
