//! Numbers of a whole run, and what is found of it for them.

use super::QuantityInfo;
use crate::token::Span;

/// A number of a whole run.
#[derive(Clone, Debug)]
pub struct MeasureInfo {
    /// Name and unit.
    pub quantity: QuantityInfo,
    /// The primitives that it is made of, by index.
    pub uses: Vec<usize>,
}

/// What a scene seeks.
#[derive(Clone, Debug, PartialEq)]
pub struct SynthesisInfo {
    /// The constants that are varied.
    pub varied: Vec<VariedInfo>,
    /// The measures that must not be below zero, the most important first.
    pub conditions: Vec<usize>,
    /// The measures that had better not be below zero, each with what it costs per unit of what is missed.
    pub preferences: Vec<(usize, f64)>,
    /// The measure that is made small.
    pub objective: usize,
    /// The measures of whose squares it is the sum, if it is one.
    pub squares: Vec<usize>,
    /// What follows from a condition while designs are sought.
    pub solved: Option<SolvedInfo>,
}

/// Constants that follow from a condition, a polynomial in them.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedInfo {
    /// The condition.
    pub text: String,
    /// Their places among those that are varied.
    pub unknowns: Vec<usize>,
    /// The terms of the polynomial.
    pub terms: Vec<TermInfo>,
    /// The one of them, by its place here, but for which terms that move are linear in all together.
    pub scanned: Option<usize>,
    /// The one that stands alone in a term that does not move.
    pub free: Option<usize>,
    /// The groups of loops that the coefficients need, in their order.
    pub groups: Vec<usize>,
}

/// A term of a polynomial.
#[derive(Clone, Debug, PartialEq)]
pub struct TermInfo {
    /// Its coefficient, by its place among what measures look at.
    pub quantity: usize,
    /// The power of each unknown.
    pub powers: Vec<u32>,
    /// Whether the coefficient is not the same on the whole way.
    pub moves: bool,
}

/// A constant that is varied.
#[derive(Clone, Debug, PartialEq)]
pub struct VariedInfo {
    /// Its name.
    pub name: String,
    /// Where that stands.
    pub place: Span,
    /// Its place among the constants of the scene.
    pub constant: usize,
    /// Lower end of its range, SI units.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// The only values that it may have, in ascending order; none where it may have any.
    pub values: Vec<f64>,
}

/// A number of a run that is found by looking at it.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// What is found.
    pub kind: PrimitiveKind,
    /// The quantity concerned, by its place among those that measures look at.
    pub argument: usize,
    /// Only where this quantity is positive.
    pub window: Option<usize>,
}

/// What is found of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum PrimitiveKind {
    /// The largest value.
    Peak,
    /// The smallest value.
    Lowest,
    /// The mean over the time.
    Mean,
    /// The square root of the mean of the square.
    Rms,
    /// The integral over the time.
    Integral,
    /// How long the quantity is positive.
    Duration,
    /// The way that the quantity covers, forth and back.
    Travel,
    /// The largest distance from the straight line over another quantity, by its place, that is best.
    Straightness(usize),
    /// The value at a moment.
    Value(Moment),
    /// How often a moment comes.
    Count(Moment),
    /// The coefficient of `cos kα` over the turns of an angle: places of the angle and of its rate, and `k`.
    Cosine(usize, usize, u32),
    /// The coefficient of `sin kα`.
    Sine(usize, usize, u32),
    /// The frequency of a vibration about a position of rest, from 1.
    Frequency(u32),
    /// Its share of critical damping.
    Damping(u32),
    /// The modulus of a Floquet multiplier, from 1, the largest first.
    Multiplier(u32),
    /// The distance of a Floquet multiplier from 1, the nearest first.
    Detuning(u32),
}

/// What a scene does, as far as measures are concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// It runs from a time to a time.
    Run,
    /// It seeks a motion that repeats.
    Periodic,
    /// It seeks a position of rest.
    Rest,
    /// It goes through positions.
    Positions,
}

impl PrimitiveKind {
    /// Whether what a scene does has this number.
    pub fn is_of(&self, what: Measured) -> bool {
        match self {
            Self::Frequency(_) | Self::Damping(_) => what == Measured::Rest,
            Self::Multiplier(_) | Self::Detuning(_) => what == Measured::Periodic,
            Self::Value(Moment::End) => true,
            Self::Peak
            | Self::Lowest
            | Self::Mean
            | Self::Rms
            | Self::Travel
            | Self::Straightness(_)
            | Self::Value(Moment::Start | Moment::Passes(..))
            | Self::Count(Moment::Passes(..)) => what != Measured::Rest,
            _ => matches!(what, Measured::Run | Measured::Periodic),
        }
    }
}

/// A moment of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Moment {
    /// Its begin.
    Start,
    /// Its end.
    End,
    /// Where the quantity of this place passes zero; the last time, or the first.
    Passes(usize, bool),
    /// Just after a mode is entered; the last time, or the first.
    Enter(usize, bool),
    /// Just before a mode is left; the last time, or the first.
    Leave(usize, bool),
    /// Just before an event of this name; the last time, or the first.
    Before(String, bool),
    /// Just after an event of this name; the last time, or the first.
    After(String, bool),
}
