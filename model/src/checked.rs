//! The checked model: what a file says once every name, unit and balance is right, one program for each scene.
//!
//! It is plain data. The macro prints it as Rust; the command lists it.

mod linkage;
mod measure;
mod mode;
mod tests;

pub use linkage::{
    AugmentedInfo, DependentInfo, GroupInfo, GroupKind, LinkInfo, LinkageInfo, LoopInfo, RangeInfo,
    VariableInfo,
};
pub use measure::{
    MeasureInfo, Measured, Moment, Primitive, PrimitiveKind, SolvedInfo, SynthesisInfo, TermInfo,
    VariedInfo,
};
pub use mode::{EventInfo, ModeModel};
pub use tests::Test;

use crate::diagnostic::Diagnostic;
use crate::program::{Counts, Program, Staging, Value};
pub use crate::syntax::tree::{Direction, Distribution};
use crate::token::Span;

/// What the compiler made of a file.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Name of the mechanism; empty when not even that could be read.
    pub name: String,
    /// Names of the scenes that the file declares, right or wrong.
    pub scene_names: Vec<String>,
    /// The model, if there is no error.
    pub model: Option<Model>,
    /// Errors and warnings, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
    /// The files of parts that were read, in the order in which their tokens are counted.
    pub parts: Vec<PartFile>,
    /// Steps that were taken to derive everything, the same on every machine. A file that needs too many is an error.
    pub steps: u64,
}

/// A file of a part. Its tokens are counted on behind those of the files before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartFile {
    /// Its path, relative to the folder of the main file.
    pub path: String,
    /// What its first token is counted as.
    pub first: u32,
    /// Where the main file first needs it.
    pub place: Span,
}

/// A mechanism.
#[derive(Clone, Debug)]
pub struct Model {
    /// Name as the file states it, `Batten`.
    pub name: String,
    /// Documentation, lines joined by newlines.
    pub documentation: String,
    /// The cited source.
    pub source: String,
    /// Effects that it may show.
    pub effects: Vec<Described>,
    /// Choices between descriptions.
    pub choices: Vec<ChoiceInfo>,
    /// Named sets of values.
    pub presets: Vec<PresetInfo>,
    /// The scenes, the default one first.
    pub scenes: Vec<SceneModel>,
}

/// A name with its explanation.
#[derive(Clone, Debug)]
pub struct Described {
    /// The name.
    pub name: String,
    /// The explanation.
    pub summary: String,
}

/// Several descriptions of one thing.
#[derive(Clone, Debug)]
pub struct ChoiceInfo {
    /// The name.
    pub name: String,
    /// What is described.
    pub summary: String,
    /// The alternatives, the default one first.
    pub alternatives: Vec<String>,
}

/// A named set of values.
#[derive(Clone, Debug)]
pub struct PresetInfo {
    /// The name.
    pub name: String,
    /// What the values are.
    pub summary: String,
    /// Names of constants with their values in SI units.
    pub values: Vec<(String, f64)>,
}

/// One scene: the mechanism with a set of effects and choices.
#[derive(Clone, Debug, Default)]
pub struct SceneModel {
    /// The name.
    pub name: String,
    /// What it shows.
    pub summary: String,
    /// Effects that are present.
    pub effects: Vec<String>,
    /// For each choice its name and the alternative that holds.
    pub choices: Vec<(String, String)>,
    /// The preset that it starts from; empty for the declared defaults.
    pub preset: String,
    /// Dimensions and parameters that it depends on.
    pub constants: Vec<ConstantInfo>,
    /// Prescribed coordinates.
    pub drivers: Vec<QuantityInfo>,
    /// The state vector: coordinates, their speeds, first-order states.
    pub states: Vec<QuantityInfo>,
    /// What it reports.
    pub outputs: Vec<QuantityInfo>,
    /// Numbers of a whole run.
    pub measures: Vec<MeasureInfo>,
    /// What is found of the run for them.
    pub primitives: Vec<Primitive>,
    /// What it seeks, if it is a synthesis.
    pub synthesis: Option<SynthesisInfo>,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Absolute tolerance of each state per unit of relative tolerance, SI units.
    pub scales: Vec<f64>,
    /// The equations as text.
    pub equations: Vec<EquationInfo>,
    /// Conditions on the values, in the order of the program's `requirements`.
    pub requirements: Vec<RequirementInfo>,
    /// Its task.
    pub span: SpanKind,
    /// Whether energy is conserved: energies are stated, nothing dissipates, and nothing depends on the time.
    pub conservative: bool,
    /// The first number with a length, mass or time in its unit that the motion or an output depends on. Such a scene
    /// cannot be stated in other units by changing the values of its constants.
    pub literal: Option<LiteralInfo>,
    /// Places that plots show.
    pub marks: Vec<MarkInfo>,
    /// Published facts.
    pub expectations: Vec<ExpectInfo>,
    /// The loops, if the scene is a linkage.
    pub linkage: Option<LinkageInfo>,
    /// The loops by which the motion is reduced to its independent coordinates, if it has any.
    pub reduced: Option<LinkageInfo>,
    /// The closures that hold the coordinates of a motion and are not solved for, if it has any.
    pub augmented: Option<AugmentedInfo>,
    /// Names of the points.
    pub points: Vec<String>,
    /// Lines between them.
    pub links: Vec<LinkInfo>,
    /// Forces of closures that are reported, by the first of the two outputs that each is. The places at which they act
    /// stand behind those of the points.
    pub arrows: Vec<usize>,
    /// The scalar closures whose forces others depend on, as friction does.
    pub felt: Vec<String>,
    /// Whether loops that move with coordinates may come to a dead point, where the motion would end.
    pub may_stop: bool,
    /// The same motion with all positions as coordinates, which goes on beyond dead points; where it may come to one.
    pub unreduced: Option<Box<SceneModel>>,
    /// The loops that the motion carries along, one entry for each group that may fail to close.
    pub carried: Vec<LoopInfo>,
    /// The modes, if the motion has any, or events. Each has a program of its own.
    pub modes: Vec<ModeModel>,
    /// The mode in which the motion begins.
    pub first: usize,
    /// The operations.
    pub program: Program,
}

impl SceneModel {
    /// How many operations it takes; of a linkage a position counts as an evaluation, and its influence coefficients as
    /// the Jacobian.
    pub fn counts(&self, staging: &Staging) -> Counts {
        let results = &self.program.results;
        let (evaluated, slopes): (Vec<Value>, Vec<Value>) = match &self.linkage {
            Some(linkage) => {
                let closing = &results.closing;
                (closing.of_position(&linkage.groups), closing.influence.clone())
            }
            None => (results.derivative.clone(), results.slopes().collect()),
        };
        let mut counts = self.program.counts(staging, &evaluated, &slopes);
        for mode in &self.modes {
            let rates = &mode.program.results.derivative;
            counts.unfelt += mode.program.series(rates).map_or(0, |series| series.unfelt(rates));
        }
        counts
    }
}

/// A named quantity with the unit in which it is printed.
#[derive(Clone, Debug)]
pub struct QuantityInfo {
    /// Name as the file writes it, `dot(phi2)` for a derivative.
    pub name: String,
    /// Documentation.
    pub summary: String,
    /// Unit, empty for a pure number.
    pub unit: String,
    /// SI value of one such unit.
    pub factor: f64,
    /// Exponents of m, kg, s, A, K, mol, cd as numerator and denominator.
    pub dimension: [(i8, i8); 7],
}

/// A dimension or parameter.
#[derive(Clone, Debug)]
pub struct ConstantInfo {
    /// Name and unit.
    pub quantity: QuantityInfo,
    /// Whether it is a made dimension.
    pub is_dimension: bool,
    /// Value unless another is given, SI units.
    pub default: f64,
    /// Permitted error of the made size, SI units; zero if none is stated.
    pub tolerance: f64,
    /// How the made sizes are distributed.
    pub distribution: Distribution,
    /// Permitted range, SI units; infinite where open.
    pub range: (f64, f64),
}

/// A number with its unit, as the file writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LiteralInfo {
    /// The number, `3 mm`.
    pub text: String,
    /// Where it stands in the file.
    pub span: Span,
}

/// An equation as text.
#[derive(Clone, Debug)]
pub struct EquationInfo {
    /// The equation.
    pub text: String,
    /// Unit of each of its sides.
    pub unit: String,
    /// Where it stands in the file.
    pub span: Span,
}

/// A condition on the values.
#[derive(Clone, Debug)]
pub struct RequirementInfo {
    /// The condition.
    pub text: String,
    /// The message that the file gives with it, or empty.
    pub message: String,
    /// Indices of the constants concerned.
    pub names: Vec<usize>,
}

/// Task of a scene; its times are values of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpanKind {
    /// The steady state over a period, which is a result where no time is given.
    Periodic,
    /// A motion from a time to a time.
    Run,
    /// A position of rest, with the vibrations about it.
    Rest,
    /// Positions of the drivers over their ranges.
    Sweep,
    /// None stated.
    #[default]
    Open,
}

/// A place that plots show.
#[derive(Clone, Debug)]
pub struct MarkInfo {
    /// What is there.
    pub text: String,
    /// A time, or a position of a driver.
    pub at: ExpectPlace,
}

/// A published fact.
#[derive(Clone, Debug)]
pub struct ExpectInfo {
    /// Where in the motion.
    pub at: ExpectPlace,
    /// What it speaks of.
    pub quantity: Subject,
    /// Published value, SI units.
    pub value: f64,
    /// Half-width of the band, SI units.
    pub tolerance: f64,
    /// Preset to run with; empty for the scene's own values.
    pub preset: String,
    /// What the value is and how far to trust it.
    pub remark: String,
    /// Where it stands in the file.
    pub span: Span,
    /// The fact in words, `phi2 at theta = 1.9198 rad`.
    pub label: String,
}

/// What a fact speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A component of the state, of a linkage a dependent coordinate.
    State(usize),
    /// An output.
    Output(usize),
    /// The influence of a variable of a linkage on an output: output, variable.
    Influence(usize, usize),
    /// A measure.
    Measure(usize),
}

/// A place in a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpectPlace {
    /// At a time, in seconds.
    Time(f64),
    /// Where the driver of this index first reaches a position, SI units.
    Driver(usize, f64),
    /// At positions of the drivers, those that are named (index and position, SI units).
    Position(Vec<(usize, f64)>),
    /// Largest value over the task.
    Maximum,
    /// Smallest value over the task.
    Minimum,
    /// Largest absolute value over the task.
    Amplitude,
    /// The whole run.
    Run,
}
