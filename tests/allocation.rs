//! Nothing is allocated where a scene of fixed size is evaluated, or in a step of any method.

use assur::model::{Bound, Flow, Model};
use assur::ode::{Explicit, Options, Varied, Workspace, integrate};
use assur::problem::{Equations, Phase, Reports, Scene, Span};
use assur::shape::Shape;
use assur::stiff;
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
    let start = vec![0.0; scene.shape().states.len()];
    let options = Options::scaled(1e-10, scene.shape().scales);
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
fn ten_revolutions_allocate_nothing() {
    check_revolutions::<Elastic>(Explicit::Dop853);
    check_revolutions::<Elastic>(Explicit::Tsit5);
    check_revolutions::<Exact>(Explicit::Dop853);
}

/// All functions of prepared equations.
fn evaluate<C: Scene + Default>() -> usize {
    let (equations, phase) = (C::default().prepare::<f64>(), Phase::of(0));
    let scene = C::default();
    let shape = scene.shape();
    let (states, row) = (equations.states(), equations.instant());
    let state = vec![0.0; states];
    let mut rates = state.clone();
    let mut columns = vec![0.0; states * states];
    let mut products = columns.clone();
    let mut outputs = vec![0.0; shape.outputs.len()];
    let mut drivers = vec![0.0; shape.drivers.len()];
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

/// Where nothing is known to be stiff, the memory of a stiff method, Radau's 14 lists with that of the spectrum, is taken when it is
/// first tried, and then kept.
#[test]
fn stiff_methods_allocate_nothing_per_step() {
    use stiff::Implicit::{Automatic, Radau, Rosenbrock};
    for (method, once) in [(Radau, 0), (Rosenbrock, 0), (Automatic, 14)] {
        let flow = Flow::new(&Oscillator, 0);
        let mut workspace = stiff::Workspace::new(method, &flow);
        let options = Options::default();
        for (end, allowed) in [(2.0, once), (6.0, 0)] {
            let mut steps = 0;
            let count = allocations(|| {
                let (times, start) = ((0.0, end), [2.0, 0.0]);
                let done =
                    stiff::integrate(&flow, times, &start, &options, &mut workspace, &mut ());
                steps = done.unwrap().steps;
            });
            assert!(count <= allowed, "{method:?}: {count}");
            assert!(steps > 500, "{method:?} {steps}");
        }
    }
}
