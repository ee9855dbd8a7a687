//! The method that carries a motion from one event to the next.

use crate::hybrid::event::watch::Watch;
use crate::model::Flow;
use crate::ode::{self, Observer, OdeError, Options, Statistics};
use crate::settings::Settings;
use crate::stiff::{self, Switch};
use crate::taylor::Taylor;

/// A method with its memory. A stiff one, and the automatic choice, keep it from event to event, and what they have found
/// out about the stiffness with it.
pub(in crate::hybrid) enum Carrier {
    Explicit(ode::Workspace),
    Taylor(Taylor),
    Stiff(Box<stiff::Workspace>),
}

impl Carrier {
    /// Room for the states of a motion.
    pub fn new(flow: &Flow<'_>, settings: &Settings) -> Self {
        let method = settings.method;
        match (method.explicit(), method.stiff()) {
            (Some(method), _) => Self::Explicit(ode::Workspace::new(method, flow)),
            (_, Some(method)) => Self::Stiff(Box::new(stiff::Workspace::new(method, flow))),
            _ => Self::Taylor(Taylor::new(flow.states(), settings.rtol)),
        }
    }

    /// Integrates what is watched until the end, or until the watch has enough.
    pub fn carry(
        &mut self,
        times: (f64, f64),
        start: &[f64],
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Statistics, OdeError> {
        let flow = watch.flow;
        let observe: &mut dyn Observer = watch;
        match self {
            Self::Explicit(memory) => ode::integrate(flow, times, start, options, memory, observe),
            Self::Taylor(memory) => memory.integrate(flow, times, start, options, observe),
            Self::Stiff(memory) => stiff::integrate(flow, times, start, options, memory, observe),
        }
    }

    /// Where an automatic choice changed the method in the last integration.
    pub fn switches(&self) -> &[Switch] {
        match self {
            Self::Stiff(memory) => memory.switches(),
            _ => &[],
        }
    }
}
