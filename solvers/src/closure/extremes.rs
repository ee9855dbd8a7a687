//! Extremes of a function of one variable whose rate is known.
//!
//! An extreme is where the rate changes its sign. What stands still for a moment and goes on is none, whatever signs
//! rounding gives its rate there: only rates above the noise count.

use super::error::ClosureError;
use super::root::brent;

/// How often a part is halved whose ends contradict each other.
const HALVINGS: usize = 12;
/// How often the part is halved in which a function comes to a standstill.
const EDGE: usize = 40;
/// Rates this much smaller than usual ones are noise: until such a rate vanishes and comes back, the function changes by
/// no more than its rounding.
const SLOW: f64 = 1e-10;
/// Rounding of a value, relative to the largest one.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A value and where it is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The independent variable.
    pub at: f64,
    /// The output.
    pub value: f64,
}

/// A value with its rate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub at: f64,
    pub value: f64,
    pub rate: f64,
}

impl Sample {
    /// Whether there are a value and a rate.
    fn is_known(self) -> bool {
        !self.value.is_nan() && !self.rate.is_nan()
    }
}

/// Finds the extremes between the first and the last of some samples, in order. A function that stands still between
/// rising and falling has its extreme in the middle of that.
///
/// # Errors
/// The first one of `look`, which takes further samples.
pub(super) fn find(
    samples: &[Sample],
    look: impl FnMut(f64) -> Result<Sample, ClosureError>,
) -> Result<Vec<Extreme>, ClosureError> {
    let mut search = Search {
        look,
        noise: Noise::of(samples),
        last: None,
        still: None,
        found: Vec::new(),
    };
    for (index, sample) in samples.iter().enumerate() {
        match index.checked_sub(1) {
            Some(before) => search.go(samples[before], *sample, HALVINGS)?,
            None => search.pass(*sample)?,
        }
    }
    Ok(search.found)
}

/// What of values and rates is rounding.
#[derive(Clone, Copy)]
struct Noise {
    value: f64,
    rate: f64,
}

impl Noise {
    fn of(samples: &[Sample]) -> Self {
        let values = samples.iter().map(|sample| sample.value.abs());
        let value = ROUNDING * values.filter(|one| one.is_finite()).fold(0.0, f64::max);
        let width = match samples {
            [first, .., last] => last.at - first.at,
            _ => f64::INFINITY,
        };
        let rates = samples.iter().map(|sample| sample.rate.abs());
        let mut rates: Vec<_> = rates.filter(|one| one.is_finite()).collect();
        rates.sort_by(f64::total_cmp);
        // Neither rests nor poles make a rate usual.
        let usual = rates.get(rates.len() * 3 / 4).copied().unwrap_or(0.0);
        Self {
            value,
            rate: (SLOW * usual).max(value / width),
        }
    }

    /// The sign of a rate; zero if it is noise, or none.
    fn sign(self, rate: f64) -> f64 {
        match rate.abs() > self.rate {
            true => rate.signum(),
            false => 0.0,
        }
    }

    /// Whether a function turns between two places without a change of sign. Its mean rate is taken somewhere between
    /// them; it must turn before or after that if neither end has its sign.
    fn hides(self, before: Sample, after: Sample) -> bool {
        let rise = after.value - before.value;
        let is_known = before.is_known() && after.is_known() && rise.abs() > self.value;
        let mean = self.sign(rise / (after.at - before.at));
        let ends = [before, after].map(|end| self.sign(end.rate));
        is_known && mean != 0.0 && !ends.contains(&mean)
    }
}

/// A search from sample to sample.
struct Search<F> {
    look: F,
    noise: Noise,
    /// The last sample with a rate above noise.
    last: Option<Sample>,
    /// Since then the function stands still between these places.
    still: Option<(f64, f64)>,
    found: Vec<Extreme>,
}

impl<F: FnMut(f64) -> Result<Sample, ClosureError>> Search<F> {
    /// Goes from one sample to the next.
    fn go(&mut self, before: Sample, after: Sample, halvings: usize) -> Result<(), ClosureError> {
        if halvings == 0 || !self.noise.hides(before, after) {
            return self.pass(after);
        }
        let middle = (self.look)(0.5 * (before.at + after.at))?;
        self.go(before, middle, halvings - 1)?;
        self.go(middle, after, halvings - 1)
    }

    /// Passes a sample; writes down an extreme before it.
    fn pass(&mut self, sample: Sample) -> Result<(), ClosureError> {
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
                let value = (self.look)(at)?.value;
                self.found.push(Extreme { at, value });
            }
        }
        Ok(())
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
    fn root(&mut self, before: Sample, after: Sample) -> Result<f64, ClosureError> {
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
mod tests {
    use super::*;

    /// The extremes from -1 to 1 of a function that gives its value and rate, and the number of looks beside the samples.
    fn extremes(function: impl Fn(f64) -> (f64, f64), parts: u32) -> (Vec<Extreme>, usize) {
        let sample = |at: f64| {
            let (value, rate) = function(at);
            Sample { at, value, rate }
        };
        let place = |k| -1.0 + 2.0 * f64::from(k) / f64::from(parts);
        let samples: Vec<_> = (0..=parts).map(|k| sample(place(k))).collect();
        let mut looks = 0;
        let found = find(&samples, |at| {
            looks += 1;
            Ok(sample(at))
        });
        (found.expect("every place can be looked at"), looks)
    }

    /// Whether zero is or is not among the samples.
    const PARTS: [u32; 2] = [180, 181];

    #[track_caller]
    fn check(function: impl Fn(f64) -> (f64, f64), expected: &[f64]) {
        for parts in PARTS {
            let (found, _) = extremes(&function, parts);
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for (found, expected) in found.iter().zip(expected) {
                assert!((found.at - expected).abs() < 1e-12, "{found:?} {expected}");
            }
        }
    }

    /// A rate with what rounding may add to it, of either sign.
    fn rounded(x: f64, rate: f64) -> f64 {
        rate + 1e-16 * (1e9 * x).sin()
    }

    #[test]
    fn a_double_zero_of_the_rate_is_no_extreme() {
        check(|x| (x.powi(3), 3.0 * x * x), &[]);
        check(|x| (-x.powi(3), rounded(x, -3.0 * x * x)), &[]);
        check(|x| (7.0 + x.powi(5), 5.0 * x.powi(4)), &[]);
    }

    #[test]
    fn a_triple_zero_of_the_rate_is_one_extreme() {
        check(|x| (x.powi(4), 4.0 * x.powi(3)), &[0.0]);
        let noisy = |x: f64| (-x.powi(4), rounded(x, -4.0 * x.powi(3)));
        for parts in PARTS {
            let (found, _) = extremes(noisy, parts);
            assert!(found.len() == 1 && found[0].at.abs() < 1e-5, "{found:?}");
        }
    }

    #[test]
    fn a_rest_on_a_summit_is_one_extreme() {
        let away = |x: f64| (x - 0.1).signum() * ((x - 0.1).abs() - 0.3).max(0.0);
        check(|x| (-away(x).powi(2), -2.0 * away(x)), &[0.1]);
        check(|x| (away(x), f64::from(u8::from(away(x) != 0.0))), &[]);
    }

    #[test]
    fn two_extremes_between_neighbouring_samples_are_found() {
        let d = 4e-3;
        check(|x| (x.powi(3) / 3.0 - d * d * x, x * x - d * d), &[-d, d]);
    }

    #[test]
    fn extremes_at_the_ends_are_not_inside() {
        let quarter = std::f64::consts::FRAC_PI_2;
        check(
            |x| ((quarter * x).sin(), quarter * (quarter * x).cos()),
            &[],
        );
    }

    #[test]
    fn what_has_no_rate_is_not_looked_at() {
        for function in [|x: f64| (x, f64::NAN), |x: f64| (x.ln(), 1.0 / x)] {
            let (found, looks) = extremes(function, 180);
            assert!(found.is_empty() && looks == 0, "{looks}");
        }
    }
}
