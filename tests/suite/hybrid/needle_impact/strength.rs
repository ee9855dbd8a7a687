//! Stress, damage, probability of failure: by the equations' own integral, by another program's, and by drawing.

use super::*;

/// The probability of each case, over twelve powers of ten.
#[test]
fn probability_of_failure() {
    for one in closed("chances") {
        let changes = changes(&one["values"]);
        let moved = Moved::of(one["scene"].as_str().unwrap(), &changes, 1.0);
        for name in ["P_cam", "P_both"] {
            let (found, expected) = (moved.output(name, 1.0), number(&one[name]));
            // The solver bounds the error by the whole, which is one.
            let off = (found - expected).abs();
            let what = format!("{} {changes:?} {name}", one["scene"]);
            assert!(off < 1e-9 * expected + 1e-13, "{what}: {found:e}, expected {expected:e}");
            // Probability is one in all.
            assert!((0.0..=1.0 + 1e-12).contains(&found));
        }
    }
}

/// A generator of normal numbers.
struct Normal {
    state: u64,
}

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.state = self.state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    fn draw(&mut self) -> f64 {
        let (radius, angle) = (self.uniform(), self.uniform());
        (-2.0 * radius.ln()).sqrt() * (std::f64::consts::TAU * angle).cos()
    }
}

/// Needles made at random, each computed alone: as many break as the integral says.
#[test]
fn monte_carlo_agrees_with_the_integral() {
    use assur::closure::Assembly;
    use assur_equations::needle_impact::StruckFitted;
    let (speed, s_ln, t_life, samples) = (1.8, 0.2, 3.6e5, 40_000);
    let expected =
        Moved::of("chance_struck", &[("V_c", speed), ("s_ln", s_ln), ("t_life", t_life)], 1.0);
    let expected = expected.output("P_both", 1.0);
    let scene = entry("needle_impact", "struck_fitted");
    let used = place(scene.outputs, "used");
    let mut normal = Normal { state: 7 };
    let mut broken = 0;
    let nominal = StruckFitted::default();
    let mut outputs = vec![0.0; StruckFitted::shape().outputs.len()];
    for _ in 0..samples {
        // The probability is that of a line without a fatigue limit: the damage is scaled by hand, and the limit, which
        // the scene has, does not come in because its stress does not occur below.
        let gap = (nominal.Delta + 0.05e-3 / 3.0 * normal.draw()).max(0.0);
        let limit = (s_ln * normal.draw()).exp();
        let needle = StruckFitted {
            Delta: gap,
            // All stresses are above this limit; what the damage is at another one follows from the slope.
            s_R: nominal.s_R * 1e-3,
            ..nominal
        };
        let mut assembly = Assembly::<StruckFitted, f64>::new(&needle);
        assembly.start_at(&[speed], &[]).unwrap();
        assembly.outputs(&mut outputs);
        let damage = outputs[used] * t_life * (1e-3 / limit).powf(nominal.k);
        broken += u32::from(damage > 1.0);
    }
    let share = f64::from(broken) / f64::from(samples);
    let spread = (expected * (1.0 - expected) / f64::from(samples)).sqrt();
    assert!((0.05..0.95).contains(&expected), "{expected} decides nothing");
    assert!(
        (share - expected).abs() < 4.0 * spread,
        "{share}, expected {expected} within {spread}"
    );
}

/// The same by runs of whole motions, each of its own needle: the gap and the fatigue limit are drawn from what the file says.
#[test]
fn monte_carlo_of_runs_agrees_with_the_integral() {
    use assur::study::{drawn, runs};
    let (changes, count) = ([("V_c", 2.8)], 3000);
    let expected = Moved::of("chance", &changes, 1.0).output("P_cam", 1.0);
    let scene = entry("needle_impact", "made");
    let nominal = values(scene, &changes);
    let made = |index: usize| {
        let mut one = drawn(scene.constants, &nominal, 11, index);
        let gap = scene.constants.iter().position(|it| it.quantity.name == "Delta");
        one[gap.unwrap()] = one[gap.unwrap()].max(0.0);
        one
    };
    let settings = Settings { rtol: 1e-8, ..FINE };
    let found = runs(&scene.bind, count, &made, &settings, 0, &|_| {});
    let breaks = place(scene.measures, "breaks");
    let broken: f64 = found.into_iter().map(|one| one.unwrap()[breaks].unwrap()).sum();
    let share = broken / count as f64;
    let spread = (expected * (1.0 - expected) / count as f64).sqrt();
    assert!(
        (share - expected).abs() < 4.0 * spread,
        "{share}, expected {expected} within {spread}"
    );
}

/// What a run measures is what the closed forms say.
#[test]
fn measures_are_those_of_the_closed_forms() {
    for speed in [1.9, 2.5, 3.0] {
        for (motion, formula) in
            [("selected", "sliding"), ("total", "sliding_total"), ("plain", "sliding_plain")]
        {
            let moved = Moved::of(motion, &[("V_c", speed)], 1e-3);
            let here = Formula::of(formula, &[], speed);
            check(motion, moved.measure("F_cam_max"), here.get("F"), 1e-9);
            check(motion, moved.measure("stress_cam"), here.get("stress_cam"), 1e-9);
        }
    }
    for speed in [1.7, 2.0, 2.8] {
        let moved = Moved::of("unselected", &[("V_c", speed)], 3e-3);
        let here = Formula::of("struck", &[], speed);
        for (measure, output) in [("F_cam_max", "F"), ("F_wedge_max", "F_wedge")] {
            check(measure, moved.measure(measure), here.get(output), 1e-9);
        }
        check("V_0", moved.event("overrun").before[1], here.get("V_0"), 1e-9);
    }
}

/// The chain by hand: stress, mean stress, line, fatigue limit.
#[test]
fn the_chain_of_strength() {
    let here = Formula::of("struck", &[], 3.0);
    let (force, a, b, s) = (here.get("F"), 2.5e-3, 1.8e-3, 0.45e-3);
    let stress = 2.0 * 6.0 * force * a / (s * b * b) + force / (s * b);
    check("stress", here.get("stress_cam"), stress, 1e-14);
    let amplitude = stress / 2.0 / (1.0 - stress / 2.0 / 1500e6);
    let damage = 2.0 * (amplitude / 150e6).powi(8) / 1e7;
    check("damage", here.get("damage_cam"), damage, 1e-13);
    let turn = std::f64::consts::PI * 0.09525 / 3.0;
    let both = here.get("damage_wedge") + damage;
    check("used", here.get("used"), both / turn, 1e-13);
    // Below the limit nothing is damaged.
    let slow = Formula::of("sliding", &[], 1.9);
    assert!(slow.get("F") > 0.0 && slow.get("used") == 0.0);
    // Beyond the ultimate stress the butt breaks at once: the line is cut off where the share of the mean stress is all.
    let gone = Formula::of("struck", &[("s_u", 1e8)], 3.0);
    assert!(gone.get("damage_cam") > 1.0 && gone.get("damage_cam").is_finite());
}
