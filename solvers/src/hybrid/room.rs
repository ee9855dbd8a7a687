//! Room for the guards of a mode, taken once for a motion.

use super::problem::Modes;

/// Values and rates of the guards of a mode.
#[derive(Clone, Debug, Default)]
pub(super) struct Guards {
    pub values: Vec<f64>,
    pub rates: Vec<f64>,
}

impl Guards {
    /// Room for so many guards; within what there has been, nothing is allocated.
    pub fn resize(&mut self, count: usize) {
        self.values.resize(count, 0.0);
        self.rates.resize(count, 0.0);
    }

    /// Fills with zeros.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
        self.rates.fill(0.0);
    }

    /// Computes the guards at a time and state.
    #[inline(always)]
    pub fn look<E: Modes<f64>>(&mut self, equations: &E, time: f64, state: &E::State) {
        equations.look(time, state, &mut self.values, &mut self.rates);
    }
}

/// Parts of a step that are kept: those that several guards are looked at in are the first ones.
const KEPT: usize = 10;

/// All guards at the first parts of a step that have been looked at.
#[derive(Clone, Debug, Default)]
pub(super) struct Seen {
    parts: [f64; KEPT],
    length: usize,
    guards: [Guards; KEPT],
}

impl Seen {
    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.length = 0;
    }

    /// The guards at a part, if it has been looked at.
    #[inline(always)]
    pub fn find(&self, part: f64) -> Option<&Guards> {
        let mut parts = self.parts[..self.length.min(KEPT)].iter();
        parts
            .position(|one| *one == part)
            .map(|place| &self.guards[place])
    }

    /// Room for the guards at another part.
    #[inline(always)]
    pub fn next(&mut self, part: f64) -> Option<&mut Guards> {
        let place = self.length;
        let guards = self.guards.get_mut(place)?;
        self.parts[place] = part;
        self.length += 1;
        Some(guards)
    }
}

/// The guards in several places.
#[derive(Clone, Debug, Default)]
pub(super) struct Room {
    /// At the begin of a step.
    pub begin: Guards,
    /// At its end.
    pub end: Guards,
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
        for angle in guards..self.end.values.len() {
            let change = (self.end.values[angle] - self.begin.values[angle]).abs();
            let rate = self.begin.rates[angle]
                .abs()
                .max(self.end.rates[angle].abs());
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
            &mut self.there,
            &mut self.terms,
        ] {
            guards.resize(count);
        }
        self.seen.clear();
        for guards in &mut self.seen.guards {
            guards.resize(count);
        }
    }
}
