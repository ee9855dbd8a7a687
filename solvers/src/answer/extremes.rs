//! The extremes of a motion with their errors.

use std::cell::RefCell;
use std::collections::HashMap;

use super::estimate::{Estimate, ROUNDINGS, near};
use super::motion::Motion;
use crate::measure::{self, Extreme, Extremes};
use crate::ode::larger;
use crate::problem::Phase;
use crate::shape::Subject;

/// Values that differ by so many times their errors may be the same: some errors are told that many times too small.
const ALIKE: f64 = 5.0;

/// Roundings of the time at which it is seen by how much a value scatters.
const BESIDE: [f64; 2] = [-1.0, 1.0];
/// Parts of a step at which errors are looked at beside an extreme.
const HARDLY: [f64; 4] = [-1e-2, -1e-5, 1e-5, 1e-2];

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
    /// The error of the time if all times count at which the value cannot be told from the extreme.
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
    /// Of what is nothing but noise either end may lie beyond the other. What others have there may be as noisy and yet agree by
    /// luck at one end: then it is as uncertain as all that the noise goes through, and may lie anywhere.
    fn share(&mut self, (from, to): (f64, f64)) {
        let apart = self.highest.value - self.lowest.value;
        let errors = [self.lowest.error, self.highest.error];
        let is_noise = apart <= ALIKE * larger(errors[0], errors[1]);
        for (end, [own, other]) in
            [(&mut self.lowest, errors), (&mut self.highest, [errors[1], errors[0]])]
        {
            end.error = larger(own, other - apart);
            if is_noise {
                end.error = larger(end.error, apart);
                end.reach = end.reach.max(end.time - from).max(to - end.time);
            }
        }
    }

    /// The one with the largest absolute value.
    pub fn furthest(&self) -> End {
        match self.lowest.value.abs() > self.highest.value.abs() {
            true => self.lowest,
            false => self.highest,
        }
    }
}

/// Samples of a motion.
#[derive(Clone, Copy, Debug)]
pub struct Samples<'a> {
    /// The times.
    pub times: &'a [f64],
    /// The values of all subjects at each time.
    pub values: &'a [Vec<f64>],
}

impl Motion {
    /// Smallest and largest value of some subjects between two times of the task; none where there is no time between.
    pub fn extremes(&self, subjects: &[Subject], times: (f64, f64)) -> Vec<Extremes> {
        let found = measure::extremes(self.path(), times, subjects.len(), &self.probe(subjects));
        found.into_iter().flatten().collect()
    }

    /// What measures ask some subjects by.
    fn probe(&self, subjects: &[Subject]) -> impl Fn(Phase<'_, f64>, f64, &[f64], &mut [f64]) {
        |phase, time, state, values| {
            values.copy_from_slice(&self.values_on(subjects, phase, time, state))
        }
    }
}

impl Estimate {
    /// The extremes of all subjects with their errors, beside samples. Where other solutions have them is looked for near
    /// by.
    pub fn extremes(
        &self,
        motion: &Motion,
        subjects: &[Subject],
        samples: &Samples<'_>,
        extremes: &[Extremes],
    ) -> Vec<Ends> {
        let steps = motion.steps();
        let of = |own: &Extremes| [own.lowest, own.highest];
        let windows: Vec<_> =
            extremes.iter().map(|own| of(own).map(|end| around(&steps, end))).collect();
        let theirs = self.others.iter().map(|other| {
            let other = &other.motion;
            measure::extremes_near(other.path(), &windows, &other.probe(subjects))
        });
        let theirs: Vec<_> = theirs.collect();
        // Quantities of one motion often turn at the same time.
        let known = RefCell::new(HashMap::<u64, (Vec<f64>, Vec<f64>)>::new());
        let errors_at = |time: f64, index: usize| -> (f64, f64) {
            let mut known = known.borrow_mut();
            let at = || (self.about(motion, subjects, time), scatter(motion, subjects, time));
            let (errors, scatter) = known.entry(time.to_bits()).or_insert_with(at);
            (errors[index], scatter[index])
        };
        let error_at = |time: f64, index: usize| {
            let (error, scatter) = errors_at(time, index);
            larger(error, scatter)
        };
        let each = extremes.iter().enumerate().map(|(index, own)| {
            let end = |which: usize| {
                let theirs = theirs.iter().filter_map(|theirs| theirs[index][which]);
                let mut found = self.end(of(own)[which], &theirs.collect::<Vec<_>>());
                let (error, scatter) = errors_at(found.time, index);
                found.error = larger(found.error, error);
                if scatter > found.error {
                    found.error = scatter;
                    found.blur = larger(found.blur, flat(motion, subjects[index], &found));
                }
                found
            };
            Ends { lowest: end(0), highest: end(1) }
        });
        let mut ends: Vec<_> = each.collect();
        let limits = motion.task().limits();
        ends.iter_mut().for_each(|ends| ends.share(limits));
        for (index, (ends, own)) in ends.iter_mut().zip(extremes).enumerate() {
            let rounding = f64::EPSILON * own.amplitude();
            for (end, rivals) in
                [(&mut ends.lowest, &own.low_rivals), (&mut ends.highest, &own.high_rivals)]
            {
                end.error = larger(end.error, rounding);
                let jitter = |place: (f64, f64)| jitter(motion, subjects[index], place);
                end.error = larger(end.error, jitter((end.time, end.value)));
                let error = |rival: &Extreme| {
                    error_at(rival.time, index) + jitter((rival.time, rival.value))
                };
                widen(end, rivals, &error, samples, index);
            }
        }
        ends
    }

    /// The errors of all subjects at a time, and hardly beside it: an extreme of what is noisy lies where luck has it, and so
    /// may what others have there.
    fn about(&self, motion: &Motion, subjects: &[Subject], time: f64) -> Vec<f64> {
        let mut errors = vec![0.0; subjects.len()];
        for place in hardly_beside(motion, time).into_iter().chain([time]) {
            let here = self.exactly_at(motion, subjects, place).into_iter().flatten();
            for (error, here) in errors.iter_mut().zip(here) {
                *error = larger(*error, here);
            }
        }
        errors
    }

    /// One extreme with what other solutions have in its place.
    fn end(&self, own: Extreme, theirs: &[Extreme]) -> End {
        let of = |part: fn(&Extreme) -> f64| theirs.iter().map(part).collect::<Vec<_>>();
        let blur = self.differ(own.time, &of(|extreme| extreme.time)) + own.blur;
        End {
            value: own.value,
            error: self.differ(own.value, &of(|extreme| extreme.value)),
            time: own.time,
            blur,
            reach: blur,
        }
    }
}

/// Takes the first of the places that cannot be told from an extreme by their values. Their errors are their own: where the
/// extreme is the start, which is given, any of them may lie further out.
fn widen(
    end: &mut End,
    rivals: &[Extreme],
    error: &dyn Fn(&Extreme) -> f64,
    samples: &Samples<'_>,
    index: usize,
) {
    let below = |value: f64| (value - end.value).abs();
    let rivals = rivals.iter().map(|rival| (rival.time, below(rival.value), error(rival)));
    let rivals: Vec<(f64, f64, f64)> = rivals.collect();
    let further = rivals.iter().map(|(_, below, error)| error - below);
    let own = further.fold(end.error, larger);
    let is_like = |value: f64| below(value) <= ALIKE * own;
    let tops = rivals.iter().filter(|(_, below, error)| *below <= ALIKE * (own + error));
    let tops: Vec<f64> = tops.map(|rival| rival.0).collect();
    let samples = samples.times.iter().zip(samples.values);
    let samples = samples.filter(|(_, values)| is_like(values[index]));
    let times = samples.map(|(time, _)| *time).chain(tops.iter().copied());
    let (from, to) =
        times.fold((end.time, end.time), |(from, to), time| (from.min(time), to.max(time)));
    end.error = own;
    end.time = tops.into_iter().fold(end.time, f64::min);
    end.reach = end.reach.max(end.blur).max(to - end.time).max(end.time - from);
}

/// By how much some subjects scatter within roundings of a time, as they do where roundings of the state are amplified: all
/// solutions may do so alike. Not beside an event, where they may jump.
fn scatter(motion: &Motion, subjects: &[Subject], time: f64) -> Vec<f64> {
    let mut most = vec![0.0; subjects.len()];
    if motion.is_beside_event(time) {
        return most;
    }
    let (from, to) = motion.task().limits();
    let here = motion.values(subjects, time);
    for beside in BESIDE.map(|part| (time + part * ROUNDINGS * time.abs()).clamp(from, to)) {
        let there = motion.values(subjects, beside);
        for ((most, here), there) in most.iter_mut().zip(&here).zip(there) {
            *most = larger(*most, (here - there).abs());
        }
    }
    most
}

/// Times by parts of its step before and after a time, without an event between.
fn hardly_beside(motion: &Motion, time: f64) -> Vec<f64> {
    let steps = motion.steps();
    let after = steps.partition_point(|step| *step <= time).clamp(1, steps.len().max(2) - 1);
    let (Some(from), Some(to)) = (steps.get(after - 1), steps.get(after)) else {
        return Vec::new();
    };
    let (begin, end) = motion.task().limits();
    let places = HARDLY.map(|part| (time + part * (to - from)).clamp(begin, end));
    places.into_iter().filter(|place| motion.passed(*place) == motion.passed(time)).collect()
}

/// How far from the time of an extreme a subject cannot be told from it.
fn flat(motion: &Motion, subject: Subject, end: &End) -> f64 {
    let (from, to) = motion.task().limits();
    let differs = |time: f64| {
        let there = motion.values(&[subject], time.clamp(from, to))[0];
        let apart = (there - end.value).abs();
        apart.is_nan() || apart > 2.0 * end.error
    };
    let mut far = ROUNDINGS * end.time.abs().max(to - from);
    while far < to - from && !(differs(end.time - far) && differs(end.time + far)) {
        far *= 2.0;
    }
    far
}

/// What the rounding of the time of an event makes of a value there, which the motion may leave with any slope.
fn jitter(motion: &Motion, subject: Subject, (time, value): (f64, f64)) -> f64 {
    if !motion.is_beside_event(time) {
        return 0.0;
    }
    let rounding = ROUNDINGS * time.abs();
    let near = near(motion, time).into_iter();
    let near = near.filter(|near| (near - time).abs() > rounding);
    let slopes = near.map(|near| {
        let there = motion.values(&[subject], near)[0];
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Widens an extreme that is given, one at zero, beside a rival at a later time with a value and an error.
    fn beside(value: f64, error: f64) -> End {
        let mut end = End { value: 1.0, error: 0.0, time: 0.0, blur: 0.0, reach: 0.0 };
        let rival = Extreme { value, time: 3.0, blur: 0.0 };
        let samples = Samples { times: &[], values: &[] };
        widen(&mut end, &[rival], &|_| error, &samples, 0);
        end
    }

    #[test]
    fn a_place_that_may_lie_further_out_makes_an_extreme_uncertain() {
        let end = beside(0.75, 1.0);
        assert_eq!((end.error, end.time, end.reach), (0.75, 0.0, 3.0));
    }

    #[test]
    fn a_place_that_cannot_lie_as_far_out_does_not_count() {
        let end = beside(0.0, 0.125);
        assert_eq!((end.error, end.time, end.reach), (0.0, 0.0, 0.0));
    }

    /// An angular velocity that is zero: its largest value errs by far more than its smallest one is told to.
    #[test]
    fn an_end_may_lie_beyond_the_other_one() {
        let end = |value, error| End { value, error, time: 0.0, blur: 0.0, reach: 0.0 };
        let errors = |lowest, highest, reach| {
            let mut ends = Ends { lowest, highest };
            ends.share((0.0, 1.0));
            assert_eq!((ends.lowest.reach, ends.highest.reach), (reach, reach));
            (ends.lowest.error, ends.highest.error)
        };
        assert_eq!(errors(end(-0.25, 0.125), end(1.0, 8.0), 1.0), (6.75, 8.0));
        // One end of noise that others agree with by luck.
        assert_eq!(errors(end(-8.0, 10.0), end(8.0, 0.25), 1.0), (16.0, 16.0));
        assert_eq!(errors(end(-8.0, 0.125), end(8.0, 0.25), 0.0), (0.125, 0.25));
    }

    #[test]
    fn errors_may_be_told_too_small_by_so_much_that_a_place_is_as_far_out() {
        let end = beside(0.5, 0.125);
        assert_eq!((end.error, end.time, end.reach), (0.0, 0.0, 3.0));
    }
}
