//! Mechanisms as equation files: checked at compile time, solved by generic solvers.
//!
//! [`mechanism!`] turns equations into Rust, [`equations!`] whole files of them. The emitted types implement the
//! traits of [`problem`]; the algorithms are in the modules beside it. The macros refer to all of it as `::assur::…`, so
//! a user depends on this crate alone.
//!
//! The crate has no types of its own.

#[allow(unused_extern_crates, reason = "emitted code names the facade `::assur`")]
extern crate self as assur;

pub use assur_macros::{equations, mechanism};
pub use assur_registry::{check, registry, study};
#[doc(hidden)]
pub use assur_solvers::exact;
pub use assur_solvers::{
    answer, closure, dense, dispatch, hybrid, measure, model, periodic, problem, rest, scalar,
    series, shape, stiff, synthesis, tolerance,
};

/// The motion of a scene without events, and the explicit methods that it is found by.
pub mod ode {
    pub use assur_solvers::model::Varied;
    pub use assur_solvers::ode::*;
    pub use assur_solvers::smooth::march;
}

/// What most programs need: `use assur::prelude::*;`.
pub mod prelude {
    pub use assur_macros::{equations, mechanism};
    pub use assur_solvers::answer::{Method, Motion, Move, Settings, Solve};
    pub use assur_solvers::model::{Bound, Model};
    pub use assur_solvers::problem::{Equations, Phase, Reports, Scene, Smooth};
    pub use assur_solvers::scalar::Scalar;
}
