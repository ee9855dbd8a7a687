//! How a linkage changes with one variable, by dual numbers: the loops are kept closed in their derivatives.

use crate::closure::{AnyLinkage, Variable, duals, keep_closed};
use crate::dense::Singular;
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
        let instant = loops.instant_row(&independents, &duals(self.motion, None));
        let mut position = duals(self.position, None);
        keep_closed(&*loops, &instant, &mut position)?;
        let mut influence = vec![Dual::default(); shape.outputs.len() * entry.variables.len()];
        loops.influence(&instant, &position, &mut influence);
        let slopes = |list: &[Dual]| list.iter().map(|one| one.slope).collect();
        Ok(Variation {
            dependents: slopes(&position[..entry.dependents.len()]),
            influence: slopes(&influence),
        })
    }
}
