//! The same samples for the same seed, and what cannot be asked.

use super::super::{Sampling, Study, ToleranceError, monte_carlo};
use super::{Heald, at, study};
use crate::shape::Distribution;
use std::sync::atomic::{AtomicU64, Ordering};

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let study = study(&[70.0, 90.0], 1.0, Distribution::Truncated);
    let sampling =
        |threads, seed| Sampling { samples: 30_001, seed, threads, ..Sampling::default() };
    let run = |threads, seed| {
        monte_carlo(&Heald::default(), &study, &sampling(threads, seed), &|_| ())
            .expect("it assembles")
    };
    let one = run(1, 7);
    assert_eq!(one, run(2, 7));
    assert_eq!(one, run(3, 7));
    assert_ne!(one, run(1, 8));
}

#[test]
fn progress_adds_up() {
    let (heald, study) = at(90.0);
    let done = AtomicU64::new(0);
    let sampling = Sampling { samples: 10_000, ..Sampling::default() };
    let progress = |more| {
        done.fetch_add(more, Ordering::Relaxed);
    };
    monte_carlo(&heald, &study, &sampling, &progress).expect("it assembles");
    assert_eq!(done.into_inner(), 10_000);
}

#[track_caller]
fn check_refused(change: impl Fn(&mut Study, &mut Sampling), expected: &ToleranceError) {
    let (heald, mut study) = at(90.0);
    let mut sampling = Sampling::default();
    change(&mut study, &mut sampling);
    let found = monte_carlo(&heald, &study, &sampling, &|_| ());
    assert_eq!(&found.unwrap_err(), expected);
}

#[test]
fn questions_without_sense_are_refused() {
    let samples = |samples| ToleranceError::BadSamples { samples, least: 2, most: 100_000_000_000 };
    check_refused(|_, sampling| sampling.samples = 0, &samples(0));
    check_refused(|_, sampling| sampling.samples = 1_000_000_000_000, &samples(1_000_000_000_000));
    check_refused(|study, _| study.sources.clear(), &ToleranceError::NoSource);
    check_refused(|study, _| study.places.clear(), &ToleranceError::NoPlace);
    let bad = |half_width| ToleranceError::BadHalfWidth { source: 2, half_width };
    check_refused(|study, _| study.sources[2].half_width = -1e-5, &bad(-1e-5));
    check_refused(|study, _| study.sources[2].half_width = f64::INFINITY, &bad(f64::INFINITY));
    check_refused(
        |study, _| study.sources[2].variable = 8,
        &ToleranceError::NoVariable { source: 2, variable: 8, variables: 8 },
    );
    check_refused(|study, _| study.output = 1, &ToleranceError::NoOutput { output: 1, outputs: 1 });
    check_refused(
        |_, sampling| sampling.confidence = 1.0,
        &ToleranceError::BadLevel { level: 1.0 },
    );
}

#[test]
fn a_tolerance_that_is_no_number_is_refused() {
    let (heald, mut study) = at(90.0);
    study.sources[0].half_width = f64::NAN;
    let found = monte_carlo(&heald, &study, &Sampling::default(), &|_| ());
    assert!(matches!(found, Err(ToleranceError::BadHalfWidth { source: 0, .. })));
}
