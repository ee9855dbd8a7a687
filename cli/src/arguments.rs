//! What can be asked of the command, with the help that it gives.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::answer::Format;
use crate::ask::settings::Accuracy;
use crate::ask::{Asked, Values};
use crate::draw::surface::arguments::SurfaceArguments;

/// Mechanisms as equation files: run, check and explain them.
#[derive(Debug, Parser)]
#[command(
    name = "assur",
    version,
    disable_help_subcommand = true,
    after_help = "Begin with:\n  assur list\n  assur run batten\n\nExit codes: 0 done, 1 the numbers did not come out, 2 the request is wrong."
)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the mechanisms with their scenes, those of the command or of equation files.
    #[command(
        after_help = "Examples:\n  assur list\n  assur list my_mechanisms\n  assur list press.eqn hammer.eqn"
    )]
    List(ListArguments),
    /// Write an equation file to begin with.
    #[command(after_help = crate::new::EXAMPLES)]
    New(crate::new::NewArguments),
    /// Run a scene: its results, the published values beside them, and a figure of its curves.
    #[command(after_help = RUN_EXAMPLES)]
    Run(RunArguments),
    /// Draw a linkage at some positions, and moving; or a surface, also into files of its facets.
    #[command(after_help = DRAW_EXAMPLES)]
    Draw(DrawArguments),
    /// Show the loops of a linkage, its degrees of freedom and the order of solution.
    #[command(
        after_help = "Examples:\n  assur structure heald_linkage\n  assur structure heald_linkage --scene straight --format json"
    )]
    Structure(StructureArguments),
    /// Check an equation file without compiling anything.
    #[command(
        after_help = "Example:\n  assur check my_linkage.eqn\n\nExit codes: 0 no error, 2 at least one error."
    )]
    Check(CheckArguments),
    /// Test a mechanism: its derivatives, energies, loops and units, and its published numbers.
    #[command(
        after_help = "Examples:\n  assur test my_linkage.eqn\n  assur test my_linkage.eqn --scene turn\n\nThe tests are those that the compiler generates from the model. Exit codes: 0 all passed, 1 at least one failed."
    )]
    Test(TestArguments),
    /// Print the Rust that an equation file becomes.
    #[command(
        after_help = "Examples:\n  assur expand batten --scene elastic\n  assur expand my_linkage.eqn"
    )]
    Expand(ExpandArguments),
    /// Write a page of all mechanisms: pictures, equations, scenes, published numbers beside the computed ones.
    #[command(after_help = crate::gallery::EXAMPLES)]
    Gallery(crate::gallery::GalleryArguments),
    /// Compare the scenes of a mechanism: size, cost, and what each effect changes.
    #[command(
        after_help = "Examples:\n  assur scenes batten\n  assur scenes batten --against exact --plot effects.svg\n  assur scenes batten --within F2=5% --over n=150..400rpm"
    )]
    Scenes(ScenesArguments),
    /// List all assembly modes of a linkage at a position.
    #[command(after_help = crate::modes::EXAMPLES)]
    Modes(crate::modes::ModesArguments),
    /// Measure many runs: over a range of values, over two of them, or with values made at random.
    #[command(after_help = crate::study::EXAMPLES)]
    Study(crate::study::StudyArguments),
    /// Seek the values for which a scene is as it should be.
    #[command(after_help = crate::synth::EXAMPLES)]
    Synth(crate::synth::SynthArguments),
    /// Find what accuracy costs in time: each method at each tolerance against a reference.
    #[command(after_help = crate::cost::EXAMPLES)]
    Cost(crate::cost::CostArguments),
    /// Find how an output errs by the tolerances, and tolerances of least cost.
    #[command(after_help = crate::tolerance::EXAMPLES)]
    Tolerance(crate::tolerance::ToleranceArguments),
    /// Print what an answer in JSON is made of, as JSON Schema.
    #[command(after_help = "Example:\n  assur schema run > assur-run.schema.json")]
    Schema(crate::schema::SchemaArguments),
}

const RUN_EXAMPLES: &str = "Examples:
  assur run batten
  assur run batten --scene exact --set n=300rpm --at theta=110deg
  assur run batten --rtol 1e-12 --format json
  assur run batten --scene start --rtol 1e-8 --atol 'phi2=1e-12 rad'
  assur run batten --format csv > batten.csv
  assur run heald_linkage --at phi4=75deg --set l4=91mm
  assur run heald_linkage --format csv --rows limits
  assur run gear_flank --scene addendum --format csv --places u=21,th=41
  assur run table_drive --format csv --rows events
  assur run my.eqn --watch
  assur run batten --with damping --run 0s..0.5s --start 'phi2=0.01rad'

A linkage is moved through the positions of its drivers: --at names one of each, alpha=90deg,beta=180deg; a driver that
is not named stands where it starts.

One JSON object is printed with --format json, which `assur schema run` describes.

The figure goes to NAME-SCENE.svg in the current directory, or where --out or --plot say;
with --format json or csv it is drawn only when one of these asks for it.";

const DRAW_EXAMPLES: &str = "Examples:
  assur draw heald_linkage
  assur draw heald_linkage --scene straight --at phi4=90deg --at phi4=110deg --out pictures
  assur draw gear_flank --scene addendum,dedendum,addendum_left,dedendum_left
  assur draw gear_flank --scene addendum --surface r_gear --view 60deg,20deg --places u=13,th=41
  assur draw gear_flank --scene dedendum --surface r_gear --obj flank.obj --stl flank.stl

Of a scene with points two files are written: NAME-SCENE-positions.svg, the first position strong and the others pale,
with the paths of the points; and NAME-SCENE-moving.svg, which any browser plays.

A scene that sweeps two values and has a vector of three lengths as an output is a surface, without perspective and
shaded: NAME-SCENE-surface.svg, of several scenes NAME-surface.svg. Outside is where a vector of length one among the
outputs points to that is its normal, else where the first swept value turns anticlockwise into the second; --flip turns
a scene over. What has no value at a corner is a hole. STL has no units: its lengths are in millimetres.
The places of a surface as comma-separated values: assur run NAME --scene SCENE --format csv --places 41.";

/// Options of `assur list`.
#[derive(Args, Debug)]
pub struct ListArguments {
    /// Equation files, and directories of them; the mechanisms of the command unless given.
    #[arg(value_name = "FILE.eqn|DIR")]
    pub paths: Vec<PathBuf>,
}

/// Options of `assur run`.
#[derive(Args, Debug, Default)]
pub struct RunArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// A position of the drivers or a time at which to print everything, `theta=110deg`, `time=0.1s`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub at: Vec<String>,
    /// Places along each value that a linkage or formula sheet sweeps, evenly apart, `41` or `u=21,th=41`: the rows of
    /// --format csv. Round ones unless given.
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pub places: Option<String>,
    #[command(flatten)]
    pub accuracy: Accuracy,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
    /// What the rows are with --format csv.
    #[arg(long, value_enum, default_value_t = Rows::Positions)]
    pub rows: Rows,
    /// File for the figure.
    #[arg(long, value_name = "FILE.svg", conflicts_with = "out")]
    pub plot: Option<PathBuf>,
    /// Directory for the figure, created if it is missing.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Curves of the figure, `phi2,dot(phi2)`, of a linkage `diff(phi7, l5)` too, of a motion with energies
    /// `energy,energy(kinetic),energy(potential)`, or `all`; those that matter most unless given.
    #[arg(long, value_name = "NAMES")]
    pub curves: Option<String>,
    /// Run an equation file again at each change of it, or of the files of its parts.
    #[arg(long)]
    pub watch: bool,
}

/// What the rows of comma-separated values are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Rows {
    /// Samples or positions over the task.
    #[default]
    Positions,
    /// Of a linkage: extremes, strokes, limit positions, and how far the drivers go.
    Limits,
    /// Of a motion with events: each with its time, the modes and the state before and after it.
    Events,
}

/// Options of `assur draw`.
#[derive(Args, Debug, Default)]
pub struct DrawArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// A position of the drivers or a time to draw, `phi4=90deg`, `time=0.1s`; may be repeated. Some over the range unless
    /// given.
    #[arg(long, value_name = "NAME=VALUE")]
    pub at: Vec<String>,
    /// Forces of closures that the scene reports, as arrows.
    #[arg(long)]
    pub forces: bool,
    /// The vibration about a position of rest that moves the picture, 1 being the slowest.
    #[arg(long, value_name = "NUMBER")]
    pub vibration: Option<usize>,
    #[command(flatten)]
    pub surface: SurfaceArguments,
    /// Directory for the pictures, created if it is missing.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Options of `assur structure`.
#[derive(Args, Debug)]
pub struct StructureArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// Options of `assur check`.
#[derive(Args, Debug)]
pub struct CheckArguments {
    /// The equation files; `-` is standard input.
    #[arg(required = true, value_name = "FILE.eqn")]
    pub files: Vec<PathBuf>,
}

/// Options of `assur expand`.
#[derive(Args, Debug)]
pub struct ExpandArguments {
    /// The mechanism, or an equation file.
    pub name: Option<String>,
    /// Only this scene.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
}

/// Options of `assur scenes`.
#[derive(Args, Debug)]
pub struct ScenesArguments {
    /// The mechanism, or an equation file.
    pub name: Option<String>,
    #[command(flatten)]
    pub values: Values,
    /// The scene that the others are compared with; the one with most effects unless given.
    #[arg(long, value_name = "SCENE")]
    pub against: Option<String>,
    /// By how much outputs and measures may differ from that scene, `1%`, `'F2=2N'`, `'peak_F=5%'`; may be repeated. Which
    /// combination of effects and choices, with a name or not, is the cheapest one that keeps this.
    #[arg(long, value_name = "[NAME=]VALUE")]
    pub within: Vec<String>,
    /// The effects and choices that may differ, `bending,crank`; unless given all those of that scene.
    #[arg(long, value_name = "NAMES", value_delimiter = ',', requires = "within")]
    pub among: Vec<String>,
    /// A range of a parameter that it is to keep this over, `n=150..400rpm`, at five values or as many as `:9` says.
    #[arg(long, value_name = "NAME=FROM..TO[:COUNT]", requires = "within")]
    pub over: Option<String>,
    /// File for a figure: what each scene costs and by how much it differs from that one.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
}

/// Options of `assur test`.
#[derive(Args, Debug)]
pub struct TestArguments {
    /// The mechanism, or an equation file.
    pub name: Option<String>,
    /// The scene; all unless given.
    #[arg(long)]
    pub scene: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn options_may_stand_before_or_after_the_name() {
        for words in [
            ["assur", "run", "--rtol", "1e-9", "batten"],
            ["assur", "run", "batten", "--rtol", "1e-9"],
        ] {
            let Ok(Arguments { command: Command::Run(options) }) = Arguments::try_parse_from(words)
            else {
                panic!("{words:?} is not understood");
            };
            assert_eq!(options.asked.name.as_deref(), Some("batten"));
            assert_eq!(options.accuracy.rtol, Some(1e-9));
        }
    }
}
