//! Extremes of a function of one variable whose rate is known, and where it jumps or goes beyond all bounds.
//!
//! An extreme is where the rate changes its sign. What stands still for a moment and goes on is none, whatever signs
//! rounding gives its rate there: only rates above the noise count. A part between two samples is divided until values
//! and rates at its ends agree with each other; where they never do the function is broken, see [`super::breaks`].

use super::breaks::{self, Break};
use super::noise::Noise;
use super::root::brent;
use crate::closure::error::ClosureError;

/// How often a part is halved whose ends contradict each other: down to some 1e-11 of the range.
const HALVINGS: usize = 28;
/// How many looks that may take between two samples.
const LOOKS: usize = 400;
/// Of so many parts one may have ends that contradict each other.
const MOST: usize = 3;
/// How often the part is halved in which a function comes to a standstill.
const EDGE: usize = 40;

/// A value and where it is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The independent variable.
    pub at: f64,
    /// The output; infinite where it goes beyond all bounds.
    pub value: f64,
}

/// A limit position: an output turns round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Where it is, and the output there.
    pub place: Extreme,
    /// Whether the output is larger there than beside it, its rate falling through zero.
    pub is_highest: bool,
}

/// A value with its rate.
#[derive(Clone, Copy, Debug)]
pub(in crate::closure) struct Node {
    pub at: f64,
    pub value: f64,
    pub rate: f64,
}

impl Node {
    /// Whether there are a value and a rate.
    pub fn is_known(self) -> bool {
        self.value.is_finite() && !self.rate.is_nan()
    }

    /// The same place, nothing being known there.
    pub fn unknown(self) -> Self {
        Self { value: f64::NAN, rate: f64::NAN, ..self }
    }

    /// The value without its rate.
    pub fn place(&self) -> Extreme {
        Extreme { at: self.at, value: self.value }
    }
}

/// Where a function turns round, and where it is broken, both in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Course {
    pub limits: Vec<Limit>,
    pub breaks: Vec<Break>,
}

/// Follows a function from the first to the last of some samples. One that stands still between rising and falling has
/// its extreme in the middle of that.
///
/// # Errors
/// The first one of `look`, which takes further samples.
pub(super) fn follow(
    samples: &[Node],
    look: impl FnMut(f64) -> Result<Node, ClosureError>,
) -> Result<Course, ClosureError> {
    let mut search = Search {
        look,
        noise: Noise::of(samples),
        range: match samples {
            [first, .., last] => (first.at, last.at),
            _ => (f64::NAN, f64::NAN),
        },
        left: 0,
        last: None,
        still: None,
        course: Course::default(),
    };
    // Where values and rates hardly ever agree the values are rounding, and so is how they turn.
    let torn = samples.windows(2).filter(|pair| search.noise.is_torn(pair[0], pair[1]));
    if MOST * torn.count() > samples.len() {
        return Ok(search.course);
    }
    for (index, sample) in samples.iter().enumerate() {
        search.left = LOOKS;
        match index.checked_sub(1) {
            Some(before) => search.go(samples[before], *sample, HALVINGS)?,
            None => search.pass(*sample)?,
        }
    }
    Ok(search.course)
}

/// A search from sample to sample.
pub(super) struct Search<F> {
    pub look: F,
    pub noise: Noise,
    /// The first and the last place.
    pub range: (f64, f64),
    /// How many looks may still be taken before the next sample.
    left: usize,
    /// The last sample with a rate above noise.
    last: Option<Node>,
    /// Since then the function stands still between these places.
    still: Option<(f64, f64)>,
    course: Course,
}

impl<F: FnMut(f64) -> Result<Node, ClosureError>> Search<F> {
    /// Goes from one sample to the next.
    fn go(&mut self, before: Node, after: Node, halvings: usize) -> Result<(), ClosureError> {
        let is_torn = self.noise.is_torn(before, after);
        if !is_torn && !self.noise.hides(before, after) {
            return self.pass(after);
        }
        let middle = 0.5 * (before.at + after.at);
        let is_inside = before.at < middle && middle < after.at;
        if halvings > 0 && self.left > 0 && is_inside {
            self.left -= 1;
            let middle = (self.look)(middle)?;
            self.go(before, middle, halvings - 1)?;
            return self.go(middle, after, halvings - 1);
        }
        if is_torn && let Some(found) = self.break_between(before, after)? {
            self.note(found);
            (self.last, self.still) = (None, None);
        }
        self.pass(after)
    }

    /// Passes a sample; writes down an extreme before it.
    fn pass(&mut self, sample: Node) -> Result<(), ClosureError> {
        let sign = self.noise.sign(sample.rate);
        if !sample.is_known() {
            (self.last, self.still) = (None, None);
        } else if sign == 0.0 {
            let from = self.still.map_or(sample.at, |(from, _)| from);
            self.still = Some((from, sample.at));
        } else {
            let before = self.last.replace(sample);
            let still = self.still.take();
            if let Some(before) = before.filter(|before| before.rate.signum() != sign) {
                let at = match still {
                    Some((from, to)) if from < to => {
                        0.5 * (self.edge(from, before.at)? + self.edge(to, sample.at)?)
                    }
                    _ => self.root(before, sample)?,
                };
                self.turn(at, sign < 0.0)?;
            }
        }
        Ok(())
    }

    /// Writes down that the function turns round at a place, or that it does so through a pole.
    fn turn(&mut self, at: f64, is_highest: bool) -> Result<(), ClosureError> {
        let value = (self.look)(at)?.value;
        let pole = Break {
            at,
            before: self.limit_towards(at, value, -1.0)?,
            after: self.limit_towards(at, value, 1.0)?,
        };
        if pole.is_unbounded() {
            self.note(pole);
        } else {
            let value = if value.is_nan() { pole.before } else { value };
            let place = Extreme { at, value };
            self.course.limits.push(Limit { place, is_highest });
        }
        Ok(())
    }

    /// Writes a break down; one with the last where a sample has fallen between them by rounding.
    fn note(&mut self, found: Break) {
        let near = breaks::NEAREST * (self.range.1 - self.range.0);
        match self.course.breaks.last_mut() {
            Some(last) if found.at - last.at <= near => last.after = found.after,
            _ => self.course.breaks.push(found),
        }
    }

    /// Where the rate becomes noise, between a place where it is and one where it is not.
    fn edge(&mut self, mut still: f64, mut moving: f64) -> Result<f64, ClosureError> {
        for _ in 0..EDGE {
            let middle = 0.5 * (still + moving);
            match self.noise.sign((self.look)(middle)?.rate) == 0.0 {
                true => still = middle,
                false => moving = middle,
            }
        }
        Ok(still)
    }

    /// Where the rate is zero, between two places where it has different signs.
    fn root(&mut self, before: Node, after: Node) -> Result<f64, ClosureError> {
        let mut error = None;
        let at = brent(
            |at| match (self.look)(at) {
                Ok(sample) => sample.rate,
                Err(found) => {
                    error = Some(found);
                    f64::NAN
                }
            },
            (before.at, before.rate),
            (after.at, after.rate),
        );
        error.map_or(Ok(at), Err)
    }
}

#[cfg(test)]
mod tests;
