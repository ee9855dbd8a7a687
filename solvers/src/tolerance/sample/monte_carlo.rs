//! Linkages made at random: what their errors are, and how many do not assemble.
//!
//! Blocks of samples go to whichever thread is free. The numbers of a sample depend on the seed and on its own number
//! alone, and sums are joined in the order of the blocks: the answer is the same, bit for bit, for any number of threads.

use super::drawing::{BATCH, Block, Blocks, Run};
use super::estimate::{Counted, Estimate, Sampled, share};
use super::tally::{CLASSES, Classes, Counts, Sums, cumulate};
use crate::closure::{AnyLinkage, Linkage};
use crate::threads;
use crate::tolerance::error::ToleranceError;
use crate::tolerance::made::nominal::Nominal;
use crate::tolerance::random::normal;
use crate::tolerance::source::Study;
use std::sync::Mutex;

/// Fewest samples: one has no spread.
const LEAST: u64 = 2;
/// Most samples: hours.
const MOST: u64 = 100_000_000_000;
/// Smallest block, and the largest that is not for the sake of their number.
const BLOCK: (u64, u64) = (256, 4096);
/// Blocks that are enough for threads to end at about the same time.
const SHARES: u64 = 64;
/// Largest number of blocks.
const BLOCKS: u64 = 4096;
/// Samples from which the classes are chosen: a part of all, within bounds.
const PILOT: (u64, u64, u64) = (32, 256, 1024);

/// How samples are drawn and what is made of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    /// Number of samples.
    pub samples: u64,
    /// Which samples: the same seed gives the same ones.
    pub seed: u64,
    /// Number of threads; zero for as many as the machine has.
    pub threads: usize,
    /// Probability that an interval contains what it is to contain.
    pub confidence: f64,
    /// Shares for which quantiles are wanted.
    pub levels: Vec<f64>,
}

impl Default for Sampling {
    /// A hundred thousand samples, intervals of 95 %, quantiles at ±2 and ±3 standard deviations of a normal
    /// distribution.
    fn default() -> Self {
        Self {
            samples: 100_000,
            seed: 1,
            threads: 0,
            confidence: 0.95,
            levels: vec![0.001_35, 0.022_75, 0.5, 0.977_25, 0.998_65],
        }
    }
}

/// What the samples say along the places.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarlo {
    /// At each place.
    pub places: Vec<Sampled>,
    /// Share of linkages that fail to assemble at one place or another.
    pub failures: Estimate,
}

/// Makes linkages at random and looks at the errors of an output at every place. `progress` hears how many samples more
/// are done.
///
/// # Errors
/// [`ToleranceError`] if the question makes no sense, or if the nominal linkage does not get to a place. Samples that do
/// not assemble are no error: they are counted.
pub fn monte_carlo<L: Linkage>(
    linkage: &L,
    study: &Study,
    sampling: &Sampling,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<MonteCarlo, ToleranceError> {
    monte_carlo_of(linkage, study, sampling, progress)
}

/// [`monte_carlo`] of a linkage behind a pointer.
pub(crate) fn monte_carlo_of(
    linkage: &dyn AnyLinkage,
    study: &Study,
    sampling: &Sampling,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<MonteCarlo, ToleranceError> {
    study.check(linkage.shape())?;
    sampling.check()?;
    let nominals = Nominal::along(linkage, &study.places, &study.sources)?;
    let mut run =
        Run { linkage, nominals: &nominals, study, seed: sampling.seed, classes: Vec::new() };
    let pilot = Blocks::new(sampling.pilot(), sampling.pilot(), &|_| ());
    for (_, block) in linkage.draw(&run, &pilot, &mut []) {
        run.classes = block.places.iter().map(|one| Classes::around(one.extremes)).collect();
    }
    let (blocks, counts) = run.all(sampling, progress);
    Ok(run.judge(sampling, &blocks, counts))
}

impl Sampling {
    fn check(&self) -> Result<(), ToleranceError> {
        if !(LEAST..=MOST).contains(&self.samples) {
            return Err(ToleranceError::BadSamples {
                samples: self.samples,
                least: LEAST,
                most: MOST,
            });
        }
        for &level in self.levels.iter().chain([&self.confidence]) {
            if !(level > 0.0 && level < 1.0) {
                return Err(ToleranceError::BadLevel { level });
            }
        }
        Ok(())
    }

    /// How many samples are drawn to choose the classes.
    fn pilot(&self) -> u64 {
        let (part, least, most) = PILOT;
        self.samples.min((self.samples / part).clamp(least, most))
    }

    /// How many samples are drawn together: whole batches.
    fn block(&self) -> u64 {
        let (least, most) = BLOCK;
        let shared = self.samples.div_ceil(SHARES).next_multiple_of(BATCH as u64);
        shared.clamp(least, most).max(self.samples.div_ceil(BLOCKS))
    }

    fn threads(&self, blocks: u64) -> u64 {
        (threads::count(self.threads) as u64).clamp(1, blocks)
    }
}

impl Run<'_> {
    /// Draws all blocks. Gives them in their order, and the classes counted.
    fn all(
        &self,
        sampling: &Sampling,
        progress: &(dyn Fn(u64) + Sync),
    ) -> (Vec<Block>, Vec<Counts>) {
        let blocks = Blocks::new(sampling.samples, sampling.block(), progress);
        let threads = sampling.threads(blocks.count());
        let gathered = Mutex::new((Vec::new(), Vec::<Counts>::new()));
        let work = || {
            let mut counts = vec![[0; CLASSES]; self.nominals.len()];
            let done = self.linkage.draw(self, &blocks, &mut counts);
            let mut all = gathered.lock().unwrap_or_else(|poison| poison.into_inner());
            all.0.extend(done);
            if all.1.is_empty() {
                all.1 = counts;
                return;
            }
            for (sum, count) in all.1.as_flattened_mut().iter_mut().zip(counts.as_flattened()) {
                *sum += count;
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..threads {
                scope.spawn(work);
            }
            work();
        });
        let (mut blocks, counts) =
            gathered.into_inner().unwrap_or_else(|poison| poison.into_inner());
        blocks.sort_by_key(|(index, _)| *index);
        (blocks.into_iter().map(|(_, block)| block).collect(), counts)
    }

    fn judge(&self, sampling: &Sampling, blocks: &[Block], mut counts: Vec<Counts>) -> MonteCarlo {
        counts.iter_mut().for_each(|counts| cumulate(counts));
        let place = |(index, nominal): (usize, &Nominal)| {
            let mut sums = Sums::NONE;
            for block in blocks {
                sums.join(&block.places[index]);
            }
            let counted = Counted {
                value: nominal.outputs[self.study.output],
                drawn: sampling.samples,
                sums: &sums,
                classes: &self.classes[index],
                up_to: &counts[index],
            };
            counted.judge(sampling.confidence, &sampling.levels)
        };
        let whole: u64 = blocks.iter().map(|block| block.whole).sum();
        let z = normal::quantile(0.5 + 0.5 * sampling.confidence);
        MonteCarlo {
            places: self.nominals.iter().enumerate().map(place).collect(),
            failures: share(sampling.samples - whole, sampling.samples, z),
        }
    }
}
