//! Slopes of all functions.

use super::*;

/// Holds the slope of a function of one variable against central differences.
#[track_caller]
fn check(function: fn(Dual) -> Dual) {
    for x in [0.137, 0.42, 0.811] {
        let at = |x: f64| function(Dual::constant(x)).value;
        let step = 1e-5;
        let difference = (at(x + step) - at(x - step)) / (2.0 * step);
        let slope = function(Dual::variable(x)).slope;
        assert!(
            (slope - difference).abs() < 1e-8 * (1.0 + slope.abs()),
            "at {x}: {slope}, by differences {difference}"
        );
    }
}

#[test]
fn slopes_are_those_of_differences() {
    let functions: [fn(Dual) -> Dual; 26] = [
        |x| x.sin_cos().0,
        |x| x.sin_cos().1,
        Scalar::tan,
        Scalar::asin,
        Scalar::acos,
        Scalar::atan,
        Scalar::sinh,
        Scalar::cosh,
        Scalar::tanh,
        Scalar::exp,
        Scalar::exp_m1,
        Scalar::ln,
        Scalar::ln_1p,
        Scalar::log10,
        Scalar::sqrt,
        Scalar::erf,
        Scalar::normal_cdf,
        Scalar::floor,
        |x| (-x).abs(),
        |x| Dual::atan2(x * x, x - Dual::ONE),
        |x| (x + Dual::ONE).hypot(x * x),
        |x| x.powf(Dual::constant(2.5)),
        |x| Dual::constant(2.5).powf(x),
        |x| x / (Dual::ONE + x * x) - x,
        |x| x.max(Dual::constant(0.3)) * x.min(Dual::constant(0.5)),
        |x| x.mul_add(x.sign(), x),
    ];
    functions.into_iter().for_each(check);
}

#[test]
fn a_negative_base_has_whole_powers() {
    let cube = Dual::variable(-2.0).powf(Dual::constant(3.0));
    assert_eq!((cube.value, cube.slope), (-8.0, 12.0));
}
