//! How large the terms are of which a guard is made.

use super::problem::Modes;
use crate::scalar::Scalar;

/// Relative change of what a guard depends on; large enough for the rounding of the difference.
const CHANGE: f64 = 1.0 / (1 << 20) as f64;

/// The terms of a guard and of its rate: `Σ |∂g/∂y · y|` over state and time. Their roundings are those of the guard,
/// however small it is itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Terms {
    pub value: f64,
    pub rate: f64,
}

/// The terms of the guards of a mode.
pub(super) fn terms<S: Scalar, E: Modes<S>>(
    equations: &E,
    time: f64,
    state: &E::State,
    count: usize,
) -> Vec<Terms> {
    let guards = |time: f64, state: &E::State| {
        let (mut values, mut rates) = (vec![S::ZERO; count], vec![S::ZERO; count]);
        let instant = equations.instant(S::from_f64(time));
        equations.guards(&instant, state, &mut values, &mut rates);
        let pairs = values.iter().zip(&rates);
        let pairs = pairs.map(|(value, rate)| (value.to_f64(), rate.to_f64()));
        pairs.collect::<Vec<(f64, f64)>>()
    };
    let here = guards(time, state);
    let mut all = vec![Terms::default(); count];
    let mut add = |there: Vec<(f64, f64)>| {
        for ((terms, here), there) in all.iter_mut().zip(&here).zip(&there) {
            terms.value += (there.0 - here.0).abs() / CHANGE;
            terms.rate += (there.1 - here.1).abs() / CHANGE;
        }
    };
    add(guards(time * (1.0 + CHANGE), state));
    for index in 0..equations.states() {
        let mut moved = state.clone();
        let slot = &mut moved.as_mut()[index];
        *slot = *slot * S::from_f64(1.0 + CHANGE);
        add(guards(time, &moved));
    }
    all
}
