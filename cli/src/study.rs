//! `assur study`: the measures of many runs, over a grid of values or with values made at random.

mod answer;
mod arguments;
mod csv;
mod figure;
mod json;
mod question;
mod range;
mod table;
mod tolerance;

pub use arguments::{EXAMPLES, StudyArguments};

use crate::arguments::Format;
use crate::error::Failure;
use crate::lookup::Registry;
use crate::output::{self, Destination};
use crate::style;
use question::Question;

/// Answers everything first; then the figure is written, then the answer is printed.
///
/// # Errors
/// A wrong request, or a study of which no run comes out. Nothing is written then.
pub fn execute(options: &StudyArguments, registry: Registry) -> Result<(), Failure> {
    let question = Question::read(options, registry)?;
    let figure = match &options.plot {
        Some(path) => Some(Destination::figure(path)?),
        None => None,
    };
    let answer = answer::find(&question)?;
    if let Some(destination) = &figure {
        destination.write(figure::draw(&question, &answer).as_bytes())?;
    }
    let path = figure.as_ref().map(Destination::path);
    output::print(&match options.format {
        Format::Table => table::render(&question, &answer, path, style::stdout()),
        Format::Json => json::render(&question, &answer, path),
        Format::Csv => csv::render(&question, &answer),
    })
}
