//! How accurate a motion is. It is solved again with a tenth of the tolerance, and with ten times the tolerance.
//!
//! The error is proportional to the tolerance, or falls faster, so a solution with a tenth of it differs from the printed one by
//! nine tenths of the printed one's error or more. One with ten times the tolerance differs by nine times that error, or by much
//! more: a quarter of a ninth of the difference counts, lest the first two solutions agree by luck. The larger of both counts, twice
//! (`examples/accuracy.rs` compares it with what is true). Where double precision leaves no room for a tenth, or
//! where it takes too long, ten times the tolerance gives an upper bound instead, and a hundred times guards against luck.
//! Rounding is added as a floor.

use super::error::Error;
use super::motion::Motion;
use crate::hybrid;
use crate::measure::Missing;
use crate::ode::larger;
use crate::problem::Span;
use crate::rest::Rest;
use crate::settings::{Method, Settings};
use crate::shape::Subject;

/// The smallest relative tolerance: double precision leaves no room for less.
const SMALLEST: f64 = 1e-14;
/// Estimates are so many times what the solutions differ by.
const SAFETY: f64 = 2.0;
/// Roundings of a value.
pub(super) const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
/// The part of the difference from ten times the tolerance that counts beside that from a tenth, and from a hundred times beside
/// that from ten times.
const LUCK: f64 = 1.0 / 36.0;
/// The largest tolerance that it is asked for.
const COARSEST: f64 = 1e-2;
/// Steps that a tenth of the tolerance may take: so many times those of the printed solution, and so many more. Methods of order
/// five, the lowest that there are, take 1.6 times as many.
const MOST: (usize, usize) = (2, 200);
/// So many times as many steps are no more.
const MORE: f64 = 1.05;
/// The first step then, over that of the printed solution.
const FIRST: f64 = 0.4;
/// Steps on both sides of a place whose errors are errors of that place, so that no luck makes it look better.
const NEAR: usize = 2;
/// How much earlier or later an event may happen in another solution of the same motion, over the length of the task.
const LATE: f64 = 1e-3;
/// Places on both sides at which a motion may be instead, if its period is wrong.
const LATER: usize = 4;
/// Steps in which a motion without states is looked at once more.
const OTHER: usize = 110;
/// Places in each of them.
const PARTS: usize = 4;

/// Other solutions of the same task. What they are asked for is a list of subjects.
pub struct Estimate {
    pub(super) others: Vec<Other>,
    /// How many times the work of the printed solution ten times more accuracy takes; unknown at the limit of double
    /// precision.
    pub tenfold: Option<f64>,
    /// Whether a tenth of the tolerance takes too long, or does not come out.
    pub is_cut_off: bool,
}

pub(super) struct Other {
    pub(super) motion: Motion,
    /// What its difference from the printed solution is to be multiplied by.
    pub(super) share: f64,
}

impl Estimate {
    /// Solves the task again.
    pub(super) fn of(motion: &Motion) -> Result<Self, Error> {
        if motion.task() == Span::Open {
            return Ok(Self { others: Vec::new(), tenfold: None, is_cut_off: false });
        }
        if motion.shape().states.is_empty() {
            return Ok(Self {
                others: vec![in_other_steps(motion)],
                tenfold: None,
                is_cut_off: false,
            });
        }
        if let Some(rest) = motion.rest() {
            return Ok(Self { others: aside(motion, rest), tenfold: None, is_cut_off: false });
        }
        let (question, settings) = (&motion.question, &motion.settings);
        let rtol = settings.rtol;
        let finer = (rtol / 10.0 >= SMALLEST).then(|| finest(motion));
        let coarser = question.solve(&as_chosen(motion).at(10.0 * rtol));
        let is_cut_off = matches!(finer, Some(Err(_)));
        let (finer, coarser) = match (finer, coarser) {
            (Some(Err(_)) | None, Err(failure)) => return Err(failure),
            (finer, coarser) => (finer.and_then(Result::ok), coarser.ok()),
        };
        let own = motion.statistics().evaluations;
        let (finer, work) = finer.unzip();
        let tenfold = work.filter(|_| own > 0).map(|work| work as f64 / own as f64);
        let bound = if finer.is_some() { LUCK } else { 1.0 };
        let coarser = coarser.filter(|other| finer.is_none() || other.is_like(motion));
        let is_bare = finer.is_none() && 100.0 * rtol <= COARSEST;
        let coarsest = is_bare.then(|| question.solve(&as_chosen(motion).at(100.0 * rtol)).ok());
        let coarsest = coarsest.flatten().filter(|other| other.is_like(motion));
        let share =
            |motion: Option<Motion>, share: f64| motion.map(|motion| Other { motion, share });
        let others = [share(finer, 10.0 / 9.0), share(coarser, bound), share(coarsest, LUCK)];
        Ok(Self { others: others.into_iter().flatten().collect(), tenfold, is_cut_off })
    }

    /// What a motion differs by from another solution of the same task, which is so much better that it counts as exact.
    pub fn against(exact: &Motion) -> Self {
        let exact = Other { motion: exact.clone(), share: 1.0 / SAFETY };
        Self { others: vec![exact], tenfold: None, is_cut_off: false }
    }

    /// The error of a value for which the others have these.
    pub(super) fn differ(&self, value: f64, others: &[f64]) -> f64 {
        let pairs = self.others.iter().zip(others);
        let most = pairs.map(|(other, theirs)| (value - theirs).abs() * other.share);
        larger(SAFETY * most.fold(0.0, larger), ROUNDINGS * value.abs())
    }

    /// The errors of all variables at one time, but for times at which the solutions differ by an event.
    pub(super) fn exactly_at(
        &self,
        motion: &Motion,
        subjects: &[Subject],
        time: f64,
    ) -> Option<Vec<f64>> {
        let is_comparable = |other: &&Other| {
            !motion.is_beside_event(time) && !is_between(motion, &other.motion, time)
        };
        let like: Vec<&Other> = self.others.iter().filter(is_comparable).collect();
        if like.is_empty() && !self.others.is_empty() {
            return None;
        }
        let values = motion.values(subjects, time);
        let mut errors: Vec<f64> = values.iter().map(|one| ROUNDINGS * one.abs()).collect();
        for other in like {
            let theirs = other.motion.values(subjects, time);
            for ((error, a), b) in errors.iter_mut().zip(&values).zip(theirs) {
                *error = larger(*error, SAFETY * (a - b).abs() * other.share);
            }
        }
        Some(errors)
    }

    /// The errors of all variables at one time: the largest of the steps around it. Of a motion whose period is a result any
    /// number of periods may have passed: then it may be as much earlier or later as they are wrong together.
    pub fn at(&self, motion: &Motion, subjects: &[Subject], time: f64) -> Vec<f64> {
        let within = motion.task().reduce(time).unwrap_or(time);
        let mut errors = self.within(motion, subjects, within);
        let periods =
            motion.length().map_or(0.0, |length| ((time - within) / length).round().abs());
        let late = if periods > 0.0 { periods * self.period(motion) } else { 0.0 };
        if late > 0.0 {
            let here = motion.values(subjects, within);
            for part in (1..=LATER).flat_map(|part| [part as f64, -(part as f64)]) {
                // Where a period ends, angles begin anew.
                let (from, to) = motion.task().limits();
                let beside = (within + late * part / LATER as f64).clamp(from, to);
                let there = motion.values(subjects, beside);
                for ((error, here), there) in errors.iter_mut().zip(&here).zip(there) {
                    *error = larger(*error, (here - there).abs());
                }
            }
        }
        errors
    }

    /// The errors of all variables at a time of the task.
    fn within(&self, motion: &Motion, subjects: &[Subject], time: f64) -> Vec<f64> {
        let mut errors = match self.exactly_at(motion, subjects, time) {
            Some(errors) => errors,
            // Before or after an event: that is not known.
            None => self.jump(motion, subjects, time),
        };
        // The start of a run is given.
        if matches!(motion.task(), Span::Run(from, _) if from == time) {
            return errors;
        }
        for near in near(motion, time) {
            if motion.passed(near) != motion.passed(time) {
                continue;
            }
            for (error, here) in
                errors.iter_mut().zip(self.exactly_at(motion, subjects, near).into_iter().flatten())
            {
                *error = larger(*error, here);
            }
        }
        errors
    }

    fn jump(&self, motion: &Motion, subjects: &[Subject], time: f64) -> Vec<f64> {
        let theirs = self.others.iter();
        let theirs: Vec<_> = theirs.map(|other| other.motion.values(subjects, time)).collect();
        let values = motion.values(subjects, time).into_iter().enumerate();
        values
            .map(|(index, value)| {
                let apart = theirs.iter().map(|other| (value - other[index]).abs());
                apart.fold(0.0, larger)
            })
            .collect()
    }

    /// The largest error of each subject at samples of the task.
    pub fn largest(&self, motion: &Motion, subjects: &[Subject], times: &[f64]) -> Vec<f64> {
        let mut errors = vec![0.0; subjects.len()];
        // Every third sample is enough for a largest value.
        for time in times.iter().step_by(3) {
            let here = self.exactly_at(motion, subjects, *time);
            for (error, here) in errors.iter_mut().zip(here.into_iter().flatten()) {
                *error = larger(*error, here);
            }
        }
        errors
    }

    /// The error of the time after which the motion repeats; zero unless that is a result.
    pub fn period(&self, motion: &Motion) -> f64 {
        let others = self.others.iter().map(|other| other.motion.length());
        match (motion.length(), others.collect::<Option<Vec<_>>>()) {
            (Some(length), Some(others)) => self.differ(length, &others),
            _ => 0.0,
        }
    }

    /// The errors of the times of events; NaN where not all solutions have as many.
    pub fn events(&self, motion: &Motion) -> Vec<f64> {
        let events = motion.events();
        let others = self.others.iter().map(|other| other.motion.events());
        let others: Vec<_> = others.collect();
        let errors = events.iter().enumerate().map(|(index, event)| {
            if others.iter().any(|other| other.len() != events.len()) {
                return f64::NAN;
            }
            let theirs: Vec<_> = others.iter().map(|other| other[index].time).collect();
            self.differ(event.time, &theirs)
        });
        errors.collect()
    }

    /// The errors of the measures of a motion; NaN where a solution does not have one. What they are made of is rounded.
    pub fn measures(&self, motion: &Motion, measures: &[Result<f64, Missing>]) -> Vec<f64> {
        let rounded = motion.model().disturbed(&motion.path, ROUNDINGS);
        let others = self.others.iter();
        let others: Vec<_> = others.map(|other| other.motion.measures()).collect();
        let errors = measures.iter().enumerate().map(|(index, value)| {
            let theirs = others.iter().map(|other| other[index]);
            let theirs: Option<Vec<f64>> = theirs.map(Result::ok).collect();
            match (value, theirs) {
                (Ok(value), Some(theirs)) => larger(self.differ(*value, &theirs), rounded[index]),
                _ => f64::NAN,
            }
        });
        errors.collect()
    }
}

/// What moves with the time alone, looked at in other steps: nothing is integrated, but sums round.
fn in_other_steps(motion: &Motion) -> Other {
    let path = hybrid::Motion::without_states(motion.path.mode, motion.task().limits(), OTHER);
    Other { motion: Motion { path, ..motion.clone() }, share: 1.0 }
}

/// A position of rest with each of its numbers as far off as that may be; all of them together count.
fn aside(motion: &Motion, rest: &Rest) -> Vec<Other> {
    let disturbed = rest.disturbed();
    let share = 1.0 + rest.state.len() as f64;
    let other = |rest: Rest| {
        let path = hybrid::Motion::resting(motion.path.mode, rest);
        Other { motion: Motion { path, ..motion.clone() }, share }
    };
    disturbed.into_iter().map(other).collect()
}

/// The solution with a tenth of the tolerance, and the evaluations that it takes. Where its steps are as many, something else
/// determines them, the places of a table for instance, and both err alike: then one with ever less of it, until they are more.
fn finest(motion: &Motion) -> Result<(Motion, usize), Error> {
    let tried = |motion: &Motion| motion.statistics().steps + motion.statistics().rejected;
    let enough = MORE * tried(motion) as f64;
    let mut part = 0.1;
    let mut found = motion.question.solve(&finer(motion, part))?;
    let work = found.statistics().evaluations;
    // A series of higher order takes as many.
    let is_fixed = |found: &Motion| tried(found) as f64 <= enough && !is_by_series(found);
    while is_fixed(&found) && part / 100.0 * motion.settings.rtol >= SMALLEST {
        part /= 100.0;
        let Ok(next) = motion.question.solve(&finer(motion, part)) else { break };
        found = next;
    }
    Ok((found, work))
}

/// Whether most of a motion comes from its Taylor series.
fn is_by_series(motion: &Motion) -> bool {
    let statistics = motion.statistics();
    2 * statistics.series_steps > statistics.steps
}

/// The settings of a motion: where it was chosen to take the series, another tolerance is not to choose anything else. A looser
/// one would have much larger errors, and a finer one would begin with the very steps that the choice was made by.
fn as_chosen(motion: &Motion) -> Settings {
    match is_by_series(motion) {
        true => Settings { method: Method::Taylor, ..motion.settings.clone() },
        false => motion.settings.clone(),
    }
}

/// The settings for a part of the tolerance: so much work at most, and of a run a first step of its own.
fn finer(motion: &Motion, part: f64) -> Settings {
    let rtol = motion.settings.rtol * part;
    let Span::Run(..) = motion.task() else {
        return motion.settings.at(rtol);
    };
    let statistics = motion.statistics();
    let steps = motion.steps();
    Settings {
        max_steps: Some(MOST.0 * (statistics.steps + statistics.rejected) + MOST.1),
        // Else the first steps, which do not grow any faster, would be the same whatever the tolerance.
        first_step: steps.get(..2).map(|steps| FIRST * (steps[1] - steps[0])),
        ..as_chosen(motion).at(rtol)
    }
}

/// Whether a time lies between the times at which two solutions have an event, which are not far apart: there they differ by a
/// jump.
fn is_between(a: &Motion, b: &Motion, time: f64) -> bool {
    let passed = (a.passed(time), b.passed(time));
    let next = usize::min(passed.0, passed.1);
    let (from, to) = a.task().limits();
    match (a.events().get(next), b.events().get(next)) {
        _ if passed.0 == passed.1 => false,
        (Some(a), Some(b)) => (a.time - b.time).abs() < LATE * (to - from),
        _ => false,
    }
}

/// Times in the steps around a time.
pub(super) fn near(motion: &Motion, time: f64) -> Vec<f64> {
    let steps = motion.steps();
    let after = steps.partition_point(|step| *step <= time);
    let last = steps.len().saturating_sub(1);
    let around = &steps[after.saturating_sub(NEAR + 1).min(last)..(after + NEAR).min(steps.len())];
    let part = |step: &[f64], part: usize| {
        step[0] + (step[1] - step[0]) * (part as f64 + 0.5) / PARTS as f64
    };
    let parts = around
        .windows(2)
        .flat_map(|step| (0..PARTS).map(|index| part(step, index)).collect::<Vec<_>>());
    parts.collect()
}
