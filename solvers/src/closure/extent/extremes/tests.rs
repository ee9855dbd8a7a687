//! Extremes and breaks of functions in closed form.

use super::*;

/// The course from -1 to 1 of a function that gives its value and rate, and the number of looks beside the samples.
fn course(function: impl Fn(f64) -> (f64, f64), parts: u32) -> (Course, usize) {
    let sample = |at: f64| {
        let (value, rate) = function(at);
        Node { at, value, rate }
    };
    let place = |k| -1.0 + 2.0 * f64::from(k) / f64::from(parts);
    let samples: Vec<_> = (0..=parts).map(|k| sample(place(k))).collect();
    let mut looks = 0;
    let found = follow(&samples, |at| {
        looks += 1;
        Ok(sample(at))
    });
    (found.expect("every place can be looked at"), looks)
}

/// Whether zero is or is not among the samples.
const PARTS: [u32; 2] = [180, 181];

#[track_caller]
fn check(function: impl Fn(f64) -> (f64, f64), expected: &[f64]) {
    for parts in PARTS {
        let (found, _) = course(&function, parts);
        assert_eq!(found.limits.len(), expected.len(), "{found:?}");
        for (limit, expected) in found.limits.iter().zip(expected) {
            let at = limit.place.at;
            assert!((at - expected).abs() < 1e-12, "{at} {expected}");
            let [below, above] = [at - 1e-4, at + 1e-4].map(|x| function(x).0);
            assert_eq!(limit.is_highest, limit.place.value >= below.max(above));
        }
        assert!(found.breaks.is_empty(), "{found:?}");
    }
}

/// A rate with what rounding may add to it, of either sign.
fn rounded(x: f64, rate: f64) -> f64 {
    rate + 1e-16 * (1e9 * x).sin()
}

#[test]
fn a_double_zero_of_the_rate_is_no_extreme() {
    check(|x| (x.powi(3), 3.0 * x * x), &[]);
    check(|x| (-x.powi(3), rounded(x, -3.0 * x * x)), &[]);
    check(|x| (7.0 + x.powi(5), 5.0 * x.powi(4)), &[]);
}

#[test]
fn a_triple_zero_of_the_rate_is_one_extreme() {
    check(|x| (x.powi(4), 4.0 * x.powi(3)), &[0.0]);
    let noisy = |x: f64| (-x.powi(4), rounded(x, -4.0 * x.powi(3)));
    for parts in PARTS {
        let (found, _) = course(noisy, parts);
        let [limit] = &found.limits[..] else { panic!("{found:?}") };
        assert!(limit.place.at.abs() < 1e-5, "{found:?}");
    }
}

#[test]
fn a_rest_on_a_summit_is_one_extreme() {
    let away = |x: f64| (x - 0.1).signum() * ((x - 0.1).abs() - 0.3).max(0.0);
    check(|x| (-away(x).powi(2), -2.0 * away(x)), &[0.1]);
    check(|x| (away(x), f64::from(u8::from(away(x) != 0.0))), &[]);
}

#[test]
fn two_extremes_between_neighbouring_samples_are_found() {
    let d = 4e-3;
    check(|x| (x.powi(3) / 3.0 - d * d * x, x * x - d * d), &[-d, d]);
}

#[test]
fn extremes_at_the_ends_are_not_inside() {
    let quarter = std::f64::consts::FRAC_PI_2;
    check(|x| ((quarter * x).sin(), quarter * (quarter * x).cos()), &[]);
}

#[test]
fn what_has_no_rate_is_not_looked_at() {
    let (found, looks) = course(|x| (x, f64::NAN), 180);
    assert_eq!((found, looks), (Course::default(), 0));
}

/// Checks the breaks, with what the function tends to at each on either side.
#[track_caller]
fn check_breaks(function: impl Fn(f64) -> (f64, f64), expected: &[(f64, f64, f64)]) {
    // A place is known to rounding, and what a square root leaves of that is its root.
    let is_same = |found: f64, expected: f64| {
        found == expected
            || (found - expected).abs() < 3e-8
            || (found.is_nan() && expected.is_nan())
    };
    for parts in PARTS {
        let (found, looks) = course(&function, parts);
        assert_eq!(found.breaks.len(), expected.len(), "{found:?}");
        for (found, &(at, before, after)) in found.breaks.iter().zip(expected) {
            assert!((found.at - at).abs() < 1e-12, "{found:?} {at}");
            assert!(is_same(found.before, before), "{found:?} {before}");
            assert!(is_same(found.after, after), "{found:?} {after}");
        }
        assert!(looks < 1000, "{looks}");
    }
}

#[test]
fn a_jump_has_a_limit_on_either_side() {
    let saw = |x: f64| (x - (x - 0.3).floor(), 1.0);
    check_breaks(saw, &[(-0.7, 0.3 + 1.0, 0.3), (0.3, 1.3, 0.3)]);
    check_breaks(|x| (f64::from(u8::from(x < 0.0)), 0.0), &[(0.0, 1.0, 0.0)]);
    // A small one in a steep function.
    check_breaks(|x| (1e3 * x + f64::from(u8::from(x > 0.1)), 1e3), &[(0.1, 100.0, 101.0)]);
}

#[test]
fn a_pole_is_no_extreme() {
    let (up, down) = (f64::INFINITY, f64::NEG_INFINITY);
    check_breaks(|x| ((x - 0.1).recip(), -(x - 0.1).powi(-2)), &[(0.1, down, up)]);
    check_breaks(|x| (x.recip(), -x.powi(-2)), &[(0.0, down, up)]);
    check_breaks(|x| (-x.powi(-2), 2.0 * x.powi(-3)), &[(0.0, down, down)]);
    let square = |x: f64| ((x - 0.123).powi(-2), -2.0 * (x - 0.123).powi(-3));
    check_breaks(square, &[(0.123, up, up)]);
    let (found, _) = course(square, 180);
    assert!(found.limits.is_empty(), "{found:?}");
    check_breaks(|x| (x.abs().ln(), x.recip()), &[(0.0, down, down)]);
}

#[test]
fn rounding_is_not_followed() {
    let noise = |x: f64| (1e-13 * (1e7 * x).sin(), 1e-9 * (3e7 * x).cos());
    let (found, looks) = course(noise, 180);
    assert_eq!((found, looks), (Course::default(), 0));
}

#[test]
fn a_high_summit_is_no_pole() {
    let summit = |x: f64| (x * x + 1e-8).recip();
    check(|x| (summit(x), -2.0 * x * summit(x).powi(2)), &[0.0]);
}

#[test]
fn an_end_of_the_domain_is_told() {
    let root = |x: f64| ((x - 0.5).sqrt(), 0.5 / (x - 0.5).sqrt());
    check_breaks(root, &[(0.5, f64::NAN, 0.0)]);
    check_breaks(|x| (x.ln(), x.ln().exp().recip()), &[(0.0, f64::NAN, f64::NEG_INFINITY)]);
}

#[test]
fn steep_passages_and_kinks_are_no_breaks() {
    check_breaks(|x| ((x - 0.1).cbrt(), (x - 0.1).cbrt().powi(-2) / 3.0), &[]);
    check(|x| ((x - 0.2).abs(), (x - 0.2).signum()), &[0.2]);
    check(|x| (((x - 0.2) * 1e3).tanh(), 1e3 / ((x - 0.2) * 1e3).cosh().powi(2)), &[]);
}
