//! Nothing is allocated where a scene of fixed size is evaluated or integrated.

use assur::model::{Bound, Flow};
use assur::ode::{Explicit, Options, Varied, Workspace, integrate};
use assur::problem::{Equations, Phase, Reports, Scene, Span};
use assur_equations::batten::{Elastic, Exact};
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

/// Ten revolutions of a scene by a method, from rest: how often they allocate.
#[track_caller]
fn check_revolutions<C: Scene + Default>(method: Explicit) {
    let scene = C::default();
    let Span::Periodic(period) = scene.span() else {
        panic!("the scene has another task");
    };
    let model = Bound::new(&scene);
    let flow = Flow::new(&model, 0);
    let start = vec![0.0; C::shape().states.len()];
    let options = Options::scaled(1e-10, C::shape().scales);
    let mut workspace = Workspace::new(method, &flow);
    let mut steps = 0;
    let mut turn = || {
        let times = (0.0, 10.0 * period);
        let done = integrate(&flow, times, &start, &options, &mut workspace, &mut ());
        steps = done.unwrap().steps;
    };
    // The first one makes room for what depends on the time alone.
    let counts = [allocations(&mut turn), allocations(&mut turn)];
    assert!(counts[0] <= 1 && counts[1] == 0, "{counts:?}");
    assert!(steps > 100, "{steps}");
}

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(Vec::<f64>::new), 0);
    assert_eq!(allocations(|| vec![1.0]), 1);
}

#[test]
fn ten_revolutions_allocate_nothing() {
    check_revolutions::<Elastic>(Explicit::Dop853);
    check_revolutions::<Elastic>(Explicit::Tsit5);
    check_revolutions::<Exact>(Explicit::Dop853);
}

/// All functions of prepared equations.
fn evaluate<C: Scene + Default>() -> usize {
    let (equations, phase) = (C::default().prepare::<f64>(), Phase::of(0));
    let (states, row) = (equations.states(), equations.instant());
    let state = vec![0.0; states];
    let mut rates = state.clone();
    let mut columns = vec![0.0; states * states];
    let mut products = columns.clone();
    let mut outputs = vec![0.0; C::shape().outputs.len()];
    let mut drivers = vec![0.0; C::shape().drivers.len()];
    let mut rows = vec![0.0; 2 * row];
    allocations(|| {
        equations.instants(phase, &[0.01, 0.02], &mut rows);
        let (first, later) = rows.split_at(row);
        equations.rates(phase, first, &state, &mut rates);
        equations.jacobian(phase, later, &state, &mut columns);
        equations.variation(phase, first, &state, &mut rates, &columns, &mut products);
        equations.outputs(phase, 0.01, &state, &mut outputs);
        equations.drivers(0.01, &mut drivers);
    })
}

#[test]
fn evaluations_allocate_nothing() {
    assert_eq!(evaluate::<Elastic>(), 0);
    assert_eq!(evaluate::<Exact>(), 0);
}

/// Allocations of one turn of the variational equations, and of ten: nothing but the room for what depends on the time.
#[test]
fn variational_equations_allocate_nothing_per_step() {
    let model = Bound::new(&Elastic::default());
    let flow = &Flow::new(&model, 0);
    let scales = Elastic::shape().scales;
    let varied = Varied { flow, scales };
    let start = varied.start(&[0.0; 6]);
    let options = Options::scaled(1e-8, scales);
    let mut workspace = Workspace::new(Explicit::Dop853, &varied);
    let counts = [0.24, 2.4].map(|end| {
        let times = (0.0, end);
        allocations(|| integrate(&varied, times, &start, &options, &mut workspace, &mut ()))
    });
    assert!(counts[0] <= 1 && counts[1] == 0, "{counts:?}");
}
