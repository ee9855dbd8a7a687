//! The hand-written equations for Assur's steppers: what a stepper costs without the emitted code.

use assur::ode::{Method, Options, System, Workspace, integrate};

use crate::hand::{Batten, Instant};
use crate::hand_loop::Run;
use crate::revolutions::{END, SCALE, START};

impl System<f64> for Batten {
    type State = [f64; 6];
    type Instant = Instant;

    fn zeros(&self) -> [f64; 6] {
        [0.0; 6]
    }

    #[inline(always)]
    fn instants<const K: usize>(&self, times: [f64; K]) -> [Instant; K] {
        self.instants_by::<true, K>(times)
    }

    #[inline(always)]
    fn rate(&self, instant: &Instant, state: &[f64; 6], rate: &mut [f64; 6]) {
        self.derivative(instant, state, rate);
    }

    #[inline(always)]
    fn parts(_state: &[f64; 6]) -> usize {
        1
    }

    #[inline(always)]
    fn part(state: &[f64; 6], _number: usize) -> &[f64] {
        state
    }

    #[inline(always)]
    fn part_mut(state: &mut [f64; 6], _number: usize) -> &mut [f64] {
        state
    }
}

/// Ten revolutions of the hand-written equations with a stepper of Assur.
#[inline(never)]
pub fn run<M: Method>(rtol: f64) -> Run {
    let system = Batten::default();
    let options = Options::scaled(rtol, &[SCALE; 6]);
    let mut workspace = Workspace::<_, M>::new::<f64, _>(&system);
    let times = (0.0, END);
    let statistics = integrate(&system, times, &START, &options, &mut workspace, &mut ());
    Run {
        end: *workspace.state(),
        evaluations: statistics.map_or(0, |statistics| statistics.evaluations),
    }
}
