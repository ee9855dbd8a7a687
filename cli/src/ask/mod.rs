//! What every command asks about: a mechanism, one of its scenes, and values.

pub mod case;
pub mod constants;
pub mod file;
pub mod lookup;
pub mod permitted;
pub mod place;
pub mod settings;
pub mod values;
pub mod variables;

use assur::registry::{Mechanism, SceneEntry};
use clap::Args;

use crate::draw::surface;
use crate::error::Failure;
use constants::Constants;
use lookup::Registry;

/// The options that say so.
#[derive(Args, Debug, Default)]
pub struct Asked {
    /// The mechanism, as `assur list` names it.
    pub name: Option<String>,
    /// The scene; unless given the first one of the file that the command is for.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    #[command(flatten)]
    pub values: Values,
}

/// The options that change values.
#[derive(Args, Debug, Default)]
pub struct Values {
    /// A named set of values to start from.
    #[arg(long, value_name = "PRESET")]
    pub preset: Option<String>,
    /// A dimension or parameter with its unit, `n=300rpm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}

/// Which scenes a command is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum For {
    /// Any.
    All,
    /// Linkages.
    Linkages,
    /// Those that close loops: linkages, and motions that loops reduce.
    Loops,
    /// Those that have measures.
    Measured,
    /// Those that have points, or are surfaces.
    Drawn,
}

impl For {
    /// Whether a scene is one of them.
    pub fn suits(self, scene: &'static SceneEntry) -> bool {
        match self {
            Self::All => true,
            Self::Linkages => scene.linkage.is_some(),
            Self::Loops => {
                scene.linkage.is_some() || scene.reduced.is_some() || scene.augmented.is_some()
            }
            Self::Measured => !scene.measures.is_empty(),
            Self::Drawn => !scene.points.is_empty() || surface::is_surface(scene),
        }
    }

    /// The scene of this name; unless given the first one that suits.
    fn scene(
        self,
        registry: Registry,
        mechanism: &'static Mechanism,
        name: Option<&str>,
    ) -> Result<&'static SceneEntry, Failure> {
        let mut scenes = mechanism.scenes.iter();
        let scene = match (name, scenes.find(|scene| self.suits(scene))) {
            (None, Some(first)) => first,
            _ => lookup::scene(mechanism, name)?,
        };
        match self {
            _ if self.suits(scene) => Ok(scene),
            Self::Linkages | Self::Loops => Err(lookup::no_linkage(registry, mechanism, scene)),
            Self::Drawn => Err(surface::nothing(mechanism, scene)),
            _ => Err(lookup::no_measures(mechanism, scene)),
        }
    }
}

impl Asked {
    /// The scene with its values.
    ///
    /// # Errors
    /// Unknown names, wrong units, values that cannot be; a scene that the command is not for.
    pub fn find(
        &self,
        registry: Registry,
        command: &str,
        scenes: For,
    ) -> Result<Constants, Failure> {
        let mechanism = registry.mechanism(self.name.as_deref(), command, scenes)?;
        self.constants(mechanism, scenes.scene(registry, mechanism, self.scene.as_deref())?)
    }

    /// The scenes of which names are given, with commas between them, each with its values.
    ///
    /// # Errors
    /// As [`Asked::find`].
    pub fn find_all(
        &self,
        registry: Registry,
        command: &str,
        scenes: For,
    ) -> Result<Vec<Constants>, Failure> {
        let Some(names) = &self.scene else {
            return Ok(vec![self.find(registry, command, scenes)?]);
        };
        let mechanism = registry.mechanism(self.name.as_deref(), command, scenes)?;
        let scene = |name: &str| {
            self.constants(mechanism, scenes.scene(registry, mechanism, Some(name.trim()))?)
        };
        names.split(',').map(scene).collect()
    }

    fn constants(
        &self,
        mechanism: &'static Mechanism,
        scene: &'static SceneEntry,
    ) -> Result<Constants, Failure> {
        let Values { preset, set } = &self.values;
        Constants::from_options(mechanism, scene, preset.as_deref(), set)
    }
}
