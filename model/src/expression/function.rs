//! The functions and relations of the language, and what they mean on numbers: the same as `Scalar` of the solvers, to
//! the last bit, which the tests of the macros hold.

/// A function of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Log10,
    Sqrt,
    Hypot,
    Erf,
    NormalCdf,
    Floor,
    /// `|x|`
    Abs,
    /// −1, 0 or 1
    Sign,
    /// The larger of two.
    Max,
    /// The smaller of two.
    Min,
    /// `x^y` for any real `y`
    Power,
    /// `e^x − 1` without cancellation
    ExpM1,
    /// `ln(1 + x)` without cancellation
    Ln1p,
}

/// A relation between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Relation {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `==`
    Equal,
}

impl Relation {
    /// Whether it holds between two numbers.
    pub fn holds(self, left: f64, right: f64) -> bool {
        match self {
            Self::Less => left < right,
            Self::LessEqual => left <= right,
            Self::Equal => left == right,
        }
    }
}

impl Function {
    /// The value of a function of one or two numbers.
    pub fn apply(self, x: &[f64]) -> f64 {
        let second = || x.get(1).copied().unwrap_or(f64::NAN);
        let Some(first) = x.first().copied() else {
            return f64::NAN;
        };
        match self {
            Self::Sin => first.sin(),
            Self::Cos => first.cos(),
            Self::Tan => first.tan(),
            Self::Asin => first.asin(),
            Self::Acos => first.acos(),
            Self::Atan => first.atan(),
            Self::Atan2 => first.atan2(second()),
            Self::Sinh => first.sinh(),
            Self::Cosh => first.cosh(),
            Self::Tanh => first.tanh(),
            Self::Exp => first.exp(),
            Self::Ln => first.ln(),
            Self::Log10 => first.log10(),
            Self::Sqrt => first.sqrt(),
            Self::Hypot => first.hypot(second()),
            Self::Erf => assur_functions::erf(first),
            Self::NormalCdf => assur_functions::normal_cdf(first),
            Self::Floor => first.floor(),
            Self::Abs => first.abs(),
            // Zero of either sign and NaN give themselves.
            Self::Sign if first > 0.0 => 1.0,
            Self::Sign if first < 0.0 => -1.0,
            Self::Sign => first,
            Self::Max if second() <= first || first.is_nan() => first,
            Self::Min if first <= second() || first.is_nan() => first,
            Self::Max | Self::Min => second(),
            Self::Power => first.powf(second()),
            Self::ExpM1 => first.exp_m1(),
            Self::Ln1p => first.ln_1p(),
        }
    }
}
