//! Whether what is told of errors can be trusted: beside each, what the number really errs by.

use std::sync::Arc;
use std::time::{Duration, Instant};

use assur_solvers::answer::{Estimate, Motion, Question, Settings};
use assur_solvers::model::Model;
use assur_solvers::problem::Span;
use assur_solvers::shape::Subject;

use super::cost::references;

/// Samples of a task.
const SAMPLES: usize = 360;
/// So many times better than a number the reference is to be known.
const KNOWN: f64 = 10.0;

/// What is told of a number, and what is true; SI units.
#[derive(Clone, Debug)]
pub struct Told {
    /// The relative tolerance at which it was found.
    pub rtol: f64,
    /// Its place among states, outputs and measures, one behind the other.
    pub place: usize,
    /// What it may err by; of what moves the largest over the task.
    pub told: f64,
    /// What it errs by, likewise.
    pub real: f64,
}

/// What is told of a task.
#[derive(Clone, Debug, Default)]
pub struct Trust {
    /// All numbers whose errors are known.
    pub numbers: Vec<Told>,
    /// What could not be compared, and why.
    pub missing: Vec<String>,
}

/// Solves a task at some settings and compares what is told of each state, output and measure with its difference from a reference
/// at the limit of double precision. Numbers of which the reference is not known ten times better do not count. Nothing for what
/// does not move. After a time nothing more is begun.
///
/// # Errors
/// Why there is no reference.
pub fn trust(
    model: &Arc<dyn Model>,
    settings: &[Settings],
    patience: Duration,
) -> Result<Trust, String> {
    let mut found = Trust::default();
    let shape = model.shape();
    let moves = matches!(model.span(), Span::Periodic(_) | Span::Autonomous | Span::Run(..));
    if shape.states.is_empty() || !moves {
        return Ok(found);
    }
    let clock = Instant::now();
    let (first, second) = &references(model)?;
    let states = (0..shape.states.len()).map(Subject::State);
    let subjects: Vec<_> = states.chain((0..shape.outputs.len()).map(Subject::Output)).collect();
    let (from, to) = first.task().limits();
    let time = |sample: usize| from + (to - from) * sample as f64 / SAMPLES as f64;
    let times: Vec<f64> = (0..=SAMPLES).map(time).collect();
    let errors = |estimate: &Estimate, motion: &Motion| {
        let moving = estimate.largest(motion, &subjects, &times);
        [moving, estimate.measures(motion, &motion.measures())].concat()
    };
    let against = Estimate::against(first);
    let doubt = errors(&against, second);
    for settings in settings {
        if clock.elapsed() > patience {
            found.missing.push(format!("{settings}: not tried, as it takes too long"));
            continue;
        }
        let answer = Question::of(model.clone()).solve(settings);
        let answer = answer.and_then(|motion| Ok((motion.estimate()?, motion)));
        let (estimate, motion) = match answer {
            Ok(answer) => answer,
            // What does not come out is an error that is told.
            Err(error) => {
                found.missing.push(format!("{settings}: {error}"));
                continue;
            }
        };
        if !motion.is_like(first) {
            found.missing.push(format!("{settings}: it takes another course"));
            continue;
        }
        let pairs = errors(&estimate, &motion).into_iter().zip(errors(&against, &motion));
        for (place, ((told, real), doubt)) in pairs.zip(&doubt).enumerate() {
            if real > KNOWN * doubt && told.is_finite() {
                found.numbers.push(Told { rtol: settings.rtol, place, told, real });
            }
        }
    }
    Ok(found)
}
