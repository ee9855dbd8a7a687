//! The equations of a model in one phase.

use super::{Correction, Model, Steps};
use crate::ode::{Explicit, OdeError, Room, System, first_bad, system};
use crate::problem::{Equations, Events, Phase};
use crate::shape::Shape;
use std::cell::{OnceCell, RefCell};

/// The equations of a model in one phase: a mode, and the sides of its switching surfaces.
pub struct Flow<'a> {
    model: &'a dyn Model,
    equations: &'a dyn Equations<f64>,
    events: Option<&'a dyn Events<f64>>,
    mode: usize,
    sides: Vec<f64>,
    /// Room for what depends on the time alone.
    instant: RefCell<Vec<f64>>,
    /// Room for what keeps closures closed, if a step asks for it; most flows are asked for single values.
    correction: OnceCell<RefCell<Option<Correction>>>,
}

impl<'a> Flow<'a> {
    /// The equations in a mode, with all sides left to the values.
    pub fn new(model: &'a dyn Model, mode: usize) -> Self {
        let equations = model.equations();
        Self {
            model,
            equations,
            events: model.events(),
            mode,
            sides: Vec::new(),
            instant: RefCell::new(vec![0.0; equations.instant()]),
            correction: OnceCell::new(),
        }
    }

    /// The flow of a mode on these sides of its switching surfaces.
    pub(crate) fn on(model: &'a dyn Model, mode: usize, sides: &[f64]) -> Self {
        Self { sides: sides.to_vec(), ..Self::new(model, mode) }
    }

    /// Length of the state vector.
    #[inline]
    pub fn states(&self) -> usize {
        self.equations.states()
    }

    /// What the scene is made of.
    pub fn shape(&self) -> &'a Shape {
        self.model.shape()
    }

    /// The mode.
    pub fn mode(&self) -> usize {
        self.mode
    }

    /// Goes into a mode.
    pub(crate) fn enter(&mut self, mode: usize) {
        self.mode = mode;
        self.sides.clear();
        self.correction = OnceCell::new();
    }

    /// Puts the motion on a side of a switching surface, 1 or −1; 0 leaves it to the values.
    pub(crate) fn put(&mut self, surface: usize, side: f64) {
        if self.sides.len() <= surface {
            self.sides.resize(surface + 1, 0.0);
        }
        self.sides[surface] = side;
    }

    /// Whether the sides of some switching surfaces are left to the values.
    pub(crate) fn is_loose(&self) -> bool {
        let mode = self.shape().modes.get(self.mode);
        let surfaces =
            mode.into_iter().flat_map(|mode| mode.events).filter_map(|event| event.surface);
        surfaces.into_iter().any(|surface| self.phase().side(surface) == 0.0)
    }

    #[inline]
    fn phase(&self) -> Phase<'_, f64> {
        Phase { mode: self.mode, sides: &self.sides }
    }

    /// [`held`] in the phase.
    #[inline]
    fn held<R: Copy>(
        &self,
        numbers: &mut [f64],
        compute: impl FnMut(Phase<'_, f64>, &mut [f64]) -> R,
    ) -> R {
        held(self.phase(), numbers, compute)
    }

    /// Whether sides are held, and numbers do not exist.
    #[inline]
    fn is_lost(&self, numbers: &[f64]) -> bool {
        is_lost(self.phase(), numbers)
    }

    /// Writes `f(t, y)`.
    pub fn rates(&self, time: f64, state: &[f64], rates: &mut [f64]) {
        let mut instant = self.instant.borrow_mut();
        self.held(rates, |phase, rates| {
            self.equations.instants(phase, &[time], &mut instant);
            self.equations.rates(phase, &instant, state, rates);
        });
    }

    /// Writes `∂f/∂y`, column by column.
    pub fn jacobian(&self, time: f64, state: &[f64], columns: &mut [f64]) {
        let mut instant = self.instant.borrow_mut();
        self.held(columns, |phase, columns| {
            self.equations.instants(phase, &[time], &mut instant);
            self.equations.jacobian(phase, &instant, state, columns);
        });
    }

    /// Writes the rates of a motion and of the columns of its variation, which stand behind it.
    pub fn variation(&self, time: f64, state: &[f64], rates: &mut [f64]) {
        let mut instant = self.instant.borrow_mut();
        let (state, columns) = state.split_at(self.states());
        self.held(rates, |phase, rates| {
            let (rates, products) = rates.split_at_mut(state.len());
            self.equations.instants(phase, &[time], &mut instant);
            self.equations.variation(phase, &instant, state, rates, columns, products);
        });
    }

    /// Writes the Taylor series of the motion, see [`Equations::series`].
    pub fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool {
        self.held(rows, |phase, rows| self.equations.series(phase, time, length, rows))
    }

    fn correction(&self) -> &RefCell<Option<Correction>> {
        self.correction.get_or_init(|| RefCell::new(Correction::of(self.shape(), self.mode)))
    }

    /// Brings a state back onto the closures that hold it.
    ///
    /// # Errors
    /// [`OdeError::Open`] where that is not possible.
    pub fn correct(&self, time: f64, state: &mut [f64]) -> Result<(), OdeError> {
        match self.correction().borrow_mut().as_mut() {
            Some(correction) => correction.correct(self.model.reports(), self.phase(), time, state),
            None => Ok(()),
        }
    }

    /// Writes the guards of the mode and their rates; none where there are no events.
    pub fn guards(&self, time: f64, state: &[f64], values: &mut [f64], rates: &mut [f64]) {
        let Some(events) = self.events else { return };
        events.guards(self.phase(), time, state, values, rates);
        if self.is_lost(values) || self.is_lost(rates) {
            events.guards(Phase::of(self.mode), time, state, values, rates);
        }
    }

    /// Whether what else an event asks for holds.
    pub(crate) fn permits(&self, event: usize, time: f64, state: &[f64]) -> bool {
        self.events.is_none_or(|events| events.permits(self.phase(), event, time, state))
    }

    /// Writes the state after an event.
    pub(crate) fn jump(&self, event: usize, time: f64, state: &[f64], after: &mut [f64]) {
        match self.events {
            Some(events) => events.jump(self.phase(), event, time, state, after),
            None => after.copy_from_slice(state),
        }
    }

    /// Whether closures hold the states.
    pub(crate) fn is_held(&self) -> bool {
        self.shape().held_in(self.mode).is_some()
    }

    /// Lets the closures of the mode take hold of a state that has jumped, or that comes from another mode.
    ///
    /// # Errors
    /// [`OdeError::Open`] where that is not possible.
    pub(crate) fn seize(
        &self,
        time: f64,
        before: &[f64],
        state: &mut [f64],
    ) -> Result<(), OdeError> {
        match self.correction().borrow_mut().as_mut() {
            Some(correction) => {
                correction.jump(self.model.reports(), self.phase(), time, (before, state))
            }
            None => Ok(()),
        }
    }

    /// Value and rate of the guard of an event.
    pub(crate) fn guard(&self, event: usize, time: f64, state: &[f64]) -> (f64, f64) {
        let count = self.shape().modes[self.mode].written();
        let (mut values, mut rates) = (vec![0.0; count], vec![0.0; count]);
        self.guards(time, state, &mut values, &mut rates);
        (values[event], rates[event])
    }

    /// Writes the derivatives of the guard of an event by the state.
    pub(crate) fn guard_slopes(&self, event: usize, time: f64, state: &[f64], slopes: &mut [f64]) {
        if let Some(events) = self.events {
            events.guard_slopes(self.phase(), event, time, state, slopes);
        }
    }

    /// Writes the derivatives of the state after an event by that before it, column by column, and its total time
    /// derivative. False where the event sets nothing.
    pub(crate) fn jump_slopes(
        &self,
        event: usize,
        (time, state): (f64, &[f64]),
        columns: &mut [f64],
        rates: &mut [f64],
    ) -> bool {
        self.events.is_some_and(|events| {
            events.jump_slopes(self.phase(), event, time, state, columns, rates)
        })
    }

    /// The stages of a step of the motion with its variations.
    pub(crate) fn attempt_varied(&self, method: Explicit, room: &mut Room) {
        let varied = true;
        self.model.attempt(Steps { method, varied }, self.phase(), room);
    }

    /// What is missing of it.
    pub(crate) fn finish_varied(&self, method: Explicit, room: &mut Room, dense: bool) {
        let varied = true;
        self.model.finish(Steps { method, varied }, self.phase(), room, dense);
    }
}

impl System for Flow<'_> {
    fn length(&self) -> usize {
        self.states()
    }

    fn rates(&self, time: f64, state: &[f64], rates: &mut [f64]) {
        Flow::rates(self, time, state, rates);
    }

    fn correct(&self, time: f64, state: &mut [f64]) -> Result<(), OdeError> {
        Flow::correct(self, time, state)
    }

    fn attempt(&self, method: Explicit, room: &mut Room) {
        let varied = false;
        self.model.attempt(Steps { method, varied }, self.phase(), room);
        room.is_apart = self.is_lost(&room.trial);
        if room.is_apart {
            system::attempt_each(
                &|time, state, rates| self.rates(time, state, rates),
                method,
                room,
            );
        }
    }

    fn finish(&self, method: Explicit, room: &mut Room, dense: bool) {
        let varied = false;
        // What has been tried one evaluation after the other keeps its instants in another way.
        if !room.is_apart {
            self.model.finish(Steps { method, varied }, self.phase(), room, dense);
        }
        if room.is_apart || self.is_lost(&room.slopes) {
            let rates = &|time: f64, state: &[f64], rates: &mut [f64]| {
                self.rates(time, state, rates);
            };
            system::finish_each(rates, method, room, dense);
        }
    }
}

/// Computes numbers; where they do not exist though they might, with the sides left to the values. A branch that is
/// held beyond its surface, where the step that ends on the surface tries the equations, may not exist there, `sqrt(x)`
/// of a negative number: they are those of the branch that does, then.
#[inline]
pub(crate) fn held<R: Copy>(
    phase: Phase<'_, f64>,
    numbers: &mut [f64],
    mut compute: impl FnMut(Phase<'_, f64>, &mut [f64]) -> R,
) -> R {
    let done = compute(phase, numbers);
    match is_lost(phase, numbers) {
        true => compute(Phase::of(phase.mode), numbers),
        false => done,
    }
}

/// Whether sides are held, and numbers do not exist.
#[inline]
fn is_lost(phase: Phase<'_, f64>, numbers: &[f64]) -> bool {
    !phase.sides.is_empty() && first_bad(numbers, 1).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ode::Workspace;
    use crate::problem::{Reports, Span};

    /// `dot(y) = 20 (t - 0.75) + 0.001 sqrt(y)` on one side of a surface, without the root on the other.
    struct Rooted;

    const SHAPE: Shape = Shape::named("rooted");

    impl Equations<f64> for Rooted {
        fn states(&self) -> usize {
            1
        }

        fn instant(&self) -> usize {
            1
        }

        fn instants(&self, _phase: Phase<'_, f64>, times: &[f64], rows: &mut [f64]) {
            for (row, time) in rows.iter_mut().zip(times) {
                *row = 20.0 * (time - 0.75);
            }
        }

        fn rates(&self, phase: Phase<'_, f64>, instant: &[f64], y: &[f64], rates: &mut [f64]) {
            let root = if phase.side(0) > 0.0 { y[0].sqrt() } else { 0.0 };
            rates[0] = instant[0] + 0.001 * root;
        }

        fn variation(
            &self,
            _: Phase<'_, f64>,
            _: &[f64],
            _: &[f64],
            _: &mut [f64],
            _: &[f64],
            _: &mut [f64],
        ) {
        }

        fn jacobian(&self, _: Phase<'_, f64>, _: &[f64], _: &[f64], _: &mut [f64]) {}
    }

    impl Reports<f64> for Rooted {}

    impl Model for Rooted {
        fn shape(&self) -> &Shape {
            &SHAPE
        }

        fn equations(&self) -> &dyn Equations<f64> {
            self
        }

        fn reports(&self) -> &dyn Reports<f64> {
            self
        }

        fn span(&self) -> Span {
            Span::Open
        }

        fn start(&self) -> Vec<f64> {
            vec![0.0]
        }
    }

    /// A step whose stages leave the branch that is held ends with the rate of its end.
    #[test]
    fn a_step_beyond_a_branch_has_the_slope_of_its_end() {
        let flow = Flow::on(&Rooted, 0, &[1.0]);
        let mut workspace = Workspace::new(Explicit::Dop853, &flow);
        let room = workspace.room_mut();
        (room.time, room.step) = (0.5, 0.5);
        flow.rates(0.5, &[0.0], &mut room.slopes[..1]);
        flow.attempt(Explicit::Dop853, room);
        assert!(room.is_apart);
        flow.finish(Explicit::Dop853, room, true);
        let (mut expected, end) = ([0.0], room.trial[0]);
        flow.rates(1.0, &[end], &mut expected);
        assert_eq!(room.slopes[12], expected[0]);
    }
}
