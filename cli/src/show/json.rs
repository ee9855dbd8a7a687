//! What all answers in JSON have in common.
//!
//! Each answer is described once, by the types that are serialised. `assur schema` prints what follows from them; its files
//! are held true by a test. Values stand in the unit beside them, times in seconds; null is a number that is not finite or
//! not known. A field that changes its meaning changes the number behind the name of the format.

use std::path::Path;

use assur::answer::Settings as Given;
use assur::registry::SceneEntry;
use assur::shape::Quantity;
use serde::{Serialize, Serializer};

use super::unit;
use crate::ask::constants::Constants;
use crate::ask::settings::given_atol;
use crate::ask::variables::Variable;
use crate::published::Comparison;

/// A number, null if it is not finite.
pub type Number = Option<f64>;

/// A number that may not be finite.
pub fn number(value: f64) -> Number {
    value.is_finite().then_some(value)
}

/// A text, null if it is empty.
pub fn text(text: &str) -> Option<&str> {
    (!text.is_empty()).then_some(text)
}

/// The path of a figure.
pub fn path(figure: Option<&Path>) -> Option<String> {
    figure.map(|path| path.display().to_string())
}

/// An object, with its last line ended.
pub fn render(object: &impl Serialize) -> String {
    // All keys are texts, so printing cannot fail.
    serde_json::to_string_pretty(object).unwrap_or_default() + "\n"
}

/// What an answer is about.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct About {
    pub mechanism: Mechanism,
    pub scene: Scene,
    /// Dimensions and parameters.
    pub parameters: Vec<Parameter>,
}

/// The mechanism.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Mechanism {
    pub name: &'static str,
    pub title: &'static str,
    pub source: &'static str,
}

/// The scene, and the values that it starts from.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Scene {
    pub name: &'static str,
    pub effects: &'static [&'static str],
    /// The alternative of each choice.
    #[serde(serialize_with = "map")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<String, String>"))]
    pub choices: &'static [(&'static str, &'static str)],
    /// Null for the declared values.
    pub preset: Option<&'static str>,
    /// The statements by which it differs from the scene of the file: `with damping;`.
    pub changes: Vec<String>,
}

/// A dimension or parameter.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Parameter {
    pub name: &'static str,
    pub kind: ParameterKind,
    pub unit: &'static str,
    pub value: f64,
    /// As the file declares it.
    pub default: f64,
    pub changed: bool,
}

/// What kind of constant it is.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ParameterKind {
    Dimension,
    Parameter,
}

/// How motions are integrated.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Settings {
    pub method: &'static str,
    pub rtol: f64,
    /// Absolute tolerances of states, those that are given.
    pub atol: Vec<Amount>,
}

/// A value with its unit.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Amount {
    pub name: String,
    pub unit: String,
    pub value: Number,
}

/// A value with its estimated error.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Reading {
    pub name: String,
    pub unit: String,
    pub value: Number,
    pub estimated_error: Number,
}

/// A published value beside the computed one.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Published {
    pub name: String,
    pub unit: String,
    /// Where in the motion, in words.
    pub place: String,
    pub published: f64,
    /// Half the width of the band in which the file expects the computed value.
    pub tolerance: f64,
    /// Null where the mechanism does not get there.
    pub computed: Number,
    pub estimated_error: Number,
    /// Computed less published.
    pub deviation: Number,
    pub relative_deviation: Number,
    /// Whether the computed value lies in the band; null when it was published for other values than those of this run.
    pub within: Option<bool>,
    pub remark: Option<&'static str>,
    /// Line of the equation file.
    pub line: usize,
}

impl About {
    /// A scene with its values.
    pub fn of(constants: &Constants) -> Self {
        let (mechanism, scene) = (constants.mechanism, constants.scene);
        let parameter = |index: usize| {
            let constant = &scene.constants[index];
            let quantity = &constant.quantity;
            Parameter {
                name: quantity.name,
                kind: match constant.is_dimension {
                    true => ParameterKind::Dimension,
                    false => ParameterKind::Parameter,
                },
                unit: quantity.unit,
                value: unit::stated(constants.values[index], quantity.factor),
                default: unit::stated(constant.default, quantity.factor),
                changed: constants.is_changed(index),
            }
        };
        Self {
            mechanism: Mechanism {
                name: mechanism.name,
                title: mechanism.title,
                source: mechanism.source,
            },
            scene: Scene {
                name: scene.name,
                effects: scene.effects,
                choices: scene.choices,
                preset: text(constants.preset),
                changes: constants.changes.clone(),
            },
            parameters: (0..constants.values.len()).map(parameter).collect(),
        }
    }
}

impl Settings {
    /// Settings for a scene.
    pub fn of(settings: &Given, scene: &SceneEntry) -> Self {
        let atol = given_atol(settings, scene);
        let atol = atol.map(|(state, value)| Amount::of(state, value));
        Self { method: settings.method.name(), rtol: settings.rtol, atol: atol.collect() }
    }
}

impl Amount {
    /// A value of a quantity, SI units.
    pub fn of(quantity: &Quantity, value: f64) -> Self {
        Self {
            name: quantity.name.to_owned(),
            unit: quantity.unit.to_owned(),
            value: number(unit::stated(value, quantity.factor)),
        }
    }

    /// Values of quantities, SI units.
    pub fn all(quantities: &[Quantity], values: &[f64]) -> Vec<Self> {
        quantities.iter().zip(values).map(|(quantity, value)| Self::of(quantity, *value)).collect()
    }

    /// Values of variables, SI units; none where they are not known.
    pub fn results(variables: &[Variable], values: Option<&[f64]>) -> Vec<Self> {
        let one = |(index, variable): (usize, &Variable)| Self {
            name: variable.name.clone(),
            unit: variable.unit.clone(),
            value: values.and_then(|values| number(variable.in_unit(values[index]))),
        };
        variables.iter().enumerate().map(one).collect()
    }
}

impl Reading {
    /// A value of a variable with its error, SI units.
    pub fn of(variable: &Variable, value: f64, error: f64) -> Self {
        Self {
            name: variable.name.clone(),
            unit: variable.unit.clone(),
            value: number(variable.in_unit(value)),
            estimated_error: number(variable.in_unit(error)),
        }
    }
}

impl Published {
    /// All of them.
    pub fn all(published: &[Comparison]) -> Vec<Self> {
        published.iter().map(Self::of).collect()
    }

    fn of(one: &Comparison) -> Self {
        let in_unit = |value: f64| number(unit::stated(value, one.factor));
        Self {
            name: one.name.clone(),
            unit: one.unit.clone(),
            place: one.place.clone(),
            published: unit::stated(one.fact.value, one.factor),
            tolerance: unit::stated(one.fact.tolerance, one.factor),
            computed: in_unit(one.computed),
            estimated_error: in_unit(one.error),
            deviation: in_unit(one.deviation()),
            relative_deviation: number(one.relative()),
            within: one.within(),
            remark: text(one.fact.remark),
            line: one.fact.line as usize,
        }
    }
}

/// Pairs as an object.
fn map<S: Serializer>(pairs: &[(&str, &str)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().copied())
}
