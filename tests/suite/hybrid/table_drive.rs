//! The table drive: closed forms at 50 digits, a second computation from event to event, laws, hard cases, the tables of
//! the paper.

mod closed_forms;
mod hard;
mod laws;
mod published;
mod stepped;

use assur::hybrid::{Happened, Motion, march};
use assur::prelude::*;
use assur_equations::table_drive::*;
use serde_json::Value;
use std::sync::LazyLock;

/// As accurately as the solvers can.
const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-13);

static REFERENCE: LazyLock<Value> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../reference/table_drive.json")).unwrap()
});

/// A scene whose values are set by name.
trait Drive: Scene + Default {
    fn set(&mut self, name: &str, value: f64);

    /// A scene with some of its values changed.
    fn with(changes: &[(&str, f64)]) -> Self {
        let mut drive = Self::default();
        for (name, value) in changes {
            drive.set(name, *value);
        }
        drive
    }
}

macro_rules! drives {
    ($($scene:ident: $($field:ident)+;)+) => {$(
        impl Drive for $scene {
            fn set(&mut self, name: &str, value: f64) {
                match name {
                    $(stringify!($field) => self.$field = value,)+
                    _ => panic!("no constant `{name}`"),
                }
            }
        }
    )+};
}

drives! {
    Table1: J1 J2 c beta Mc Ms omega;
    Table2: J1 J2 c beta Mc Ms omega;
    Printed: J1 J2 c beta Mc Ms omega;
    Balance: J1 J2 c beta Mc Ms omega;
    Full: J1 J2 c beta Mc Ms omega;
    Constant: J1 J2 c beta Mc Ms;
    Kloss: J1 J2 c beta Mc Ms omega s_k q;
    Transient: J1 J2 c beta Mc omega Mst lambda1 lambda2 cos_ph;
    Blocked: J1 J2 c beta Mc omega Mst lambda1 lambda2 cos_ph;
    Switched: J1 J2 c beta Mc Ms omega Mst lambda1 lambda2 cos_ph;
    Loose: J1 J2 c beta Mc Ms omega g;
    LooseSwitched: J1 J2 c beta Mc Ms omega Mst lambda1 lambda2 cos_ph g;
    LooseFull: J1 J2 c beta Mc Ms omega g;
}

/// A motion of a scene, with what it is the motion of.
struct Moved<C> {
    drive: C,
    motion: Motion,
}

impl<C: Drive> Moved<C> {
    /// The motion from rest up to a time.
    fn of(drive: C, end: f64) -> Self {
        Self::at(drive, end, &FINE)
    }

    fn at(drive: C, end: f64, settings: &Settings) -> Self {
        let motion = march(&drive, (0.0, end), &drive.start(), settings);
        let motion = motion.unwrap_or_else(|error| panic!("{error}"));
        Self { drive, motion }
    }

    /// An output at a time; at an event, after it.
    fn output(&self, name: &str, time: f64) -> f64 {
        let (mode, state) = self.motion.at(time);
        self.output_of(name, time, mode, &state)
    }

    /// An output of a state in a mode.
    fn output_of(&self, name: &str, time: f64, mode: usize, state: &[f64]) -> f64 {
        let model: &dyn Model = &Bound::new(&self.drive);
        model.outputs_in(mode, time, state)[place(&self.drive, name)]
    }

    /// Names of the modes that the events lead to.
    fn modes(&self) -> Vec<&'static str> {
        let events = self.motion.events.iter();
        events.map(|event| self.drive.shape().modes[event.to].name).collect()
    }

    /// The only event that leads to a mode.
    fn event(&self, mode: &str) -> &Happened {
        let mut found = self.motion.events.iter();
        let found = found.find(|event| self.drive.shape().modes[event.to].name == mode);
        found.unwrap_or_else(|| panic!("no event leads to {mode}: {:?}", self.modes()))
    }

    /// Times that lie closely, a thousand to each stretch between events.
    fn times(&self) -> Vec<f64> {
        let ends = self.motion.pieces.iter().map(Motion::ends);
        ends.flat_map(|(from, to)| {
            (0..=1000).map(move |k| from + (to - from) * f64::from(k) / 1000.0)
        })
        .collect()
    }

    /// Time and value of the largest value of an output.
    fn peak(&self, name: &str) -> (f64, f64) {
        let values = self.times().into_iter().map(|time| (time, self.output(name, time)));
        values.fold((0.0, f64::NEG_INFINITY), |best, one| if one.1 > best.1 { one } else { best })
    }
}

fn place<C: Scene>(drive: &C, name: &str) -> usize {
    let found = assur::shape::find(drive.shape().outputs, name);
    found.unwrap_or_else(|| panic!("no output `{name}`"))
}

/// A case of the reference.
fn case(way: &str, name: &str) -> &'static Value {
    let case = &REFERENCE[way][name];
    assert!(case.is_object(), "no case {name} in {way}");
    case
}

/// A number of the reference, of all digits or of those of a float.
fn number(value: &Value) -> f64 {
    let digits = value.as_str().map(|text| text.parse().unwrap());
    digits.or(value.as_f64()).unwrap_or_else(|| panic!("{value} is no number"))
}

/// The scene with the values of a case.
fn drive<C: Drive>(case: &Value) -> C {
    let mut drive = C::default();
    for (name, value) in case["values"].as_object().unwrap() {
        drive.set(name, number(value));
    }
    drive
}

/// Angles, speeds and accelerations at the times of a case, in parts of the largest value of each.
#[track_caller]
fn check_samples<C: Drive>(moved: &Moved<C>, case: &Value, allowed: f64) {
    let samples = case["samples"].as_array().unwrap();
    for (key, name) in [
        ("phi1", "phi1"),
        ("phi2", "phi2"),
        ("dphi1", "dot(phi1)"),
        ("dphi2", "dot(phi2)"),
        ("ddphi1", "ddot(phi1)"),
        ("ddphi2", "ddot(phi2)"),
    ] {
        let largest = samples.iter().map(|one| number(&one[key]).abs()).fold(0.0, f64::max);
        for one in samples {
            let (time, expected) = (number(&one["time"]), number(&one[key]));
            let off = (moved.output(name, time) - expected).abs();
            assert!(off <= allowed * largest, "{name} at {time} s: off by {off:e} of {expected:e}");
        }
    }
}

/// The events of a case: where they lead and when.
#[track_caller]
fn check_events<C: Drive>(moved: &Moved<C>, case: &Value, allowed: f64) {
    let expected = case["events"].as_array().unwrap();
    let modes: Vec<&str> = expected.iter().map(|one| one["to"].as_str().unwrap()).collect();
    assert_eq!(moved.modes(), modes);
    for (event, one) in moved.motion.events.iter().zip(expected) {
        let off = (event.time - number(&one["time"])).abs();
        assert!(off <= allowed, "to {} at {} s: off by {off:e} s", one["to"], event.time);
    }
}
