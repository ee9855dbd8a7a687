//! The rack of the feed mechanism by its mean and first harmonics, as the paper describes its new mechanism.

use super::*;

/// Five points and weights of Gauss's quadrature on -1 .. 1.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// Level of the fabric at an angle of the shaft.
fn level<C: Foot>(foot: &C, phi: f64) -> f64 {
    let time = (phi + PI) * foot.period() / (2.0 * PI);
    output(foot, "s", CONTACT, time, &foot.start())
}

/// Where the rack passes the plate, between an angle at which it is above and one at which it is not.
fn crossing(machine: &Machine, above: f64, below: f64) -> f64 {
    let (mut above, mut below) = (above, below);
    for _ in 0..60 {
        let middle = (above + below) / 2.0;
        match level(machine, middle) > 0.0 {
            true => above = middle,
            false => below = middle,
        }
    }
    above
}

/// The integral over a turn of the level with a weight: from crossing to crossing, where it is smooth.
fn integral(machine: &Machine, (from, to): (f64, f64), weight: impl Fn(f64) -> f64) -> f64 {
    let parts = 60;
    let half = (to - from) / f64::from(2 * parts);
    let middles = (0..parts).map(|part| from + half * f64::from(2 * part + 1));
    let points = middles.flat_map(|middle| GAUSS.map(|(x, c)| (middle + half * x, half * c)));
    points.map(|(phi, c)| c * level(machine, phi) * weight(phi)).sum()
}

/// The harmonics that the file gives are those of the mechanism: by quadrature of what its closures say, and of what a
/// second computation says.
#[test]
fn the_harmonics_are_those_of_the_mechanism() {
    let (machine, given) = (Machine::default(), MachineHarmonics::default());
    let above = (crossing(&machine, 0.0, -2.0), crossing(&machine, 0.0, 2.0));
    let crossings = numbers(&REFERENCE["rack"]["crossings"]);
    assert!((above.0 - crossings[0]).abs() < 1e-12 && (above.1 - crossings[1]).abs() < 1e-12);
    let cosines = [given.a_0, given.a_1, given.a_2, given.a_3, given.a_4, given.a_5];
    let sines = [0.0, given.b_1, given.b_2, given.b_3, given.b_4, given.b_5];
    for k in 0..=5 {
        let (place, turns) = (k as usize, f64::from(k));
        let share = if k == 0 { 2.0 * PI } else { PI };
        let cosine = integral(&machine, above, |phi| (turns * phi).cos()) / share;
        let sine = integral(&machine, above, |phi| (turns * phi).sin()) / share;
        for (found, given, second) in [
            (cosine, cosines[place], &REFERENCE["rack"]["cosines"][place]),
            (sine, sines[place], &REFERENCE["rack"]["sines"][place]),
        ] {
            // In parts of the rise, 1 mm.
            assert!((found - given).abs() < 1e-12, "{k}: {found:e} {given:e}");
            assert!((found - number(second)).abs() < 1e-15, "{k}: {found:e}");
        }
    }
}

/// Every harmonic brings the level nearer to that of the rack in the mean of the squares, by half its own square.
#[test]
fn each_harmonic_brings_the_series_nearer() {
    let machine = Machine::default();
    let count = 20_000;
    let angles = || (0..count).map(|k| PI * (f64::from(2 * k + 1) / f64::from(count) - 1.0));
    let all = MachineHarmonics::default();
    let pairs = [
        (all.a_1, all.b_1),
        (all.a_2, all.b_2),
        (all.a_3, all.b_3),
        (all.a_4, all.b_4),
        (all.a_5, all.b_5),
    ];
    let off = |order: i32| {
        let series = MachineHarmonics::with(&[("order", f64::from(order))]);
        let squares = angles().map(|phi| (level(&machine, phi) - level(&series, phi)).powi(2));
        squares.sum::<f64>() / f64::from(count)
    };
    for order in 1..=5 {
        let (a, b) = pairs[order as usize - 1];
        let gained = off(order - 1) - off(order);
        let expected = (a * a + b * b) / 2.0;
        assert!(gained > 0.0 && (gained / expected - 1.0).abs() < 1e-3, "{order}");
    }
}

/// The series dips below the plate while the rack returns, and the foot follows: the force is what spring and weight ask for,
/// whatever the level, as long as all is slow.
#[test]
fn the_series_dips_below_the_plate() {
    fn check<C: Foot>() {
        let foot = C::with(&[("omega", 1.0)]);
        let angles = (0..=600).map(|k| PI * (f64::from(k) / 300.0 - 1.0));
        let lowest = angles.map(|phi| level(&foot, phi)).fold(0.0, f64::min);
        assert!((-6e-5..-2e-5).contains(&lowest), "{lowest:e} m");
        let found = foot.cycle().unwrap();
        assert!(changes(&found.motion).is_empty());
        let plain = Elliptic::default();
        for k in 0..100 {
            let time = foot.period() * f64::from(k) / 100.0;
            let pressed = force(&foot, &found.motion, time);
            let w = found.motion.at(time).1[0];
            let asked = plain.F10 + plain.c1 * w + plain.m * plain.g;
            assert!((pressed / asked - 1.0).abs() < 1e-3, "{pressed} {asked}");
        }
    }
    check::<FiveHarmonics>();
    check::<MachineHarmonics>();
}

/// Without any harmonic the fabric lies at the mean level, and the foot rests on it.
#[test]
fn the_mean_alone_is_rest() {
    fn check<C: Foot>(mean: f64) {
        let foot = C::with(&[("order", 0.0)]);
        assert!((level(&foot, 1.0) / mean - 1.0).abs() < 1e-12);
        let found = foot.cycle().unwrap();
        let as_elliptic = Elliptic::default();
        let load = as_elliptic.F10 + as_elliptic.m * as_elliptic.g;
        let expected = (as_elliptic.c2 * mean - load) / (as_elliptic.c1 + as_elliptic.c2);
        assert!((found.motion.end[0] / expected - 1.0).abs() < 1e-11);
    }
    check::<MachineHarmonics>(MachineHarmonics::default().a_0);
    // The mean of the ellipse above the plate.
    let foot = FiveHarmonics::default();
    let half = foot.phi_p / 2.0;
    check::<FiveHarmonics>(
        foot.rise * (half.sin() - half.cos() * half) / (PI * (1.0 - half.cos())),
    );
}
