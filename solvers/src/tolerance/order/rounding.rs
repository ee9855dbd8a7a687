//! How far the numbers of a linkage may be off by rounding.

use crate::closure::{AnyLinkage, Variable};
use crate::tolerance::error::ToleranceError;
use crate::tolerance::made::nominal::Nominal;

/// Half the last place of a number, at most, over the number.
pub(in crate::tolerance) const HALF_PLACE: f64 = f64::EPSILON / 2.0;

/// How far the numbers of a linkage may be off by rounding at a place, SI units: the root of the sum of squares of what each value,
/// a constant or the position of a driver, makes of them if it is off by half its last place, and of half of their own. Roundings have
/// any sign. Not a number where that is not known.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounding {
    /// Of the dependent coordinates.
    pub dependents: Vec<f64>,
    /// Of the outputs.
    pub outputs: Vec<f64>,
    /// Of the influence coefficients, outputs by variables; empty unless they are asked for.
    pub influence: Vec<f64>,
}

/// Finds it at a place.
///
/// # Errors
/// Why the linkage does not get there.
pub(crate) fn rounding_of(
    linkage: &dyn AnyLinkage,
    place: &[f64],
    with_influence: bool,
) -> Result<Rounding, ToleranceError> {
    let nominals = Nominal::along(linkage, &[place.to_vec()], &[])?;
    let Some(nominal) = nominals.first() else { return Err(ToleranceError::NoSource) };
    let (stand, entry) = (nominal.stand(), linkage.shape().loops());
    let own = |values: &[f64]| values.iter().map(|value| value.powi(2)).collect::<Vec<f64>>();
    let mut rounding = Rounding {
        dependents: own(&stand.position[..entry.dependents.len()]),
        outputs: own(&nominal.outputs),
        influence: Vec::new(),
    };
    if with_influence {
        rounding.influence = vec![0.0; nominal.outputs.len() * entry.variables.len()];
    }
    let constants = (0..stand.values.len()).map(Variable::Constant);
    for variable in constants.chain((0..stand.independents.len()).map(Variable::Driver)) {
        let value = match variable {
            Variable::Constant(index) => stand.values[index],
            Variable::Driver(index) => stand.independents[index],
        };
        if value == 0.0 {
            continue;
        }
        let at = || ToleranceError::NotFinite { place: 0, at: place.to_vec() };
        let variation = stand.varied(linkage, variable).map_err(|_| at())?;
        let add = |sums: &mut [f64], slopes: Vec<f64>| {
            for (sum, slope) in sums.iter_mut().zip(slopes) {
                *sum += (slope * value).powi(2);
            }
        };
        add(&mut rounding.dependents, variation.dependents());
        add(&mut rounding.outputs, variation.outputs());
        if with_influence {
            add(&mut rounding.influence, variation.influence());
        }
    }
    let Rounding { dependents, outputs, influence } = &mut rounding;
    for sum in [dependents, outputs, influence].into_iter().flatten() {
        *sum = HALF_PLACE * sum.sqrt();
    }
    Ok(rounding)
}
