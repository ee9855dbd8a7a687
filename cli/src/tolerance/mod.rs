//! `assur tolerance`: how an output errs by the tolerances, what contributes most, and tolerances of least cost.

mod answer;
mod arguments;
mod csv;
mod json;
mod places;
mod question;
mod table;

pub use answer::Unit;
pub use arguments::{EXAMPLES, ToleranceArguments};
pub use json::Tolerance as Object;
pub use places::range;
pub use question::Names;

use std::path::Path;

use serde::Serialize;

use crate::answer::{Answer, give};
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::plot;
use crate::show::page::Page;
use question::Question;

/// Finds how an output errs.
///
/// # Errors
/// A wrong request, or a linkage that does not get to a place. Nothing is written then.
pub fn execute(options: &ToleranceArguments, registry: Registry) -> Result<(), Failure> {
    give(options.format, options.plot.as_deref(), || {
        let question = Question::read(options, registry)?;
        Ok(Tolerance { answer: answer::find(&question)?, question })
    })
}

/// A question with its answer.
struct Tolerance {
    question: Question,
    answer: answer::Answer,
}

impl Answer for Tolerance {
    fn figure(&self) -> Option<String> {
        Some(plot::contributions(&self.answer.chart(&self.question)))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        table::render(page, &self.question, &self.answer, figure);
    }

    fn csv(&self) -> String {
        csv::render(&self.question, &self.answer)
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        Object::of(&self.question, &self.answer, figure)
    }
}
