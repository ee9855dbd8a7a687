//! The drawing of one block of samples.
//!
//! Errors are drawn and their first order is added up for a batch of samples at once, which the compiler packs; the
//! linkages are then closed one by one, and what they give is tallied for the whole batch.

use super::tally::{CLASSES, Classes, Sums};
use crate::closure::{AnyLinkage, Linkage};
use crate::dispatch::Task;
use crate::scalar::Scalar;
use crate::shape::Distribution;
use crate::tolerance::made::Maker;
use crate::tolerance::made::lead::Lead;
use crate::tolerance::made::nominal::Nominal;
use crate::tolerance::random::Random;
use crate::tolerance::source::Study;

/// Samples in a batch.
const BATCH: usize = 64;

/// The samples of a block.
#[derive(Clone, Debug)]
pub struct Block {
    pub(super) places: Vec<Sums>,
    /// Samples that assemble at all places.
    pub(super) whole: u64,
}

/// What all blocks have in common.
pub struct Run<'a> {
    pub(super) linkage: &'a dyn AnyLinkage,
    pub(super) nominals: &'a [Nominal],
    pub(super) study: &'a Study,
    pub(super) seed: u64,
    /// Of each place; none while they are not yet chosen.
    pub(super) classes: Vec<Classes>,
}

/// The drawing of one block.
pub(crate) struct Drawing<'a, 'b, L: Linkage> {
    pub run: &'a Run<'a>,
    /// The first sample, and the one behind the last.
    pub samples: (u64, u64),
    pub counts: &'b mut [u64],
    pub linkage: &'a L,
}

impl<L: Linkage> Task for Drawing<'_, '_, L> {
    type Output = Block;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Block {
        let (run, sources) = (self.run, &self.run.study.sources);
        let output = run.study.output;
        let mut maker = Maker::<L, S, BATCH>::new(self.linkage, run.nominals, sources, output);
        let mut closure = maker.nominal();
        let mut block = Block { places: vec![Sums::NONE; run.nominals.len()], whole: 0 };
        let mut errors = vec![[S::ZERO; BATCH]; sources.len()];
        let mut found = vec![[f64::NAN; BATCH]; run.nominals.len()];
        for first in (self.samples.0..self.samples.1).step_by(BATCH) {
            let count = BATCH.min((self.samples.1 - first) as usize);
            run.draw(first, &mut errors);
            maker.make(&errors);
            for sample in 0..count {
                maker.prepare(&mut closure, sample);
                let mut whole = true;
                for (place, found) in found.iter_mut().enumerate() {
                    let mut error = maker.error(&closure, place, sample).to_f64();
                    if !error.is_finite() {
                        error = run.lead(place, &errors, sample);
                        whole &= !error.is_nan();
                    }
                    found[sample] = error;
                }
                block.whole += u64::from(whole);
            }
            for (place, found) in found.iter().enumerate() {
                let found = &found[..count];
                block.places[place].add_all(found);
                if let Some(classes) = run.classes.get(place) {
                    classes.count(found, &mut self.counts[place * CLASSES..][..CLASSES]);
                }
            }
        }
        block
    }
}

impl Run<'_> {
    /// Draws the errors of the samples of a batch, source by source, so that each distribution is chosen once.
    #[inline(always)]
    fn draw<S: Scalar>(&self, first: u64, errors: &mut [[S; BATCH]]) {
        let sources = &self.study.sources;
        let stride = sources.len() as u64;
        let random = Random::new(self.seed, first.wrapping_mul(stride));
        for (k, (source, errors)) in sources.iter().zip(errors).enumerate() {
            /// Written out, so that what is known of the distribution is known to the compiler.
            macro_rules! draw {
                ($distribution:expr) => {
                    for (sample, error) in errors.iter_mut().enumerate() {
                        let share = random.ahead(sample as u64 * stride + k as u64);
                        let quantile = $distribution.quantile(share);
                        *error = S::from_f64(quantile * source.half_width);
                    }
                };
            }
            match source.distribution {
                Distribution::Uniform => draw!(Distribution::Uniform),
                Distribution::Normal => draw!(Distribution::Normal),
                Distribution::Truncated => draw!(Distribution::Truncated),
                Distribution::Lognormal { ratio } => draw!(Distribution::Lognormal { ratio }),
            }
        }
    }

    /// The careful way to a made linkage; no number if there is none.
    #[cold]
    #[inline(never)]
    fn lead<S: Scalar>(&self, place: usize, errors: &[[S; BATCH]], sample: usize) -> f64 {
        if !self.linkage.shape().loops().is_iterated() {
            return f64::NAN;
        }
        let errors: Vec<f64> = errors.iter().map(|one| one[sample].to_f64()).collect();
        let lead = Lead::new(self.linkage, self.study, &self.nominals[place]);
        lead.error(&errors).unwrap_or(f64::NAN)
    }
}
