//! Room for the guards of a mode, taken once for a motion.

use crate::model::Flow;

/// Values and rates of the guards of a mode.
#[derive(Clone, Debug, Default)]
pub(in crate::hybrid) struct Guards {
    /// The values, then the rates.
    numbers: Vec<f64>,
    /// How many of each.
    count: usize,
}

impl Guards {
    /// Room for so many guards. What it holds is of others then.
    pub fn resize(&mut self, count: usize) {
        self.count = count;
        if self.numbers.len() < 2 * count {
            self.numbers.resize(2 * count, 0.0);
        }
    }

    /// The values.
    #[inline(always)]
    pub fn values(&self) -> &[f64] {
        &self.numbers[..self.count]
    }

    /// The rates.
    #[inline(always)]
    pub fn rates(&self) -> &[f64] {
        &self.numbers[self.count..2 * self.count]
    }

    /// Values and rates.
    #[inline(always)]
    pub fn both_mut(&mut self) -> (&mut [f64], &mut [f64]) {
        self.numbers[..2 * self.count].split_at_mut(self.count)
    }

    /// Fills with zeros.
    pub fn clear(&mut self) {
        self.numbers[..2 * self.count].fill(0.0);
    }

    /// Computes the guards at a time and state.
    #[inline(always)]
    pub fn look(&mut self, flow: &Flow<'_>, time: f64, state: &[f64]) {
        let (values, rates) = self.both_mut();
        flow.guards(time, state, values, rates);
    }
}

/// Parts of a step that are kept: those that several guards are looked at in are the first ones.
const KEPT: usize = 10;

/// All guards at the first parts of a step that have been looked at.
#[derive(Clone, Debug, Default)]
pub(in crate::hybrid) struct Seen {
    parts: [f64; KEPT],
    length: usize,
    /// The guards at one part after the other: values, then rates.
    numbers: Vec<f64>,
    /// The number of guards.
    count: usize,
}

impl Seen {
    /// Room for so many guards.
    fn resize(&mut self, count: usize) {
        self.count = count;
        self.length = 0;
        if self.numbers.len() < 2 * KEPT * count {
            self.numbers.resize(2 * KEPT * count, 0.0);
        }
    }

    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.length = 0;
    }

    /// Value and rate of a guard at a part, if that has been looked at.
    #[inline(always)]
    pub fn find(&self, part: f64, guard: usize) -> Option<(f64, f64)> {
        let mut parts = self.parts[..self.length].iter();
        let begin = 2 * self.count * parts.position(|one| *one == part)?;
        let value = self.numbers[begin + guard];
        Some((value, self.numbers[begin + self.count + guard]))
    }

    /// Room for the values and rates at another part, as long as there is some.
    #[inline(always)]
    pub fn next(&mut self, part: f64) -> Option<(&mut [f64], &mut [f64])> {
        let place = self.length;
        *self.parts.get_mut(place)? = part;
        self.length += 1;
        let numbers = self.numbers.chunks_exact_mut(2 * self.count).nth(place)?;
        Some(numbers.split_at_mut(self.count))
    }
}

/// The guards in several places.
#[derive(Clone, Debug, Default)]
pub(in crate::hybrid) struct Room {
    /// At the begin of a step.
    pub begin: Guards,
    /// At its end.
    pub end: Guards,
    /// At the instant that a motion has come to.
    pub here: Guards,
    /// Anywhere.
    pub there: Guards,
    /// At the parts of a step that have been looked at.
    pub seen: Seen,
    /// The terms of which they are made.
    pub terms: Guards,
    /// The parts of a step just before and at which guards bend, the first one first.
    pub bends: Vec<(f64, f64)>,
    /// At the end of a step of which parts are looked at.
    pub last: Guards,
}

impl Room {
    /// How far the angles turn, which stand behind so many guards, in a step of a length.
    pub fn turned(&self, guards: usize, length: f64) -> f64 {
        let mut turned = 0.0;
        let (begin, end) = (&self.begin, &self.end);
        for angle in guards..end.values().len() {
            let change = (end.values()[angle] - begin.values()[angle]).abs();
            let rate = begin.rates()[angle].abs().max(end.rates()[angle].abs());
            turned = change.max(length * rate).max(turned);
        }
        turned
    }

    /// Room for so many guards, kinks and angles.
    pub fn resize(&mut self, count: usize) {
        for guards in [
            &mut self.begin,
            &mut self.end,
            &mut self.last,
            &mut self.here,
            &mut self.there,
            &mut self.terms,
        ] {
            guards.resize(count);
        }
        self.seen.resize(count);
    }
}
