//! The structure of a linkage as an object.

use serde::Serialize;

use crate::linkage::group;
use crate::linkage::json::Driver;
use crate::show::json::{About, Number, number};
use crate::show::unit;

/// The answer of `assur structure` as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Structure {
    /// `assur-structure/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    degrees_of_freedom: usize,
    counts: Counts,
    loops: Vec<Loop>,
    unknowns: Vec<Unknown>,
    /// They start where the linkage is put together; null if it cannot be.
    drivers: Vec<Driver>,
    /// The coordinates that a motion with loops is reduced to; empty for a linkage.
    independent: Vec<Coordinate>,
    /// The coordinates that closures hold without being solved for: those whose start follows from the independent ones.
    held: Vec<Coordinate>,
    /// Scalar closures whose forces others depend on, as friction does: they are found together.
    felt: &'static [&'static str],
    /// Loops that follow from others.
    redundant: Vec<&'static str>,
    /// In the order of solution.
    groups: Vec<Group>,
    status: Status,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Counts {
    equations: usize,
    unknowns: usize,
    drivers: usize,
}

/// A scalar loop equation.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Loop {
    name: &'static str,
    unit: &'static str,
    /// Line of the equation file.
    line: usize,
    /// The equation of the file that it belongs to.
    equation: Option<&'static str>,
}

/// A dependent coordinate.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Unknown {
    name: &'static str,
    unit: &'static str,
    start: Number,
}

/// An independent coordinate.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Coordinate {
    name: &'static str,
    unit: &'static str,
    start: Number,
}

impl Coordinate {
    fn of((quantity, start): &(assur::shape::Quantity, f64)) -> Self {
        Self {
            name: quantity.name,
            unit: quantity.unit,
            start: number(unit::stated(*start, quantity.factor)),
        }
    }
}

/// Loops that are solved together.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Group {
    loops: Vec<&'static str>,
    unknowns: Vec<&'static str>,
    kind: &'static str,
    /// What its links are, in words.
    links: &'static str,
    /// How it is solved, in words.
    solved: &'static str,
    /// +1 or -1 where the linkage starts; null if it has one only.
    assembly_mode: Number,
    /// Whether no start value picks the mode.
    assumed: bool,
    transmission_angle: Number,
    transmission_unit: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
enum Status {
    #[serde(rename = "complete")]
    Complete,
    /// It cannot be put together; the exit code is 1.
    #[serde(rename = "not assembled")]
    NotAssembled,
}

impl Structure {
    /// The object.
    pub fn of(structure: &super::Structure) -> Self {
        let sample = structure.sample();
        let entry = &structure.entry;
        let (equations, unknowns, drivers) = structure.counts();
        let loops = entry.loops.iter().zip(structure.texts()).map(|(one, text)| Loop {
            name: one.name,
            unit: one.unit,
            line: one.line as usize,
            equation: text.map(|text| text.text),
        });
        let dependents = entry.dependents.iter().enumerate().map(|(index, dependent)| Unknown {
            name: dependent.name,
            unit: dependent.unit,
            start: sample
                .and_then(|one| number(unit::stated(one.dependents[index], dependent.factor))),
        });
        let starts = (0..drivers).map(|index| sample.map(|sample| sample.independents[index]));
        let groups = entry.groups.iter().enumerate();
        Self {
            format: "assur-structure/1",
            about: About::of(&structure.constants),
            degrees_of_freedom: drivers + structure.coordinates.len(),
            counts: Counts { equations, unknowns, drivers },
            loops: loops.collect(),
            unknowns: dependents.collect(),
            drivers: Driver::starting((&structure.drivers, &structure.ranges), starts),
            independent: structure.coordinates.iter().map(Coordinate::of).collect(),
            held: structure.held.iter().map(Coordinate::of).collect(),
            felt: structure.constants.scene.felt,
            redundant: structure.redundant.clone(),
            groups: groups.map(|(index, one)| Group::of(structure, index, one)).collect(),
            status: match structure.is_whole() {
                true => Status::Complete,
                false => Status::NotAssembled,
            },
        }
    }
}

impl Group {
    fn of(structure: &super::Structure, index: usize, of_group: &assur::closure::Group) -> Self {
        let entry = &structure.entry;
        let found = structure.found(index, of_group);
        Self {
            loops: of_group.equations.iter().map(|&one| entry.loops[one].name).collect(),
            unknowns: of_group.unknowns.iter().map(|&one| entry.dependents[one].name).collect(),
            kind: group::kind(of_group.kind),
            links: group::links(of_group.kind),
            solved: group::solved(of_group.kind),
            assembly_mode: found.mode.and_then(number),
            assumed: found.assumed,
            transmission_angle: found.angle.and_then(number),
            transmission_unit: "deg",
        }
    }
}
