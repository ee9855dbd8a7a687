//! Motions whose closures are not solved for: beyond dead points, through change points, in space, where closures depend on
//! each other, and where pins come and go. The naive way fails beside each.

mod flat;

use assur::answer::{Error, Motion};
use assur::prelude::*;

use crate::stability::{Row, told};

/// A slider-crank with the slider as the coordinate.
mod slider {
    assur::mechanism! {
        Slider from "made up";
        parameter r = 40 mm, l = 140 mm in 1 mm .. 1 m, J = 2e-3 [kg m^2], m = 0.5 kg in 0 kg .. 1 t, J_r = 0 [kg m^2] in 0 [kg m^2] .. 1 [kg m^2];
        coordinate x: m = 150 mm, rate = -1 [m/s];
        dependent theta ~ 60 deg, psi ~ -14 deg;
        closure pin: r*dir(theta) + l*dir(psi) = [x, 0];
        kinetic J*dot(theta)^2/2 + m*dot(x)^2/2 + J_r*dot(psi)^2/2;
        output x, theta, w = dot(theta), pin = reaction(pin) [N], E = energy(kinetic);
        scene run { run time 0 s .. 1 s; }
    }
}

/// The same with the crank as the coordinate, which has no dead point.
mod crank {
    assur::mechanism! {
        Crank from "made up";
        parameter r = 40 mm, l = 140 mm, J = 2e-3 [kg m^2], m = 0.5 kg;
        coordinate theta: rad = acos((r^2 + (150 mm)^2 - l^2)/(2*r*(150 mm))), rate = 1 [m/s]/(r*sin(theta_0 - psi_0)/cos(psi_0));
        let theta_0 = acos((r^2 + (150 mm)^2 - l^2)/(2*r*(150 mm)));
        let psi_0 = -asin(r/l*sin(theta_0));
        dependent psi ~ -14 deg, x ~ 150 mm;
        closure pin: r*dir(theta) + l*dir(psi) = [x, 0];
        kinetic J*dot(theta)^2/2 + m*dot(x)^2/2;
        output x, theta, w = dot(theta), pin = reaction(pin) [N], E = energy(kinetic);
        scene run { run time 0 s .. 1 s; }
    }
}

/// A pendulum in Cartesian coordinates that is pushed to and fro in a fluid.
mod pushed {
    assur::mechanism! {
        Pushed from "made up";
        parameter L = 1 m, m = 1 kg, g = 9.81 [m/s^2], F = 2 N, d = 0.8 [N*s/m], w = 2.5 [rad/s];
        coordinate x: m = 0.05 m;
        dependent y ~ -1 m;
        closure rod: x^2 + y^2 = L^2;
        kinetic m*(dot(x)^2 + dot(y)^2)/2;
        potential m*g*y;
        dissipation d*(dot(x)^2 + dot(y)^2)/2;
        force F*cos(w*time) on x;
        output x, y, v = dot(x);
        scene steady { periodic over 2*pi/w; }
    }
}

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-12);

/// By the reduced equations, as they are.
fn reduced(scene: &impl Solve) -> Result<Motion, Error> {
    scene.ask().attempt(&FINE)
}

#[track_caller]
fn check(motion: &Motion, name: &str, time: f64, expected: f64, tolerance: f64) {
    let found = motion.value(name, time).expect("a quantity");
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{name} at {time} s: {found}, expected {expected}, off by {off:e}");
}

#[test]
fn a_slider_goes_through_both_dead_centres() {
    let slider = slider::Run::default();
    assert!(reduced(&slider).is_err_and(|error| error.is_lost()));
    let one = slider.solve(&FINE).expect("a motion");
    let other = crank::Run::default().solve(&FINE).expect("a motion");
    assert!(one.shape().augmented.is_some() && other.shape().augmented.is_none());
    for time in [0.05, 0.0740132328, 0.19, 0.5, 1.0] {
        for (name, tolerance) in [
            ("theta", 1e-9),
            ("x", 1e-10),
            ("w", 1e-8),
            ("E", 1e-10),
            ("pin.x", 1e-8),
            ("pin.y", 1e-8),
        ] {
            check(&one, name, time, other.value(name, time).expect("a quantity"), tolerance);
        }
    }
    let off = (one.value("E", 1.0).expect("E") / one.value("E", 0.0).expect("E") - 1.0).abs();
    let stopped = reduced(&slider).map(|_| ()).expect_err("a dead point").to_string();
    let work = [&one, &other].map(|motion| motion.statistics().evaluations as f64);
    told(&Row {
        case: "Dead points",
        tried: "a slider-crank whose slider is the coordinate, for a second, through 13 dead points",
        naive: format!("the equations reduced to the slider end: {stopped}"),
        ours: format!("goes on with all positions as coordinates; energy kept to {off:.0e}"),
        cost: format!("{:.2} times the evaluations of the crank as coordinate", work[0] / work[1]),
    });
    // A start of one's own in the coordinates of the scene is kept.
    let from = slider.from([0.16, 0.5]).solve(&FINE).expect("a motion");
    check(&from, "x", 0.0, 0.16, 1e-15);
    check(&from, "dot(x)", 0.0, 0.5, 1e-14);
}

#[test]
fn with_equal_crank_and_rod_the_piston_rests_or_runs_through() {
    // At x = 0 crank and rod lie on each other: the piston may rest there, or run through by its momentum.
    let equal = slider::Run { l: 0.04, J_r: 1e-4, ..slider::Run::default() };
    let start = [0.06, -1.0];
    assert!(equal.from(start).attempt(&FINE).is_err_and(|error| error.is_lost()));
    let motion = equal.from(start).solve(&Settings::default()).expect("a motion");
    let lowest = (0..400).map(|k| motion.value("x", k as f64 * 2.5e-3).expect("x"));
    let lowest = lowest.fold(f64::INFINITY, f64::min);
    assert!((lowest + 0.08).abs() < 1e-3, "{lowest}");
    let energy = motion.value("E", 0.0).expect("E");
    check(&motion, "E", 1.0, energy, 1e-8 * energy);
}

#[test]
fn a_pendulum_swings_in_cartesian_coordinates() {
    let scene = assur_equations::simple_pendulum::Swing::default();
    assert!(reduced(&scene).is_err_and(|error| error.is_lost()));
    let motion = scene.solve(&FINE).expect("a motion");
    let period = 2.3678419475762;
    check(&motion, "x", 0.5 * period, 1.0, 1e-10);
    check(&motion, "x", 4.0 * period, -1.0, 1e-10);
    check(&motion, "tension", 2.25 * period, 29.43, 1e-8);
    // The naive second derivative of the closure drifts; here it stays closed, position and speed.
    for time in [1.0, 5.0, 10.0] {
        let (_, state) = motion.place(time);
        let (open, slips) = (
            state[0] * state[0] + state[1] * state[1] - 1.0,
            state[0] * state[2] + state[1] * state[3],
        );
        assert!(open.abs() < 1e-11 && slips.abs() < 1e-9, "{time}: {open:e} {slips:e}");
    }
}

#[test]
fn all_methods_agree_on_what_is_held() {
    let scene = assur_equations::bricard::Fall::default();
    let exact = scene.solve(&FINE).expect("a motion").value("a[1]", 3.0).expect("an angle");
    for (method, tolerance) in [
        (Method::Tsit5, 1e-6),
        (Method::Radau, 1e-5),
        (Method::Rosenbrock, 1e-6),
        (Method::Auto, 1e-6),
    ] {
        let motion =
            scene.ask().until(3.0).solve(&Settings::new(method).rtol(1e-8)).expect("a motion");
        check(&motion, "a[1]", 3.0, exact, tolerance);
    }
}

/// Where the closures of Bricard's mechanism are open by turning its hinges.
fn hinges(a: &[f64]) -> [f64; 5] {
    use nalgebra::{Rotation3, Vector3};
    let [x, y, z] = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    let mut turned = Rotation3::identity();
    let mut place = Vector3::zeros();
    for ((axis, rod), angle) in [(y, *x), (z, -*y), (x, *z), (y, -*x), (z, *y)].into_iter().zip(a) {
        turned *= Rotation3::from_axis_angle(&axis, *angle);
        place += turned * rod;
    }
    let (open, last) = (place - *z, turned * *x);
    [open.x, open.y, open.z, last.y, last.z]
}

#[test]
fn of_five_closures_four_say_everything() {
    let scene = assur_equations::bricard::Fall::default();
    let motion = scene.solve(&FINE).expect("a motion");
    let mut ratio = 0.0_f64;
    for time in [0.0, 0.7, 1.9, 4.4, 8.0] {
        let (_, state) = motion.place(time);
        let angles = &state[..5];
        let open = hinges(angles).iter().fold(0.0_f64, |most, open| most.max(open.abs()));
        assert!(open < 1e-10, "{time}: {open:e}");
        let slope = |row: usize, column: usize| {
            let aside = [1e-5, -1e-5].map(|step| {
                let mut aside = angles.to_vec();
                aside[column] += step;
                hinges(&aside)[row]
            });
            (aside[0] - aside[1]) / 2e-5
        };
        let values = nalgebra::SMatrix::<f64, 5, 5>::from_fn(slope).singular_values();
        // The naive elimination divides by the last one.
        assert!(values[4] < 1e-9 * values[0] && values[3] > 1e-3 * values[0], "{time}: {values}");
        check(&motion, "E", time, -29.43, 1e-8);
        ratio = ratio.max(values[4] / values[0]);
    }
    let lost = (motion.value("E", 10.0).expect("E") / -29.43 - 1.0).abs();
    told(&Row {
        case: "Redundant loops",
        tried: "Bricard's mechanism falls for 10 s: of its five closures one follows from the others",
        naive: format!("elimination divides by {ratio:.0e} of the largest pivot"),
        ours: format!("factors by rank; energy kept to {lost:.0e}"),
        cost: format!("{} evaluations", motion.statistics().evaluations),
    });
}

/// A pendulum of which the rod breaks where its tension comes to a limit.
mod broken {
    assur::mechanism! {
        Broken from "made up";
        parameter m = 1 kg, L = 1 m, g = 9.81 [m/s^2], limit = 20 N;
        coordinate x: m = -1 m, y: m = 0;
        kinetic m*(dot(x)^2 + dot(y)^2)/2;
        potential m*g*y;
        output x, y, E = energy(kinetic) + energy(potential);
        mode held {
            closure rod: x^2 + y^2 = L^2;
            when breaks: -2*L*reaction(rod) - limit rises -> free;
        }
        mode free { }
        scene swing { run time 0 s .. 1 s; start held; }
    }
}

#[test]
fn a_rod_that_breaks_lets_go() {
    let motion = broken::Swing::default().solve(&FINE).expect("a motion");
    let [event] = motion.events() else { panic!("{:?}", motion.events()) };
    // The tension is -3 m g y.
    let (_, state) = motion.place(event.time);
    assert!((state[1] + 20.0 / (3.0 * 9.81)).abs() < 1e-9, "{state:?}");
    let speed = (2.0 * 9.81 * -state[1]).sqrt();
    let (x, vx) = (-(1.0 - state[1] * state[1]).sqrt(), speed * -state[1]);
    let left = 1.0 - event.time;
    check(&motion, "x", 1.0, x + vx * left, 1e-8);
    check(&motion, "E", 1.0, 0.0, 1e-9);
}

/// A mass on a plane that a rod catches: it goes on around the pivot with what is left of its speed.
mod caught {
    assur::mechanism! {
        Caught from "made up";
        parameter m = 2 kg, L = 1 m;
        coordinate x: m = 0.6 m, y: m = 0, rate = 1 [m/s];
        kinetic m*(dot(x)^2 + dot(y)^2)/2;
        output x, y, E = energy(kinetic);
        mode free { when taut: x^2 + y^2 - L^2 rises -> held; }
        mode held { closure rod: x^2 + y^2 = L^2; }
        scene run { run time 0 s .. 3 s; start free; }
    }
}

#[test]
fn a_rod_that_catches_takes_the_speed_along_it() {
    let motion = caught::Run::default().solve(&FINE).expect("a motion");
    // It is caught at (0.6, 0.8): 0.6 of the speed is left, across the rod.
    check(&motion, "E", 0.5, 1.0, 1e-12);
    check(&motion, "E", 2.0, 0.36, 1e-9);
    let angle = f64::atan2(0.8, 0.6) + 0.6 * (3.0 - 0.8);
    check(&motion, "x", 3.0, angle.cos(), 1e-9);
    check(&motion, "y", 3.0, angle.sin(), 1e-9);
}

/// A crank about z moves a rocker about x by a rod with ball joints, in space.
mod rssr {
    assur::mechanism! {
        Rssr from "any textbook";
        parameter r = 50 mm, L = 270 mm, q = 120 mm, a = 200 mm, b = 100 mm, c = 80 mm, J = 1e-3 [kg m^2], K = 2e-3 [kg m^2];
        coordinate phi: rad = 30 deg, rate = 20 [rad/s];
        dependent psi ~ 60 deg;
        let A = rotz(phi)*[r, 0 m, 0 m];
        let B = [a, b, c] + rotx(psi)*[0 m, q, 0 m];
        closure rod: inner(B - A, B - A) = L^2;
        kinetic J*dot(phi)^2/2 + K*dot(psi)^2/2;
        output psi, w = dot(phi), E = energy(kinetic), rod = reaction(rod);
        scene run { run time 0 s .. 2 s; }
    }
}

#[test]
fn a_spatial_loop_keeps_its_energy() {
    let motion = rssr::Run::default().solve(&FINE).expect("a motion");
    let energy = motion.value("E", 0.0).expect("E");
    for time in [0.3, 1.0, 2.0] {
        check(&motion, "E", time, energy, 1e-10 * energy);
        let (phi, psi) = (motion.value("phi", time), motion.value("psi", time));
        let (phi, psi) = (phi.expect("an angle"), psi.expect("an angle"));
        let a = [0.05 * phi.cos(), 0.05 * phi.sin(), 0.0];
        let b = [0.2, 0.1 + 0.12 * psi.cos(), 0.08 + 0.12 * psi.sin()];
        let length = a.iter().zip(b).map(|(a, b)| (b - a) * (b - a)).sum::<f64>().sqrt();
        assert!((length - 0.27).abs() < 1e-12, "{length}");
    }
}

#[test]
fn a_start_that_does_not_close_is_refused() {
    let scene = assur_equations::bricard::Fall::default();
    assert!(scene.check().is_ok());
    let start = scene.start();
    let from = |off: f64| {
        let mut start = start.clone();
        start[1] += off;
        scene.from(start).run()
    };
    let motion = from(1e-9).expect("a motion");
    check(&motion, "E", 10.0, -29.43, 1e-7);
    let error = from(1e-3).map(|_| ()).expect_err("it does not close");
    assert!(error.to_string().contains("the closures next to that ask for"), "{error}");
    told(&Row {
        case: "Inconsistent start values",
        tried: "Bricard's mechanism from an angle that is off by 1 mrad",
        naive: "constraints differentiated twice keep whatever gap there is: see the drift of constraints".to_owned(),
        ours: format!("an error: {error}; what is off by 1 nrad is closed first"),
        cost: "none".to_owned(),
    });
    let long = slider::Run { r: 0.3, ..slider::Run::default() };
    let unreduced = long.unreduced().expect("another form");
    assert!(unreduced.run().is_err() && long.ask().run().is_err());
}

/// A four-bar under its motor, and the same with a closure that says once more how long the coupler is.
mod motor {
    assur::mechanism! {
        Motor from "made up";
        parameter a = 50 mm, b = 150 mm, c = 120 mm, d = 160 mm;
        parameter J = 1e-3 [kg m^2], K = 2e-3 [kg m^2], w = 40 [rad/s], k = 0.02 [N m s], l = 0.01 [N m s];
        coordinate phi: rad = 0, rate = 30 [rad/s];
        dependent psi ~ 80 deg, theta ~ 50 deg;
        let A = a*dir(phi);
        let B = [d, 0] + c*dir(psi);
        closure coupler: A + b*dir(theta) = B;
        effect twice { closure length: inner(B - A, B - A) = b^2; }
        kinetic J*dot(phi)^2/2 + K*dot(psi)^2/2;
        dissipation l*dot(psi)^2/2;
        force k*(w - dot(phi)) on phi;
        output speed = dot(phi);
        scene once { periodic; }
        scene over = twice { periodic; }
    }
}

#[test]
fn a_motion_repeats_with_the_same_multipliers_where_closures_hold_it() {
    let settings = Settings::new(Method::Dop853).rtol(1e-11);
    let once = motor::Once::default().solve(&settings).expect("a motion");
    let over = motor::Over::default().solve(&settings).expect("a motion");
    assert!(once.shape().augmented.is_none());
    let held = over.shape().augmented.expect("closures");
    assert_eq!((held.loops.len(), held.rank, held.redundant.len()), (3, 2, 1));
    let lengths = [&once, &over].map(|motion| motion.length().expect("a period"));
    assert!((lengths[0] - lengths[1]).abs() < 1e-9 * lengths[0], "{lengths:?}");
    let moduli = [&once, &over].map(|motion| -> Vec<f64> {
        motion.multipliers().iter().map(|multiplier| multiplier.modulus()).collect()
    });
    assert_eq!((moduli[0].len(), moduli[1].len()), (1, 1), "{moduli:?}");
    assert!((moduli[0][0] - moduli[1][0]).abs() < 1e-7, "{moduli:?}");
}

/// Multipliers are those of what the closure leaves.
#[test]
fn a_steady_state_that_closures_hold_is_that_of_the_reduced_motion() {
    let scene = pushed::Steady::default();
    let held = scene.unreduced().expect("either coordinate may come to a dead point");
    let (reduced, held) =
        (scene.solve(&FINE).expect("it repeats"), held.solve(&FINE).expect("it repeats"));
    for time in [0.0, 0.4, 1.1, 2.0] {
        for name in ["x", "y", "v"] {
            let [a, b] =
                [&reduced, &held].map(|motion| motion.value(name, time).expect("reported"));
            assert!((a - b).abs() < 1e-8, "{name} at {time}: {a} {b}");
        }
    }
    let moduli =
        |motion: &Motion| motion.multipliers().iter().map(|one| one.modulus()).collect::<Vec<_>>();
    let (a, b) = (moduli(&reduced), moduli(&held));
    assert_eq!((a.len(), b.len()), (2, 2), "{a:?} {b:?}");
    assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-6), "{a:?} {b:?}");
}

/// Nine masses, of which a pin holds two together for a while: many coordinates, and hardly an operation. Its Jacobian is what its
/// own tests look at.
mod sliding {
    assur::mechanism! {
        Sliding from "made up";
        parameter m = 1 kg, L = 1 m, c = 2 [N/m];
        for k in 1..9 {
            coordinate x[k]: m = 0 m, rate = 1 [m/s];
            kinetic m*dot(x[k])^2/2;
            potential c*x[k]^2/2;
        }
        output x[1];
        mode held {
            closure pin: x[1] = x[2];
            when opens: 2*x[1] - L rises -> loose;
        }
        mode loose { }
        scene run { run time 0 s .. 1 s; }
    }
}
