//! What every command asks about: a mechanism, one of its scenes, and values.

pub mod case;
pub mod constants;
pub mod lookup;
pub mod permitted;
pub mod place;
pub mod settings;
pub mod values;
pub mod variables;

use assur::registry::{Mechanism, SceneEntry};
use clap::Args;

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
    /// Those that have points.
    Drawn,
}

impl For {
    fn suits(self, scene: &SceneEntry) -> bool {
        match self {
            Self::All => true,
            Self::Linkages => scene.linkage.is_some(),
            Self::Loops => {
                scene.linkage.is_some() || scene.reduced.is_some() || scene.augmented.is_some()
            }
            Self::Measured => !scene.measures.is_empty(),
            Self::Drawn => !scene.points.is_empty(),
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
            Self::Drawn => Err(Failure::request(format!("scene `{}` has no points", scene.name))
                .remedy(
                    "state them in the equation file: point A = [0, 0]; link A - B \"crank\";",
                )),
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
        let scene = scenes.scene(registry, mechanism, self.scene.as_deref())?;
        let Values { preset, set } = &self.values;
        Constants::from_options(mechanism, scene, preset.as_deref(), set)
    }
}
