//! A scene of the registry with its steady state, read by the names that the equation file gives.

use assur::answer::{Method, Settings};
use assur::model::Model;
use assur::periodic::{Orbit, PeriodicError};
use assur::problem::{Refused, Span};
use assur::registry::{Bind, SceneEntry};
use assur_equations::REGISTRY;
use std::f64::consts::TAU;

/// As accurately as the solvers can.
pub const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-13);

/// As accurately as most questions ask for.
pub const USUAL: Settings = Settings::new(Method::Dop853).rtol(1e-10);

/// Revolutions per minute in radians per second.
pub const RPM: f64 = TAU / 60.0;

/// The entry of a scene.
pub fn entry(mechanism: &str, scene: &str) -> &'static SceneEntry {
    let mechanism = REGISTRY.iter().find(|entry| entry.name == mechanism);
    let mut scenes = mechanism.expect("a mechanism of the registry").scenes.iter();
    let scene = scenes.find(|entry| entry.name == scene);
    scene.expect("a scene of the mechanism")
}

/// The values of a scene in the order of its constants, with some of them changed.
pub fn values(entry: &SceneEntry, changes: &[(&str, f64)]) -> Vec<f64> {
    let mut values: Vec<f64> = entry.constants.iter().map(|it| it.default).collect();
    for (name, value) in changes {
        let place = entry.constants.iter().position(|it| it.quantity.name == *name);
        values[place.unwrap_or_else(|| panic!("no constant `{name}`"))] = *value;
    }
    values
}

/// A scene with its steady state.
pub struct Solved {
    pub entry: &'static SceneEntry,
    pub run: Box<dyn Model>,
    pub orbit: Orbit,
    pub period: f64,
    values: Vec<f64>,
}

impl Solved {
    /// The steady state of a scene with its declared values, as accurately as the solvers can.
    pub fn new(mechanism: &str, scene: &str) -> Self {
        Self::with(mechanism, scene, &[])
    }

    /// The same with some values changed.
    pub fn with(mechanism: &str, scene: &str, changes: &[(&str, f64)]) -> Self {
        Self::of(entry(mechanism, scene), changes, &FINE).unwrap()
    }

    /// The steady state of a scene with some values changed at a tolerance, or why there is none.
    pub fn of(
        entry: &'static SceneEntry,
        changes: &[(&str, f64)],
        settings: &Settings,
    ) -> Result<Self, PeriodicError> {
        let values = values(entry, changes);
        let run = entry.bind.motion(&values).unwrap();
        let Span::Periodic(period) = run.span() else {
            panic!("the scene {} has another task", entry.name);
        };
        Ok(Self { orbit: run.periodic(period, settings)?, entry, run, period, values })
    }

    /// A constant.
    pub fn constant(&self, name: &str) -> f64 {
        let mut constants = self.entry.constants.iter();
        self.values[constants.position(|it| it.quantity.name == name).unwrap()]
    }

    /// The time at which the crank is at an angle.
    pub fn time_at(&self, angle: f64) -> f64 {
        angle / TAU * self.period
    }

    /// The outputs at a time, integrated to that time and not interpolated.
    pub fn outputs(&self, time: f64) -> Vec<f64> {
        let start = &self.orbit.start;
        let end = match start.is_empty() {
            true => Vec::new(),
            false => self.run.march((0.0, time), start, &FINE).unwrap().end().to_vec(),
        };
        self.run.outputs(time, &end)
    }

    /// An output at an angle of the crank.
    pub fn at(&self, angle: f64, name: &str) -> f64 {
        self.outputs(self.time_at(angle))[self.place(name)]
    }

    /// The place of an output in the list.
    pub fn place(&self, name: &str) -> usize {
        let place = self.entry.outputs.iter().position(|it| it.name == name);
        place.unwrap_or_else(|| panic!("the scene does not report `{name}`"))
    }

    /// The outputs at equal parts of the period, the begin first and the end left out.
    pub fn samples(&self, count: usize) -> Vec<Vec<f64>> {
        let outputs = |index: usize| {
            let time = self.period * index as f64 / count as f64;
            self.run.outputs(time, &self.orbit.at(time))
        };
        (0..count).map(outputs).collect()
    }

    /// The mean over the period of what is made of the outputs. Equal weights are exact here up to the tolerance.
    pub fn mean(&self, quantity: impl Fn(&[f64]) -> f64) -> f64 {
        let samples = self.samples(1024);
        samples.iter().map(|it| quantity(it)).sum::<f64>() / samples.len() as f64
    }

    /// The largest absolute value of an output over the period.
    pub fn amplitude(&self, name: &str) -> f64 {
        let place = self.place(name);
        let samples = self.samples(1024);
        samples.iter().map(|it| it[place].abs()).fold(0.0, f64::max)
    }
}

/// Fixes the values of a scene with some of them changed.
pub fn bind(entry: &SceneEntry, changes: &[(&str, f64)]) -> Result<Box<dyn Model>, Refused> {
    entry.bind.motion(&values(entry, changes))
}

/// Whether a scene of either kind accepts its values with some of them changed.
pub fn accepts(entry: &SceneEntry, changes: &[(&str, f64)]) -> Result<(), Refused> {
    let values = values(entry, changes);
    match entry.bind {
        Bind::Motion(bind) => bind(&values).map(|_| ()),
        Bind::Linkage(bind) => bind(&values).map(|_| ()),
    }
}
