//! The modes as an object.

use assur::closure::{Group, Listed};
use serde::Serialize;

use super::{Found, sign};
use crate::linkage::group;
use crate::linkage::json::Residual;
use crate::show::json::{About, Amount, Number, number};

/// The answer of `assur modes` as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Modes {
    /// `assur-modes/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    status: Status,
    places: Vec<Place>,
    statistics: Statistics,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
enum Status {
    /// All lists are certainly complete.
    Complete,
    Incomplete,
}

/// The modes at a place.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Place {
    /// In words.
    place: String,
    drivers: Vec<Amount>,
    /// Drivers outside of their ranges, in words.
    outside: Vec<String>,
    /// Whether there are certainly no others.
    complete: bool,
    /// Places of the search that could not be decided.
    undecided: usize,
    /// Boxes that were looked at.
    boxes: usize,
    modes: Vec<Mode>,
    /// Index of the mode that the start values pick.
    declared: Option<usize>,
    /// Why the mode of the start values does not get there.
    unreached: Option<String>,
}

/// One way to put the linkage together.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Mode {
    /// Whether the start values pick it.
    declared: bool,
    results: Vec<Amount>,
    groups: Vec<OfGroup>,
    /// What is left of each loop equation.
    residuals: Vec<Residual>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct OfGroup {
    loops: String,
    unknowns: String,
    kind: &'static str,
    /// Sign of the determinant: 1, -1 or 0.
    sign: i8,
    /// Sine of the transmission angle.
    sine: Number,
    /// Transmission angle.
    transmission: Number,
    unit: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Statistics {
    seconds: f64,
}

impl Modes {
    /// The object.
    pub fn of(answer: &super::Modes) -> Self {
        let complete = answer.found.iter().all(|found| found.listing.complete);
        Self {
            format: "assur-modes/1",
            about: About::of(&answer.case.constants),
            status: if complete { Status::Complete } else { Status::Incomplete },
            places: answer.found.iter().map(|found| Place::of(answer, found)).collect(),
            statistics: Statistics { seconds: answer.seconds },
        }
    }
}

impl Place {
    fn of(answer: &super::Modes, found: &Found) -> Self {
        let listing = &found.listing;
        let modes = listing.modes.iter().enumerate();
        let modes =
            modes.map(|(index, one)| Mode::of(answer, one, listing.declared == Some(index)));
        Self {
            place: found.place.label.clone(),
            drivers: Amount::all(&answer.case.drivers, &found.place.independents),
            outside: found.place.outside.clone(),
            complete: listing.complete,
            undecided: listing.undecided,
            boxes: listing.boxes,
            modes: modes.collect(),
            declared: listing.declared,
            unreached: found.unreached.as_ref().map(|told| told.reason.clone()),
        }
    }
}

impl Mode {
    fn of(answer: &super::Modes, mode: &Listed, declared: bool) -> Self {
        let (case, entry) = (&answer.case, answer.case.moved.entry);
        let values = case.values_of(&mode.dependents, &mode.outputs);
        let of_group = |(one, sine): (&Group, &f64)| OfGroup {
            loops: group::equations(entry, one),
            unknowns: group::unknowns(entry, one),
            kind: group::kind(one.kind),
            sign: sign(*sine),
            sine: number(*sine),
            transmission: group::transmits(one).then(|| group::transmission(*sine)),
            unit: "deg",
        };
        let left = mode.residuals.iter().enumerate();
        Self {
            declared,
            results: Amount::results(&case.variables, Some(&values)),
            groups: entry.groups.iter().zip(&mode.sines).map(of_group).collect(),
            residuals: left.map(|(index, left)| Residual::of(case, index, *left)).collect(),
        }
    }
}
