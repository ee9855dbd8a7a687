//! What every command asks about: a mechanism, one of its scenes, and values.

pub mod case;
pub mod changes;
pub mod constants;
pub mod file;
pub mod lookup;
pub mod modes;
pub mod permitted;
pub mod place;
pub mod range;
pub mod settings;
pub mod tolerances;
pub mod values;
pub mod variables;
pub mod wanted;

use assur::registry::{Mechanism, SceneEntry};
use assur_model::asked::Asked as Scenes;
use clap::Args;

use crate::draw::surface;
use crate::error::Failure;
use crate::source::{Source, Wanted};
use changes::Changes;
use constants::Constants;
use lookup::Registry;

/// The options that say so.
#[derive(Args, Clone, Debug, Default)]
pub struct Asked {
    /// The mechanism, as `assur list` names it; or an equation file, `my.eqn`, or `-` for standard input.
    pub name: Option<String>,
    /// The scene; unless given the first one of the file that the command is for.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    #[command(flatten)]
    pub values: Values,
    #[command(flatten)]
    pub changes: Changes,
}

/// The options that change values.
#[derive(Args, Clone, Debug, Default)]
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
    /// Those that choose their own values.
    Synthesis,
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
            Self::Synthesis => scene.synthesis.is_some(),
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
            Self::Synthesis => Err(lookup::no_synthesis(mechanism, scene)),
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
        let file = self.file()?;
        let statements = self.changes.statements()?;
        let found = self.with(registry, command, scenes, file.as_ref(), &statements)?;
        let Some(number) = self.changes.mode else { return Ok(found) };
        let started = modes::start(found, number)?;
        self.with(registry, command, scenes, file.as_ref(), &[statements, vec![started]].concat())
    }

    /// The equation file, if it is one that is asked about.
    fn file(&self) -> Result<Option<Source>, Failure> {
        let name = self.name.as_deref();
        name.filter(|name| file::is_file(name)).map(file::read).transpose()
    }

    /// The scene with its values, changed by statements.
    fn with(
        &self,
        registry: Registry,
        command: &str,
        scenes: For,
        file: Option<&Source>,
        statements: &[String],
    ) -> Result<Constants, Failure> {
        if statements.is_empty() {
            let mechanism = self.mechanism(registry, command, scenes, file)?;
            return self
                .constants(mechanism, scenes.scene(registry, mechanism, self.scene.as_deref())?);
        }
        let mechanism = match file {
            Some(source) => self.changed(source, scenes, statements, || {
                file::mechanism(source, Wanted::Scenes(Scenes::All))
            }),
            None => {
                let mechanism = registry.mechanism(self.name.as_deref(), command, scenes)?;
                let source = Source::of(mechanism)?.call(mechanism.name);
                self.changed(&source, scenes, statements, || Ok(mechanism))
            }
        }?;
        let found = self.constants(mechanism, scenes.scene(registry, mechanism, None)?)?;
        Ok(Constants { changes: statements.to_vec(), ..found })
    }

    /// The mechanism, of a file those scenes that are asked for.
    fn mechanism(
        &self,
        registry: Registry,
        command: &str,
        scenes: For,
        file: Option<&Source>,
    ) -> Result<&'static Mechanism, Failure> {
        let (name, scene) = (self.name.as_deref(), self.scene.as_deref());
        let Some(source) = file else {
            return registry.mechanism(name, command, scenes);
        };
        let names: Vec<&str> =
            scene.iter().flat_map(|names| names.split(',')).map(str::trim).collect();
        let asked = match (names.as_slice(), scenes) {
            ([], For::All) => Scenes::Some(&[]),
            ([], _) => Scenes::All,
            (names, _) => Scenes::Some(names),
        };
        file::mechanism(source, Wanted::Scenes(asked))
    }

    /// A mechanism with a scene that is made of another: of that which is named, or the first one that suits.
    fn changed(
        &self,
        source: &Source,
        scenes: For,
        statements: &[String],
        whole: impl FnOnce() -> Result<&'static Mechanism, Failure>,
    ) -> Result<&'static Mechanism, Failure> {
        let base = match (self.scene.as_deref(), scenes) {
            (Some(name), _) => Some(name),
            (None, For::All) => None,
            (None, _) => {
                let mut all = whole()?.scenes.iter();
                all.find(|scene| scenes.suits(scene)).map(|scene| scene.name)
            }
        };
        file::mechanism(source, Wanted::Changed(base, &(statements.join("\n") + "\n")))
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
        if self.changes.are_given() {
            return match names.contains(',') {
                true => Err(Failure::request("changes are those of one scene")
                    .place(format!("--scene {names}"))
                    .remedy("name one scene, or leave the changes out")),
                false => Ok(vec![self.find(registry, command, scenes)?]),
            };
        }
        let mechanism = self.mechanism(registry, command, scenes, self.file()?.as_ref())?;
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
