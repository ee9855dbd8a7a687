//! Stiff motions by other libraries, at equal achieved error. All get the hand-written equations with their Jacobian.

use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::{ImplicitRungeKutta, Matrix as Slopes};
use diffsol::{NalgebraLU, NalgebraMat, OdeBuilder, OdeEquations, OdeSolverMethod};
use diffsol::{NalgebraVec, OdeSolverProblem, OdeSolverStopReason, Op};

use super::differential_equations::Silent;
use super::scripts;
use crate::equal::{Peer, peer};
use crate::hand_radau::Run;
use crate::stiff::{Kinetics, Oscillator, Problem, compared};

/// The equations for `differential-equations`.
struct Equations<P>(P);

macro_rules! known {
    ($($states:literal)*) => {$(
        impl<P: Problem<$states>> ODE<f64, [f64; $states]> for Equations<P> {
            #[inline(always)]
            fn diff(&self, _time: f64, y: &[f64; $states], rate: &mut [f64; $states]) {
                *rate = self.0.rates(y);
            }

            fn jacobian(&self, _time: f64, y: &[f64; $states], slopes: &mut Slopes<f64>) {
                for (row, values) in self.0.slopes(y).into_iter().enumerate() {
                    for (column, value) in values.into_iter().enumerate() {
                        slopes[(row, column)] = value;
                    }
                }
            }
        }
    )*};
}

known!(2 3);

/// Radau of `differential-equations`; it takes one absolute tolerance.
fn radau5<const N: usize, P: Problem<N>>(rtol: f64) -> Option<Run<N>>
where
    Equations<P>: ODE<f64, [f64; N]>,
    [f64; N]: differential_equations::traits::State<f64>,
{
    let equations = Equations(P::default());
    let (end, first) = P::TIMES;
    let least = P::SCALES.into_iter().fold(f64::INFINITY, f64::min);
    let mut method =
        ImplicitRungeKutta::radau5().rtol(rtol).atol(rtol * least).h0(first).max_steps(1_000_000);
    let solution = solve_ode(&mut method, &equations, 0.0, end, &P::START, &mut Silent).ok()?;
    Some(Run { end: *method.y(), evaluations: solution.evals.function })
}

/// Backward differences of `diffsol`.
fn bdf<const N: usize, P: Problem<N> + 'static>(rtol: f64) -> Option<Run<N>> {
    let rates = |y: &[f64], _: &[f64], _: f64, rate: &mut [f64]| {
        if let Ok(y) = y.try_into() {
            rate.copy_from_slice(&P::default().rates(y));
        }
    };
    let product = |y: &[f64], _: &[f64], _: f64, v: &[f64], product: &mut [f64]| {
        if let Ok(y) = y.try_into() {
            for (product, row) in product.iter_mut().zip(P::default().slopes(y)) {
                *product = row.iter().zip(v).map(|(slope, v)| slope * v).sum();
            }
        }
    };
    let problem: OdeSolverProblem<_> = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(rtol)
        .atol(P::SCALES.map(|scale| scale * rtol))
        .h0(P::TIMES.1)
        .rhs_implicit(rates, product)
        .init(|_, _, y| y.copy_from_slice(&P::START), N)
        .build()
        .ok()?;
    let solver = problem.bdf::<NalgebraLU<f64>>().ok()?;
    driven(solver, P::TIMES.0)
}

/// Steps to the end.
fn driven<'a, const N: usize, E>(
    mut solver: impl OdeSolverMethod<'a, E>,
    end: f64,
) -> Option<Run<N>>
where
    E: OdeEquations<T = f64, V = NalgebraVec<f64>> + 'a,
{
    solver.set_stop_time(end).ok()?;
    while !matches!(solver.step().ok()?, OdeSolverStopReason::TstopReached) {}
    let state = solver.state();
    let end = std::array::from_fn(|index| state.y[index]);
    let statistics = solver.problem().eqn().rhs().statistics();
    Some(Run { end, evaluations: statistics.number_of_calls })
}

/// The peers of a problem.
fn peers<const N: usize, P: Problem<N> + 'static>() -> Vec<Peer<Run<N>>>
where
    Equations<P>: ODE<f64, [f64; N]>,
    [f64; N]: differential_equations::traits::State<f64>,
{
    vec![
        peer("differential-equations", "radau5", radau5::<N, P>),
        peer("diffsol", "bdf", bdf::<N, P>),
    ]
}

/// Measures and prints.
pub fn report() {
    compared::<2, Oscillator>(peers::<2, Oscillator>(), |(names, all)| {
        scripts::add("van-der-pol", names, all);
    });
    compared::<3, Kinetics>(peers::<3, Kinetics>(), |(names, all)| {
        scripts::add("robertson", names, all);
    });
}
