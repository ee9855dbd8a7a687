//! Explicit methods with control of the step size and continuous output.
//!
//! [`integrate`] carries any [`System`] over a stretch of time, forwards or backwards; the method is a type
//! ([`Tsit5`], [`Dop853`]), what happens with the steps is up to an [`Observer`]. All its memory is the [`Workspace`].
//! [`march`] is the usual task: the motion of a scene from a start, kept as a [`Trajectory`], also by its Taylor series.
//!
//! The control follows E. Hairer, S. P. Nørsett, G. Wanner: *Solving Ordinary Differential Equations I*, 2nd edition,
//! sections II.4 to II.6.

mod combine;
mod controller;
mod dop853;
mod doubt;
mod error;
mod explicit;
mod march;
mod norm;
mod observer;
mod options;
mod sweep;
mod system;
mod tableau;
mod taylor;
mod trajectory;
mod tsit5;
mod workspace;

pub(crate) use controller::Controller;
pub use dop853::Dop853;
pub use error::OdeError;
pub(crate) use explicit::Clock;
pub use explicit::{Statistics, integrate};
pub(crate) use march::{bad_start, march_called, state_from};
pub use march::{march, march_on};
pub use observer::{Basis, Observer, Step};
pub use options::{AbsoluteTolerance, Options};
pub use system::{Bundle, Plain, System, Varied};
pub use tableau::{Method, Row};
pub(crate) use taylor::{Expand, Taylor};
pub use trajectory::{Recorder, Trajectory};
pub use tsit5::Tsit5;
pub(crate) use workspace::SHORTEST;
pub use workspace::Workspace;

#[cfg(test)]
mod tests;
