//! How far the first and the second order are from closing the loops again, over linkages made at random.

use super::second::quadratics_of;
use crate::closure::{AnyLinkage, Linkage};
use crate::tolerance::error::ToleranceError;
use crate::tolerance::made::exact;
use crate::tolerance::made::nominal::Nominal;
use crate::tolerance::random::Random;
use crate::tolerance::source::Study;

/// How far an approximation is off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Root of the mean square.
    pub rms: f64,
    /// Greatest.
    pub greatest: f64,
}

/// The differences at one place. They say nothing of linkages that do not assemble.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Differences {
    /// Of the first order.
    pub linear: Difference,
    /// Of the second order.
    pub quadratic: Difference,
    /// What they are differences to: the size of the errors themselves.
    pub errors: Difference,
    /// Linkages that were compared.
    pub compared: u64,
    /// Linkages that do not assemble in the mode of the nominal one.
    pub failed: u64,
}

impl Difference {
    /// Adds the square; the root is taken at the end.
    fn add(&mut self, difference: f64) {
        self.rms += difference * difference;
        self.greatest = self.greatest.max(difference.abs());
    }

    fn finish(&mut self, count: u64) {
        self.rms = (self.rms / count as f64).sqrt();
    }
}

/// The differences at every place of a study, over so many linkages.
///
/// # Errors
/// [`ToleranceError`] if the question makes no sense or the nominal linkage does not get to a place.
pub fn differences<L: Linkage>(
    linkage: &L,
    study: &Study,
    samples: u64,
    seed: u64,
) -> Result<Vec<Differences>, ToleranceError> {
    differences_of(linkage, study, samples, seed)
}

/// [`differences`] of a linkage behind a pointer.
pub(crate) fn differences_of(
    linkage: &dyn AnyLinkage,
    study: &Study,
    samples: u64,
    seed: u64,
) -> Result<Vec<Differences>, ToleranceError> {
    let forms = quadratics_of(linkage, study)?;
    let nominals = Nominal::along(linkage, &study.places, &study.sources)?;
    let mut all = vec![Differences::default(); study.places.len()];
    let mut found = vec![0.0; study.places.len()];
    let mut errors = vec![0.0; study.sources.len()];
    let mut random = Random::new(seed, 0);
    for _ in 0..samples {
        for (error, source) in errors.iter_mut().zip(&study.sources) {
            *error = source.half_width * source.distribution.quantile(random.uniform());
        }
        exact::errors(linkage, study, &nominals, &errors, &mut found);
        for ((one, form), error) in all.iter_mut().zip(&forms).zip(&found) {
            if error.is_nan() {
                one.failed += 1;
                continue;
            }
            one.compared += 1;
            one.linear.add(form.linear(&errors) - error);
            one.quadratic.add(form.error(&errors) - error);
            one.errors.add(*error);
        }
    }
    for one in &mut all {
        for difference in [&mut one.linear, &mut one.quadratic, &mut one.errors] {
            difference.finish(one.compared);
        }
    }
    Ok(all)
}
