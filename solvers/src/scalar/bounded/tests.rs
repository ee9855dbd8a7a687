//! Bounds hold, and are not much larger than they have to be.

use super::*;

/// Evaluates a function of two numbers that are slightly off, in all directions, and holds the values against the bound.
#[track_caller]
fn check(function: fn(Bounded, Bounded) -> Bounded) {
    // The product is rounded once more.
    let off = |value: f64, sign: f64| Bounded::exact(value * (1.0 + sign * f64::EPSILON));
    for (x, y) in [(0.137, 0.42), (0.42, 0.811), (0.811, 0.137)] {
        let Bounded { value, bound } = function(Bounded::from_f64(x), Bounded::from_f64(y));
        let mut worst: f64 = 0.0;
        for (right, up) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let beside = function(off(x, right), off(y, up));
            let (away, most) = ((beside.value - value).abs(), bound + beside.bound);
            assert!(away <= most, "{value} at ({x}, {y}): {away:e} > {most:e}");
            worst = worst.max(away);
        }
        let ample = 10.0 * (worst + FUNCTION * value.abs());
        assert!(bound <= ample, "{value} at ({x}, {y}): {bound:e} > {ample:e}");
    }
}

#[test]
fn values_stay_within_their_bounds() {
    let functions: [fn(Bounded, Bounded) -> Bounded; 27] = [
        |x, y| x + y,
        |x, y| x - y,
        |x, y| x * y,
        |x, y| x / y,
        |x, y| -x.mul_add(y, x),
        |x, _| x.sin_cos().0,
        |x, _| x.sin_cos().1,
        |x, _| x.tan(),
        |x, _| x.asin(),
        |x, _| x.acos(),
        |x, _| x.atan(),
        |x, _| x.sinh(),
        |x, _| x.cosh(),
        |x, _| x.tanh(),
        |x, _| x.exp(),
        |x, _| x.exp_m1(),
        |x, _| x.ln(),
        |x, _| x.ln_1p(),
        |x, _| x.log10(),
        |x, _| x.sqrt(),
        |x, _| x.erf(),
        |x, _| x.normal_cdf(),
        |x, _| (-x).abs() + x.floor() + x.sign(),
        |x, y| x.max(y) * x.min(y),
        Bounded::atan2,
        Bounded::hypot,
        Bounded::powf,
    ];
    functions.into_iter().for_each(check);
}

#[test]
fn what_rounding_hides_has_no_bound() {
    let [one, two, three] = [1.0, 2.0, 3.0].map(Bounded::from_f64);
    assert_eq!((one / (one + two - three)).bound, f64::INFINITY);
    assert_eq!(three.floor().bound, 1.0);
    assert_eq!((one + two - three).sign().bound, 2.0);
    assert_eq!((one + two - three).sqrt().bound, f64::INFINITY);
}

#[test]
fn exact_numbers_have_no_bound_to_carry() {
    let [zero, three] = [0.0, 3.0].map(Bounded::exact);
    for value in [zero.sqrt(), zero.powf(three / Bounded::exact(2.0)), zero * three, three.floor()]
    {
        assert_eq!(value.bound, 0.0, "{value:?}");
    }
    assert_eq!(Bounded::exact(-2.0).powf(three).value, -8.0);
    assert!(Bounded::exact(-2.0).powf(three).bound < 1e-14);
}
