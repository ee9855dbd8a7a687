//! How large the terms are of which a guard is made.

use super::room::Guards;
use crate::hybrid::numbers::Numbers;
use crate::model::Flow;

/// Relative change of what a guard depends on; large enough for the rounding of the difference.
const CHANGE: f64 = 1.0 / (1 << 20) as f64;

/// The terms of the guards of a mode and of their rates: `Σ |∂g/∂y · y|` over state and time. Their roundings are those
/// of a guard, however small it is itself. `here` are the guards at this time and state, `there` is room for others.
pub(in crate::hybrid) fn terms(
    flow: &Flow<'_>,
    time: f64,
    state: &[f64],
    here: &Guards,
    there: &mut Guards,
    terms: &mut Guards,
) {
    terms.clear();
    let mut add = |time: f64, state: &[f64]| {
        there.look(flow, time, state);
        let add = |terms: &mut [f64], here: &[f64], there: &[f64]| {
            for ((term, here), there) in terms.iter_mut().zip(here).zip(there) {
                *term += (there - here).abs() / CHANGE;
            }
        };
        let (values, rates) = terms.both_mut();
        add(values, here.values(), there.values());
        add(rates, here.rates(), there.rates());
    };
    add(time * (1.0 + CHANGE), state);
    let mut moved = Numbers::new(state);
    for (index, value) in state.iter().enumerate() {
        moved.as_mut()[index] = value * (1.0 + CHANGE);
        add(time, &moved);
        moved.as_mut()[index] = *value;
    }
}
