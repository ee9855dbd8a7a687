//! `assur run` for a linkage.

use std::path::Path;

use assur::registry::Mechanism;

use super::case::{Case, Task};
use super::report::{self, Report};
use super::{csv, json, place, table};
use crate::arguments::{Format, Rows, RunArguments};
use crate::constants::Constants;
use crate::error::Failure;
use crate::output::{self, Destination};
use crate::plot::{self, Selection};
use crate::progress::Progress;
use crate::run::figure_path;
use crate::style;

/// Moves a linkage through its task. Everything is computed first; then the figure is written, then the answer is
/// printed.
///
/// # Errors
/// A wrong request, nothing being written then; or a linkage that does not get everywhere, after all else is printed.
pub fn execute(
    options: &RunArguments,
    mechanism: &'static Mechanism,
    constants: Constants,
) -> Result<(), Failure> {
    let scene = constants.scene;
    without_integration(options)?;
    let curves = Selection::read(scene, options.curves.as_deref())?;
    let figure = match figure_path(options, mechanism, scene) {
        Some(path) => Some(Destination::figure(&path)?),
        None => None,
    };
    let case = Case::new(constants)?;
    let places = options.at.iter().map(|text| place::read(&case, text));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    if case.task == Task::Open && places.is_empty() {
        let driver = scene.drivers.first().map_or("…", |driver| driver.name);
        return Err(Failure::request(format!("scene `{}` has no range to go over", scene.name))
            .remedy(format!("say where to look: --at {driver}=…")));
    }
    let progress = Progress::start(format!("{}, scene {}", mechanism.name, scene.name), 0);
    let report = report::collect(mechanism, case, places)?;
    drop(progress);
    let drawn = match figure.filter(|_| !report.lines.is_empty()) {
        Some(destination) => {
            destination.write(plot::draw_linkage(&report, &curves).as_bytes())?;
            Some(destination)
        }
        None => None,
    };
    output::print(&render(&report, options, drawn.as_ref().map(Destination::path)))?;
    report.outcome()
}

fn render(report: &Report, options: &RunArguments, figure: Option<&Path>) -> String {
    match (options.format, options.rows) {
        (Format::Table, _) => table::render(report, figure, style::stdout()),
        (Format::Json, _) => json::render(report, figure),
        (Format::Csv, Rows::Limits) => csv::limits(report),
        (Format::Csv, _) => csv::render(report),
    }
}

/// Loops are closed to the last digit, and nothing is integrated.
fn without_integration(options: &RunArguments) -> Result<(), Failure> {
    match options.accuracy.given().next() {
        Some((option, text)) => Err(Failure::request(format!("a linkage takes no {option}"))
            .place(format!("{option} {text}"))
            .reason("its loops are closed to rounding; nothing is integrated")
            .remedy("leave it out")),
        None => Ok(()),
    }
}
