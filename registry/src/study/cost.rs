//! What accuracy costs: one task by each method at each tolerance, what each takes and by how much it errs.
//!
//! Errors are differences from a reference far below them. How well that is known is what it differs by from the nearest
//! solution by another method, a second reference or one of those that are tried. Times are those of whole solutions,
//! repeated and interleaved, so that whatever else the machine does falls on all of them alike.

mod made;
mod times;

pub use made::{Found, Made, Trial as MadeTrial, Way, made};
pub use times::{Times, front};

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use assur_solvers::answer::{Error, Estimate, Method, Motion, Question, Settings};
use assur_solvers::model::Model;
use assur_solvers::problem::Span;
use assur_solvers::shape::Subject;
use times::in_turns;

/// Methods that are asked for the reference, and their tolerances: the first two that answer count.
const EXACT: [(Method, f64); 4] = [
    (Method::Taylor, 1e-14),
    (Method::Dop853, 1e-14),
    (Method::Radau, 1e-13),
    (Method::Rosenbrock, 1e-11),
];
/// Instants of the task at which errors are looked at.
const INSTANTS: usize = 240;
/// [`Estimate::largest`] looks at one of so many samples.
const THINNED: usize = 3;

/// What is tried.
#[derive(Clone, Debug)]
pub struct Look<'a> {
    /// The settings of each trial.
    pub settings: &'a [Settings],
    /// What is looked at.
    pub subjects: &'a [Subject],
    /// Seconds that the times may take together.
    pub seconds: f64,
}

/// What a way to solve the task takes and gives.
#[derive(Clone, Debug)]
pub struct Work {
    /// How long it takes.
    pub times: Times,
    /// Steps.
    pub steps: usize,
    /// Evaluations of the rates.
    pub evaluations: usize,
    /// The largest error of each subject over the task, SI units.
    pub errors: Vec<f64>,
    /// The error of each measure, SI units; NaN of what the run does not have.
    pub measures: Vec<f64>,
}

/// One way to solve the task.
#[derive(Clone, Debug)]
pub struct Trial {
    /// Method and tolerance.
    pub settings: Settings,
    /// What it takes and gives, or why nothing comes of it.
    pub outcome: Result<Work, String>,
}

/// All of it.
#[derive(Clone, Debug)]
pub struct Costs {
    /// The settings of the reference.
    pub reference: Settings,
    /// Those of the second one.
    pub second: Settings,
    /// By how much the reference differs from the nearest solution by another method: each subject and each measure.
    pub doubt: (Vec<f64>, Vec<f64>),
    /// The largest modulus of each subject over the task, and of each measure, SI units.
    pub sizes: (Vec<f64>, Vec<f64>),
    /// What was tried, in its order.
    pub trials: Vec<Trial>,
    /// Rounds of times.
    pub rounds: usize,
}

/// Finds what accuracy costs. `progress` hears of each solution; it says whether to go on, and what is not timed any more is
/// left out.
///
/// # Errors
/// Why there is no reference.
pub fn cost(
    model: &Arc<dyn Model>,
    look: &Look<'_>,
    progress: &dyn Fn() -> bool,
) -> Result<Costs, String> {
    let solve = |settings: &Settings| Question::of(model.clone()).solve(settings);
    if model.span() == Span::Open {
        return Err(Error::NoTask.to_string());
    }
    let (exact, second) = references(model)?;
    let against = Estimate::against(&exact);
    let (from, to) = exact.task().limits();
    let parts = INSTANTS * THINNED;
    let times: Vec<f64> =
        (0..=parts).map(|part| from + (to - from) * part as f64 / parts as f64).collect();
    let measures = exact.measures();
    let errors = |motion: &Motion| {
        let measured = motion.measures();
        (against.largest(motion, look.subjects, &times), against.measures(motion, &measured))
    };
    let mut sizes = vec![0.0; look.subjects.len()];
    for time in times.iter().step_by(THINNED) {
        let here = exact.values(look.subjects, *time);
        for (size, value) in sizes.iter_mut().zip(here) {
            *size = f64::max(*size, value.abs());
        }
    }
    let (mut trials, mut first) = (Vec::new(), Vec::new());
    for settings in look.settings {
        let clock = Instant::now();
        let solved = solve(settings);
        first.push(clock.elapsed().as_secs_f64());
        let outcome = solved.map_err(|error| error.to_string()).and_then(|motion| {
            if !motion.is_like(&exact) {
                return Err(other_course(&motion, &exact));
            }
            let (errors, measures) = errors(&motion);
            let statistics = motion.statistics();
            Ok(Work {
                times: Times { median: f64::NAN, quartiles: (f64::NAN, f64::NAN) },
                steps: statistics.steps,
                evaluations: statistics.evaluations,
                errors,
                measures,
            })
        });
        trials.push(Trial { settings: settings.clone(), outcome });
        if !progress() {
            break;
        }
    }
    let again = |index: usize| {
        if trials[index].outcome.is_ok() {
            let _ = black_box(solve(&trials[index].settings));
        }
    };
    let (times, rounds) = in_turns(&first, look.seconds, &again, progress);
    for (trial, times) in trials.iter_mut().zip(times) {
        if let Ok(work) = &mut trial.outcome {
            work.times = times;
        }
    }
    let mut doubt = errors(&second);
    for trial in trials.iter().filter(|trial| trial.settings.method != exact.settings.method) {
        if let Ok(work) = &trial.outcome {
            let pairs = doubt.0.iter_mut().zip(&work.errors);
            for (least, error) in pairs.chain(doubt.1.iter_mut().zip(&work.measures)) {
                *least = least.min(*error);
            }
        }
    }
    Ok(Costs {
        reference: exact.settings.clone(),
        second: second.settings.clone(),
        doubt,
        sizes: (sizes, measures.iter().map(|one| one.map_or(f64::NAN, f64::abs)).collect()),
        trials,
        rounds,
    })
}

/// Two solutions of the task at the limit of double precision, by different methods: by what they differ they are not known.
///
/// # Errors
/// Why there are no two.
pub fn references(model: &Arc<dyn Model>) -> Result<(Motion, Motion), String> {
    let mut found: Vec<Motion> = Vec::new();
    let mut failed = None;
    for (method, rtol) in EXACT {
        let settings = Settings::new(method).rtol(rtol);
        match Question::of(model.clone()).solve(&settings) {
            Ok(motion) if found.first().is_none_or(|first| first.is_like(&motion)) => {
                found.push(motion);
            }
            Ok(motion) => failed = Some(other_course(&motion, &found[0])),
            Err(error) => failed = Some(error.to_string()),
        }
        if let [_, _] = found[..] {
            break;
        }
    }
    let mut found = found.into_iter();
    match (found.next(), found.next()) {
        (Some(first), Some(second)) => Ok((first, second)),
        _ => Err(failed.unwrap_or_default()),
    }
}

/// That a motion takes another course than the reference.
fn other_course(motion: &Motion, exact: &Motion) -> String {
    match (motion.events().len(), exact.events().len()) {
        (own, known) if own != known => format!("{own} events happen in it instead of {known}"),
        _ => format!(
            "it repeats after {} periods instead of {}",
            motion.multiple(),
            exact.multiple()
        ),
    }
}

impl Costs {
    /// The trials that nothing cheaper is better than, by a number of each; the cheapest first.
    pub fn front(&self, error: impl Fn(&Work) -> f64) -> Vec<usize> {
        front(self.trials.iter().map(|trial| match &trial.outcome {
            Ok(work) => (work.times.median, error(work)),
            Err(_) => (f64::NAN, f64::NAN),
        }))
    }
}
