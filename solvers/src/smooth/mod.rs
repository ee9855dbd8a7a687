//! The motion of a scene without events from a start, in one piece, by whichever method is asked for.

#[cfg(test)]
mod tests;

use crate::model::{Bound, Flow, Model};
use crate::ode::{Observer, OdeError, Options, Recorder, Trajectory, Workspace, integrate};
use crate::problem::Smooth;
use crate::settings::Settings;
use crate::stiff;
use crate::taylor::Taylor;

/// The motion of a scene without events from a start. Where the settings give no absolute tolerances they are `rtol` times
/// the scales of the shape.
///
/// # Errors
/// [`OdeError`], with the time that was reached.
pub fn march<C: Smooth>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Trajectory, OdeError> {
    follow(&Bound::new(scene), times, start, settings)
}

/// [`march`] of a model behind a pointer; events that it has are not seen.
pub(crate) fn follow(
    model: &dyn Model,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Trajectory, OdeError> {
    let (flow, shape) = (Flow::new(model, 0), model.shape());
    let options = Options::of(settings, shape.scales);
    if let Some(method) = settings.method.stiff() {
        return stiff::record(&flow, times, start, &options, method);
    }
    let mut recorder = Recorder::new(times.0, start);
    let statistics = match settings.method.explicit() {
        Some(method) => {
            let mut workspace = Workspace::new(method, &flow);
            let observe: &mut dyn Observer = &mut recorder;
            integrate(&flow, times, start, &options, &mut workspace, observe)?
        }
        None => {
            let mut taylor = Taylor::new(shape.states.len(), options.rtol);
            taylor.integrate(&flow, times, start, &options, &mut recorder)?
        }
    };
    Ok(recorder.finish(statistics))
}
