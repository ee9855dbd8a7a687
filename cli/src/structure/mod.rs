//! `assur structure`: the loops of a linkage, or of a motion that they reduce, and the order in which they are solved.

mod csv;
mod json;
mod table;

use std::path::Path;

use assur::closure::{ClosureError, Group, Range, Sample};
use assur::shape::{EquationText, LinkageEntry, Loop, Quantity};
use serde::Serialize;

use crate::answer::{Answer, give};
use crate::arguments::StructureArguments;
use crate::ask::For;
use crate::ask::constants::Constants;
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::linkage::group;
use crate::motion;
use crate::show::page::Page;
pub use json::Structure as Object;

/// Gives the structure of a linkage, or of a motion with loops.
///
/// # Errors
/// A wrong request; or a linkage that cannot be put together, after its structure is printed.
pub fn execute(options: &StructureArguments, registry: Registry) -> Result<(), Failure> {
    give(options.format, None, || {
        let constants = options.asked.find(registry, "structure", For::Loops)?;
        match (constants.scene.augmented, constants.scene.reduced) {
            (Some(held), _) => {
                let entry = LinkageEntry { loops: held.loops, ..LinkageEntry::NONE };
                Structure::of_motion(constants, entry)
            }
            (None, Some(entry)) => Structure::of_motion(constants, entry),
            (None, None) => Structure::of_linkage(constants),
        }
    })
}

/// The structure of a linkage, or of a motion with loops.
pub struct Structure {
    /// The scene with its values.
    pub constants: Constants,
    /// The loops.
    pub entry: LinkageEntry,
    /// The drivers, in the units in which they are shown.
    pub drivers: Vec<Quantity>,
    /// Where each driver of a linkage moves.
    pub ranges: Vec<Range>,
    /// The independent coordinates of a motion, and where each starts, SI units.
    pub coordinates: Vec<(Quantity, f64)>,
    /// The coordinates of a motion that closures hold without being solved for, and where each starts, SI units.
    pub held: Vec<(Quantity, f64)>,
    /// How many scalar closures are independent; all where they are solved for.
    pub independent: usize,
    /// The closures that follow from others.
    pub redundant: Vec<&'static str>,
    /// A linkage where it starts, and the groups whose assembly mode had to be assumed; nothing for a motion.
    start: Option<(Sample, Vec<usize>)>,
    /// Where the linkage starts, in words; empty for a motion.
    pub place: String,
    /// Why the linkage cannot be put together.
    wrong: Option<Failure>,
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
        self.wrong.clone().map_or(Ok(()), Err)
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
    fn of_linkage(constants: Constants) -> Result<Self, Failure> {
        let case = Case::new(constants)?;
        let (start, wrong) = match start(&case) {
            Ok(start) => (Some(start), None),
            Err(error) => {
                (None, Some(case.tell(&error).failure("the linkage cannot be put together")))
            }
        };
        let place =
            start.as_ref().map_or_else(String::new, |(sample, _)| case.label(&sample.independents));
        Ok(Self {
            entry: *case.moved.entry,
            drivers: case.drivers,
            ranges: case.moved.ranges,
            constants: case.constants,
            coordinates: Vec::new(),
            held: Vec::new(),
            independent: case.moved.entry.loops.len(),
            redundant: Vec::new(),
            start,
            place,
            wrong,
        })
    }

    fn of_motion(constants: Constants, entry: LinkageEntry) -> Result<Self, Failure> {
        let case = motion::case::Case::new(constants)?;
        let start = case.run().start();
        let second_order = |index: &usize| {
            let rate = format!("dot({})", case.scene.states[*index].name);
            case.scene.states.iter().any(|state| state.name == rate)
        };
        let coordinates = (0..case.scene.states.len()).filter(second_order);
        let held = case.scene.augmented;
        let is_free = |index: &usize| held.is_none_or(|held| held.kept.contains(index));
        let (free, bound): (Vec<usize>, Vec<usize>) = coordinates.partition(is_free);
        let begun = |index: usize| (case.scene.states[index], start[index]);
        let redundant = held.map_or(&[][..], |held| held.redundant);
        Ok(Self {
            coordinates: free.into_iter().map(begun).collect(),
            held: bound.into_iter().map(begun).collect(),
            independent: held.map_or(entry.loops.len(), |held| held.rank),
            redundant: redundant.iter().map(|index| entry.loops[*index].name).collect(),
            entry,
            drivers: case.drivers,
            ranges: Vec::new(),
            constants: case.constants,
            start: None,
            place: String::new(),
            wrong: None,
        })
    }

    /// Whether it is put together, as far as is asked.
    pub fn is_whole(&self) -> bool {
        self.wrong.is_none()
    }

    /// The linkage where it starts, if it gets there.
    pub fn sample(&self) -> Option<&Sample> {
        self.start.as_ref().map(|(sample, _)| sample)
    }

    /// What is known of a group where the linkage starts.
    pub fn found(&self, index: usize, of_group: &Group) -> Found {
        let mode = self.sample().filter(|_| of_group.kind.has_modes());
        let sine = self.sample().filter(|_| group::transmits(of_group));
        Found {
            mode: mode.map(|sample| sample.modes[index]),
            angle: sine.map(|sample| group::transmission(sample.sines[index])),
            assumed: self.start.as_ref().is_some_and(|(_, assumed)| assumed.contains(&index)),
        }
    }

    /// Numbers of scalar loop equations, unknowns and drivers.
    pub fn counts(&self) -> (usize, usize, usize) {
        let entry = &self.entry;
        (entry.loops.len(), entry.dependents.len(), self.drivers.len())
    }

    /// The equation of the file that each loop belongs to: a vector equation is several loops.
    pub fn texts(&self) -> Vec<Option<&'static EquationText>> {
        let equations = self.constants.scene.equations;
        let text = |one: &Loop| {
            let mut closures = equations.iter().filter(|text| text.text.starts_with("closure"));
            closures.find(|text| text.line == one.line)
        };
        self.entry.loops.iter().map(text).collect()
    }
}
