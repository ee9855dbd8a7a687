//! How far the numbers of a linkage may be off by rounding.

use assur::scalar::fault;

use super::case::Case;
use super::influence::Influence;
use super::search::Extreme;

/// Of each variable at a place, SI units; not a number where that is not known.
pub fn at(case: &Case, place: &[f64]) -> Vec<f64> {
    let found = case.run().rounding(place, false);
    // What has no value there is told elsewhere.
    fault::take();
    match found {
        Ok(found) => case.values_of(&found.dependents, &found.outputs),
        Err(_) => vec![f64::NAN; case.variables.len()],
    }
}

/// Of the extremes of each variable, where integrals are known to this part of their size.
pub fn of_limits(
    case: &Case,
    limits: &[Option<(Extreme, Extreme)>],
    doubt: f64,
) -> Vec<(f64, f64)> {
    // Many variables have their extremes at the same places, such as the ends of the task.
    let mut known: Vec<(&[f64], Vec<f64>)> = Vec::new();
    let mut error = |index: usize, extreme| {
        let Extreme { station, value, .. }: &Extreme = extreme;
        let there = known.iter().position(|(other, _)| other == station);
        let there = there.unwrap_or_else(|| {
            known.push((station, at(case, &case.place(station))));
            known.len() - 1
        });
        or_more(known[there].1[index], doubt * value.abs())
    };
    let each = limits.iter().enumerate().map(|(index, limits)| match limits {
        Some((low, high)) => (error(index, low), error(index, high)),
        None => (f64::NAN, f64::NAN),
    });
    each.collect()
}

/// The larger of two errors; not a number where one is not known.
pub fn or_more(error: f64, other: f64) -> f64 {
    if error.is_nan() || other.is_nan() { f64::NAN } else { error.max(other) }
}

/// Gives influence coefficients at a place their errors.
pub fn of_influence(case: &Case, place: &[f64], influence: &mut [Influence]) {
    let found = case.run().rounding(place, true);
    fault::take();
    let Ok(found) = found else { return };
    let width = case.moved.entry.variables.len();
    for row in influence {
        let errors = found.influence.iter().skip(row.index).step_by(width);
        row.errors = errors.copied().collect();
    }
}
