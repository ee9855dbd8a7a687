//! Limit positions and strokes of the outputs.
//!
//! A limit position is a zero of the rate of an output, which the kinematic coefficients give: it is found to the last
//! bits, where a search for the greatest value would lose half of the digits.

use super::assembly::Assembly;
use super::error::ClosureError;
use super::extremes::{self, Extreme, Sample};
use super::limits::{End, Stretch, stretch};
use super::problem::Linkage;
use super::rates::Rates;

/// Number of parts of a range in which limit positions are looked for.
const PARTS: usize = 180;
/// By this part of a stroke a sample lies clearly beyond it.
const CLEAR: f64 = 1e-9;

/// The extremes of one output over a stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The smallest value, at a limit position or an end; beside a pole or a jump as far as it was looked.
    pub least: Extreme,
    /// The greatest value.
    pub greatest: Extreme,
    /// All limit positions inside, in order.
    pub limits: Vec<Extreme>,
}

impl Stroke {
    /// The greatest value less the smallest.
    pub fn length(&self) -> f64 {
        self.greatest.value - self.least.value
    }
}

/// Finds the limit positions and the strokes of all outputs over the stretch of one independent variable within bounds.
///
/// # Errors
/// As [`stretch`].
pub fn strokes<L: Linkage>(
    linkage: &L,
    variable: usize,
    bounds: (f64, f64),
) -> Result<Vec<Stroke>, ClosureError> {
    let stretch = stretch(linkage, variable, bounds)?;
    let mut track = Track::new(linkage, variable)?;
    let looks = inside(&stretch)
        .map(|at| track.look(at))
        .collect::<Result<Vec<_>, _>>()?;
    let stroke = |output: usize| {
        let samples: Vec<_> = looks.iter().map(|look| look.of(output)).collect();
        let look = |at| Ok(track.look(at)?.of(output));
        let ends = [&stretch.low, &stretch.high].map(|end| Extreme {
            at: end.at,
            value: end.outputs[output],
        });
        Ok(over(extremes::find(&samples, look)?, ends, &samples))
    };
    (0..L::OUTPUTS).map(stroke).collect()
}

/// Equally spaced places over a stretch. Ends at dead points cannot be stood on; the rates of outputs do not vanish
/// beside them.
fn inside(stretch: &Stretch) -> impl Iterator<Item = f64> {
    let (low, high) = (stretch.low.at, stretch.high.at);
    let beside = |end: &End| if end.dead.is_some() { 1e-9 } else { 0.0 };
    let first = low + beside(&stretch.low) * (high - low);
    let last = high - beside(&stretch.high) * (high - low);
    let between = move |k| first + (last - first) * k as f64 / PARTS as f64;
    (0..PARTS).map(between).chain([last])
}

/// The stroke over limit positions and ends, and over samples that lie clearly beyond them: beside a pole or a jump.
fn over(limits: Vec<Extreme>, ends: [Extreme; 2], samples: &[Sample]) -> Stroke {
    let mut least = ends[0];
    let mut greatest = ends[0];
    let mut reach = |one: Extreme, clearance: f64| {
        if one.value < least.value - clearance {
            least = one;
        }
        if one.value > greatest.value + clearance {
            greatest = one;
        }
        greatest.value - least.value
    };
    let mut length = 0.0;
    for one in limits.iter().chain(&ends) {
        length = reach(*one, 0.0);
    }
    for &Sample { at, value, .. } in samples {
        reach(Extreme { at, value }, CLEAR * length);
    }
    Stroke {
        least,
        greatest,
        limits,
    }
}

/// All outputs with their rates at one place.
struct Look {
    at: f64,
    values: Vec<f64>,
    rates: Vec<f64>,
}

impl Look {
    fn of(&self, output: usize) -> Sample {
        Sample {
            at: self.at,
            value: self.values[output],
            rate: self.rates[output],
        }
    }
}

/// A linkage that is moved along one of its independent variables.
struct Track<L: Linkage> {
    assembly: Assembly<L, f64>,
    rates: Rates<L>,
    variable: usize,
    place: Vec<f64>,
}

impl<L: Linkage> Track<L> {
    fn new(linkage: &L, variable: usize) -> Result<Self, ClosureError> {
        let mut assembly = Assembly::new(linkage);
        assembly.start()?;
        let place = assembly.independents().to_vec();
        Ok(Self {
            assembly,
            rates: Rates::new(linkage),
            variable,
            place,
        })
    }

    /// Moves to a place and looks at the outputs.
    fn look(&mut self, at: f64) -> Result<Look, ClosureError> {
        self.place[self.variable] = at;
        self.assembly.travel(&self.place)?;
        let mut values = vec![0.0; L::OUTPUTS];
        let mut rates = vec![0.0; L::OUTPUTS];
        self.assembly.outputs(&mut values);
        self.rates.of(&self.assembly, self.variable, &mut rates);
        Ok(Look { at, values, rates })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beside_a_pole_samples_count() {
        let extreme = |at: f64, value: f64| Extreme { at, value };
        let sample = |at: f64, value: f64| Sample {
            at,
            value,
            rate: 1.0,
        };
        let ends = [extreme(0.0, 1.0), extreme(4.0, 2.0)];
        let limits = vec![extreme(1.0, 0.5)];
        let samples = [
            sample(1.1, 0.5 - 1e-12),
            sample(2.0, 90.0),
            sample(3.0, -80.0),
        ];
        let stroke = over(limits.clone(), ends, &samples[..1]);
        assert_eq!((stroke.least, stroke.greatest), (limits[0], ends[1]));
        let stroke = over(limits, ends, &samples);
        assert_eq!((stroke.least.at, stroke.greatest.at), (3.0, 2.0));
    }
}
