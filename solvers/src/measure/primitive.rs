//! What has been found so far of what is asked of a run.

use super::extreme::Hunt;
use super::grid::{Grid, Sampler};
use super::harmonic;
use super::passage::Passages;
use super::quadrature::integral;
use super::straight::Straight;
use super::travel::travel;
use super::window::windows;
use crate::shape::{Kind, Moment, Primitive};
use assur_functions::Sense;

/// Why a run has no such number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Missing {
    /// The mode is never entered.
    NeverEntered(usize),
    /// The mode is never left.
    NeverLeft(usize),
    /// No event of this name happens.
    NeverHappens(&'static str),
    /// The condition holds at no time.
    NeverHolds,
    /// The two sides are nowhere equal.
    NeverPasses,
    /// The run has no length.
    Empty,
    /// The angle makes so many turns, which is not a whole number of them.
    NotWhole(f64),
    /// It is a number of a position of rest, and this moves.
    Moves,
    /// There are fewer vibrations.
    NoVibration {
        /// The one that is asked for.
        number: u32,
        /// How many there are.
        count: usize,
    },
    /// There are fewer multipliers.
    NoMultiplier {
        /// The one that is asked for.
        number: u32,
        /// How many there are.
        count: usize,
    },
    /// Nobody asked for it.
    NotLookedFor,
    /// The quantity is not a finite number somewhere.
    NotFinite,
}

impl Missing {
    /// The reason in words, with the names of the modes.
    pub fn text(&self, modes: &[&str]) -> String {
        let name = |mode: &usize| modes.get(*mode).copied().unwrap_or("?");
        match self {
            Self::NeverEntered(mode) => format!("the mode `{}` is never entered", name(mode)),
            Self::NeverLeft(mode) => format!("the mode `{}` is never left", name(mode)),
            Self::NeverHappens(event) => format!("the event `{event}` never happens"),
            Self::NeverHolds => "its condition never holds".to_string(),
            Self::NeverPasses => "its two sides are nowhere equal".to_string(),
            Self::NoMultiplier { number, count } => {
                format!("there is no multiplier number {number}: there are {count}")
            }
            Self::Empty => "the run has no length".to_string(),
            Self::NotWhole(turns) => format!(
                "the angle makes {turns:.6} turns, and harmonics need a whole number of them"
            ),
            Self::Moves => "it is a number of a position of rest, and this moves".to_string(),
            Self::NoVibration { number, count } => format!(
                "there is no vibration number {number}: {count} disturbances vibrate, the others die out or grow without"
            ),
            Self::NotLookedFor => "nobody asked for it".to_string(),
            Self::NotFinite => "it is not a finite number".to_string(),
        }
    }
}

/// What has been found so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// The search for the extreme, if that is what is to be found.
    hunt: Option<Hunt>,
    /// Where a quantity passes zero.
    passages: Passages,
    /// The curve that is to be straight.
    straight: Straight,
    /// The integral, or the way.
    value: f64,
    /// The time that has been looked at.
    time: f64,
    /// The size of what was added up: sums are as exact as this allows.
    size: f64,
}

impl Tally {
    /// Nothing yet.
    pub(super) fn new(primitive: &Primitive) -> Self {
        let hunt = |sense| Some(Hunt::new(primitive.argument, sense));
        let hunt = match primitive.kind {
            Kind::Peak => hunt(Sense::Largest),
            Kind::Lowest => hunt(Sense::Smallest),
            _ => None,
        };
        Self { hunt, ..Self::default() }
    }

    /// Looks at a step.
    pub(super) fn add(
        &mut self,
        primitive: &Primitive,
        grid: &Grid<'_>,
        sampler: &mut Sampler<'_>,
    ) {
        let index = primitive.argument;
        let window = match primitive.kind {
            Kind::Value(Moment::Passes { index, .. })
            | Kind::Count(Moment::Passes { index, .. }) => {
                return self.passages.look(index, grid, sampler);
            }
            Kind::Value(_) | Kind::Count(_) | Kind::Frequency(_) | Kind::Damping(_) => return,
            Kind::Multiplier(_) | Kind::Detuning(_) => return,
            Kind::Duration => Some(index),
            _ => primitive.window,
        };
        for (from, to) in windows(window, grid, sampler) {
            self.time += to - from;
            let times = (from, to);
            if let Some(hunt) = &mut self.hunt {
                hunt.look(times, grid, sampler);
                continue;
            }
            if let Kind::Straightness(along) = primitive.kind {
                self.straight.look((index, along), times, grid, sampler);
                continue;
            }
            let sum = match primitive.kind {
                Kind::Travel => (travel(index, times, grid, sampler), 0.0),
                Kind::Mean | Kind::Integral => {
                    integral(times, grid, sampler, self.size, &|values| values[index])
                }
                Kind::Rms => integral(times, grid, sampler, self.size, &|values| {
                    values[index] * values[index]
                }),
                Kind::Cosine { angle, order } => {
                    integral(times, grid, sampler, self.size, &|values| {
                        values[index] * (f64::from(order) * values[angle.0]).cos() * values[angle.1]
                    })
                }
                Kind::Sine { angle, order } => {
                    integral(times, grid, sampler, self.size, &|values| {
                        values[index] * (f64::from(order) * values[angle.0]).sin() * values[angle.1]
                    })
                }
                _ => (0.0, 0.0),
            };
            self.value += sum.0;
            self.size += sum.1;
        }
    }

    /// The number, once all steps have been looked at.
    pub(super) fn result(
        self,
        primitive: &Primitive,
        sampler: &mut Sampler<'_>,
    ) -> Result<f64, Missing> {
        let nothing = match primitive.window {
            Some(_) => Missing::NeverHolds,
            None => Missing::Empty,
        };
        if let Some(hunt) = self.hunt {
            let (extreme, _) = hunt.finish(sampler).ok_or(nothing)?;
            return Ok(extreme.value);
        }
        match primitive.kind {
            Kind::Duration => Ok(self.time),
            Kind::Integral | Kind::Travel => Ok(self.value),
            Kind::Straightness(along) => {
                self.straight.finish((primitive.argument, along), sampler).ok_or(nothing)
            }
            Kind::Count(_) => Ok(self.passages.finish().0 as f64),
            Kind::Value(moment) => {
                let (first, last) = self.passages.finish().1.ok_or(Missing::NeverPasses)?;
                let is_last = matches!(moment, Moment::Passes { last: true, .. });
                let (number, time) = if is_last { last } else { first };
                let piece = &sampler.motion.pieces[number];
                Ok(sampler.at(piece, time)[primitive.argument])
            }
            Kind::Mean if self.time > 0.0 => Ok(self.value / self.time),
            Kind::Rms if self.time > 0.0 => Ok((self.value / self.time).sqrt()),
            Kind::Cosine { angle, order } | Kind::Sine { angle, order } => {
                Ok(harmonic::scaled(self.value, order, harmonic::turns(angle.0, sampler)?))
            }
            _ => Err(nothing),
        }
    }
}
