//! Numbers of a whole run, and what is found of it for them.

use super::QuantityInfo;

/// A number of a whole run.
#[derive(Clone, Debug)]
pub struct MeasureInfo {
    /// Name and unit.
    pub quantity: QuantityInfo,
    /// The primitives that it is made of, by index.
    pub uses: Vec<usize>,
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
}

/// A moment of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Moment {
    /// Its begin.
    Start,
    /// Its end.
    End,
    /// Just after a mode is entered; the last time, or the first.
    Enter(usize, bool),
    /// Just before a mode is left; the last time, or the first.
    Leave(usize, bool),
    /// Just before an event of this name; the last time, or the first.
    Before(String, bool),
    /// Just after an event of this name; the last time, or the first.
    After(String, bool),
}
