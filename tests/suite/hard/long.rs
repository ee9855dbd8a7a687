//! Motions over many periods without losses.

use crate::solved::{FINE, RPM, Solved, USUAL, entry};
use assur::ode::{Dop853, Method, Observer, Options, Plain, Step, Tsit5, Workspace, integrate};
use assur::problem::Scene;
use assur::registry::{self, Settings};

assur::mechanism! {
    /// A point mass on a massless rod, swinging widely.
    Pendulum from "any textbook";
    dimension l = 1 m;
    parameter m = 1 kg, g = 9.81 [m/s^2];
    coordinate phi: rad = 2;
    kinetic   m*(l*dot(phi))^2/2;
    potential m*g*l*(1 - cos(phi));
    scene swing "some swings" { run time 0 s .. 10 s; }
}

/// Distance of a motion from the repeating one after each of so many revolutions, over the motion's size.
fn distances(solved: &Solved, start: &[f64], revolutions: usize, settings: &Settings) -> Vec<f64> {
    let end = revolutions as f64 * solved.period;
    let motion = solved.run.march((0.0, end), start, settings).unwrap();
    let size = solved
        .orbit
        .start
        .iter()
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    let distance = |revolution: usize| {
        let here = motion.at(revolution as f64 * solved.period);
        let parts = here.iter().zip(&solved.orbit.start);
        parts.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
    };
    (1..=revolutions).map(distance).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[test]
fn marching_until_steady_never_converges_without_damping() {
    let solved = Solved::new("batten", "elastic");
    let rest = distances(&solved, &[0.0; 6], 200, &USUAL);
    assert!(largest(&rest[150..]) > 0.5 * largest(&rest[..50]));

    let ours = distances(&solved, &solved.orbit.start, 1, &FINE);
    assert!(ours[0] < 1e-10, "{:e}", ours[0]);
    let after = distances(&solved, &solved.orbit.start, 200, &USUAL);
    assert!(largest(&after) < 1e-6, "{:e}", largest(&after));
}

/// Keeps the largest change of the energy.
struct Drift<'a> {
    equations: &'a SwingEquations<f64>,
    begin: f64,
    largest: f64,
}

impl Observer<[f64; 2]> for Drift<'_> {
    fn step(&mut self, step: &Step<'_, [f64; 2]>) {
        let (kinetic, potential) = self.equations.energy(step.to, step.after);
        let change = (kinetic + potential) / self.begin - 1.0;
        self.largest = self.largest.max(change.abs());
    }
}

/// Largest relative change of the energy over so many periods, of which one lasts 2.67 s.
fn drift<M: Method>(periods: f64, rtol: f64) -> f64 {
    let swing = Swing::default();
    let equations = swing.prepare::<f64>();
    let start: [f64; 2] = swing.start().try_into().unwrap();
    let (kinetic, potential) = equations.energy(0.0, &start);
    let mut drift = Drift {
        equations: &equations,
        begin: kinetic + potential,
        largest: 0.0,
    };
    let system = Plain(&equations);
    let options = Options {
        max_steps: usize::MAX,
        ..Options::scaled(rtol, Swing::shape().scales)
    };
    let mut workspace = Workspace::<_, M>::new::<f64, _>(&system);
    let times = (0.0, 2.67 * periods);
    integrate(&system, times, &start, &options, &mut workspace, &mut drift).unwrap();
    drift.largest
}

#[test]
fn a_pendulum_keeps_its_energy_over_ten_thousand_periods() {
    let naive = drift::<Tsit5>(1e4, 1e-4);
    let ours = drift::<Dop853>(1e4, 1e-10);
    assert!(naive > 0.1, "{naive:e}");
    assert!(ours < 1e-6, "{ours:e}");
}

#[test]
fn near_a_multiplier_of_minus_one_nothing_grows() {
    let speed = [("n", 300.0 * RPM)];
    let growth = |solved: &Solved| {
        let moduli = solved.orbit.multipliers.iter().map(|it| it.modulus() - 1.0);
        moduli.fold(f64::NEG_INFINITY, f64::max)
    };
    let solved = Solved::of(entry("batten", "elastic"), &speed, &USUAL).unwrap();
    let nearest = solved
        .orbit
        .multipliers
        .iter()
        .map(|it| (it.re + 1.0).hypot(it.im));
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    assert!(nearest < 0.01, "{nearest:e}");
    assert!(growth(&solved).abs() < 1e-6, "{:e}", growth(&solved));

    // Marched crudely from rest, the free motion seems to grow.
    let late = |settings: &Settings| {
        let distances = distances(&solved, &[0.0; 6], 200, settings);
        largest(&distances[150..]) / largest(&distances[..50])
    };
    let crude = Settings::new(registry::Method::Tsit5, 1e-3);
    assert!(late(&crude) > 1.5, "{}", late(&crude));
    assert!(late(&USUAL) < 1.0, "{}", late(&USUAL));
}
