//! Methods for stiff motions: parts that are much stiffer, or lighter, than the motion of interest asks for.
//!
//! An explicit method follows the fastest oscillation or decay that the equations know even where nothing of it is left:
//! its steps stay below a few `1/|λ|`. The methods here solve linear systems with the emitted Jacobian in every step, and
//! their steps follow the accuracy alone.
//!
//! | file | what it does |
//! |---|---|
//! | `stepper` | the loop over the steps |
//! | `radau` | Radau IIA of order 5 with simplified Newton iteration |
//! | `rosenbrock` | Rodas5P of order 5, without iteration |
//! | `automatic`, `spectrum` | the choice between the explicit method, the Taylor series and Radau, while the motion goes on |
//! | `march` | a motion from its start |
//!
//! They drive the same [`Observer`] as the explicit methods and give the continuous solution in the same basis, so that
//! trajectories and events do not know which method it was. They run on `f64`.
//!
//! **Which one.** Radau at the same tolerance errs ten to a hundred times less than Rodas5P, and where stiff springs hold masses
//! Rodas5P takes many times as many steps. It is for parts of first order, and where the Jacobian is cheap. The automatic choice
//! costs little where nothing is stiff.
//!
//! **What stiffness is not.** A fast oscillation whose amplitude exceeds the tolerance is motion: every method has to
//! follow it, and the explicit one does so best. One below the tolerance is damped by both stiff methods.
//!
//! **What stiffness costs.** Where `h λ` is large, the order falls: on the problem of Prothero and Robinson both methods
//! have order 3 in `h`, beside the small factor `1/λ` (`tests/orders.rs` measures it).

mod automatic;
mod here;
mod march;
mod radau;
mod rosenbrock;
mod rounding;
mod spectrum;
mod stepper;

pub use crate::ode::Switch;
pub(crate) use march::record;

use crate::model::Flow;
use crate::ode::{Observer, OdeError, Options, Statistics, bad_start, first_bad};
use crate::settings;
use automatic::Automatic;
use here::Here;
use radau::Radau;
use rosenbrock::Rosenbrock;
use stepper::drive;

/// A method for stiff motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Implicit {
    /// Radau IIA of order 5.
    Radau,
    /// The Rosenbrock method Rodas5P of order 5.
    Rosenbrock,
    /// Dormand–Prince 8(5,3), the Taylor series where that is faster, Radau where the motion is stiff.
    Automatic,
}

/// The memory of an integration. Nothing but it is allocated.
pub struct Workspace {
    here: Here,
    method: Chosen,
}

/// The memory of a method.
enum Chosen {
    Radau(Radau),
    Rosenbrock(Rosenbrock),
    Automatic(Box<Automatic>),
}

impl Workspace {
    /// Room for the states of a system.
    pub fn new(method: Implicit, flow: &Flow<'_>) -> Self {
        let states = flow.states();
        let (method, degree) = match method {
            Implicit::Radau => (Chosen::Radau(Radau::new(states)), Radau::DEGREE),
            Implicit::Rosenbrock => {
                (Chosen::Rosenbrock(Rosenbrock::new(states)), Rosenbrock::DEGREE)
            }
            Implicit::Automatic => {
                (Chosen::Automatic(Box::new(Automatic::new(flow))), Automatic::DEGREE)
            }
        };
        let here = Here::new(states, degree);
        Self { here, method }
    }

    /// The state where the last integration ended.
    pub fn state(&self) -> &[f64] {
        &self.here.state
    }

    /// What the last integration took, whether it ended well or not.
    pub fn statistics(&self) -> &Statistics {
        &self.here.statistics
    }

    /// Where the last integration changed the method.
    pub fn switches(&self) -> &[Switch] {
        match &self.method {
            Chosen::Automatic(automatic) => &automatic.switches,
            Chosen::Radau(_) | Chosen::Rosenbrock(_) => &[],
        }
    }
}

/// Integrates from one time to another, forwards or backwards. The end state is [`Workspace::state`].
///
/// # Errors
/// [`OdeError`], with the time that was reached.
pub fn integrate(
    flow: &Flow<'_>,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
    workspace: &mut Workspace,
    observe: &mut dyn Observer,
) -> Result<Statistics, OdeError> {
    let Workspace { here, method } = workspace;
    let states = here.state.len();
    options.check(times, states)?;
    if start.len() != states || flow.states() != states {
        return Err(bad_start(start.len(), states));
    }
    if let Some(component) = first_bad(start, states) {
        return Err(OdeError::BadOption {
            name: "start",
            reason: format!("state {component} is not a finite number"),
        });
    }
    here.state.copy_from_slice(start);
    match method {
        Chosen::Radau(radau) => drive(radau, flow, here, times, options, observe, None)?,
        Chosen::Rosenbrock(method) => drive(method, flow, here, times, options, observe, None)?,
        Chosen::Automatic(automatic) => {
            automatic.integrate(flow, here, times, options, observe)?;
        }
    }
    Ok(here.statistics)
}

impl settings::Method {
    /// The method among those that solve stiff motions; none if it is explicit.
    pub fn stiff(self) -> Option<Implicit> {
        match self {
            Self::Tsit5 | Self::Dop853 | Self::Taylor => None,
            Self::Radau => Some(Implicit::Radau),
            Self::Rosenbrock => Some(Implicit::Rosenbrock),
            Self::Auto => Some(Implicit::Automatic),
        }
    }
}

#[cfg(test)]
mod tests;
