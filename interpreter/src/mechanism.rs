//! A checked model as a mechanism of the registry.

use std::sync::Arc;

use assur_model::checked::{Model, SceneModel};
use assur_registry::registry::{
    Bind, Choice, Mechanism, Named, Preset, SceneEntry, bind, bind_linkage,
};
use assur_solvers::problem::Refused;
use assur_solvers::shape::Shape;

use crate::scene::{Loops, Motion, Moved, Moving};
use crate::shape::{Lines, list, shape, text};

/// Where the equations stand.
pub struct Origin<'a> {
    /// Name of the file, `batten.eqn`.
    pub file: &'a str,
    /// Its text.
    pub text: &'a str,
    /// Paths and texts of the files of its parts.
    pub parts: Vec<(&'a str, &'a str)>,
    /// The line of a place in it, from 1.
    pub lines: Lines<'a>,
    /// Name of the mechanism, as commands take it.
    pub name: &'a str,
}

/// The mechanism that a model is. It stays until the process ends, as emitted code does.
pub fn mechanism(model: &Model, origin: &Origin<'_>) -> Mechanism {
    let effects = model.effects.iter();
    let effects = effects.map(|one| Named { name: text(&one.name), summary: text(&one.summary) });
    let choices = model.choices.iter().map(|one| Choice {
        name: text(&one.name),
        summary: text(&one.summary),
        alternatives: list(one.alternatives.iter().map(|one| text(one))),
    });
    let presets = model.presets.iter().map(|one| Preset {
        name: text(&one.name),
        summary: text(&one.summary),
        values: list(one.values.iter().map(|(name, value)| (text(name), *value))),
    });
    let parts = origin.parts.iter().map(|(path, own)| (text(path), text(own)));
    Mechanism {
        name: text(origin.name),
        title: text(&model.name),
        summary: text(&model.documentation),
        source: text(&model.source),
        file: text(origin.file),
        text: text(origin.text),
        parts: list(parts),
        effects: list(effects),
        choices: list(choices),
        presets: list(presets),
        scenes: list(model.scenes.iter().map(|scene| entry(scene, origin.lines))),
    }
}

/// A scene that values may be bound to.
pub(crate) enum Made {
    Motion(Arc<Motion>),
    Loops(Arc<Loops>),
}

impl Made {
    /// A scene with its shape, and that of the same with all positions as coordinates.
    pub fn of(scene: &SceneModel, shape: &'static Shape, other: Option<&'static Shape>) -> Self {
        match &scene.linkage {
            Some(linkage) => Self::Loops(Arc::new(Loops::new(scene, linkage, shape))),
            None => Self::Motion(Arc::new(Motion::new(scene, shape, other))),
        }
    }
}

/// A scene, and what goes on where it comes to a dead point.
fn entry(scene: &SceneModel, lines: Lines<'_>) -> SceneEntry {
    let shape = shape(scene, lines);
    let expected = shape.constants.len();
    let unreduced: Option<&'static SceneEntry> =
        scene.unreduced.as_ref().map(|other| &*Box::leak(Box::new(entry(other, lines))));
    let bind = match Made::of(scene, shape, unreduced.map(|other| other.shape)) {
        Made::Loops(loops) => Bind::Linkage(Box::leak(Box::new(move |values: &[f64]| {
            counted(values, expected)?;
            bind_linkage(Moved::new(&loops, values))
        }))),
        Made::Motion(motion) => Bind::Motion(Box::leak(Box::new(move |values: &[f64]| {
            counted(values, expected)?;
            match motion.is_smooth() {
                true => bind(Moving::<true>::new(&motion, values)),
                false => bind(Moving::<false>::new(&motion, values)),
            }
        }))),
    };
    SceneEntry { shape, bind, unreduced }
}

/// That there are as many values as the scene has constants.
fn counted(values: &[f64], expected: usize) -> Result<(), Refused> {
    match values.len() == expected {
        true => Ok(()),
        false => Err(Refused {
            name: "number of values".to_owned(),
            reason: format!("found {}, expected {expected}", values.len()),
        }),
    }
}
