//! `assur synth` on points that go straight, or through others: the examples, as a user would run them.

use super::classics::{settled, sought, value};

/// Chebyshev's lambda mechanism: frame (4 + √7)/3 and coupler (3 + √7)/2 over the crank, with both assembly modes.
#[test]
fn the_straightest_crank_rocker_is_chebyshevs() {
    let found = sought("straight_line", &["--scene", "best", "--evaluations", "12000"]);
    let best = settled(&found, 0);
    let root = 7f64.sqrt();
    let [b, c, d, u] = [0, 1, 2, 3].map(|index| value(&best["values"], index) / 10.0);
    for (found, expected) in
        [(b, (3.0 + root) / 2.0), (c, b), (d, (4.0 + root) / 3.0), (u, 2.0 * b)]
    {
        assert!((found - expected).abs() < 1e-6, "{best}");
    }
    // Seven places, with alternating signs, hold six numbers.
    let places = best["polish"]["held"].as_array().expect("a list").len();
    assert!((7..=8).contains(&places), "{best}");
    let designs = found["designs"].as_array().expect("a list").iter().take(2);
    let modes: Vec<f64> = designs.map(|one| value(&one["values"], 6)).collect();
    assert!(modes.contains(&1.0) && modes.contains(&-1.0), "{modes:?}");
}

/// The joint of a coupler that begins at `a` and a rocker about `c`, of these lengths, on the left of the way from the one to the
/// other or on the right.
fn joint(a: [f64; 2], c: [f64; 2], [coupler, rocker]: [f64; 2], side: f64) -> [f64; 2] {
    let (x, y) = (c[0] - a[0], c[1] - a[1]);
    let square = x * x + y * y;
    let along = (square + coupler * coupler - rocker * rocker) / (2.0 * square);
    let across = side * (coupler * coupler / square - along * along).sqrt();
    [a[0] + along * x - across * y, a[1] + along * y + across * x]
}

/// Hoeken's ratios are those of Chebyshev's mechanism in small whole numbers.
#[test]
fn hoekens_linkage_is_nearly_chebyshevs() {
    let found = sought("straight_line", &["--scene", "hoeken", "--evaluations", "400"]);
    let path = |k: i32| {
        let phi = f64::from(k) / 20_000.0 * std::f64::consts::PI - std::f64::consts::FRAC_PI_2;
        let a = [-10.0 * phi.cos(), -10.0 * phi.sin()];
        let b = joint(a, [20.0, 0.0], [25.0, 25.0], 1.0);
        [2.0 * b[0] - a[0], 2.0 * b[1] - a[1]]
    };
    let all: Vec<[f64; 2]> = (0..=20_000).map(path).collect();
    let heights = all.iter().map(|one| one[1]);
    let (low, high) =
        heights.fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(y), high.max(y)));
    let travel: f64 = all.windows(2).map(|pair| (pair[1][0] - pair[0][0]).abs()).sum();
    let deviation = 0.5 * (high - low) / travel;
    let best = settled(&found, 0);
    assert!((value(&best["measures"], 0) - deviation).abs() < 1e-8, "{deviation} {best}");
    assert!(deviation > 2.7 * 0.000_446_25);
}

/// Four errors of equal size with alternating signs hold three numbers.
#[test]
fn watts_linkage() {
    let found = sought("watt", &["--scene", "best", "--evaluations", "2000"]);
    let best = settled(&found, 0);
    let [d, h, x0] = [0, 1, 2].map(|index| value(&best["values"], index));
    let error = |k: i32| {
        let phi = (f64::from(k) / 400.0 - 25.0).to_radians();
        let a = [100.0 * phi.cos(), 100.0 * phi.sin()];
        0.5 * (a[0] + joint(a, [d, h], [60.0, 100.0], -1.0)[0]) - x0
    };
    let errors: Vec<f64> = (0..=20_000).map(error).collect();
    let largest = errors.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    assert!((1e-3 * largest - value(&best["measures"], 0)).abs() < 1e-10, "{largest} {best}");
    let mut signs: Vec<f64> =
        errors.iter().filter(|one| one.abs() > 0.9999 * largest).copied().collect();
    signs.dedup_by(|a, b| *a * *b > 0.0);
    assert!(signs.len() >= 4, "{signs:?}");
}

/// The point of the coupler at a place where it has turned by some angle, of which each crank says something linear (the square of
/// the exponential less one falls out): by how much the exponential is off the circle.
fn off_circle(design: &[f64], [dx, dy]: [f64; 2]) -> f64 {
    let crank = |c: &[f64]| {
        let [ax, ay, x, y] = [c[0], c[1], c[2], c[3]];
        let (wx, wy) = (dx - ax, dy - ay);
        (
            x * wx + y * wy,
            x * wy - y * wx,
            (dx * dx + dy * dy) / 2.0 + dx * (x - ax) + dy * (y - ay),
        )
    };
    let ((r1, i1, s1), (r2, i2, s2)) = (crank(&design[..4]), crank(&design[4..8]));
    let both = r1 * i2 - r2 * i1;
    let (g, h) = ((i1 * s2 - i2 * s1) / both, (r2 * s1 - r1 * s2) / both);
    (g + 1.0).hypot(h) - 1.0
}

/// Of the 192 real four-bars some, each verified by equations in which the angles of the coupler do not stand. With the sum as one
/// number, inside an `abs`, it takes 74 480 looks.
#[test]
fn four_bars_through_nine_points() {
    const POINTS: [[f64; 2]; 9] = [
        [0.25, 0.0],
        [0.52, 0.10],
        [0.80, 0.70],
        [1.20, 1.00],
        [1.40, 1.30],
        [1.10, 1.48],
        [0.70, 1.40],
        [0.20, 1.00],
        [0.02, 0.40],
    ];
    let effort = ["--scene", "through", "--searches", "100", "--evaluations", "10000"];
    let found = sought("nine_points", &effort);
    let designs = found["designs"].as_array().expect("a list");
    let looks: f64 = designs.iter().filter_map(|one| one["polish"]["looks"].as_f64()).sum();
    assert!(looks < 40_000.0, "{looks} looks");
    let exact = designs.iter().filter(|one| one["worth"].as_f64().expect("a number") < 1e-20);
    let mut distinct: Vec<Vec<f64>> = Vec::new();
    for one in exact {
        let mut design: Vec<f64> = (0..8).map(|index| value(&one["values"], index)).collect();
        for [x, y] in &POINTS[1..] {
            let off = off_circle(&design, [x - POINTS[0][0], y - POINTS[0][1]]);
            assert!(off.abs() < 1e-9, "{off} {one}");
        }
        // Which of the cranks comes first makes no other mechanism.
        if design[0] > design[4] {
            design.rotate_left(4);
        }
        let is_like =
            |other: &&Vec<f64>| other.iter().zip(&design).all(|(a, b)| (a - b).abs() < 1e-6);
        if distinct.iter().find(is_like).is_none() {
            distinct.push(design);
        }
    }
    assert!(distinct.len() >= 6, "{distinct:?}");
}

/// As one number the sum takes 60 looks.
#[test]
fn a_path_with_its_timing() {
    let found = sought("timed_path", &["--scene", "timed", "--evaluations", "2000"]);
    let best = settled(&found, 6);
    assert!(best["polish"]["looks"].as_u64().is_some_and(|looks| looks < 40), "{best}");
    for (index, expected) in [2.0, 6.0, 5.0, 7.0, 3.0, 2.0].into_iter().enumerate() {
        assert!((value(&best["values"], index) - expected).abs() < 1e-9, "{best}");
    }
}

/// With a frame of one, a rocker `c` and its directions in the dead positions the crank is half the difference of the distances,
/// the coupler half the sum. Of those in which the cranks there differ by what is asked for, the best.
#[test]
fn a_crank_rocker_with_swing_and_time_ratio() {
    let found = sought("crank_rocker", &["--scene", "best", "--evaluations", "2000"]);
    let best = settled(&found, 1);
    let (swing, ahead) = (40f64.to_radians(), 15f64.to_radians());
    let dead =
        |psi: f64, c: f64| [psi, psi + swing].map(|psi| (1.0 + c * psi.cos(), c * psi.sin()));
    let miss = |psi: f64, c: f64| {
        let [(x, y), (u, v)] = dead(psi, c);
        (x * v - y * u).atan2(x * u + y * v) - ahead
    };
    let cosine = |psi: f64| {
        let (mut low, mut high) = (0.8, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let end = if miss(psi, middle) * miss(psi, low) > 0.0 { &mut low } else { &mut high };
            *end = middle;
        }
        let [one, two] = dead(psi, low).map(|(x, y)| x.hypot(y));
        let (a, b, c) = (0.5 * (one - two).abs(), 0.5 * (one + two), low);
        let of = |a: f64| ((b * b + c * c - (1.0 - a).powi(2)) / (2.0 * b * c)).abs();
        (of(a).max(of(-a)), a)
    };
    let psi = |k: i32| (205.0 + f64::from(k) / 1000.0).to_radians();
    let all = (0..=10_000).map(|k| cosine(psi(k)));
    let (least, crank) = all.fold((1.0, 0.0), |best, one| if one.0 < best.0 { one } else { best });
    assert!((value(&best["measures"], 0) - least).abs() < 1e-6, "{least} {best}");
    assert!((value(&best["values"], 0) - 100.0 * crank).abs() < 0.05, "{crank} {best}");
}
