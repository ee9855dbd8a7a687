//! The motion of a scene from a start.

use super::dop853::Dop853;
use super::error::OdeError;
use super::explicit::integrate;
use super::options::Options;
use super::system::{Plain, System};
use super::tableau::Method;
use super::taylor::{Expand, Taylor};
use super::trajectory::{Recorder, Trajectory};
use super::tsit5::Tsit5;
use super::workspace::Workspace;
use crate::dispatch::{Task, dispatch};
use crate::problem::{Equations, Scene, Stages, Storage};
use crate::registry::{self, Settings};
use crate::scalar::Scalar;
use crate::stiff;

/// The motion of a scene from a start, on the scalar type that is fastest on the machine at hand. Where the settings
/// give no absolute tolerances they are `rtol` times the scales of the shape.
///
/// # Errors
/// [`OdeError`], with the time that was reached.
pub fn march<C: Scene>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Trajectory, OdeError> {
    dispatch(Marching {
        scene,
        times,
        start,
        settings,
    })
}

/// The task of [`march`].
struct Marching<'a, C> {
    /// The scene.
    scene: &'a C,
    /// Begin and end.
    times: (f64, f64),
    /// State at the begin.
    start: &'a [f64],
    /// The method and its accuracy.
    settings: &'a Settings,
}

impl<C: Scene> Task for Marching<'_, C> {
    type Output = Result<Trajectory, OdeError>;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Self::Output {
        march_on::<C, S>(self.scene, self.times, self.start, self.settings)
    }
}

/// The motion of a scene from a start, evaluated on a scalar type. Where the settings give no
/// absolute tolerances they are `rtol` times the scales of the shape.
///
/// # Errors
/// [`OdeError`], with the time that was reached.
#[inline(always)]
pub fn march_on<C: Scene, S: Scalar>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Trajectory, OdeError> {
    use registry::Method;
    if !matches!(settings.method, Method::Tsit5 | Method::Dop853) {
        // The others take no numbers but `f64`.
        return march_called(scene, times, start, settings);
    }
    let options = Options::of(settings, C::shape().scales);
    let equations = scene.prepare::<S>();
    let start = state_from::<S, _>(&equations, start)?;
    match settings.method {
        Method::Tsit5 => march_with::<S, _, Tsit5>(&equations, times, &start, &options),
        _ => march_with::<S, _, Dop853>(&equations, times, &start, &options),
    }
}

/// The motion of some equations from a start.
#[inline(always)]
pub(super) fn march_with<S: Scalar, E: Equations<S>, M: Method>(
    equations: &E,
    times: (f64, f64),
    start: &E::State,
    options: &Options,
) -> Result<Trajectory, OdeError> {
    march_system::<S, _, M>(&Plain(equations), times, start, options)
}

/// The motion of a system from a start.
#[inline(always)]
fn march_system<S: Scalar, Y: System<S>, M: Method>(
    system: &Y,
    times: (f64, f64),
    start: &Y::State,
    options: &Options,
) -> Result<Trajectory, OdeError>
where
    Y::State: Storage<S>,
{
    let mut workspace = Workspace::<Y::State, M>::new::<S, _>(system);
    let mut recorder = Recorder::<S>::new(times.0, start);
    let statistics = integrate(system, times, start, options, &mut workspace, &mut recorder)?;
    Ok(recorder.finish(statistics))
}

/// The same behind a pointer, on `f64`: what follows the motion is compiled once and not for each scene. So the command
/// runs the scenes of its registry.
pub(crate) fn march_called<C: Scene>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Trajectory, OdeError> {
    let options = Options::of(settings, C::shape().scales);
    if let Some(method) = settings.method.stiff() {
        return stiff::march(scene, times, start, &options, method);
    }
    let equations = scene.prepare::<f64>();
    let start = state_from::<f64, _>(&equations, start)?;
    let single = &Single(&equations);
    follow(single, times, start.as_ref(), settings.method, &options)
}

/// The motion of any equations.
fn follow(
    single: &dyn Called,
    times: (f64, f64),
    start: &[f64],
    method: registry::Method,
    options: &Options,
) -> Result<Trajectory, OdeError> {
    let begin = start.to_vec();
    let system = Behind {
        equations: single,
        states: start.len(),
    };
    match method {
        registry::Method::Taylor => march_by_series(single, times, start, options),
        registry::Method::Tsit5 => march_system::<f64, _, Tsit5>(&system, times, &begin, options),
        _ => march_system::<f64, _, Dop853>(&system, times, &begin, options),
    }
}

/// What is asked of equations behind a pointer.
trait Called: Expand {
    /// Evaluates all stages of a step.
    fn sweep(&self, times: &[f64], stages: &mut dyn Stages<f64>);
}

/// The same as a system.
struct Behind<'a> {
    equations: &'a dyn Called,
    states: usize,
}

impl System<f64> for Behind<'_> {
    type State = Vec<f64>;
    type Instant = f64;

    const CALLED: bool = true;

    fn zeros(&self) -> Vec<f64> {
        vec![0.0; self.states]
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [f64; K] {
        times
    }

    fn rate(&self, time: &f64, state: &Vec<f64>, rate: &mut Vec<f64>) {
        self.equations.rate(*time, state, rate);
    }

    fn sweep(&self, times: &[f64], stages: &mut dyn Stages<f64>) {
        self.equations.sweep(times, stages);
    }

    fn parts(_state: &Vec<f64>) -> usize {
        1
    }

    fn part(state: &Vec<f64>, _number: usize) -> &[f64] {
        state
    }

    fn part_mut(state: &mut Vec<f64>, _number: usize) -> &mut [f64] {
        state
    }
}

/// Equations that are asked through a pointer.
struct Single<'a, E>(&'a E);

impl<E: Equations<f64>> Called for Single<'_, E> {
    fn sweep(&self, times: &[f64], stages: &mut dyn Stages<f64>) {
        if self.0.sweep(times, stages) {
            return;
        }
        for (number, time) in times.iter().enumerate() {
            let (state, rate) = stages.next(number);
            self.rate(*time, state, rate);
        }
    }
}

impl<E: Equations<f64>> Expand for Single<'_, E> {
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let mut numbers = E::State::zeros(state.len());
        numbers.as_mut().copy_from_slice(state);
        let mut rates = E::State::zeros(state.len());
        let [instant] = self.0.instants([time]);
        self.0.derivative(&instant, &numbers, &mut rates);
        rate.copy_from_slice(rates.as_ref());
    }

    fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool {
        self.0.series(time, length, rows)
    }
}

/// The motion from a start by its Taylor series.
pub(super) fn march_by_series(
    expand: &dyn Expand,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
) -> Result<Trajectory, OdeError> {
    let start = start.to_vec();
    let mut recorder = Recorder::<f64>::new(times.0, &start);
    let mut taylor = Taylor::new(start.len(), options.rtol);
    let statistics = taylor.integrate(expand, times, &start, options, &mut recorder)?;
    Ok(recorder.finish(statistics))
}

/// A state of some equations from numbers.
pub(crate) fn state_from<S: Scalar, E: Equations<S>>(
    equations: &E,
    values: &[f64],
) -> Result<E::State, OdeError> {
    let states = equations.states();
    if values.len() != states {
        return Err(bad_start(values.len(), states));
    }
    let mut state = E::State::zeros(states);
    for (target, value) in state.as_mut().iter_mut().zip(values) {
        *target = S::from_f64(*value);
    }
    Ok(state)
}

/// The error for so many start values.
pub(crate) fn bad_start(values: usize, states: usize) -> OdeError {
    OdeError::BadOption {
        name: "start",
        reason: format!("{values} values are given for {states} states"),
    }
}
