//! What changes the equations of a motion on its way.

use assur_solvers::problem::{Events, Phase};
use assur_solvers::scalar::Scalar;

use super::equations::{Function, Prepare};
use super::room::room;

impl<S: Scalar> Events<S> for Prepare<S> {
    fn guards(&self, phase: Phase<'_, S>, time: S, state: &[S], values: &mut [S], rates: &mut [S]) {
        let Some(mode) = self.mode(phase.mode) else { return };
        let count = mode.program().results.events.len();
        room(2 * count, |all| {
            self.at(Function::Guards, (phase, time, state), all);
            values[..count].copy_from_slice(&all[..count]);
            rates[..count].copy_from_slice(&all[count..]);
        });
    }

    fn permits(&self, phase: Phase<'_, S>, event: usize, time: S, state: &[S]) -> bool {
        let Some(mode) = self.mode(phase.mode) else { return true };
        let events = &mode.program().results.events;
        if events.get(event).is_none_or(|event| event.condition.is_none()) {
            return true;
        }
        let mut holds = [S::ZERO];
        self.at(Function::Permits(event), (phase, time, state), &mut holds);
        S::holds(S::less(S::ZERO, holds[0]))
    }

    fn jump(&self, phase: Phase<'_, S>, event: usize, time: S, state: &[S], after: &mut [S]) {
        let events = self.mode(phase.mode).map(|mode| &mode.program().results.events);
        match events.and_then(|events| events.get(event)) {
            Some(own) if !own.after.is_empty() => {
                self.at(Function::Jump(event), (phase, time, state), after);
            }
            _ => after.copy_from_slice(state),
        }
    }

    fn has_slopes(&self) -> bool {
        self.motion.has_slopes
    }

    fn guard_slopes(
        &self,
        phase: Phase<'_, S>,
        event: usize,
        time: S,
        state: &[S],
        slopes: &mut [S],
    ) {
        let events = self.mode(phase.mode).map(|mode| &mode.program().results.events);
        match events.and_then(|events| events.get(event)) {
            Some(own) if !own.slopes.guard.is_empty() => {
                self.at(Function::GuardSlopes(event), (phase, time, state), slopes);
            }
            _ => slopes.fill(S::ZERO),
        }
    }

    fn jump_slopes(
        &self,
        phase: Phase<'_, S>,
        event: usize,
        time: S,
        state: &[S],
        columns: &mut [S],
        rates: &mut [S],
    ) -> bool {
        let events = self.mode(phase.mode).map(|mode| &mode.program().results.events);
        let Some(own) = events.and_then(|events| events.get(event)) else { return false };
        let (after, rate) = (own.slopes.after.len(), own.slopes.rate.len());
        if after == 0 {
            return false;
        }
        room(after + rate, |all| {
            self.at(Function::JumpSlopes(event), (phase, time, state), all);
            columns[..after].copy_from_slice(&all[..after]);
            rates[..rate].copy_from_slice(&all[after..]);
        });
        true
    }
}
