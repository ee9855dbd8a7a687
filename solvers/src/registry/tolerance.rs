//! What is asked about the tolerances of a linkage; whole runs, as everything behind `dyn`.

use super::linkage::Bound;
use crate::closure::Linkage;
use crate::tolerance::{
    self, Differences, Extremes, Influences, MonteCarlo, Quadratic, Sampling, Study, ToleranceError,
};
#[cfg(feature = "allocation")]
use crate::tolerance::{Allocation, AllocationError, Candidate, Rule};

/// A linkage whose dimensions are fixed, but for their tolerances. Each run is explained where the solvers have it, in
/// [`mod@crate::tolerance`].
pub trait RunTolerance {
    /// Influence of all variables on the output, see [`fn@tolerance::influences`].
    ///
    /// # Errors
    /// Why a place is not reached.
    fn influences(&self, study: &Study) -> Result<Influences, ToleranceError>;
    /// The output to second order, see [`fn@tolerance::quadratics`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    fn quadratics(&self, study: &Study) -> Result<Vec<Quadratic>, ToleranceError>;
    /// Errors at all extremes, see [`fn@tolerance::corners`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    fn corners(&self, study: &Study) -> Result<Vec<Extremes>, ToleranceError>;
    /// What the first and the second order miss, see [`fn@tolerance::differences`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    fn differences(
        &self,
        study: &Study,
        samples: u64,
        seed: u64,
    ) -> Result<Vec<Differences>, ToleranceError>;
    /// Linkages made at random, see [`fn@tolerance::monte_carlo`].
    ///
    /// # Errors
    /// [`ToleranceError`].
    fn monte_carlo(
        &self,
        study: &Study,
        sampling: &Sampling,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<MonteCarlo, ToleranceError>;
    #[cfg(feature = "allocation")]
    /// Tolerances of least cost, see [`fn@tolerance::allocate`].
    ///
    /// # Errors
    /// [`AllocationError`].
    fn allocate(
        &self,
        study: &Study,
        candidates: &[Candidate],
        rule: Rule,
        band: f64,
    ) -> Result<Allocation, AllocationError>;
}

impl<L: Linkage> RunTolerance for Bound<L, true> {
    fn influences(&self, study: &Study) -> Result<Influences, ToleranceError> {
        study.check_places::<L>()?;
        tolerance::influences(&self.linkage, study.output, &study.places)
    }

    fn quadratics(&self, study: &Study) -> Result<Vec<Quadratic>, ToleranceError> {
        tolerance::quadratics(&self.linkage, study)
    }

    fn corners(&self, study: &Study) -> Result<Vec<Extremes>, ToleranceError> {
        tolerance::corners(&self.linkage, study)
    }

    fn differences(
        &self,
        study: &Study,
        samples: u64,
        seed: u64,
    ) -> Result<Vec<Differences>, ToleranceError> {
        tolerance::differences(&self.linkage, study, samples, seed)
    }

    fn monte_carlo(
        &self,
        study: &Study,
        sampling: &Sampling,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<MonteCarlo, ToleranceError> {
        tolerance::monte_carlo(&self.linkage, study, sampling, progress)
    }

    #[cfg(feature = "allocation")]
    fn allocate(
        &self,
        study: &Study,
        candidates: &[Candidate],
        rule: Rule,
        band: f64,
    ) -> Result<Allocation, AllocationError> {
        tolerance::allocate(&self.linkage, study, candidates, rule, band)
    }
}

/// Nothing in it has a tolerance.
impl<L: Linkage> RunTolerance for Bound<L, false> {
    fn influences(&self, _study: &Study) -> Result<Influences, ToleranceError> {
        Err(ToleranceError::NoSource)
    }

    fn quadratics(&self, _study: &Study) -> Result<Vec<Quadratic>, ToleranceError> {
        Err(ToleranceError::NoSource)
    }

    fn corners(&self, _study: &Study) -> Result<Vec<Extremes>, ToleranceError> {
        Err(ToleranceError::NoSource)
    }

    fn differences(
        &self,
        _study: &Study,
        _samples: u64,
        _seed: u64,
    ) -> Result<Vec<Differences>, ToleranceError> {
        Err(ToleranceError::NoSource)
    }

    fn monte_carlo(
        &self,
        _study: &Study,
        _sampling: &Sampling,
        _progress: &(dyn Fn(u64) + Sync),
    ) -> Result<MonteCarlo, ToleranceError> {
        Err(ToleranceError::NoSource)
    }

    #[cfg(feature = "allocation")]
    fn allocate(
        &self,
        _study: &Study,
        _candidates: &[Candidate],
        _rule: Rule,
        _band: f64,
    ) -> Result<Allocation, AllocationError> {
        Err(AllocationError::Tolerance(ToleranceError::NoSource))
    }
}
