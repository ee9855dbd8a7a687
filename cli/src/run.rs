//! `assur run`: a scene with its values, its results and its figure.

use std::path::{Path, PathBuf};

use assur::problem::Span;
use assur::registry::{Mechanism, SceneEntry};

use crate::arguments::{Format, Rows, RunArguments};
use crate::asked::For;
use crate::case::Case;
use crate::error::Failure;
use crate::lookup::Registry;
use crate::output::{self, Destination};
use crate::plot::Selection;
use crate::progress::Progress;
use crate::report::{self, Report};
use crate::{csv, events, json, linkage, plot, style, table, values};

/// Runs a scene. Everything is computed first; then the figure is written, then the answer is printed.
///
/// # Errors
/// A wrong request, or numbers that do not come out, nothing being written then; or a motion that is not accurate, after all
/// else is printed.
pub fn execute(options: &RunArguments, registry: Registry) -> Result<(), Failure> {
    let (mechanism, constants) = options.asked.find(registry, "run", For::All)?;
    let scene = constants.scene;
    check_rows(options, scene)?;
    if scene.linkage.is_some() {
        return linkage::run::execute(options, mechanism, constants);
    }
    let places =
        options.at.iter().map(|text| values::place(scene, text)).collect::<Result<Vec<_>, _>>()?;
    let settings = options.accuracy.settings(scene)?;
    let curves = Selection::read(scene, options.curves.as_deref())?;
    let figure = match figure_path(options, mechanism, scene) {
        Some(path) => Some(Destination::figure(&path)?),
        None => None,
    };
    let case = Case::new(constants)?;
    if case.task == Span::Open && places.is_empty() {
        return Err(Failure::request(format!("scene `{}` has no task of its own", scene.name))
            .remedy(format!(
                "say where to look: --at {}=…",
                scene.drivers.first().map_or("time", |driver| driver.name)
            )));
    }
    let progress = Progress::start(format!("{}, scene {}", mechanism.name, scene.name), 0);
    let report = report::collect(mechanism, case, settings, &places)?;
    drop(progress);
    let drawn = match figure.filter(|_| !report.curves.times.is_empty()) {
        Some(destination) => {
            destination.write(plot::draw(&report, &curves).as_bytes())?;
            Some(destination)
        }
        None => None,
    };
    output::print(&render(&report, options, drawn.as_ref().map(Destination::path)))?;
    report.outcome()
}

/// Rows of limits are rows of a linkage, rows of events those of a scene that states some.
fn check_rows(options: &RunArguments, scene: &SceneEntry) -> Result<(), Failure> {
    let (name, lack) = match options.rows {
        Rows::Positions => return Ok(()),
        Rows::Limits if scene.linkage.is_none() => {
            ("limits", Some("only a linkage has rows of limits".to_owned()))
        }
        Rows::Events if !events::are_stated(scene) => {
            ("events", Some(format!("scene `{}` states no events", scene.name)))
        }
        Rows::Limits => ("limits", None),
        Rows::Events => ("events", None),
    };
    let refused = |what: &str| Failure::request(what).place(format!("--rows {name}"));
    match (lack, options.format) {
        (Some(lack), _) => Err(refused(&lack).remedy("leave it out")),
        (None, Format::Csv) => Ok(()),
        (None, _) => Err(refused("only --format csv has rows")
            .remedy(format!("add --format csv; the tables and json show the {name} anyway"))),
    }
}

fn render(report: &Report, options: &RunArguments, figure: Option<&Path>) -> String {
    match (options.format, options.rows) {
        (Format::Table, _) => table::render(report, figure, style::stdout()),
        (Format::Json, _) => json::render(report, figure),
        (Format::Csv, Rows::Events) => csv::events(report),
        (Format::Csv, _) => csv::render(report),
    }
}

/// Where the figure goes: a table has one unless told otherwise, the formats for programs only when it is asked for.
pub fn figure_path(
    options: &RunArguments,
    mechanism: &Mechanism,
    scene: &SceneEntry,
) -> Option<PathBuf> {
    let name = format!("{}-{}.svg", mechanism.name, scene.name);
    match (&options.plot, &options.out) {
        (Some(file), _) => Some(file.clone()),
        (None, Some(directory)) => Some(directory.join(name)),
        (None, None) => (options.format == Format::Table).then(|| PathBuf::from(name)),
    }
}
