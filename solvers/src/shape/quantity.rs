//! Named numbers with their units.

use super::{List, Text};

/// A unit.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// `1/s`; empty for a pure number.
    pub symbol: Text,
    /// SI value of one such unit.
    pub factor: f64,
    /// Exponents of m, kg, s, A, K, mol, cd as numerator and denominator.
    pub dimension: [(i8, i8); 7],
}

impl Unit {
    /// Of pure numbers.
    pub const NONE: Self = Self::new("", 1.0, [0; 7]);

    /// With whole exponents of m, kg, s, A, K, mol, cd.
    #[doc(hidden)]
    pub const fn new(symbol: Text, factor: f64, exponents: [i8; 7]) -> Self {
        Self::over(symbol, factor, exponents, [1; 7])
    }

    /// With exponents that are fractions.
    #[doc(hidden)]
    pub const fn over(symbol: Text, factor: f64, above: [i8; 7], below: [i8; 7]) -> Self {
        let mut dimension = [(0, 1); 7];
        let mut base = 0;
        while base < 7 {
            dimension[base] = (above[base], below[base]);
            base += 1;
        }
        Self { symbol, factor, dimension }
    }
}

/// A named quantity with the unit in which it is printed.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Name as the equation file writes it, `dot(phi2)` for a derivative.
    pub name: Text,
    /// Documentation.
    pub summary: Text,
    /// Unit in which the value is printed, `1/s`; empty for a pure number.
    pub unit: Text,
    /// SI value of one such unit.
    pub factor: f64,
    /// Exponents of m, kg, s, A, K, mol, cd as numerator and denominator.
    pub dimension: [(i8, i8); 7],
}

impl Quantity {
    /// A quantity in a unit.
    #[doc(hidden)]
    pub const fn new(name: Text, summary: Text, unit: Unit) -> Self {
        Self { name, summary, unit: unit.symbol, factor: unit.factor, dimension: unit.dimension }
    }
}

/// Distribution of a made size.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Distribution {
    /// Half-width is three standard deviations.
    #[default]
    Normal,
    /// All within the half-width alike.
    Uniform,
    /// Normal with the half-width as three standard deviations, cut off there.
    Truncated,
    /// Of what is above zero, with the half-width as three standard deviations about its mean; its logarithm is normal.
    Lognormal {
        /// The half-width over the mean.
        ratio: f64,
    },
}

impl Distribution {
    /// The same about another mean, or with another half-width.
    #[must_use]
    pub fn about(self, half_width: f64, mean: f64) -> Self {
        match self {
            Self::Lognormal { .. } => Self::Lognormal { ratio: half_width / mean },
            other => other,
        }
    }

    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Uniform => "uniform",
            Self::Truncated => "truncated",
            Self::Lognormal { .. } => "lognormal",
        }
    }
}

/// A dimension or parameter.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    /// Name, unit and documentation.
    pub quantity: Quantity,
    /// Whether it is a made dimension.
    pub is_dimension: bool,
    /// Value in SI units unless another is given (the scene's preset applied).
    pub default: f64,
    /// Permitted error of the made size, SI units; zero if none is stated.
    pub tolerance: f64,
    /// How the made sizes are distributed.
    pub distribution: Distribution,
    /// Permitted range in SI units, from `in lo .. hi`; infinite where open.
    pub range: (f64, f64),
}

impl Constant {
    /// A parameter in its range; its default comes with the scene.
    #[doc(hidden)]
    pub const fn parameter(quantity: Quantity, low: f64, high: f64) -> Self {
        Self {
            quantity,
            is_dimension: false,
            default: 0.0,
            tolerance: 0.0,
            distribution: Distribution::Normal,
            range: (low, high),
        }
    }

    /// A made dimension.
    #[doc(hidden)]
    pub const fn dimension(quantity: Quantity, low: f64, high: f64) -> Self {
        Self { is_dimension: true, ..Self::parameter(quantity, low, high) }
    }

    /// With a tolerance.
    #[doc(hidden)]
    pub const fn made(mut self, tolerance: f64, distribution: Distribution) -> Self {
        (self.tolerance, self.distribution) = (tolerance, distribution);
        self
    }

    /// Those of a mechanism at some places, with the defaults of a scene.
    #[doc(hidden)]
    pub const fn some<const N: usize>(
        all: List<Self>,
        places: [usize; N],
        defaults: [f64; N],
    ) -> [Self; N] {
        let nothing = Quantity::new("", "", Unit::NONE);
        let mut some = [Self::parameter(nothing, 0.0, 0.0); N];
        let mut index = 0;
        while index < N {
            some[index] = all[places[index]];
            some[index].default = defaults[index];
            index += 1;
        }
        some
    }
}
