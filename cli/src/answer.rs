//! The way of every request: what is asked, the answer, and how it is shown.

use std::path::Path;

use clap::ValueEnum;
use serde::Serialize;

use crate::error::Failure;
use crate::show::output::{self, Destination};
use crate::show::page::Page;
use crate::show::{json, style};

/// How an answer is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Tables to read.
    #[default]
    Table,
    /// One JSON object; `assur schema` describes it.
    Json,
    /// Comma-separated values (RFC 4180): one heading with names and units, no comments.
    Csv,
}

/// What a command has found, to be shown in any format.
pub trait Answer {
    /// The figure; none where there is nothing to draw.
    fn figure(&self) -> Option<String> {
        None
    }

    /// Adds its tables to a page.
    fn table(&self, page: &mut Page, figure: Option<&Path>);

    /// Its rows as comma-separated values, each line ended.
    fn csv(&self) -> String;

    /// It as an object.
    fn json(&self, figure: Option<&Path>) -> impl Serialize;

    /// What is said when all is shown: why it is not the whole answer, if it is not.
    ///
    /// # Errors
    /// What is missing, or not to be trusted.
    fn outcome(&self) -> Result<(), Failure> {
        Ok(())
    }
}

/// Finds an answer and gives it: everything is computed first, then the figure is written, then the answer is printed.
///
/// # Errors
/// A wrong request or numbers that do not come out, nothing being written then; or an answer that is not whole, after all
/// else is printed.
pub fn give<A: Answer>(
    format: Format,
    figure: Option<&Path>,
    find: impl FnOnce() -> Result<A, Failure>,
) -> Result<(), Failure> {
    let destination = figure.map(Destination::figure).transpose()?;
    let answer = find()?;
    let mut drawn = None;
    if let Some(destination) = &destination
        && let Some(figure) = answer.figure()
    {
        destination.write(figure.as_bytes())?;
        drawn = Some(destination.path());
    }
    output::print(&match format {
        Format::Table => {
            let mut page = Page::new(style::stdout());
            answer.table(&mut page, drawn);
            page.text
        }
        Format::Json => json::render(&answer.json(drawn)),
        Format::Csv => answer.csv(),
    })?;
    answer.outcome()
}
