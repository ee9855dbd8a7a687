//! Inline mechanisms, compiled and run: every kind of statement and name that the printer has to get right.
#![allow(missing_docs, reason = "what is tested is the emitted code")]

mod emitted {
    mod branches;
    mod chain;
    mod coupled;
    mod events;
    mod first_order;
    mod groups;
    mod implicit;
    mod names;
    mod parts;
    mod pendulum;
    mod small;

    use assur::problem::{Equations, Scene};

    /// The derivative of the state with the declared values.
    pub fn rate<C: Scene + Default>(time: f64, state: &[f64]) -> Vec<f64> {
        rate_of(&C::default(), time, state)
    }

    /// The derivative of the state.
    pub fn rate_of<C: Scene>(scene: &C, time: f64, state: &[f64]) -> Vec<f64> {
        let equations = scene.prepare::<f64>();
        let state = fill::<C>(state);
        let mut rate = fill::<C>(&[]);
        equations.derivative(&equations.instant(time), &state, &mut rate);
        rate.as_ref().to_vec()
    }

    /// The outputs with the declared values.
    pub fn outputs<C: Scene + Default>(time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; C::shape().outputs.len()];
        let equations = C::default().prepare::<f64>();
        equations.outputs(time, &fill::<C>(state), &mut values);
        values
    }

    /// Names of the states.
    pub fn names<C: Scene>() -> Vec<&'static str> {
        C::shape().states.iter().map(|state| state.name).collect()
    }

    type State<C> = <<C as Scene>::Equations<f64> as Equations<f64>>::State;

    fn fill<C: Scene>(values: &[f64]) -> State<C> {
        use assur::problem::Storage;
        let mut state = State::<C>::zeros(C::shape().states.len());
        for (slot, value) in state.as_mut().iter_mut().zip(values) {
            *slot = *value;
        }
        state
    }

    #[track_caller]
    pub fn check(found: &[f64], expected: &[f64]) {
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found - expected).abs() <= 1e-12 * expected.abs().max(1e-3),
                "found {found}, expected {expected}"
            );
        }
    }
}
