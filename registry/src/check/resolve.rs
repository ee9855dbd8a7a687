//! Influence coefficients of a linkage against putting it together again.

use super::Failed;
use super::linkage::{Position, compare};
use assur_solvers::closure::{AnyLinkage, Variable};

/// Largest deviation from a difference of positions, whose rounding grows as its step shrinks, as a share of the largest
/// derivative by the same variable.
const DIFFERENCE: f64 = 1e-6;

/// What rounding makes of an output, over the output.
const OUTPUT: f64 = 16.0 * f64::EPSILON;

/// Differences of two steps within which their rounding lies.
const ROUNDING: f64 = 4.0;

/// The largest constant of the dimension of one of them; where all are zero 1 in SI units.
fn size(linkage: &dyn AnyLinkage, index: usize) -> f64 {
    let constants = linkage.shape().constants;
    let own = constants[index].quantity.dimension;
    let values = linkage.values();
    let alike = constants.iter().zip(&values).filter(|one| one.0.quantity.dimension == own);
    match alike.fold(0.0_f64, |most, one| most.max(one.1.abs())) {
        0.0 => 1.0,
        size => size,
    }
}

/// Checks the influence coefficients against the outputs of the linkage made anew with each constant a little larger and
/// smaller, in the same modes.
pub(super) fn resolved(linkage: &dyn AnyLinkage, here: &Position<'_>) -> Result<(), Failed> {
    let variables = linkage.shape().loops().variables;
    let near = &here.position[..linkage.shape().loops().dependents.len()];
    let outputs = |values: &[f64]| -> Result<Vec<f64>, Failed> {
        let other = linkage.with_values(values);
        let mut assembly = other.assemble();
        let mut guide = assembly.guide();
        let started = guide.start_at(&here.independents, near);
        started.map_err(|error| Failed(error.to_string()))?;
        let instant = guide.loops.instant_row(guide.independents, &here.motion);
        let mut list = vec![0.0; here.outputs()];
        guide.loops.outputs(&instant, guide.position, &mut list);
        Ok(list)
    };
    let count = variables.len();
    for (j, variable) in variables.iter().enumerate() {
        let Variable::Constant(index) = variable else {
            continue;
        };
        let (size, value) = (size(linkage, *index), linkage.values()[*index].abs());
        let step = 1e-5 * if value == 0.0 { size } else { value.max(1e-3 * size) };
        let moved = |change: f64| {
            let mut values = linkage.values();
            values[*index] += change;
            outputs(&values)
        };
        let slopes = |step: f64| -> Result<Vec<f64>, Failed> {
            let (above, below) = (moved(step)?, moved(-step)?);
            Ok(above.iter().zip(&below).map(|(a, b)| (a - b) / (2.0 * step)).collect())
        };
        let found: Vec<f64> = (0..here.outputs()).map(|i| here.influence[i * count + j]).collect();
        let mut expected = slopes(step)?;
        // Where a condition does not hold there is no output that could change.
        for ((expected, found), output) in expected.iter_mut().zip(&found).zip(&here.reported) {
            if output.is_nan() {
                *expected = *found;
            }
        }
        let what = format!(
            "influence of {variable:?} on the outputs, by putting the linkage together again"
        );
        let mut floors = here.floors(OUTPUT / step);
        let check = |floors: &[f64]| {
            compare(&what, &found, &expected, (DIFFERENCE, floors), &here.independents)
        };
        if check(&floors).is_err() {
            // An output may be a small difference of large terms: how much rounding is in it another step shows.
            for ((floor, near), far) in floors.iter_mut().zip(&expected).zip(slopes(2.0 * step)?) {
                *floor = floor.max(ROUNDING * (near - far).abs());
            }
            check(&floors)?;
        }
    }
    Ok(())
}
