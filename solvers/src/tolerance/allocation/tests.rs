//! Allocations against closed forms, over a range, and requirements that cannot be met.

use super::*;
use crate::tolerance::ToleranceError;
use crate::tolerance::tests::{Heald, study};

fn candidate(variable: usize, factor: f64) -> Candidate {
    Candidate {
        variable,
        distribution: Distribution::Uniform,
        cost: Cost { fixed: 0.0, factor, exponent: 1.0 },
        least: 0.0,
        most: f64::INFINITY,
    }
}

const INFLUENCES: [f64; 4] = [0.75, -4.5, 0.84, 2.2];
const FACTORS: [f64; 4] = [5e-5, 5e-5, 2e-4, 1e-4];

fn candidates(exponent: f64) -> Vec<Candidate> {
    let one = |(variable, factor): (usize, &f64)| {
        let mut one = candidate(variable, *factor);
        one.cost.exponent = exponent;
        one
    };
    FACTORS.iter().enumerate().map(one).collect()
}

/// Checks the optimum for one place against its closed form, up to the factor that fills the band.
#[track_caller]
fn check_closed_form(rule: Rule, exponent: f64, shape: impl Fn(f64, f64) -> f64) {
    let band = 1e-3;
    let candidates = candidates(exponent);
    let found = allocate_along(&mut |_| INFLUENCES.to_vec(), 1, &candidates, rule, band)
        .expect("there is an optimum");
    let pairs = INFLUENCES.iter().zip(FACTORS);
    let mut expected: Vec<f64> = pairs.map(|(k, b)| shape(k.abs(), b)).collect();
    let scale = band / rule.error(&INFLUENCES, &expected);
    expected.iter_mut().for_each(|one| *one *= scale);
    for (found, expected) in found.tolerances.iter().zip(&expected) {
        assert!((found / expected - 1.0).abs() < 2e-4, "{found} {expected}");
    }
    // Near the optimum the cost is flat: it is far more accurate than the tolerances.
    let pairs = candidates.iter().zip(&expected);
    let cost: f64 = pairs.map(|(one, t)| one.cost.of(*t)).sum();
    assert!((found.cost / cost - 1.0).abs() < 1e-7, "{} {cost}", found.cost);
    assert!(found.greatest <= band * (1.0 + 1e-12) && found.greatest > band * (1.0 - 1e-6));
    // A cost that goes with the power -k of the band.
    assert!((found.price / (exponent * cost) - 1.0).abs() < 1e-4, "{found:?}");
    assert_eq!(found.active.len(), 1);
}

#[test]
fn worst_case_with_reciprocal_cost() {
    check_closed_form(Rule::Worst, 1.0, |k, b| (b / k).sqrt());
}

#[test]
fn root_sum_square_with_reciprocal_cost() {
    check_closed_form(Rule::RootSumSquare, 1.0, |k, b| (b / (k * k)).cbrt());
}

#[test]
fn worst_case_with_other_exponents() {
    for exponent in [0.5, 2.0] {
        check_closed_form(Rule::Worst, exponent, |k, b| (b / k).powf(1.0 / (1.0 + exponent)));
    }
}

#[test]
fn root_sum_square_with_other_exponents() {
    for exponent in [0.5, 2.0] {
        let shape = |k: f64, b: f64| (b / (k * k)).powf(1.0 / (2.0 + exponent));
        check_closed_form(Rule::RootSumSquare, exponent, shape);
    }
}

#[test]
fn deviations_permit_wider_tolerances_than_half_widths() {
    let run = |rule| {
        allocate_along(&mut |_| INFLUENCES.to_vec(), 1, &candidates(1.0), rule, 1e-3)
            .expect("there is an optimum")
    };
    let (half_widths, deviations) = (run(Rule::RootSumSquare), run(Rule::Deviation));
    for (narrow, wide) in half_widths.tolerances.iter().zip(&deviations.tolerances) {
        assert!((wide / narrow - 3f64.sqrt()).abs() < 1e-3);
    }
}

fn heald(rule: Rule, band: f64) -> (Study, Vec<Candidate>, Result<Allocation, AllocationError>) {
    let degrees: Vec<f64> = (0..=12).map(|k| 60.0 + 5.0 * f64::from(k)).collect();
    let study = study(&degrees, 1.0, Distribution::Uniform);
    let candidates: Vec<Candidate> =
        study.sources.iter().map(|source| candidate(source.variable, source.half_width)).collect();
    let found = allocate(&Heald::default(), &study, &candidates, rule, band);
    (study, candidates, found)
}

/// The greatest error over ten thousand places.
fn densely(rule: Rule, candidates: &[Candidate], tolerances: &[f64]) -> f64 {
    let places: Vec<Vec<f64>> =
        (0..=10_000).map(|k| vec![(60.0 + 0.006 * f64::from(k)).to_radians()]).collect();
    let all = crate::tolerance::influences(&Heald::default(), 0, &places).expect("it moves");
    let error = |place: usize| {
        let row = candidates.iter();
        let weighed: Vec<f64> =
            row.map(|one| rule.weigh(all.at(place)[one.variable], one)).collect();
        rule.error(&weighed, tolerances)
    };
    (0..places.len()).map(error).fold(0.0, f64::max)
}

#[test]
fn the_band_holds_between_the_places_too() {
    for (rule, band) in [(Rule::Worst, 1.0e-3), (Rule::Deviation, 0.28e-3)] {
        let (_, candidates, found) = heald(rule, band);
        let found = found.expect("there is an optimum");
        let dense = densely(rule, &candidates, &found.tolerances);
        assert!(dense <= band * (1.0 + 1e-9), "{dense}");
        assert!(dense >= band * (1.0 - 1e-6), "{dense}");
        assert!((found.greatest / dense - 1.0).abs() < 1e-7);
    }
}

/// Halving all tolerances halves the band too, but costs more.
#[test]
fn halving_the_band_costs_less_than_halving_every_tolerance() {
    let (study, candidates, _) = heald(Rule::Worst, 1.0);
    let present: Vec<f64> = study.sources.iter().map(|one| one.half_width).collect();
    let half = 0.5 * densely(Rule::Worst, &candidates, &present);
    let (.., found) = heald(Rule::Worst, half);
    let found = found.expect("there is an optimum");
    // Every present tolerance costs one.
    assert!(found.cost < 0.95 * 16.0, "{}", found.cost);
    let shares: f64 = found.active.iter().map(|one| one.share).sum();
    assert!((shares - 1.0).abs() < 1e-5);
}

/// The optimum for the place in the middle alone leaves the band at the ends.
#[test]
fn one_place_is_not_the_range() {
    let band = 1.0e-3;
    let (mut study, candidates, whole) = heald(Rule::Worst, band);
    study.places = vec![study.places[6].clone()];
    let one = allocate(&Heald::default(), &study, &candidates, Rule::Worst, band)
        .expect("there is an optimum");
    let dense = densely(Rule::Worst, &candidates, &one.tolerances);
    assert!(dense > 1.05 * band, "{dense}");
    assert!(one.cost < whole.expect("there is an optimum").cost);
}

#[test]
fn limits_are_kept_and_named() {
    let mut candidates = candidates(1.0);
    candidates[1].least = 2e-4;
    candidates[0].most = 1e-5;
    let found = allocate_along(&mut |_| INFLUENCES.to_vec(), 1, &candidates, Rule::Worst, 1e-3)
        .expect("there is an optimum");
    assert_eq!(found.limits[..2], [Limit::Most, Limit::Least]);
    assert!(found.tolerances[0] <= 1e-5 && found.tolerances[1] >= 2e-4);
    assert_eq!(found.limits[2..], [Limit::None, Limit::None]);
    // Nothing but upper limits binds in a wide band.
    candidates.iter_mut().for_each(|one| one.most = 3e-4);
    let wide = allocate_along(&mut |_| INFLUENCES.to_vec(), 1, &candidates, Rule::Worst, 1.0)
        .expect("there is an optimum");
    assert_eq!(wide.limits, [Limit::Most; 4]);
    assert!(wide.price.abs() < 1e-6 * wide.cost && wide.greatest < 1.0);
}

#[test]
fn a_band_out_of_reach_says_where_and_by_how_much() {
    let (study, mut candidates, _) = heald(Rule::Worst, 1.0);
    candidates.iter_mut().for_each(|one| one.least = 4e-5);
    candidates[7].least = 1e-3;
    let found = allocate(&Heald::default(), &study, &candidates, Rule::Worst, 0.5e-3);
    let Err(AllocationError::OutOfReach { at, reached, band, candidate, share }) = found else {
        panic!("{found:?}");
    };
    assert_eq!(band, 0.5e-3);
    let least: Vec<f64> = candidates.iter().map(|one| one.least).collect();
    let dense = densely(Rule::Worst, &candidates, &least);
    assert!((reached / dense - 1.0).abs() < 1e-7);
    assert!(at[0] >= 60f64.to_radians() - 1e-9 && at[0] <= 120f64.to_radians() + 1e-9);
    assert!(candidate < 8 && share > 0.125 && share < 1.0);
}

#[track_caller]
fn check_refused(change: impl Fn(&mut Vec<Candidate>), band: f64, expected: &AllocationError) {
    let mut candidates = candidates(1.0);
    change(&mut candidates);
    let influences = [0.75, 0.0, 0.84, 2.2];
    let found = allocate_along(&mut |_| influences.to_vec(), 1, &candidates, Rule::Worst, band);
    assert_eq!(found.as_ref().unwrap_err(), expected);
}

#[test]
fn requirements_without_sense_are_refused() {
    check_refused(|_| (), 0.0, &AllocationError::BadBand { band: 0.0 });
    check_refused(|_| (), -1.0, &AllocationError::BadBand { band: -1.0 });
    check_refused(|_| (), 1e-3, &AllocationError::Unbounded { candidate: 1 });
    check_refused(|all| all.clear(), 1e-3, &AllocationError::Tolerance(ToleranceError::NoSource));
    check_refused(
        |all| (all[2].least, all[2].most) = (2.0, 1.0),
        1e-3,
        &AllocationError::BadLimits { candidate: 2, least: 2.0, most: 1.0 },
    );
    check_refused(
        |all| all[3].cost.factor = -1.0,
        1e-3,
        &AllocationError::BadCost { candidate: 3, factor: -1.0, exponent: 1.0 },
    );
    let nan = allocate_along(&mut |_| vec![1.0; 4], 1, &candidates(1.0), Rule::Worst, f64::NAN);
    assert!(matches!(nan, Err(AllocationError::BadBand { .. })));
}
