//! How a linkage changes with one variable, by dual numbers: the loops are kept closed in their derivatives.

use crate::closure::{Answers, AnyLinkage, Square, Variable, instant_at};
use crate::dense::{Lu, Singular};
use crate::scalar::Dual;

/// Derivatives by one variable at a closed position.
pub(in crate::tolerance) struct Variation {
    /// Of the dependent coordinates.
    pub dependents: Vec<f64>,
    /// Of the influence coefficients, outputs by variables.
    pub influence: Vec<f64>,
}

/// Where a linkage stands.
pub(in crate::tolerance) struct Stand<'a> {
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
    pub fn varied(
        &self,
        linkage: &dyn AnyLinkage,
        variable: Variable,
    ) -> Result<Variation, Singular> {
        let (constant, driver) = match variable {
            Variable::Constant(index) => (Some(index), None),
            Variable::Driver(index) => (None, Some(index)),
        };
        let (shape, entry) = (linkage.shape(), linkage.shape().loops());
        let loops = linkage.differentiate(&duals(self.values, constant));
        let independents = duals(self.independents, driver);
        let instant = instant_at(&*loops, &independents, &duals(self.motion, None));
        let mut position = duals(self.position, None);
        for group in 0..entry.groups.len() {
            close(&*loops, group, &instant, &mut position)?;
        }
        let mut influence = vec![Dual::default(); shape.outputs.len() * entry.variables.len()];
        loops.influence(&instant, &position, &mut influence);
        let slopes = |list: &[Dual]| list.iter().map(|one| one.slope).collect();
        Ok(Variation {
            dependents: slopes(&position[..entry.dependents.len()]),
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
fn close(
    loops: &dyn Answers<Dual>,
    group: usize,
    instant: &[Dual],
    position: &mut [Dual],
) -> Result<(), Singular> {
    let mut square = Square::of(loops.shape());
    square.look(loops, group, instant, position);
    let unknowns = loops.shape().loops().groups[group].unknowns;
    let count = unknowns.len();
    let entries = square.jacobian[..count * count].iter();
    let factors = Lu::new(entries.map(|one| one.value).collect(), count)?;
    let rows = square.residual[..count].iter();
    let mut right: Vec<f64> = rows.map(|one| -one.slope).collect();
    factors.solve(&mut right);
    for (unknown, slope) in unknowns.iter().zip(right) {
        position[*unknown].slope = slope;
    }
    // Sines and cosines follow.
    square.look(loops, group, instant, position);
    Ok(())
}
