//! The runs, and what they say together.

use assur::study::{self, Outcome, Spread};

use super::question::{Plan, Question};
use crate::error::Failure;
use crate::show::progress::Progress;

/// Shares for which quantiles are found.
pub const LEVELS: [f64; 5] = [0.01, 0.1, 0.5, 0.9, 0.99];
/// Probability that an interval contains what it is to contain.
pub const CONFIDENCE: f64 = 0.95;

/// All runs.
pub struct Answer {
    /// For each run what it came to.
    pub outcomes: Vec<Outcome>,
    /// For each measure that is asked for its values together, where they were made at random.
    pub spreads: Vec<Option<Spread>>,
    /// Seconds that it took.
    pub seconds: f64,
}

impl Answer {
    /// A measure of a run, SI units; NaN where it has none.
    pub fn value(&self, run: usize, measure: usize) -> f64 {
        let outcome = self.outcomes[run].as_ref().ok();
        let value = outcome.and_then(|all| all.get(measure)?.ok());
        value.unwrap_or(f64::NAN)
    }

    /// Runs that did not come out.
    pub fn failures(&self) -> usize {
        self.outcomes.iter().filter(|one| one.is_err()).count()
    }

    /// The first run that did not come out, with the reason.
    pub fn first_failure(&self) -> Option<(usize, &str)> {
        let mut runs = self.outcomes.iter().enumerate();
        runs.find_map(|(index, one)| Some((index, one.as_ref().err()?.as_str())))
    }
}

/// Does one run.
fn outcome(question: &Question, index: usize) -> Outcome {
    question.measures_with(&question.values(index))
}

/// Does all runs.
///
/// # Errors
/// When none of them comes out.
pub fn find(question: &Question) -> Result<Answer, Failure> {
    let count = question.count();
    let clock = std::time::Instant::now();
    let what = format!("{}, scene {}", question.constants.mechanism.name, question.scene.name);
    let progress = Progress::start(what, count as u64);
    let outcomes =
        study::each(count, question.threads, &|more| progress.advance_by(more), &|index| {
            outcome(question, index)
        });
    drop(progress);
    let mut answer =
        Answer { outcomes, spreads: Vec::new(), seconds: clock.elapsed().as_secs_f64() };
    if let (true, Some((_, reason))) = (answer.failures() == count, answer.first_failure()) {
        return Err(Failure::numerical(format!("none of {count} runs came out"))
            .reason(format!("the first: {reason}"))
            .remedy("run one of them with `assur run` and look at it"));
    }
    if let Plan::Random(..) = question.way {
        let spread = |measure: &usize| {
            let values: Vec<f64> = (0..count).map(|run| answer.value(run, *measure)).collect();
            study::spread(&values, CONFIDENCE, &LEVELS)
        };
        answer.spreads = question.measures.iter().map(spread).collect();
    }
    Ok(answer)
}
