//! What is asked about the tolerances of a linkage.

#[cfg(feature = "allocation")]
use super::allocation::allocate_of;
use super::order::corners::corners_of;
use super::order::differences::differences_of;
use super::order::influence::influences_of;
use super::order::rounding::rounding_of;
use super::order::second::quadratics_of;
use super::sample::monte_carlo::monte_carlo_of;
#[cfg(feature = "allocation")]
use super::{Allocation, AllocationError, Candidate, Rule};
use super::{
    Differences, Extremes, Influences, MonteCarlo, Quadratic, Rounding, Sampling, Study,
    ToleranceError,
};
use crate::closure::{AnyLinkage, Variable};

/// Each run is explained where the solvers have it, in [`mod@super`]. There is none of a linkage in which nothing
/// has a tolerance or is a made dimension.
impl dyn AnyLinkage + '_ {
    /// Whether anything in it is made to a tolerance, or is a dimension and so may be.
    fn is_made(&self) -> Result<(), ToleranceError> {
        let entry = self.shape().loops();
        let mut variables = entry.variables.iter();
        let is_made = variables.any(|one| matches!(one, Variable::Constant(_)))
            || entry.tolerances.iter().any(|one| one.0 > 0.0);
        is_made.then_some(()).ok_or(ToleranceError::NoSource)
    }

    /// Influence of all variables on the output, see [`fn@super::influences`].
    ///
    /// # Errors
    /// Why a place is not reached.
    pub fn influences(&self, study: &Study) -> Result<Influences, ToleranceError> {
        self.is_made()?;
        study.check_places(self.shape())?;
        influences_of(self, study.output, &study.places)
    }

    /// How far its numbers may be off by rounding at a place of the drivers, see [`Rounding`].
    ///
    /// # Errors
    /// Why it does not get there.
    pub fn rounding(
        &self,
        place: &[f64],
        with_influence: bool,
    ) -> Result<Rounding, ToleranceError> {
        rounding_of(self, place, with_influence)
    }

    /// The output to second order, see [`fn@super::quadratics`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    pub fn quadratics(&self, study: &Study) -> Result<Vec<Quadratic>, ToleranceError> {
        self.is_made()?;
        quadratics_of(self, study)
    }

    /// Errors at all extremes, see [`fn@super::corners`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    pub fn corners(&self, study: &Study) -> Result<Vec<Extremes>, ToleranceError> {
        self.is_made()?;
        corners_of(self, study)
    }

    /// What the first and the second order miss, see [`fn@super::differences`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    pub fn differences(
        &self,
        study: &Study,
        samples: u64,
        seed: u64,
    ) -> Result<Vec<Differences>, ToleranceError> {
        self.is_made()?;
        differences_of(self, study, samples, seed)
    }

    /// Linkages made at random, see [`fn@super::monte_carlo`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    pub fn monte_carlo(
        &self,
        study: &Study,
        sampling: &Sampling,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<MonteCarlo, ToleranceError> {
        self.is_made()?;
        monte_carlo_of(self, study, sampling, progress)
    }

    /// Tolerances of least cost, see [`fn@super::allocate`].
    ///
    /// # Errors
    /// [`AllocationError`].
    #[cfg(feature = "allocation")]
    pub fn allocate(
        &self,
        study: &Study,
        candidates: &[Candidate],
        rule: Rule,
        band: f64,
    ) -> Result<Allocation, AllocationError> {
        self.is_made()?;
        allocate_of(self, study, candidates, rule, band)
    }
}
