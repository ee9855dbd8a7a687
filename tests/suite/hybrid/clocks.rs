//! Motions that repeat by themselves, and where motions of several periods begin.

use std::f64::consts::TAU;

use assur::hybrid;
use assur::prelude::*;

mod clock {
    assur::mechanism! {
        /// A pendulum that is pushed at each passage to the right.
        Clock from "an escapement without recoil";
        parameter w = 1 [1/s], d = 0.02 [1/s], push = 0.02 [1/s];
        coordinate phi: rad = 0.1;
        motion swing: ddot(phi) + d*dot(phi) + w^2*phi = 0 [1/s^2];
        mode free { when phi rises -> free { set dot(phi) = dot(phi) + push; } }
        output phi;
        scene own { periodic; }
    }
}

/// Settings with a tolerance.
fn fine(rtol: f64) -> Settings {
    Settings::new(Method::Dop853).rtol(rtol)
}

#[test]
fn a_clock_has_its_period() {
    let scene = clock::Own::default();
    let found = hybrid::clock(&scene, &fine(1e-11)).expect("it repeats");
    // Between pushes at zero the motion is one turn of the damped oscillator.
    let turn = TAU / (scene.w.powi(2) - (scene.d / 2.0).powi(2)).sqrt();
    assert!((found.period() / turn - 1.0).abs() < 1e-11, "{}", found.period());
    let decay = (-scene.d / 2.0 * turn).exp();
    assert_eq!(found.multipliers.len(), 1);
    assert!((found.multipliers[0].re - decay).abs() < 1e-8);
    // The speed before a push, of which the rest comes back.
    let passed = &found.motion.events[0];
    let speed = scene.push * decay / (1.0 - decay);
    assert!((passed.before[1] / speed - 1.0).abs() < 1e-9, "{:?}", passed.before);
    // It begins where the angle is largest.
    assert!(found.start()[1].abs() < 1e-9);
    let larger = (0..100).map(|part| found.motion.at(f64::from(part) * turn / 100.0).1[0]);
    assert!(larger.fold(0.0, f64::max) <= found.start()[0] + 1e-12);
}

#[test]
fn a_motion_of_several_periods_begins_in_the_one_where_the_first_state_is_largest() {
    let scene = assur_equations::presser_foot::Progressive { omega: 410.0, ..Default::default() };
    let period = TAU / scene.omega;
    let starts = [1e-8, 1e-9, 1e-10].map(|rtol| {
        let found = hybrid::cycle(&scene, period, &fine(rtol)).expect("it repeats");
        assert_eq!(found.multiple, 3);
        let begin = |number: usize| found.motion.at(number as f64 * period).1[0];
        assert!(begin(0) > begin(1) && begin(0) > begin(2));
        found.start()
    });
    // So its start is known as well as the motion.
    assert!((starts[0][0] - starts[2][0]).abs() < 1e-9, "{starts:?}");
}
