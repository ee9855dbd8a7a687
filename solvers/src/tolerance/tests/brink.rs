//! Tolerances at the brink of what assembles, beside the naive way.

use super::super::made::small;
use super::super::{Sampling, Status, corners, monte_carlo};
use super::{Heald, at};
use crate::closure::{Assembly, Closure, Linkage, Variable};
use crate::tolerance::random::Random;

fn sampling(samples: u64) -> Sampling {
    Sampling { samples, ..Sampling::default() }
}

#[test]
fn half_of_the_linkages_fail_just_before_the_dead_centre() {
    let (heald, study) = at(220.213);
    let found = &monte_carlo(&heald, &study, &sampling(20_000), &|_| ())
        .expect("the nominal linkage assembles")
        .places[0];
    assert_eq!(found.status, Status::Conditional);
    assert!((0.4..0.6).contains(&found.failures.value), "{:?}", found.failures);
}

/// A made linkage closed by plain Newton steps from the nominal position: the output and the sign of the mode.
fn naive(heald: &Heald, place: &[f64], errors: &[f64], from: &[f64; 9]) -> Option<(f64, f64)> {
    let (mut values, mut independents) = (heald.values(), place.to_vec());
    for (variable, error) in Linkage::shape(heald).loops().variables.iter().zip(errors) {
        match *variable {
            Variable::Constant(index) => values[index] += error,
            Variable::Driver(index) => independents[index] += error,
        }
    }
    let closure = heald.prepare(&values);
    let instant = closure.instant(&independents);
    let (mut position, mut row, mut matrix) = (*from, [0.0; 3], [0.0; 9]);
    for _ in 0..50 {
        closure.trial(0, &instant, &mut position, &mut row, &mut matrix);
        if row.iter().all(|one| one.abs() < 1e-13) {
            let determinant = small::solve(3, &mut matrix, &mut row);
            return Some((position[2] - row[2], determinant));
        }
        small::solve(3, &mut matrix, &mut row);
        for (unknown, step) in position.iter_mut().zip(row) {
            *unknown -= step;
        }
    }
    None
}

/// Plain Newton steps close most of the linkages that do not assemble in the mode: in another one, or turned round.
#[test]
fn the_naive_way_averages_over_other_modes() {
    let (heald, study) = at(220.213);
    let place = &study.places[0];
    let mut assembly = Assembly::<Heald, f64>::new(&heald);
    assembly.start().expect("it assembles");
    assembly.move_to(place).expect("it gets there");
    let (nominal, sine) = (*assembly.position(), assembly.sine(0));
    let samples = 5_000;
    let mut random = Random::new(1, 0);
    let (mut found, mut others) = (0, 0);
    for _ in 0..samples {
        let sources = study.sources.iter();
        let errors: Vec<f64> = sources
            .map(|one| one.half_width * one.distribution.quantile(random.uniform()))
            .collect();
        if let Some((value, determinant)) = naive(&heald, place, &errors, &nominal) {
            found += 1;
            let elsewhere = (value - nominal[2]).abs() > 0.5;
            others += usize::from(determinant * sine < 0.0 || elsewhere);
        }
    }
    let ours = &monte_carlo(&heald, &study, &sampling(samples), &|_| ())
        .expect("the nominal linkage assembles")
        .places[0];
    assert!(others > 100, "{found} found, {others} elsewhere");
    let kept = (found - others) as f64 - ours.assembled as f64;
    assert!(kept.abs() < 0.02 * samples as f64, "{found} {others} {}", ours.assembled);
}

/// All errors at their extremes, as the corner says.
fn signed(half_widths: impl Iterator<Item = f64>, corner: u32) -> Vec<f64> {
    let sign = |bit: usize| if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
    half_widths.enumerate().map(|(bit, one)| sign(bit) * one).collect()
}

#[test]
fn extremes_just_before_the_dead_centre_are_no_turns_away() {
    for degrees in [-65.3297, -65.3, 220.213, 220.222] {
        let (heald, study) = at(degrees);
        let exact = corners(&heald, &study).expect("the nominal linkage assembles")[0].exact;
        assert!(exact.failed > 0 && exact.failed < exact.tried, "{exact:?}");
        assert!(exact.worst() < 0.2, "{degrees}: {exact:?}");
    }
}

#[test]
fn extremes_are_closed_to_rounding() {
    let (heald, study) = at(90.0);
    let exact = corners(&heald, &study).expect("the nominal linkage assembles")[0].exact;
    let mut assembly = Assembly::<Heald, f64>::new(&heald);
    assembly.start().expect("it assembles");
    assembly.move_to(&study.places[0]).expect("it gets there");
    let nominal = *assembly.position();
    for (error, corner) in [(exact.least, exact.least_at), (exact.greatest, exact.greatest_at)] {
        let errors = signed(study.sources.iter().map(|one| one.half_width), corner);
        let (value, _) = naive(&heald, &study.places[0], &errors, &nominal).expect("it closes");
        assert!((value - nominal[2] - error).abs() < 2e-15, "{error} {}", value - nominal[2]);
    }
}
