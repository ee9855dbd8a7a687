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

/// A speed that does not change is a speed.
#[test]
fn a_ramp_of_nothing_is_none() {
    let ramp = RunUp {
        alpha: 0.0,
        ..RunUp::default()
    };
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
    let foot = RunUp {
        omega: 215.0,
        alpha: 4.0,
        ..RunUp::default()
    };
    let motion = hybrid::march(&foot, (0.0, 4.0), &foot.start(), &FINE).unwrap();
    let first = changes(&motion)
        .into_iter()
        .find(|one| one.0 > 0.2)
        .unwrap();
    let speed = foot.omega + foot.alpha * first.0;
    // A turn takes 28 ms, in which the speed rises by 0.1 1/s.
    assert!((speed - border).abs() < 0.3, "{speed} {border}");
}

#[test]
fn a_preload_that_follows_the_speed() {
    let tracked = Tracked {
        omega: 400.0,
        ..Tracked::default()
    };
    let preload = tracked.F10 + tracked.F_rise * (tracked.omega - tracked.omega_0);
    let fixed = Elliptic::with(&[("omega", 400.0), ("F10", preload)]);
    let [one, other] = [
        hybrid::cycle(&tracked, fixed.period(), &FINE).unwrap(),
        fixed.cycle().unwrap(),
    ];
    assert_eq!(one.multiple, other.multiple);
    let [a, b] = [
        Measured::of(&tracked, &one.motion),
        Measured::of(&fixed, &other.motion),
    ];
    assert!(
        (a.mean - b.mean).abs() < 1e-8 && (a.free - b.free).abs() < 1e-9,
        "{a:?} {b:?}"
    );
}
