//! A motion by a stiff method.

use super::{Implicit, Workspace, integrate};
use crate::model::Flow;
use crate::ode::{OdeError, Options, Recorder, Trajectory};

/// The motion from a start.
///
/// # Errors
/// [`OdeError`], with the time that was reached.
pub(crate) fn record(
    flow: &Flow<'_>,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
    method: Implicit,
) -> Result<Trajectory, OdeError> {
    let mut workspace = Workspace::new(method, flow);
    let mut recorder = Recorder::new(times.0, start);
    let statistics = integrate(flow, times, start, options, &mut workspace, &mut recorder)?;
    let mut trajectory = recorder.finish(statistics);
    trajectory.switches = workspace.switches().to_vec();
    Ok(trajectory)
}
