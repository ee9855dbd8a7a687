//! Effects that can be switched, against what they come to where they vanish.

use super::*;

/// A foot that is hinged on the bar by an ever stiffer joint is one body with it; what is left goes with the compliance.
#[test]
fn a_stiff_joint_makes_one_body() {
    let omega = 200.0;
    let single = Elliptic::with(&[("omega", omega)]);
    let expected = Measured::of(&single, &single.cycle().unwrap().motion).smallest;
    let off = [1e7, 1e8].map(|c_j: f64| {
        let foot = Hinged {
            omega,
            c_j,
            // Three tenths of the critical damping.
            mu_j: 0.6 * (0.03 * c_j).sqrt(),
            ..Hinged::default()
        };
        let found = hybrid::cycle(&foot, 2.0 * PI / omega, &FINE).unwrap();
        (Measured::of(&foot, &found.motion).smallest - expected).abs()
    });
    assert!(off[0] < 0.5 && off[1] < off[0] / 2.5, "{off:?}");
}

/// Without damping the law of the fabric is that with a damper of nothing.
#[test]
fn no_damping_is_a_damper_of_nothing() {
    let (elastic, damper) = (Undamped::default(), Elliptic::with(&[("mu2", 0.0)]));
    let [one, other] = [
        hybrid::march(&elastic, (0.0, 0.2), &elastic.start(), &FINE).unwrap(),
        hybrid::march(&damper, (0.0, 0.2), &damper.start(), &FINE).unwrap(),
    ];
    assert!(changes(&one).len() > 10);
    assert_eq!(changes(&one).len(), changes(&other).len());
    for (a, b) in changes(&one).iter().zip(changes(&other)) {
        assert!((a.0 - b.0).abs() < 1e-9 && a.1 == b.1, "{a:?} {b:?}");
    }
}

/// What is left of the compression relaxes by itself, from what it is where the foot leaves; and the foot comes back where it
/// meets it, later than on a fabric that recovers at once.
#[test]
fn a_fabric_that_recovers_slowly() {
    let foot = Recovering::default();
    let found = hybrid::cycle(&foot, 2.0 * PI / foot.omega, &FINE).unwrap();
    let events = &found.motion.events;
    let contacts: Vec<_> = events.iter().filter(|one| one.from != one.to).collect();
    let level = |time: f64| output(&foot, "s", CONTACT, time, &foot.start());
    let mut met = 0;
    for pair in contacts.windows(2).filter(|pair| pair[0].to == FLIGHT) {
        let (lost, regained) = (pair[0], pair[1]);
        let begin = level(lost.time) - lost.before[0];
        assert!((lost.after[2] - begin).abs() < 1e-15, "{:?}", lost.after);
        let passed = regained.time - lost.time;
        let left = begin * (-foot.c2 / foot.mu2 * passed).exp();
        assert!((regained.before[2] - left).abs() < 1e-12, "{left:e}");
        let compressed = level(regained.time) - regained.before[0];
        assert!((compressed - left).abs() < 1e-12, "{compressed:e} {left:e}");
        met += 1;
    }
    assert!(met > 0, "{contacts:?}");
    let at_once = Elliptic::default();
    let longer = Measured::of(&foot, &found.motion).free;
    let shorter = Measured::of(&at_once, &at_once.cycle().unwrap().motion).free;
    assert!(longer > shorter, "{longer} {shorter}");
}

/// Nothing rubs and nothing is hit: then it is the plain foot. Friction in the guide takes from the flights.
#[test]
fn friction_in_the_guide() {
    let at = |rub: f64| {
        let foot = Guided { F_c: rub, w_stop: 1.0, ..Guided::default() };
        let found = hybrid::cycle(&foot, 2.0 * PI / foot.omega, &FINE).unwrap();
        Measured::of(&foot, &found.motion)
    };
    let plain = Elliptic::default();
    let plain = Measured::of(&plain, &plain.cycle().unwrap().motion);
    let (without, with) = (at(0.0), at(3.0));
    assert!((without.free - plain.free).abs() < 1e-10 && (without.mean - plain.mean).abs() < 1e-8);
    assert!(with.free < plain.free, "{with:?} {plain:?}");
}

/// The stop throws the bar back with the part `e_stop` of its speed, and the bar never gets beyond it.
#[test]
fn a_stop_above() {
    let foot = Guided { F_c: 0.0, w_stop: 1.1e-3, omega: 400.0, ..Guided::default() };
    let motion = hybrid::march(&foot, (0.0, 0.5), &foot.start(), &FINE).unwrap();
    let hits: Vec<_> =
        motion.events.iter().filter(|one| (one.before[1] - one.after[1]).abs() > 1e-9).collect();
    assert!(hits.len() > 5, "{}", hits.len());
    for hit in hits {
        assert!((hit.before[0] - foot.w_stop).abs() < 1e-15);
        assert!((hit.after[1] + foot.e_stop * hit.before[1]).abs() < 1e-15);
    }
    for piece in &motion.pieces {
        for time in piece.trajectory.times() {
            let height = piece.trajectory.at(*time)[0];
            assert!(height < foot.w_stop + 1e-12, "{height:e} m at {time} s");
        }
    }
}

/// A speed that does not change is a speed.
#[test]
fn a_ramp_of_nothing_is_none() {
    let ramp = RunUp { alpha: 0.0, ..RunUp::default() };
    let steady = Elliptic::default();
    let end = 10.0 * steady.period();
    let [one, other] = [
        hybrid::march(&ramp, (0.0, end), &ramp.start(), &FINE).unwrap(),
        hybrid::march(&steady, (0.0, end), &steady.start(), &FINE).unwrap(),
    ];
    assert_eq!(changes(&one).len(), changes(&other).len());
    for (a, b) in changes(&one).iter().zip(changes(&other)) {
        assert!((a.0 - b.0).abs() < 1e-11 && a.1 == b.1, "{a:?} {b:?}");
    }
}

/// In a slow run-up contact is lost near the speed at which steady motion loses it, and not before.
#[test]
fn a_run_up_leaves_the_fabric_where_steady_motion_does() {
    let border = number(&REFERENCE["linear"]["elliptic"]["borders"][0]["omega"]);
    let foot = RunUp { omega: 215.0, alpha: 4.0, ..RunUp::default() };
    let motion = hybrid::march(&foot, (0.0, 4.0), &foot.start(), &FINE).unwrap();
    let first = changes(&motion).into_iter().find(|one| one.0 > 0.2).unwrap();
    let speed = foot.omega + foot.alpha * first.0;
    // A turn takes 28 ms, in which the speed rises by 0.1 1/s.
    assert!((speed - border).abs() < 0.3, "{speed} {border}");
}

#[test]
fn a_preload_that_follows_the_speed() {
    let tracked = Tracked { omega: 400.0, ..Tracked::default() };
    let preload = tracked.F10 + tracked.F_rise * (tracked.omega - tracked.omega_0);
    let fixed = Elliptic::with(&[("omega", 400.0), ("F10", preload)]);
    let [one, other] =
        [hybrid::cycle(&tracked, fixed.period(), &FINE).unwrap(), fixed.cycle().unwrap()];
    assert_eq!(one.multiple, other.multiple);
    let [a, b] = [Measured::of(&tracked, &one.motion), Measured::of(&fixed, &other.motion)];
    assert!((a.mean - b.mean).abs() < 1e-8 && (a.free - b.free).abs() < 1e-9, "{a:?} {b:?}");
}
