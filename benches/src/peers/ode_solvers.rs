//! The steppers of `ode_solvers`. It has one absolute tolerance for all states and keeps the state of every step.
//!
//! Its `Dop853` (0.6.2) evaluates the twelfth stage at the begin of the step: its `C[11]` is 0 instead of 1. On
//! equations that depend on the time that is a method of order one, and it gives up. It gets the time as a seventh
//! state here, which no table of nodes can spoil.

use ode_solvers::dop_shared::{IntegrationError, Stats};
use ode_solvers::{Dop853, Dopri5, OutputType, SVector, System};

use crate::hand::Batten;
use crate::hand_loop::Run;
use crate::revolutions::{END, SCALE, START};

type State = SVector<f64, 6>;
type Timed = SVector<f64, 7>;

/// The hand-written equations.
struct Equations(Batten);

impl System<f64, State> for Equations {
    #[inline(always)]
    fn system(&self, time: f64, y: &State, rate: &mut State) {
        let [column] = &y.data.0;
        let [rates] = &mut rate.data.0;
        self.0.derivative(&self.0.instant_by::<true>(time), column, rates);
    }
}

/// The hand-written equations with the time as the last state.
struct Autonomous(Batten);

impl System<f64, Timed> for Autonomous {
    #[inline(always)]
    fn system(&self, _time: f64, y: &Timed, rate: &mut Timed) {
        let [column] = &y.data.0;
        let [rates] = &mut rate.data.0;
        let (Some((y, [time])), Some((rates, [clock]))) =
            (column.split_first_chunk::<6>(), rates.split_first_chunk_mut::<6>())
        else {
            return;
        };
        *clock = 1.0;
        self.0.derivative(&self.0.instant_by::<true>(*time), y, rates);
    }
}

/// What a run gives, from its last state.
fn run(end: Option<&[f64]>, statistics: Result<Stats, IntegrationError>) -> Option<Run> {
    Some(Run { end: *end?.first_chunk()?, evaluations: statistics.ok()?.num_eval as usize })
}

/// Dormand and Prince, order 8.
pub fn dop853(rtol: f64) -> Option<Run> {
    let equations = Autonomous(Batten::default());
    let start = Timed::from_fn(|row, _| START.get(row).copied().unwrap_or(0.0));
    let mut stepper = Dop853::new(equations, 0.0, END, END, start, rtol, rtol * SCALE);
    stepper.set_output(OutputType::Sparse);
    let statistics = stepper.integrate();
    run(stepper.y_out().last().map(Timed::as_slice), statistics)
}

/// Dormand and Prince, order 5.
pub fn dopri5(rtol: f64) -> Option<Run> {
    let equations = Equations(Batten::default());
    let start = State::from(START);
    let mut stepper = Dopri5::new(equations, 0.0, END, END, start, rtol, rtol * SCALE);
    stepper.set_output(OutputType::Sparse);
    let statistics = stepper.integrate();
    run(stepper.y_out().last().map(State::as_slice), statistics)
}
