//! Nothing is allocated where a scene of fixed size is evaluated or integrated.

use assur::dispatch::{Task, dispatch};
use assur::ode::{Dop853, Method, Options, Plain, Tsit5, Varied, Workspace, integrate};
use assur::problem::{Equations, Scene, Span, Storage};
use assur::scalar::Scalar;
use assur_equations::batten::{Elastic, Exact};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::marker::PhantomData;

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

/// State of a scene on a scalar type.
type State<C, S> = <<C as Scene>::Equations<S> as Equations<S>>::State;

/// Ten revolutions of a scene by a method, from rest.
struct Revolutions<C, M>(PhantomData<(C, M)>);

impl<C: Scene + Default, M: Method> Task for Revolutions<C, M> {
    type Output = (usize, usize);

    #[inline(always)]
    fn run<S: Scalar>(self) -> (usize, usize) {
        let scene = C::default();
        let Span::Periodic(period) = scene.span() else {
            panic!("the scene has another task");
        };
        let equations = scene.prepare::<S>();
        let start = State::<C, S>::zeros(C::shape().states.len());
        let options = Options::scaled(1e-10, C::shape().scales);
        let system = Plain(&equations);
        let mut workspace = Workspace::<_, M>::new::<S, _>(&system);
        let mut steps = 0;
        let count = allocations(|| {
            let times = (0.0, 10.0 * period);
            let done = integrate(&system, times, &start, &options, &mut workspace, &mut ());
            steps = done.unwrap().steps;
        });
        (count, steps)
    }
}

#[track_caller]
fn check_revolutions<C: Scene + Default, M: Method>() {
    let (count, steps) = dispatch(Revolutions::<C, M>(PhantomData));
    assert_eq!(count, 0);
    assert!(steps > 100, "{steps}");
}

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(Vec::<f64>::new), 0);
    assert_eq!(allocations(|| vec![1.0]), 1);
}

#[test]
fn ten_revolutions_allocate_nothing() {
    check_revolutions::<Elastic, Dop853>();
    check_revolutions::<Elastic, Tsit5>();
    check_revolutions::<Exact, Dop853>();
}

/// All functions of prepared equations.
fn evaluate<C: Scene + Default>() -> usize {
    let equations = C::default().prepare::<f64>();
    let state = State::<C, f64>::zeros(C::shape().states.len());
    let mut rate = state.clone();
    let mut columns = vec![state.clone(); C::shape().states.len()];
    let mut products = columns.clone();
    let mut outputs = vec![0.0; C::shape().outputs.len()];
    let mut drivers = vec![0.0; C::shape().drivers.len()];
    allocations(|| {
        let instant = equations.instant(0.01);
        let [_, later] = equations.instants([0.02, 0.03]);
        equations.derivative(&instant, &state, &mut rate);
        equations.jacobian(&later, &state, &mut columns);
        equations.variation(&instant, &state, &mut rate, &columns, &mut products);
        equations.outputs(0.01, &state, &mut outputs);
        equations.drivers(0.01, &mut drivers);
    })
}

#[test]
fn evaluations_allocate_nothing() {
    assert_eq!(evaluate::<Elastic>(), 0);
    assert_eq!(evaluate::<Exact>(), 0);
}

/// Allocations of one turn of the variational equations, and of ten: the two are copies of the start, whose columns
/// are a vector.
#[test]
fn variational_equations_allocate_nothing_per_step() {
    let scene = Elastic::default();
    let equations = scene.prepare::<f64>();
    let varied = Varied {
        equations: &equations,
        scales: Some(Elastic::shape().scales),
    };
    let start = varied.start::<f64>(&[0.0; 6]);
    let options = Options::scaled(1e-8, Elastic::shape().scales);
    let mut workspace = Workspace::<_, Dop853>::new::<f64, _>(&varied);
    let counts = [0.24, 2.4].map(|end| {
        allocations(|| {
            integrate(
                &varied,
                (0.0, end),
                &start,
                &options,
                &mut workspace,
                &mut (),
            )
        })
    });
    assert_eq!(counts[0], counts[1]);
    assert!(counts[0] <= 2, "{counts:?}");
}
