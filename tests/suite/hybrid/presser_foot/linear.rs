//! The linear fabric that is never left: matrix exponentials say what the motion is.

use super::*;

#[track_caller]
fn check_rows<C: Foot>(name: &str) {
    let case = &REFERENCE["linear"][name];
    let mut compared = 0;
    for row in case["rows"].as_array().unwrap() {
        if number(&row["smallest"]) <= 0.0 {
            continue;
        }
        compared += 1;
        let mut foot = foot::<C>(case);
        foot.set("omega", number(&row["omega"]));
        let found = foot.cycle().unwrap();
        assert!(changes(&found.motion).is_empty());
        let start = found.motion.pieces[0].trajectory.at(0.0);
        for (value, (expected, size)) in
            start.iter().zip(numbers(&row["start"]).iter().zip([1e-3, 1e-1]))
        {
            assert!((value - expected).abs() < 1e-11 * size, "{name}: {value:e} {expected:e}");
        }
        for pair in row["forces"].as_array().unwrap() {
            let pair = numbers(pair);
            let found = force(&foot, &found.motion, (pair[0] + PI) * foot.period() / (2.0 * PI));
            assert!(
                (found - pair[1]).abs() < 1e-9,
                "{name} at {} rad: {found} {}",
                pair[0],
                pair[1]
            );
        }
    }
    assert!(compared >= 2, "{name}: {compared}");
}

#[test]
fn without_separation_the_motion_is_that_of_the_closed_form() {
    check_rows::<Elliptic>("elliptic");
    check_rows::<Elliptic>("elliptic_half");
    check_rows::<Elliptic>("elliptic_low");
    check_rows::<Straight>("straight");
    check_rows::<StraightLow>("straight_low");
    check_rows::<FiveHarmonics>("five_harmonics");
    check_rows::<Machine>("machine");
    check_rows::<MachineHarmonics>("machine_harmonics");
}

/// At rest on the plate the fabric bears spring and weight.
#[test]
fn at_rest_on_the_plate() {
    for changes in [&[][..], &[("F10", 0.0)], &[("F10", 0.0), ("c1", 0.0)], &[("c1", 1e5)]] {
        let mut foot = Elliptic::with(changes);
        foot.rise = 0.0;
        let found = foot.cycle().unwrap();
        let w = found.motion.end[0];
        let expected = -(foot.F10 + foot.m * foot.g) / (foot.c1 + foot.c2);
        assert!((w / expected - 1.0).abs() < 1e-11, "{w:e} {expected:e}");
        let load = Measured::of(&foot, &found.motion).mean;
        let balance = foot.F10 + foot.c1 * w + foot.m * foot.g;
        assert!((load / balance - 1.0).abs() < 1e-11, "{load} {balance}");
    }
}

fn separates<C: Foot>(case: &Value, omega: f64) -> bool {
    let mut foot = foot::<C>(case);
    foot.set("omega", omega);
    let found = foot.cycle().unwrap_or_else(|error| panic!("{omega}: {error}"));
    !changes(&found.motion).is_empty()
}

/// Contact is lost on one side of each border and kept on the other, one part in a million away; and between the borders
/// nothing changes.
#[track_caller]
fn check_borders<C: Foot>(name: &str, expected: &[bool]) {
    let case = &REFERENCE["linear"][name];
    let borders = case["borders"].as_array().unwrap();
    let kinds: Vec<bool> = borders.iter().map(|one| one["separates"].as_bool().unwrap()).collect();
    assert_eq!(kinds, expected, "{name}");
    let mut free = true;
    let mut speeds: Vec<(f64, bool)> = Vec::new();
    for border in borders {
        let (omega, begins) = (number(&border["omega"]), border["separates"].as_bool().unwrap());
        assert_eq!(free, begins);
        speeds.extend([(omega * (1.0 - 1e-6), !begins), (omega * (1.0 + 1e-6), begins)]);
        free = !begins;
    }
    for (omega, expected) in speeds {
        assert_eq!(separates::<C>(case, omega), expected, "{name} at {omega} 1/s");
    }
    // A coarse look at everything between.
    for step in 0..=20 {
        let omega = 120.0 + 15.0 * f64::from(step);
        let passed = borders.iter().filter(|one| number(&one["omega"]) < omega).count();
        assert_eq!(separates::<C>(case, omega), passed % 2 == 1, "{name} at {omega} 1/s");
    }
}

/// The straight path loses contact in two windows, not above a speed.
#[test]
fn speeds_of_first_separation() {
    check_borders::<Elliptic>("elliptic", &[true]);
    check_borders::<Elliptic>("elliptic_half", &[true]);
    check_borders::<Elliptic>("elliptic_low", &[]);
    check_borders::<Straight>("straight", &[true, false, true]);
    check_borders::<StraightLow>("straight_low", &[]);
    check_borders::<FiveHarmonics>("five_harmonics", &[true]);
    check_borders::<Machine>("machine", &[true]);
    check_borders::<MachineHarmonics>("machine_harmonics", &[true]);
}

#[test]
fn speeds_of_first_separation_of_the_other_fabrics() {
    fn check<C: Foot>(name: &str) {
        let omega = number(&REFERENCE["first_separation"][name]);
        for (factor, expected) in [(1.0 - 1e-7, false), (1.0 + 1e-7, true)] {
            let mut foot = C::default();
            foot.set("omega", factor * omega);
            assert_eq!(
                !changes(&foot.cycle().unwrap().motion).is_empty(),
                expected,
                "{name} {omega}"
            );
        }
    }
    check::<Progressive>("progressive");
    check::<HuntCrossley>("hunt_crossley");
}

/// One part in a million below the smallest preload the foot leaves the fabric.
#[test]
fn the_smallest_preload() {
    fn check<C: Foot>(name: &str) {
        let case = &REFERENCE["linear"][name];
        for row in case["rows"].as_array().unwrap() {
            for (factor, expected) in [(1.0 + 1e-6, false), (1.0 - 1e-6, true)] {
                let mut foot = foot::<C>(case);
                foot.set("omega", number(&row["omega"]));
                let preload = factor * number(&row["preload"]);
                foot.set("F10", preload);
                let found = foot.cycle().unwrap_or_else(|error| panic!("{name} {row}: {error}"));
                assert_eq!(!changes(&found.motion).is_empty(), expected, "{name}: {preload} N");
            }
        }
    }
    check::<Elliptic>("elliptic");
    check::<Straight>("straight");
    check::<StraightLow>("straight_low");
    check::<FiveHarmonics>("five_harmonics");
}

/// A method of order four that does not locate the events has order one, because the force jumps where contact is
/// regained; ours keeps the order of the method. The closed orbit of the second computation ends where it began.
#[test]
fn without_location_of_events_the_order_is_lost() {
    let case = &REFERENCE["cases"]["elliptic_300"];
    let foot = foot::<Elliptic>(case);
    let start = numbers(&case["start"]);
    let off = |end: &[f64]| ((end[0] - start[0]) * foot.omega).hypot(end[1] - start[1]);
    let naive_error =
        |steps: usize| off(&naive::turn(&foot, &start, steps, |gap, f| gap > 0.0 && f > 0.0).0);
    // Where a step happens to end near an event the error is small by chance: the mean of many.
    let mean = |steps: usize| {
        let all = (0..40).map(|k| naive_error(steps + steps * k / 40).ln());
        (all.sum::<f64>() / 40.0).exp()
    };
    let naive_order = (mean(1000) / mean(16_000)).ln() / 16f64.ln();
    assert!((0.7..1.4).contains(&naive_order), "{naive_order}");
    let ours = |rtol: f64| {
        let settings = Settings::new(Method::Tsit5).rtol(rtol);
        let times = (0.0, foot.period());
        let motion = hybrid::march_in(&foot, FLIGHT, times, &start, &settings).unwrap();
        (motion.statistics.steps as f64, off(&motion.end))
    };
    let (coarse, fine) = (ours(1e-6), ours(1e-11));
    let order = (coarse.1 / fine.1).ln() / (fine.0 / coarse.0).ln();
    assert!(order > 4.0, "{order}: {coarse:?} {fine:?}");
    assert!(naive_error(16_000) > 1e3 * fine.1, "{} {fine:?}", naive_error(16_000));
}
