//! The steppers of `ode_solvers`. It has one absolute tolerance for all states and keeps the state of every step.

use ode_solvers::dop_shared::{IntegrationError, Stats};
use ode_solvers::{Dop853, Dopri5, OutputType, SVector, System};

use crate::hand::Batten;
use crate::hand_loop::Run;
use crate::revolutions::{END, SCALE, START};

type State = SVector<f64, 6>;

/// The hand-written equations.
struct Equations(Batten);

impl System<f64, State> for Equations {
    #[inline(always)]
    fn system(&self, time: f64, y: &State, rate: &mut State) {
        let [column] = &y.data.0;
        let [rates] = &mut rate.data.0;
        self.0
            .derivative(&self.0.instant_by::<true>(time), column, rates);
    }
}

/// What a run gives, from its last state.
fn run(end: Option<&State>, statistics: Result<Stats, IntegrationError>) -> Option<Run> {
    Some(Run {
        end: end?.data.0[0],
        evaluations: statistics.ok()?.num_eval as usize,
    })
}

/// Dormand and Prince, order 8.
pub fn dop853(rtol: f64) -> Option<Run> {
    let equations = Equations(Batten::default());
    let start = State::from(START);
    let mut stepper = Dop853::new(equations, 0.0, END, END, start, rtol, rtol * SCALE);
    stepper.set_output(OutputType::Sparse);
    let statistics = stepper.integrate();
    run(stepper.y_out().last(), statistics)
}

/// Dormand and Prince, order 5.
pub fn dopri5(rtol: f64) -> Option<Run> {
    let equations = Equations(Batten::default());
    let start = State::from(START);
    let mut stepper = Dopri5::new(equations, 0.0, END, END, start, rtol, rtol * SCALE);
    stepper.set_output(OutputType::Sparse);
    let statistics = stepper.integrate();
    run(stepper.y_out().last(), statistics)
}
