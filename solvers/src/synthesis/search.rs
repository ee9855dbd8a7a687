//! The search of all designs between the bounds.

use super::crew::Crew;
use super::population::{LEAST, Population};
use super::problem::{Judge, Score, SynthesisError, check};
use std::ops::ControlFlow;

/// Designs of the first generation for each number that is sought.
const DESIGNS: usize = 18;
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
    let from = from.map(|population| population.check(sought).map(|()| population)).transpose()?;
    let population = std::thread::scope(|scope| {
        let crew = Crew::new(judge, effort.threads, scope);
        gone_on(&crew, (judge, effort, first), from, progress)
    });
    Ok(Found {
        design: population.design(0).to_vec(),
        score: population.scores[0],
        is_gathered: population.is_gathered(sought, GATHERED),
        population,
    })
}

/// The population that a search comes to, from one or from anywhere.
fn gone_on(
    crew: &Crew<'_>,
    (judge, effort, first): (&dyn Judge, &Effort, usize),
    from: Option<Population>,
    progress: &mut dyn FnMut(&Population) -> ControlFlow<()>,
) -> Population {
    let sought = judge.sought();
    let judged = |designs: &[f64], scores: &mut [Score]| crew.judge(designs, scores);
    let mut population = from.unwrap_or_else(|| {
        let mut population = Population::anywhere(sought, first, effort.seed);
        population.begin(judged);
        population
    });
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
    population
}
