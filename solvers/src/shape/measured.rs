//! What measures find of a run, and what a synthesis seeks by them.

use super::List;

/// A number of a run that is found by looking at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Primitive {
    /// What is found.
    pub kind: Kind,
    /// The quantity concerned, by index.
    pub argument: usize,
    /// Only where this quantity, by index, is positive.
    pub window: Option<usize>,
}

impl Primitive {
    /// A number of the whole run.
    #[doc(hidden)]
    pub const fn of(kind: Kind, argument: usize) -> Self {
        Self { kind, argument, window: None }
    }

    /// Only where this quantity is positive.
    #[doc(hidden)]
    pub const fn within(mut self, window: usize) -> Self {
        self.window = Some(window);
        self
    }
}

/// What a scene seeks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Synthesis {
    /// The constants that are varied.
    pub varied: List<Varied>,
    /// The measures that must not be below zero, by index, the most important first.
    pub conditions: List<usize>,
    /// The measures that had better not be below zero, by index, each with what is added to what is made small per unit of what
    /// is missed.
    pub preferences: List<(usize, f64)>,
    /// The measure that is made small, by index.
    pub objective: usize,
}

impl Synthesis {
    /// What is made small, with what preferences that are missed cost, from the measures.
    pub fn worth(&self, measure: impl Fn(usize) -> f64) -> f64 {
        let preferences = self.preferences.iter();
        let costs = preferences.map(|(index, cost)| cost * f64::max(-measure(*index), 0.0));
        measure(self.objective) + costs.sum::<f64>()
    }
}

/// A constant that a synthesis chooses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Varied {
    /// Its index.
    pub constant: usize,
    /// Lower end of its range, SI units.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// The only values that it may have, in ascending order; none where it may have any.
    pub values: List<f64>,
}

impl Varied {
    /// A constant with its range, and the only values that it may have.
    #[doc(hidden)]
    pub const fn new(constant: usize, (from, to): (f64, f64), values: List<f64>) -> Self {
        Self { constant, from, to, values }
    }
}

/// What is found of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The largest value.
    Peak,
    /// The smallest value.
    Lowest,
    /// The mean over the time.
    Mean,
    /// The square root of the mean of the square over the time.
    Rms,
    /// The integral over the time.
    Integral,
    /// How long the quantity is positive.
    Duration,
    /// The way that the quantity covers, forth and back.
    Travel,
    /// The largest distance, along the quantity, from that straight line over another quantity, by its index, for which it is
    /// least.
    Straightness(usize),
    /// The value at a moment.
    Value(Moment),
    /// How often a moment comes.
    Count(Moment),
    /// `1/π ∫ x cos kα dα` over the turns of an angle, per turn; for `k = 0` the mean over the angle.
    Cosine {
        /// The angle and its time derivative, by index.
        angle: (usize, usize),
        /// The number of the harmonic.
        order: u32,
    },
    /// `1/π ∫ x sin kα dα` over the turns of an angle, per turn.
    Sine {
        /// The angle and its time derivative, by index.
        angle: (usize, usize),
        /// The number of the harmonic.
        order: u32,
    },
    /// The frequency of a vibration about a position of rest, 1/s, the slowest being number 1.
    Frequency(u32),
    /// Its share of critical damping.
    Damping(u32),
    /// The modulus of a Floquet multiplier, the largest being number 1.
    Multiplier(u32),
    /// The distance of a Floquet multiplier from 1, at which a resonance lies, the nearest being number 1.
    Detuning(u32),
}

/// A moment of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    /// Its begin.
    Start,
    /// Its end.
    End,
    /// Where a quantity passes zero, the first or the last time.
    Passes {
        /// The quantity, by index.
        index: usize,
        /// The last time.
        last: bool,
    },
    /// Just after a mode is entered, the first or the last time. A run that begins in the mode does not enter it there.
    Enter {
        /// The mode, by index.
        mode: usize,
        /// The last time.
        last: bool,
    },
    /// Just before a mode is left, the first or the last time.
    Leave {
        /// The mode, by index.
        mode: usize,
        /// The last time.
        last: bool,
    },
    /// Just before an event of a name happens, the first or the last time.
    Before {
        /// The event.
        event: NamedEvent,
        /// The last time.
        last: bool,
    },
    /// Just after an event of a name has happened, the first or the last time.
    After {
        /// The event.
        event: NamedEvent,
        /// The last time.
        last: bool,
    },
}

/// What a scene calls by one name: an event, or several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedEvent {
    /// The name.
    pub name: &'static str,
    /// Each by its mode and its index in that mode.
    pub places: &'static [(usize, usize)],
}
