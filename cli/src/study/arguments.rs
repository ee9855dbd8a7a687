//! What can be asked of `assur study`.

use std::path::PathBuf;

use clap::Args;

use crate::answer::Format;
use crate::ask::Asked;
use crate::ask::settings::Accuracy;
use crate::ask::values::whole;

/// Examples, and what the formats contain.
pub const EXAMPLES: &str = "Examples:
  assur study presser_foot --over 'omega=150..420[1/s]:55' --measure free,F_smallest --plot lift_off.svg
  assur study presser_foot --over 'omega=200..420[1/s]:23' --over F10=10..80N:15 --measure free --plot map.svg
  assur study presser_foot --attractors --over 'omega=450..700[1/s]:26' --measure F_largest --plot attractors.svg
  assur study batten --resonances --over n=150..400rpm:251
  assur study batten --scene damped --sensitivity --measure peak_rod1,mean_loss
  assur study heald_linkage --over 's=30..50mm:21'
  assur study table_drive --samples 1000 --tolerance J2=10% --tolerance c=20% --seed 7

--over runs through values from one end to the other, so many of them: one for curves, two for a map.
--samples makes values at random: those with a tolerance in the file, and those that --tolerance gives one, distributed as
the file says (normally, the tolerance being three standard deviations) unless a distribution stands behind it.

--attractors finds all motions that attract at each value: from the start of the scene, from starts made at random about its
motion, and from what attracts at the neighbouring values, from below and from above.
--resonances follows the Floquet multipliers: where one passes 1 there is a resonance; where one passes -1, or two meet,
motions may begin to grow, and the ranges in which they do are found however narrow they are.
--sensitivity finds the derivatives of the measures by every dimension and parameter, from differences whose steps go to
nothing, with their errors.

Csv has one row a run, a motion that attracts, a resonance, or a dimension or parameter.";

/// Most runs of a study.
pub const MOST: u64 = 10_000_000;
/// Most threads.
const THREADS: u64 = 1024;

/// Options of `assur study`.
#[derive(Args, Debug, Default)]
pub struct StudyArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// A value that is gone through, `omega=200..400[1/s]:41`; once or twice.
    #[arg(long, value_name = "NAME=FROM..TO:COUNT")]
    pub over: Vec<String>,
    /// Number of runs with values made at random.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<2, MOST>, conflicts_with = "over")]
    #[arg(allow_hyphen_values = true)]
    pub samples: Option<u64>,
    /// Find all motions that attract over a range.
    #[arg(long, conflicts_with_all = ["samples", "sensitivity"])]
    pub attractors: bool,
    /// With --attractors, starts made at random at each value.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<0, 10_000>, requires = "attractors")]
    #[arg(default_value = "4", allow_hyphen_values = true)]
    pub starts: u64,
    /// Find the resonances over a range, and where motions grow.
    #[arg(long, conflicts_with_all = ["samples", "sensitivity", "attractors", "measure"])]
    pub resonances: bool,
    /// Find how measures change with every dimension and parameter.
    #[arg(long, conflicts_with_all = ["samples", "over", "plot"])]
    pub sensitivity: bool,
    /// A tolerance, `J2=10%` or `'J2=5e-5[kg m^2] lognormal'`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", requires = "samples")]
    pub tolerance: Vec<String>,
    /// Which values are made: the same seed gives the same ones.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<0, { u64::MAX }>)]
    #[arg(default_value = "1", allow_hyphen_values = true)]
    pub seed: u64,
    /// The measures, `F_largest,free`; all unless given.
    #[arg(long, value_name = "NAMES")]
    pub measure: Option<String>,
    /// Number of threads; as many as the machine has unless given.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<0, THREADS>)]
    #[arg(default_value = "0", allow_hyphen_values = true)]
    pub threads: u64,
    #[command(flatten)]
    pub accuracy: Accuracy,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
    /// File for the figure.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
}
