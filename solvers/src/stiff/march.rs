//! The motion of a scene by a stiff method.

use super::rates::{Emitted, Rates};
use super::{Method, Workspace, integrate};
use crate::ode::{OdeError, Options, Recorder, Trajectory};
use crate::problem::Scene;

/// The motion of a scene from a start.
///
/// # Errors
/// [`OdeError`], with the time that was reached.
#[inline(never)]
pub(crate) fn march<C: Scene>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
    method: Method,
) -> Result<Trajectory, OdeError> {
    let equations = scene.prepare::<f64>();
    record(&mut Emitted::new(&equations), times, start, options, method)
}

/// The motion from a start.
pub(super) fn record(
    rates: &mut dyn Rates,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
    method: Method,
) -> Result<Trajectory, OdeError> {
    let mut workspace = Workspace::new(method, rates);
    let mut recorder = Recorder::<f64>::new(times.0, &start.to_vec());
    let statistics = integrate(rates, times, start, options, &mut workspace, &mut recorder)?;
    let mut trajectory = recorder.finish(statistics);
    trajectory.switches = workspace.switches().to_vec();
    Ok(trajectory)
}
