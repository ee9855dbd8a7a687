//! Many runs.

use super::*;
use assur_solvers::shape::{Constant, Distribution, Quantity};

const WIDE: Constant = Constant {
    quantity: Quantity { name: "a", summary: "", unit: "", factor: 1.0, dimension: [(0, 1); 7] },
    is_dimension: true,
    default: 5.0,
    tolerance: 0.5,
    distribution: Distribution::Uniform,
    range: (f64::NEG_INFINITY, f64::INFINITY),
};

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let work = |index: usize| (index as f64).sqrt();
    let one = each(1000, 1, &|_| {}, &work);
    for threads in [0, 2, 7, 2000] {
        assert_eq!(each(1000, threads, &|_| {}, &work), one);
    }
    assert!(each(0, 3, &|_| {}, &work).is_empty());
}

#[test]
fn what_has_a_tolerance_is_drawn_and_the_rest_stays() {
    let fixed = Constant { tolerance: 0.0, ..WIDE };
    let all: Vec<Vec<f64>> =
        (0..20_000).map(|index| drawn(&[WIDE, fixed, WIDE], &[5.0, 7.0, -1.0], 3, index)).collect();
    assert!(all.iter().all(|one| one[1] == 7.0 && (one[0] - 5.0).abs() < 0.5));
    let first: Vec<f64> = all.iter().map(|one| one[0]).collect();
    let found = spread(&first, 0.999, &[0.5]).unwrap();
    assert!(found.mean.low < 5.0 && found.mean.high > 5.0, "{:?}", found.mean);
    assert!((found.deviation - 0.5 / 3f64.sqrt()).abs() < 3e-3);
    // The two are drawn independently.
    let product: f64 = all.iter().map(|one| (one[0] - 5.0) * (one[2] + 1.0)).sum();
    assert!((product / 20_000.0).abs() < 2e-3);
    assert_eq!(drawn(&[WIDE], &[5.0], 3, 11), drawn(&[WIDE], &[5.0], 3, 11));
}

#[test]
fn a_small_spread_around_a_large_value_keeps_its_digits() {
    let values = [1e9 + 1.0, 1e9 + 2.0, 1e9 + 4.0, f64::NAN];
    let found = spread(&values, 0.95, &[0.0, 0.25, 1.0]).unwrap();
    assert_eq!(found.count, 3);
    assert!((found.deviation - (7.0_f64 / 3.0).sqrt()).abs() < 1e-9);
    assert_eq!(found.quantiles[1], (0.25, 1e9 + 1.5));
    assert_eq!(spread(&[f64::NAN], 0.95, &[]), None);
}

#[test]
fn slopes_are_those_of_formulas() {
    let at = |x: f64| Some(vec![x.sin(), x.powi(5), if x < 0.9995 { f64::NAN } else { x.ln() }]);
    let found = slopes(&at, (1.0, 1.0), 3);
    for (slope, expected) in found.iter().zip([1f64.cos(), 5.0]) {
        let slope = slope.expect("a slope");
        assert!((slope.value - expected).abs() < 1e-10, "{slope:?}");
        assert!((slope.value - expected).abs() <= 5.0 * slope.error + 1e-14, "{slope:?}");
    }
    let near = found[2].expect("a slope from smaller changes");
    assert!((near.value - 1.0).abs() < 1e-9, "{near:?}");
    // At a kink there is none, and the error says so.
    let kink = slopes(&|x| Some(vec![x.max(0.0)]), (0.0, 1.0), 1)[0].expect("a difference");
    assert!((kink.value - 0.5).abs() < 1e-12 && kink.error > 0.49, "{kink:?}");
    let lost = slopes(&|x: f64| (x <= 1.0).then(|| vec![x]), (1.0, 1.0), 1);
    assert_eq!(lost, [None]);
}
