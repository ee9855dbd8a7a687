//! Published solutions: F. Mazzia, C. Magherini, *Test Set for Initial Value Problem Solvers*, release 2.4 (2008).

use super::problems::{HIRES, ROBERTSON, VAN_DER_POL};
use super::{Hand, Implicit, STIFF, march, relative_error, tolerances};

#[track_caller]
fn check<const N: usize>(
    problem: Hand<N>,
    (start, end): ([f64; N], f64),
    (rtol, atol): (f64, f64),
    expected: [f64; N],
    permitted: f64,
    evaluations: usize,
) {
    for method in STIFF.into_iter().chain([Implicit::Automatic]) {
        let motion = march(&problem, method, (0.0, end), start, &tolerances(rtol, atol)).unwrap();
        let error = relative_error(motion.end(), &expected);
        println!("{method:?}: {error:e} {:?} {:?}", motion.statistics, motion.switches);
        assert!(error < permitted, "{method:?} {error:e}");
        let took = motion.statistics.evaluations;
        assert!(took <= evaluations, "{method:?} {took}");
    }
}

#[test]
fn van_der_pol() {
    let expected = [1.706167732170483, -0.8928097010247975];
    let motion = ([2.0, 0.0], 2.0);
    check(VAN_DER_POL, motion, (1e-7, 1e-7), expected, 1e-5, 14_000);
    check(VAN_DER_POL, motion, (1e-10, 1e-10), expected, 1e-8, 75_000);
}

#[test]
fn robertson() {
    let expected = [2.083340149701255e-8, 8.333360770334713e-14, 0.999999979166505];
    let motion = ([1.0, 0.0, 0.0], 1e11);
    check(ROBERTSON, motion, (1e-8, 1e-18), expected, 1e-5, 14_000);
}

#[test]
fn hires() {
    let expected = [
        7.371312573325668e-4,
        1.442485726316185e-4,
        5.888729740967575e-5,
        1.175651343283149e-3,
        2.386356198831331e-3,
        6.238968252742796e-3,
        2.849998395185769e-3,
        2.850001604814231e-3,
    ];
    let start = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057];
    check(HIRES, (start, 321.8122), (1e-8, 1e-10), expected, 1e-5, 5_000);
}
