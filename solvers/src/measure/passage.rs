//! Where a quantity passes zero.

use super::GRID;
use super::grid::{Grid, Sampler};
use super::window::windows;

/// A place of the run: the number of its piece, and the time.
pub(super) type Place = (usize, f64);

/// The passages that have been seen so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Passages {
    /// How many.
    count: usize,
    /// The first and the last one.
    ends: Option<(Place, Place)>,
    /// Whether the quantity is above zero where was looked last.
    above: Option<bool>,
    /// The end of what has been looked at, where zero is reached there from below.
    reached: Option<Place>,
}

impl Passages {
    /// Looks at a step.
    pub(super) fn look(&mut self, index: usize, grid: &Grid<'_>, sampler: &mut Sampler<'_>) {
        let (from, to) = grid.ends();
        let values = grid.column(index);
        let begins = values[0] > 0.0;
        // A run that begins at zero passes it there; at an event a quantity may jump over it.
        let leaves = self.above.is_none() && values[0] == 0.0 && values[1] < 0.0;
        if leaves || self.above.is_some_and(|above| above != begins) {
            self.found((grid.number, from));
        }
        for (begin, end) in windows(Some(index), grid, sampler) {
            if begin > from || !begins {
                self.found((grid.number, begin));
            }
            if end < to || values[GRID] <= 0.0 {
                self.found((grid.number, end));
            }
        }
        self.above = Some(values[GRID] > 0.0);
        let reaches = values[GRID] == 0.0 && values[GRID - 1] < 0.0;
        self.reached = reaches.then_some((grid.number, to));
    }

    fn found(&mut self, place: Place) {
        self.count += 1;
        let first = self.ends.map_or(place, |ends| ends.0);
        self.ends = Some((first, place));
    }

    /// How many there are, and the first and the last one, once all steps have been looked at.
    pub(super) fn finish(mut self) -> (usize, Option<(Place, Place)>) {
        if let Some(place) = self.reached {
            self.found(place);
        }
        (self.count, self.ends)
    }
}
