//! What is sought, and what a design is worth.

use std::fmt;

/// A number that is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sought {
    /// Lower bound.
    pub low: f64,
    /// Upper bound.
    pub high: f64,
    /// Whether both bounds are the same design, as those of an angle over a whole turn.
    pub is_turn: bool,
}

impl Sought {
    /// Between two bounds.
    pub const fn between(low: f64, high: f64) -> Self {
        Self { low, high, is_turn: false }
    }

    /// Anywhere on a circle.
    pub const fn around(low: f64, high: f64) -> Self {
        Self { low, high, is_turn: true }
    }

    /// Its range.
    pub fn width(&self) -> f64 {
        self.high - self.low
    }

    /// The way from one of its values to another, the shorter one of a circle.
    pub fn way(&self, from: f64, to: f64) -> f64 {
        let way = to - from;
        match self.is_turn {
            true => way - (way / self.width()).round() * self.width(),
            false => way,
        }
    }

    /// A value within the bounds: on a circle the same one, else half-way from a value that is within to the bound.
    pub fn within(&self, value: f64, from: f64) -> f64 {
        if self.is_turn {
            return self.low + (value - self.low).rem_euclid(self.width());
        }
        match value {
            value if value < self.low => 0.5 * (self.low + from),
            value if value > self.high => 0.5 * (self.high + from),
            value => value,
        }
    }
}

/// What a design is worth. Of two the one that misses less is better, whatever its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Score {
    /// By how much mandatory conditions are missed; zero where all hold.
    pub missed: f64,
    /// What is to be small.
    pub value: f64,
}

impl Score {
    /// Of a design that nothing can be said of.
    pub const WORST: Self = Self { missed: f64::INFINITY, value: f64::INFINITY };

    /// Of a design that keeps all conditions.
    pub const fn kept(value: f64) -> Self {
        Self { missed: 0.0, value }
    }

    /// Of a design that misses some.
    pub const fn missing(missed: f64) -> Self {
        Self { missed, value: f64::INFINITY }
    }

    /// Whether it keeps all conditions.
    pub fn is_kept(&self) -> bool {
        self.missed == 0.0 && self.value.is_finite()
    }

    /// What it is compared by. What is no number is worst.
    fn rank(&self) -> (f64, f64) {
        match self.missed {
            missed if missed > 0.0 => (missed, 0.0),
            missed if missed == 0.0 && !self.value.is_nan() => (0.0, self.value),
            _ => (f64::INFINITY, f64::INFINITY),
        }
    }

    /// Whether it is no worse than another.
    pub fn is_as_good_as(&self, other: &Self) -> bool {
        self.rank() <= other.rank()
    }

    /// The better one before the other.
    pub fn order(&self, other: &Self) -> std::cmp::Ordering {
        let (a, b) = (self.rank(), other.rank());
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    }
}

/// What designs are judged by.
pub trait Judge: Sync {
    /// The numbers that are sought.
    fn sought(&self) -> &[Sought];

    /// Judges designs, one behind the other in the list, each of as many numbers as are sought. What it says of one must
    /// not depend on the others: how they are shared among threads is not told. At first the scores hold what each design has to be
    /// as good as; of one that is certainly worse any worse score will do.
    fn judge(&self, designs: &[f64], scores: &mut [Score]);
}

/// Whether there is something to seek.
pub(super) fn check(sought: &[Sought]) -> Result<(), SynthesisError> {
    if sought.is_empty() {
        return Err(SynthesisError::Nothing);
    }
    for (index, &Sought { low, high, .. }) in sought.iter().enumerate() {
        if !(low < high && (high - low).is_finite()) {
            return Err(SynthesisError::BadBounds { sought: index, low, high });
        }
    }
    Ok(())
}

/// Why nothing can be sought.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SynthesisError {
    /// There is nothing to vary.
    Nothing,
    /// Bounds that leave nothing between them, or are no numbers.
    BadBounds {
        /// Which number, counted from zero.
        sought: usize,
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
    /// A population that cannot be crossed.
    BadPopulation {
        /// What was asked for.
        size: usize,
        /// What is needed.
        least: usize,
    },
    /// A start that belongs to another problem.
    OtherProblem {
        /// Numbers of a design there.
        found: usize,
        /// Numbers of a design here.
        expected: usize,
    },
    /// The design that is to be polished cannot be judged.
    NotJudged,
}

impl fmt::Display for SynthesisError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => write!(formatter, "nothing is varied; say what may change"),
            Self::BadBounds { sought, low, high } => write!(
                formatter,
                "number {sought} is to lie between {low} and {high}; expected two finite bounds, the lower one first"
            ),
            Self::BadPopulation { size, least } => {
                write!(
                    formatter,
                    "a population of {size} cannot be crossed; choose at least {least}"
                )
            }
            Self::OtherProblem { found, expected } => write!(
                formatter,
                "the population that is to go on has designs of {found} numbers, this problem of {expected}: it belongs to \
                 another one"
            ),
            Self::NotJudged => write!(
                formatter,
                "the design that is to be polished cannot be judged: it does not assemble, or gives what is no number"
            ),
        }
    }
}

impl std::error::Error for SynthesisError {}
