//! `assur run`: a scene with its values, its results and its figure.

use std::path::PathBuf;

use assur::problem::Span;
use assur::registry::SceneEntry;
use serde::Serialize;

use crate::answer::{Format, give};
use crate::arguments::{Rows, RunArguments};
use crate::ask::constants::Constants;
use crate::ask::lookup::Registry;
use crate::ask::place::Place;
use crate::ask::{For, file};
use crate::error::Failure;
use crate::linkage::line::Grid;
use crate::linkage::{self, json::Linkage};
use crate::motion::{self, events, json::Motion};
use crate::plot::Selection;
use crate::show::json::{About, Published};
use crate::show::progress::Progress;
use crate::watch;

/// Most places along each value that is swept.
const PLACES: usize = 1000;

/// The answer of `assur run` as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Run {
    /// `assur-run/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    #[serde(flatten)]
    found: Found,
    published: Vec<Published>,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// What is found of a scene.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Found {
    Motion(Box<Motion>),
    Linkage(Box<Linkage>),
}

/// What is wanted of an answer.
pub struct Shown {
    /// The curves of the figure.
    pub curves: Selection,
    /// What the rows of comma-separated values are.
    pub rows: Rows,
}

impl Run {
    /// All of it.
    pub fn new(
        about: About,
        found: Found,
        published: Vec<Published>,
        figure: Option<String>,
    ) -> Self {
        Self { format: "assur-run/1", about, found, published, figure }
    }
}

/// Runs a scene.
///
/// # Errors
/// A wrong request, or numbers that do not come out, nothing being written then; or an answer that is not whole or not
/// accurate, after all else is printed.
pub fn execute(options: &RunArguments, registry: Registry) -> Result<(), Failure> {
    match options.watch {
        true => watch::execute(options.asked.name.as_deref(), || once(options, registry)),
        false => once(options, registry),
    }
}

fn once(options: &RunArguments, registry: Registry) -> Result<(), Failure> {
    let constants = options.asked.find(registry, "run", For::All)?;
    let scene = constants.scene;
    check_rows(options, scene)?;
    let curves = Selection::read(scene, options.curves.as_deref())?;
    let shown = Shown { curves, rows: options.rows };
    let figure = figure_path(options, &constants);
    let figure = figure.as_deref();
    match scene.linkage {
        Some(_) => give(options.format, figure, || of_linkage(options, constants, shown)),
        None => give(options.format, figure, || of_motion(options, constants, shown)),
    }
}

/// A motion; with all positions as coordinates where it comes to a dead point otherwise.
fn of_motion(
    options: &RunArguments,
    constants: Constants,
    shown: Shown,
) -> Result<motion::report::Report, Failure> {
    let Some(unreduced) = constants.scene.unreduced else {
        return followed(options, constants, shown);
    };
    let curves = Selection::read(unreduced, options.curves.as_deref())?;
    let again = Shown { curves, rows: options.rows };
    followed(options, constants.clone(), shown).or_else(|failure| {
        if !failure.is_lost() {
            return Err(failure);
        }
        let why = failure.why().unwrap_or_default();
        eprintln!("note: {why}; from its start on the motion is followed with all positions as coordinates");
        followed(options, constants.in_scene(unreduced), again)
    })
}

fn followed(
    options: &RunArguments,
    constants: Constants,
    shown: Shown,
) -> Result<motion::report::Report, Failure> {
    if let Some(numbers) = &options.places {
        return Err(Failure::request("a motion takes no --places")
            .place(format!("--places {numbers}"))
            .reason("its steps are chosen by its tolerances; places are those of what is swept")
            .remedy("leave it out"));
    }
    let settings = options.accuracy.settings(constants.scene)?;
    let mut case = motion::case::Case::new(constants)?;
    case.add_energies(&shown.curves)?;
    if case.moved.task == Span::Rest {
        check_resting(options)?;
    }
    let places = options.at.iter().map(|text| Place::read(&case, text, true));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    if case.moved.task == Span::Open && places.is_empty() {
        return Err(nowhere(case.scene, "task of its own", "time"));
    }
    let _progress = progress(&case.constants);
    motion::report::collect(case, &settings, &places, shown)
}

/// What a position of rest has no use for.
fn check_resting(options: &RunArguments) -> Result<(), Failure> {
    let at = options.at.first().map(|text| ("--at", text.clone()));
    let Some((option, text)) = options.accuracy.given().next().or(at) else {
        return Ok(());
    };
    Err(Failure::request(format!("a position of rest takes no {option}"))
        .place(format!("{option} {text}"))
        .reason("it is one place, found to rounding; nothing is integrated")
        .remedy("leave it out"))
}

fn of_linkage(
    options: &RunArguments,
    constants: Constants,
    shown: Shown,
) -> Result<linkage::report::Report, Failure> {
    options.accuracy.none_for_linkages()?;
    let case = linkage::case::Case::new(constants)?;
    let places = options.at.iter().map(|text| linkage::place::read(&case, text));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    if case.moved.task == linkage::case::Task::Open && places.is_empty() {
        return Err(nowhere(case.scene, "range to go over", "…"));
    }
    let grid = match &options.places {
        Some(numbers) => Grid::even(&case, numbers, PLACES)?,
        None => Grid::fine(&case),
    };
    let _progress = progress(&case.constants);
    linkage::report::collect(case, &grid, places, shown)
}

fn progress(constants: &Constants) -> Progress {
    let name = constants.mechanism.name;
    Progress::start(format!("{name}, scene {}", constants.scene.name), 0)
}

/// That a scene does nothing unless it is said where to look.
fn nowhere(scene: &SceneEntry, lacks: &str, instead: &str) -> Failure {
    let driver = scene.drivers.first().map_or(instead, |driver| driver.name);
    Failure::request(format!("scene `{}` has no {lacks}", scene.name))
        .remedy(format!("say where to look: --at {driver}=…"))
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

/// Where the figure goes: a table has one unless told otherwise, the formats for programs only when it is asked for.
fn figure_path(options: &RunArguments, constants: &Constants) -> Option<PathBuf> {
    let name = format!("{}-{}.svg", file::stem(constants.mechanism), constants.scene.name);
    match (&options.plot, &options.out) {
        (Some(file), _) => Some(file.clone()),
        (None, Some(directory)) => Some(directory.join(name)),
        (None, None) => (options.format == Format::Table).then(|| PathBuf::from(name)),
    }
}
