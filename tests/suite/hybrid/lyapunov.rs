//! Lyapunov exponents of motions of which they are known.

use assur::hybrid::{self, CycleError, Periods};
use assur::prelude::*;

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-12);

mod idle {
    assur::mechanism! {
        /// A shaken mass with more than the critical damping. Its event sets the speed to what it is.
        Idle from "made up";
        parameter m = 1 kg, d = 5 [N s/m], c = 4 [N/m], F = 3 N, omega = 6 [1/s];
        coordinate x: m = 0;
        motion m*ddot(x) + d*dot(x) + c*x = F*cos(omega*time);
        when x falls { set dot(x) = dot(x); }
        output x;
        scene shaken { periodic over 2*pi/omega; }
    }
}

mod shift {
    assur::mechanism! {
        /// A number that is multiplied once a period, and of which the whole part is dropped.
        Shift from "A. Renyi, Acta Math. Acad. Sci. Hung. 8 (1957) 477";
        parameter beta = 1.9 in 1 .. 2, P = 0.5 s;
        state x: 1 = 0.3;
        motion dot(x) = 0 [1/s];
        when sin(2*pi*time/P) falls { set x = if beta*x > 1 { beta*x - 1 } else { beta*x }; }
        output x;
        scene shifted { periodic over P; }
    }
}

mod filling {
    assur::mechanism! {
        /// A level that grows by itself and is let down where it comes to the brim.
        Filling from "made up";
        parameter T = 2 s, brim = 2, rest = 1;
        state x: 1 = 1.2;
        motion T*dot(x) = x;
        when x - brim rises { set x = rest; }
        output x;
        scene filled { periodic over T*ln(brim/rest); }
    }
}

#[track_caller]
fn check<C: Scene>(scene: &C, period: f64, settling: usize, expected: &[f64]) {
    let periods = Periods { settling, counted: 50 };
    let start = (scene.shape().first, &scene.start()[..]);
    let found = hybrid::lyapunov(scene, start, period, periods, &FINE).unwrap();
    assert_eq!(found.exponents.len(), expected.len());
    for (found, expected) in found.exponents.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

/// The roots of `m λ² + d λ + c = 0`, events or not.
#[test]
fn of_a_linear_motion_they_are_the_roots() {
    let scene = idle::Shaken::default();
    let period = std::f64::consts::TAU / scene.omega;
    let motion = hybrid::march(&scene, (0.0, 20.0 * period), &scene.start(), &FINE).unwrap();
    assert!(motion.events.len() > 10, "{}", motion.events.len());
    check(&scene, period, 10, &[-1.0, -4.0]);
}

/// All orbits of the shift part by the same factor, and fill the interval.
#[test]
fn of_the_shift_it_is_the_logarithm_of_the_factor() {
    for beta in [1.3, 1.9] {
        let scene = shift::Shifted { beta, ..shift::Shifted::default() };
        check(&scene, scene.P, 0, &[beta.ln() / scene.P]);
        let error = hybrid::cycle(&scene, scene.P, &FINE).unwrap_err();
        let CycleError::NoneStable { growth, .. } = error else {
            panic!("{error}");
        };
        assert!((growth / beta - 1.0).abs() < 1e-9, "{growth} {beta}");
    }
}

/// Who is later on the way of a motion that goes by itself stays as late, for ever: what grows on the way up is lost at
/// the brim, where the one is let down sooner than the other.
#[test]
fn along_a_motion_that_goes_by_itself_it_is_zero() {
    let scene = filling::Filled::default();
    let period = scene.T * (scene.brim / scene.rest).ln();
    check(&scene, period, 0, &[0.0]);
}

#[test]
fn a_period_of_nothing_is_refused() {
    let scene = idle::Shaken::default();
    let periods = Periods { settling: 0, counted: 1 };
    for period in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let found = hybrid::lyapunov(&scene, (0, &[0.0, 0.0]), period, periods, &FINE);
        assert!(matches!(found, Err(CycleError::BadPeriod { .. })));
    }
}
