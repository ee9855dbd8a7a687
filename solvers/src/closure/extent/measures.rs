//! Numbers of a whole way of a linkage: those that measures find of a run, with the place of the driver for the time.

use super::track::Along;
use super::walk::Walk;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::measure::{self, Missing};

/// Parts in which a way is looked through, and once more for the error. Each is looked at in eight places and halved where they
/// do not say what lies between.
const PARTS: [usize; 2] = [48, 35];
/// Parts in which a way is looked through where one number is weighed against many others.
const FEW: usize = 12;
/// Roundings by which a number may be wrong in any case.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A number of a whole way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Its value, SI units, or why there is none.
    pub value: Result<f64, Missing>,
    /// Its estimated error, SI units; NaN where there is none. Of an integral, and of what is looked for, it is what two ways
    /// to look make of it, not less than rounding.
    pub error: f64,
}

/// The measures of a linkage along a way, in the order of its file.
///
/// # Errors
/// Why the linkage does not get through it.
pub(in crate::closure) fn measures_of(
    linkage: &dyn AnyLinkage,
    along: Along,
) -> Result<Vec<Measured>, ClosureError> {
    let [found, other] = PARTS.map(|parts| measured(linkage, along, parts, &|_| true));
    let pairs = found?.into_iter().zip(other?);
    let both = pairs.map(|(value, other)| {
        let error = match (value, other) {
            (Ok(value), Ok(other)) => f64::max((value - other).abs(), ROUNDING * value.abs()),
            _ => f64::NAN,
        };
        Measured { value, error }
    });
    Ok(both.collect())
}

/// Those that are wanted by a look at fewer places, without errors; the others are missing.
///
/// # Errors
/// As there.
pub(in crate::closure) fn weighed_of(
    linkage: &dyn AnyLinkage,
    along: Along,
    wanted: &dyn Fn(usize) -> bool,
) -> Result<Vec<Result<f64, Missing>>, ClosureError> {
    measured(linkage, along, FEW, wanted)
}

/// The measures as so many parts of the way show them.
fn measured(
    linkage: &dyn AnyLinkage,
    along: Along,
    parts: usize,
    wanted: &dyn Fn(usize) -> bool,
) -> Result<Vec<Result<f64, Missing>>, ClosureError> {
    let mut walk = Walk::new(linkage, along)?;
    let uses = linkage.shape().uses.iter().enumerate();
    let uses: Vec<&[usize]> = uses.filter(|(index, _)| wanted(*index)).map(|one| *one.1).collect();
    let found = walk.find(parts, &|primitive| uses.iter().any(|uses| uses.contains(&primitive)))?;
    let measures = |found: &[f64], values: &mut [f64]| walk.loops.measures(found, values);
    Ok(measure::made(linkage.shape(), &found, &measures))
}
