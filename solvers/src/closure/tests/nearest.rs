//! Start values that are not near the position meant: the nearest of all assemblies is taken.

use super::linkages::{Heald, SixBar};
use crate::closure::{Assembly, ClosureError, Linkage, Search, modes};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Numbers from 0 to 1, one after the other.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1u64 << 53) as f64
}

/// Distance of angles, whole turns apart.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let apart = |(a, b): (&f64, &f64)| (a - b + PI).rem_euclid(TAU) - PI;
    a.iter().zip(b).map(apart).map(|one| one * one).sum::<f64>().sqrt()
}

/// Checks what a linkage of angles is put together as. True if it assembles.
#[track_caller]
fn check_nearest<L: Linkage>(linkage: &L, at: f64, near: &[f64]) -> bool {
    let search = Search::default();
    let listed = modes(linkage, &[at], &search).expect("a place");
    let mut all: Vec<f64> =
        listed.modes.iter().map(|mode| distance(&mode.coordinates, near)).collect();
    all.sort_by(f64::total_cmp);
    let mut assembly = Assembly::<L, f64>::new(linkage);
    let outcome = assembly.start_at(&[at], near);
    let Some(least) = all.first() else {
        assert!(outcome.is_err(), "{outcome:?}");
        return false;
    };
    if all.get(1).is_some_and(|second| *second <= 1.002 * least) {
        return false;
    }
    let start = outcome.unwrap_or_else(|error| panic!("{error}, though there are {all:?}"));
    let found = distance(&assembly.coordinates(), near);
    assert!(found < least + 1e-9 || found < 0.5, "{found} {all:?}");
    let far = assembly.coordinates();
    let far = far.iter().zip(near).filter(|(a, b)| distance(&[**a], &[**b]) > 1.0);
    assert_eq!(start.contradicted.len(), far.count());
    true
}

#[test]
fn of_a_six_bar_far_from_its_start_values_the_nearest_assembly_is_taken() {
    let state = &mut 1;
    let mut assembled = 0;
    for _ in 0..2000 {
        let mut linkage = SixBar::default();
        for value in &mut linkage.values {
            *value *= 0.4 + 1.2 * random(state);
        }
        let near: Vec<f64> = (0..4).map(|_| TAU * random(state) - PI).collect();
        assembled += usize::from(check_nearest(&linkage, TAU * random(state), &near));
    }
    assert!(assembled > 1000, "{assembled}");
}

#[test]
fn of_an_iterated_linkage_the_nearest_assembly_is_taken() {
    let state = &mut 1;
    for _ in 0..20 {
        let near: Vec<f64> = (0..3).map(|_| TAU * random(state) - PI).collect();
        check_nearest(&Heald::printed(), FRAC_PI_2, &near);
    }
}

#[test]
fn a_linkage_that_has_no_assembly_says_so() {
    let mut linkage = SixBar::default();
    linkage.values[6] = 1e-3;
    linkage.values[7] = 1e-3;
    let outcome = Assembly::<SixBar, f64>::new(&linkage).start();
    assert!(matches!(outcome, Err(ClosureError::NotAssembled { group: 1, .. })), "{outcome:?}");
}
