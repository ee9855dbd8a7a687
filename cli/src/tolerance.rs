//! `assur tolerance`: how an output errs by the tolerances, what contributes most, and tolerances of least cost.

mod answer;
mod arguments;
mod csv;
mod json;
mod places;
mod question;
mod table;

pub use arguments::{EXAMPLES, ToleranceArguments};

use crate::arguments::Format;
use crate::error::Failure;
use crate::lookup::Registry;
use crate::output::{self, Destination};
use crate::{plot, style};
use question::Question;

/// Answers everything first; then the figure is written, then the answer is printed.
///
/// # Errors
/// A wrong request, or a linkage that does not get to a place. Nothing is written then.
pub fn execute(options: &ToleranceArguments, registry: Registry) -> Result<(), Failure> {
    let question = Question::read(options, registry)?;
    let figure = match &options.plot {
        Some(path) => Some(Destination::figure(path)?),
        None => None,
    };
    let answer = answer::find(&question)?;
    if let Some(destination) = &figure {
        let drawn = plot::contributions(&answer.chart(&question));
        destination.write(drawn.as_bytes())?;
    }
    let path = figure.as_ref().map(Destination::path);
    output::print(&match options.format {
        Format::Table => table::render(&question, &answer, path, style::stdout()),
        Format::Json => json::render(&question, &answer, path),
        Format::Csv => csv::render(&question, &answer),
    })
}
