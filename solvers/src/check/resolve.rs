//! Influence coefficients of a linkage against putting it together again.

use super::Failed;
use super::linkage::{Position, compare};
use crate::closure::{Assembly, Closure, Linkage, Variable};

/// Largest deviation from a difference of positions, whose rounding grows as its step shrinks, as a share of the largest
/// derivative by the same variable.
const DIFFERENCE: f64 = 1e-6;

/// Checks the influence coefficients against the outputs of the linkage made anew with each constant a little larger and
/// smaller, in the same modes.
pub(super) fn resolved<L: Linkage>(
    linkage: &L,
    assembly: &Assembly<L, f64>,
    motion: &[f64],
) -> Result<(), Failed> {
    let near = assembly.position().as_ref()[..L::DEPENDENTS].to_vec();
    let outputs = |values: &[f64]| -> Result<Vec<f64>, Failed> {
        let mut other = Assembly::<L, f64>::new(&L::with_values(values));
        other
            .start_at(assembly.independents(), &near)
            .map_err(|error| Failed(error.to_string()))?;
        let instant = other.closure().moving(other.independents(), motion);
        let mut list = vec![0.0; L::OUTPUTS];
        other
            .closure()
            .outputs(&instant, other.position(), &mut list);
        Ok(list)
    };
    let here = Position::of(linkage, assembly, motion);
    let count = L::VARIABLES.len();
    for (j, variable) in L::VARIABLES.iter().enumerate() {
        let Variable::Constant(index) = variable else {
            continue;
        };
        let size = linkage
            .values()
            .iter()
            .fold(0.0_f64, |most, one| most.max(one.abs()));
        let value = linkage.values()[*index].abs();
        // What is zero may be an angle among lengths: a step as small as the others would drown in rounding.
        let step = 1e-5
            * if value == 0.0 {
                size
            } else {
                value.max(1e-3 * size)
            };
        let moved = |change: f64| {
            let mut values = linkage.values();
            values[*index] += change;
            outputs(&values)
        };
        let (above, below) = (moved(step)?, moved(-step)?);
        let expected: Vec<f64> = above
            .iter()
            .zip(&below)
            .map(|(a, b)| (a - b) / (2.0 * step))
            .collect();
        let found: Vec<f64> = (0..L::OUTPUTS)
            .map(|i| here.influence[i * count + j])
            .collect();
        let what = format!(
            "influence of {variable:?} on the outputs, by putting the linkage together again"
        );
        compare(
            &what,
            &found,
            &expected,
            DIFFERENCE,
            assembly.independents(),
        )?;
    }
    Ok(())
}
