//! Words for the time after which a motion repeats.

use crate::show::number;

/// What the multipliers count by: the time after which the motion repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turn {
    /// Periods until the motion repeats.
    pub periods: usize,
}

impl Turn {
    /// One of them: `period`, `turn of 2 periods`.
    pub fn one(self) -> String {
        self.name("period", "turn")
    }

    /// So many of them: `1 period`, `8.19 turns of 2 periods`.
    pub fn count(self, count: f64) -> String {
        match number::short(number::rounded(count, 3)).as_str() {
            "1" => format!("1 {}", self.one()),
            count => format!("{count} {}", self.name("periods", "turns")),
        }
    }

    /// So many of them as it stands behind `every`, where one is not counted.
    pub fn every(self, count: f64) -> String {
        let text = self.count(count);
        text.strip_prefix("1 ").map_or(text.clone(), str::to_owned)
    }

    fn name(self, period: &str, turn: &str) -> String {
        match self.periods {
            0 | 1 => period.to_owned(),
            periods => format!("{turn} of {periods} periods"),
        }
    }
}
