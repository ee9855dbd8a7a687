//! Published facts against the computed motion.

use super::{Failed, positions};
use crate::hybrid;
use crate::ode::Trajectory;
use crate::problem::{Refused, Span};
use crate::registry::{
    At, Bind, Constant, Expectation, Mechanism, Method, Quantity, Run, SceneEntry, Settings,
    Subject,
};

/// How the motion is found: far more accurately than anything is published.
const SETTINGS: Settings = Settings {
    method: Method::Dop853,
    rtol: 1e-11,
};
/// Samples along a task when an extreme is sought.
const SAMPLES: usize = 2048;

/// Solves a scene and checks one of its published facts, by its place in the list of the scene.
///
/// # Errors
/// The fact with the computed and the published value; or why there is no value to compare.
pub fn fact(mechanism: &Mechanism, scene: &str, index: usize) -> Result<(), Failed> {
    let scene = mechanism.scenes.iter().find(|entry| entry.name == scene);
    let scene = scene.ok_or_else(|| Failed("there is no such scene".into()))?;
    let fact = scene.expectations.get(index);
    let fact = fact.ok_or_else(|| Failed("there is no such fact".into()))?;
    let quantity = scene
        .quantity(fact.subject)
        .ok_or_else(|| Failed("the scene does not report the quantity".into()))?;
    let values = values(mechanism, scene, fact);
    let refused = |refused: Refused| Failed(refused.to_string());
    let computed = match scene.bind {
        Bind::Motion(bind) => Motion::of(bind(&values).map_err(refused)?)?
            .value(fact)
            .ok_or_else(|| Failed(format!("the motion does not get to {:?}", fact.at)))?,
        Bind::Linkage(bind) => positions::value(scene, &*bind(&values).map_err(refused)?, fact)?,
    };
    let deviation = computed - fact.value;
    if deviation.abs() <= fact.tolerance {
        return Ok(());
    }
    Err(Failed(text(mechanism, fact, quantity, computed)))
}

/// The values of the scene's constants with which a fact is compared.
fn values(mechanism: &Mechanism, scene: &SceneEntry, fact: &Expectation) -> Vec<f64> {
    let preset = mechanism
        .presets
        .iter()
        .find(|preset| preset.name == fact.preset);
    let given = preset.map_or(&[][..], |preset| preset.values);
    let value = |constant: &Constant| {
        let own = given
            .iter()
            .find(|(name, _)| *name == constant.quantity.name);
        own.map_or(constant.default, |(_, value)| *value)
    };
    scene.constants.iter().map(value).collect()
}

/// `dot(phi2) at Driver(0, 1.9): computed …, published … ± …, deviation … (batten.eqn:190)`
fn text(mechanism: &Mechanism, fact: &Expectation, quantity: &Quantity, computed: f64) -> String {
    let shown = |value: f64| {
        format!("{} {}", value / quantity.factor, quantity.unit)
            .trim_end()
            .to_owned()
    };
    format!(
        "{} at {:?}: computed {}, published {} ± {}, deviation {} ({}:{}) {}",
        quantity.name,
        fact.at,
        shown(computed),
        shown(fact.value),
        shown(fact.tolerance),
        shown(computed - fact.value),
        mechanism.file,
        fact.line,
        fact.remark,
    )
}

/// A solved scene.
struct Motion {
    run: Box<dyn Run>,
    span: Span,
    /// None where the scene has no task, or no state.
    path: Option<Path>,
}

enum Path {
    Orbit(Trajectory),
    Through(hybrid::Motion),
}

impl Motion {
    fn of(run: Box<dyn Run>) -> Result<Self, Failed> {
        let span = run.span();
        let unsolved = |error: &dyn std::fmt::Display| Failed(format!("no motion: {error}"));
        let path = match span {
            _ if run.start().is_empty() => None,
            Span::Open => None,
            Span::Periodic(period) if run.mode_count() > 0 => {
                let cycle = run.cycle(period, &SETTINGS);
                let cycle = cycle.map_err(|error| unsolved(&error))?;
                Some(Path::Through(cycle.motion))
            }
            Span::Autonomous => {
                let cycle = run.clock(&SETTINGS);
                let cycle = cycle.map_err(|error| unsolved(&error))?;
                Some(Path::Through(cycle.motion))
            }
            Span::Periodic(period) => {
                let orbit = run.periodic(period, &SETTINGS);
                let orbit = orbit.map_err(|error| unsolved(&error))?;
                Some(Path::Orbit(orbit.trajectory))
            }
            Span::Run(from, to) => {
                let motion = run.follow((from, to), &run.start(), &SETTINGS);
                Some(Path::Through(motion.map_err(|error| unsolved(&error))?))
            }
        };
        Ok(Self { run, span, path })
    }

    /// The computed value of a fact; nothing where the motion does not get there.
    fn value(&self, fact: &Expectation) -> Option<f64> {
        match fact.at {
            At::Time(time) => self.at(self.span.reduce(time)?, fact.subject),
            At::Driver(driver, position) => {
                let time = self.run.time_of(driver, position).ok()?;
                self.at(time, fact.subject)
            }
            At::Maximum => self.largest(fact.subject, |value| value),
            At::Minimum => self
                .largest(fact.subject, |value| -value)
                .map(|value| -value),
            At::Amplitude => self.largest(fact.subject, f64::abs),
            At::Run => self.measured(fact.subject),
            At::Position(_) => None,
        }
    }

    /// A measure of the run.
    fn measured(&self, subject: Subject) -> Option<f64> {
        let Subject::Measure(index) = subject else {
            return None;
        };
        let measures = match self.path.as_ref()? {
            Path::Orbit(orbit) => self.run.measure(&hybrid::Motion::of(orbit.clone())),
            Path::Through(motion) => self.run.measure(motion),
        };
        measures.get(index)?.ok()
    }

    /// A state or output at a time.
    fn at(&self, time: f64, subject: Subject) -> Option<f64> {
        let (mode, state) = match &self.path {
            Some(Path::Orbit(orbit)) => (0, orbit.at(time)),
            Some(Path::Through(motion)) => motion.at(time),
            None => (self.run.first_mode(), self.run.start()),
        };
        match subject {
            Subject::Output(index) => {
                let outputs = self.run.outputs_in(mode, time, &state);
                outputs.get(index).copied()
            }
            Subject::State(index) => state.get(index).copied(),
            Subject::Influence(..) | Subject::Measure(_) => None,
        }
    }

    /// Times along the task.
    fn times(&self) -> Vec<f64> {
        let (from, to) = self.span.limits();
        let at = |index: usize| from + (to - from) * index as f64 / SAMPLES as f64;
        (0..=SAMPLES).map(at).collect()
    }

    /// The largest of what is made of a quantity over the task.
    fn largest(&self, subject: Subject, size: impl Fn(f64) -> f64) -> Option<f64> {
        let times = self.times();
        let at = |time: f64| self.at(time, subject).map(&size);
        let mut best = (0, f64::NEG_INFINITY);
        for (index, time) in times.iter().enumerate() {
            let here = at(*time)?;
            if here > best.1 {
                best = (index, here);
            }
        }
        // Between its neighbours the largest sample is beside one hill, which thirds close in on.
        let (mut low, mut high) = (
            times[best.0.saturating_sub(1)],
            times[(best.0 + 1).min(SAMPLES)],
        );
        for _ in 0..60 {
            let third = (high - low) / 3.0;
            if at(low + third)? < at(high - third)? {
                low += third;
            } else {
                high -= third;
            }
        }
        Some(best.1.max(at(low + (high - low) / 2.0)?))
    }
}
