//! What is found of the scenes of a mechanism by running them, as `assur run` does.

use assur::answer::Settings;
use assur::registry::{Mechanism, SceneEntry};

use super::facts::Computed;
use crate::answer::Answer;
use crate::arguments::Rows;
use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::linkage::line::Grid;
use crate::plot::Selection;
use crate::published::{Comparison, Stated};
use crate::run::Shown;
use crate::{linkage, motion};

/// What is found of some scenes.
pub struct Found(Vec<(&'static str, Report)>);

/// What is found of a scene.
pub enum Report {
    Motion(Box<motion::report::Report>),
    Linkage(Box<linkage::report::Report>),
}

impl Found {
    /// Runs the scenes with published numbers, and one more.
    ///
    /// # Errors
    /// The first scene that does not come out.
    pub fn of(
        mechanism: &'static Mechanism,
        more: Option<&'static SceneEntry>,
    ) -> Result<Self, Failure> {
        let more = more.map(|scene| scene.name);
        let wanted = mechanism
            .scenes
            .iter()
            .filter(|scene| !scene.expectations.is_empty() || more == Some(scene.name));
        let run = |scene: &'static SceneEntry| {
            let report = Report::of(Constants::declared(mechanism, scene));
            let place = || format!("{}, scene {}", mechanism.name, scene.name);
            Ok((scene.name, report.map_err(|failure| failure.place(place()))?))
        };
        wanted.map(run).collect::<Result<_, _>>().map(Self)
    }

    /// The figure of a scene that was run.
    pub fn figure(&self, scene: &SceneEntry) -> Option<String> {
        match self.report(scene)? {
            Report::Motion(report) => report.figure(),
            Report::Linkage(report) => report.figure(),
        }
    }

    fn report(&self, scene: &SceneEntry) -> Option<&Report> {
        let mut reports = self.0.iter();
        reports.find(|(name, _)| *name == scene.name).map(|(_, report)| report)
    }
}

impl Report {
    fn of(constants: Constants) -> Result<Self, Failure> {
        let shown = || Shown { curves: Selection::Usual, rows: Rows::Positions };
        if constants.scene.linkage.is_some() {
            let case = linkage::case::Case::new(constants)?;
            let grid = Grid::fine(&case);
            let report = linkage::report::collect(case, &grid, Vec::new(), shown())?;
            return Ok(Self::Linkage(Box::new(report)));
        }
        let report = constants.going_on(|constants| {
            let case = motion::case::Case::new(constants)?;
            motion::report::collect(case, &Settings::default(), &[], shown())
        });
        Ok(Self::Motion(Box::new(report?)))
    }

    fn published(&self) -> &[Comparison] {
        match self {
            Self::Motion(report) => &report.published,
            Self::Linkage(report) => &report.published,
        }
    }
}

impl Computed for Found {
    fn text(&self, scene: &SceneEntry, stated: &Stated) -> Option<String> {
        let mut published = self.report(scene)?.published().iter();
        let is_it = |one: &&Comparison| {
            one.fact.line == stated.fact.line
                && one.name == stated.name
                && one.place == stated.place
        };
        let found = published.find(is_it)?;
        Some(super::facts::rounded(found.in_unit(found.computed), stated))
    }
}
