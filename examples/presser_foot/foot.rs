//! A foot on a path and a fabric, its steady motion, and what that comes to.

use assur::hybrid::{self, Cycle, CycleError, Motion, Periods};
use assur::measure;
use assur::prelude::*;
use assur::shape;
use assur_equations::presser_foot as scenes;
use std::f64::consts::TAU;

const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-9);

/// The rack and the fabric.
#[derive(Clone, Copy)]
pub enum Foot {
    /// Rise in mm.
    Ellipse(f64),
    /// Rise in mm, straight part in degrees.
    Straight(f64, f64),
    /// The straight path of 0.5 mm with another transition.
    Shaped([f64; 3]),
    /// The feed mechanism itself.
    Machine,
    /// So many harmonics of the ellipse of 1 mm.
    Harmonics(u8),
    /// So many harmonics of the feed mechanism.
    MachineHarmonics(u8),
    Progressive,
    Stiff,
    HuntCrossley,
    /// The ellipse of 1 mm over a plate of this stiffness in N/m.
    Plate(f64),
    /// The straight path of 0.5 mm over a plate of 1e6 N/m, below which the rack drops by so many mm.
    PlateDrop(f64),
}
use Foot::*;

/// How the foot is driven.
#[derive(Clone, Copy)]
pub struct Drive {
    /// Speed of the shaft in 1/s.
    pub omega: f64,
    /// Preload in N.
    pub preload: f64,
    /// Force from which on the foot holds the fabric, in N.
    pub hold: f64,
}

impl Drive {
    pub fn at(omega: f64) -> Self {
        Self { omega, preload: 40.0, hold: 5.0 }
    }

    pub fn period(self) -> f64 {
        TAU / self.omega
    }
}

/// A scene of the file with a drive and some values of its own.
macro_rules! scene {
    ($scene:ident, $drive:expr $(, $field:ident = $value:expr)*) => {
        Box::new(scenes::$scene {
            omega: $drive.omega,
            F10: $drive.preload,
            F_min: $drive.hold,
            $($field: $value,)*
            ..Default::default()
        })
    };
}

impl Foot {
    pub fn name(self) -> String {
        match self {
            Ellipse(rise) => format!("ellipse {rise} mm"),
            Straight(rise, 60.0) => format!("straight {rise} mm"),
            Straight(rise, angle) => format!("straight {rise} mm {angle} deg"),
            Shaped(_) => "another transition".into(),
            Machine => "feed mechanism".into(),
            Harmonics(5) => "five harmonics 1 mm".into(),
            Harmonics(order) => format!("{order} harmonics 1 mm"),
            MachineHarmonics(order) => format!("{order} of the mechanism"),
            Progressive => "ellipse, progressive".into(),
            Stiff => "ellipse, stiff".into(),
            HuntCrossley => "ellipse, Hunt-Crossley".into(),
            Plate(stiffness) => format!("plate of {stiffness:e} N/m"),
            PlateDrop(drop) => format!("straight, drop of {drop} mm"),
        }
    }

    /// The scene with a drive.
    pub fn driven(self, drive: Drive) -> Box<dyn Driven> {
        match self {
            Ellipse(rise) => scene!(Elliptic, drive, rise = 1e-3 * rise),
            Straight(rise, angle) => {
                scene!(Straight, drive, rise = 1e-3 * rise, phi_v = angle.to_radians())
            }
            Shaped([q1, q2, q3]) => scene!(Straight, drive, q1 = q1, q2 = q2, q3 = q3),
            Machine => scene!(Machine, drive),
            Harmonics(order) => scene!(FiveHarmonics, drive, order = f64::from(order)),
            MachineHarmonics(order) => scene!(MachineHarmonics, drive, order = f64::from(order)),
            Progressive => scene!(Progressive, drive),
            Stiff => scene!(Elliptic, drive, c2 = 4e5, mu2 = 40.0),
            HuntCrossley => scene!(HuntCrossley, drive),
            Plate(stiffness) => scene!(Yielding, drive, c_p = stiffness),
            PlateDrop(drop) => scene!(YieldingStraight, drive, drop = 1e-3 * drop),
        }
    }

    /// What its steady motion comes to.
    pub fn outcome(self, drive: Drive) -> Outcome {
        let scene = self.driven(drive);
        match scene.cycle(None, drive.period()) {
            Ok(cycle) => scene.outcome(Some(cycle.multiple), &cycle.motion),
            Err(CycleError::NoneStable { .. }) => {
                let motion = scene.march(None, 200.0 * drive.period());
                scene.outcome(None, &motion)
            }
            Err(error) => panic!("{error}"),
        }
    }
}

/// What a motion comes to.
#[derive(Clone, Copy)]
pub struct Outcome {
    /// Turns until it repeats; none if nothing that repeats is stable.
    pub turns: Option<usize>,
    /// Forces on the working stroke and of all, in N.
    pub largest: f64,
    pub smallest: f64,
    pub mean: f64,
    pub least: f64,
    /// Part of the time without contact.
    pub free: f64,
    pub lift_offs: f64,
    /// Feed of a turn while the foot holds the fabric, in mm.
    pub feed: f64,
}

/// Mode and state at the bottom of a turn.
pub type Place = (usize, Vec<f64>);

/// What is asked of a scene with its values, whichever it is. Without a place it begins as the file says.
pub trait Driven {
    /// The stable motion that a place leads to.
    fn cycle(&self, from: Option<&Place>, period: f64) -> Result<Cycle, CycleError>;
    /// The motion from there up to a time.
    fn march(&self, from: Option<&Place>, end: f64) -> Motion;
    /// The largest Lyapunov exponent from there, 1/s.
    fn exponent(&self, from: &Place, period: f64, counted: usize) -> f64;
    /// What a motion comes to.
    fn outcome(&self, turns: Option<usize>, motion: &Motion) -> Outcome;
    /// An output by its name.
    fn output(&self, name: &str, motion: &Motion, time: f64) -> f64;
}

impl<C: Scene> Driven for C {
    fn cycle(&self, from: Option<&Place>, period: f64) -> Result<Cycle, CycleError> {
        match from {
            Some((mode, state)) => hybrid::cycle_from(self, (*mode, state), period, &SETTINGS),
            None => hybrid::cycle(self, period, &SETTINGS),
        }
    }

    fn march(&self, from: Option<&Place>, end: f64) -> Motion {
        let motion = match from {
            Some((mode, state)) => hybrid::march_in(self, *mode, (0.0, end), state, &SETTINGS),
            None => hybrid::march(self, (0.0, end), &self.start(), &SETTINGS),
        };
        motion.unwrap_or_else(|error| panic!("{error}"))
    }

    fn exponent(&self, (mode, state): &Place, period: f64, counted: usize) -> f64 {
        let periods = Periods { settling: 10, counted };
        let found = hybrid::lyapunov(self, (*mode, state), period, periods, &SETTINGS);
        found.unwrap_or_else(|error| panic!("{error}")).exponents[0]
    }

    fn outcome(&self, turns: Option<usize>, motion: &Motion) -> Outcome {
        let measures = scenes::MECHANISM.scenes[0].measures;
        let values = measure::of(self, motion);
        let value = |name: &str| {
            let place = measures.iter().position(|one| one.name == name).unwrap();
            values[place].unwrap_or(f64::NAN)
        };
        Outcome {
            turns,
            largest: value("F_largest"),
            smallest: value("F_smallest").max(0.0),
            mean: value("F_mean"),
            least: value("F_least").max(0.0),
            free: value("free"),
            lift_offs: value("flights") / value("turns"),
            feed: 1e3 * value("real_feed"),
        }
    }

    fn output(&self, name: &str, motion: &Motion, time: f64) -> f64 {
        let (mode, values) = motion.at(time);
        let model: &dyn Model = &Bound::new(self);
        model.outputs_in(mode, time, &values)[shape::find(self.shape().outputs, name).unwrap()]
    }
}
