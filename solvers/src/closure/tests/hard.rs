//! Hard cases: what must stay stable, beside the failure of the naive way.

use super::linkages::{FourBar, Heald, Iterated, SixBar};
use super::published::{residual, started};
use crate::closure::{
    Apart, Assembly, AtDeadPoint, Axis, Closure, ClosureError, Event, Linkage, Newton, Trials as _,
    sweep,
};
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
fn check_change_points<L: Linkage>(
    linkage: &L,
    crossed: bool,
    step: f64,
    count: usize,
    offset: f64,
) {
    let mut assembly = started(linkage);
    let mut met = Vec::new();
    for k in 0..=count {
        let at = FRAC_PI_2 + offset + step * k as f64;
        assembly.move_to(&[at]).unwrap_or_else(|error| panic!("{error}"));
        met.extend(assembly.take_events());
        let found = assembly.coordinates()[1];
        assert!(apart(found, rocker(crossed, at)) < 1e-9, "{at}: {found}");
    }
    let turns = ((FRAC_PI_2 + offset + step * count as f64) / PI).floor().abs() as usize;
    assert_eq!(met.len(), turns, "{met:?}");
    for event in met {
        let Event::ChangePoint { at, .. } = event else { panic!("{event:?}") };
        assert!(apart(2.0 * at[0], 0.0) < 1e-11, "{at:?}");
    }
}

#[test]
fn flattened_parallelogram_goes_on_smoothly() {
    for crossed in [false, true] {
        check_change_points(&parallelogram(crossed), crossed, 1f64.to_radians(), 720, 0.0);
        check_change_points(
            &parallelogram(crossed),
            crossed,
            1f64.to_radians(),
            720,
            0.5f64.to_radians(),
        );
        check_change_points(&parallelogram(crossed), crossed, 7f64.to_radians(), 100, 0.123);
        check_change_points(&parallelogram(crossed), crossed, 30f64.to_radians(), 24, 0.0);
        check_change_points(&parallelogram(crossed), crossed, 1e-3, 4000, 0.0);
    }
}

#[test]
fn flattened_parallelogram_goes_on_smoothly_when_iterated() {
    for crossed in [false, true] {
        let linkage = Iterated(parallelogram(crossed));
        check_change_points(&linkage, crossed, 1f64.to_radians(), 720, 0.5f64.to_radians());
        check_change_points(&linkage, crossed, 7f64.to_radians(), 100, 0.123);
        check_change_points(&linkage, crossed, 1f64.to_radians(), 720, 0.0);
    }
}

#[test]
fn turning_back_at_a_change_point_is_no_crossing() {
    let mut assembly = started(&parallelogram(false));
    let mode = assembly.mode(0);
    assembly.move_to(&[PI]).expect("the mode goes on");
    assembly.move_to(&[3.0]).expect("the mode goes on");
    assert_eq!((assembly.mode(0), assembly.take_events()), (mode, vec![]));
    assert!(apart(assembly.position()[1], 3.0) < 1e-12);
    assembly.move_to(&[PI]).expect("the mode goes on");
    assembly.move_to(&[3.3]).expect("the mode goes on");
    assert_eq!((assembly.mode(0), assembly.take_events().len()), (-mode, 1));
    assert!(apart(assembly.position()[1], 3.3) < 1e-12);
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
    assert!((sine.abs() / expected - 1.0).abs() < 1e-5, "{sine} {expected}");
    let (at, gap) = dead_point(assembly.move_to(&[end + 1e-9]));
    assert!((at - end).abs() < 1e-12);
    assert!((gap / (short * 0.1) - 1.0).abs() < 1e-5, "{gap}");
    // The naive way, Newton's method from the position one degree before, does not stay on its side.
    let mut naive = started(&swinging());
    naive.move_to(&[end - 1f64.to_radians()]).expect("the mode goes on");
    let before = naive.sine(0);
    let instant = naive.closure().instant(&[end - 1e-9]);
    let mut z = *naive.position();
    let (mut row, mut matrix) = ([0.0; 2], [0.0; 4]);
    let mut sines = Vec::new();
    for _ in 0..60 {
        naive.closure().trial(0, &instant, &mut z, &mut row, &mut matrix);
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
        assert!((at.to_degrees() - expected).abs() < 6e-4, "{}", at.to_degrees());
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
    assembly.pass_dead_point(&[1.4]).expect("there is a dead point");
    let events = assembly.take_events();
    let [Event::DeadPoint { group: 0, at: passed, mode: after }] = &events[..] else {
        panic!("{events:?}")
    };
    assert!((passed[0] - at).abs() < 1e-12);
    assert_eq!(*after, -mode);
    assembly.move_to(&[0.8]).expect("the other mode goes back");
    let mut other = Assembly::<_, f64>::new(&swinging());
    other.start_at(&[0.8], &assembly.coordinates()).expect("it assembles");
    assert_eq!(assembly.mode(0), other.mode(0));
    assert_eq!(assembly.mode(0), -mode);

    let mut heald = started(&Heald::printed());
    dead_point(heald.move_to(&[4.5]));
    let sine = heald.sine(0);
    heald.pass_dead_point(&[4.5]).expect("there is a dead point");
    assert!(heald.sine(0) * sine < 0.0);
    heald.move_to(&[FRAC_PI_2]).expect("the other mode goes back");
    assert!(residual(&heald) < 1e-16);
    assert!((heald.position()[2].to_degrees() + 70.06145).abs() > 1.0);
}

#[test]
fn loops_that_fail_to_close_by_one_part_in_1e12() {
    // Stretched, the crank and the frame reach 0.14 m; rod and rocker fall short of it by 1e-12 of that.
    let mut linkage = parallelogram(false);
    linkage.values[1] -= 0.14e-12;
    let mut assembly = started(&linkage);
    let (at, gap) = dead_point(assembly.move_to(&[PI]));
    // d = l2 + l3 where (β - π)² = 2 · 0.14e-12 · 0.14 / (l1 a)
    let before = (2.0f64 * 0.14e-12 * 0.14 / 0.004).sqrt();
    assert!(((PI - at) / before - 1.0).abs() < 1e-3, "{:e}", PI - at);
    assert!((gap / 0.14e-12 - 1.0).abs() < 1e-3, "{gap:e}");
    // Nor is the gap jumped over, which is 3 µrad wide.
    for beyond in [PI + 1e-5, PI + 0.01, PI + 0.1] {
        let (again, _) = dead_point(assembly.move_to(&[beyond]));
        // The margin changes by 1e-7 m/rad there, and is known to 3e-17 m.
        assert!((again - at).abs() < 1e-9, "{again} {at}");
    }
    // The naive way clamps the cosine and goes on as if nothing were.
    let cosine: f64 = (0.04f64.powi(2) + linkage.values[1].powi(2) - 0.14f64.powi(2))
        / (2.0 * 0.04 * linkage.values[1]);
    assert!(cosine < -1.0 && cosine.clamp(-1.0, 1.0).acos() == PI);
}

#[test]
fn modes_that_miss_each_other_by_one_part_in_1e12_are_not_exchanged() {
    let mut linkage = parallelogram(false);
    linkage.values[1] += 0.14e-12;
    let mut assembly = started(&linkage);
    let mode = assembly.mode(0);
    for k in 0..=300 {
        assembly.move_to(&[FRAC_PI_2 + 0.01 * f64::from(k)]).expect("the mode goes on");
    }
    assert_eq!((assembly.mode(0), assembly.take_events()), (mode, vec![]));
    // With its sign kept, the parallelogram has turned into the crossed linkage.
    let at = assembly.independents()[0];
    assert!(apart(assembly.position()[1], rocker(true, at)) < 1e-6);
    assert!(apart(assembly.position()[1], rocker(false, at)) > 0.5);
}

#[test]
fn coincident_pivots() {
    // A kite: where the crank lies on the frame, rod and rocker turn freely about one point.
    let kite = |at: f64| FourBar::new([0.1, 0.06, 0.06, 0.1], at, [1.5, 1.5]);
    let outcome = Assembly::<_, f64>::new(&kite(0.0)).start();
    assert!(matches!(outcome, Err(ClosureError::Ambiguous { group: 0, .. })), "{outcome:?}");
    // On the way through, the smooth continuation is taken.
    let mut linkage = kite(0.5);
    linkage.start = [0.9, 1.5];
    let mut assembly = started(&linkage);
    let mut last = assembly.position()[0];
    for k in 1..=100 {
        assembly.move_to(&[0.5 - 0.01 * f64::from(k)]).expect("it goes on");
        let found = assembly.position()[0];
        assert!((found - last).abs() < 0.02, "{k}: {found} {last}");
        assert!(residual(&assembly) < 1e-12);
        last = assembly.position()[0];
    }
    let events = assembly.take_events();
    assert!(
        matches!(&events[..], [Event::ChangePoint { at, .. }] if at[0].abs() < 1e-11),
        "{events:?}"
    );
}

#[test]
fn links_of_no_length() {
    // A crank of no length moves nothing.
    let mut assembly = started(&FourBar::new([0.0, 0.09, 0.06, 0.1], 0.0, [0.4, 1.8]));
    let before = *assembly.position();
    assembly.move_to(&[3.0]).expect("nothing moves");
    assert_eq!(before, *assembly.position());
    // A rocker of none leaves a gap.
    let outcome =
        Assembly::<_, f64>::new(&FourBar::new([0.025, 0.09, 0.0, 0.1], 1.0, [0.4, 1.8])).start();
    let far = (0.025f64.powi(2) + 0.01 - 0.005 * 1f64.cos()).sqrt();
    match outcome {
        Err(ClosureError::NotAssembled { gap, .. }) => {
            assert!((gap - (far - 0.09).abs()).abs() < 1e-16)
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_million_between_the_longest_and_the_shortest_link() {
    let mut assembly = started(&FourBar::new([1e-6, 1.0, 0.5, 1.1], 0.0, [0.4, 1.8]));
    let at_rest = *assembly.position();
    for k in 0..=360 {
        let at = f64::from(k).to_radians();
        assembly.move_to(&[at]).expect("the crank turns");
        assert!(residual(&assembly) < 1e-15);
        // To first order in the crank, from its position at 0.
        let [gamma, theta, ..] = at_rest;
        let along = 1e-6 * ((at.cos() - 1.0) * gamma.cos() + at.sin() * gamma.sin());
        let expected = -along / (0.5 * (theta - gamma).sin());
        let found = assembly.position()[1] - theta;
        assert!((found - expected).abs() < 2e-11, "{found:e} {expected:e}");
    }
}

#[test]
fn angles_that_pass_half_a_turn() {
    // Drag link: frame shortest, both cranks turn.
    let linkage = FourBar::new([0.1, 0.09, 0.1, 0.03], 0.5, [0.0, 1.0]);
    let mut assembly = started(&linkage);
    let (mut last, mut jumps) = (*assembly.position(), 0);
    let first = last;
    for k in 1..=720 {
        assembly.move_to(&[0.5 + f64::from(k).to_radians()]).expect("the crank turns");
        let next = *assembly.position();
        assert!((next[1] - last[1]).abs() < 0.1);
        let naive = |z: [f64; 6]| z[5].atan2(z[4]);
        jumps += usize::from((naive(next) - naive(last)).abs() > 6.0);
        last = next;
    }
    assert!((last[1] - first[1] - 2.0 * TAU).abs() < 1e-12);
    assert_eq!(jumps, 2, "the arc tangent alone jumps");
}

#[test]
fn start_values_pick_the_nearest_mode() {
    let at = 0.5f64;
    let start = |values: [f64; 2]| {
        let mut linkage = FourBar::default();
        linkage.range.start = at;
        linkage.start = values;
        let mut assembly = Assembly::<_, f64>::new(&linkage);
        assembly.start().map(|start| (assembly.mode(0), *assembly.position(), start))
    };
    let (open, first, told) = start([0.5, 1.5]).expect("it assembles");
    assert!(told.assumed.is_empty());
    let (crossed, second, _) = start([-0.9, -1.9]).expect("it assembles");
    assert_eq!(open, -crossed);
    // One known value suffices; none is said to have been assumed.
    assert_eq!(start([f64::NAN, second[1] + 0.3]).expect("it assembles").0, crossed);
    let (assumed, _, told) = start([f64::NAN; 2]).expect("it assembles");
    assert_eq!((assumed, told.assumed), (1.0, vec![0]));
    // Whole turns are kept.
    let (mode, turned, _) = start([first[0] + TAU, first[1] - TAU]).expect("it assembles");
    assert_eq!(mode, open);
    assert!(
        (turned[0] - first[0] - TAU).abs() < 1e-12 && (turned[1] - first[1] + TAU).abs() < 1e-12
    );
    // Half way between the modes there is no nearest one.
    let middle = [0.5 * (first[0] + second[0]), 0.5 * (first[1] + second[1])];
    let outcome = start(middle);
    assert!(matches!(outcome, Err(ClosureError::Ambiguous { .. })), "{outcome:?}");
}

#[test]
fn newton_alone_lands_in_another_mode() {
    let linkage = Heald::printed();
    let loops = Apart(Linkage::prepare::<f64>(&linkage, &linkage.values));
    let mut kept = started(&linkage);
    let start = kept.coordinates();
    let (sign, mut other, mut same) = (kept.sine(0).signum(), 0, 0);
    for (number, degrees) in (-65..=220).step_by(5).enumerate() {
        let at = f64::from(degrees).to_radians();
        // Ours: from the start along the way, in one call.
        kept.travel(&[at]).expect("the mode goes on");
        assert_eq!(kept.sine(0).signum(), sign);
        assert!(residual(&kept) < 1e-15);
        // The naive way: Newton's method from rough values, here off by a radian.
        let mut z = Closure::<f64>::zeros(&loops.0);
        for (j, value) in start.iter().enumerate() {
            z[j] = value + if number >> j & 1 == 0 { 1.0 } else { -1.0 };
        }
        let mut newton = Newton::new(kept.closure().shape());
        if let Ok(closed) = newton.close(&loops, 0, &loops.instant_row(&[at], &[]), &mut z) {
            assert!(closed.residual < 1e-15);
            let away = (0..3).map(|j| apart(z[j], kept.position()[j])).fold(0.0, f64::max);
            if away > 1e-6 { other += 1 } else { same += 1 }
        }
    }
    assert!(other >= 5 && same >= 5, "{other} {same}");
}

#[test]
fn nonsense_is_refused() {
    let mut assembly = Assembly::<_, f64>::new(&FourBar::default());
    assert!(matches!(assembly.move_to(&[1.0]), Err(ClosureError::BadRange { .. })));
    assembly.start().expect("it assembles");
    assert!(matches!(assembly.move_to(&[f64::NAN]), Err(ClosureError::BadRange { .. })));
    assembly.move_to(&[1.0]).expect("it goes on");
    let mut broken = FourBar::default();
    broken.values[1] = f64::NAN;
    let outcome = Assembly::<_, f64>::new(&broken).start();
    assert!(matches!(outcome, Err(ClosureError::NotFinite { .. })), "{outcome:?}");
}

#[test]
fn sweeps_stop_or_pass_through() {
    let axis = Axis { from: 0.8, to: 1.4, count: 61 };
    let stopped = sweep(&swinging(), &[axis], AtDeadPoint::Stop).expect("it assembles");
    let end = end_of_swing();
    let count = ((end - 0.8) / 0.01) as usize + 1;
    assert_eq!((stopped.len(), stopped.missed), (count, 61 - count));
    assert!(
        matches!(&stopped.end, Some(ClosureError::DeadPoint { at, .. }) if (at[0] - end).abs() < 1e-12)
    );
    let through = sweep(&swinging(), &[axis], AtDeadPoint::Through).expect("it assembles");
    assert_eq!((through.len(), &through.end), (2 * count, &None));
    assert!((through.independents(2 * count - 1)[0] - 0.8).abs() < 1e-15);
    assert!((through.outputs(0)[0] - through.outputs(2 * count - 1)[0]).abs() > 0.1);
    assert!(matches!(&through.events[..], [Event::DeadPoint { .. }]));
}

#[test]
fn two_groups_flatten_at_once() {
    // Two parallelograms, the second on the coupler of the first: all of it swings in parallel.
    let linkage = SixBar {
        values: [0.04, 0.1, 0.04, 0.1, 0.05, 0.0, 0.1, 0.04, 0.15, 0.0],
        start: [0.0, FRAC_PI_2, 0.0, FRAC_PI_2],
    };
    for offset in [0.0, 0.5f64.to_radians()] {
        let mut assembly = started(&linkage);
        for k in 0..=720 {
            let at = FRAC_PI_2 + offset + f64::from(k).to_radians();
            assembly.move_to(&[at]).unwrap_or_else(|error| panic!("{error}"));
            let [a, b, c, d] = [0, 1, 2, 3].map(|j| assembly.position()[j]);
            assert!(apart(a, 0.0) + apart(b, at) + apart(c, 0.0) + apart(d, at) < 1e-8, "{k}");
        }
        assert_eq!(assembly.take_events().len(), 8);
    }
}

/// A place that is looked at twice, or once more beside itself, says nothing of where a mode leads: neither what changed there,
/// which is rounding, nor how far the next step goes by that measure.
#[test]
fn steps_that_lead_nowhere_lose_no_mode() {
    for nothing in [0.0, 1e-15, 1e-13] {
        let mut assembly = started(&Heald::default());
        for k in 0..=60 {
            let at = (60.0 + f64::from(k)).to_radians();
            for at in [at, at + nothing, at] {
                assembly.move_to(&[at]).unwrap_or_else(|error| panic!("{nothing:e}: {error}"));
            }
        }
    }
}
