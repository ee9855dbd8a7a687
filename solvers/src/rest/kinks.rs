//! Rest on a switching surface, where equations go over from one branch to another.

use super::error::RestError;
use super::place::Place;
use nalgebra::DVector;

/// Sides of a surface differ if a step does, over the scales of the states, by more than this.
const APART: f64 = 1e-9;
/// The same of their slopes, over the largest of these.
const BENT: f64 = 1e-9;

/// A surface on which the position lies and whose sides have other slopes; none where there is none.
///
/// # Errors
/// [`RestError::Sticks`] where even the rates differ: the mechanism rests on a stretch, as with dry friction.
pub fn at(place: &Place<'_>, state: &[f64], errors: &[f64]) -> Result<Option<usize>, RestError> {
    let Some(entry) = place.shape().modes.get(place.flow.mode()) else {
        return Ok(None);
    };
    let mut bent = None;
    for (index, event) in entry.events.iter().enumerate() {
        let Some(surface) = event.surface.filter(|_| is_on(place, index, state, errors)) else {
            continue;
        };
        let sides = [1.0, -1.0].map(|side| place.beside(surface, side));
        let residuals = sides.each_ref().map(|side| side.residual(state));
        let slopes = sides[0].slopes(state);
        let apart: DVector<f64> = &residuals[0] - &residuals[1];
        // Where one depends on nothing no step says so.
        let is_alone = slopes.check(&apart, place.names()).is_err();
        if is_alone || place.length(&slopes.solve(&apart)) > APART {
            return Err(RestError::Sticks { surface: event.text });
        }
        let jacobians = sides.each_ref().map(|side| side.jacobian(state));
        let size = jacobians[0].amax().max(jacobians[1].amax());
        if (&jacobians[0] - &jacobians[1]).amax() > BENT * size {
            bent = Some(index);
        }
    }
    Ok(bent)
}

/// Whether the guard of an event is zero, as far as the position is known.
fn is_on(place: &Place<'_>, event: usize, state: &[f64], errors: &[f64]) -> bool {
    let guard = |share: f64| {
        let aside: Vec<f64> =
            state.iter().zip(errors).map(|(y, error)| y + share * error).collect();
        place.flow.guard(event, 0.0, &aside).0
    };
    let here = guard(0.0);
    here == 0.0 || [1.0, -1.0].into_iter().any(|share| guard(share) * here <= 0.0)
}
