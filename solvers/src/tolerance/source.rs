//! What errs, and what is asked about it.

use super::error::ToleranceError;
use crate::shape::{Distribution, Shape};

/// An independent error of one variable. A variable may have several: a tolerance, and play in its joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// Index into [`LinkageEntry::variables`](crate::shape::LinkageEntry::variables).
    pub variable: usize,
    /// Largest error, or three standard deviations of a normal distribution; SI units.
    pub half_width: f64,
    /// How the errors are distributed.
    pub distribution: Distribution,
}

impl Source {
    /// Radial play in a joint of a link that carries two forces only: its length errs by as much. Which way, the sense of
    /// its force decides, so that all errors are alike probable unless more is known.
    pub fn play(variable: usize, radial: f64) -> Self {
        Self { variable, half_width: radial, distribution: Distribution::Uniform }
    }

    /// Standard deviation of the error.
    pub fn deviation(&self) -> f64 {
        self.half_width * self.distribution.deviation()
    }

    /// Variance of the error.
    pub fn variance(&self) -> f64 {
        self.half_width.powi(2) * self.distribution.variance()
    }

    /// Third central moment of the error.
    pub fn third_moment(&self) -> f64 {
        self.half_width.powi(3) * self.distribution.third_moment()
    }

    /// Fourth central moment of the error.
    pub fn fourth_moment(&self) -> f64 {
        self.half_width.powi(4) * self.distribution.fourth_moment()
    }
}

/// A question about tolerances: of which output, where, and what errs.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// Index of the output.
    pub output: usize,
    /// Positions of the drivers, and behind them how these move where that is known. They are gone through in their order.
    pub places: Vec<Vec<f64>>,
    /// What errs.
    pub sources: Vec<Source>,
}

impl Study {
    /// Checks the question about a linkage.
    ///
    /// # Errors
    /// What cannot be asked.
    pub fn check(&self, shape: &Shape) -> Result<(), ToleranceError> {
        self.check_places(shape)?;
        check_sources(&self.sources, shape.loops().variables.len())
    }

    /// Checks the output, and that there is a place.
    pub(crate) fn check_places(&self, shape: &Shape) -> Result<(), ToleranceError> {
        let (output, outputs) = (self.output, shape.outputs.len());
        if output >= outputs {
            return Err(ToleranceError::NoOutput { output, outputs });
        }
        if self.places.is_empty() {
            return Err(ToleranceError::NoPlace);
        }
        Ok(())
    }
}

/// Checks what errs; there must be something.
pub(super) fn check_sources(sources: &[Source], variables: usize) -> Result<(), ToleranceError> {
    check_variables(sources.iter().map(|one| one.variable), variables)?;
    for (index, source) in sources.iter().enumerate() {
        if !(source.half_width >= 0.0 && source.half_width.is_finite()) {
            return Err(ToleranceError::BadHalfWidth {
                source: index,
                half_width: source.half_width,
            });
        }
    }
    if sources.iter().all(|source| source.half_width == 0.0) {
        return Err(ToleranceError::NoSource);
    }
    Ok(())
}

/// Checks that variables exist.
pub(super) fn check_variables(
    chosen: impl Iterator<Item = usize>,
    variables: usize,
) -> Result<(), ToleranceError> {
    for (source, variable) in chosen.enumerate() {
        if variable >= variables {
            return Err(ToleranceError::NoVariable { source, variable, variables });
        }
    }
    Ok(())
}
