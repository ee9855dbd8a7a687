//! What can be asked of `assur synth`.

use std::path::PathBuf;

use clap::Args;

use crate::answer::Format;
use crate::ask::Asked;
use crate::ask::settings::Accuracy;
use crate::ask::values::whole;

/// Examples, and what is found.
pub const EXAMPLES: &str = "Examples:
  assur synth my.eqn
  assur synth my.eqn --evaluations 400000 --searches 8 --seed 7
  assur synth my.eqn --set l4=110mm --format json
  assur synth my.eqn --resume my.search
  assur synth my.eqn --resume my.search --more 60s
  assur synth my.eqn --plot best.svg --draw best-positions.svg

The scene says what is varied, kept and made small: `vary l1 in 5 mm .. 60 mm;`, `require peak(mu) < 50 deg;`,
`minimise peak(abs(error));`. Its own values do not count where they are varied, so that --set and --preset give the others.

All designs between the bounds are sought, several times, each time from others; a design that misses a condition is worse than
any that keeps it. What a search finds is polished by quadratic programmes: of a linkage all places count at which an extreme may
lie. The distinct designs are printed, the best one first, with what is left of each condition, what holds it where it is, and
as a preset that can be put into the equation file. An interrupt (Ctrl-C) ends the search and prints what there is; with --resume
it goes on later, and finds what it would have found without a stop.

Start values pick the assembly mode of every design: where they follow from the dimensions, `dependent psi ~ eta + mode*90 deg`,
all designs that close in the mode that is meant have it, and `vary mode in {-1, 1};` seeks in both. What had better be kept, but
need not, is a `prefer peak(mu) < 50 deg weight 0.2;`: `max(…, 0)` of what is to be small has a corner at which polishing stops.
What follows at once from a condition on positions need not be sought: `solve for x, y, r: inner(C - D, C - D) = r^2;`.

Many short searches find more than few long ones, since what they find is polished: some hundred designs each are enough.

Csv has one row a design.";

/// Most designs that are judged.
const MOST: u64 = 10_000_000_000;
/// Most threads.
const THREADS: u64 = 1024;

/// Options of `assur synth`.
#[derive(Args, Debug)]
pub struct SynthArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// Designs that are judged, all searches together.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<1, MOST>)]
    #[arg(default_value = "8000", allow_hyphen_values = true)]
    pub evaluations: u64,
    /// Searches, each from other designs.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<1, 10_000>)]
    #[arg(default_value = "8", allow_hyphen_values = true)]
    pub searches: u64,
    /// Designs of the first generation of a search; 18 for each value that is varied unless given.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<4, 65_536>)]
    #[arg(allow_hyphen_values = true)]
    pub population: Option<u64>,
    /// Which designs are begun with: the same seed finds the same ones.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<0, { u64::MAX }>)]
    #[arg(default_value = "1", allow_hyphen_values = true)]
    pub seed: u64,
    /// Number of threads; as many as the machine has unless given.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<0, THREADS>)]
    #[arg(default_value = "0", allow_hyphen_values = true)]
    pub threads: u64,
    /// Seeks on after these searches, each time from other designs, for so long: `60s`.
    #[arg(long, value_name = "TIME")]
    pub more: Option<String>,
    /// The design first that is best where it is made within the tolerances of its dimensions.
    #[arg(long)]
    pub robust: bool,
    /// A file of where the search stands. If it is there the search goes on from it; it is written again and again, and once more
    /// where the search ends or is interrupted.
    #[arg(long, value_name = "FILE")]
    pub resume: Option<PathBuf>,
    /// Draws what the best design does over its task: its outputs.
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Draws the best design at some positions.
    #[arg(long, value_name = "FILE")]
    pub draw: Option<PathBuf>,
    #[command(flatten)]
    pub accuracy: Accuracy,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}
