//! Names of other notations, and how the same is written here.

use super::Lowering;
use crate::resolve::Role;
use crate::unit;

/// How something is written here that other notations have under this name.
pub(super) fn elsewhere(name: &str) -> Option<&'static str> {
    Some(match name {
        "log" => "write `ln(x)` for the natural logarithm, `log10(x)` for the decimal one",
        "e" => "write `exp(x)` for a power of e",
        "pow" => "write a power as `x^2`",
        "arcsin" | "arccos" | "arctan" | "arctan2" => "write `asin`, `acos`, `atan` or `atan2`",
        "sgn" | "signum" => "write `sign(x)`",
        "fabs" => "write `abs(x)`",
        "d" | "dt" | "der" | "ddt" => "write `dot(x)`, or `ddot(x)` for the second derivative",
        "cot" => "write `1/tan(x)`",
        "sec" => "write `1/cos(x)`",
        "t" => "the time is called `time`",
        "PI" | "Pi" | "π" => "write `pi`",
        _ => return None,
    })
}

/// What a function with another number of arguments may be meant to be.
pub(super) fn other_count(name: &str, found: usize) -> Option<&'static str> {
    Some(match (name, found) {
        ("dot", 2) => "a second derivative is `ddot(x)`, a partial one `diff(f, x)`",
        ("diff", 1) => "a partial derivative is `diff(f, x)`, one by the time `dot(f)`",
        ("atan", 2) => "write `atan2(y, x)`",
        ("max", 1) => "the largest value of a run is `peak(x)`, in a `measure`",
        ("min", 1) => "the smallest value of a run is `lowest(x)`, in a `measure`",
        _ => return None,
    })
}

/// A unit that is written as a quotient or product of names.
pub(super) fn unit_name(name: &str) -> Option<String> {
    unit::is_unit(name).then(|| {
        format!(
            "`{name}` is a unit: one that is more than one name stands in brackets, as in `9.81 [m/s^2]`"
        )
    })
}

/// Endings of names that mean a time derivative elsewhere.
const ENDINGS: &[(&str, &str)] = &[
    ("_ddot", "ddot"),
    ("_dot", "dot"),
    ("_dd", "ddot"),
    ("_d", "dot"),
    ("ddot", "ddot"),
    ("dot", "dot"),
    ("dd", "ddot"),
    ("d", "dot"),
];

impl Lowering<'_> {
    /// A derivative that is written as a name: `xdot`, `x_ddot`, `dx`.
    pub(super) fn derivative_named(&self, name: &str) -> Option<String> {
        let endings = ENDINGS.iter();
        let behind = endings.filter_map(|(end, word)| Some((*word, name.strip_suffix(end)?)));
        let before = name.strip_prefix('d').map(|base| ("dot", base));
        let mut found = behind.chain(before).filter(|(_, base)| self.moves(base));
        let (word, base) = found.next()?;
        Some(format!("a time derivative is written `{word}({base})`"))
    }

    fn moves(&self, name: &str) -> bool {
        let entry = self.names.table.get(name);
        entry.is_some_and(|entry| matches!(entry.role, Role::Coordinate(_) | Role::State(_)))
    }
}
