//! Motions with all their events, against another program in another language that steps from event to event.

use super::*;

/// Times to 1e-12 s, positions to 1e-14 m, speeds to 1e-9 m/s, peaks to 1e-9 N.
#[track_caller]
fn agrees(name: &str) -> Moved {
    let case = &REFERENCE["stepped"][name];
    let moved =
        Moved::of(case["scene"].as_str().unwrap(), &changes(&case["values"]), number(&case["end"]));
    let expected = case["events"].as_array().unwrap();
    let modes: Vec<&str> = expected.iter().map(|one| one["to"].as_str().unwrap()).collect();
    assert_eq!(moved.modes(), modes, "{name}");
    for (event, one) in moved.motion.events.iter().zip(expected) {
        let off = (event.time - number(&one["time"])).abs();
        assert!(off < 1e-12, "{name}, to {}: off by {off:e} s", one["to"]);
        let off = (event.after[1] - number(&one["speed"])).abs();
        assert!(off < 1e-9, "{name}, to {}: off by {off:e} m/s", one["to"]);
    }
    for one in case["samples"].as_array().unwrap() {
        let time = number(&one["time"]);
        let off = (moved.output("y", time) - number(&one["y"])).abs();
        assert!(off < 1e-14, "{name} at {time} s: off by {off:e} m");
        let off = (moved.output("dot(y)", time) - number(&one["speed"])).abs();
        assert!(off < 1e-9, "{name} at {time} s: off by {off:e} m/s");
    }
    for (measure, key) in [("F_wedge_max", "F_wedge"), ("F_cam_max", "F_cam")] {
        let off = (moved.measure(measure) - number(&case[key])).abs();
        assert!(off < 1e-9, "{name}, {measure}: off by {off:e} N");
    }
    moved
}

#[test]
fn needles_that_slide() {
    for name in ["selected", "selected_slow", "plain", "total"] {
        agrees(name);
    }
}

/// Friction stops the needle before the cam, on it, and behind it.
#[test]
fn friction_that_opposes_the_motion() {
    for (name, last) in [
        ("rubbing_slow", "rest"),
        ("rubbing", "pressed"),
        ("rubbing_pressed", "pressed"),
        ("rubbing_fast", "pressed"),
    ] {
        assert_eq!(agrees(name).modes().last(), Some(&last), "{name}");
    }
}

#[test]
fn needles_that_are_struck() {
    for name in
        ["unselected_slow", "unselected", "unselected_hard", "unselected_free", "unselected_total"]
    {
        agrees(name);
    }
}

/// The wedge follows, catches up, and ends.
#[test]
fn a_wedge_that_ends() {
    for name in ["caught_up", "caught_up_often", "caught_up_early"] {
        agrees(name);
    }
}

#[test]
fn all_effects() {
    for name in [
        "selected_full",
        "selected_full_fast",
        "unselected_full",
        "unselected_full_fast",
        "unselected_full_light",
        "unselected_full_short",
        "unselected_full_long",
        "unselected_full_ended",
    ] {
        agrees(name);
    }
}

/// The limiting cam is struck before the wedge arrives, which meets the needle on its way back.
#[test]
fn a_needle_that_is_ahead_of_the_wedge() {
    assert!(agrees("unselected_full_ahead").modes().contains(&"turn"));
}
