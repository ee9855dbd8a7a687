//! `assur modes`: all ways in which a linkage can be assembled where its drivers stand.

mod csv;
mod json;
mod table;

use std::path::Path;
use std::time::Instant;

use assur::closure::{Listed, Listing, Search};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Format, give};
use crate::ask::lookup::Registry;
use crate::ask::{Asked, For};
use crate::error::{Failure, Told};
use crate::linkage::case::Case;
use crate::linkage::place::{self, Place};
use crate::show::page::Page;
pub use json::Modes as Object;

/// Examples, and what the formats contain.
pub const EXAMPLES: &str = "Examples:
  assur modes heald_linkage
  assur modes heald_linkage --at phi4=200deg --at phi4=230deg
  assur modes heald_linkage --scene straight --format json

Loops in closed form have two modes each; loops that are closed together are searched completely by interval
arithmetic, so that the list says itself whether there are others.

Csv has one row a mode.";

/// Options of `assur modes`.
#[derive(Args, Debug)]
pub struct ModesArguments {
    #[command(flatten)]
    pub asked: Asked,
    /// A position of the drivers, `phi4=90deg`; may be repeated. Where they start unless given.
    #[arg(long, value_name = "NAME=VALUE")]
    pub at: Vec<String>,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// The modes at all places.
pub struct Modes {
    /// The linkage with its values.
    pub case: Case,
    /// The places, each with its modes.
    pub found: Vec<Found>,
    /// Seconds that it took.
    pub seconds: f64,
}

/// The modes at one place.
pub struct Found {
    /// The place.
    pub place: Place,
    /// The modes.
    pub listing: Listing,
    /// Why the mode of the start values does not reach the place, in words.
    pub unreached: Option<Told>,
}

/// Lists the modes.
///
/// # Errors
/// A wrong request. That a linkage cannot be assembled somewhere is an answer, not an error.
pub fn execute(options: &ModesArguments, registry: Registry) -> Result<(), Failure> {
    give(options.format, None, || {
        let case = Case::new(options.asked.find(registry, "modes", For::Linkages)?)?;
        let places = match options.at.as_slice() {
            [] => vec![place::start(&case)?],
            given => given.iter().map(|text| place::read(&case, text)).collect::<Result<_, _>>()?,
        };
        let clock = Instant::now();
        let found = places.into_iter().map(|place| find(&case, place));
        let found = found.collect::<Result<_, _>>()?;
        Ok(Modes { found, seconds: clock.elapsed().as_secs_f64(), case })
    })
}

fn find(case: &Case, place: Place) -> Result<Found, Failure> {
    let listing = case.run().modes(&place.independents, &Search::default());
    let listing =
        listing.map_err(|error| case.tell(&error).failure("the modes cannot be listed"))?;
    let unreached = listing.stopped.as_ref().map(|error| case.tell(error));
    Ok(Found { unreached, listing, place })
}

impl Answer for Modes {
    fn table(&self, page: &mut Page, _: Option<&Path>) {
        table::render(page, self);
    }

    fn csv(&self) -> String {
        csv::render(self)
    }

    fn json(&self, _: Option<&Path>) -> impl Serialize {
        Object::of(self)
    }
}

impl Modes {
    /// The values of the variables in a mode, each in its unit.
    pub fn values(&self, mode: &Listed) -> Vec<f64> {
        let values = self.case.values_of(&mode.dependents, &mode.outputs);
        let pairs = self.case.variables.iter().zip(values);
        pairs.map(|(variable, value)| variable.in_unit(value)).collect()
    }

    /// The loop equation that is left worst in a mode, and what is left of it in SI units.
    pub fn gap(mode: &Listed) -> Option<(usize, f64)> {
        let left = mode.residuals.iter().map(|left| left.abs()).enumerate();
        left.max_by(|(_, a), (_, b)| a.total_cmp(b))
    }
}

/// The sign of a determinant, 0 where it has none: the assembly mode of a group.
pub fn sign(sine: f64) -> i8 {
    match sine {
        sine if sine > 0.0 => 1,
        sine if sine < 0.0 => -1,
        _ => 0,
    }
}
