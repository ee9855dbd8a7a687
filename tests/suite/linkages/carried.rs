//! A linkage that shakes a mass: its loop beside a coordinate that moves by itself, against the same with the loop solved
//! by hand.

use assur::prelude::*;

mod by_loop {
    assur::mechanism! {
        Shaker from "a slider-crank";
        dimension r = 20 mm, l = 60 mm, h = 5 mm;
        parameter n = 300 rpm, m = 1 kg, c = 900 [N/m], d = 3 [N s/m];
        driver theta = n*time ~ 0 deg;
        dependent psi ~ -5 deg, s ~ 80 mm;
        closure crank: r*dir(theta) + l*dir(psi) + [0, h] = [s, 0 m];
        coordinate x: m = 0;
        motion m*ddot(x) = c*(s - l - x) + d*(dot(s) - dot(x));
        output x, s, slide = dot(s), jerk = ddot(s);
        scene right { run time 0 s .. 1 s; }
    }
}

mod by_hand {
    assur::mechanism! {
        Shaker from "a slider-crank";
        dimension r = 20 mm, l = 60 mm, h = 5 mm;
        parameter n = 300 rpm, m = 1 kg, c = 900 [N/m], d = 3 [N s/m];
        driver theta = n*time;
        let s = r*cos(theta) + sqrt(l^2 - (r*sin(theta) + h)^2);
        coordinate x: m = 0;
        motion m*ddot(x) = c*(s - l - x) + d*(dot(s) - dot(x));
        output x, s, slide = dot(s), jerk = ddot(s);
        scene right { run time 0 s .. 1 s; }
    }
}

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-12);

#[test]
fn a_loop_beside_a_coordinate_moves_it_as_the_formula_does() {
    let (a, b) = (by_loop::Right::default(), by_hand::Right::default());
    let moved = assur::ode::march(&a, (0.0, 1.0), &a.start(), &FINE).unwrap();
    let same = assur::ode::march(&b, (0.0, 1.0), &b.start(), &FINE).unwrap();
    let (first, second) = (a.prepare::<f64>(), b.prepare::<f64>());
    let (mut these, mut those) = ([0.0; 4], [0.0; 4]);
    for step in 0..=100 {
        let time = f64::from(step) / 100.0;
        let (x, y) = (moved.at(time), same.at(time));
        assert!((x[0] - y[0]).abs() < 1e-12, "{time}: {} {}", x[0], y[0]);
        first.outputs(Phase::of(0), time, &x, &mut these);
        second.outputs(Phase::of(0), time, &x, &mut those);
        for (one, other) in these.iter().zip(those) {
            assert!(
                (one - other).abs() < 1e-10 * (1.0 + other.abs()),
                "{time}: {these:?} {those:?}"
            );
        }
    }
}

/// With a long crank the rod does not reach from some angle on: an error there, and not a number.
#[test]
fn a_loop_that_ceases_to_close_ends_the_motion_with_an_error() {
    use assur::ode::OdeError;
    let scene = by_loop::Right { r: 0.058, ..Default::default() };
    let error = assur::ode::march(&scene, (0.0, 1.0), &scene.start(), &FINE).unwrap_err();
    let (OdeError::NotFinite { time, .. } | OdeError::StepTooSmall { time, .. }) = error else {
        panic!("not expected: {error}");
    };
    let angle = ((scene.l - scene.h) / scene.r).asin();
    assert!((time - angle / scene.n).abs() < 1e-9, "{time}");
}
