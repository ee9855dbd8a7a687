//! Loops, beside Newton's method from the last position.

use std::f64::consts::{PI, TAU};

use assur::prelude::*;

use crate::stability::{Row, told};

assur::mechanism! {
    /// Four links and four pins.
    FourBar from "any textbook";
    dimension a = 40 mm, b = 100 mm, c = 40 mm, d = 100 mm;
    driver phi ~ 60 deg in 0 deg .. 1440 deg;
    dependent theta ~ 0 deg, psi ~ 60 deg;
    closure loop: a*dir(phi) + b*dir(theta) = [d, 0] + c*dir(psi);
    output theta, psi;
    scene turn { sweep phi; }
}

/// The links of a four-bar, and what a step of Newton's method makes of two angles.
fn newton([a, b, c, d]: [f64; 4], phi: f64, [theta, psi]: [f64; 2]) -> ([f64; 2], f64) {
    let x = a * phi.cos() + b * theta.cos() - d - c * psi.cos();
    let y = a * phi.sin() + b * theta.sin() - c * psi.sin();
    let slopes = [[-b * theta.sin(), c * psi.sin()], [b * theta.cos(), -c * psi.cos()]];
    let det = slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0];
    let step =
        [(x * slopes[1][1] - y * slopes[0][1]) / det, (y * slopes[0][0] - x * slopes[1][0]) / det];
    ([theta - step[0], psi - step[1]], x.hypot(y))
}

/// The naive way: from the last position until the loop is closed to a length, at most 50 steps.
fn closed(links: [f64; 4], phi: f64, mut at: [f64; 2], to: f64) -> Option<([f64; 2], usize)> {
    for step in 0..50 {
        let (next, gap) = newton(links, phi, at);
        if gap < to {
            return Some((at, step));
        }
        at = next;
    }
    None
}

fn apart(a: f64, b: f64) -> f64 {
    ((a - b + PI).rem_euclid(TAU) - PI).abs()
}

/// The angle of the rocker where opposite links are of one length, parallel or crossed.
fn is_parallel(phi: f64, psi: f64) -> bool {
    apart(phi, psi) < 1e-6
}

/// Two turns in steps of 31 degrees.
const STEPS: usize = 24;
const FROM: f64 = PI / 3.0;
const STEP: f64 = 31.0 * PI / 180.0;

#[test]
fn a_parallelogram_stays_one_through_its_change_points() {
    let to = FROM + STEP * STEPS as f64;
    let path = Turn::default().sweep(FROM..=to, STEPS + 1).expect("it turns");
    let psi = path.output("psi").expect("an output");
    assert_eq!(psi.len(), STEPS + 1);
    let worst = psi.iter().map(|(phi, psi)| apart(*phi, *psi)).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst:e}");
    let (mut at, mut crossed, mut lost) = ([0.0, FROM], 0, 0);
    for step in 1..=STEPS {
        let phi = FROM + STEP * step as f64;
        match closed([0.04, 0.1, 0.04, 0.1], phi, at, 1e-12) {
            Some((found, _)) => at = found,
            None => lost += 1,
        }
        crossed += usize::from(!is_parallel(phi, at[1]));
    }
    assert!(crossed > 3, "{crossed} {lost}");
    told(&Row {
        case: "Flattened parallelogram",
        tried: "two turns of equal cranks in steps of 31°, through four change points",
        naive: format!(
            "Newton from the last position: crossed in {crossed} of {STEPS} positions, and nothing tells"
        ),
        ours: format!("parallel in all, within {worst:.0e} rad; the change points are reported"),
        cost: "the passage is found by its tangent, four times".to_owned(),
    });
}

#[test]
fn modes_near_a_change_point_are_not_exchanged() {
    // A rocker that is longer by a part in 1e9: the modes miss each other by 76 µrad.
    let c = 0.04 * (1.0 + 1e-9);
    let to = FROM + TAU;
    let path = Turn { c, ..Turn::default() }.sweep(FROM..=to, 25).expect("it turns");
    let psi = path.output("psi").expect("an output");
    let ours = psi.last().expect("a position").1;
    let theta = path.output("theta").expect("an output");
    let sides = theta.iter().map(|(phi, theta)| side([0.04, 0.1, c, 0.1], *phi, *theta));
    assert!(sides.sum::<f64>().abs() == 25.0);
    // The rocker does not turn: crossed for half of the turn, it is back after the whole.
    assert!(apart(ours, FROM) < 1e-6, "{ours}");
    let beyond = psi.iter().filter(|(phi, psi)| !is_parallel(*phi, *psi)).count();
    assert!(beyond > 5, "{beyond}");
    let mut at = [0.0, FROM];
    let mut naive = 0;
    for (phi, exact) in &psi[1..] {
        if let Some((found, _)) = closed([0.04, 0.1, c, 0.1], *phi, at, 1e-12) {
            at = found;
        }
        naive += usize::from(apart(at[1], *exact) > 1e-3);
    }
    assert!(naive > 0, "{naive}");
    told(&Row {
        case: "Near a change point",
        tried: "the same with a rocker longer by 1e-9 of it: the modes miss each other by 76 µrad",
        naive: format!("Newton from the last position: the other mode in {naive} of 24 positions"),
        ours: "the mode that continues, in all positions".to_owned(),
        cost: "steps shorten beside the singularity".to_owned(),
    });
}

/// The side of the pins' diagonal on which the coupler and the rocker meet: the assembly mode.
fn side([a, b, _, d]: [f64; 4], phi: f64, theta: f64) -> f64 {
    let diagonal = [d - a * phi.cos(), -a * phi.sin()];
    let coupler = [b * theta.cos(), b * theta.sin()];
    (diagonal[0] * coupler[1] - diagonal[1] * coupler[0]).signum()
}

#[test]
fn a_mode_is_kept_over_jumps_of_the_crank() {
    let links = [0.04, 0.1, 0.045, 0.1];
    let [a, b, c, d] = links;
    let scene = Turn { a, b, c, d };
    let (mut ours, mut other, mut lost) = (0, 0, 0);
    for degrees in (5..=360).step_by(5) {
        let to = FROM + f64::from(degrees).to_radians();
        let path = scene.sweep(FROM..=to, 2).expect("it turns");
        let [theta, psi] = ["theta", "psi"].map(|name| path.output(name).expect("an output"));
        let start = [theta[0].1, psi[0].1];
        let rough = [start[0] - 1.0, start[1] + 1.0];
        ours += usize::from(side(links, to, theta[1].1) == side(links, FROM, start[0]));
        match closed(links, to, rough, 1e-12) {
            Some((at, _)) => {
                other += usize::from(side(links, to, at[0]) != side(links, FROM, start[0]));
            }
            None => lost += 1,
        }
    }
    assert!(ours == 72 && other > 3, "{ours} {other} {lost}");
    told(&Row {
        case: "Switching of assembly mode",
        tried: "a crank-rocker in one jump of the crank, by 5° to 360°: 72 jumps",
        naive: format!(
            "Newton from angles that are off by 1 rad: closed, but in the other mode {other} times, not closed {lost}"
        ),
        ours: "the declared mode, all 72 times".to_owned(),
        cost: "the way is followed, in steps that the curvature permits".to_owned(),
    });
}

#[test]
fn what_cannot_be_reached_is_told_with_its_gap() {
    let b = 0.1 - 0.14e-12;
    let path = Turn { b, ..Turn::default() }.sweep(FROM..=1.5 * PI, 31).expect("it starts");
    let error = path.positions().end.clone().expect("it is too short").to_string();
    // The naive way takes what the cosine is clamped to.
    let cosine: f64 = (0.04f64.powi(2) + b * b - 0.14f64.powi(2)) / (2.0 * 0.04 * b);
    assert!(cosine < -1.0);
    let least = closed([0.04, b, 0.04, 0.1], PI, [0.0, PI - 1e-3], 1e-9);
    assert!(least.is_some(), "it says that it has converged");
    told(&Row {
        case: "Loops that just fail to close",
        tried: "the parallelogram with a coupler that is short by 0.14 pm, through 180°",
        naive:
            "Newton to 1 nm says that it has converged; a clamped `acos` goes on as if nothing were"
                .to_owned(),
        ours: format!("an error: {error}"),
        cost: "none".to_owned(),
    });
}

#[test]
fn very_small_links_close_to_their_own_rounding() {
    let links = [40e-9, 100e-9, 60e-9, 90e-9];
    let [a, b, c, d] = links;
    let path = Turn { a, b, c, d }.sweep(FROM..=FROM + 1.0, 5).expect("it moves");
    let psi = path.output("psi").expect("an output");
    let mut at = [path.output("theta").expect("an output")[0].1, psi[0].1];
    let (mut ours, mut naive) = (0.0, 0.0);
    for (phi, psi) in &psi[1..] {
        let rough = closed(links, *phi, at, 1e-9).expect("it converges");
        let exact = closed(links, *phi, rough.0, 1e-22).map_or(rough.0, |one| one.0);
        ours = f64::max(ours, apart(*psi, exact[1]));
        naive = f64::max(naive, apart(rough.0[1], exact[1]));
        at = rough.0;
    }
    assert!(ours < 1e-13 && naive > 1e-3, "{ours:e} {naive:e}");
    told(&Row {
        case: "Very small mechanisms",
        tried: "a four-bar of 40 to 100 nm, in metres",
        naive: format!(
            "Newton until the loop is closed to 1 nm: an angle is off by {naive:.0e} rad"
        ),
        ours: format!(
            "within {:.0e} rad of the exact: lengths count in the size of the links",
            ours.max(f64::EPSILON)
        ),
        cost: "none".to_owned(),
    });
}
