//! The drawing of blocks of samples by one thread.
//!
//! Errors are drawn and their first order is added up for a batch of samples at once; the linkages are then closed some side
//! by side, and what they give is tallied for the whole batch.

use super::tally::{Classes, Counts, Sums};
use crate::closure::{AnyLinkage, Linkage};
use crate::dispatch::Task;
use crate::scalar::Pack;
use crate::shape::Distribution;
use crate::tolerance::made::Maker;
use crate::tolerance::made::lead::Lead;
use crate::tolerance::made::nominal::Nominal;
use crate::tolerance::random::Random;
use crate::tolerance::source::Study;
use std::sync::atomic::{AtomicU64, Ordering};

/// Samples in a batch.
pub(super) const BATCH: usize = 64;

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

/// Blocks that wait: each is drawn by the thread that comes first.
pub struct Blocks<'a> {
    samples: u64,
    size: u64,
    next: AtomicU64,
    /// Hears how many samples more are drawn.
    progress: &'a (dyn Fn(u64) + Sync),
}

impl<'a> Blocks<'a> {
    pub fn new(samples: u64, size: u64, progress: &'a (dyn Fn(u64) + Sync)) -> Self {
        Self { samples, size, next: AtomicU64::new(0), progress }
    }

    /// How many there are in all.
    pub fn count(&self) -> u64 {
        self.samples.div_ceil(self.size)
    }

    /// The index of the next one, its first sample, and the one behind its last.
    fn take(&self) -> Option<(u64, u64, u64)> {
        let index = self.next.fetch_add(1, Ordering::Relaxed);
        let first = index.checked_mul(self.size).filter(|first| *first < self.samples)?;
        Some((index, first, self.samples.min(first + self.size)))
    }
}

/// The drawing of blocks by one thread, until none waits; each comes with its index.
pub(crate) struct Drawing<'a, 'b, L: Linkage> {
    pub run: &'a Run<'a>,
    pub blocks: &'a Blocks<'a>,
    /// Of each place.
    pub counts: &'b mut [Counts],
    pub linkage: &'a L,
}

impl<L: Linkage> Task for Drawing<'_, '_, L> {
    type Output = Vec<(u64, Block)>;

    #[inline(always)]
    fn run<P: Pack>(self) -> Vec<(u64, Block)> {
        let (run, sources) = (self.run, &self.run.study.sources);
        let output = run.study.output;
        let mut maker = Maker::<L, P>::new(self.linkage, run.nominals, sources, output);
        let mut closure = maker.nominal();
        let mut errors = vec![[0.0; BATCH]; sources.len()];
        let mut pack = vec![P::ZERO; sources.len()];
        let mut found = vec![[f64::NAN; BATCH]; run.nominals.len()];
        let mut done = Vec::new();
        while let Some((index, from, to)) = self.blocks.take() {
            let mut block = Block { places: vec![Sums::NONE; run.nominals.len()], whole: 0 };
            for first in (from..to).step_by(BATCH) {
                let count = BATCH.min((to - first) as usize);
                run.draw(first, &mut errors);
                let mut whole = [true; BATCH];
                for from in (0..count).step_by(P::WIDTH) {
                    for (pack, errors) in pack.iter_mut().zip(&errors) {
                        *pack = P::load(&errors[from..]);
                    }
                    maker.prepare(&mut closure, &pack);
                    for (place, found) in found.iter_mut().enumerate() {
                        let found = &mut found[from..][..P::WIDTH];
                        maker.error(&closure, place, &pack).store(found);
                        for (lane, error) in found.iter_mut().enumerate() {
                            if !error.is_finite() {
                                let sample = from + lane;
                                *error = run.lead(place, &errors, sample);
                                whole[sample] &= !error.is_nan();
                            }
                        }
                    }
                }
                block.whole += whole[..count].iter().filter(|whole| **whole).count() as u64;
                for (place, found) in found.iter_mut().enumerate() {
                    found[count..].fill(f64::NAN);
                    block.places[place].add_all::<P>(found);
                    if let Some(classes) = run.classes.get(place) {
                        classes.count::<P>(found, &mut self.counts[place]);
                    }
                }
            }
            done.push((index, block));
            (self.blocks.progress)(to - from);
        }
        done
    }
}

impl Run<'_> {
    /// Draws the errors of the samples of a batch, source by source, so that each distribution is chosen once.
    #[inline(always)]
    fn draw(&self, first: u64, errors: &mut [[f64; BATCH]]) {
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
                        *error = quantile * source.half_width;
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
    fn lead(&self, place: usize, errors: &[[f64; BATCH]], sample: usize) -> f64 {
        if !self.linkage.shape().loops().is_iterated() {
            return f64::NAN;
        }
        let errors: Vec<f64> = errors.iter().map(|one| one[sample]).collect();
        let lead = Lead::new(self.linkage, self.study, &self.nominals[place]);
        lead.error(&errors).unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closure::tests::linkages::SixBar;
    use crate::dispatch::{dispatch, dispatch_packs};
    use crate::tolerance::made::exact;
    use crate::tolerance::source::Source;
    use crate::tolerance::tests::{Heald, study};

    /// So many samples that they do not fill the last block, nor its last pack.
    const SAMPLES: u64 = 1003;

    /// What is drawn in blocks of a size, single or in packs, and the run.
    fn drawn<L: Linkage>(run: &Run<'_>, linkage: &L, size: u64, packs: bool) -> Vec<Block> {
        let blocks = Blocks::new(SAMPLES, size, &|_| ());
        let drawing = Drawing { run, blocks: &blocks, counts: &mut [], linkage };
        let drawn = if packs { dispatch_packs(drawing) } else { dispatch(drawing) };
        assert_eq!(drawn.len() as u64, blocks.count());
        drawn.into_iter().map(|(_, block)| block).collect()
    }

    fn run<'a>(linkage: &'a dyn AnyLinkage, nominals: &'a [Nominal], study: &'a Study) -> Run<'a> {
        Run { linkage, nominals, study, seed: 7, classes: Vec::new() }
    }

    /// Of a linkage that is iterated.
    #[test]
    fn packs_draw_what_single_numbers_draw() {
        let (heald, study) =
            (Heald::default(), study(&[70.0, 90.0], 10.0, Distribution::Truncated));
        let nominals = Nominal::along(&heald, &study.places, &study.sources).expect("it closes");
        let run = run(&heald, &nominals, &study);
        let [single, packed] = [false, true].map(|packs| drawn(&run, &heald, 256, packs));
        for (one, other) in single.iter().zip(&packed) {
            assert_eq!(one.whole, other.whole);
            for (one, other) in one.places.iter().zip(&other.places) {
                assert_eq!(one.count, other.count);
                for (one, other) in one.powers.iter().zip(other.powers) {
                    assert!((one - other).abs() <= 1e-6 * one.abs(), "{one} {other}");
                }
            }
        }
        assert_eq!(single.iter().map(|block| block.places[0].count).sum::<u64>(), SAMPLES);
    }

    /// Of a linkage in closed form, eight samples by eight: errors from the small to those that turn it far or leave it open,
    /// beside each linkage put together by itself.
    #[test]
    fn packs_draw_what_is_put_together() {
        let six_bar = SixBar::default();
        let mut missing = 0;
        for (half_width, output) in [(1e-5, 2), (1e-3, 3), (2e-2, 1)] {
            let source = |variable| {
                let distribution = Distribution::Uniform;
                Source { variable, half_width, distribution }
            };
            let places = (0..6).map(|k| vec![0.2 + k as f64]).collect();
            let study = Study { output, places, sources: (0..10).map(source).collect() };
            let nominals =
                Nominal::along(&six_bar, &study.places, &study.sources).expect("it closes");
            let run = run(&six_bar, &nominals, &study);
            for (index, block) in drawn(&run, &six_bar, 8, true).iter().enumerate() {
                let (from, mut errors) = (8 * index as u64, vec![[0.0; BATCH]; 10]);
                run.draw(from, &mut errors);
                let mut expected = vec![Sums::NONE; nominals.len()];
                for sample in 0..8.min(SAMPLES - from) as usize {
                    let errors: Vec<f64> = errors.iter().map(|one| one[sample]).collect();
                    let mut found = vec![0.0; nominals.len()];
                    exact::errors(&six_bar, &study, &nominals, &errors, &mut found);
                    missing += found.iter().filter(|error| error.is_nan()).count();
                    for (sums, error) in expected.iter_mut().zip(found) {
                        sums.add_all::<f64>(&[error]);
                    }
                }
                for (found, expected) in block.places.iter().zip(&expected) {
                    check(found, expected);
                }
            }
        }
        assert!(missing > 100, "{missing}");
    }

    /// The sums of eight errors, each as large as the angles round.
    fn check(found: &Sums, expected: &Sums) {
        const ROUNDING: f64 = 1e-13;
        assert_eq!(found.count, expected.count);
        let (low, high) = expected.extremes;
        assert!((found.extremes.0 - low).abs() <= ROUNDING || expected.count == 0);
        assert!((found.extremes.1 - high).abs() <= ROUNDING || expected.count == 0);
        let largest = f64::max(high, -low);
        for (power, (one, other)) in (0..).zip(found.powers.iter().zip(expected.powers)) {
            let share = 8.0 * f64::from(power + 1) * largest.powi(power);
            assert!(
                (one - other).abs() <= share * ROUNDING || expected.count == 0,
                "{one} {other}"
            );
        }
    }
}
