//! Errors of the kernel against the angle whose sine and cosine are known in twice the precision.

use super::super::sine::tests::{Double, product, reference};
use super::*;
use crate::scalar::Fused;
use std::f64::consts::PI;

/// Error of an angle in units in its last place: the sine of what it is off, `(y cos φ − x sin φ)/r`.
fn error(found: f64, y: f64, x: f64) -> f64 {
    let (sine, cosine) = reference(found);
    let across = sine.times(Double(-x, 0.0)).plus(cosine.times(Double(y, 0.0)));
    let size = found.abs();
    let unit = size.next_up() - size;
    (across.0 / x.hypot(y) / unit).abs()
}

/// Points all around, along the axes, along the borders of the eighths and of the sixteenths.
fn points() -> Vec<(f64, f64)> {
    let mut seed = 12345u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 * 2f64.powi(-53)
    };
    let mut points = Vec::new();
    for k in 0..60_000 {
        let angle = match k % 3 {
            0 => PI * (2.0 * random() - 1.0),
            1 => f64::from(k % 16) * (PI / 8.0) + 1e-3 * (random() - 0.5),
            _ => f64::from(k % 4) * (PI / 2.0) + 10f64.powf(-12.0 * random()),
        };
        let size = 10f64.powf(6.0 * random() - 3.0);
        points.push((size * angle.sin(), size * angle.cos()));
    }
    points
}

fn largest<S: Bits<Word = u64>>() -> f64 {
    let angle = |(y, x)| S::atan2(S::from_f64(y), S::from_f64(x)).to_f64();
    let errors = points().into_iter().map(|(y, x)| error(angle((y, x)), y, x));
    errors.fold(0.0, f64::max)
}

#[test]
fn errors_stay_below_two_units_in_the_last_place() {
    for (name, worst) in [("f64", largest::<f64>()), ("Fused", largest::<Fused>())] {
        println!("{name}: {worst:.4} ulp");
        assert!(worst < 1.8, "{name}: {worst}");
        assert!(worst > 0.4, "{name}: {worst} is too good to be measured");
    }
}

#[test]
fn the_measure_agrees_with_the_standard_library() {
    let errors = points().into_iter().map(|(y, x)| error(y.atan2(x), y, x));
    assert!(errors.fold(0.0, f64::max) < 1.0);
    // The tangent of the nearest double to π/4 is 1 less 6.1e-17.
    assert!(error(FRAC_PI_4, 1.0, 1.0) < 0.5);
    assert!(product(0.1, 10.0).1 != 0.0);
}

/// Checks single points and lanes against each other and the standard library.
fn check_lanes<S: Bits<Word = u64>>() {
    let values = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        f64::MAX,
        -f64::MIN_POSITIVE,
        5e-324,
        1e300,
        1e-300,
    ];
    for y in values {
        let lanes = S::atan2_all([S::from_f64(y); 12], values.map(S::from_f64));
        for (x, lane) in values.into_iter().zip(lanes) {
            let (found, expected) = (lane.to_f64(), y.atan2(x));
            let single = S::atan2(S::from_f64(y), S::from_f64(x));
            assert_eq!(found.to_bits(), single.to_f64().to_bits(), "{y} {x}");
            if expected.is_nan() {
                assert!(found.is_nan(), "{y} {x}");
                continue;
            }
            assert!((found - expected).abs() <= 4e-16 * expected.abs(), "{y} {x}");
            assert_eq!(found.is_sign_negative(), expected.is_sign_negative());
        }
    }
}

#[test]
fn points_beyond_the_limits_take_the_other_path() {
    check_lanes::<f64>();
    check_lanes::<Fused>();
    let []: [f64; 0] = f64::atan2_all([], []);
}

#[test]
fn angles_along_the_axes_are_exact() {
    for (y, x, angle) in [
        (0.0, 2.0, 0.0),
        (2.0, 0.0, FRAC_PI_2),
        (0.0, -2.0, PI),
        (-0.0, -2.0, -PI),
        (-2.0, -0.0, -FRAC_PI_2),
        (3.0, 3.0, FRAC_PI_4),
        (3.0, -3.0, 3.0 * FRAC_PI_4),
    ] {
        assert_eq!(<f64 as Scalar>::atan2(y, x), angle);
        assert_eq!(Fused::atan2(Fused(y), Fused(x)).0, angle);
    }
}
