//! Series against what they are the series of.

use super::*;
use crate::dense::Factor;
use crate::scalar::Scalar;

/// Terms of `u = 0.4 + 0.7 θ - 0.2 θ² + 0.1 θ³`.
const ARGUMENT: [f64; 4] = [0.4, 0.7, -0.2, 0.1];

fn argument(k: usize) -> f64 {
    ARGUMENT.get(k).copied().unwrap_or(0.0)
}

/// Value of a series at a part of its length.
fn value(terms: &[f64], part: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| sum * part + term)
}

/// Compares a function of the argument with its series, on both sides of where that begins.
fn check(name: &str, exact: impl Fn(f64) -> f64, mut next: impl FnMut(usize, f64) -> f64) {
    let terms: Vec<f64> = (0..TERMS).map(|k| next(k, argument(k))).collect();
    for part in [-0.05, 0.02, 0.06] {
        let (sum, exact) = (value(&terms, part), exact(value(&ARGUMENT, part)));
        assert!(
            (sum - exact).abs() <= 4e-15 * exact.abs().max(1.0),
            "{name} at {part}: {sum} {exact}"
        );
    }
}

/// Checks functions of one quantity.
macro_rules! functions {
    ($($kind:ident $exact:expr;)*) => {$({
        let mut function = $kind::default();
        check(stringify!($kind), $exact, |k, u| function.next(k, u));
    })*};
}

#[test]
fn functions_are_their_series() {
    functions! {
        Exp f64::exp;
        ExpM1 f64::exp_m1;
        Ln f64::ln;
        Ln1p f64::ln_1p;
        Log10 f64::log10;
        Tan f64::tan;
        Tanh f64::tanh;
        Asin f64::asin;
        Acos f64::acos;
        Atan f64::atan;
        Sinh f64::sinh;
        Cosh f64::cosh;
        Sqrt f64::sqrt;
        Erf <f64 as Scalar>::erf;
        NormalCdf <f64 as Scalar>::normal_cdf;
    }
}

#[test]
fn sines_and_cosines_are_their_series() {
    let mut one = Sine::default();
    check("sine", f64::sin, |k, u| one.next(k, u).0);
    let mut one = Sine::default();
    check("cosine", f64::cos, |k, u| one.next(k, u).1);
    // An angle that grows evenly.
    let (mut turn, mut sine) = (Turn::default(), Sine::default());
    for k in 0..TERMS {
        let angle = if k < 2 { argument(k) } else { 0.0 };
        let (one, other) = (turn.next(k, angle), sine.next(k, angle));
        assert!((one.0 - other.0).abs() + (one.1 - other.1).abs() < 1e-16, "{k}");
    }
}

#[test]
fn products_quotients_and_powers_are_their_series() {
    let mut product = Product::default();
    check("square", |u| u * u, |k, u| product.next(k, u, u));
    // A factor that turns out to be a constant, on each side.
    let constant = |k: usize| 3.0 * one::<f64>(k);
    let mut product = Product::default();
    check("left", |u| 3.0 * u, |k, u| product.next(k, constant(k), u));
    let mut product = Product::default();
    check("right", |u| 3.0 * u, |k, u| product.next(k, u, constant(k)));
    let mut quotient = Quotient::default();
    check("quotient", |u| u / (2.0 - u), |k, u| quotient.next(k, u, 2.0 * one::<f64>(k) - u));
    for exponent in [1.5, -2.0, 3.0] {
        let mut power = Power::default();
        check("power", |u| u.powf(exponent), |k, u| power.next(k, u, exponent));
    }
}

#[test]
fn distances_and_angles_of_points_are_their_series() {
    let mut hypot = Hypot::default();
    check("hypot", |u| u.hypot(1.0 - u), |k, u| hypot.next(k, u, one::<f64>(k) - u));
    for side in [-1.0, 1.0] {
        let mut angle = Atan2::default();
        let x = |k: usize, u: f64| side * (one::<f64>(k) - 2.0 * u);
        check("atan2", |u| u.atan2(side * (1.0 - 2.0 * u)), |k, u| angle.next(k, u, x(k, u)));
    }
}

#[test]
fn solutions_of_systems_are_their_series() {
    let matrix = |u: f64, one: f64| [[3.0 * one + u, u], [u, 2.0 * one]];
    let solved = |u: f64, row: usize| {
        let [[a, b], [_, d]] = matrix(u, 1.0);
        let (first, second) = (u, 1.0 - u);
        let below = a * d - b * b;
        [(d * first - b * second) / below, (a * second - b * first) / below][row]
    };
    for row in 0..2 {
        let mut system = Matrix::<f64, Factor<f64, 2>, 2>::default();
        check(
            "solve",
            |u| solved(u, row),
            |k, u| system.next(k, matrix(u, one(k)), [u, one::<f64>(k) - u])[row],
        );
    }
}
