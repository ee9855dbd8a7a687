//! The rows of a programme that matter: of many places of an extreme few are ever the largest.
//!
//! A programme of all of them would take most of the time of a polishing. So it begins with those that are nearest to be held, and
//! takes up others where its solution shows that they are needed: what comes out is the solution for all.

use super::curve::dot;
use super::programme::{Model, Step};

/// Rows of each kind that are taken up at once, over how many numbers there are.
const AT_ONCE: usize = 3;
/// A row is needed where it is passed by more than this part of what rows change by within the region.
const PASSED: f64 = 1e-9;

/// The rows of a programme, of values and of conditions.
pub(super) struct Working {
    values: Kind,
    conditions: Kind,
}

/// Rows of one kind, by index.
struct Kind {
    taken: Vec<usize>,
    /// Others that may matter within the region, those nearest to be held first.
    left: Vec<usize>,
    /// The most that one changes by within the region.
    reach: f64,
}

impl Working {
    /// Those to begin with.
    pub fn new(model: &Model<'_>) -> Self {
        let (slopes, others) = model.slopes();
        let (first, _) = model.aim.parts(&model.look.values);
        let reaches = model.reaches(&slopes[..first.len()]);
        let falls = first.iter().zip(&reaches).map(|(value, reach)| value - reach);
        let least = falls.fold(f64::NEG_INFINITY, f64::max);
        let values =
            Kind::new(reaches, |index, reach| first[index] + reach >= least, |index| -first[index]);
        let all = &model.look.conditions;
        let conditions = Kind::new(
            model.reaches(&others),
            |index, reach| all[index] <= reach,
            |index| all[index],
        );
        let mut working = Self { values, conditions };
        working.take(model, (&|_| true, &|_| true));
        working
    }

    /// Those of the values.
    pub fn values(&self) -> &[usize] {
        &self.values.taken
    }

    /// Those of the conditions.
    pub fn conditions(&self) -> &[usize] {
        &self.conditions.taken
    }

    /// Takes up rows that a step passes by which the largest value comes to this. Whether there are any.
    pub fn extend(&mut self, model: &Model<'_>, step: &Step, largest: f64) -> bool {
        let (slopes, others) = model.slopes();
        let there = |value: f64, row: &[f64]| value + dot(row, &step.way);
        let largest = largest + PASSED * self.values.reach;
        let missed = step.missed + PASSED * self.conditions.reach;
        let look = model.look;
        let is_larger = |row: usize| there(look.values[row], slopes[row]) > largest;
        let is_missed = |row: usize| there(look.conditions[row], others[row]) < -missed;
        self.take(model, (&is_larger, &is_missed))
    }

    fn take(
        &mut self,
        model: &Model<'_>,
        (is_larger, is_missed): (&dyn Fn(usize) -> bool, &dyn Fn(usize) -> bool),
    ) -> bool {
        let (slopes, others) = model.slopes();
        let most = AT_ONCE * model.room.len();
        // A value that is the same twice, slopes and all, is one.
        let is_same = |values: &[f64], slopes: &[&[f64]], a: usize, b: usize| {
            values[a] == values[b] && slopes[a] == slopes[b]
        };
        let look = model.look;
        let of_values =
            self.values.take(most, is_larger, |a, b| is_same(&look.values, &slopes, a, b));
        let of_conditions =
            self.conditions.take(most, is_missed, |a, b| is_same(&look.conditions, &others, a, b));
        of_values || of_conditions
    }
}

impl Kind {
    /// Rows that may matter where they change by so much, in the order of a rank.
    fn new(
        reaches: Vec<f64>,
        may_matter: impl Fn(usize, f64) -> bool,
        rank: impl Fn(usize) -> f64,
    ) -> Self {
        let all = reaches.iter().enumerate();
        let mut left: Vec<usize> =
            all.filter(|(index, reach)| may_matter(*index, **reach)).map(|one| one.0).collect();
        left.sort_by(|a, b| rank(*a).total_cmp(&rank(*b)));
        Self { taken: Vec::new(), left, reach: reaches.iter().copied().fold(0.0, f64::max) }
    }

    /// Takes up so many rows at most that are needed. Whether there are any.
    fn take(
        &mut self,
        most: usize,
        is_needed: &dyn Fn(usize) -> bool,
        is_same: impl Fn(usize, usize) -> bool,
    ) -> bool {
        let before = self.taken.len();
        for row in std::mem::take(&mut self.left) {
            if self.taken.len() == before + most || !is_needed(row) {
                self.left.push(row);
            } else if !self.taken.iter().any(|other| is_same(*other, row)) {
                self.taken.push(row);
            }
        }
        self.taken.len() > before
    }
}
