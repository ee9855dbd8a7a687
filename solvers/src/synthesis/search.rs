//! The search of all designs between the bounds.

use super::population::{LEAST, Population};
use super::problem::{Judge, Score, SynthesisError, check};
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

/// Designs of the first generation for each number that is sought.
const DESIGNS: usize = 18;
/// Fewest and most designs that are judged together; packs of numbers divide them.
const BLOCK: (usize, usize) = (8, 64);
/// Blocks for each thread at least, where there are designs enough.
const BLOCKS: usize = 4;
/// A population whose designs differ by less, as a part of each range, has found what it can find.
const GATHERED: f64 = 1e-10;

/// How much is searched.
#[derive(Clone, Debug, PartialEq)]
pub struct Effort {
    /// Designs that may be judged.
    pub evaluations: u64,
    /// Which random numbers: the same seed finds the same design.
    pub seed: u64,
    /// Designs of the first generation; none for 18 for each number that is sought.
    pub population: Option<usize>,
    /// Number of threads; zero for as many as the machine has. The answer is the same for any.
    pub threads: usize,
}

impl Default for Effort {
    /// Two hundred thousand designs.
    fn default() -> Self {
        Self { evaluations: 200_000, seed: 1, population: None, threads: 0 }
    }
}

/// What a search has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The best design.
    pub design: Vec<f64>,
    /// What it is worth.
    pub score: Score,
    /// Whether all designs had come together at the end; if not, more evaluations may find better ones.
    pub is_gathered: bool,
    /// All of them, to go on with.
    pub population: Population,
}

/// Seeks the best design, from a population that another search has left or from anywhere. `progress` hears of each
/// generation and may end the search.
///
/// # Errors
/// [`SynthesisError`] if the problem makes no sense, or the population belongs to another one. That no design keeps all
/// conditions is no error: the score of the best one says by how much.
pub fn search(
    judge: &dyn Judge,
    effort: &Effort,
    from: Option<Population>,
    progress: &mut dyn FnMut(&Population) -> ControlFlow<()>,
) -> Result<Found, SynthesisError> {
    let sought = judge.sought();
    check(sought)?;
    let first = effort.population.unwrap_or(DESIGNS * sought.len());
    if first < LEAST {
        return Err(SynthesisError::BadPopulation { size: first, least: LEAST });
    }
    let judged = |designs: &[f64], scores: &mut [Score]| judge_all(judge, effort, designs, scores);
    let mut population = match from {
        Some(population) => {
            population.check(sought)?;
            population
        }
        None => {
            let mut population = Population::anywhere(sought, first, effort.seed);
            population.begin(judged);
            population
        }
    };
    let mut going = progress(&population);
    while going.is_continue()
        && population.evaluations < effort.evaluations
        && !population.is_gathered(sought, GATHERED)
    {
        let share = population.evaluations as f64 / effort.evaluations as f64;
        let keep = first as f64 + (LEAST as f64 - first as f64) * share.min(1.0);
        let keep = (keep.round() as usize).min(population.scores.len());
        population.advance(judge, (effort.seed, keep), judged);
        going = progress(&population);
    }
    Ok(Found {
        design: population.design(0).to_vec(),
        score: population.scores[0],
        is_gathered: population.is_gathered(sought, GATHERED),
        population,
    })
}

/// Judges designs in blocks; each goes to the thread that comes first.
fn judge_all(judge: &dyn Judge, effort: &Effort, designs: &[f64], scores: &mut [Score]) {
    let n = judge.sought().len();
    let machine = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let threads = if effort.threads == 0 { machine() } else { effort.threads };
    let threads = threads.min(scores.len().div_ceil(BLOCK.0)).max(1);
    let block = scores.len().div_ceil(BLOCKS * threads).clamp(BLOCK.0, BLOCK.1);
    let blocks = Mutex::new(designs.chunks(block * n).zip(scores.chunks_mut(block)));
    let work = || {
        loop {
            let taken = blocks.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some((designs, scores)) = taken else { break };
            judge.judge(designs, scores);
        }
    };
    if threads == 1 {
        return work();
    }
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
}
