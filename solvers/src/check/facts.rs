//! Published facts against the computed motion.

use super::{Failed, positions};
use crate::hybrid;
use crate::measure::{self, Extremes};
use crate::model::Model;
use crate::problem::{Refused, Span};
use crate::registry::{Bind, Mechanism, Method, SceneEntry, Settings};
use crate::shape::{At, Constant, Expectation, Quantity, Subject};
use crate::study;

/// How the motion is found: far more accurately than anything is published.
const SETTINGS: Settings = Settings::new(Method::Dop853, 1e-11);

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
    // Digits below a hundredth of the tolerance say nothing about the fact.
    let rounded = |value: f64| {
        let decimals = 2.0 - (fact.tolerance / quantity.factor).log10();
        let text = format!(
            "{:.*}",
            decimals.ceil().clamp(0.0, 17.0) as usize,
            value / quantity.factor
        );
        shown(
            text.parse()
                .map_or(value, |digits: f64| digits * quantity.factor),
        )
    };
    format!(
        "{} at {:?}: computed {}, published {} ± {}, deviation {} ({}:{}) {}",
        quantity.name,
        fact.at,
        rounded(computed),
        shown(fact.value),
        shown(fact.tolerance),
        rounded(computed - fact.value),
        mechanism.file,
        fact.line,
        fact.remark,
    )
}

/// A solved scene.
struct Motion {
    run: Box<dyn Model>,
    span: Span,
    /// At rest where the scene has no task.
    path: hybrid::Motion,
}

impl Motion {
    fn of(run: Box<dyn Model>) -> Result<Self, Failed> {
        let span = run.span();
        let path = match span {
            Span::Open => Ok(hybrid::Motion {
                mode: run.shape().first,
                ..hybrid::Motion::at_rest(0.0, &run.start())
            }),
            _ if run.start().is_empty() => Ok(hybrid::Motion::without_states(
                run.shape().first,
                span.limits(),
            )),
            _ => study::motion(run.as_ref(), &SETTINGS),
        };
        let path = path.map_err(|error| Failed(format!("no motion: {error}")))?;
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
            At::Maximum => Some(self.extremes(fact.subject)?.highest.value),
            At::Minimum => Some(self.extremes(fact.subject)?.lowest.value),
            At::Amplitude => Some(self.extremes(fact.subject)?.amplitude()),
            At::Run => self.measured(fact.subject),
            At::Position(_) => None,
        }
    }

    /// A measure of the run.
    fn measured(&self, subject: Subject) -> Option<f64> {
        let Subject::Measure(index) = subject else {
            return None;
        };
        self.run.measure(&self.path).get(index)?.ok()
    }

    /// A state or output at a time.
    fn at(&self, time: f64, subject: Subject) -> Option<f64> {
        let (mode, state) = self.path.at(time);
        self.of_state(mode, time, &state, subject)
    }

    /// A state or output in a mode at a time and state.
    fn of_state(&self, mode: usize, time: f64, state: &[f64], subject: Subject) -> Option<f64> {
        match subject {
            Subject::Output(index) => {
                let outputs = self.run.outputs_in(mode, time, state);
                outputs.get(index).copied()
            }
            Subject::State(index) => state.get(index).copied(),
            Subject::Influence(..) | Subject::Measure(_) => None,
        }
    }

    /// Smallest and largest value of a quantity over the task.
    fn extremes(&self, subject: Subject) -> Option<Extremes> {
        let sample = |mode: usize, time: f64, state: &[f64], values: &mut [f64]| {
            values[0] = self
                .of_state(mode, time, state, subject)
                .unwrap_or(f64::NAN);
        };
        let found = measure::extremes(&self.path, measure::ALWAYS, 1, &sample);
        found.into_iter().next()?
    }
}
