//! The dimensions and parameters of a scene, and what stands behind `--set` and `--preset`.

use assur::registry::{Mechanism, Preset, SceneEntry};
use assur_model::asked::UNNAMED;

use crate::ask::file;
use crate::ask::lookup::{suggestion, with_feature};
use crate::ask::permitted::permitted;
use crate::ask::values::{quantity, split};
use crate::error::Failure;

/// The dimensions and parameters of a scene with their values, SI units.
#[derive(Clone)]
pub struct Constants {
    /// The mechanism.
    pub mechanism: &'static Mechanism,
    /// The scene.
    pub scene: &'static SceneEntry,
    /// The preset that the values start from; empty for the declared ones.
    pub preset: &'static str,
    /// The values, in the order of the scene.
    pub values: Vec<f64>,
    /// The statements by which the scene differs from that of the file.
    pub changes: Vec<String>,
    /// Whether the value was given by `--set`.
    pub(super) given: Vec<bool>,
}

impl Constants {
    /// The values that the file declares.
    pub fn declared(mechanism: &'static Mechanism, scene: &'static SceneEntry) -> Self {
        Self {
            mechanism,
            scene,
            preset: scene.preset,
            values: scene.constants.iter().map(|constant| constant.default).collect(),
            changes: Vec::new(),
            given: vec![false; scene.constants.len()],
        }
    }

    /// The values of the file, with a preset and single values put over them.
    ///
    /// # Errors
    /// Unknown names, wrong units, values that cannot be.
    pub fn from_options(
        mechanism: &'static Mechanism,
        scene: &'static SceneEntry,
        preset: Option<&str>,
        sets: &[String],
    ) -> Result<Self, Failure> {
        let mut constants = Self::declared(mechanism, scene);
        if let Some(name) = preset {
            constants.apply(find_preset(mechanism, name)?);
        }
        for text in sets {
            constants.set(text)?;
        }
        Ok(constants)
    }

    /// The same with other values, SI units.
    pub fn with_values(&self, values: &[f64]) -> Self {
        Self { values: values.to_vec(), ..self.clone() }
    }

    /// The same values in another form of the scene.
    pub fn in_scene(&self, scene: &'static SceneEntry) -> Self {
        let changes = self.changes.clone();
        let mut other =
            Self { preset: self.preset, changes, ..Self::declared(self.mechanism, scene) };
        for (index, constant) in scene.constants.iter().enumerate() {
            if let Some(place) = self.position(constant.quantity.name) {
                (other.values[index], other.given[index]) = (self.values[place], self.given[place]);
            }
        }
        other
    }

    /// What is found of the scene, or where it comes to a dead point of the same with all positions as coordinates.
    ///
    /// # Errors
    /// When neither is found.
    pub fn going_on<T>(self, find: impl Fn(Self) -> Result<T, Failure>) -> Result<T, Failure> {
        let unreduced = self.scene.unreduced.map(|scene| self.in_scene(scene));
        find(self).or_else(|failure| match unreduced {
            Some(unreduced) if failure.is_lost() => find(unreduced),
            _ => Err(failure),
        })
    }

    /// The values of the file, with a preset put over them unless its name is empty.
    ///
    /// # Errors
    /// When there is no preset of this name.
    pub fn of_preset(&self, name: &str) -> Result<Self, Failure> {
        let preset = (!name.is_empty()).then_some(name);
        Self::from_options(self.mechanism, self.scene, preset, &[])
    }

    /// Puts a named set of values over these; values that the scene does not have are passed over.
    fn apply(&mut self, preset: &Preset) {
        self.preset = preset.name;
        for (name, value) in preset.values {
            if let Some(index) = self.position(name) {
                self.values[index] = *value;
            }
        }
    }

    fn position(&self, name: &str) -> Option<usize> {
        self.scene.constants.iter().position(|constant| constant.quantity.name == name)
    }

    fn set(&mut self, text: &str) -> Result<(), Failure> {
        let (name, value) = split(text, "--set", "n=300rpm")?;
        let index = self
            .position(name)
            .ok_or_else(|| unknown_constant(self.mechanism, self.scene, name))?;
        if self.given[index] {
            return Err(Failure::request(format!("`{name}` is given twice"))
                .place(format!("--set {text}"))
                .remedy("leave one of them out"));
        }
        let constant = &self.scene.constants[index];
        let value = quantity(value, &constant.quantity)
            .map_err(|failure| failure.place(format!("--set {text}")))?;
        permitted(constant, value).map_err(|failure| failure.place(format!("--set {text}")))?;
        self.values[index] = value;
        self.given[index] = true;
        Ok(())
    }

    /// Names of the values that were given by `--set`.
    pub fn given_names(&self) -> Vec<&'static str> {
        let constants = self.scene.constants.iter().zip(&self.given);
        let given = constants.filter(|(_, given)| **given);
        given.map(|(constant, _)| constant.quantity.name).collect()
    }

    /// Whether any value differs from the file's.
    pub fn changed(&self) -> bool {
        (0..self.values.len()).any(|index| self.is_changed(index))
    }

    /// Whether a value differs from the file's.
    pub fn is_changed(&self, index: usize) -> bool {
        self.scene.constants[index].default != self.values[index]
    }
}

/// The preset of this name.
///
/// # Errors
/// When there is none; the nearest name is offered.
fn find_preset(mechanism: &'static Mechanism, name: &str) -> Result<&'static Preset, Failure> {
    mechanism.presets.iter().find(|preset| preset.name == name).ok_or_else(|| {
        let names: Vec<_> = mechanism.presets.iter().map(|preset| preset.name).collect();
        Failure::request(format!("`{}` has no preset `{name}`", mechanism.name))
            .place(format!("--preset {name}"))
            .remedy(suggestion(name, &names))
    })
}

fn unknown_constant(
    mechanism: &'static Mechanism,
    scene: &'static SceneEntry,
    name: &str,
) -> Failure {
    let failure = Failure::request(format!(
        "scene `{}` of `{}` has no parameter `{name}`",
        scene.name, mechanism.name
    ))
    .place(format!("--set {name}=…"));
    if let Some(words) = with_feature(mechanism, name) {
        return failure.remedy(words);
    }
    if scene.drivers.iter().any(|driver| driver.name == name) {
        return failure.remedy(format!(
            "`{name}` is driven; --at {name}=… prints everything at a position of it"
        ));
    }
    // Of a file only the scenes that are asked for were read.
    let is_whole = !file::is_file(mechanism.name) && scene.name != UNNAMED;
    let whole = if is_whole { mechanism } else { file::whole(mechanism) };
    let elsewhere: Vec<_> = whole
        .scenes
        .iter()
        .filter(|other| other.constants.iter().any(|constant| constant.quantity.name == name))
        .map(|other| other.name)
        .collect();
    if !elsewhere.is_empty() {
        return failure.remedy(format!("it belongs to --scene {}", elsewhere.join(", --scene ")));
    }
    let names: Vec<_> = scene.constants.iter().map(|constant| constant.quantity.name).collect();
    failure.remedy(suggestion(name, &names))
}
