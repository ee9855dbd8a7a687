//! Mechanisms as data: what the command and the generated tests need to run any scene without knowing its type.
//!
//! Emitted code fills these tables. The solvers never look at a name or a unit in them; they are carried for whoever
//! prints the answer, and the dimensions for [`crate::check::scaling`].

mod bind;
mod linkage;
mod unit;

pub use bind::{bind, check_values, unmet, with};
pub use linkage::bind_linkage;
pub use unit::{si, stated};

use assur_solvers::closure::AnyLinkage;
use assur_solvers::model::Model;
use assur_solvers::problem::Refused;
use assur_solvers::shape::Shape;

/// One equation file.
#[derive(Clone, Copy)]
pub struct Mechanism {
    /// Name as the command takes it, `batten`.
    pub name: &'static str,
    /// Name as the file states it, `Batten`.
    pub title: &'static str,
    /// Documentation of the mechanism, lines joined by newlines.
    pub summary: &'static str,
    /// Source that the file cites.
    pub source: &'static str,
    /// File name of the equation file, `batten.eqn`; empty for a mechanism written inline.
    pub file: &'static str,
    /// Text of the equation file; empty for a mechanism written inline.
    pub text: &'static str,
    /// Paths, relative to the equation file, and texts of the files of its parts; none for a mechanism written inline.
    pub parts: &'static [(&'static str, &'static str)],
    /// Effects that the mechanism may show.
    pub effects: &'static [Named],
    /// Choices between descriptions, each with its alternatives.
    pub choices: &'static [Choice],
    /// Named sets of values.
    pub presets: &'static [Preset],
    /// The scenes, the default one first.
    pub scenes: &'static [SceneEntry],
}

/// A name with a line of explanation.
#[derive(Clone, Copy, Debug)]
pub struct Named {
    /// The name.
    pub name: &'static str,
    /// What it stands for.
    pub summary: &'static str,
}

/// Several descriptions of one thing.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// Name of the choice.
    pub name: &'static str,
    /// What is described.
    pub summary: &'static str,
    /// The alternatives, the default one first.
    pub alternatives: &'static [&'static str],
}

/// A named set of values.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Name of the preset.
    pub name: &'static str,
    /// What the values are.
    pub summary: &'static str,
    /// Names of parameters with their values in SI units.
    pub values: &'static [(&'static str, f64)],
}

/// What fixes the values of a scene (SI units, in the order of its constants), if the mechanism accepts them.
pub type Binder<R> = &'static (dyn Fn(&[f64]) -> Result<Box<R>, Refused> + Sync);

/// Fixes the values of a scene.
#[derive(Clone, Copy)]
pub enum Bind {
    /// Of a scene that moves by its equations of motion.
    Motion(Binder<dyn Model>),
    /// Of a linkage.
    Linkage(Binder<dyn AnyLinkage>),
}

impl Bind {
    /// Fixes the values of a scene that moves by its equations of motion.
    ///
    /// # Errors
    /// The first value or condition that the mechanism does not accept, or that the scene is a linkage.
    pub fn motion(&self, values: &[f64]) -> Result<Box<dyn Model>, Refused> {
        match self {
            Bind::Motion(bind) => bind(values),
            Bind::Linkage(_) => Err(other_kind("a linkage, which is moved from outside")),
        }
    }

    /// Fixes the values of a linkage.
    ///
    /// # Errors
    /// The first value or condition that the mechanism does not accept, or that the scene is none.
    pub fn linkage(&self, values: &[f64]) -> Result<Box<dyn AnyLinkage>, Refused> {
        match self {
            Bind::Linkage(bind) => bind(values),
            Bind::Motion(_) => Err(other_kind("no linkage: it moves by its equations of motion")),
        }
    }
}

fn other_kind(reason: &str) -> Refused {
    Refused { name: "the scene".to_string(), reason: format!("it is {reason}") }
}

/// One scene of a mechanism: its shape, and what fixes its values.
#[derive(Clone, Copy)]
pub struct SceneEntry {
    /// What it is made of.
    pub shape: &'static Shape,
    /// Fixes its values.
    pub bind: Bind,
    /// The same motion with all positions as coordinates, where this one may come to a dead point.
    pub unreduced: Option<&'static SceneEntry>,
}

impl std::ops::Deref for SceneEntry {
    type Target = Shape;

    fn deref(&self) -> &Shape {
        self.shape
    }
}
