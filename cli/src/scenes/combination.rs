//! One combination of effects and choices, over all values of a range: what its outputs and measures come to.

use std::time::Instant;

use assur::answer::{Motion, Question, Settings};
use assur::closure::{ClosureError, Sample};
use assur::problem::Span;
use assur::registry::SceneEntry;
use assur::shape::{Quantity, Subject};

use crate::ask::constants::Constants;
use crate::ask::wanted::Difference;
use crate::error::Failure;
use crate::linkage;
use crate::linkage::line::Grid;
use crate::motion::case::Case;

/// Instants of a task at which outputs are compared.
const INSTANTS: usize = 720;
/// Differences below so many times what a motion is known by are none.
const KNOWN: f64 = 3.0;
/// Roundings of an output that nothing is integrated for, over its size.
const ROUNDING: f64 = 1e-12;

/// What a scene gives with certain values.
pub struct Given {
    /// Each output at each instant or place of the task, SI units.
    outputs: Vec<Vec<f64>>,
    /// The measures, SI units; NaN of what the run does not have.
    measures: Vec<f64>,
    /// Seconds of the whole answer: the motion, its outputs and measures.
    pub seconds: f64,
}

/// A combination.
pub struct Combination {
    /// Its scene.
    pub scene: &'static SceneEntry,
    /// What it gives with each value of the range, or why it gives nothing.
    pub given: Vec<Result<Given, Failure>>,
}

/// The one that the others are compared with.
pub struct Reference {
    /// Itself.
    pub combination: Combination,
    /// What is looked at: outputs, then measures.
    pub shown: Vec<Quantity>,
    /// For each value of the range by how much each quantity is known, and its size, SI units.
    known: Vec<Vec<(f64, f64)>>,
}

/// What a scene gives with these values.
///
/// # Errors
/// Why it gives nothing.
pub fn give(constants: Constants) -> Result<Given, Failure> {
    let clock = Instant::now();
    let scene = constants.scene;
    let mut given = match scene.linkage {
        Some(_) => places(&linkage::case::Case::new(constants)?)?,
        None => constants.going_on(|constants| {
            let case = Case::new(constants)?;
            let motion = case.solve(&Settings::default())?;
            Ok(along(scene, &motion))
        })?,
    };
    given.seconds = clock.elapsed().as_secs_f64();
    Ok(given)
}

/// The outputs of a motion.
fn along(scene: &SceneEntry, motion: &Motion) -> Given {
    let outputs: Vec<_> = (0..scene.outputs.len()).map(Subject::Output).collect();
    let rows = times(motion.task()).map(|time| motion.values(&outputs, time));
    let measures = motion.measures().into_iter().map(|one| one.unwrap_or(f64::NAN));
    Given { outputs: columns(outputs.len(), rows), measures: measures.collect(), seconds: f64::NAN }
}

fn times(task: Span) -> impl Iterator<Item = f64> {
    let (from, to) = task.limits();
    (0..=INSTANTS).map(move |index| from + (to - from) * index as f64 / INSTANTS as f64)
}

/// The outputs of a linkage.
fn places(case: &linkage::case::Case) -> Result<Given, Failure> {
    let told = |error: &ClosureError, what: &str| case.tell(error).failure(what);
    let lines = case.grid(&Grid::fine(case));
    let lines = lines.map_err(|error| told(&error, "the linkage cannot be put together"))?;
    if let Some(stop) = lines.iter().find_map(|line| line.stops.first()) {
        return Err(told(stop, "the linkage does not reach the whole task"));
    }
    // Where its extremes cannot be looked for, its positions are known all the same.
    let measures = case.measures().unwrap_or_default().into_iter().map(|one| one.value);
    let measures = measures.map(|value| value.unwrap_or(f64::NAN));
    let missing = std::iter::repeat_n(f64::NAN, case.scene.measures.len());
    let count = case.scene.outputs.len();
    let samples = lines.iter().flat_map(|line| &line.samples);
    let row = |sample: &Option<Sample>| match sample {
        Some(sample) => sample.outputs.clone(),
        None => vec![f64::NAN; count],
    };
    Ok(Given {
        outputs: columns(count, samples.map(row)),
        measures: measures.chain(missing).take(case.scene.measures.len()).collect(),
        seconds: f64::NAN,
    })
}

fn columns(count: usize, rows: impl Iterator<Item = Vec<f64>>) -> Vec<Vec<f64>> {
    let mut columns = vec![Vec::new(); count];
    for row in rows {
        for (column, value) in columns.iter_mut().zip(row) {
            column.push(value);
        }
    }
    columns
}

impl Combination {
    /// A quantity over the task with one value of the range: many numbers of an output, one of a measure.
    fn values(&self, name: &str, value: usize) -> Option<&[f64]> {
        let given = self.given[value].as_ref().ok()?;
        let place = |list: &[Quantity]| list.iter().position(|one| one.name == name);
        match place(self.scene.outputs) {
            Some(index) => given.outputs.get(index).map(Vec::as_slice),
            None => place(self.scene.measures)
                .and_then(|index| given.measures.get(index))
                .map(std::slice::from_ref),
        }
    }

    /// Whether it has a quantity.
    pub fn has(&self, name: &str) -> bool {
        self.scene.outputs.iter().chain(self.scene.measures).any(|one| one.name == name)
    }

    /// Seconds over all values of the range.
    pub fn seconds(&self) -> f64 {
        self.given.iter().map(|given| given.as_ref().map_or(f64::NAN, |one| one.seconds)).sum()
    }

    /// Why it gives nothing, somewhere in the range.
    pub fn failure(&self) -> Option<&Failure> {
        self.given.iter().find_map(|given| given.as_ref().err())
    }
}

/// The largest of differences of four things over the task, the one that is told last taken from the others in turn:
/// `(a - b) - (c - d)`. None where one of them lacks the quantity.
pub fn largest(of: [Option<&[f64]>; 4]) -> Option<f64> {
    let [a, b, c, d] = of;
    let (a, b, c, d) = (a?, b?, c?, d?);
    let all = a.iter().zip(b).zip(c.iter().zip(d));
    // Where nobody has a value nothing differs; where one of them has none they cannot be compared.
    let apart =
        |[a, b, c, d]: [f64; 4]| match [a, b, c, d].iter().filter(|one| one.is_nan()).count() {
            0 => ((a - b) - (c - d)).abs(),
            4 => 0.0,
            _ => f64::INFINITY,
        };
    (a.len() == b.len() && c.len() == d.len() && a.len() == c.len())
        .then(|| all.fold(0.0, |most, ((a, b), (c, d))| f64::max(most, apart([*a, *b, *c, *d]))))
}

impl Reference {
    /// The reference with what is known of it.
    ///
    /// # Errors
    /// That of the first value of the range with which it gives nothing.
    pub fn new(combination: Combination, all: &[Constants]) -> Result<Self, Failure> {
        let scene = combination.scene;
        let shown: Vec<Quantity> = scene.outputs.iter().chain(scene.measures).copied().collect();
        let mut known = Vec::new();
        for (value, constants) in all.iter().enumerate() {
            if let Err(failure) = &combination.given[value] {
                return Err(failure.clone());
            }
            let sizes = shown.iter().map(|one| {
                let values = combination.values(one.name, value).unwrap_or_default();
                values.iter().fold(0.0, |most: f64, one| most.max(one.abs()))
            });
            let sizes: Vec<f64> = sizes.collect();
            let errors = match scene.linkage {
                Some(_) => vec![0.0; shown.len()],
                None => errors(constants)?,
            };
            let floor =
                |(error, size): (f64, f64)| (f64::max(KNOWN * error, ROUNDING * size), size);
            known.push(errors.into_iter().zip(sizes).map(floor).collect());
        }
        Ok(Self { combination, shown, known })
    }

    /// By how much another one differs in a quantity with one value of the range. What it does not have is infinitely off.
    pub fn differs(&self, other: &Combination, index: usize, value: usize) -> Difference {
        let name = self.shown[index].name;
        let (own, theirs) = (self.combination.values(name, value), other.values(name, value));
        let apart = largest([own, theirs, own, own]);
        self.seen(apart.unwrap_or(f64::INFINITY), index, value)
    }

    /// Whether all values of a quantity that others have can be set beside its own.
    pub fn has_size(&self, index: usize) -> bool {
        self.known.iter().all(|known| known[index].1 > 0.0)
    }

    /// A difference of a quantity, none where it is not more than what is known.
    fn seen(&self, apart: f64, index: usize, value: usize) -> Difference {
        let (floor, size) = self.known[value][index];
        Difference {
            error: if apart > floor { apart } else { 0.0 },
            // Nothing over nothing is nothing.
            size: if apart > floor || size > 0.0 { size } else { f64::INFINITY },
        }
    }

    /// What the change from `b` to `a` does to a quantity, over its size here, less what that from `d` to `c` does; the
    /// largest over the range. None where one of them lacks it.
    pub fn share(&self, of: [&Combination; 4], index: usize) -> Option<f64> {
        let name = self.shown[index].name;
        let mut shares = (0..self.known.len()).map(|value| {
            let apart = largest(of.map(|one| one.values(name, value)))?;
            let Difference { error, size } = self.seen(apart, index, value);
            Some(error / size)
        });
        shares.try_fold(0.0, |most, share| Some(f64::max(most, share?)))
    }
}

/// By how much the outputs and measures of a motion are known.
fn errors(constants: &Constants) -> Result<Vec<f64>, Failure> {
    constants.clone().going_on(|constants| {
        let scene = constants.scene;
        let case = Case::new(constants)?;
        let motion = Question::of(case.model()).attempt(&Settings::default());
        let motion = motion.map_err(|error| case.unanswered(&error))?;
        let estimate = motion.estimate().map_err(|error| case.unanswered(&error))?;
        let outputs: Vec<_> = (0..scene.outputs.len()).map(Subject::Output).collect();
        let times: Vec<f64> = times(motion.task()).collect();
        let mut errors = estimate.largest(&motion, &outputs, &times);
        errors.extend(estimate.measures(&motion, &motion.measures()));
        Ok(errors)
    })
}
