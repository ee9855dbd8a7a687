//! Change points: where links lie flat closures depend on each other for an instant.

use super::{FINE, check, reduced};
use assur::answer::Motion;
use assur::prelude::*;

/// A parallelogram that is crossed: its crank and its rocker turn against each other.
mod crossed {
    assur::mechanism! {
        Crossed from "made up";
        parameter a = 1 m, d = 2 m, J = 0.7 [kg m^2], m = 1 kg, g = 9.81 [m/s^2];
        coordinate th: rad = 1 rad, rate = 8 [rad/s];
        dependent psi ~ -117 deg, be ~ -70 deg;
        closure pin: a*dir(th) + d*dir(be) = [d, 0] + a*dir(psi);
        let C = a*dir(th) + d/2*dir(be);
        kinetic J*dot(th)^2/2 + 0.4*J*dot(psi)^2/2 + m*inner(dot(C), dot(C))/2 + 0.3*J*dot(be)^2/2;
        potential m*g*C.y;
        scene turns { run time 0 s .. 5 s; }
    }
}

/// The same, its rocker's angle by half angles: nothing is singular.
mod half_angles {
    assur::mechanism! {
        HalfAngles from "made up";
        parameter a = 1 m, d = 2 m, J = 0.7 [kg m^2], m = 1 kg, g = 9.81 [m/s^2];
        coordinate th: rad = 1 rad, rate = 8 [rad/s];
        let psi = -2*atan2((d + a)*sin(th/2), (d - a)*cos(th/2));
        let A = a*dir(th), B = [d, 0] + a*dir(psi);
        let C = (A + B)/2, w = dot(B - A)/d;
        kinetic J*dot(th)^2/2 + 0.4*J*dot(psi)^2/2 + m*inner(dot(C), dot(C))/2 + 0.3*J*inner(w, w)/2;
        potential m*g*C.y;
        scene turns { run time 0 s .. 5 s; }
    }
}

/// Both cranks turn about seven times, through about fourteen change points, at none of which a symmetry helps.
#[test]
fn a_crossed_parallelogram_stays_crossed() {
    assert!(reduced(&crossed::Turns::default()).is_err_and(|error| error.is_lost()));
    for round in 0..8 {
        let start = [1.0, 6.0 + 0.7 * f64::from(round)];
        let end = |motion: Motion| motion.value("th", 5.0).expect("an angle");
        let motion = crossed::Turns::default().from(start).solve(&FINE).expect("a motion");
        let exact = half_angles::Turns::default().from(start).solve(&FINE).expect("a motion");
        let flat = motion.change_points().len() as f64;
        let (found, exact) = (end(motion), end(exact));
        assert!((found - exact).abs() < 5e-8, "{start:?}: {found} {exact}");
        let turned = (exact - start[0]) / std::f64::consts::PI;
        assert!((flat - turned).abs() < 1.0, "{flat} {turned}");
    }
}

#[test]
fn a_start_at_a_change_point_goes_on_with_its_speeds() {
    use assur_equations::four_bar_chain::One;
    let scene = One::default();
    // Flat: the reduced equations are nothing over nothing.
    assert!(scene.from([0.0, -2.0]).attempt(&FINE).is_err());
    let error = scene.from([0.0, -2.0]).run().map(|_| ()).expect_err("which branch?");
    assert!(error.to_string().contains("the closures next to that ask for"), "{error}");
    let held = scene.unreduced().expect("all positions as coordinates");
    let parallel = held.from([0.0, 0.0, 0.0, -2.0, -2.0, 0.0]).solve(&FINE).expect("a motion");
    // The energy of parallel cranks.
    let speed = |motion: &Motion, time: f64| motion.value("dot(th[0])", time).expect("a speed");
    let angle = |motion: &Motion, time: f64| motion.value("th[0]", time).expect("an angle");
    for time in [0.2, 0.5, 1.0] {
        let energy = |w: f64, th: f64| (2.0 / 3.0 + 1.0) * w * w / 2.0 + 2.0 * 9.81 * th.sin();
        let off = energy(speed(&parallel, time), angle(&parallel, time)) - energy(-2.0, 0.0);
        assert!(off.abs() < 1e-8, "{time}: {off:e}");
        check(&parallel, "ph[1]", time, 0.0, 1e-9);
    }
}

#[test]
fn windows_lie_flat_and_go_on() {
    use assur_equations::four_bar_chain::{One, Two};
    assert!(reduced(&One::default()).is_err_and(|error| error.is_lost()));
    // ((N + 1)/3 + N) th'' = -((N + 1)/2 + N) g/L cos th from 90 deg and -1/s, by a Taylor series with 20 digits.
    let one = One::default().solve(&FINE).expect("a motion");
    check(&one, "th[0]", 5.0, -15.37448094142013, 1e-8);
    check(&one, "dot(th[0])", 5.0, -5.678977607488, 1e-8);
    let two = Two::default().solve(&FINE).expect("a motion");
    for (time, angle) in
        [(2.0, -4.770237034517435), (5.0, -15.083557159858586), (10.0, -30.179800860191205)]
    {
        check(&two, "th[0]", time, angle, 1e-8);
        check(&two, "E", time, 35.835, 1e-8);
        check(&two, "ph[2]", time, 0.0, 1e-10);
    }
    // From upright through nine flat positions to 30.2 rad further back: each is reported, and nothing else.
    let changes = two.change_points();
    for (index, time) in changes.iter().enumerate() {
        let flat = -(index as f64) * std::f64::consts::PI;
        check(&two, "th[0]", *time, flat, 1e-6);
    }
    assert_eq!(changes.len(), 10, "{changes:?}");
}

#[test]
fn forty_windows_lie_flat_ten_times_and_go_on() {
    use assur_equations::four_bar_row::Falls;
    let settings = Settings::new(Method::Dop853).rtol(1e-7);
    let motion = Falls::default().ask().until(10.0).solve(&settings).expect("a motion");
    // By a Taylor series of all links in parallel, with 25 digits.
    check(&motion, "th[0]", 10.0, -30.0266374171908, 1e-4);
    check(&motion, "th[40]", 10.0, -30.0266374171908, 1e-4);
    check(&motion, "E", 10.0, 620.338333333333, 1e-2);
    assert_eq!(motion.change_points().len(), 10);
}

/// Beside a change point accelerations are nearly nothing over nothing, and all solutions scatter alike: where the largest one
/// lies, luck says, and others may have the same there.
#[test]
fn extremes_beside_a_change_point_are_as_uncertain_as_what_scatters() {
    use assur::answer::{Ends, Samples};
    use assur::shape::Subject;
    use assur_equations::four_bar_chain::One;
    let one = One { g: 11.1, ..One::default() };
    let extremes = |settings: &Settings| -> Vec<Ends> {
        let motion = one.solve(settings).expect("a motion");
        let rates: Vec<_> = (0..motion.shape().states.len()).map(Subject::Rate).collect();
        let found = motion.extremes(&rates, motion.task().limits());
        let samples = Samples { times: &[], values: &[] };
        motion.estimate().expect("other solutions").extremes(&motion, &rates, &samples, &found)
    };
    let noisy = extremes(&Settings::new(Method::Dop853).rtol(1e-12));
    let smooth = extremes(&Settings::new(Method::Tsit5).rtol(1e-6));
    assert_eq!(noisy.len(), smooth.len());
    for (index, (noisy, smooth)) in noisy.iter().zip(&smooth).enumerate() {
        for (found, right) in [(noisy.lowest, smooth.lowest), (noisy.highest, smooth.highest)] {
            let off = (found.value - right.value).abs();
            assert!(off <= 10.0 * found.error + right.error, "{index}: {found:?} {right:?}");
        }
    }
}
