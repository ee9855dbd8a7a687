//! What measures find of a run, and what a synthesis seeks by them.

use super::{List, Text};

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
    /// The measures of whose squares it is the sum, by index; none if it is no such sum.
    pub squares: List<usize>,
    /// What follows from a condition while designs are sought.
    pub solved: Option<Solved>,
}

impl Synthesis {
    /// How many of the constants that are varied, the first ones, are chosen while designs are sought.
    pub fn chosen(&self) -> usize {
        self.varied.len() - self.solved.map_or(0, |solved| solved.unknowns.len())
    }

    /// What is made small, and what preferences that are missed cost, from their measures.
    pub fn worth(&self, objective: f64, margin: impl Fn(usize) -> f64) -> f64 {
        let preferences = self.preferences.iter();
        let costs = preferences.map(|(index, cost)| cost * f64::max(-margin(*index), 0.0));
        objective + costs.sum::<f64>()
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

/// Constants that follow from a condition, a polynomial in them, once the others are chosen: those for which the sum of its
/// squares over the way is least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solved {
    /// The condition.
    pub text: Text,
    /// The constants, by their places among those that are varied.
    pub unknowns: List<usize>,
    /// The terms of the polynomial.
    pub terms: List<Term>,
    /// The one of them, by its place here, but for which terms that move are linear in all together.
    pub scanned: Option<usize>,
    /// The one that stands in no term that moves, but in a power of its own in one that does not.
    pub free: Option<usize>,
    /// The groups of loops that have to be closed, in their order.
    pub groups: List<usize>,
}

/// A term of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Its coefficient, a quantity by its index.
    pub quantity: usize,
    /// The power of each unknown.
    pub powers: List<u32>,
    /// Whether the coefficient is not the same on the whole way.
    pub moves: bool,
}

impl Term {
    /// A coefficient, whether it moves, and the power of each unknown.
    #[doc(hidden)]
    pub const fn new(quantity: usize, moves: bool, powers: List<u32>) -> Self {
        Self { quantity, powers, moves }
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
