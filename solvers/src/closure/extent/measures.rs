//! Numbers of a whole way of a linkage: those that measures find of a run, with the place of the driver for the time.

use std::cell::RefCell;

use super::track::Along;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::instant_at;
use crate::hybrid::Motion;
use crate::measure::{self, Missing};
use crate::problem::Phase;

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
    let [found, other] = PARTS.map(|parts| measured(linkage, along, parts));
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

/// The same by a look at fewer places, without errors.
///
/// # Errors
/// As there.
pub(in crate::closure) fn weighed_of(
    linkage: &dyn AnyLinkage,
    along: Along,
) -> Result<Vec<Result<f64, Missing>>, ClosureError> {
    measured(linkage, along, FEW)
}

/// The measures as so many parts of the way show them.
fn measured(
    linkage: &dyn AnyLinkage,
    along: Along,
    parts: usize,
) -> Result<Vec<Result<f64, Missing>>, ClosureError> {
    let mut assembly = linkage.assemble();
    assembly.guide().start()?;
    let standing = assembly.guide().independents.to_vec();
    let assembly = RefCell::new(assembly);
    let loops = linkage.prepare(&linkage.values());
    let (from, to) = along.bounds();
    // A way that is gone backwards begins where it begins.
    let sign = if from > to { -1.0 } else { 1.0 };
    let motion = Motion::without_states(0, (sign * from, sign * to), parts);
    let stopped = RefCell::new(None);
    let place = |at: f64| match along {
        Along::Driver(index, _) => {
            let mut place = standing.clone();
            place[index] = at;
            Ok(place)
        }
        Along::Time(..) => linkage.drive(at).ok_or_else(|| ClosureError::BadRange {
            reason: "the drivers do not move in time".to_owned(),
        }),
    };
    let look = |at: f64, values: &mut [f64]| -> Result<(), ClosureError> {
        let place = place(sign * at)?;
        let (drivers, motion) = place.split_at(standing.len());
        let mut assembly = assembly.borrow_mut();
        assembly.travel(drivers)?;
        let instant = instant_at(&*loops, drivers, linkage.motion(motion));
        loops.measured(&instant, assembly.guide().position, values);
        Ok(())
    };
    let sample = |_: Phase<'_, f64>, at: f64, _: &[f64], values: &mut [f64]| {
        if let Err(error) = look(at, values) {
            values.fill(f64::NAN);
            stopped.borrow_mut().get_or_insert(error);
        }
    };
    let measures = |found: &[f64], values: &mut [f64]| loops.measures(found, values);
    let found = measure::all(&motion, linkage.shape(), &sample, &measures);
    match stopped.into_inner() {
        Some(error) => Err(error),
        None => Ok(found),
    }
}
