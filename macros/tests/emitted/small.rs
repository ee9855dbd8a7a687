//! Scenes that lack something: states, parameters, outputs, drivers.

use super::{check, outputs, rate};
use assur::problem::{Reports, Scene, Span};

mod fixed {
    assur::mechanism! {
        /// A crank that is only looked at: no state.
        Crank from "made up";
        dimension r = 0.5 m;
        driver theta = 2 [rad/s]*time;
        output height = r*sin(theta);
        expect at theta = 90 deg: height = 0.5 m +- 1e-12 m;
        expect at amplitude: height = 0.5 m +- 1e-9 m;
        scene turn { periodic over pi*1 s; }
    }
}

mod bare {
    assur::mechanism! {
        /// Nothing but a state: no parameter, no output, no driver, no task.
        Bare from "made up";
        state x: 1 = 1;
        motion decay: dot(x) = -x/(1 s);
    }
}

mod inside {
    #[test]
    fn a_mechanism_may_stand_in_a_function() {
        assur::mechanism! {
            /// A mass on a spring.
            Oscillator from "any textbook";
            parameter m = 2 kg, k = 8 [N/m];
            coordinate x: m = 1 m;
            kinetic m*dot(x)^2/2;
            potential k*x^2/2;
        }
        super::check(&super::rate::<Oscillator>(0.0, &[1.0, 0.5]), &[0.5, -4.0]);
    }
}

#[test]
fn a_scene_without_states_has_outputs() {
    check(&outputs::<fixed::Turn>(0.3, &[]), &[0.5 * 0.6_f64.sin()]);
    assert_eq!(rate::<fixed::Turn>(0.3, &[]), []);
    let mut driver = [f64::NAN];
    let equations = fixed::Turn::default().prepare::<f64>();
    equations.drivers(0.3, &mut driver);
    check(&driver, &[0.6]);
}

#[test]
fn a_scene_may_have_nothing_but_a_state() {
    check(&rate::<bare::Bare>(0.0, &[3.0]), &[-3.0]);
    assert_eq!(bare::Bare {}.span(), Span::Open);
    assert_eq!(bare::Bare::from_values(&[]).values(), []);
    assert_eq!((bare::Bare::shape().outputs.len(), bare::Bare::shape().drivers.len()), (0, 0));
}
