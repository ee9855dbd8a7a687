//! How a linkage changes with one variable, by dual numbers: the loops are kept closed in their derivatives.

use crate::closure::{Answers, AnyLinkage, Variable, duals, keep_closed};
use crate::dense::Singular;
use crate::scalar::Dual;

/// A linkage at a closed position, with the derivatives of all by one variable.
pub(in crate::tolerance) struct Variation {
    loops: Box<dyn Answers<Dual>>,
    instant: Vec<Dual>,
    position: Vec<Dual>,
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
    /// How it changes with a variable.
    ///
    /// # Errors
    /// Where the Jacobian of a group is singular there are no derivatives.
    pub fn varied(
        &self,
        linkage: &dyn AnyLinkage,
        variable: Variable,
    ) -> Result<Variation, Singular> {
        let (constant, driver) = match variable {
            Variable::Constant(index) => (Some(index), None),
            Variable::Driver(index) => (None, Some(index)),
        };
        let loops = linkage.differentiate(&duals(self.values, constant));
        let independents = duals(self.independents, driver);
        let instant = loops.instant_row(&independents, &duals(self.motion, None));
        let mut position = duals(self.position, None);
        keep_closed(&*loops, &instant, &mut position)?;
        Ok(Variation { loops, instant, position })
    }
}

impl Variation {
    /// Derivatives of the dependent coordinates.
    pub fn dependents(&self) -> Vec<f64> {
        slopes(&self.position[..self.loops.shape().loops().dependents.len()])
    }

    /// Derivatives of the outputs.
    pub fn outputs(&self) -> Vec<f64> {
        let mut outputs = vec![Dual::default(); self.loops.shape().outputs.len()];
        self.loops.outputs(&self.instant, &self.position, &mut outputs);
        slopes(&outputs)
    }

    /// Derivatives of the influence coefficients, outputs by variables.
    pub fn influence(&self) -> Vec<f64> {
        let shape = self.loops.shape();
        let count = shape.outputs.len() * shape.loops().variables.len();
        let mut influence = vec![Dual::default(); count];
        self.loops.influence(&self.instant, &self.position, &mut influence);
        slopes(&influence)
    }
}

fn slopes(list: &[Dual]) -> Vec<f64> {
    list.iter().map(|one| one.slope).collect()
}
