//! The steppers of `diffsol`, on vectors of nalgebra. Its implicit methods get the hand-written Jacobian.

use diffsol::{
    DiffsolError, NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquations,
    OdeEquationsImplicit, OdeSolverMethod, OdeSolverProblem, OdeSolverStopReason, Op,
};

use crate::hand::Batten;
use crate::hand_loop::Run;
use crate::revolutions::{END, SCALE, START};

type Matrix = NalgebraMat<f64>;

/// The hand-written equations.
fn problem(
    rtol: f64,
) -> Result<
    OdeSolverProblem<
        impl OdeEquationsImplicit<
            T = f64,
            V = NalgebraVec<f64>,
            M = Matrix,
            C = diffsol::NalgebraContext,
        >,
    >,
    DiffsolError,
> {
    let batten = Batten::default();
    let derivative = move |y: &[f64], _: &[f64], time: f64, rate: &mut [f64]| {
        let (Ok(y), Ok(rate)) = (y.try_into(), rate.try_into()) else {
            return;
        };
        batten.derivative(&batten.instant_by::<true>(time), y, rate);
    };
    let product = move |_: &[f64], _: &[f64], time: f64, v: &[f64], product: &mut [f64]| {
        let mut columns = [[0.0; 6]; 6];
        batten.jacobian(&batten.instant_by::<true>(time), &mut columns);
        product.fill(0.0);
        for (column, v) in columns.iter().zip(v) {
            for (product, entry) in product.iter_mut().zip(column) {
                *product += entry * v;
            }
        }
    };
    OdeBuilder::<Matrix>::new()
        .rtol(rtol)
        .atol([rtol * SCALE; 6])
        .rhs_implicit(derivative, product)
        .init(|_, _, y| y.copy_from_slice(&START), START.len())
        .build()
}

/// Steps to the end.
fn run<'a, E>(mut solver: impl OdeSolverMethod<'a, E>) -> Result<Run, DiffsolError>
where
    E: OdeEquations<T = f64, V = NalgebraVec<f64>> + 'a,
{
    solver.set_stop_time(END)?;
    while !matches!(solver.step()?, OdeSolverStopReason::TstopReached) {}
    let mut end = [0.0; 6];
    let state = solver.state();
    for (index, value) in end.iter_mut().enumerate() {
        *value = state.y[index];
    }
    let statistics = solver.problem().eqn().rhs().statistics();
    Ok(Run { end, evaluations: statistics.number_of_calls })
}

/// Tsitouras, order 5.
pub fn tsit45(rtol: f64) -> Option<Run> {
    run(problem(rtol).ok()?.tsit45().ok()?).ok()
}

/// Backward differences of variable order.
pub fn bdf(rtol: f64) -> Option<Run> {
    run(problem(rtol).ok()?.bdf::<NalgebraLU<f64>>().ok()?).ok()
}
