//! The presser foot: a second computation from event to event, closed forms without separation, hard cases, what the
//! paper says.

mod grazing;
mod hard;
mod harmonics;
mod irregular;
mod linear;
mod naive;
mod plate;
mod published;
mod transition;
mod variants;

use assur::hybrid::{self, Cycle, CycleError, Motion};
use assur::measure;
use assur::prelude::*;
use assur::shape;
use assur_equations::presser_foot::*;
use serde_json::Value;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// As accurately as the solvers can.
const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-13);

static REFERENCE: LazyLock<Value> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../reference/presser_foot.json")).unwrap()
});

const CONTACT: usize = 0;
const FLIGHT: usize = 1;

/// A scene whose values are set by name, and whose motion repeats.
trait Foot: Scene + Default + Copy {
    fn set(&mut self, name: &str, value: f64);
    fn period(&self) -> f64;

    /// A scene with some of its values changed.
    fn with(changes: &[(&str, f64)]) -> Self {
        let mut foot = Self::default();
        for (name, value) in changes {
            foot.set(name, *value);
        }
        foot
    }

    /// The stable motion that the declared start leads to.
    fn cycle(&self) -> Result<Cycle, CycleError> {
        hybrid::cycle(self, self.period(), &FINE)
    }
}

macro_rules! feet {
    ($($scene:ident: $($field:ident)+;)+) => {$(
        impl Foot for $scene {
            fn set(&mut self, name: &str, value: f64) {
                match name {
                    $(stringify!($field) => self.$field = value,)+
                    _ => panic!("no constant `{name}`"),
                }
            }

            fn period(&self) -> f64 {
                2.0 * PI / self.omega
            }
        }
    )+};
}

feet! {
    Elliptic: m c1 mu1 F10 c2 c3 mu2 omega rise g;
    Straight: m c1 mu1 F10 c2 c3 mu2 omega rise phi_v g q1 q2 q3;
    StraightLow: m c1 mu1 F10 c2 c3 mu2 omega rise phi_v g;
    Progressive: m c1 mu1 F10 c2 c3 mu2 omega rise g;
    FiveHarmonics: m c1 mu1 F10 c2 c3 mu2 omega rise g order;
    Machine: m c1 mu1 F10 c2 c3 mu2 omega g;
    MachineHarmonics: m c1 mu1 F10 c2 c3 mu2 omega g order;
    Yielding: m c1 mu1 F10 c2 mu2 omega rise g c_p;
    YieldingStraight: m c1 mu1 F10 c2 mu2 omega rise g c_p;
    HuntCrossley: m c1 mu1 F10 c2 c3 eta omega rise g;
}

/// The measures of the file.
#[derive(Clone, Copy, Debug)]
struct Measured {
    largest: f64,
    smallest: f64,
    mean: f64,
    free: f64,
    lift_offs: f64,
}

impl Measured {
    fn of<C: Scene>(foot: &C, motion: &Motion) -> Self {
        let scene = MECHANISM.scenes[0];
        let values = measure::of(foot, motion);
        let value = |name: &str| {
            let place = scene.measures.iter().position(|one| one.name == name);
            *values[place.unwrap()].as_ref().unwrap()
        };
        Self {
            largest: value("F_largest"),
            smallest: value("F_smallest"),
            mean: value("F_mean"),
            free: value("free"),
            lift_offs: value("flights"),
        }
    }
}

/// The foot with the values of a case.
fn foot<C: Foot>(case: &Value) -> C {
    let mut foot = C::default();
    for (name, value) in case["values"].as_object().unwrap() {
        foot.set(name, value.as_f64().unwrap());
    }
    foot
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// Where contact is lost and regained: time and mode afterwards. Changes of the branch of the path are left out.
fn changes(motion: &Motion) -> Vec<(f64, usize)> {
    let events = motion.events.iter().filter(|one| one.from != one.to);
    events.map(|one| (one.time, one.to)).collect()
}

/// What a scene reports in a mode, at a time and state.
fn output<C: Scene>(foot: &C, name: &str, mode: usize, time: f64, values: &[f64]) -> f64 {
    let model: &dyn Model = &Bound::new(foot);
    model.outputs_in(mode, time, values)[shape::find(foot.shape().outputs, name).unwrap()]
}

/// F2 just after a time.
fn force<C: Scene>(foot: &C, motion: &Motion, time: f64) -> f64 {
    let (mode, values) = motion.at(time);
    output(foot, "F2", mode, time, &values)
}

/// A motion that repeats against the second computation: its state at phi = -pi, its multipliers, all instants of
/// contact lost and regained to ten digits, forces.
#[track_caller]
fn check<C: Foot>(name: &str) {
    let case = &REFERENCE["cases"][name];
    assert!(case.is_object(), "no case {name}");
    let foot = foot::<C>(case);
    let found = foot.cycle().unwrap_or_else(|error| panic!("{name}: {error}"));
    compare(name, &foot, &found);
}

/// The same for a motion that has been found.
#[track_caller]
fn compare<C: Foot>(name: &str, foot: &C, found: &Cycle) {
    let case = &REFERENCE["cases"][name];
    assert_eq!(found.multiple as u64, case["turns"].as_u64().unwrap(), "{name}");
    // A motion of several turns may begin with each of them.
    let (period, start) = (foot.period(), numbers(&case["start"]));
    let length = period * found.multiple as f64;
    let off = |turn: usize| {
        let (_, state) = found.motion.at(turn as f64 * period);
        (state[0] - start[0]).abs() * foot_speed(period) + (state[1] - start[1]).abs()
    };
    let turns = (0..found.multiple).min_by(|a, b| off(*a).total_cmp(&off(*b)));
    let shift = turns.unwrap() as f64 * period;
    let (mode, state) = found.motion.at(shift);
    assert_eq!(foot.shape().modes[mode].name, case["mode"].as_str().unwrap(), "{name}");
    for (value, (expected, size)) in state.iter().zip(start.iter().zip([1e-3, 1e-1])) {
        let off = (value - expected).abs();
        assert!(off < 1e-10 * size, "{name}: state off by {off:e} of {expected:e}");
    }
    let expected = case["events"].as_array().unwrap();
    let mut events: Vec<(f64, usize)> = changes(&found.motion);
    for event in &mut events {
        event.0 = (event.0 - shift).rem_euclid(length);
    }
    events.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!(events.len(), expected.len(), "{name}: {events:?}");
    for ((time, mode), expected) in events.iter().zip(expected) {
        assert_eq!(foot.shape().modes[*mode].name, expected["to"].as_str().unwrap(), "{name}");
        let off = (time - number(&expected["time"])).abs();
        assert!(off < 1e-10 * length, "{name}: event at {time} s off by {off:e} s");
    }
    let expected = case["multipliers"].as_array().unwrap();
    for (found, expected) in found.multipliers.iter().zip(expected) {
        let expected = numbers(expected);
        let off = (found.re - expected[0]).abs() + (found.im.abs() - expected[1].abs()).abs();
        assert!(off < 1e-8, "{name}: multiplier {found} against {expected:?}");
    }
    for pair in case["forces"].as_array().unwrap() {
        let [time, expected] = numbers(pair)[..] else {
            panic!("{pair}");
        };
        let force = force(foot, &found.motion, (time + shift).rem_euclid(length));
        assert!((force - expected).abs() < 1e-7, "{name}: {force} N at {time} s, {expected} N");
    }
    let forces = Measured::of(foot, &found.motion);
    for (value, key, size) in [
        (forces.largest, "largest", 100.0),
        (forces.smallest, "smallest", 100.0),
        (forces.mean, "mean", 100.0),
        (forces.free, "free", 1.0),
    ] {
        let off = (value - number(&case[key])).abs();
        assert!(off < 1e-9 * size, "{name}: {key} {value} off by {off:e}");
    }
}

/// Turns a path into a speed.
fn foot_speed(period: f64) -> f64 {
    2.0 * PI / period
}

#[test]
fn the_ellipse() {
    for omega in [200, 300, 400, 500, 700] {
        check::<Elliptic>(&format!("elliptic_{omega}"));
    }
}

/// At 500 1/s a foot that begins on the fabric and one that is let fall come to different motions, both stable.
#[test]
fn two_motions_at_one_speed() {
    let foot = Elliptic::with(&[("omega", 500.0)]);
    let other = hybrid::cycle_from(&foot, (FLIGHT, &[2e-3, 0.0]), foot.period(), &FINE).unwrap();
    assert!(other.is_stable());
    compare("elliptic_500_other", &foot, &other);
    let [here, there] = ["elliptic_500", "elliptic_500_other"]
        .map(|name| numbers(&REFERENCE["cases"][name]["start"]));
    assert!((here[0] - there[0]).abs() > 1e-3);
}

/// At 180 and 200 1/s contact is lost just before the rack passes the plate, and regained exactly there.
#[test]
fn the_straight_path() {
    for omega in [180, 200, 300, 400] {
        check::<Straight>(&format!("straight_{omega}"));
    }
    for omega in [200, 300, 400] {
        check::<StraightLow>(&format!("straight_low_{omega}"));
    }
}

#[test]
fn the_other_fabrics() {
    check::<Progressive>("progressive_250");
    check::<Progressive>("progressive_300");
    check::<HuntCrossley>("hunt_crossley_300");
}

#[test]
fn five_harmonics() {
    check::<FiveHarmonics>("five_harmonics_300");
}

#[test]
fn the_feed_mechanism_and_its_harmonics() {
    for omega in [200, 300, 400] {
        check::<Machine>(&format!("machine_{omega}"));
        check::<MachineHarmonics>(&format!("machine_harmonics_{omega}"));
    }
}

#[test]
fn light_and_slow() {
    check::<Elliptic>("light_300");
    check::<Elliptic>("held_by_weight");
}
