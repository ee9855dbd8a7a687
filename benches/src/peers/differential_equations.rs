//! The steppers of `differential-equations`. It has no method of Tsitouras.

use differential_equations::control::ControlFlag;
use differential_equations::interpolate::Interpolation;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::ExplicitRungeKutta;
use differential_equations::solout::Solout;
use differential_equations::solution::Solution;

use crate::hand::Batten;
use crate::hand_loop::Run;
use crate::revolutions::{END, SCALE, START};

type State = [f64; 6];

/// The hand-written equations.
struct Equations(Batten);

impl ODE<f64, State> for Equations {
    #[inline(always)]
    fn diff(&self, time: f64, y: &State, rate: &mut State) {
        self.0.derivative(&self.0.instant_by::<true>(time), y, rate);
    }
}

/// Keeps no states.
pub struct Silent;

impl<Y: differential_equations::traits::State<f64>> Solout<f64, Y> for Silent {
    fn solout<I>(
        &mut self,
        _now: f64,
        _before: f64,
        _state: &Y,
        _state_before: &Y,
        _interpolator: &mut I,
        _solution: &mut Solution<f64, Y>,
    ) -> ControlFlag<f64, Y>
    where
        I: Interpolation<f64, Y> + ?Sized,
    {
        ControlFlag::Continue
    }
}

/// Runs a method.
fn run(
    mut method: impl OrdinaryNumericalMethod<f64, State> + Interpolation<f64, State>,
) -> Option<Run> {
    let equations = Equations(Batten::default());
    let solution = solve_ode(&mut method, &equations, 0.0, END, &START, &mut Silent).ok()?;
    Some(Run { end: *method.y(), evaluations: solution.evals.function })
}

/// Makes a function of a method with tolerances.
macro_rules! method {
    ($(#[$text:meta])* $name:ident, $constructor:ident) => {
        $(#[$text])*
        pub fn $name(rtol: f64) -> Option<Run> {
            let method = ExplicitRungeKutta::$constructor();
            run(method.rtol(rtol).atol(rtol * SCALE).max_steps(10_000_000))
        }
    };
}

method! {
    /// Dormand and Prince, order 8.
    dop853, dop853
}
method! {
    /// Dormand and Prince, order 5.
    dopri5, dopri5
}
method! {
    /// Verner, order 9 with an estimate of order 8.
    verner, rkv988e
}
