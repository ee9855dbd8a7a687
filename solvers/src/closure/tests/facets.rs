//! How measures change with constants: facets beside linkages nearby.

use super::linkages::{FourBar, Iterated};
use crate::closure::{Along, AnyLinkage, Facet};
use assur_functions::Sense;
use std::f64::consts::TAU;

/// The swing and the largest cosine, which are to be small, the swing as what is to be large, the mean; and what is found where a
/// condition holds, once of the crank alone, once of the rocker, and where that begins or ends to hold.
const WANTED: [(usize, Option<Sense>); 7] = [
    (0, Some(Sense::Smallest)),
    (1, Some(Sense::Smallest)),
    (0, Some(Sense::Largest)),
    (2, Some(Sense::Largest)),
    (3, Some(Sense::Smallest)),
    (4, Some(Sense::Smallest)),
    (5, Some(Sense::Smallest)),
];

fn facets(linkage: &dyn AnyLinkage) -> Vec<Vec<Facet>> {
    let way = linkage.way().expect("it is swept");
    let constants = (0..4).map(|index| (index, 0.1)).collect();
    let facets = linkage.facets(way, constants, &WANTED).expect("the crank turns");
    facets.of(linkage).expect("the crank turns")
}

fn measures(linkage: &dyn AnyLinkage) -> Vec<f64> {
    let found = linkage.measures(linkage.way().expect("it is swept")).expect("the crank turns");
    found.into_iter().map(|one| one.value.expect("all are found")).collect()
}

/// Derivatives of all measures by a constant, from linkages nearby.
fn differences(linkage: &dyn AnyLinkage, constant: usize) -> Vec<f64> {
    let [behind, ahead] = [-1.0, 1.0].map(|way| {
        let mut values = linkage.values();
        values[constant] += way * 1e-6;
        measures(&*linkage.with_values(&values))
    });
    ahead.iter().zip(behind).map(|(a, b)| (a - b) / 2e-6).collect()
}

fn check(linkage: &dyn AnyLinkage) {
    assert!(matches!(linkage.way(), Some(Along::Driver(0, (0.0, TAU)))));
    let (all, known) = (facets(linkage), measures(linkage));
    for ((measure, _), facets) in WANTED.iter().zip(&all) {
        // None lies beyond the measure, and one is it.
        let furthest = facets
            .iter()
            .max_by(|a, b| a.value.total_cmp(&b.value))
            .expect("every measure has a facet");
        assert!((furthest.value - known[*measure]).abs() < 1e-12, "{measure}: {furthest:?}");
        for (constant, slope) in furthest.slopes.iter().enumerate() {
            let expected = differences(linkage, constant)[*measure];
            assert!((slope - expected).abs() < 2e-6, "{measure}, {constant}: {slope} {expected}");
        }
    }
    // Of what is to be small every place counts; of what is to be large only the extremes themselves.
    let counts: Vec<usize> = all.iter().map(Vec::len).collect();
    assert_eq!(counts, [2 * 128, 128, 1, 1, 2 * 21, 1, 1]);
    let within = |at: f64| at.cos() > 0.5 - 1e-12;
    assert!(all[4].iter().all(|facet| facet.at.is_some_and(within)), "{:?}", all[4]);
    assert!(all[1].iter().all(|facet| facet.at.is_some()) && all[2][0].at.is_none());
}

#[test]
fn facets_are_what_linkages_nearby_come_to() {
    check(&FourBar::default());
    check(&Iterated::default());
}

/// Facets of a linkage that hardly differs hardly differ: a place that goes from part to part takes value and slope along.
#[test]
fn facets_do_not_jump() {
    let mut linkage = FourBar::default();
    let mut before = facets(&linkage);
    for _ in 0..80 {
        linkage.values[1] += 2e-5;
        let after = facets(&linkage);
        for (a, b) in before.iter().flatten().zip(after.iter().flatten()) {
            assert!((a.value - b.value).abs() < 1e-3, "{a:?} {b:?}");
            for (a, b) in a.slopes.iter().zip(&b.slopes) {
                assert!((a - b).abs() < 0.05, "{a} {b}");
            }
        }
        before = after;
    }
}

/// Samples alone do not say how far out an extreme lies.
#[test]
fn extremes_lie_between_places() {
    let linkage = FourBar::default();
    let swing = measures(&linkage)[0] - linkage.values[0];
    let mut assembly = linkage.assemble();
    assembly.guide().start().expect("it assembles");
    let rocker = |step: usize| {
        assembly.travel(&[step as f64 * TAU / 60.0]).expect("the crank turns");
        assembly.guide().position[1]
    };
    let all: Vec<f64> = (0..=60).map(rocker).collect();
    let sampled = all.iter().copied().fold(f64::NEG_INFINITY, f64::max)
        - all.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(swing - sampled > 1e-5, "{swing} {sampled}");
    // The facets that lie furthest out are those of the extremes themselves.
    let best = facets(&linkage)[0].iter().map(|facet| facet.value).fold(f64::MIN, f64::max);
    assert!((best - linkage.values[0] - swing).abs() < 1e-12);
}
