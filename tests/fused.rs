//! No fused-multiply library call stands in a timed path.
//!
//! Without the instruction a fused multiply-add is a call of `fma`, some twenty times slower. This binary has an `fma` of
//! its own, which counts: what runs here must never come to it.

use std::sync::atomic::{AtomicUsize, Ordering};

use assur::ode;
use assur::periodic;
use assur::problem::{Scene, Span};
use assur::registry::{Method, Settings};
use assur_equations::batten::{Elastic, Start};

static CALLS: AtomicUsize = AtomicUsize::new(0);

/// Takes the place of the library's `fma` in this binary.
#[unsafe(no_mangle)]
extern "C" fn fma(a: f64, b: f64, c: f64) -> f64 {
    CALLS.fetch_add(1, Ordering::Relaxed);
    // Not fused: exact enough for whoever comes here, who is wrong to come.
    a * b + c
}

/// The counter itself: a fused operation outside of a dispatched task is such a call.
fn check_counter() {
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
}

#[test]
fn no_solve_calls_the_library() {
    check_counter();
    let steady = Elastic::default();
    let run = Start::default();
    let (Span::Periodic(period), Span::Run(from, to)) = (steady.span(), run.span()) else {
        panic!("the scenes have other tasks");
    };
    for method in [Method::Dop853, Method::Tsit5] {
        let settings = Settings { method, rtol: 1e-8 };
        let calls = || CALLS.load(Ordering::Relaxed);
        let before = calls();
        periodic::solve(&steady, period, &settings).unwrap();
        let between = calls();
        ode::march(&run, (from, to), &run.start(), &settings).unwrap();
        assert_eq!((between - before, calls() - between), (0, 0), "{method:?}");
    }
}
