//! Linkages that have mass: two ways to write one mechanism, forces against work, periodic motions that turn, pins that
//! lift off.

use crate::stability::{Row, told};
use assur::answer::{Error, Motion};
use assur::model::{Bound, Flow, Model};
use assur::ode::{Explicit, Options, Workspace, integrate};
use assur::prelude::*;
use std::f64::consts::PI;

/// A slider-crank with few coordinates.
mod chain {
    assur::mechanism! {
        SliderCrank from "made up";
        parameter r = 40 mm, l = 140 mm, J = 2e-3 [kg m^2], m_c = 1 kg, m_r = 0.45 kg, J_r = 1.5e-3 [kg m^2], m_p = 0.35 kg, g = 9.81 [m/s^2];
        coordinate a1: rad = 0, rate = 30 [rad/s];
        dependent a2 ~ 0 rad, x3 ~ 180 mm;
        let C1 = r/2*dir(a1);
        let C2 = r*dir(a1) + l/2*dir(a2);
        closure piston_pin: r*dir(a1) + l*dir(a2) = [x3, 0];
        kinetic m_c*inner(dot(C1), dot(C1))/2 + J*dot(a1)^2/2;
        kinetic m_r*inner(dot(C2), dot(C2))/2 + J_r*dot(a2)^2/2;
        kinetic m_p*dot(x3)^2/2;
        potential g*(m_c*C1.y + m_r*C2.y);
        let weight = [0, g];
        output a1, w = dot(a1), a2, x3, pin = reaction(piston_pin) [N],
            bearing = m_c*(ddot(C1) + weight) + m_r*(ddot(C2) + weight) - reaction(piston_pin) [N],
            E = energy(kinetic) + energy(potential);
        scene run { run time 0 s .. 1 s; }
    }
}

/// The same as bodies with pins.
mod bodies {
    assur::mechanism! {
        Bodies from "made up";
        parameter r = 40 mm, l = 140 mm, J = 2e-3 [kg m^2], m_c = 1 kg, m_r = 0.45 kg, J_r = 1.5e-3 [kg m^2], m_p = 0.35 kg, g = 9.81 [m/s^2];
        coordinate x1: m = 20 mm, y1: m = 0, a1: rad = 0, rate = 30 [rad/s];
        coordinate x2: m = 110 mm, y2: m = 0, a2: rad = 0;
        coordinate x3: m = 180 mm;
        let C1 = [x1, y1];
        let C2 = [x2, y2];
        closure bearing: C1 - r/2*dir(a1) = [0, 0];
        closure crank_pin: C1 + r/2*dir(a1) = C2 - l/2*dir(a2);
        closure piston_pin: C2 + l/2*dir(a2) = [x3, 0];
        kinetic m_c*inner(dot(C1), dot(C1))/2 + J*dot(a1)^2/2;
        kinetic m_r*inner(dot(C2), dot(C2))/2 + J_r*dot(a2)^2/2;
        kinetic m_p*dot(x3)^2/2;
        potential g*(m_c*y1 + m_r*y2);
        output a1, w = dot(a1), a2, x3, pin = reaction(piston_pin) [N], held = reaction(bearing) [N],
            E = energy(kinetic) + energy(potential);
        scene run { run time 0 s .. 1 s; }
    }
}

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-12);

#[test]
fn bodies_with_pins_move_as_the_chain_does() {
    let one = chain::Run::default().solve(&FINE).expect("a motion");
    let other = bodies::Run::default().solve(&FINE).expect("a motion");
    let pairs = [
        ("a1", "a1"),
        ("w", "w"),
        ("a2", "a2"),
        ("x3", "x3"),
        ("pin.x", "pin.x"),
        ("pin.y", "pin.y"),
        ("bearing.x", "held.x"),
        ("bearing.y", "held.y"),
        ("E", "E"),
    ];
    for step in 0..=50 {
        let time = f64::from(step) / 50.0;
        for (name, same) in pairs {
            let (a, b) = (one.value(name, time).unwrap(), other.value(same, time).unwrap());
            assert!((a - b).abs() < 1e-8 * (1.0 + a.abs()), "{name} at {time}: {a} {b}");
        }
    }
}

/// A thousand turns lose no more energy than the tolerance says: the loops close exactly at every place. The naive way,
/// constraints differentiated twice, drifts.
#[test]
fn loops_do_not_drift_and_constraints_differentiated_twice_do() {
    let motion = bodies::Run::default().ask().until(200.0).run().expect("a motion");
    let energy = |time: f64| motion.value("E", time).unwrap();
    let lost = (energy(200.0) - energy(0.0)).abs() / energy(0.0);
    assert!(motion.value("a1", 200.0).unwrap() > 850.0 * std::f64::consts::TAU, "it turns");
    assert!(lost < 1e-6, "{lost:e}");
    let value = |name: &str| motion.value(name, 200.0).unwrap();
    let open = 0.04 * value("a1").cos() + 0.14 * value("a2").cos() - value("x3");
    assert!(open.abs() < 1e-15, "{open:e}");

    let naive = naive::Run::default().run().expect("a motion");
    let gap = |time: f64| naive.value("gap", time).unwrap().abs();
    assert!(gap(0.0) < 1e-15 && gap(60.0) > 1e-8, "{:e} {:e}", gap(0.0), gap(60.0));
    told(&Row {
        case: "Drift of constraints",
        tried: "a slider-crank with masses for 200 s, and a pendulum by a constraint differentiated twice for 60 s",
        naive: format!("the rope is off by {:.0e} of its length, and grows", gap(60.0)),
        ours: format!(
            "the loop is open by less than {:.0e} m, energy kept to {lost:.0e}",
            open.abs().max(1e-16)
        ),
        cost: "1.05 times: dependent positions are corrected once a step".to_owned(),
    });
    // Nor does it feel that it starts a millimetre off.
    let off = naive::Run::default().from([1.001, 0.0, 0.0, 0.0, 0.0]).run().expect("a motion");
    let gap = |time: f64| off.value("gap", time).unwrap();
    assert!((gap(0.0) - 2.001e-3).abs() < 1e-12 && gap(5.0) > 1.9e-3, "{:e}", gap(5.0));
}

/// A pendulum whose rope is a constraint differentiated twice, its force the rate of a state.
mod naive {
    assur::mechanism! {
        Naive from "made up";
        parameter m = 1 kg, r = 1 m, g = 9.81 [m/s^2];
        coordinate x: m = 1 m, y: m = 0;
        state p: [N s/m] = 0;
        let rope = x^2 + y^2 - r^2;
        kinetic m*inner(dot([x, y]), dot([x, y]))/2;
        potential m*g*y;
        force -dot(p) on rope/(2 m)*(1 m);
        motion length: ddot(rope) = 0 [m^2/s^2];
        output x, y, gap = rope/(1 [m^2]);
        scene run { run time 0 s .. 60 s; }
    }
}

/// A crank-rocker that turns evenly, its masses and springs.
mod driven {
    assur::mechanism! {
        CrankRocker from "made up";
        dimension a = 50 mm, b = 150 mm, c = 120 mm, d = 160 mm;
        parameter n = 20 [rad/s], m = 0.8 kg, I = 2.5e-3 [kg m^2], J = 3e-3 [kg m^2], k = 3 [N m], dc = 0.02 [N m s], g = 9.81 [m/s^2];
        driver phi = n*time ~ 90 deg in 0 deg .. 360 deg;
        dependent theta ~ 25 deg, psi ~ 70 deg;
        point A = a*dir(phi), C = A + b/2*dir(theta);
        closure joint: A + b*dir(theta) = [d, 0] + c*dir(psi);
        kinetic m*inner(dot(C), dot(C))/2 + I*dot(theta)^2/2 + J*dot(psi)^2/2;
        potential m*g*C.y + k*(psi - 70 deg)^2/2;
        dissipation dc*dot(psi)^2/2;
        output M = effort(phi), T = energy(kinetic), V = energy(potential), lost = energy(dissipation), pin = reaction(joint);
        scene turn { sweep phi; }
    }
}

/// The work of the drive over an angle is what the energies grow by and what is lost; the effort is its slope.
#[test]
fn the_effort_of_a_driver_is_what_energies_and_losses_ask_for() {
    let path = driven::Turn::default().sweep(0.0..=std::f64::consts::TAU, 721).expect("it turns");
    let column = |name: &str| -> Vec<f64> {
        let pairs = path.output(name).expect("an output");
        pairs.into_iter().map(|pair| pair.1).collect()
    };
    let (torque, kinetic, potential, lost) =
        (column("M"), column("T"), column("V"), column("lost"));
    let step = std::f64::consts::TAU / 720.0;
    for place in 2..719 {
        let slope = |list: &[f64]| {
            let far = list[place + 2] - list[place - 2];
            (8.0 * (list[place + 1] - list[place - 1]) - far) / (12.0 * step)
        };
        let expected = slope(&kinetic) + slope(&potential) + lost[place] / 20.0;
        let off = (torque[place] - expected).abs();
        assert!(off < 1e-6 * (1.0 + expected.abs()), "{place}: {} {expected}", torque[place]);
    }
}

/// A damper on the driver alone, without any mass.
mod damped {
    assur::mechanism! {
        Damped from "made up";
        dimension r = 40 mm, l = 140 mm;
        parameter n = 20 [rad/s], d = 0.3 [N m s], b = 5 [N s/m];
        driver phi = n*time ~ 90 deg in 0 deg .. 360 deg;
        dependent psi ~ -15 deg, x ~ 135 mm;
        closure pin: r*dir(phi) + l*dir(psi) = [x, 0];
        dissipation d*dot(phi)^2/2 + b*dot(x)^2/2;
        output M = effort(phi), v = dot(x), lost = energy(dissipation);
        scene turn { sweep phi; }
    }
}

#[test]
fn a_damper_on_a_driver_takes_effort() {
    let path = damped::Turn::default().sweep(0.0..=std::f64::consts::TAU, 13).expect("it turns");
    let column = |name: &str| path.output(name).expect("an output");
    let pairs = column("M").into_iter().zip(column("v")).zip(column("lost"));
    for (((phi, torque), (_, speed)), (_, lost)) in pairs {
        let expected = 0.3 * 20.0 + 5.0 * speed * speed / 20.0;
        assert!((torque - expected).abs() < 1e-12 * expected, "{phi}: {torque} {expected}");
        assert!((lost - 20.0 * expected).abs() < 1e-12 * lost, "{phi}: {lost}");
    }
}

/// A rotor with an unbalanced load under a motor: the motion repeats though its angle does not come back.
mod rotor {
    assur::mechanism! {
        Rotor from "made up";
        parameter J = 0.02 [kg m^2], m = 0.5 kg, r = 60 mm, g = 9.81 [m/s^2], k = 0.05 [N m s], w = 30 [rad/s];
        coordinate phi: rad = 0, rate = w;
        dependent x ~ 60 mm, y ~ 0 mm;
        closure arm: r*dir(phi) = [x, y];
        kinetic J*dot(phi)^2/2 + m*(dot(x)^2 + dot(y)^2)/2;
        potential m*g*y;
        force k*(w - dot(phi)) on phi;
        output phi, speed = dot(phi), y;
        measure slowest = lowest(dot(phi)), fastest = peak(dot(phi));
        scene steady { periodic; }
        scene run { run time 0 s .. 60 s; }
    }
}

#[test]
fn a_rotor_repeats_after_a_turn() {
    let cycle = rotor::Steady::default().run().expect("it repeats");
    let period = cycle.length().expect("a period");
    assert_eq!(cycle.multiple(), 1);
    // The loss of the motor's characteristic alone damps: the multiplier follows from the divergence of the equations.
    let inertia = 0.02 + 0.5 * 0.06 * 0.06;
    let expected = (-0.05 * period / inertia).exp();
    let found = cycle.multipliers()[0].re;
    assert!((found - expected).abs() < 1e-7, "{found} {expected}");
    let (slow, fast) = (cycle.measure("slowest").unwrap(), cycle.measure("fastest").unwrap());
    assert!(slow < 30.0 && fast > slow, "{slow} {fast}");
    let run = rotor::Run::default().solve(&FINE).expect("a motion");
    let turns = run.value("phi", 60.0).unwrap() - run.value("phi", 59.0).unwrap();
    assert!((turns / std::f64::consts::TAU * period - 1.0).abs() < 0.05, "{turns}");
}

/// The error of a period adds up: after thousands of them a motion is known only as well as they are together.
#[test]
fn periods_that_pass_add_up_their_errors() {
    let steady = rotor::Steady::default();
    let exact = steady.solve(&FINE).expect("it repeats");
    let found = steady.solve(&Settings::new(Method::Dop853).rtol(1e-7)).expect("it repeats");
    let estimate = found.estimate().expect("other solutions");
    let subjects = [found.subject("phi").expect("an output")];
    let time = 5000.4 * exact.length().expect("a period");
    let first = time.rem_euclid(found.length().expect("a period"));
    let phi = |motion: &assur::answer::Motion| motion.value("phi", time).expect("a value");
    let error = (phi(&found) - phi(&exact)).abs();
    let [naive, told] = [first, time].map(|time| estimate.at(&found, &subjects, time)[0]);
    assert!(error > 100.0 * naive, "{error} {naive}");
    assert!(told > 0.2 * error && told < 50.0 * error, "{error} {told}");
}

/// A bead on a turning arm that a pin carries: where the force of the pin passes zero the event is found.
mod lifting {
    assur::mechanism! {
        Lifting from "made up";
        parameter m = 1 kg, r = 0.5 m, g = 9.81 [m/s^2], J = 1e9 [kg m^2], w = 3 [rad/s];
        coordinate phi: rad = -90 deg, rate = w;
        dependent y ~ -0.5 m;
        closure rest: y = r*sin(phi);
        kinetic J*dot(phi)^2/2 + m*dot(y)^2/2;
        potential m*g*y;
        output y, push = reaction(rest) [N];
        measure off = value(phi, before(lifts)), lowest_push = lowest(reaction(rest));
        when lifts: reaction(rest) falls { set dot(phi) = dot(phi)/2; }
        scene fast { run time 0 s .. 3 s; start dot(phi) = 6 [rad/s]; }
        scene slow { run time 0 s .. 3 s; }
    }
}

/// With a flywheel `y'' = -r w² sin(phi)`, so that the push is `m (g - r w² sin(phi))`.
#[test]
fn a_pin_lifts_off_where_its_force_passes_zero() {
    let slow = lifting::Slow::default().run().expect("a motion");
    assert_eq!(slow.events().len(), 0);
    let least = slow.measure("lowest_push").unwrap();
    assert!((least - (9.81 - 0.5 * 9.0)).abs() < 1e-5, "{least}");
    let fast = lifting::Fast::default().run().expect("a motion");
    let off = fast.measure("off").unwrap();
    let expected = (9.81_f64 / (0.5 * 36.0)).asin();
    assert!((off - expected).abs() < 1e-6, "{off} {expected}");
    // A pin that hardly lifts off: whoever looks eight times a second does not see it.
    let short = lifting::Fast::default().from([-0.5 * PI, -0.5, 4.44, 0.0]);
    let motion = short.run().expect("a motion");
    assert!(!motion.events().is_empty());
    let expected = (9.81_f64 / (0.5 * 4.44 * 4.44)).asin();
    let off = motion.measure("off").unwrap();
    assert!((off - expected).abs() < 1e-5, "{off} {expected}");
    let push = |time: f64| 9.81 - 0.5 * 4.44 * 4.44 * (4.44 * time - 0.5 * PI).sin();
    let seen = (0..8).map(|look| push(f64::from(look) / 8.0)).fold(f64::INFINITY, f64::min);
    assert!(seen > 0.0, "{seen}");
}

/// A hundred thousand turns: the loops close to rounding at the end, and the energy is off by no more than the steps may
/// err, 1e-13 each.
#[test]
fn a_hundred_thousand_turns_do_not_drift() {
    let scene = chain::Run::default();
    let bound = Bound::new(&scene);
    let flow = Flow::new(&bound, 0);
    let options = Options::scaled(1e-13, chain::Run::shape().scales);
    let mut workspace = Workspace::new(Explicit::Dop853, &flow);
    let (start, end) = (scene.start(), 100_000.0 * 0.231_93);
    let options = Options { max_steps: 100_000_000, ..options };
    let done = integrate(&flow, (0.0, end), &start, &options, &mut workspace, &mut ());
    let steps = done.expect("it goes on").steps;
    let state = workspace.state();
    assert!(state[0] > 99_000.0 * std::f64::consts::TAU, "{}", state[0]);
    let equations = scene.prepare::<f64>();
    let energy = |at: &[f64]| {
        let (kinetic, potential) = equations.energy(Phase::of(0), 0.0, at).expect("energies");
        kinetic + potential
    };
    let drift = (energy(state) / energy(&start) - 1.0).abs();
    assert!(drift < 1e-13 * steps as f64, "{drift:e} in {steps} steps");
    let mut outputs = [0.0; 9];
    equations.outputs(Phase::of(0), end, state, &mut outputs);
    let open = 0.04 * state[0].cos() + 0.14 * outputs[2].cos() - outputs[3];
    assert!(open.abs() < 1e-15, "{open:e}");
}

/// Both ways to write the mechanism agree where masses are fifteen orders of magnitude apart, or none.
#[test]
fn masses_may_be_far_apart() {
    for (m_r, m_p) in [(1e-9, 1e6), (1e6, 1e-9), (1e-9, 1e-9), (0.0, 0.35)] {
        let j_r = if m_r == 0.0 { 0.0 } else { 1.5e-3 };
        let one =
            chain::Run { m_r, m_p, J_r: j_r, ..Default::default() }.ask().until(0.3).solve(&FINE);
        let other =
            bodies::Run { m_r, m_p, J_r: j_r, ..Default::default() }.ask().until(0.3).solve(&FINE);
        let (one, other) = (one.expect("a motion"), other.expect("a motion"));
        for name in ["a1", "w", "pin.x", "pin.y"] {
            let (a, b) = (one.value(name, 0.3).unwrap(), other.value(name, 0.3).unwrap());
            let size = a.abs() + 1e-6 * (1.0 + m_p + m_r);
            assert!((a - b).abs() < 1e-7 * size, "{name} with {m_r:e} and {m_p:e}: {a} {b}");
        }
    }
}

/// The force in the piston pin at 1 rad and 30 rad/s, by 40 digits, for masses of rod and piston.
const PIN: [[f64; 4]; 4] = [
    [1e-9, 1e6, 23.009_455_816_332_574, -2.615_409_940_584_158_6],
    [1e6, 1e-9, -3.089_010_047_178_098e-10, -5_175_541.831_682_963],
    [1e-9, 1e-9, 1.436_405_076_556_414e-8, 2.437_338_044_860_127],
    [0.0, 0.35, 3.869_015_390_598_726, -0.958_297_707_125_747_7],
];

/// The naive way: `J A⁻¹ Jᵀ` of the closures of all bodies, for the forces that hold them.
fn naive_pin(m_r: f64, m_p: f64, j_r: f64) -> Option<[f64; 2]> {
    let (r, l, w, a1) = (0.04_f64, 0.14, 30.0, 1.0_f64);
    let a2 = -(r / l * a1.sin()).asin();
    let w2 = -r * w * a1.cos() / (l * a2.cos());
    let [(s1, c1), (s2, c2)] = [a1, a2].map(f64::sin_cos);
    let (half, rod) = (r / 2.0, l / 2.0);
    let slopes = nalgebra::SMatrix::<f64, 6, 7>::from_row_slice(
        &[
            [1.0, 0.0, half * s1, 0.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, -half * c1, 0.0, 0.0, 0.0, 0.0],
            [1.0, 0.0, -half * s1, -1.0, 0.0, -rod * s2, 0.0],
            [0.0, 1.0, half * c1, 0.0, -1.0, rod * c2, 0.0],
            [0.0, 0.0, 0.0, 1.0, 0.0, -rod * s2, -1.0],
            [0.0, 0.0, 0.0, 0.0, 1.0, rod * c2, 0.0],
        ]
        .concat(),
    );
    let (one, two) = (w * w * half, w2 * w2 * rod);
    let left = nalgebra::SVector::<f64, 6>::from([
        one * c1,
        one * s1,
        -one * c1 - two * c2,
        -one * s1 - two * s2,
        -two * c2,
        -two * s2,
    ]);
    let inverse = [1.0, 1.0, 2e-3, m_r, m_r, j_r, m_p].map(f64::recip);
    let inverse = nalgebra::SMatrix::<f64, 7, 7>::from_diagonal(&inverse.into());
    let weight = nalgebra::SVector::<f64, 7>::from([0.0, -9.81, 0.0, 0.0, -9.81 * m_r, 0.0, 0.0]);
    let matrix = slopes * inverse * slopes.transpose();
    let forces = matrix.lu().solve(&(slopes * inverse * weight + left))?;
    Some([-forces[4], -forces[5]])
}

#[test]
fn forces_have_all_their_digits_whatever_the_masses() {
    let mut worst = [0.0_f64; 2];
    for [m_r, m_p, x, y] in PIN {
        let j_r = if m_r == 0.0 { 0.0 } else { 1.5e-3 };
        let equations = chain::Run { m_r, m_p, J_r: j_r, ..Default::default() }.prepare::<f64>();
        let mut outputs = [0.0; 9];
        equations.outputs(Phase::of(0), 0.0, &[1.0, 30.0], &mut outputs);
        let off = |found: [f64; 2]| ((found[0] - x).hypot(found[1] - y)) / x.hypot(y);
        let ours = off([outputs[4], outputs[5]]);
        let naive = naive_pin(m_r, m_p, j_r).map_or(f64::NAN, off);
        assert!(ours < 1e-11, "{m_r:e} {m_p:e}: {ours:e}");
        let is_worse = naive.is_nan() || naive > 100.0 * ours;
        assert!(is_worse, "{m_r:e} {m_p:e}: {naive:e} {ours:e}");
        worst = [worst[0].max(ours), worst[1].max(naive)];
    }
    told(&Row {
        case: "Masses far apart",
        tried: "forces of a slider-crank whose rod and piston weigh 1e-9 and 1e6 kg, or nothing",
        naive: format!("`J A⁻¹ Jᵀ` of the closures: off by {:.0e}, or singular", worst[1]),
        ours: format!("off by {:.0e}: masses are reduced along the loops", worst[0]),
        cost: "less: one equation instead of six".to_owned(),
    });
}

/// Both cranks of a drag link turn all round, written with angles from x and from each other.
mod drag_link {
    assur::mechanism! {
        DragLink from "any textbook";
        parameter a = 80 mm, b = 90 mm, c = 100 mm, d = 40 mm, J = 1e-3 [kg m^2], K = 2e-3 [kg m^2];
        coordinate phi: rad = 60 deg, rate = 10 [rad/s];
        kinetic J*dot(phi)^2/2;
        choice form {
            absolute {
                dependent theta ~ 30 deg, psi ~ 60 deg;
                closure pin: a*dir(phi) + b*dir(theta) = [d, 0] + c*dir(psi);
                output theta, psi;
            }
            relative {
                dependent alpha ~ -30 deg, beta ~ 40 deg;
                let theta = phi + alpha, psi = theta + beta;
                closure pin: a*dir(phi) + b*dir(theta) = [d, 0] + c*dir(psi);
                output theta, psi;
            }
        }
        kinetic K*dot(psi)^2/2;
        scene one { run time 0 s .. 3 s; }
        scene two = form.relative { run time 0 s .. 3 s; }
    }
}

#[test]
fn an_angle_that_turns_all_round_does_not_jump() {
    let one = drag_link::One::default().solve(&FINE).expect("a motion");
    let two = drag_link::Two::default().solve(&FINE).expect("a motion");
    let mut last: Option<f64> = None;
    for step in 0..=300 {
        let time = f64::from(step) / 100.0;
        let of = |motion: &Motion, name: &str| motion.value(name, time).expect("an angle");
        let [phi, psi, theta] = ["phi", "psi", "theta"].map(|name| of(&one, name));
        assert!((of(&two, "psi") - psi).abs() < 1e-8 && (of(&two, "theta") - theta).abs() < 1e-8);
        assert!(last.is_none_or(|last| (psi - last).abs() < 0.3), "{time}: {last:?} {psi}");
        last = Some(psi);
        let naive = psi.sin().atan2(psi.cos());
        assert!(phi < 5.5 || (naive - psi).abs() > 3.0, "an arc tangent alone comes back");
        let open = 0.08 * phi.cos() + 0.09 * theta.cos() - 0.04 - 0.1 * psi.cos();
        assert!(open.abs() < 1e-14, "{open:e}");
    }
    assert!(last.is_some_and(|last| last > 5.0 * 2.0 * PI), "{last:?}");
}

/// A crank that cannot turn all round, and is driven against its end.
mod locking {
    assur::mechanism! {
        Locking from "made up";
        parameter a = 100 mm, b = 150 mm, c = 80 mm, d = 200 mm, J = 1e-3 [kg m^2], M = 0.1 [N m];
        coordinate phi: rad = 40 deg;
        dependent theta ~ 10 deg, psi ~ 80 deg;
        closure joint: a*dir(phi) + b*dir(theta) = [d, 0] + c*dir(psi);
        kinetic J*dot(phi)^2/2 + J*dot(psi)^2/2;
        force M on phi;
        output phi, psi;
        scene run { run time 0 s .. 3 s; }
    }
}

/// The crank alone would go on, and the loop does not let it: the reduced equations end there with what was reached, and with
/// all positions as coordinates the rocker swings on through.
#[test]
fn a_crank_that_cannot_turn_round_comes_back() {
    let scene = locking::Run::default();
    let motion = scene.run().expect("a motion");
    for time in [0.5, 1.0, 3.0] {
        let of = |name: &str| motion.value(name, time).expect("a quantity");
        let energy = 1e-3 * (of("dot(phi)").powi(2) + of("dot(psi)").powi(2)) / 2.0;
        let work = 0.1 * (of("phi") - 40_f64.to_radians());
        assert!((energy - work).abs() < 1e-9, "{time}: {energy} {work}");
    }
    let error = scene.ask().attempt(&Settings::default()).expect_err("a dead point");
    let Error::Stopped(stopped) = &error else { panic!("{error}") };
    let reached = stopped.motion().expect("the motion so far");
    // There the coupler and the rocker are in one line: `d² + a² - 2 a d cos(phi) = (b + c)²`.
    let end = ((0.2_f64.powi(2) + 0.1_f64.powi(2) - 0.23_f64.powi(2)) / (2.0 * 0.1 * 0.2)).acos();
    assert!(reached.time > 0.01, "{}", reached.time);
    assert!((reached.end[0] - end).abs() < 1e-5, "{} {end}", reached.end[0]);
    assert!(matches!(stopped, assur::hybrid::HybridError::Lost { .. }), "{stopped}");
    let model = Bound::new(&locking::Run::default());
    let margin = (&model as &dyn Model).margins_in(0, reached.time, &reached.end)[0];
    assert!(margin.abs() < 1e-6, "{margin:e}");
}

/// A drive turns a four-bar farther than its links reach, while a mass hangs on it by a spring.
mod locks {
    assur::mechanism! {
        Locks from "made up";
        parameter a = 80 mm, b = 100 mm, c = 90 mm, d = 160 mm, w = 2 [rad/s], m = 1 kg, k = 100 [N/m];
        driver phi = 0.8 rad + w*time;
        dependent psi ~ -10 deg, chi ~ 100 deg;
        coordinate x: m = 0;
        closure pin: a*dir(phi) + b*dir(psi) = [d, 0] + c*dir(chi);
        kinetic m*dot(x)^2/2;
        potential k*(x - c*cos(chi))^2/2;
        output M = effort(phi) [N m];
        scene runs { run time 0 s .. 2 s; }
    }
}

#[test]
fn a_linkage_that_locks_on_the_way_ends_the_motion_there() {
    let error = locks::Runs::default().run().expect_err("the links do not reach");
    let Error::Stopped(stopped) = &error else { panic!("{error}") };
    let motion = stopped.motion().expect("it moved so far");
    // Coupler and rocker stretched, in mm: cos φ = (a² + d² - (b + c)²)/(2 a d).
    let reach: f64 = (80.0 * 80.0 + 160.0 * 160.0 - 190.0 * 190.0) / (2.0 * 80.0 * 160.0);
    let end = (reach.acos() - 0.8) / 2.0;
    assert!((motion.time - end).abs() < 1e-9, "{} {end}", motion.time);
    assert!(error.to_string().contains("0.4658"), "{error}");
    // The cosine rule goes on, with what is no number.
    let angle = 0.8 + 2.0 * (end + 1e-6);
    let square = 80.0_f64.powi(2) + 160.0_f64.powi(2) - 2.0 * 80.0 * 160.0 * angle.cos();
    let naive = (square - 100.0_f64.powi(2) - 90.0_f64.powi(2)) / (2.0 * 100.0 * 90.0);
    assert!(naive.acos().is_nan(), "{naive}");
}
