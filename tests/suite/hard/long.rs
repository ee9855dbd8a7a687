//! Motions over many periods without losses.

use crate::solved::{FINE, RPM, Solved, USUAL, entry};
use crate::stability::{Row, told};
use assur::answer::{Method, Settings};
use assur::model::{Bound, Flow};
use assur::ode::{Explicit, Observer, Options, Step, Workspace, integrate};
use assur::problem::{Phase, Reports, Scene};

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
    let size = solved.orbit.start.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
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
    reports: &'a dyn Reports<f64>,
    begin: f64,
    largest: f64,
}

impl Observer for Drift<'_> {
    fn step(&mut self, step: &Step<'_>) {
        let energy = self.reports.energy(Phase::of(0), step.to, step.after);
        let (kinetic, potential) = energy.unwrap();
        let change = (kinetic + potential) / self.begin - 1.0;
        self.largest = self.largest.max(change.abs());
    }
}

/// Largest relative change of the energy over so many periods, of which one lasts 2.67 s.
fn drift(method: Explicit, periods: f64, rtol: f64) -> f64 {
    let swing = Swing::default();
    let equations = swing.prepare::<f64>();
    let start = swing.start();
    let (kinetic, potential) = equations.energy(Phase::of(0), 0.0, &start).unwrap();
    let mut drift = Drift { reports: &equations, begin: kinetic + potential, largest: 0.0 };
    let model = Bound::new(&swing);
    let flow = Flow::new(&model, 0);
    let options = Options { max_steps: usize::MAX, ..Options::scaled(rtol, Swing::shape().scales) };
    let mut workspace = Workspace::new(method, &flow);
    let times = (0.0, 2.67 * periods);
    integrate(&flow, times, &start, &options, &mut workspace, &mut drift).unwrap();
    drift.largest
}

#[test]
fn a_pendulum_keeps_its_energy_over_a_hundred_thousand_periods() {
    let naive = drift(Explicit::Tsit5, 1e4, 1e-4);
    let ours = drift(Explicit::Dop853, 1e5, 1e-13);
    assert!(naive > 0.1, "{naive:e}");
    assert!(ours < 1e-8, "{ours:e}");
    told(&Row {
        case: "Undamped motion",
        tried: "a pendulum that swings widely, 1e5 periods",
        naive: format!(
            "Tsit5 at rtol 1e-4 changes the energy by {:.0} % in the first tenth",
            100.0 * naive
        ),
        ours: format!("DOP853 at rtol 1e-13: by {ours:.0e}"),
        cost: "as many steps as the tolerance asks for".to_owned(),
    });
}

#[test]
fn near_a_multiplier_of_minus_one_nothing_grows() {
    let speed = [("n", 300.0 * RPM)];
    let growth = |solved: &Solved| {
        let moduli = solved.orbit.multipliers.iter().map(|it| it.modulus() - 1.0);
        moduli.fold(f64::NEG_INFINITY, f64::max)
    };
    let solved = Solved::of(entry("batten", "elastic"), &speed, &USUAL).unwrap();
    let nearest = solved.orbit.multipliers.iter().map(|it| (it.re + 1.0).hypot(it.im));
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    assert!(nearest < 0.01, "{nearest:e}");
    assert!(growth(&solved).abs() < 1e-6, "{:e}", growth(&solved));

    // Marched crudely from rest, the free motion seems to grow.
    let late = |settings: &Settings| {
        let distances = distances(&solved, &[0.0; 6], 200, settings);
        largest(&distances[150..]) / largest(&distances[..50])
    };
    let crude = Settings::new(Method::Tsit5).rtol(1e-3);
    assert!(late(&crude) > 1.5, "{}", late(&crude));
    assert!(late(&USUAL) < 1.0, "{}", late(&USUAL));
    told(&Row {
        case: "Multipliers at -1",
        tried: "the batten at 300 rpm, its nearest multiplier beside -1",
        naive: format!(
            "marched from rest by Tsit5 at rtol 1e-3, what is free seems to grow: {:.1} times in 200 turns",
            late(&crude)
        ),
        ours: format!(
            "multipliers {nearest:.4} from -1, moduli 1 to {:.0e}: nothing grows",
            growth(&solved).abs()
        ),
        cost: "the variations beside the motion: 2 times the plain run".to_owned(),
    });
}
