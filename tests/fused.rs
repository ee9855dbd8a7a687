//! No fused-multiply library call stands in a timed path.
//!
//! Without the instruction a fused multiply-add is a call of `fma`, some twenty times slower. This binary has an `fma` of
//! its own, which counts: what runs here must never come to it.

use std::marker::PhantomData;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard};

use assur::answer::{Method, Settings};
use assur::closure::{self, Assembly, AtDeadPoint, Axis, Closure, Linkage};
use assur::dispatch::{Task, dispatch};
use assur::ode;
use assur::periodic;
use assur::problem::{Equations, Phase, Reports, Scene, Span};
use assur::scalar::Scalar;
use assur_equations::batten::{Elastic, Start};
use assur_equations::{heald_linkage, presser_foot, sewing_feed, table_drive};

static CALLS: AtomicUsize = AtomicUsize::new(0);
/// Who counts.
static TURN: Mutex<()> = Mutex::new(());

/// Takes the place of the library's `fma` in this binary.
#[unsafe(no_mangle)]
extern "C" fn fma(a: f64, b: f64, c: f64) -> f64 {
    CALLS.fetch_add(1, Ordering::Relaxed);
    // Not fused: exact enough for whoever comes here, who is wrong to come.
    a * b + c
}

/// The counter itself: a fused operation outside of a dispatched task is such a call. Gives the turn to count.
fn check_counter() -> MutexGuard<'static, ()> {
    let turn = TURN.lock().unwrap_or_else(|poison| poison.into_inner());
    let before = CALLS.load(Ordering::Relaxed);
    let (a, b, c) = std::hint::black_box((3.0_f64, 5.0, 7.0));
    let value = std::hint::black_box(a.mul_add(b, c));
    assert_eq!(value, 22.0);
    // A build for a processor that has the instruction calls nothing.
    if !cfg!(target_feature = "fma") && cfg!(target_arch = "x86_64") {
        assert!(
            CALLS.load(Ordering::Relaxed) > before,
            "`fma` of this binary is not the one that is called"
        );
    }
    turn
}

#[test]
fn no_solve_calls_the_library() {
    let _turn = check_counter();
    let steady = Elastic::default();
    let run = Start::default();
    let (Span::Periodic(period), Span::Run(from, to)) = (steady.span(), run.span()) else {
        panic!("the scenes have other tasks");
    };
    for method in [Method::Dop853, Method::Tsit5] {
        let settings = Settings::new(method).rtol(1e-8);
        let calls = || CALLS.load(Ordering::Relaxed);
        let before = calls();
        periodic::solve(&steady, period, &settings).unwrap();
        let between = calls();
        ode::march(&run, (from, to), &run.start(), &settings).unwrap();
        assert_eq!((between - before, calls() - between), (0, 0), "{method:?}");
    }
}

/// Everything that is asked of a linkage, on the numbers of the machine at hand.
struct Loops<L>(PhantomData<L>);

impl<L: Linkage + Default> Task for Loops<L> {
    type Output = f64;

    #[inline(always)]
    fn run<S: Scalar>(self) -> f64 {
        let linkage = L::default();
        let mut assembly = Assembly::<L, S>::new(&linkage);
        assembly.start().unwrap();
        let range = linkage.ranges()[0];
        let step = S::from_f64((range.to - range.from) / 200.0);
        let mut place = assembly.independents().to_vec();
        let (shape, entry) = (linkage.shape(), linkage.shape().loops());
        let (outputs, variables) = (shape.outputs.len(), entry.variables.len());
        let lists = [
            outputs,
            outputs * variables,
            outputs * variables * (variables + 1) / 2,
            entry.dependents.len(),
            shape.places(),
        ];
        let mut values = vec![S::ZERO; lists.into_iter().max().unwrap_or(0)];
        let mut columns = vec![assembly.closure().zeros(); shape.drivers.len()];
        let mut sum = S::ZERO;
        for _ in 0..5 {
            place[0] = place[0] + step;
            assembly.move_to(&place).unwrap();
            assembly.outputs(&mut values);
            assembly.influence(&mut values);
            let (loops, position) = (assembly.closure(), assembly.position());
            let instant = loops.instant(&place);
            if entry.second {
                loops.second_influence(&instant, position, &mut values);
            }
            loops.residual(&instant, position, &mut values);
            loops.points(&instant, position, &mut values);
            loops.coefficients(&instant, position, &mut columns);
            for group in 0..entry.groups.len() {
                std::hint::black_box(loops.margin(group, &instant, position));
            }
            sum = sum + values[0];
        }
        sum.to_f64()
    }
}

/// Everything that is asked of a scene with modes, on the numbers of the machine at hand.
struct Modal<C>(PhantomData<C>);

impl<C: Scene + Default> Task for Modal<C> {
    type Output = f64;

    #[inline(always)]
    fn run<S: Scalar>(self) -> f64 {
        let scene = C::default();
        let shape = scene.shape();
        let equations = scene.prepare::<S>();
        let start = scene.start().into_iter();
        let state: Vec<S> = start.map(|value| S::from_f64(value + 1e-3)).collect();
        let states = state.len();
        let (mut rates, mut after) = (state.clone(), state.clone());
        let mut columns = vec![S::ZERO; states * states];
        let mut instant = vec![S::ZERO; equations.instant()];
        let time = S::from_f64(1e-3);
        let mut sum = S::ZERO;
        for mode in 0..shape.modes.len() {
            let (phase, guards) = (Phase::of(mode), shape.modes[mode].written());
            let most = guards.max(shape.outputs.len()).max(shape.measured);
            let mut values = vec![S::ZERO; most];
            let mut slopes = values.clone();
            equations.instants(phase, &[time], &mut instant);
            equations.rates(phase, &instant, &state, &mut rates);
            equations.jacobian(phase, &instant, &state, &mut columns);
            let mut products = columns.clone();
            equations.variation(phase, &instant, &state, &mut rates, &columns, &mut products);
            equations.outputs(phase, time, &state, &mut values);
            equations.measured(phase, time, &state, &mut values);
            let events = C::events(&equations).expect("it has events");
            events.guards(phase, time, &state, &mut values, &mut slopes);
            for (event, entry) in shape.modes[mode].events.iter().enumerate() {
                let permits = !entry.conditional || events.permits(phase, event, time, &state);
                if entry.sets && permits {
                    events.jump(phase, event, time, &state, &mut after);
                }
            }
            sum = sum + rates[0] + after[0];
        }
        sum.to_f64()
    }
}

#[track_caller]
fn check_calls(what: &str, work: impl FnOnce()) {
    let before = CALLS.load(Ordering::Relaxed);
    work();
    assert_eq!(CALLS.load(Ordering::Relaxed) - before, 0, "{what}");
}

/// A long function that is emitted is one of its own, which must have the instructions of its numbers nonetheless.
#[test]
fn long_functions_have_the_instructions_of_their_numbers() {
    let _turn = check_counter();
    check_calls("three chains of dyads", || {
        assert!(dispatch(Loops::<sewing_feed::Cycle>(PhantomData)).is_finite());
    });
    check_calls("a group that is iterated", || {
        assert!(dispatch(Loops::<heald_linkage::Printed>(PhantomData)).is_finite());
    });
    check_calls("contact and flight", || {
        assert!(dispatch(Modal::<presser_foot::Elliptic>(PhantomData)).is_finite());
    });
    check_calls("loops beside modes", || {
        assert!(dispatch(Modal::<presser_foot::Machine>(PhantomData)).is_finite());
    });
    check_calls("stick and slip", || {
        assert!(dispatch(Modal::<table_drive::Table1>(PhantomData)).is_finite());
    });
}

/// What is done carefully, off the beaten track, is not compiled for fused numbers; what it evaluates is.
#[test]
fn no_careful_way_calls_the_library() {
    let _turn = check_counter();
    for at_dead_point in [AtDeadPoint::Stop, AtDeadPoint::Through] {
        let axis = Axis { from: 1.5, to: 5.0, count: 40 };
        check_calls("through a dead point", || {
            let positions =
                closure::sweep(&heald_linkage::Printed::default(), &[axis], at_dead_point);
            assert!(positions.unwrap().len() > 20);
        });
    }
}
