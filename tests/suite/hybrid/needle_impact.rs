//! The needle that strikes a limiting cam: closed forms at 40 digits, a second computation from event to event, the
//! strength that follows, hard cases, the numbers of the paper.

mod closed_forms;
mod hard;
mod published;
mod stepped;
mod strength;

use crate::solved::{FINE, entry, values};
use assur::answer::Settings;
use assur::hybrid::{Happened, Motion};
use assur::model::Model;
use assur::registry::SceneEntry;
use assur::shape::Quantity;
use serde_json::Value;
use std::sync::LazyLock;

static REFERENCE: LazyLock<Value> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../reference/needle_impact.json")).unwrap()
});

/// A list of the closed forms.
fn closed(name: &str) -> &'static Vec<Value> {
    REFERENCE["closed"][name].as_array().unwrap()
}

/// A number of the reference, of all digits or of those of a float.
fn number(value: &Value) -> f64 {
    let digits = value.as_str().map(|text| text.parse().unwrap());
    digits.or(value.as_f64()).unwrap_or_else(|| panic!("{value} is no number"))
}

/// The values of a case, by name.
fn changes(values: &Value) -> Vec<(&str, f64)> {
    let all = values.as_object().unwrap().iter();
    all.map(|(name, value)| (name.as_str(), number(value))).collect()
}

#[track_caller]
fn check(what: &str, found: f64, expected: f64, allowed: f64) {
    let off = (found - expected).abs();
    let largest = allowed * expected.abs().max(1e-300);
    assert!(
        off <= largest,
        "{what}: {found:e}, expected {expected:e}, off by {:e}",
        off / expected.abs()
    );
}

fn place(list: &[Quantity], name: &str) -> usize {
    let found = list.iter().position(|one| one.name == name);
    found.unwrap_or_else(|| panic!("no `{name}`"))
}

/// What a scene of closed forms says at a speed of the cylinder, or at an inclination of the wedge.
struct Formula {
    scene: &'static SceneEntry,
    outputs: Vec<f64>,
}

impl Formula {
    fn of(scene: &str, changes: &[(&str, f64)], at: f64) -> Self {
        let scene = entry("needle_impact", scene);
        let linkage = scene.bind.linkage(&values(scene, changes)).unwrap();
        let path = linkage.follow(&[vec![at]]).unwrap();
        assert!(path.stopped.is_none(), "{:?}", path.stopped);
        let outputs = path.samples[0].outputs.clone();
        Self { scene, outputs }
    }

    /// A blow at a speed, in one of the scenes for blows.
    fn blow(scene: &str, changes: &[(&str, f64)]) -> f64 {
        Self::of(scene, changes, 2.0).get("F")
    }

    fn get(&self, name: &str) -> f64 {
        self.outputs[place(self.scene.outputs, name)]
    }
}

/// A motion of a scene.
struct Moved {
    scene: &'static SceneEntry,
    run: Box<dyn Model>,
    motion: Motion,
}

impl Moved {
    fn of(scene: &str, changes: &[(&str, f64)], end: f64) -> Self {
        Self::at(scene, changes, end, &FINE)
    }

    fn at(scene: &str, changes: &[(&str, f64)], end: f64, settings: &Settings) -> Self {
        let scene = entry("needle_impact", scene);
        let run = scene.bind.motion(&values(scene, changes)).unwrap();
        let motion = run.follow((0.0, end), &run.start(), settings);
        let motion = motion.unwrap_or_else(|error| panic!("{error}"));
        Self { scene, run, motion }
    }

    /// An output at a time; at an event, after it.
    fn output(&self, name: &str, time: f64) -> f64 {
        let (mode, state) = self.motion.at(time);
        self.run.outputs_in(mode, time, &state)[place(self.scene.outputs, name)]
    }

    fn mode(&self, index: usize) -> &'static str {
        self.scene.modes[index].name
    }

    /// Names of the modes that the events lead to.
    fn modes(&self) -> Vec<&'static str> {
        let events = self.motion.events.iter();
        events.map(|event| self.mode(event.to)).collect()
    }

    /// The first event that leads to a mode.
    fn event(&self, mode: &str) -> &Happened {
        let mut events = self.motion.events.iter();
        let found = events.find(|event| self.mode(event.to) == mode);
        found.unwrap_or_else(|| panic!("no event leads to {mode}: {:?}", self.modes()))
    }

    fn measure(&self, name: &str) -> f64 {
        let found = self.run.measure(&self.motion)[place(self.scene.measures, name)];
        found.unwrap_or_else(|missing| panic!("{name}: {missing:?}"))
    }
}
