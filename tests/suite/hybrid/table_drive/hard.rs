//! Section 9 of the specification, the naive way beside ours where there is one.

use super::*;
use assur::hybrid::HybridError;

/// Without resistance and clearance the guard is zero at the start, and signs at the ends of a step show no change.
#[test]
fn without_resistance_the_table_starts_at_once() {
    for drive in [Table1::with(&[("Mc", 0.0)]), Table1::with(&[("Mc", 0.0), ("beta", 0.0)])] {
        let moved = Moved::of(drive, 0.1);
        assert_eq!(moved.modes(), ["run"]);
        assert!(moved.event("run").time < 1e-9, "{}", moved.event("run").time);
        let ends = moved.motion.pieces[0].trajectory.times();
        let signs = [0.0, moved.motion.pieces.last().unwrap().trajectory.times()[1]]
            .map(|time| moved.output("elastic_torque", time) - moved.drive.Mc);
        assert!(signs[0] * signs[1] == 0.0, "no change of sign: {signs:?} {ends:?}");
    }
    let moved = Moved::of(Switched::with(&[("Mc", 0.0)]), 0.1);
    assert_eq!(moved.modes(), ["run"]);
    assert!(moved.event("run").time < 1e-6, "{}", moved.event("run").time);
    let moved = Moved::of(Loose::with(&[("Mc", 0.0)]), 0.1);
    assert_eq!(moved.modes(), ["run"], "from the contact on");
}

/// A clearance of nothing is no clearance.
#[test]
fn a_clearance_of_nothing_is_none() {
    let loose = Moved::of(Loose::with(&[("g", 0.0)]), 0.1);
    let tight = Moved::of(Table1::default(), 0.1);
    assert_eq!(loose.modes(), ["wind", "run"]);
    assert!(loose.event("wind").time < 1e-9);
    assert!((loose.event("run").time - tight.event("run").time).abs() < 1e-12);
    for time in [1e-3, 0.01, 0.1] {
        let off = loose.output("phi2", time) - tight.output("phi2", time);
        assert!(off.abs() < 1e-9, "{off:e}");
    }
}

/// Eq (2) as it is written loses what it says at the start, where its terms cancel up to the second power of the time.
#[test]
fn the_transient_torque_keeps_its_digits() {
    let written = |drive: &Blocked, time: f64| {
        let Blocked { omega, Mst, lambda1, lambda2, cos_ph, .. } = *drive;
        let ph = cos_ph.acos();
        let wave = (-lambda2 * time).exp() * (omega * time - ph).cos()
            + (-lambda1 * time).exp() * (omega * time + ph).cos();
        Mst * (1.0 + (-(lambda1 + lambda2) * time).exp() - wave / ph.cos())
    };
    let moved = Moved::of(Blocked::default(), 1e-3);
    for one in REFERENCE["starting"].as_array().unwrap() {
        let (time, expected) = (number(&one["time"]), number(&one["torque"]));
        let found = moved.output_of("motor_torque", time, 0, &[0.0; 4]);
        assert!((found / expected - 1.0).abs() < 2e-14, "at {time} s: {found:e} {expected:e}");
        let naive = (written(&moved.drive, time) / expected - 1.0).abs();
        assert!(time > 2e-6 || naive > 1e-10, "at {time} s: {naive:e}");
        assert!(time > 2e-9 || naive > 1e-3, "at {time} s: {naive:e}");
    }
}

/// The largest torque of the link while the table is at rest, and when.
fn winding_peak() -> (f64, f64) {
    let Table1 { J1, c, beta, Ms, omega, .. } = Table1::with(&[("beta", 0.01)]);
    let d = (beta + Ms / omega) / (2.0 * J1);
    let q = (c / J1 - d * d).sqrt();
    let time = std::f64::consts::PI / q;
    (Ms * (1.0 + (-d * time).exp()), time)
}

/// Above every peak there is no event, below it there is one however close: the ends of the steps show none.
#[test]
fn a_resistance_that_is_just_reached() {
    let (peak, time) = winding_peak();
    let drive = |factor: f64| Table1::with(&[("beta", 0.01), ("Mc", peak * factor)]);
    let above = Moved::of(drive(1.0 + 1e-12), 0.1);
    assert_eq!((above.modes(), above.motion.mode), (vec![], 0));
    for below in [1e-4, 1e-6, 1e-8, 1e-10] {
        let moved = Moved::of(drive(1.0 - below), 0.1);
        let early = time - moved.motion.events[0].time;
        assert!(moved.modes().starts_with(&["run"]), "{below}: {:?}", moved.modes());
        assert!(early > 0.0 && early < 2e-3 * below.sqrt(), "{below}: {early:e}");
        let steps = above.motion.pieces[0].trajectory.times().iter();
        let seen =
            steps.filter(|time| above.output("elastic_torque", **time) >= peak * (1.0 - below));
        assert!(below > 1e-7 || seen.count() == 0, "a step ends on the peak");
    }
    // Equal to a rounding: either way, and no error.
    let equal = Moved::of(drive(1.0), 0.1);
    assert!(equal.motion.events.len() < 4, "{:?}", equal.modes());
}

/// Beside resonance 4.2 is a difference of two numbers of 1e12, at it it is none.
#[test]
fn resonance_is_a_motion_like_others() {
    let omega = 1024.0;
    let drive = |omega: f64| {
        Blocked::with(&[
            ("J1", 2.0_f64.powi(-11)),
            ("c", 512.0),
            ("beta", 0.0),
            ("lambda1", 0.0),
            ("lambda2", 0.0),
            ("omega", omega),
        ])
    };
    let written = |omega: f64, time: f64| {
        let (k, r) = (1024.0, omega / 1024.0);
        20.0 * (1.0 - ((omega * time).cos() - r * r * (k * time).cos()) / (1.0 - r * r))
    };
    let (at, beside) = (Moved::of(drive(omega), 0.1), Moved::of(drive(omega * (1.0 + 1e-12)), 0.1));
    let mut naive: f64 = 0.0;
    for time in at.times() {
        let expected =
            20.0 * (1.0 - (omega * time).cos() - omega * time / 2.0 * (omega * time).sin());
        for moved in [&at, &beside] {
            let off = (moved.output("elastic_torque", time) - expected).abs();
            assert!(off < 1e-7, "at {time} s: {off:e}");
        }
        naive = naive.max((written(omega * (1.0 + 1e-12), time) - expected).abs());
    }
    assert!(naive > 1e-4, "{naive:e}");
    assert!(written(omega, 0.05).is_nan());
}

/// A motor that is weaker than the resistance: eq (13), in which the resistance is a constant, drives the table backwards
/// for ever. It stops, and sticks where the link carries all the torque of the motor.
#[test]
fn a_table_that_is_too_heavy_stops() {
    for resistance in [17.3, 18.0, 20.0] {
        let moved = Moved::of(Table1::with(&[("beta", 0.01), ("Mc", resistance)]), 0.5);
        let Table1 { Mc, Ms, omega, c, .. } = moved.drive;
        let by_the_book = omega * (1.0 - Mc / Ms);
        assert!(by_the_book < 0.0);
        assert_eq!(moved.modes().last(), Some(&"stick"));
        assert!(moved.times().into_iter().all(|time| moved.output("dot(phi2)", time) >= -1e-12));
        assert_eq!(moved.output("dot(phi2)", 0.5), 0.0);
        assert!((moved.output("twist", 0.5) - Ms / c).abs() < 1e-9);
    }
}

/// The link swings about the resistance, which the table follows with stops and starts: each is found, none twice.
#[test]
fn sticking_and_slipping_come_to_an_end() {
    for (damping, resistance, inertia) in
        [(1e-3, 16.5, 5e-5), (1e-3, 17.1, 5e-4), (0.0, 17.2, 5e-5), (1e-3, 17.25, 2e-3)]
    {
        let moved =
            Moved::of(Table1::with(&[("beta", damping), ("Mc", resistance), ("J2", inertia)]), 0.3);
        let events = &moved.motion.events;
        assert!((3..400).contains(&events.len()), "{}", events.len());
        // The last swings, of a rounding each, may take no time.
        assert!(events.windows(2).all(|pair| pair[1].time >= pair[0].time));
        for (event, to) in events.iter().zip(moved.modes()) {
            match to {
                "stick" => assert!(event.guard.abs() < 1e-11 && event.after[3] == 0.0),
                _ => assert!(event.guard.abs() < 1e-11),
            }
        }
        let pieces = moved.motion.pieces.iter();
        for piece in pieces.filter(|piece| Table1::shape().modes[piece.mode].name == "stick") {
            let (from, to) = Motion::ends(piece);
            let angles = [from, (from + to) / 2.0, to].map(|time| piece.trajectory.at(time)[1]);
            assert!(angles[0] == angles[1] && angles[1] == angles[2], "{angles:?}");
        }
    }
}

/// Flanks do not pull: after the rebound of the table a link without clearance would.
#[test]
fn clearance_opens_again_and_does_not_pull() {
    let changes = [("beta", 0.05), ("J2", 5e-5), ("g", 0.02)];
    let moved = Moved::of(Loose::with(&changes), 0.05);
    let Loose { c, beta, g, .. } = moved.drive;
    let mut pull: f64 = 0.0;
    for time in moved.times() {
        let get = |name: &str| moved.output(name, time);
        assert!(get("link_torque") >= -1e-9);
        assert!(get("twist") >= -1e-12, "the other flank is not reached");
        let (mode, _) = moved.motion.at(time);
        if Loose::shape().modes[mode].name == "coast" {
            pull = pull.min(c * (get("twist") - g) + beta * get("dot(twist)"));
        }
    }
    assert!(pull < -1.0, "{pull}");
}

/// Where the event is that stiffness and damping together carry the resistance, or without damping, the table starts with
/// no acceleration at all; a guard on its speed has neither value nor rate there.
#[test]
fn a_start_without_acceleration_is_no_stop() {
    let mut seed: u64 = 1;
    let mut random = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low * (high / low).powf((seed >> 11) as f64 / (1_u64 << 53) as f64)
    };
    for _ in 0..300 {
        let values = [
            ("J1", random(1e-4, 1e-2)),
            ("J2", random(1e-4, 1e-2)),
            ("c", random(50.0, 5e3)),
            ("beta", random(1e-3, 1.0)),
            ("Mc", random(1e-3, 10.0)),
        ];
        let settings = Settings::new(Method::Dop853).rtol(1e-10);
        let full = Moved::at(Full::with(&values), 3e-3, &settings);
        let first: Vec<_> = full.modes().into_iter().take(2).collect();
        assert!(
            first.len() < 2
                || first[1] != "stick"
                || full.motion.events[1].time > full.motion.events[0].time * 1.001,
            "{values:?} {first:?}"
        );
        let undamped = Table1::with(&[values.as_slice(), &[("beta", 0.0)]].concat());
        let undamped = Moved::at(undamped, 3e-3, &settings);
        let first: Vec<_> = undamped.motion.events.iter().map(|event| event.time).take(2).collect();
        assert!(first.len() < 2 || first[1] > first[0] * 1.001, "{values:?} {first:?}");
    }
}

/// A table of a millionth of the motor's inertia: an explicit method pays for a rate of 2e6 1/s that nobody sees.
#[test]
fn a_light_table_is_stiff() {
    let evaluations = |inertia: f64| {
        let settings = Settings::new(Method::Dop853).rtol(1e-6);
        Moved::at(Table1::with(&[("J2", inertia)]), 0.02, &settings).motion.statistics.evaluations
    };
    let (usual, light) = (evaluations(5e-4), evaluations(5e-9));
    assert!(usual < 3000 && light > 1_000_000, "{usual} {light}");
    // Ten times as many steps are not begun.
    let drive = Table1::with(&[("J2", 5e-10)]);
    let explicit = Settings::new(Method::Dop853).rtol(1e-6);
    let refused = march(&drive, (0.0, 0.02), &drive.start(), &explicit).map(|_| "it came out");
    let refused = refused.expect_err("it is stiff").to_string();
    assert!(refused.contains("the equations are stiff"), "{refused}");
    let slow = Moved::at(Table1::with(&[("J2", 5e-10)]), 0.02, &FINE_AND_STIFF);
    for method in [Method::Radau, Method::Rosenbrock, Method::Auto] {
        let settings = Settings::new(method).rtol(1e-6);
        let ours = Moved::at(Table1::with(&[("J2", 5e-10)]), 0.02, &settings);
        let work = ours.motion.statistics.evaluations;
        assert!(work < 3000, "{method:?} {work}");
        for time in [1e-3, 5e-3, 0.02] {
            let pair = [&ours, &slow].map(|one| one.output("dot(phi2)", time));
            assert!((pair[0] / pair[1] - 1.0).abs() < 1e-4, "{method:?} {pair:?}");
        }
    }
}

/// Without damping a light table starts with no speed and no acceleration, and the continuous solutions of stiff methods
/// begin with other rates than the motion: at first they let it run backwards, by far less than the tolerance. Taken for a
/// stop, that held the table for ever, for the torque was above the resistance already and did not get there again.
#[test]
fn a_light_table_without_damping_is_not_stopped_by_an_error() {
    const END: f64 = 2e-3;
    let stiff = [Method::Radau, Method::Rosenbrock, Method::Auto];
    for inertia in [5e-6, 5e-7, 5e-8, 5e-10] {
        for method in stiff {
            for rtol in [1e-5, 1e-6, 1e-7] {
                let drive = Table1::with(&[("beta", 0.0), ("J2", inertia)]);
                let moved = Moved::at(drive, END, &Settings::new(method).rtol(rtol));
                let what = format!("{method:?} {rtol:e} {inertia:e}");
                assert_eq!(moved.modes(), ["run"], "{what}");
                // The motor feels the vibration by its own torque alone, so that both together speed up like one body.
                let together = |time: f64| {
                    let speed = |name: &str| moved.output(name, time);
                    let (own, other) = (moved.drive.J1, inertia);
                    (own * speed("dot(phi1)") + other * speed("dot(phi2)")) / (own + other)
                };
                let rate = moved.drive.Ms / moved.drive.omega / (moved.drive.J1 + inertia);
                let end = moved.drive.omega * (1.0 - moved.drive.Mc / moved.drive.Ms);
                let begun = moved.event("run").time;
                let expected = end - (end - together(begun)) * (-rate * (END - begun)).exp();
                let mean = together(END);
                assert!((mean / expected - 1.0).abs() < 1e-4, "{what}: {mean} {expected}");
            }
        }
    }
}

/// Where the table has run up nothing changes but by the rounding of its accelerations, which is a hundredth of the
/// tolerance. An iteration that shall get below that never ends.
#[test]
fn a_table_that_has_run_up_runs_on() {
    for rtol in [1e-8, 1e-9, 1e-10] {
        for method in [Method::Radau, Method::Rosenbrock] {
            let drive = Table1::with(&[("J1", 9.09e-6)]);
            let end = drive.omega * (1.0 - drive.Mc / drive.Ms);
            let moved = Moved::at(drive, 0.2, &Settings::new(method).rtol(rtol));
            let speed = moved.output("dot(phi2)", 0.2);
            assert!((speed / end - 1.0).abs() < 1e-9, "{method:?} {rtol:e}: {speed} {end}");
            let steps = moved.motion.statistics.steps + moved.motion.statistics.rejected;
            assert!(steps < 6000, "{method:?} {rtol:e}: {steps}");
        }
    }
}

/// As accurately as a stiff method does without many steps.
const FINE_AND_STIFF: Settings = Settings::new(Method::Rosenbrock).rtol(1e-10);

/// Values that make no machine are refused, or are the error of the run that says where.
#[test]
fn absurd_values_are_refused() {
    for (name, value) in [
        ("J1", 0.0),
        ("J1", -1.0),
        ("J2", 0.0),
        ("c", -1.0),
        ("c", 0.0),
        ("beta", -1.0),
        ("Mc", -0.1),
        ("omega", 0.0),
        ("Ms", f64::NAN),
    ] {
        let refused = Table1::with(&[(name, value)]).check();
        assert!(refused.is_err(), "{name} = {value}");
    }
    let drive = Table1::with(&[("Ms", f64::NAN)]);
    let ended = march(&drive, (0.0, 0.1), &drive.start(), &FINE);
    let is_error = matches!(ended, Err(HybridError::Ode { .. } | HybridError::Guard { .. }));
    assert!(is_error, "{ended:?}");
}
