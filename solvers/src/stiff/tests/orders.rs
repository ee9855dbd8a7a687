//! Measured orders.

use super::problems::{SMOOTH, smooth};
use super::{Hand, Implicit, STIFF, fixed, march};

/// Errors at the end, and between the steps, with these fixed steps.
fn errors(method: Implicit, step: f64) -> (f64, f64) {
    let motion = march(&SMOOTH, method, (0.0, 2.0), [1.0, 0.0, 1.0], &fixed(step)).unwrap();
    let error = |time: f64| {
        let found = motion.at(time);
        let pairs = found.iter().zip(smooth(time));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let between = (0..400).map(|part| error(0.005 * f64::from(part)));
    (error(2.0), between.fold(0.0, f64::max))
}

#[track_caller]
fn check_order(method: Implicit, order: f64, dense: f64) {
    let (coarse, fine) = (errors(method, 0.1), errors(method, 0.05));
    let measured = (coarse.0 / fine.0).log2();
    assert!((measured - order).abs() < 0.3, "{measured} {fine:?}");
    // Within a step the error is one order above that of the continuous solution.
    let measured = (coarse.1 / fine.1).log2();
    assert!((measured - dense).abs() < 0.35, "{measured} {fine:?}");
}

#[test]
fn radau_is_of_order_5_and_its_continuous_solution_of_order_3() {
    check_order(Implicit::Radau, 5.0, 4.0);
}

#[test]
fn rosenbrock_is_of_order_5_and_its_continuous_solution_of_order_4() {
    check_order(Implicit::Rosenbrock, 5.0, 5.0);
}

/// Prothero and Robinson: `y' = λ (y - cos t) - sin t` with `λ = -1e6`, whose solution is `cos t`.
const PROTHERO_ROBINSON: Hand<1> =
    Hand::new(|time, [y]| [-1e6 * (y - time.cos()) - time.sin()], |_, _| [[-1e6]]);

/// Stiffness reduces the order: what is left of it where `h λ` is large is part of what a method is.
#[test]
fn the_order_that_stiffness_leaves() {
    let error = |method, step| {
        let motion = march(&PROTHERO_ROBINSON, method, (0.0, 1.5), [1.0], &fixed(step)).unwrap();
        (motion.end()[0] - 1.5_f64.cos()).abs()
    };
    let orders = STIFF.map(|method| {
        let (coarse, fine) = (error(method, 0.15), error(method, 0.075));
        println!("{method:?}: {coarse:e} {fine:e} {}", (coarse / fine).log2());
        (coarse / fine).log2()
    });
    // Radau IIA keeps h⁴ / (hλ) of its order 5 (Hairer, Wanner II, table IV.15.1), and Rodas5P no less.
    for order in orders {
        assert!((2.7..4.0).contains(&order), "{orders:?}");
    }
}

#[test]
fn motions_can_be_followed_backwards() {
    for method in STIFF.into_iter().chain([Implicit::Automatic]) {
        let options = super::tolerances(1e-9, 1e-9);
        let back = march(&SMOOTH, method, (2.0, 0.5), smooth(2.0), &options).unwrap();
        for (found, expected) in back.end().iter().zip(smooth(0.5)) {
            assert!((found - expected).abs() < 1e-7, "{method:?} {found}");
        }
        let between = back.at(1.1);
        assert!((between[0] - smooth(1.1)[0]).abs() < 1e-7, "{method:?}");
    }
}

#[test]
fn the_error_follows_the_tolerance() {
    for method in STIFF {
        for rtol in [1e-4, 1e-6, 1e-8, 1e-10] {
            let options = super::tolerances(rtol, rtol);
            let motion = march(&SMOOTH, method, (0.0, 10.0), [1.0, 0.0, 1.0], &options).unwrap();
            let error = (0..=1000)
                .map(|part| 0.01 * f64::from(part))
                .map(|time| (motion.at(time)[1] - smooth(time)[1]).abs())
                .fold(0.0, f64::max);
            println!("{method:?} {rtol:e}: {error:e} {:?}", motion.statistics);
            assert!(error < 20.0 * rtol, "{method:?} {rtol:e} {error:e}");
        }
    }
}
