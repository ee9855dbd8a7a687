//! Names that belong to the language.

/// Functions of the language, which no declaration may hide.
pub const FUNCTIONS: &[&str] = &[
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sinh",
    "cosh",
    "tanh",
    "exp",
    "ln",
    "log10",
    "sqrt",
    "hypot",
    "erf",
    "normal_cdf",
    "floor",
    "mod",
    "abs",
    "sign",
    "max",
    "min",
    "dot",
    "ddot",
    "diff",
    "sum",
    "inner",
    "cross",
    "norm",
    "dir",
    "rot",
    "rotx",
    "roty",
    "rotz",
];

/// Quantities of the language.
pub const QUANTITIES: &[&str] = &["time", "pi"];

/// Functions that only a measure knows.
pub const MEASURING: &[&str] = &[
    "peak",
    "lowest",
    "mean",
    "rms",
    "total",
    "duration",
    "value",
    "count",
    "cosine",
    "sine",
    "amplitude",
    "frequency",
    "damping",
    "multiplier",
    "detuning",
    "travel",
    "straightness",
];

/// What says when, in a measure: `value(x, end)`, `value(x, last(y == z))`.
pub const MOMENTS: &[&str] = &["end", "last", "enter", "leave"];

/// Those of them that positions have as well as motions.
pub const POSITIONAL: &[&str] =
    &["peak", "lowest", "mean", "rms", "value", "travel", "straightness"];

/// What is found of a formula while a variable goes over a range: `integral(f, x, a .. b)`. Quantities may have these names.
pub const SEARCHES: &[&str] =
    &["integral", "root", "peak", "lowest", "peak_at", "lowest_at", "solve"];

/// Names of the components of a vector.
pub const COMPONENTS: [&str; 3] = ["x", "y", "z"];
