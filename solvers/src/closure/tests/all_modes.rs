//! Lists of all assembly modes against polynomials.

use super::linkages::{FourBar, Heald, SixBar, SliderCrank};
use crate::closure::{Closure, Linkage, Search, modes};
use std::f64::consts::PI;

/// A polynomial in `t = tan(φ7/2)`, lowest power first.
type Polynomial = Vec<f64>;

fn times(a: &[f64], b: &[f64]) -> Polynomial {
    let mut product = vec![0.0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn plus(a: &[f64], b: &[f64], factor: f64) -> Polynomial {
    let entry = |p: &[f64], k: usize| p.get(k).copied().unwrap_or(0.0);
    (0..a.len().max(b.len())).map(|k| entry(a, k) + factor * entry(b, k)).collect()
}

/// The polynomial of degree 8 of the specification: `P² - 4 Y0² (l6² - A²)`, all times `(1 + t²)⁴`.
fn polynomial(values: &[f64; 8], phi4: f64) -> Polynomial {
    let [l4, l5, l6, l7, a, b, s, kappa] = *values;
    // u + v cos φ7 and u + v sin φ7, times 1 + t²
    let with_cosine = |u: f64, v: f64| vec![u + v, 0.0, u - v];
    let with_sine = |u: f64, v: f64| vec![u, 2.0 * v, u];
    let x = with_cosine(b + s - l4 * phi4.cos(), l7 * (1.0 + kappa));
    let y0 = with_sine(a - l4 * phi4.sin(), kappa * l7);
    let one = vec![1.0, 0.0, 1.0];
    let square = times(&one, &one);
    let big_a = with_cosine(s, l7);
    let b2 =
        plus(&square.iter().map(|c| c * l6 * l6).collect::<Vec<_>>(), &times(&big_a, &big_a), -1.0);
    let sum = plus(&plus(&times(&x, &x), &times(&y0, &y0), 1.0), &b2, 1.0);
    let p = plus(&sum, &square, -l5 * l5);
    plus(&times(&p, &p), &times(&times(&y0, &y0), &b2), -4.0)
}

/// Values of `φ7` at the real roots: signs of the polynomial on a fine grid over the turn, `φ7 = π` among it.
fn real_roots(values: &[f64; 8], phi4: f64) -> Vec<f64> {
    let polynomial = polynomial(values, phi4);
    let f = |phi: f64| {
        let (s, c) = (0.5 * phi).sin_cos();
        let terms = polynomial.iter().enumerate();
        terms.map(|(k, p)| p * s.powi(k as i32) * c.powi(8 - k as i32)).sum::<f64>()
    };
    let count = 20_000;
    let grid = |k: usize| -PI + 2.0 * PI * k as f64 / f64::from(count);
    let mut roots = Vec::new();
    for k in 0..count as usize {
        let (mut low, mut high) = (grid(k), grid(k + 1));
        if f(low) * f(high) > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if f(low) * f(middle) <= 0.0 { high = middle } else { low = middle }
        }
        roots.push(low);
    }
    roots
}

/// Compares the list at one position of the heald linkage.
#[track_caller]
fn check_heald(linkage: &Heald, degrees: f64) -> usize {
    let at = degrees.to_radians();
    let list = modes(linkage, &[at], &Search::default()).expect("a position");
    let expected = real_roots(&linkage.values, at);
    assert!(list.complete, "{degrees}: {} undecided of {}", list.undecided, list.boxes);
    assert_eq!(list.modes.len(), expected.len(), "{degrees}: {list:?} {expected:?}");
    let mut found: Vec<f64> = list.modes.iter().map(|mode| mode.coordinates[2]).collect();
    found.sort_by(f64::total_cmp);
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-6, "{degrees}: {found} {expected}");
    }
    list.boxes
}

#[test]
fn heald_linkage_has_all_modes_of_its_polynomial() {
    let default = modes(&Heald::printed(), &[PI / 2.0], &Search::default()).expect("a position");
    assert_eq!((default.modes.len(), default.complete), (4, true));
    assert!(
        default.modes.iter().any(|mode| (mode.coordinates[2].to_degrees() + 70.06145).abs() < 1e-5)
    );
    let (mut most, mut degrees) = (0, -180.0);
    while degrees <= 180.0 {
        most = most.max(check_heald(&Heald::printed(), degrees));
        most = most.max(check_heald(&Heald::guided(), degrees));
        degrees += 7.3;
    }
    eprintln!("at most {most} boxes");
}

#[test]
fn modes_in_closed_form_are_counted() {
    let count = |list: crate::closure::AssemblyModes| (list.modes.len(), list.complete);
    let search = Search::default();
    assert_eq!(count(modes(&FourBar::default(), &[1.0], &search).expect("a position")), (2, true));
    assert_eq!(
        count(modes(&SliderCrank::default(), &[1.0], &search).expect("a position")),
        (2, true)
    );
    let six = modes(&SixBar::default(), &[1.0], &search).expect("a position");
    let loops = Linkage::prepare::<f64>(&SixBar::default(), &SixBar::default().values);
    let mut expected = 0;
    for (first, second) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let (mut z, instant) = (Closure::<f64>::zeros(&loops), loops.instant(&[1.0]));
        let sines =
            [loops.close(0, &instant, first, &mut z), loops.close(1, &instant, second, &mut z)];
        expected += usize::from(sines.iter().all(|sine| sine.is_finite()));
    }
    assert_eq!(count(six), (expected, true));
}

#[test]
fn what_does_not_assemble_has_no_mode() {
    let far = FourBar::new([0.01, 0.01, 0.01, 0.1], 0.0, [0.0; 2]);
    let list = modes(&far, &[0.3], &Search::default()).expect("a position");
    assert_eq!((list.modes.len(), list.complete), (0, true));
    let list = modes(&Heald::guided(), &[PI], &Search::default()).expect("a position");
    assert_eq!((list.modes.len(), list.complete), (0, true));
}
