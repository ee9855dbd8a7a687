//! How accurate a motion is. It is solved again with a tenth of the tolerance, and with ten times the tolerance.
//!
//! The error is proportional to the tolerance, so a solution with a tenth of it differs from the printed one by nine tenths
//! of the printed one's error, and one with ten times the tolerance by nine times that error. The larger of both counts,
//! twice: two solutions may agree by luck, three of them hardly do. Where double precision leaves no room for a tenth, or
//! where it takes too long, ten times the tolerance gives an upper bound instead. Rounding is added as a floor.

use assur::measure::{Extreme, Extremes};
use assur::problem::Span;
use assur::registry::Settings;

use crate::case::Case;
use crate::curves::{self, Curves};
use crate::error::Failure;
use crate::measures::Measured;
use crate::motion::Motion;
use crate::settings::RTOL;

/// Estimates are so many times what the solutions differ by.
const SAFETY: f64 = 2.0;
/// Roundings of a value.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
/// Steps that a tenth of the tolerance may take: so many times those of the printed solution, and so many more. Methods of order
/// five, the lowest that there are, take 1.6 times as many.
const MOST: (usize, usize) = (2, 200);
/// The first step then, over that of the printed solution.
const FIRST: f64 = 0.4;
/// Steps on both sides of a place whose errors are errors of that place, so that no luck makes it look better.
const NEAR: usize = 2;
/// How much earlier or later an event may happen in another solution of the same motion, over the length of the task.
const LATE: f64 = 1e-3;
/// Places in each of them.
const PARTS: usize = 4;

/// Other solutions of the same task.
pub struct Doubt {
    others: Vec<Other>,
    /// How many times the work of the printed solution ten times more accuracy takes; unknown at the limit of double
    /// precision.
    pub tenfold: Option<f64>,
    /// Whether a tenth of the tolerance takes too long, or does not come out.
    pub is_cut_off: bool,
}

struct Other {
    motion: Motion,
    /// What its difference from the printed solution is to be multiplied by.
    share: f64,
}

/// An extreme with its errors.
#[derive(Clone, Copy, Debug)]
pub struct End {
    /// The value.
    pub value: f64,
    /// Its error.
    pub error: f64,
    /// The first time at which it is reached, as far as that can be told.
    pub time: f64,
    /// The error of this time.
    pub blur: f64,
    /// The same if all times count at which the value cannot be told from the extreme.
    pub reach: f64,
}

/// The extremes of a variable.
#[derive(Clone, Copy, Debug)]
pub struct Ends {
    /// The smallest.
    pub lowest: End,
    /// The largest.
    pub highest: End,
}

impl Ends {
    /// The one with the largest absolute value.
    pub fn furthest(&self) -> End {
        match self.lowest.value.abs() > self.highest.value.abs() {
            true => self.lowest,
            false => self.highest,
        }
    }
}

impl Doubt {
    /// Solves the task again.
    ///
    /// # Errors
    /// When neither of the other tolerances comes out.
    pub fn of(case: &Case, motion: &Motion) -> Result<Self, Failure> {
        if case.scene.states.is_empty() || case.task == Span::Open {
            return Ok(Self {
                others: Vec::new(),
                tenfold: None,
                is_cut_off: false,
            });
        }
        let rtol = motion.settings.rtol;
        let effort = motion.effort();
        let again = |rtol: f64| motion.settings.at(rtol);
        let finer = |rtol: f64| match case.task {
            Span::Run(..) => Settings {
                max_steps: Some(MOST.0 * (effort.steps + effort.rejected) + MOST.1),
                // Else the first steps, which do not grow any faster, would be the same whatever the tolerance.
                first_step: motion
                    .steps()
                    .get(..2)
                    .map(|steps| FIRST * (steps[1] - steps[0])),
                ..again(rtol)
            },
            _ => again(rtol),
        };
        let finer = (rtol / 10.0 >= RTOL.0).then(|| case.solve(finer(rtol / 10.0)));
        let coarser = case.solve(again(10.0 * rtol));
        let is_cut_off = matches!(finer, Some(Err(_)));
        let (finer, coarser) = match (finer, coarser) {
            (Some(Err(_)) | None, Err(failure)) => return Err(failure),
            (finer, coarser) => (finer.and_then(Result::ok), coarser.ok()),
        };
        let work = effort.evaluations;
        let tenfold = finer.as_ref().filter(|_| work > 0);
        let tenfold = tenfold.map(|finer| finer.effort().evaluations as f64 / work as f64);
        let bound = if finer.is_some() { 1.0 / 9.0 } else { 1.0 };
        let coarser = coarser.filter(|other| finer.is_none() || other.is_like(motion));
        let share =
            |motion: Option<Motion>, share: f64| motion.map(|motion| Other { motion, share });
        let others = [share(finer, 10.0 / 9.0), share(coarser, bound)];
        Ok(Self {
            others: others.into_iter().flatten().collect(),
            tenfold,
            is_cut_off,
        })
    }

    /// The error of a value for which the others have these.
    fn differ(&self, value: f64, others: &[f64]) -> f64 {
        let pairs = self.others.iter().zip(others);
        let most = pairs.map(|(other, theirs)| (value - theirs).abs() * other.share);
        f64::max(SAFETY * most.fold(0.0, larger), ROUNDINGS * value.abs())
    }

    /// The errors of all variables at one time, but for times at which the solutions differ by an event.
    fn exactly_at(&self, case: &Case, motion: &Motion, time: f64) -> Option<Vec<f64>> {
        let is_comparable = |other: &&Other| {
            !motion.is_beside_event(time) && !is_between(motion, &other.motion, time, case.task)
        };
        let like: Vec<&Other> = self.others.iter().filter(is_comparable).collect();
        if like.is_empty() && !self.others.is_empty() {
            return None;
        }
        let values = case.sample(motion, time);
        let mut errors: Vec<f64> = values.iter().map(|one| ROUNDINGS * one.abs()).collect();
        for other in like {
            let theirs = case.sample(&other.motion, time);
            for ((error, a), b) in errors.iter_mut().zip(&values).zip(theirs) {
                *error = larger(*error, SAFETY * (a - b).abs() * other.share);
            }
        }
        Some(errors)
    }

    /// The errors of all variables at one time: the largest of the steps around it.
    pub fn at(&self, case: &Case, motion: &Motion, time: f64) -> Vec<f64> {
        let mut errors = match self.exactly_at(case, motion, time) {
            Some(errors) => errors,
            // Before or after an event: that is not known.
            None => self.jump(case, motion, time),
        };
        // The start of a run is given.
        if matches!(case.task, Span::Run(from, _) if from == time) {
            return errors;
        }
        for near in near(motion, time) {
            if motion.passed(near) != motion.passed(time) {
                continue;
            }
            for (error, here) in errors
                .iter_mut()
                .zip(self.exactly_at(case, motion, near).into_iter().flatten())
            {
                *error = larger(*error, here);
            }
        }
        errors
    }

    fn jump(&self, case: &Case, motion: &Motion, time: f64) -> Vec<f64> {
        let theirs = self.others.iter();
        let theirs: Vec<_> = theirs
            .map(|other| case.sample(&other.motion, time))
            .collect();
        let values = case.sample(motion, time).into_iter().enumerate();
        values
            .map(|(index, value)| {
                let apart = theirs.iter().map(|other| (value - other[index]).abs());
                apart.fold(0.0, larger)
            })
            .collect()
    }

    /// The largest error of each variable over the task.
    pub fn largest(&self, case: &Case, motion: &Motion, curves: &Curves) -> Vec<f64> {
        let mut errors = vec![0.0; case.variables.len()];
        // Every third sample is enough for a largest value.
        for time in curves.times.iter().step_by(3) {
            let here = self.exactly_at(case, motion, *time);
            for (error, here) in errors.iter_mut().zip(here.into_iter().flatten()) {
                *error = larger(*error, here);
            }
        }
        errors
    }

    /// The extremes of all variables with their errors. Where other solutions have them is looked for near by.
    pub fn extremes(
        &self,
        case: &Case,
        motion: &Motion,
        curves: &Curves,
        extremes: &[Extremes],
    ) -> Vec<Ends> {
        let steps = motion.steps();
        let ends = extremes.iter().enumerate().map(|(index, own)| Ends {
            lowest: self.end(case, motion, &steps, index, (own, |own| own.lowest)),
            highest: self.end(case, motion, &steps, index, (own, |own| own.highest)),
        });
        let mut ends: Vec<_> = ends.collect();
        let at = |time: f64| self.exactly_at(case, motion, time);
        for ((ends, own), index) in ends.iter_mut().zip(extremes).zip(0..) {
            let rounding = f64::EPSILON * own.amplitude();
            for (end, rivals) in [
                (&mut ends.lowest, &own.low_rivals),
                (&mut ends.highest, &own.high_rivals),
            ] {
                end.error = larger(end.error, rounding);
                end.error = larger(
                    end.error,
                    jitter(case, motion, index, (end.time, end.value)),
                );
                let error = |rival: &Extreme| {
                    let own = at(rival.time).map_or(0.0, |errors| errors[index]);
                    own + jitter(case, motion, index, (rival.time, rival.value))
                };
                widen(end, rivals, &error, curves, index);
            }
        }
        ends
    }

    fn end(
        &self,
        case: &Case,
        motion: &Motion,
        steps: &[f64],
        index: usize,
        (own, end): (&Extremes, fn(&Extremes) -> Extreme),
    ) -> End {
        let own = end(own);
        let times = around(steps, own);
        let theirs = self.others.iter().filter_map(|other| {
            let variable = &case.variables[index..=index];
            let found = curves::extremes(case, &other.motion, variable, times);
            found.first().map(end)
        });
        let theirs: Vec<_> = theirs.collect();
        let of = |part: fn(&Extreme) -> f64| theirs.iter().map(part).collect::<Vec<_>>();
        let there = self.exactly_at(case, motion, own.time);
        let blur = self.differ(own.time, &of(|extreme| extreme.time)) + own.blur;
        End {
            value: own.value,
            error: larger(
                self.differ(own.value, &of(|extreme| extreme.value)),
                there.map_or(0.0, |errors| errors[index]),
            ),
            time: own.time,
            blur,
            reach: blur,
        }
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

    /// Tells measures their errors; NaN where a solution does not have it.
    pub fn tell(&self, case: &Case, measures: &mut [Measured]) {
        let others = self.others.iter();
        let others: Vec<_> = others.map(|other| other.motion.measures(case)).collect();
        for (index, measure) in measures.iter_mut().enumerate() {
            let theirs = others.iter().map(|other| other[index].value);
            let theirs: Option<Vec<f64>> = theirs.map(Result::ok).collect();
            measure.error = match (measure.value, theirs) {
                (Ok(value), Some(theirs)) => self.differ(value, &theirs),
                _ => f64::NAN,
            };
        }
    }
}

/// Whether a time lies between the times at which two solutions have an event, which are not far apart: there they differ by a
/// jump.
fn is_between(a: &Motion, b: &Motion, time: f64, task: Span) -> bool {
    let passed = (a.passed(time), b.passed(time));
    let next = usize::min(passed.0, passed.1);
    let (from, to) = task.limits();
    match (a.events().get(next), b.events().get(next)) {
        _ if passed.0 == passed.1 => false,
        (Some(a), Some(b)) => (a.time - b.time).abs() < LATE * (to - from),
        _ => false,
    }
}

/// The larger of two errors. No number is larger than one that is not known.
fn larger(a: f64, b: f64) -> f64 {
    match a.is_nan() || b.is_nan() {
        true => f64::NAN,
        false => a.max(b),
    }
}

/// Takes the first of the places that cannot be told from an extreme by their values, which have errors of their own.
fn widen(
    end: &mut End,
    rivals: &[Extreme],
    error: &dyn Fn(&Extreme) -> f64,
    curves: &Curves,
    index: usize,
) {
    let is_like = |value: f64| (value - end.value).abs() <= end.error;
    let may_be_like = |rival: &Extreme| (rival.value - end.value).abs() <= end.error + error(rival);
    let tops = rivals.iter().filter(|rival| may_be_like(rival));
    let tops: Vec<f64> = tops.map(|rival| rival.time).collect();
    let samples = curves.times.iter().zip(&curves.values);
    let samples = samples.filter(|(_, values)| is_like(values[index]));
    let times = samples.map(|(time, _)| *time).chain(tops.iter().copied());
    let (from, to) = times.fold((end.time, end.time), |(from, to), time| {
        (from.min(time), to.max(time))
    });
    end.time = tops.into_iter().fold(end.time, f64::min);
    end.reach = end.blur.max(to - end.time).max(end.time - from);
}

/// What the rounding of the time of an event makes of a value there, which the motion may leave with any slope.
fn jitter(case: &Case, motion: &Motion, index: usize, (time, value): (f64, f64)) -> f64 {
    if !motion.is_beside_event(time) {
        return 0.0;
    }
    let rounding = ROUNDINGS * time.abs();
    let near = near(motion, time).into_iter();
    let near = near.filter(|near| (near - time).abs() > rounding);
    let slopes = near.map(|near| {
        let there = case.sample(motion, near)[index];
        ((there - value) / (near - time)).abs()
    });
    rounding * slopes.fold(0.0, f64::max)
}

/// From the begin of the step before an extreme to the end of the one after it.
fn around(steps: &[f64], extreme: Extreme) -> (f64, f64) {
    let last = steps.len().saturating_sub(1);
    let first = steps.partition_point(|step| *step < extreme.time - extreme.blur);
    let after = steps.partition_point(|step| *step <= extreme.time + extreme.blur);
    (steps[first.saturating_sub(2)], steps[(after + 1).min(last)])
}

/// Times in the steps around a time.
fn near(motion: &Motion, time: f64) -> Vec<f64> {
    let steps = motion.steps();
    let after = steps.partition_point(|step| *step <= time);
    let last = steps.len().saturating_sub(1);
    let around = &steps[after.saturating_sub(NEAR + 1).min(last)..(after + NEAR).min(steps.len())];
    let part = |step: &[f64], part: usize| {
        step[0] + (step[1] - step[0]) * (part as f64 + 0.5) / PARTS as f64
    };
    let parts = around.windows(2).flat_map(|step| {
        (0..PARTS)
            .map(|index| part(step, index))
            .collect::<Vec<_>>()
    });
    parts.collect()
}
