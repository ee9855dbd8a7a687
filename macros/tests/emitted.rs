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

    use assur::model::{Bound, Model};
    use assur::problem::Scene;

    /// The derivative of the state with the declared values.
    pub fn rate<C: Scene + Default>(time: f64, state: &[f64]) -> Vec<f64> {
        rate_of(&C::default(), time, state)
    }

    /// The derivative of the state.
    pub fn rate_of<C: Scene>(scene: &C, time: f64, state: &[f64]) -> Vec<f64> {
        let model: &dyn Model = &Bound::new(scene);
        model.rates(time, state)
    }

    /// The outputs with the declared values.
    pub fn outputs<C: Scene + Default>(time: f64, state: &[f64]) -> Vec<f64> {
        let model: &dyn Model = &Bound::new(&C::default());
        model.outputs(time, state)
    }

    /// Names of the states.
    pub fn names<C: Scene + Default>() -> Vec<&'static str> {
        C::default().shape().states.iter().map(|state| state.name).collect()
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
