//! What can be asked of `assur cost`.

use std::path::PathBuf;

use assur::answer::Method;
use clap::Args;

use crate::answer::Format;
use crate::ask::Asked;

/// Examples, and what the numbers mean.
pub const EXAMPLES: &str = "Examples:
  assur cost batten
  assur cost batten --for 'F2=0.1N' --plot cost.svg
  assur cost presser_foot --of F,F_largest --method dop853,taylor,auto
  assur cost my.eqn --scene run --rtol 1e-9..1e-3 --for 1um
  assur cost heald_linkage --for 1%

The task of the scene is solved by each method at each tolerance, several times in turns. Errors are differences from a
reference at the limit of double precision, by how much that is not known itself being told; of what moves, the largest over the
task. Rows with a star are better than all that is cheaper.

--for asks what is cheapest for an accuracy: of one quantity, of all of a unit, or of all in per cent of their size.";

/// Options of `assur cost`.
#[derive(Args, Debug)]
pub struct CostArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// What is looked at, `F2,peak_rod1`: outputs, states, measures; unless given all outputs and measures. Of a linkage one
    /// output, unless given the first.
    #[arg(long, value_name = "NAMES")]
    pub of: Option<String>,
    /// An accuracy, `'F2=0.1N'`, `1um` or `1%`: which way to get it is cheapest.
    #[arg(long = "for", value_name = "ACCURACY")]
    pub wanted: Option<String>,
    /// The methods; all unless given.
    #[arg(long, value_name = "METHODS", value_delimiter = ',', value_parser = method)]
    pub method: Vec<Method>,
    /// Relative tolerances, from the smallest to the largest, in powers of ten.
    #[arg(long, value_name = "FROM..TO", value_parser = tolerances, default_value = "1e-13..1e-3")]
    pub rtol: (f64, f64),
    /// Seconds that measuring times may take.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "4")]
    #[arg(allow_hyphen_values = true)]
    pub seconds: f64,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
    /// File for the figure.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
}

fn method(text: &str) -> Result<Method, String> {
    text.trim().parse().map_err(|unknown| format!("{unknown}"))
}

fn tolerances(text: &str) -> Result<(f64, f64), String> {
    let ends = text.split_once("..").and_then(|(from, to)| {
        Some((from.trim().parse::<f64>().ok()?, to.trim().parse::<f64>().ok()?))
    });
    match ends.filter(|(from, to)| *from > 0.0 && *to > 0.0 && from.max(*to) < 1.0) {
        Some(ends) => Ok(ends),
        None => Err("give two numbers between 0 and 1: 1e-12..1e-4".to_owned()),
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    let read = text.parse::<f64>().ok().filter(|value| (0.0..=3600.0).contains(value));
    read.ok_or_else(|| "give a number from 0 to 3600".to_owned())
}
