//! Explicit methods with control of the step size and continuous output.
//!
//! [`integrate`] carries any [`System`] over a stretch of time, forwards or backwards, by a method ([`Explicit`]); what
//! happens with the steps is up to an [`Observer`]. All its memory is the [`Workspace`]. Of a scene all stages of a step are
//! one call, compiled for it; everything around them is compiled once.
//! A motion that is kept is a [`Trajectory`]; [`march`](crate::smooth::march) finds that of a scene.
//!
//! The control follows E. Hairer, S. P. Nørsett, G. Wanner: *Solving Ordinary Differential Equations I*, 2nd edition,
//! sections II.4 to II.6.

mod combine;
mod controller;
mod dop853;
mod doubt;
mod error;
mod explicit;
mod norm;
mod observer;
mod options;
pub(crate) mod step;
pub(crate) mod system;
mod tableau;
mod trajectory;
mod tsit5;
mod workspace;

pub(crate) use controller::Controller;
pub(crate) use doubt::Doubt;
pub use error::OdeError;
pub(crate) use explicit::Clock;
pub use explicit::{Statistics, integrate};
pub(crate) use norm::{first_bad, larger};
pub use observer::{Basis, Observer, Step};
pub use options::{AbsoluteTolerance, Options};
pub(crate) use options::{bad, bad_start};
pub use step::Room;
pub use system::System;
pub use tableau::{Explicit, Row, Tableau};
pub use trajectory::{Recorder, Switch, Trajectory};
pub use workspace::Workspace;
pub(crate) use workspace::{SHORTEST, time_evaluation};

#[cfg(test)]
mod tests;
