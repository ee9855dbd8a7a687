//! The equations of a motion on numbers of any kind.

use std::sync::{Arc, OnceLock};

use assur_model::program::Program;
use assur_solvers::problem::{Equations, Phase, Staged};
use assur_solvers::scalar::Scalar;

use super::functions::{Functions, Name, Prepared};
use super::motion::Motion;
use super::room::room;
use super::staged::{Alone, Beside};
use crate::code::{Scope, Wanted};

/// The functions of a motion in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// A row of an instant.
    Instant,
    /// The rates.
    Rates,
    /// The rates with the entries of the Jacobian.
    Slopes,
    /// The rates with products of the Jacobian and columns, where it has no entries.
    Along,
    /// The entries of the Jacobian alone.
    Jacobian,
    Outputs,
    Drivers,
    Margins,
    Points,
    Closures,
    Energy,
    Mass,
    Measured,
    Measures,
    /// The guards of all events, and their rates.
    Guards,
    Permits(usize),
    Jump(usize),
    GuardSlopes(usize),
    JumpSlopes(usize),
}

/// Functions that are not those of a single event.
const SHARED: usize = 15;
/// Functions of an event.
const OWN: usize = 4;

impl Function {
    /// How many functions a program has.
    pub fn count(program: &Program) -> usize {
        SHARED + OWN * program.results.events.len()
    }

    /// All of them.
    pub fn all(program: &Program) -> impl Iterator<Item = Self> {
        let shared = [
            Self::Instant,
            Self::Rates,
            Self::Slopes,
            Self::Along,
            Self::Jacobian,
            Self::Outputs,
            Self::Drivers,
            Self::Margins,
            Self::Points,
            Self::Closures,
            Self::Energy,
            Self::Mass,
            Self::Measured,
            Self::Measures,
            Self::Guards,
        ];
        let own = |event| {
            [Self::Permits, Self::Jump, Self::GuardSlopes, Self::JumpSlopes].map(|of| of(event))
        };
        shared.into_iter().chain((0..program.results.events.len()).flat_map(own))
    }
}

impl Name for Function {
    fn number(self, _: &Program) -> usize {
        let own = |event: usize, number: usize| SHARED + OWN * event + number;
        match self {
            Self::Instant => 0,
            Self::Rates => 1,
            Self::Slopes => 2,
            Self::Along => 3,
            Self::Jacobian => 4,
            Self::Outputs => 5,
            Self::Drivers => 6,
            Self::Margins => 7,
            Self::Points => 8,
            Self::Closures => 9,
            Self::Energy => 10,
            Self::Mass => 11,
            Self::Measured => 12,
            Self::Measures => 13,
            Self::Guards => 14,
            Self::Permits(event) => own(event, 0),
            Self::Jump(event) => own(event, 1),
            Self::GuardSlopes(event) => own(event, 2),
            Self::JumpSlopes(event) => own(event, 3),
        }
    }

    fn wanted(self, program: &Program) -> (Scope, Wanted) {
        let results = &program.results;
        let slopes = || results.jacobian.iter().map(|entry| entry.2);
        let list = match self {
            Self::Instant => program.staging().timed.into_iter().collect(),
            Self::Rates => return (Scope::Evaluation, Wanted::of(results.derivative.clone())),
            Self::Jacobian => return (Scope::Evaluation, Wanted::of(slopes())),
            Self::Slopes => {
                // Entries are read once for each column: each counts as often read.
                let named = slopes().collect();
                let all = results.derivative.iter().copied().chain(slopes());
                return (Scope::Evaluation, Wanted { named, ..Wanted::of(all) });
            }
            Self::Along => {
                let steady = program.steady(&results.along);
                let named = [&steady[..], &steady[..]].concat();
                let columns = results.along.clone();
                let wanted = Wanted { named, columns, ..Wanted::of(results.derivative.clone()) };
                return (Scope::Evaluation, wanted);
            }
            Self::Outputs => results.outputs.clone(),
            Self::Drivers => results.drivers.clone(),
            Self::Margins => results.margins.clone(),
            Self::Points => results.points.clone(),
            Self::Closures => {
                let closing = &results.closing;
                let values = closing.residuals.iter().chain(&closing.rates).copied();
                values.chain(closing.slopes.iter().map(|entry| entry.2)).collect()
            }
            Self::Energy => results.energy.clone(),
            Self::Mass => results.mass.clone(),
            Self::Measured => results.measured.clone(),
            Self::Measures => results.measures.clone(),
            Self::Guards => {
                let events = &results.events;
                let guards = events.iter().map(|event| event.guard);
                guards.chain(events.iter().map(|event| event.rate)).collect()
            }
            Self::Permits(event) => results.events[event].condition.into_iter().collect(),
            Self::Jump(event) => results.events[event].after.clone(),
            Self::GuardSlopes(event) => results.events[event].slopes.guard.clone(),
            Self::JumpSlopes(event) => {
                let slopes = &results.events[event].slopes;
                slopes.after.iter().chain(&slopes.rate).copied().collect()
            }
        };
        (Scope::Time, Wanted::of(list))
    }
}

/// The equations of a motion with its prepared values.
pub struct Prepare<S: Scalar> {
    pub(super) motion: Arc<Motion>,
    values: Vec<S>,
    modes: Vec<OnceLock<Prepared<S>>>,
}

impl<S: Scalar> Prepare<S> {
    /// From the values of the constants.
    pub(super) fn new(motion: &Arc<Motion>, values: &[f64]) -> Self {
        Self {
            motion: motion.clone(),
            values: values.iter().map(|value| S::from_f64(*value)).collect(),
            modes: motion.modes.iter().map(|_| OnceLock::new()).collect(),
        }
    }

    /// A mode with its prepared values; none where there is no such mode.
    #[inline]
    pub(super) fn mode(&self, mode: usize) -> Option<&Prepared<S>> {
        let functions: &Arc<Functions> = self.motion.modes.get(mode)?;
        Some(self.modes[mode].get_or_init(|| Prepared::new(functions, &self.values)))
    }

    /// The mode in which the motion begins, or the only one.
    pub(super) fn first(&self) -> Option<&Prepared<S>> {
        self.mode(self.motion.first)
    }

    pub(super) fn states(&self) -> usize {
        self.motion.shape.states.len()
    }
}

impl<S: Scalar> Equations<S> for Prepare<S> {
    #[inline]
    fn states(&self) -> usize {
        Self::states(self)
    }

    #[inline]
    fn instant(&self) -> usize {
        self.motion.row
    }

    fn instants(&self, phase: Phase<'_, S>, times: &[S], rows: &mut [S]) {
        let row = self.motion.row;
        let Some(mode) = self.mode(phase.mode).filter(|_| row > 0) else { return };
        let storage = &mode.functions.storage;
        let idle = &self.motion.idle[phase.mode];
        let is_left = |(surface, side): &(u32, f64)| {
            let own = phase.side(*surface as usize);
            let (low, high) = if *side < 0.0 { (own, S::ZERO) } else { (S::ZERO, own) };
            S::holds(S::less(low, high))
        };
        if storage.length == 0 || idle.always || idle.sides.iter().any(is_left) {
            return;
        }
        mode.call_rows(Function::Instant, times, row, rows);
    }

    fn rates(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], rates: &mut [S]) {
        if let Some(mode) = self.mode(phase.mode) {
            mode.call(Function::Rates, &[instant, state, phase.sides], rates);
        }
    }

    fn variation(
        &self,
        phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        Beside::new(self, phase).variation(instant, state, rates, columns, products);
    }

    fn alone<'a>(&'a self, phase: Phase<'a, S>) -> impl Staged<S> {
        Alone::new(self, phase)
    }

    fn beside<'a>(&'a self, phase: Phase<'a, S>) -> impl Staged<S> {
        Beside::new(self, phase)
    }

    fn series(&self, phase: Phase<'_, S>, time: S, length: S, rows: &mut [S]) -> bool {
        if !S::SINGLE {
            return false;
        }
        match self.mode(phase.mode) {
            Some(_) if self.states() == 0 => true,
            Some(mode) => mode.series(phase.sides, (time, length), rows),
            None => false,
        }
    }

    fn jacobian(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], columns: &mut [S]) {
        let Some(mode) = self.mode(phase.mode) else { return };
        let (given, program) = (&[instant, state, phase.sides], mode.program());
        let states = Self::states(self);
        columns.fill(S::ZERO);
        if !program.results.along.is_empty() {
            columns.iter_mut().step_by(states + 1).for_each(|own| *own = S::ONE);
            return room(states, |rates| {
                mode.columns(Function::Along).call(given, rates, columns);
            });
        }
        room(program.results.jacobian.len(), |entries| {
            mode.call(Function::Jacobian, given, entries);
            for ((row, column, _), entry) in program.results.jacobian.iter().zip(entries) {
                columns[*column as usize * states + *row as usize] = *entry;
            }
        });
    }
}
