//! `assur structure`: the loops of a linkage, and the order in which they are solved.

mod csv;
mod json;
mod table;

use std::path::Path;

use assur::closure::{ClosureError, Group, Sample};
use assur::shape::EquationText;
use serde::Serialize;

use crate::answer::{Answer, give};
use crate::arguments::StructureArguments;
use crate::ask::For;
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::linkage::group;
use crate::show::page::Page;
pub use json::Structure as Object;

/// Gives the structure of a linkage.
///
/// # Errors
/// A wrong request; or a linkage that cannot be put together, after its structure is printed.
pub fn execute(options: &StructureArguments, registry: Registry) -> Result<(), Failure> {
    give(options.format, None, || {
        let case = Case::new(options.asked.find(registry, "structure", For::Linkages)?)?;
        Ok(Structure { start: start(&case), case })
    })
}

/// The structure of a linkage.
pub struct Structure {
    /// The linkage with its values.
    pub case: Case,
    /// The linkage where it starts, and the groups whose assembly mode had to be assumed.
    pub start: Result<(Sample, Vec<usize>), ClosureError>,
}

impl Answer for Structure {
    fn table(&self, page: &mut Page, _: Option<&Path>) {
        table::render(page, self);
    }

    fn csv(&self) -> String {
        csv::render(self)
    }

    fn json(&self, _: Option<&Path>) -> impl Serialize {
        Object::of(self)
    }

    fn outcome(&self) -> Result<(), Failure> {
        let apart = |error: &ClosureError| {
            self.case.tell(error).failure("the linkage cannot be put together")
        };
        self.start.as_ref().map(|_| ()).map_err(apart)
    }
}

fn start(case: &Case) -> Result<(Sample, Vec<usize>), ClosureError> {
    let standing = case.standing();
    let known = standing.iter().all(|position| position.is_finite());
    let place = match case.axes().first() {
        Some(axis) if !known => case.place(&[axis.from]),
        _ => standing,
    };
    let path = case.run().follow(&[place])?;
    match (path.samples.into_iter().next(), path.stopped) {
        (Some(sample), _) => Ok((sample, path.start.assumed)),
        (None, Some(error)) => Err(error),
        (None, None) => {
            Err(ClosureError::BadRange { reason: "there is no position to start at".to_owned() })
        }
    }
}

/// What is known of a group where the linkage starts.
pub struct Found {
    /// Its assembly mode, if it has several.
    pub mode: Option<f64>,
    /// Its transmission angle in degrees, if it has one.
    pub angle: Option<f64>,
    /// Whether no start value picks the mode.
    pub assumed: bool,
}

impl Structure {
    /// The linkage where it starts, if it gets there.
    pub fn sample(&self) -> Option<&Sample> {
        self.start.as_ref().ok().map(|(sample, _)| sample)
    }

    /// What is known of a group where the linkage starts.
    pub fn found(&self, index: usize, of_group: &Group) -> Found {
        let mode = self.sample().filter(|_| of_group.kind.has_modes());
        let sine = self.sample().filter(|_| group::transmits(of_group));
        Found {
            mode: mode.map(|sample| sample.modes[index]),
            angle: sine.map(|sample| group::transmission(sample.sines[index])),
            assumed: self.start.as_ref().is_ok_and(|(_, assumed)| assumed.contains(&index)),
        }
    }

    /// Numbers of scalar loop equations, unknowns and drivers.
    pub fn counts(&self) -> (usize, usize, usize) {
        let entry = self.case.moved.entry;
        (entry.loops.len(), entry.dependents.len(), self.case.drivers.len())
    }

    /// The equation of the file that each loop belongs to: a vector equation is several loops.
    pub fn texts(&self) -> Vec<Option<&'static EquationText>> {
        let base = |name: &'static str| {
            let component = [".x", ".y", ".z"].into_iter().find_map(|end| name.strip_suffix(end));
            component.unwrap_or(name)
        };
        let mut next = 0;
        let mut last = None;
        let loops = self.case.moved.entry.loops.iter().map(|one| {
            if last != Some((base(one.name), one.line)) {
                last = Some((base(one.name), one.line));
                next += 1;
            }
            self.case.scene.equations.get(next - 1)
        });
        loops.collect()
    }
}
