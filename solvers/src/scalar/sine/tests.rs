//! Errors of the kernel against sine and cosine in twice the precision.

use super::*;
use crate::scalar::Fused;
use std::f64::consts::{FRAC_PI_2, PI};

/// A number as the sum of two, about 106 bits.
#[derive(Clone, Copy)]
pub(in crate::scalar) struct Double(pub f64, pub f64);

/// The sum of two numbers, exactly.
fn sum(a: f64, b: f64) -> Double {
    let s = a + b;
    let part = s - a;
    Double(s, (a - (s - part)) + (b - part))
}

/// The product of two numbers, exactly.
pub(in crate::scalar) fn product(a: f64, b: f64) -> Double {
    let p = a * b;
    Double(p, f64::mul_add(a, b, -p))
}

impl Double {
    pub fn plus(self, other: Self) -> Self {
        let (high, low) = (sum(self.0, other.0), sum(self.1, other.1));
        let middle = sum(high.0, high.1 + low.0);
        sum(middle.0, middle.1 + low.1)
    }
    pub fn times(self, other: Self) -> Self {
        let p = product(self.0, other.0);
        sum(p.0, p.1 + (self.0 * other.1 + self.1 * other.0))
    }
    fn over(self, divisor: f64) -> Self {
        let first = self.0 / divisor;
        let p = product(first, -divisor);
        let rest = self.plus(p);
        sum(first, (rest.0 + rest.1) / divisor)
    }
    fn negative(self) -> Self {
        Self(-self.0, -self.1)
    }
}

/// The sum of `first · x^k / k!` over `k = start, start + 2, …` with alternating signs.
fn series(x: Double, first: Double, start: u32) -> Double {
    let square = x.times(x).negative();
    let mut term = first;
    let mut total = first;
    for k in (start + 1..40).step_by(2) {
        term = term.times(square).over(f64::from(k * (k + 1)));
        total = total.plus(term);
    }
    total
}

/// Sine and cosine of an angle, to about 2⁻⁸⁵ of their value for angles to 1e5.
pub(in crate::scalar) fn reference(angle: f64) -> (Double, Double) {
    let turns = (angle / FRAC_PI_2).round();
    let mut rest = Double(angle, 0.0);
    for part in [FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33] {
        let p = product(turns, -part);
        rest = rest.plus(Double(p.0, 0.0)).plus(Double(p.1, 0.0));
    }
    let (s, c) = (series(rest, rest, 1), series(rest, Double(1.0, 0.0), 0));
    match (turns as i64).rem_euclid(4) {
        0 => (s, c),
        1 => (c, s.negative()),
        2 => (s.negative(), c.negative()),
        _ => (c.negative(), s),
    }
}

/// Error of a result in units in the last place of the exact value.
fn error(found: f64, exact: Double) -> f64 {
    let magnitude = exact.0.abs();
    let unit = f64::from_bits(magnitude.to_bits() + 1) - magnitude;
    ((found - exact.0) - exact.1).abs() / unit
}

/// Angles of all sizes to 1e5, and those nearest to every multiple of π/4.
fn angles() -> Vec<f64> {
    let mut seed = 12345u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 * 2f64.powi(-53)
    };
    let mut angles = Vec::new();
    for _ in 0..25_000 {
        angles.push((2.0 * random() - 1.0) * 1.0e5);
        angles.push((2.0 * random() - 1.0) * 10.0);
        angles.push((2.0 * random() - 1.0) * PI);
        angles.push(10f64.powf(25.0 * random() - 20.0));
    }
    for n in 1..127_000 {
        let angle = f64::from(n) * (PI / 4.0);
        angles.extend([angle, angle.next_up(), -angle.next_down()]);
    }
    angles.retain(|angle| angle.abs() <= LIMIT);
    angles
}

/// Largest errors of sine and cosine.
fn largest<S: Bits<Word = u64>>() -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for angle in angles() {
        let (sine, cosine) = S::from_f64(angle).sin_cos();
        let exact = reference(angle);
        worst[0] = worst[0].max(error(sine.to_f64(), exact.0));
        worst[1] = worst[1].max(error(cosine.to_f64(), exact.1));
    }
    worst
}

#[test]
fn errors_stay_below_a_unit_in_the_last_place() {
    for (name, worst) in [("f64", largest::<f64>()), ("Fused", largest::<Fused>())] {
        println!("{name}: sine {:.4} ulp, cosine {:.4} ulp", worst[0], worst[1]);
        assert!(worst[0] < 1.0 && worst[1] < 1.0, "{name}: {worst:?}");
        assert!(worst[0] > 0.3, "{name}: an error of {worst:?} is too good to be measured");
    }
}

#[test]
fn reference_is_exact_where_the_sine_is_known() {
    // The nearest double to π misses it by this much.
    let (sine, cosine) = reference(PI);
    assert_eq!(sine.0, 1.2246467991473532e-16);
    assert_eq!(sine.1, -2.99476980971834e-33);
    assert_eq!((cosine.0, cosine.1), (-1.0, 7.498798913309288e-33));
    assert_eq!(reference(0.5).0.0, 0.479425538604203);
}

/// Checks single angles and lanes against each other and the standard library.
fn check_lanes<S: Bits<Word = u64>>() {
    let angles = [0.0, -0.0, 1.0e5, -1.0e5, 1.0e5f64.next_up(), -7.0e22, 2.5, 1.0e300];
    let (sines, cosines) = S::sin_cos_all(angles.map(S::from_f64));
    for (k, angle) in angles.into_iter().enumerate() {
        let (sine, cosine) = S::from_f64(angle).sin_cos();
        assert_eq!(sines[k].bits(), sine.bits());
        assert_eq!(cosines[k].bits(), cosine.bits());
        assert!((sine.to_f64() - angle.sin()).abs() <= 1.2e-16, "sin {angle}");
        assert!((cosine.to_f64() - angle.cos()).abs() <= 1.2e-16, "cos {angle}");
    }
    assert_eq!(sines[0].bits(), 0.0f64.to_bits());
    assert_eq!(sines[1].bits(), (-0.0f64).to_bits());
    let lost = [f64::INFINITY, f64::NAN, 1.0, f64::NEG_INFINITY];
    let (sines, cosines) = S::sin_cos_all(lost.map(S::from_f64));
    for k in [0, 1, 3] {
        assert!(sines[k].to_f64().is_nan() && cosines[k].to_f64().is_nan());
    }
    assert_eq!(sines[2].bits(), S::ONE.sin_cos().0.bits());
    let ([], []) = S::sin_cos_all([]);
}

#[test]
fn lanes_are_independent() {
    check_lanes::<f64>();
    check_lanes::<Fused>();
}
