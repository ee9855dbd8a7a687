//! `assur study`: the measures of many runs, over a grid of values or with values made at random; what attracts over a range,
//! and its resonances; how measures change with each value.

mod answer;
mod arguments;
mod attractors;
mod csv;
mod figure;
mod json;
mod question;
mod resonances;
mod sensitivity;
mod table;
mod tolerance;

pub use arguments::{EXAMPLES, StudyArguments};
#[cfg(test)]
pub use attractors::Object as AttractorsObject;
pub use json::Study as Object;
#[cfg(test)]
pub use resonances::Object as ResonancesObject;
#[cfg(test)]
pub use sensitivity::Object as SensitivityObject;

use std::path::Path;

use serde::Serialize;

use crate::answer::{Answer, give};
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::page::Page;
use attractors::Attractors;
use question::Question;
use resonances::Resonances;
use sensitivity::Sensitivity;

/// Studies a scene.
///
/// # Errors
/// A wrong request, or a study of which no run comes out. Nothing is written then.
pub fn execute(options: &StudyArguments, registry: Registry) -> Result<(), Failure> {
    let (format, plot) = (options.format, options.plot.as_deref());
    let question = || Question::read(options, registry);
    if options.sensitivity {
        return give(format, None, || Sensitivity::find(question()?));
    }
    if options.attractors {
        let (starts, seed) = (options.starts as usize, options.seed);
        return give(format, plot, || Attractors::find(question()?, starts, seed));
    }
    if options.resonances {
        return give(format, plot, || Resonances::find(question()?));
    }
    give(format, plot, || {
        let question = question()?;
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
