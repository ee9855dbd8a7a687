//! When the second order matters.

use super::super::{
    Quadratic, Sampling, Study, ToleranceError, corners, differences, influences, linear,
    monte_carlo, quadratics,
};
use super::{Heald, Source, study};
use crate::shape::Distribution;

#[test]
fn the_quadratic_form_has_the_derivatives_of_the_closed_loops() {
    let study = study(&[90.0], 1.0, Distribution::Uniform);
    let form = &quadratics(&Heald::default(), &study).expect("it assembles")[0];
    for p in 0..8 {
        for q in 0..8 {
            let (a, b) = (form.hessian[8 * p + q], form.hessian[8 * q + p]);
            assert!((a - b).abs() < 1e-9 * (a.abs() + 1.0), "{p} {q}: {a} {b}");
        }
    }
    // Half the tolerances leave an eighth of the error.
    let rest = |scale: f64| {
        let study = super::study(&[90.0], scale, Distribution::Uniform);
        differences(&Heald::default(), &study, 2_000, 1).expect("it assembles")[0]
    };
    let (whole, half) = (rest(2.0), rest(1.0));
    let ratio = whole.quadratic.rms / half.quadratic.rms;
    assert!((7.5..8.5).contains(&ratio), "{ratio}");
    let ratio = whole.linear.rms / half.linear.rms;
    assert!((3.9..4.1).contains(&ratio), "{ratio}");
}

#[test]
fn the_first_order_is_enough_for_the_tolerances_as_they_are() {
    let study = study(&[90.0], 1.0, Distribution::Uniform);
    let found = differences(&Heald::default(), &study, 2_000, 1).expect("it assembles")[0];
    assert_eq!(found.failed, 0);
    assert!(found.linear.rms < 2e-3 * found.errors.rms, "{found:?}");
}

/// Greatest error to first order.
fn first(study: &Study) -> f64 {
    let influences = influences(&Heald::default(), 0, &study.places).expect("it assembles");
    linear(&influences, &study.sources).expect("the sources are sound")[0].worst
}

/// Twenty times the tolerances: the worst case to first order is no bound.
#[test]
fn the_linear_sum_is_exceeded_where_tolerances_are_scaled_by_twenty() {
    let heald = Heald::default();
    for (degrees, at_least) in [(90.0, 1.015), (200.0, 1.16)] {
        let study = study(&[degrees], 20.0, Distribution::Uniform);
        let extremes = &corners(&heald, &study).expect("it assembles")[0];
        assert_eq!((extremes.exact.tried, extremes.exact.failed), (256, 0));
        let (exact, second) = (extremes.exact.worst(), extremes.quadratic.worst());
        let first = first(&study);
        assert!(exact > at_least * first, "{exact} {first}");
        assert!((exact - second).abs() < 0.3 * (exact - first), "{exact} {second} {first}");
        let compared = differences(&heald, &study, 4_000, 1).expect("it assembles")[0];
        assert!(compared.linear.rms > 5.0 * compared.quadratic.rms, "{compared:?}");
    }
}

/// To first order the output is not shifted, and its distribution is symmetric.
#[test]
fn shift_and_skewness_are_those_of_the_second_order() {
    let heald = Heald::default();
    let study = study(&[200.0], 20.0, Distribution::Uniform);
    let form = &quadratics(&heald, &study).expect("it assembles")[0];
    let moments = form.moments(&study.sources);
    let sampling = Sampling { samples: 400_000, ..Sampling::default() };
    let found = monte_carlo(&heald, &study, &sampling, &|_| ()).expect("it assembles");
    let found = &found.places[0];
    assert!(found.mean.high < -3e-4, "{:?}", found.mean);
    assert!(found.mean.low < moments.mean && moments.mean < found.mean.high);
    assert!((moments.skewness - found.skewness).abs() < 0.02, "{moments:?} {found:?}");
}

#[test]
fn too_many_sources_are_not_combined() {
    let mut study = study(&[90.0], 1.0, Distribution::Uniform);
    let source = study.sources[0];
    study.sources.resize(17, source);
    let expected = ToleranceError::TooManyCorners { sources: 17, most: 16 };
    assert_eq!(corners(&Heald::default(), &study), Err(expected));
}

/// `y = 2 x - 0.015 x²` of one error that is not symmetric: mean, deviation and skewness against means over its distribution.
#[test]
fn errors_to_one_side_make_the_form_skew() {
    let distribution = Distribution::Lognormal { ratio: 0.6 };
    let source = Source { variable: 0, half_width: 0.9, distribution };
    let form = Quadratic { value: 0.0, gradient: vec![2.0], hessian: vec![-0.03] };
    let found = form.moments(&[source]);
    let count = 400_000;
    let share = |index: usize| (index as f64 + 0.5) / f64::from(count);
    let error = |index: usize| form.error(&[0.9 * distribution.quantile(share(index))]);
    let mean = |of: &dyn Fn(f64) -> f64| {
        (0..count as usize).map(|index| of(error(index))).sum::<f64>() / f64::from(count)
    };
    let first = mean(&|error| error);
    let second = mean(&|error| (error - first).powi(2));
    let third = mean(&|error| (error - first).powi(3));
    assert!((found.mean - first).abs() < 1e-6, "{found:?} {first}");
    assert!((found.deviation - second.sqrt()).abs() < 1e-4, "{found:?} {second}");
    // The third moment leaves out the square of the second derivative.
    let skewness = third / second.powf(1.5);
    assert!((found.skewness - skewness).abs() < 2e-3, "{found:?} {skewness}");
    // Of a symmetric distribution it is that of the second derivative alone, below zero here.
    let symmetric = form.moments(&[Source { distribution: Distribution::Normal, ..source }]);
    assert!(symmetric.skewness < 0.0 && found.skewness > 0.3, "{symmetric:?} {found:?}");
}
