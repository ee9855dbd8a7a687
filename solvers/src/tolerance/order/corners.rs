//! The greatest errors of linkages whose errors are all as large as they may be.
//!
//! All combinations of signs are tried, with the loops closed again and by the quadratic form. An output that is not
//! monotonic in some dimension may be worse between its extremes; to second order only where that dimension has
//! a second derivative larger than its first over the tolerance.

use super::second::quadratics_of;
use crate::closure::{AnyLinkage, Linkage};
use crate::tolerance::error::ToleranceError;
use crate::tolerance::made::exact;
use crate::tolerance::made::nominal::Nominal;
use crate::tolerance::source::Study;

/// Largest number of sources.
const MOST: usize = 16;

/// The extreme errors over all corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners {
    /// Least error; not a number if no corner assembles.
    pub least: f64,
    /// Greatest error.
    pub greatest: f64,
    /// Where the least is: bit `k` says that the source `k` has its upper extreme.
    pub least_at: u32,
    /// Where the greatest is.
    pub greatest_at: u32,
    /// Corners that do not assemble in the mode of the nominal linkage.
    pub failed: usize,
    /// Corners that were tried.
    pub tried: usize,
}

/// At one place, both ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// With the loops closed again.
    pub exact: Corners,
    /// By the quadratic form.
    pub quadratic: Corners,
}

impl Corners {
    const NONE: Self = Self {
        least: f64::NAN,
        greatest: f64::NAN,
        least_at: 0,
        greatest_at: 0,
        failed: 0,
        tried: 0,
    };

    /// The larger of both errors in size.
    pub fn worst(&self) -> f64 {
        self.least.abs().max(self.greatest.abs())
    }

    fn add(&mut self, corner: u32, error: f64) {
        self.tried += 1;
        if error.is_nan() {
            self.failed += 1;
            return;
        }
        if self.least.is_nan() || error < self.least {
            (self.least, self.least_at) = (error, corner);
        }
        if self.greatest.is_nan() || error > self.greatest {
            (self.greatest, self.greatest_at) = (error, corner);
        }
    }
}

/// The extreme errors at every place of a study.
///
/// # Errors
/// [`ToleranceError`] if the question makes no sense, has more than 16 sources, or if the nominal linkage does not get to
/// a place.
pub fn corners<L: Linkage>(linkage: &L, study: &Study) -> Result<Vec<Extremes>, ToleranceError> {
    corners_of(linkage, study)
}

/// [`corners`] of a linkage behind a pointer.
pub(crate) fn corners_of(
    linkage: &dyn AnyLinkage,
    study: &Study,
) -> Result<Vec<Extremes>, ToleranceError> {
    let forms = quadratics_of(linkage, study)?;
    let sources = study.sources.len();
    if sources > MOST {
        return Err(ToleranceError::TooManyCorners { sources, most: MOST });
    }
    let nominals = Nominal::along(linkage, &study.places, &study.sources)?;
    let none = Extremes { exact: Corners::NONE, quadratic: Corners::NONE };
    let mut all = vec![none; study.places.len()];
    let mut found = vec![0.0; study.places.len()];
    for corner in 0..1u32 << sources {
        let errors = signed(study, corner);
        exact::errors(linkage, study, &nominals, &errors, &mut found);
        for ((extremes, form), error) in all.iter_mut().zip(&forms).zip(&found) {
            extremes.exact.add(corner, *error);
            extremes.quadratic.add(corner, form.error(&errors));
        }
    }
    Ok(all)
}

/// All errors at their extremes.
fn signed(study: &Study, corner: u32) -> Vec<f64> {
    let sources = study.sources.iter().enumerate();
    sources
        .map(|(index, source)| match corner >> index & 1 {
            0 => -source.half_width,
            _ => source.half_width,
        })
        .collect()
}
