//! What a position of a motion says.

use assur_solvers::problem::{Phase, Reports};
use assur_solvers::scalar::Scalar;

use super::equations::{Function, Prepare};
use super::room::room;

impl<S: Scalar> Prepare<S> {
    /// Calls a function of the time and the state.
    pub(super) fn at(
        &self,
        function: Function,
        (phase, time, state): (Phase<'_, S>, S, &[S]),
        values: &mut [S],
    ) {
        if let Some(mode) = self.mode(phase.mode) {
            mode.call(function, &[&[time], state, phase.sides], values);
        }
    }
}

/// Implements methods that write values at a time and state, as many as the shape says.
macro_rules! written {
    ($($method:ident: $function:ident, |$shape:ident| $count:expr;)*) => {$(
        fn $method(&self, phase: Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
            let $shape = self.motion.shape;
            self.at(Function::$function, (phase, time, state), &mut values[..$count]);
        }
    )*};
}

impl<S: Scalar> Reports<S> for Prepare<S> {
    written! {
        outputs: Outputs, |shape| shape.outputs.len();
        margins: Margins, |shape| shape.carried.len();
        points: Points, |shape| shape.places();
        measured: Measured, |shape| shape.measured;
    }

    fn drivers(&self, time: S, values: &mut [S]) {
        let count = self.motion.shape.drivers.len();
        if let Some(first) = self.first() {
            first.call(Function::Drivers, &[&[time]], &mut values[..count]);
        }
    }

    fn closures(&self, phase: Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
        let Some(closures) = self.motion.shape.held_in(phase.mode) else { return };
        let Some(mode) = self.mode(phase.mode) else { return };
        let (m, n) = (closures.loops.len(), closures.coordinates);
        let slopes = &mode.program().results.closing.slopes;
        room(2 * m + slopes.len(), |all| {
            self.at(Function::Closures, (phase, time, state), all);
            values.fill(S::ZERO);
            values[..2 * m].copy_from_slice(&all[..2 * m]);
            for ((row, column, _), slope) in slopes.iter().zip(&all[2 * m..]) {
                values[2 * m + row * n + column] = *slope;
            }
        });
    }

    fn energy(&self, phase: Phase<'_, S>, time: S, state: &[S]) -> Option<(S, S)> {
        let mode = self.mode(phase.mode)?;
        if mode.program().results.energy.len() != 2 {
            return None;
        }
        let mut values = [S::ZERO; 2];
        self.at(Function::Energy, (phase, time, state), &mut values);
        Some((values[0], values[1]))
    }

    fn mass(&self, phase: Phase<'_, S>, time: S, state: &[S], rows: &mut [S]) -> bool {
        let n = self.motion.shape.coordinates;
        let count = n * (n + 1) / 2;
        let has_mass = |length: usize| length > 0 && length == count;
        let length = self.mode(phase.mode).map_or(0, |mode| mode.program().results.mass.len());
        if !has_mass(length) {
            return false;
        }
        room(count, |triangle| {
            self.at(Function::Mass, (phase, time, state), triangle);
            for (place, entry) in rows.iter_mut().enumerate() {
                let (row, column) = ((place / n).max(place % n), (place / n).min(place % n));
                *entry = triangle[row * (row + 1) / 2 + column];
            }
        });
        true
    }

    fn measures(&self, found: &[S], values: &mut [S]) {
        let count = self.motion.shape.measures.len();
        if let Some(first) = self.first() {
            first.call(Function::Measures, &[&[], &[], &[], found], &mut values[..count]);
        }
    }
}
