//! How a linkage changes with one variable, by dual numbers: the loops are kept closed in their derivatives.

use crate::closure::{Closure, Linkage, Variable};
use crate::dense::{Lu, Singular};
use crate::problem::Storage;
use crate::scalar::Dual;

/// Derivatives by one variable at a closed position.
pub(super) struct Variation {
    /// Of the dependent coordinates.
    pub dependents: Vec<f64>,
    /// Of the influence coefficients, outputs by variables.
    pub influence: Vec<f64>,
}

/// Where a linkage stands.
pub(super) struct Stand<'a> {
    /// The constants.
    pub values: &'a [f64],
    /// Positions of the drivers.
    pub independents: &'a [f64],
    /// How they move; empty if that is not known.
    pub motion: &'a [f64],
    /// The whole closed position.
    pub position: &'a [f64],
}

impl Stand<'_> {
    /// Derivatives by a variable.
    ///
    /// # Errors
    /// Where the Jacobian of a group is singular there are none.
    pub fn varied<L: Linkage>(&self, variable: Variable) -> Result<Variation, Singular> {
        let (constant, driver) = match variable {
            Variable::Constant(index) => (Some(index), None),
            Variable::Driver(index) => (None, Some(index)),
        };
        let closure = L::prepare::<Dual>(&duals(self.values, constant));
        let independents = duals(self.independents, driver);
        let instant = match self.motion.is_empty() {
            true => closure.instant(&independents),
            false => closure.moving(&independents, &duals(self.motion, None)),
        };
        let mut position = closure.zeros();
        for (slot, value) in position.as_mut().iter_mut().zip(self.position) {
            *slot = Dual::constant(*value);
        }
        for group in 0..L::GROUPS.len() {
            close::<L>(&closure, group, &instant, &mut position)?;
        }
        let mut influence = vec![Dual::default(); L::OUTPUTS * L::VARIABLES.len()];
        closure.influence(&instant, &position, &mut influence);
        let slopes = |list: &[Dual]| list.iter().map(|one| one.slope).collect();
        Ok(Variation {
            dependents: slopes(&position.as_ref()[..L::DEPENDENTS]),
            influence: slopes(&influence),
        })
    }
}

/// Constants, but for one that varies.
fn duals(list: &[f64], varied: Option<usize>) -> Vec<Dual> {
    let one = |(index, value): (usize, &f64)| match Some(index) == varied {
        true => Dual::variable(*value),
        false => Dual::constant(*value),
    };
    list.iter().enumerate().map(one).collect()
}

/// Gives the unknowns of a group the derivatives that keep its loops closed.
fn close<L: Linkage>(
    closure: &L::Closure<Dual>,
    group: usize,
    instant: &<L::Closure<Dual> as Closure<Dual>>::Instant,
    position: &mut <L::Closure<Dual> as Closure<Dual>>::Position,
) -> Result<(), Singular> {
    let largest = L::GROUPS.iter().map(|one| one.unknowns.len()).max();
    let largest = largest.unwrap_or(0);
    let mut residual = <L::Closure<Dual> as Closure<Dual>>::Row::zeros(largest);
    let mut jacobian = <L::Closure<Dual> as Closure<Dual>>::Matrix::zeros(largest * largest);
    closure.trial(group, instant, position, &mut residual, &mut jacobian);
    let unknowns = L::GROUPS[group].unknowns;
    let count = unknowns.len();
    let entries = jacobian.as_ref()[..count * count].iter();
    let factors = Lu::new(entries.map(|one| one.value).collect(), count)?;
    let rows = residual.as_ref()[..count].iter();
    let mut right: Vec<f64> = rows.map(|one| -one.slope).collect();
    factors.solve(&mut right);
    for (unknown, slope) in unknowns.iter().zip(right) {
        position.as_mut()[*unknown].slope = slope;
    }
    // Sines and cosines follow.
    closure.trial(group, instant, position, &mut residual, &mut jacobian);
    Ok(())
}
