//! No step of a stiff method allocates.

use assur_solvers::model::{Flow, Model};
use assur_solvers::ode::Options;
use assur_solvers::problem::{Equations, Phase, Reports, Span};
use assur_solvers::shape::Shape;
use assur_solvers::stiff::{Method, Workspace, integrate};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

/// The allocator of the system, which counts what each thread asks of it.
struct Counting;

// SAFETY: all is passed on to the allocator of the system.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        unsafe { System.dealloc(memory, layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.realloc(memory, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often some work allocates.
fn allocations<T>(work: impl FnOnce() -> T) -> usize {
    let before = ALLOCATIONS.get();
    let result = work();
    let after = ALLOCATIONS.get();
    drop(result);
    after - before
}

/// Van der Pol's oscillator with `ε = 1e-4`.
struct Oscillator;

impl Equations<f64> for Oscillator {
    fn states(&self) -> usize {
        2
    }

    fn rates(&self, _phase: Phase<'_, f64>, _instant: &[f64], state: &[f64], rates: &mut [f64]) {
        rates[0] = state[1];
        rates[1] = 1e4 * ((1.0 - state[0] * state[0]) * state[1] - state[0]);
    }

    fn variation(
        &self,
        _phase: Phase<'_, f64>,
        _instant: &[f64],
        _state: &[f64],
        _rates: &mut [f64],
        _columns: &[f64],
        _products: &mut [f64],
    ) {
        unreachable!("no stiff method asks for variations");
    }

    fn jacobian(
        &self,
        _phase: Phase<'_, f64>,
        _instant: &[f64],
        state: &[f64],
        columns: &mut [f64],
    ) {
        let slope = 1e4 * (-2.0 * state[0] * state[1] - 1.0);
        columns.copy_from_slice(&[0.0, slope, 1.0, 1e4 * (1.0 - state[0] * state[0])]);
    }
}

impl Reports<f64> for Oscillator {}

impl Model for Oscillator {
    fn shape(&self) -> &Shape {
        const { &Shape::named("oscillator") }
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
        vec![2.0, 0.0]
    }
}

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(Vec::<f64>::new), 0);
    assert_eq!(allocations(|| vec![1.0]), 1);
}

#[test]
fn stiff_methods_allocate_nothing_per_step() {
    for method in [Method::Radau, Method::Rosenbrock, Method::Automatic] {
        let flow = Flow::new(&Oscillator, 0);
        let mut workspace = Workspace::new(method, &flow);
        let options = Options::default();
        for end in [2.0, 6.0] {
            let mut steps = 0;
            let count = allocations(|| {
                let (times, start) = ((0.0, end), [2.0, 0.0]);
                let done = integrate(&flow, times, &start, &options, &mut workspace, &mut ());
                steps = done.unwrap().steps;
            });
            assert_eq!(count, 0, "{method:?}");
            assert!(steps > 500, "{method:?} {steps}");
        }
    }
}
