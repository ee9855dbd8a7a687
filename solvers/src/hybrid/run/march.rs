//! The motion of a scene: what is asked for, by which method.

use super::carry::Carrier;
use super::start;
use crate::hybrid::error::HybridError;
use crate::hybrid::motion::Motion;
use crate::hybrid::run::Run;
use crate::model::{Bound, Flow, Model};
use crate::ode::{OdeError, Options, bad_start};
use crate::problem::Scene;
use crate::settings::Settings;
use crate::smooth;

/// The motion of a scene from a start, through all its events; in one piece where there are none.
///
/// # Errors
/// [`HybridError`], with the motion so far.
pub fn march<C: Scene>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    march_in(scene, scene.shape().first, times, start, settings)
}

/// The motion from event to event, from a start in any mode.
///
/// # Errors
/// [`HybridError`], with the motion so far.
pub fn march_in<C: Scene>(
    scene: &C,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    let way = Request { mode, times, start, settings, is_checked: true };
    way.of(&Bound::new(scene))
}

/// What is asked for.
pub(crate) struct Request<'a> {
    pub mode: usize,
    pub times: (f64, f64),
    pub start: &'a [f64],
    pub settings: &'a Settings,
    /// Whether the start has to fit to the mode.
    pub is_checked: bool,
}

impl Request<'_> {
    /// The motion of a model. A start that closures contradict is corrected if it is off by rounding.
    pub fn of(&self, model: &dyn Model) -> Result<Motion, HybridError> {
        let flow = Flow::new(model, self.mode.min(model.shape().modes.len().saturating_sub(1)));
        match start::closed(&flow, self.times.0, self.start)? {
            Some(start) => Request { start: &start, ..*self }.closed(model),
            None => self.closed(model),
        }
    }

    /// The motion from a start at which closures are closed.
    fn closed(&self, model: &dyn Model) -> Result<Motion, HybridError> {
        let (times, settings, shape) = (self.times, self.settings, model.shape());
        if model.events().is_none() {
            return self.smooth(model);
        }
        start::check_mode(shape, self.mode)?;
        let flow = Flow::new(model, self.mode);
        let mut motion = Motion { mode: self.mode, ..Motion::unbegun(times.0, self.start) };
        let options = Options::of(settings, shape.scales);
        if let Err(error) = self.check(&options, flow.states()) {
            return Err(HybridError::Ode { error, mode: self.mode, motion: Box::new(motion) });
        }
        if self.is_checked {
            start::check(&flow, times.0, self.start)?;
        }
        let mut carrier = Carrier::new(&flow, settings);
        let mut run = Run::new(flow, self.start.to_vec(), options, times);
        match run.through(&mut motion, &mut carrier) {
            Ok(()) => Ok(motion),
            Err(end) => Err(end.with(motion)),
        }
    }

    /// The motion of a model without events. One that ends early is followed once more, as far as it came.
    fn smooth(&self, model: &dyn Model) -> Result<Motion, HybridError> {
        let follow = |until: f64| {
            smooth::follow(model, (self.times.0, until), self.start, self.settings).map(Motion::of)
        };
        follow(self.times.1).map_err(|error| {
            let reached = error.time().filter(|time| *time != self.times.0 && time.is_finite());
            let motion = reached.and_then(|time| follow(time).ok());
            let motion = motion.unwrap_or_else(|| Motion::unbegun(self.times.0, self.start));
            HybridError::Ode { error, mode: 0, motion: Box::new(motion) }
        })
    }

    /// Whether what is asked for makes sense.
    fn check(&self, options: &Options, states: usize) -> Result<(), OdeError> {
        let times = self.times;
        options.check(times, states)?;
        if times.1 < times.0 {
            return Err(OdeError::BadOption {
                name: "times",
                reason: format!(
                    "from {} s to {} s runs backwards, and events happen forwards",
                    times.0, times.1
                ),
            });
        }
        match self.start.len() == states {
            true => Ok(()),
            false => Err(bad_start(self.start.len(), states)),
        }
    }
}
