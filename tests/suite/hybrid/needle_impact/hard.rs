//! Section 7 of the specification, the naive way beside ours where there is one.

use super::*;

/// Near the speed that just crosses the gap the square under the root cancels; a product does not.
#[test]
fn a_gap_that_is_just_crossed() {
    let mut worst: f64 = 0.0;
    for one in closed("overruns").iter().take(15) {
        let values = ["m", "P_C", "Delta", "V_given"].map(|name| (name, number(&one[name])));
        let here = Formula::of("blow", &values, 2.0);
        // Four roundings.
        check("V_tau", here.get("V_tau"), number(&one["V_tau"]), 5e-16);
        check("tau", here.get("tau"), number(&one["tau"]), 5e-16);
        let naive = number(&one["naive_V"]) / number(&one["V_tau"]) - 1.0;
        worst = worst.max(naive.abs());
    }
    assert!(worst > 1e-3, "the square under the root keeps {worst:e}");
}

/// With little friction the smaller root of the time is a difference of two speeds that are nearly equal.
#[test]
fn friction_of_nothing() {
    let mut worst: f64 = 0.0;
    for one in closed("overruns").iter().skip(15) {
        let values = ["m", "P_C", "Delta", "V_given"].map(|name| (name, number(&one[name])));
        let here = Formula::of("blow", &values, 2.0);
        check("tau", here.get("tau"), number(&one["tau"]), 4e-16);
        check("V_tau", here.get("V_tau"), number(&one["V_tau"]), 4e-16);
        if let Some(naive) = one["naive"].as_f64() {
            worst = worst.max((naive / number(&one["tau"]) - 1.0).abs());
        }
        // The same motion by integration.
        let moved = Moved::of("selected", &[("P_C", number(&one["P_C"])), ("V_c", 2.0)], 1e-3);
        assert_eq!(moved.modes().first(), Some(&"impact"));
    }
    assert!(worst == 1.0, "the smaller root is lost: {worst:e}");
}

/// `sin(w t)/w` has no value at critical damping, and eq (12) no time beyond it.
#[test]
fn damping_up_to_the_critical_one_and_beyond() {
    let near = |share: f64| {
        let c: f64 = 1.0 / (1.0 / 2.04e6 + 1.0 / 5.74e4);
        [("V_given", 2.0), ("Delta", 0.0), ("h_p", (c / 0.6e-3).sqrt() * share)]
    };
    // The force is smooth there: its differences are as its slope.
    let force = |share: f64| Formula::blow("blow", &near(share));
    let slope = (force(1.1) - force(0.9)) / 0.2;
    for step in [1e-2, 1e-4, 1e-6, 1e-8] {
        let change = (force(1.0 + step) - force(1.0 - step)) / (2.0 * step);
        assert!((change / slope - 1.0).abs() < 0.02 + 1e-13 / step, "{step:e}: {change} {slope}");
    }
    assert!(Formula::blow("blow_paper", &near(0.99)).is_finite());
    assert!(Formula::blow("blow_paper", &near(1.01)).is_nan());
    // Half the critical damping is enough that the whole force is largest at the first touch.
    let whole = |share: f64| Formula::blow("blow_total", &near(share));
    for share in [0.5, 0.9, 1.0, 3.0] {
        let h = near(share)[2].1;
        check("force", whole(share), 2.0 * 0.6e-3 * h * 2.0, 1e-14);
    }
    // The run finds the same peaks.
    for share in [0.0, 0.3, 0.7, 1.0, 1.5] {
        let changes = [("V_c", 2.0), near(share)[2], ("Delta", 0.0)];
        let speed = 2.0 * 47.5_f64.to_radians().tan();
        let values = [("V_given", speed), near(share)[2], ("Delta", 0.0)];
        for (motion, formula) in [("selected", "blow"), ("total", "blow_total")] {
            let moved = Moved::of(motion, &changes, 1e-3);
            check(motion, moved.measure("F_cam_max"), Formula::blow(formula, &values), 1e-9);
        }
    }
}

/// A needle that does not give way lengthwise, and one that is a hundred thousand times as stiff.
#[test]
fn contact_that_is_much_shorter_than_the_flight() {
    let longitudinal = Formula::of("sliding", &[("c_l", 1e15)], 2.0);
    check("c_p", longitudinal.get("c_p"), 5.74e4, 1e-10);
    for factor in [1e3, 1e5] {
        let changes = [("c_b", 5.74e4 * factor), ("c_l", 2.04e6 * factor), ("V_c", 2.0)];
        let moved = Moved::of("selected", &changes, 1e-3);
        assert_eq!(moved.modes(), ["impact", "away"]);
        let here = Formula::of("sliding", &changes[..2], 2.0);
        check("F", moved.measure("F_cam_max"), here.get("F"), 1e-9);
        let contact = moved.event("away").time - moved.event("impact").time;
        let flight = moved.event("impact").time;
        assert!(contact < 20.0 * flight / factor.sqrt(), "{contact:e}");
        check("contact", moved.measure("contact"), contact, 1e-6);
        // Steps as long as those of the flight see nothing of it.
        let missed = (0..100).filter(|k| {
            let time = 1e-3 * f64::from(*k) / 100.0;
            moved.output("F_cam", time) > 0.0
        });
        assert!(factor < 1e4 || missed.count() == 0);
    }
}

/// The first rebound is a double root of the force: below it none is found, above it one however close.
#[test]
fn the_first_rebound() {
    let threshold = Formula::of("graze", &[], 47.5_f64.to_radians());
    let (speed, time) = (threshold.get("V_c"), threshold.get("t_leave"));
    let moved =
        |factor: f64| Moved::of("caught_up", &[("V_c", speed * factor), ("H_w", 4e-3)], 1e-3);
    let below = moved(1.0 - 1e-9);
    assert_eq!(below.modes(), ["stuck", "press"]);
    let begun = |moved: &Moved| moved.event("press").time;
    for above in [1e-3, 1e-5, 1e-7, 1e-9] {
        let moved = moved(1.0 + above);
        assert_eq!(moved.modes()[..3], ["stuck", "press", "free"], "{above:e}");
        let early = begun(&moved) + time - moved.event("free").time;
        assert!(early > 0.0 && early < 1e-3 * above.sqrt(), "{above:e}: {early:e}");
        // The first loss of contact jumps from never to the tangent point, and ends as soon as it began.
        let again = moved.motion.events[3].time - moved.event("free").time;
        assert!(again < 4e-3 * above.sqrt(), "{above:e}: {again:e}");
    }
    // The naive way compares signs at the ends of the steps of a run that knows no event: none ends below zero.
    let above = speed * (1.0 + 1e-7);
    let steps = below.motion.pieces.last().unwrap().trajectory.times();
    let force = |time: f64| {
        let (k, h, m) =
            (5.31e4 * 47.5_f64.to_radians().sin() * 47.5_f64.to_radians().cos(), 565.1, 0.6e-3);
        let v = above * 47.5_f64.to_radians().tan();
        let w = (k / m - h * h).sqrt();
        let a = -2.0 * m * h * v / k;
        4.8 + k * (-h * time).exp() * (a * (w * time).cos() + (v + h * a) / w * (w * time).sin())
    };
    let seen = steps.iter().filter(|at| force(**at - begun(&below)) < 0.0).count();
    assert_eq!(seen, 0);
    let least = (0..20_000).map(|k| force(1e-3 * f64::from(k) / 2e4)).fold(1.0, f64::min);
    assert!(least < 0.0, "and yet it is lost: {least:e}");
}

/// A wedge without an end: the needle loses it again and again, ever less, and stays on it in the end.
#[test]
fn contacts_that_repeat() {
    let changes = [("H_w", 0.2), ("P_C", 2.0), ("V_c", 2.5), ("h", 100.0)];
    for scene in ["caught_up", "unselected_full"] {
        let moved = Moved::of(scene, &changes, 0.06);
        let modes = moved.modes();
        let contacts = modes.iter().filter(|mode| **mode == "press").count();
        assert!((5..60).contains(&contacts), "{contacts}");
        assert_eq!(modes.last(), Some(&"press"));
        let free: Vec<f64> = moved
            .motion
            .events
            .windows(2)
            .filter(|pair| moved.mode(pair[0].to) == "free")
            .map(|pair| pair[1].time - pair[0].time)
            .collect();
        assert!(free.windows(2).all(|pair| pair[1] < pair[0]), "{free:?}");
        // It ends in the steady state, in which the wedge carries the friction; what swings about it began below that.
        let last = moved.motion.events.last().unwrap().time;
        let swing = 2.0 * 4.0 * (-100.0 * (0.06 - last)).exp();
        assert!((moved.output("F_wedge", 0.06) - 2.0).abs() < swing);
    }
}

/// The wedge ends while it presses: the bent butt is above the end by its compression, and the gap is wider by that.
#[test]
fn the_hidden_gap() {
    let k = 5.31e4 * 47.5_f64.to_radians().cos().powi(2);
    let hidden = 4.8 / k;
    let limit = |gap: f64| (2.0 * 8000.0 * gap).sqrt() / 47.5_f64.to_radians().tan();
    let strikes = |speed: f64| {
        let moved = Moved::of("selected_full", &[("V_c", speed)], 3e-3);
        check("left at", moved.event("overrun").before[0], 2e-3 - hidden, 1e-10);
        moved.modes().contains(&"impact")
    };
    let (naive, ours) = (limit(0.25e-3), limit(0.25e-3 + hidden));
    assert!(ours > 1.3 * naive);
    assert!(!strikes(naive * 1.2), "the plain gap says that it strikes");
    assert!(!strikes(ours * (1.0 - 1e-9)) && strikes(ours * (1.0 + 1e-9)));
}

/// The paper's constant force drives a needle that has rebounded upwards, faster and faster; friction stops it.
#[test]
fn friction_does_not_drive() {
    let changes = [("V_c", 3.0)];
    let constant = Moved::of("selected", &changes, 1e-3);
    let left = constant.event("away");
    let end = constant.output("dot(y)", 1e-3);
    check("gained", left.after[1] - end, 8000.0 * (1e-3 - left.time), 1e-9);
    let faster = Moved::of("rubbing", &[("V_c", 5.0)], 3e-3);
    let modes = faster.modes();
    assert_eq!(modes, ["impact", "back", "away", "rest"]);
    let away = faster.event("away");
    let rise = away.after[0] - faster.event("rest").after[0];
    check("rise", rise, away.after[1].powi(2) / (2.0 * 8000.0), 1e-9);
    assert_eq!(faster.output("dot(y)", 3e-3), 0.0);
}

/// Whether it stays pressed is decided by where it turns round.
#[test]
fn a_needle_that_stays_pressed() {
    let turning = |speed: f64| {
        let moved = Moved::of("rubbing", &[("V_c", speed)], 1e-3);
        let pressed = moved.modes()[1] == "pressed";
        assert_eq!(pressed, moved.measure("F_cam_max") <= 4.8, "{speed}");
        pressed
    };
    let mut ends = (1.9, 3.0);
    assert!(turning(ends.0) && !turning(ends.1));
    for _ in 0..40 {
        let middle = (ends.0 + ends.1) / 2.0;
        match turning(middle) {
            true => ends.0 = middle,
            false => ends.1 = middle,
        }
    }
    let force = Formula::of("sliding", &[], ends.0).get("F");
    check("force that friction holds", force, 4.8, 1e-9);
}

/// Little scatter of the limit and a steep line make a step of the integrand: weights at fixed places fall on one side.
#[test]
fn a_step_in_the_integrand() {
    for one in closed("chances") {
        let changes = changes(&one["values"]);
        let steep = changes.contains(&("s_ln", 0.001));
        if !steep {
            continue;
        }
        let (scene, expected) = (one["scene"].as_str().unwrap(), number(&one["P_cam"]));
        let moved = Moved::of(scene, &changes, 1.0);
        let found = moved.output("P_cam", 1.0);
        assert!((found - expected).abs() < 1e-9 * expected + 1e-13);
        // The trapezoidal rule at forty places.
        let fixed: f64 = (0..40)
            .map(|k| {
                let time = (f64::from(k) + 0.5) / 40.0;
                let (mode, state) = moved.motion.at(time);
                moved.run.rates_in(mode, time, &state)[0] / 40.0
            })
            .sum();
        assert!((fixed / expected - 1.0).abs() > 1e-3, "{changes:?}: {fixed:e} {expected:e}");
    }
}

/// Values that make no needle are refused.
#[test]
fn absurd_values_are_refused() {
    for (name, value) in [
        ("m", 0.0),
        ("m", -1.0),
        ("P_C", -1.0),
        ("Delta", -1e-3),
        ("c_b", 0.0),
        ("h", -1.0),
        ("V_c", 0.0),
        ("C", f64::NAN),
    ] {
        let refused =
            crate::solved::accepts(entry("needle_impact", "unselected"), &[(name, value)]);
        assert!(refused.is_err(), "{name} = {value}");
    }
}
