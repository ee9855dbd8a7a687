//! Published facts against the computed motion.

use super::{Failed, positions};
use crate::registry::{Bind, Mechanism, SceneEntry};
use assur_solvers::answer::{Method, Motion, Question, Settings};
use assur_solvers::measure;
use assur_solvers::problem::Refused;
use assur_solvers::shape::{At, Constant, Expectation, Quantity, Subject, find};

/// How the motion is found: far more accurately than anything is published.
const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-11);

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
        Bind::Motion(bind) => {
            let question = Question::of(bind(&values).map_err(refused)?.into());
            let motion = question.solve(&SETTINGS);
            let motion = motion.map_err(|error| Failed(format!("no motion: {error}")))?;
            let fact = &in_motion(&motion, scene, fact);
            value(&motion, fact)
                .ok_or_else(|| Failed(format!("the motion does not get to {:?}", fact.at)))?
        }
        Bind::Linkage(bind) => positions::value(scene, &*bind(&values).map_err(refused)?, fact)?,
    };
    let deviation = computed - fact.value;
    if deviation.abs() <= fact.tolerance {
        return Ok(());
    }
    Err(Failed(text(mechanism, fact, quantity, computed)))
}

/// A fact in a motion whose states may stand in another order than in the scene.
fn in_motion(motion: &Motion, scene: &SceneEntry, fact: &Expectation) -> Expectation {
    let states = motion.shape().states;
    let subject = match fact.subject {
        Subject::State(index) => {
            let place = scene.states.get(index).and_then(|state| find(states, state.name));
            Subject::State(place.unwrap_or(index))
        }
        other => other,
    };
    Expectation { subject, ..*fact }
}

/// The values of the scene's constants with which a fact is compared.
fn values(mechanism: &Mechanism, scene: &SceneEntry, fact: &Expectation) -> Vec<f64> {
    let preset = mechanism.presets.iter().find(|preset| preset.name == fact.preset);
    let given = preset.map_or(&[][..], |preset| preset.values);
    let value = |constant: &Constant| {
        let own = given.iter().find(|(name, _)| *name == constant.quantity.name);
        own.map_or(constant.default, |(_, value)| *value)
    };
    scene.constants.iter().map(value).collect()
}

/// `dot(phi2) at Driver(0, 1.9): computed …, published … ± …, deviation … (batten.eqn:190)`
fn text(mechanism: &Mechanism, fact: &Expectation, quantity: &Quantity, computed: f64) -> String {
    let shown =
        |value: f64| format!("{} {}", value / quantity.factor, quantity.unit).trim_end().to_owned();
    // Digits below a hundredth of the tolerance say nothing about the fact.
    let rounded = |value: f64| {
        let decimals = 2.0 - (fact.tolerance / quantity.factor).log10();
        let text =
            format!("{:.*}", decimals.ceil().clamp(0.0, 17.0) as usize, value / quantity.factor);
        shown(text.parse().map_or(value, |digits: f64| digits * quantity.factor))
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

/// The computed value of a fact; nothing where the motion does not get there.
fn value(motion: &Motion, fact: &Expectation) -> Option<f64> {
    let at = |time: f64| Some(motion.values(&[fact.subject], motion.task().reduce(time)?)[0]);
    let extremes = || motion.extremes(&[fact.subject], measure::ALWAYS).pop();
    let value = match fact.at {
        At::Time(time) => at(time)?,
        At::Driver(driver, position) => at(motion.model().time_of(driver, position).ok()?)?,
        At::Maximum => extremes()?.highest.value,
        At::Minimum => extremes()?.lowest.value,
        At::Amplitude => extremes()?.amplitude(),
        At::Run => measured(motion, fact.subject)?,
        At::Position(_) => return None,
    };
    (!value.is_nan()).then_some(value)
}

/// A measure of the run.
fn measured(motion: &Motion, subject: Subject) -> Option<f64> {
    let Subject::Measure(index) = subject else {
        return None;
    };
    motion.measures().get(index)?.ok()
}
