//! Hard cases: what must stay stable, beside the failure of the naive way.

use super::linkages::{FourBar, Heald};
use super::published::{residual, started};
use crate::closure::{Assembly, Closure, ClosureError, Event};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The change-point linkage: opposite links of the same length.
fn parallelogram(crossed: bool) -> FourBar {
    let start = if crossed { [-1.0, -2.3] } else { [0.0, 1.5] };
    FourBar::new([0.04, 0.1, 0.04, 0.1], FRAC_PI_2, start)
}

/// Angle of the rocker of the change-point linkage in its two smooth modes.
fn rocker(crossed: bool, crank: f64) -> f64 {
    let chi = 2.0 * (-3.0 / 7.0 / (0.5 * crank).tan()).atan();
    let theta = if crossed { PI - chi } else { crank };
    (theta + PI).rem_euclid(TAU) - PI
}

/// Difference of two angles.
fn apart(a: f64, b: f64) -> f64 {
    ((a - b + PI).rem_euclid(TAU) - PI).abs()
}

/// Follows a mode of the change-point linkage in equal steps, and checks it all the way.
#[track_caller]
fn check_change_points(crossed: bool, step: f64, count: usize, offset: f64) {
    let mut assembly = started(&parallelogram(crossed));
    let mut met = Vec::new();
    for k in 0..=count {
        let at = FRAC_PI_2 + offset + step * k as f64;
        assembly
            .move_to(&[at])
            .unwrap_or_else(|error| panic!("{error}"));
        met.extend(assembly.take_events());
        let found = assembly.position()[1];
        assert!(apart(found, rocker(crossed, at)) < 1e-9, "{at}: {found}");
    }
    let turns = ((FRAC_PI_2 + offset + step * count as f64) / PI)
        .floor()
        .abs() as usize;
    assert_eq!(met.len(), turns, "{met:?}");
    for event in met {
        let Event::ChangePoint { at, .. } = event else {
            panic!("{event:?}")
        };
        assert!(apart(2.0 * at[0], 0.0) < 1e-11, "{at:?}");
    }
}

#[test]
fn flattened_parallelogram_goes_on_smoothly() {
    for crossed in [false, true] {
        check_change_points(crossed, 1f64.to_radians(), 720, 0.0);
        check_change_points(crossed, 1f64.to_radians(), 720, 0.5f64.to_radians());
        check_change_points(crossed, 7f64.to_radians(), 100, 0.123);
        check_change_points(crossed, 30f64.to_radians(), 24, 0.0);
        check_change_points(crossed, 1e-3, 4000, 0.0);
    }
}

/// A four-bar whose crank cannot turn: it ends where rod and rocker are in line.
fn swinging() -> FourBar {
    FourBar::new([0.08, 0.05, 0.05, 0.1], 0.8, [0.5, 2.0])
}

/// Where it ends: `l1² + a² - 2 l1 a cos β = (l2 + l3)²`.
fn end_of_swing() -> f64 {
    (0.0064f64 / 0.016).acos()
}

/// The dead point that an error tells of, and the gap beyond.
#[track_caller]
fn dead_point(outcome: Result<(), ClosureError>) -> (f64, f64) {
    match outcome {
        Err(ClosureError::DeadPoint { at, gap, .. }) => (at[0], gap),
        other => panic!("{other:?}"),
    }
}

#[test]
fn range_that_the_linkage_cannot_cover() {
    let mut assembly = started(&swinging());
    let (at, gap) = dead_point(assembly.move_to(&[1.4]));
    assert!((at - end_of_swing()).abs() < 1e-12, "{at}");
    let far = (0.0164 - 0.016 * 1.4f64.cos()).sqrt() - 0.1;
    assert!((gap - far).abs() < 1e-15, "{gap}");
    // It stays where it was certain, and can be moved back.
    assert!(assembly.independents()[0] < at);
    assembly.move_to(&[0.8]).expect("the mode is kept");
    // The naive way closes by the arc cosine, which is not a number.
    let cosine: f64 =
        (0.0164 - 0.016 * 1.4f64.cos()) / (2.0 * 0.05 * (0.0164 - 0.016 * 1.4f64.cos()).sqrt());
    assert!(cosine.acos().is_nan());
}

#[test]
fn a_nanoradian_before_a_dead_point() {
    let mut assembly = started(&swinging());
    let end = end_of_swing();
    assembly.move_to(&[end - 1e-9]).expect("the mode goes on");
    assert!(residual(&assembly) < 1e-16);
    // d grows by (l1 a sin β / d) per radian; half the angle between the links is the root of 2 (1 - d/(l2 + l3)).
    let short = 0.008 * end.sin() / 0.1 * 1e-9 / 0.1;
    let expected = 2.0 * (2.0 * short).sqrt();
    let sine = assembly.sine(0);
    assert!(
        (sine.abs() / expected - 1.0).abs() < 1e-5,
        "{sine} {expected}"
    );
    let (at, gap) = dead_point(assembly.move_to(&[end + 1e-9]));
    assert!((at - end).abs() < 1e-12);
    assert!((gap / (short * 0.1) - 1.0).abs() < 1e-5, "{gap}");
    // The naive way, Newton's method from the position one degree before, does not stay on its side.
    let mut naive = started(&swinging());
    naive
        .move_to(&[end - 1f64.to_radians()])
        .expect("the mode goes on");
    let before = naive.sine(0);
    let instant = naive.closure().instant(&[end - 1e-9]);
    let mut z = *naive.position();
    let (mut row, mut matrix) = ([0.0; 2], [0.0; 4]);
    let mut sines = Vec::new();
    for _ in 0..60 {
        naive
            .closure()
            .trial(0, &instant, &mut z, &mut row, &mut matrix);
        let [a, b, c, d] = matrix;
        let determinant = a * d - b * c;
        z[0] -= (d * row[0] - b * row[1]) / determinant;
        z[1] -= (a * row[1] - c * row[0]) / determinant;
        sines.push((z[0] - z[1]).sin());
    }
    assert!(before.abs() > 0.1);
    assert!((sines[5] / expected).abs() > 10.0, "slow: {sines:?}");
}

#[test]
fn heald_linkage_lives_between_its_dead_points() {
    for (wanted, expected) in [(-1.5, -65.330f64), (4.5, 220.223)] {
        let mut assembly = started(&Heald::printed());
        let (at, gap) = dead_point(assembly.move_to(&[wanted]));
        assert!(
            (at.to_degrees() - expected).abs() < 6e-4,
            "{}",
            at.to_degrees()
        );
        assert!(gap > 1e-3, "{gap}");
        let (again, _) = dead_point(assembly.move_to(&[at + 1e-6 * wanted.signum()]));
        assert!((at - again).abs() < 1e-12, "{at} {again}");
    }
}

#[test]
fn dead_points_are_passed_onto_the_other_mode() {
    let mut assembly = started(&swinging());
    let (at, _) = dead_point(assembly.move_to(&[1.4]));
    let mode = assembly.mode(0);
    assembly
        .pass_dead_point(&[1.4])
        .expect("there is a dead point");
    let events = assembly.take_events();
    let [
        Event::DeadPoint {
            group: 0,
            at: passed,
            mode: after,
        },
    ] = &events[..]
    else {
        panic!("{events:?}")
    };
    assert!((passed[0] - at).abs() < 1e-12);
    assert_eq!(*after, -mode);
    assembly.move_to(&[0.8]).expect("the other mode goes back");
    let mut other = Assembly::<_, f64>::new(&swinging());
    other
        .start_at(&[0.8], &assembly.coordinates())
        .expect("it assembles");
    assert_eq!(assembly.mode(0), other.mode(0));
    assert_eq!(assembly.mode(0), -mode);

    let mut heald = started(&Heald::printed());
    dead_point(heald.move_to(&[4.5]));
    let sine = heald.sine(0);
    heald
        .pass_dead_point(&[4.5])
        .expect("there is a dead point");
    assert!(heald.sine(0) * sine < 0.0);
    heald
        .move_to(&[FRAC_PI_2])
        .expect("the other mode goes back");
    assert!(residual(&heald) < 1e-16);
    assert!((heald.position()[2].to_degrees() + 70.06145).abs() > 1.0);
}
