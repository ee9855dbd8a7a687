//! One evaluation: emitted code against hand-written code.
//!
//! Each call takes a new time and a state that depends on the last rates, and all of its results are kept. The
//! hand-written code comes with two sines, that of the standard library and that of Assur, so that the sine is not
//! mistaken for the equations.

use std::hint::black_box;

use assur::dispatch::{Task, dispatch};
use assur::problem::{Equations, Phase, Scene};
use assur::scalar::Scalar;
use assur_equations::batten::Elastic;

use crate::count::{Case, measure};
use crate::hand::Batten;
use crate::table::{Table, number, ratio, verdict};

/// Calls in one run.
const CALLS: usize = 20_000;
/// Instants of a step of DOP853.
const STAGES: usize = 11;
/// Numbers of an instant that there is room for.
const WIDEST: usize = 11;
/// A state, neither at rest nor symmetric.
const STATE: [f64; 6] = [1e-3, -3e-4, -2e-4, 0.05, 0.01, 0.02];
/// Largest ratio of the emitted code to the hand-written code.
const GOAL: f64 = 1.05;

/// The batten, by whomever it is written.
trait Side<S: Scalar> {
    /// `y'` at a time.
    fn derivative(&self, time: S, y: &[S; 6], rate: &mut [S; 6]);
    /// `y'` and the columns of `∂y'/∂y` at a time.
    fn both(&self, time: S, y: &[S; 6], rate: &mut [S; 6], columns: &mut [[S; 6]; 6]);
    /// `y'` at several times, all that depends on the times alone computed first.
    fn step(&self, times: [S; STAGES], y: &[S; 6], rates: &mut [[S; 6]; STAGES]);
}

/// The batten by its emitted code.
struct Emitted<S: Scalar>(<Elastic as Scene>::Equations<S>);

impl<S: Scalar> Emitted<S> {
    /// What depends on times alone, a row of so many numbers for each, in what there is room for.
    #[inline(always)]
    fn rows<'a>(&self, times: &[S], room: &'a mut [S]) -> (&'a [S], usize) {
        let width = self.0.instant();
        let rows = &mut room[..times.len() * width];
        self.0.instants(Phase::of(0), times, rows);
        (rows, width)
    }
}

impl<S: Scalar> Side<S> for Emitted<S> {
    #[inline(always)]
    fn derivative(&self, time: S, y: &[S; 6], rate: &mut [S; 6]) {
        let mut room = [S::ZERO; WIDEST];
        let (row, _) = self.rows(&[time], &mut room);
        self.0.rates(Phase::of(0), row, y, rate);
    }

    #[inline(always)]
    fn both(&self, time: S, y: &[S; 6], rate: &mut [S; 6], columns: &mut [[S; 6]; 6]) {
        let mut room = [S::ZERO; WIDEST];
        let (row, _) = self.rows(&[time], &mut room);
        self.0.rates(Phase::of(0), row, y, rate);
        self.0.jacobian(Phase::of(0), row, y, columns.as_flattened_mut());
    }

    #[inline(always)]
    fn step(&self, times: [S; STAGES], y: &[S; 6], rates: &mut [[S; 6]; STAGES]) {
        let mut room = [S::ZERO; STAGES * WIDEST];
        let (rows, width) = self.rows(&times, &mut room);
        for (row, rate) in rows.chunks_exact(width).zip(rates) {
            self.0.rates(Phase::of(0), row, y, rate);
        }
    }
}

/// The batten by hand, with the sine of Assur (`KERNEL`) or of the standard library.
struct Hand<const KERNEL: bool>(Batten);

impl<const KERNEL: bool> Side<f64> for Hand<KERNEL> {
    #[inline(always)]
    fn derivative(&self, time: f64, y: &[f64; 6], rate: &mut [f64; 6]) {
        self.0.derivative(&self.0.instant_by::<KERNEL>(time), y, rate);
    }

    #[inline(always)]
    fn both(&self, time: f64, y: &[f64; 6], rate: &mut [f64; 6], columns: &mut [[f64; 6]; 6]) {
        let instant = self.0.instant_by::<KERNEL>(time);
        self.0.derivative(&instant, y, rate);
        self.0.jacobian(&instant, columns);
    }

    #[inline(always)]
    fn step(&self, times: [f64; STAGES], y: &[f64; 6], rates: &mut [[f64; 6]; STAGES]) {
        let instants = self.0.instants_by::<KERNEL, STAGES>(times);
        for (instant, rate) in instants.iter().zip(rates) {
            self.0.derivative(instant, y, rate);
        }
    }
}

/// What is evaluated.
#[derive(Clone, Copy)]
enum Workload {
    Derivative,
    Both,
    Step,
}

/// Evaluates many times and gives the last rates.
#[inline(always)]
fn run<S: Scalar>(side: &impl Side<S>, workload: Workload) -> [S; 6] {
    let mut y = STATE.map(S::from_f64);
    let small = S::from_f64(1e-6);
    let time = |call: usize| S::from_f64(black_box(call as f64 * 1e-5));
    let mut rate = [S::ZERO; 6];
    match workload {
        Workload::Derivative => {
            for call in 0..CALLS {
                side.derivative(time(call), &y, &mut rate);
                y[0] = black_box(&mut rate)[3] * small;
            }
        }
        Workload::Both => {
            let mut columns = [[S::ZERO; 6]; 6];
            for call in 0..CALLS {
                side.both(time(call), &y, &mut rate, &mut columns);
                black_box(&mut columns);
                y[0] = black_box(&mut rate)[3] * small;
            }
        }
        Workload::Step => {
            let mut rates = [rate; STAGES];
            for call in 0..CALLS / STAGES {
                let mut times = [S::ZERO; STAGES];
                for (stage, target) in times.iter_mut().enumerate() {
                    *target = time(call * STAGES + stage);
                }
                side.step(times, &y, &mut rates);
                y[0] = black_box(&mut rates)[STAGES - 1][3] * small;
            }
            rate = rates[STAGES - 1];
        }
    }
    rate
}

/// The emitted code on the scalar type that the machine at hand is fastest with.
struct Emission(Workload);

impl Task for Emission {
    type Output = [f64; 6];

    #[inline(always)]
    fn run<S: Scalar>(self) -> [f64; 6] {
        let rate = run(&Emitted(Elastic::default().prepare::<S>()), self.0);
        let mut numbers = [0.0; 6];
        for (number, rate) in numbers.iter_mut().zip(rate) {
            *number = rate.to_f64();
        }
        numbers
    }
}

#[inline(never)]
fn emitted(workload: Workload) -> [f64; 6] {
    Emission(workload).run::<f64>()
}

#[inline(never)]
fn dispatched(workload: Workload) -> [f64; 6] {
    dispatch(Emission(workload))
}

#[inline(never)]
fn hand<const KERNEL: bool>(workload: Workload) -> [f64; 6] {
    run(&Hand::<KERNEL>(Batten::default()), workload)
}

/// Everything that is measured: for each workload the four kinds of code.
pub fn cases() -> Vec<Case<'static>> {
    let one = |name, workload, code: fn(Workload) -> [f64; 6]| {
        let pieces = match workload {
            Workload::Step => CALLS / STAGES,
            _ => CALLS,
        };
        Case::new(name, pieces, move || {
            black_box(code(black_box(workload)));
        })
    };
    use Workload::{Both, Derivative, Step};
    vec![
        one("derivative-std", Derivative, hand::<false>),
        one("derivative-kernel", Derivative, hand::<true>),
        one("derivative-emitted", Derivative, emitted),
        one("derivative-dispatched", Derivative, dispatched),
        one("both-std", Both, hand::<false>),
        one("both-kernel", Both, hand::<true>),
        one("both-emitted", Both, emitted),
        one("both-dispatched", Both, dispatched),
        one("step-std", Step, hand::<false>),
        one("step-kernel", Step, hand::<true>),
        one("step-emitted", Step, emitted),
        one("step-dispatched", Step, dispatched),
    ]
}

/// Measures and prints.
pub fn report() {
    for workload in [Workload::Derivative, Workload::Both, Workload::Step] {
        let [reference, found] = [hand::<false>(workload), emitted(workload)];
        for (found, reference) in found.iter().zip(reference) {
            let tolerance = 1e-9 * (1.0 + reference.abs());
            assert!(
                (found - reference).abs() < tolerance,
                "{found} by emitted code, {reference} by hand"
            );
        }
    }
    let measures = measure("evaluate", &mut cases(), 60);
    let workloads = [
        "Derivative at one time",
        "Derivative and Jacobian at one time",
        "Eleven derivatives, their instants at once",
    ];
    let kinds = ["hand, sine of std", "hand, sine of Assur", "emitted", "emitted, dispatched"];
    for (title, group) in workloads.into_iter().zip(measures.chunks(kinds.len())) {
        let columns = ["code", "instructions", "ratio", "time, ns", "ratio"];
        let mut table = Table::new(title, &columns);
        let (kernel, found) = (&group[1], &group[2]);
        for (kind, one) in kinds.into_iter().zip(group) {
            table.row([
                kind.to_owned(),
                number(one.instructions),
                ratio(one.instructions, kernel.instructions),
                number(one.nanoseconds()),
                ratio(one.nanoseconds(), kernel.nanoseconds()),
            ]);
        }
        table.print();
        let times = (found.nanoseconds(), kernel.nanoseconds());
        let counts = (found.instructions, kernel.instructions);
        verdict("emitted / hand, instructions", counts.0, counts.1, GOAL);
        verdict("emitted / hand, time", times.0, times.1, GOAL);
    }
}
