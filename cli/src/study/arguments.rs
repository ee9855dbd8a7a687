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
  assur study table_drive --samples 1000 --tolerance J2=10% --tolerance c=20% --seed 7

--over runs through values from one end to the other, so many of them: one for curves, two for a map.
--samples makes values at random: those with a tolerance in the file, and those that --tolerance gives one, distributed as
the file says (normally, the tolerance being three standard deviations) unless a distribution stands behind it.

Csv has one row a run.";

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
