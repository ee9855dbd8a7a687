//! What can be asked of `assur tolerance`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::answer::Format;
use crate::ask::Asked;
use crate::ask::values::whole;

/// Examples, and what the formats contain.
pub const EXAMPLES: &str = "Examples:
  assur tolerance heald_linkage --at phi4=90deg --output phi7
  assur tolerance heald_linkage --scale 20 --kind second
  assur tolerance heald_linkage --kind monte-carlo --samples 1000000 --seed 7
  assur tolerance heald_linkage --play l5=0.02mm
  assur tolerance heald_linkage --allocate 1mrad --limit s=0.05mm..0.2mm

Without --at the whole range of the drivers is gone through, and the place with the greatest error is shown.

Kinds: worst (the sum of all largest errors), rss (standard deviations, root of the sum of squares),
second (the same with second derivatives, and all extremes with the loops closed again),
monte-carlo (linkages made at random; those that do not assemble are counted), all.

--allocate seeks the tolerances of least cost that keep the greatest error (with --kind rss the standard
deviation) within a band over the whole range. A tolerance t costs w*T/t, T being the one of the file and w
its weight, 1 unless --cost says otherwise: each of the file's tolerances costs its weight.

Csv has the bands and contributions over the range.";

/// Most places over the range.
const PLACES: u64 = 10_000;
/// Most linkages made at random.
const SAMPLES: u64 = 100_000_000_000;

/// Options of `assur tolerance`.
#[derive(Args, Debug, Default)]
pub struct ToleranceArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// Positions of drivers, `phi4=90deg`; may be repeated. The others stand where they start.
    #[arg(long, value_name = "NAME=VALUE")]
    pub at: Vec<String>,
    /// The output; the last one of the scene unless given.
    #[arg(long, value_name = "NAME")]
    pub output: Option<String>,
    /// Which bands.
    #[arg(long, value_enum, default_value_t = Kind::All)]
    pub kind: Kind,
    /// Number of linkages made at random.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<2, SAMPLES>)]
    #[arg(default_value = "100000", allow_hyphen_values = true)]
    pub samples: u64,
    /// Which of them: the same seed gives the same ones.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<0, { u64::MAX }>)]
    #[arg(default_value = "1", allow_hyphen_values = true)]
    pub seed: u64,
    /// Multiplies all tolerances.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_hyphen_values = true)]
    pub scale: f64,
    /// Another tolerance, `l5=0.02mm`, `'l5=0.1% uniform'`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub tolerance: Vec<String>,
    /// Radial play in a joint, as an error of a length, `l5=0.02mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub play: Vec<String>,
    /// Tolerances of least cost that keep the output within this band over the whole range.
    #[arg(long, value_name = "BAND", allow_hyphen_values = true)]
    pub allocate: Option<String>,
    /// Weight of a tolerance in the cost, `s=2`; may be repeated.
    #[arg(long, value_name = "NAME=WEIGHT", requires = "allocate")]
    pub cost: Vec<String>,
    /// Limits of a tolerance, `s=0.05mm..0.2mm`; may be repeated.
    #[arg(long, value_name = "NAME=LOW..HIGH", requires = "allocate")]
    pub limit: Vec<String>,
    /// Places over the range.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<2, PLACES>)]
    #[arg(default_value = "61", allow_hyphen_values = true)]
    pub places: u64,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
    /// File for a figure of the contributions over the range.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
}

/// How an error is reckoned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// The sum of all largest errors.
    Worst,
    /// The root of the sum of squares of standard deviations.
    Rss,
    /// To second order, and all extremes.
    Second,
    /// Linkages made at random.
    MonteCarlo,
    /// All of these.
    #[default]
    All,
}

impl Kind {
    /// Whether this kind is asked for.
    pub fn wants(self, kind: Kind) -> bool {
        self == kind || self == Kind::All
    }
}
