//! How far a driver can go, and the limit positions and strokes of the outputs.
//!
//! A limit position is a zero of the rate of an output, which the kinematic coefficients give: it is found to the last
//! bits, where a search for the greatest value would lose half of the digits.

use super::assembly::Assembly;
use super::error::ClosureError;
use super::problem::{Closure, Linkage};
use super::rates::Rates;
use super::root::brent;

/// Number of parts of a range in which limit positions are looked for.
const PARTS: usize = 180;
/// How often a part is halved whose ends contradict each other.
const HALVINGS: usize = 12;

/// How far one independent variable can go without leaving the mode, the others at their start.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// The end below.
    pub low: End,
    /// The end above.
    pub high: End,
}

/// One end of a stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// The independent variable there.
    pub at: f64,
    /// The group that has a dead point there; none if the end is the one that was asked for.
    pub dead: Option<usize>,
    /// The outputs there.
    pub outputs: Vec<f64>,
}

/// A value of an output and where it is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The independent variable.
    pub at: f64,
    /// The output.
    pub value: f64,
}

/// The extremes of one output over a stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The smallest value, at a limit position or an end.
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

/// Finds how far one independent variable can go within bounds.
///
/// # Errors
/// [`ClosureError`] if the linkage does not assemble at its start, or a mode is lost without a dead point.
pub fn stretch<L: Linkage>(
    linkage: &L,
    variable: usize,
    bounds: (f64, f64),
) -> Result<Stretch, ClosureError> {
    if variable >= L::INDEPENDENTS || !(bounds.0 < bounds.1 && (bounds.1 - bounds.0).is_finite()) {
        let reason = format!(
            "bounds {bounds:?} of independent variable {variable}: expected a finite stretch"
        );
        return Err(ClosureError::BadRange { reason });
    }
    Ok(Stretch {
        low: end(linkage, variable, bounds.0)?,
        high: end(linkage, variable, bounds.1)?,
    })
}

/// Goes from the start as far as possible.
fn end<L: Linkage>(linkage: &L, variable: usize, bound: f64) -> Result<End, ClosureError> {
    let mut assembly = Assembly::<L, f64>::new(linkage);
    assembly.start()?;
    let mut place = assembly.independents().to_vec();
    place[variable] = bound;
    let mut outputs = vec![0.0; L::OUTPUTS];
    match assembly.travel(&place) {
        Ok(()) => {
            assembly.outputs(&mut outputs);
            Ok(End {
                at: bound,
                dead: None,
                outputs,
            })
        }
        Err(ClosureError::DeadPoint {
            group, at, wanted, ..
        }) => {
            assembly.outputs_at_dead_point(&wanted, &mut outputs);
            Ok(End {
                at: at[variable],
                dead: Some(group),
                outputs,
            })
        }
        Err(error) => Err(error),
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
    let (low, high) = (stretch.low.at, stretch.high.at);
    let mut limits = vec![Vec::new(); L::OUTPUTS];
    // Ends at dead points cannot be stood on; the rates of outputs do not vanish beside them.
    let beside = |end: &End| if end.dead.is_some() { 1e-9 } else { 0.0 };
    let first = low + beside(&stretch.low) * (high - low);
    let last = high - beside(&stretch.high) * (high - low);
    let mut before = track.look(first)?;
    for k in 1..=PARTS {
        let to = if k == PARTS {
            last
        } else {
            first + (last - first) * k as f64 / PARTS as f64
        };
        let after = track.look(to)?;
        for (output, limits) in limits.iter_mut().enumerate() {
            track.find(
                output,
                before.of(output),
                after.of(output),
                HALVINGS,
                limits,
            )?;
        }
        before = after;
    }
    let ends = |output: usize| {
        [&stretch.low, &stretch.high].map(|end| Extreme {
            at: end.at,
            value: end.outputs[output],
        })
    };
    Ok(limits
        .into_iter()
        .enumerate()
        .map(|(output, limits)| stroke(limits, ends(output)))
        .collect())
}

/// The stroke over limit positions and ends.
fn stroke(limits: Vec<Extreme>, ends: [Extreme; 2]) -> Stroke {
    let all = || limits.iter().chain(&ends);
    let least = all().fold(
        ends[0],
        |best, next| if next.value < best.value { *next } else { best },
    );
    let greatest = all().fold(
        ends[0],
        |best, next| if next.value > best.value { *next } else { best },
    );
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

/// One output with its rate.
#[derive(Clone, Copy)]
struct Sample {
    at: f64,
    value: f64,
    rate: f64,
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

    /// Finds the limit positions of an output between two places.
    fn find(
        &mut self,
        output: usize,
        before: Sample,
        after: Sample,
        halvings: usize,
        limits: &mut Vec<Extreme>,
    ) -> Result<(), ClosureError> {
        if before.rate == 0.0 || (before.rate > 0.0) != (after.rate > 0.0) {
            limits.extend(self.limit(output, before, after)?);
            return Ok(());
        }
        // The mean rate between equal signs has their sign, or else the output turns twice.
        let mean = (after.value - before.value) / (after.at - before.at);
        if halvings == 0 || after.rate == 0.0 || mean * before.rate >= 0.0 {
            return Ok(());
        }
        let middle = self.look(0.5 * (before.at + after.at))?.of(output);
        self.find(output, before, middle, halvings - 1, limits)?;
        self.find(output, middle, after, halvings - 1, limits)
    }

    /// The limit position of an output between two places with rates of different signs.
    fn limit(
        &mut self,
        output: usize,
        before: Sample,
        after: Sample,
    ) -> Result<Option<Extreme>, ClosureError> {
        if before.rate == 0.0 && after.rate == 0.0 {
            // It stands still.
            return Ok(None);
        }
        let mut error = None;
        let at = brent(
            |at| match self.look(at) {
                Ok(look) => look.rates[output],
                Err(found) => {
                    error = Some(found);
                    f64::NAN
                }
            },
            (before.at, before.rate),
            (after.at, after.rate),
        );
        match error {
            Some(error) => Err(error),
            None => Ok(Some(Extreme {
                at,
                value: self.look(at)?.values[output],
            })),
        }
    }
}

impl<L: Linkage> Assembly<L, f64> {
    /// Writes the outputs at the dead point on the way to these independent variables.
    fn outputs_at_dead_point(&mut self, wanted: &[f64], values: &mut [f64]) {
        values.fill(f64::NAN);
        let Some((at, coordinates)) = self.dead_position(wanted) else {
            return;
        };
        let instant = self.closure.instant(&at);
        self.trial.clone_from(&self.position);
        self.trial.as_mut()[..L::DEPENDENTS].copy_from_slice(&coordinates);
        for group in 0..L::GROUPS.len() {
            self.newton
                .sine(&self.closure, group, &instant, &mut self.trial);
        }
        self.closure.outputs(&instant, &self.trial, values);
    }
}
