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
pub use json::Study as Object;

use std::path::Path;

use serde::Serialize;

use crate::answer::{Answer, give};
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::page::Page;
use question::Question;

/// Studies a scene.
///
/// # Errors
/// A wrong request, or a study of which no run comes out. Nothing is written then.
pub fn execute(options: &StudyArguments, registry: Registry) -> Result<(), Failure> {
    give(options.format, options.plot.as_deref(), || {
        let question = Question::read(options, registry)?;
        Ok(Study { answer: answer::find(&question)?, question })
    })
}

/// A question with its answer.
struct Study {
    question: Question,
    answer: answer::Answer,
}

impl Answer for Study {
    fn figure(&self) -> Option<String> {
        Some(figure::draw(&self.question, &self.answer))
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
