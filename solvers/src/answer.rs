//! Questions to a scene, and their answers: the front door for whoever fills in a scene.
//!
//! ```text
//! let motion = swing.run()?;                                     // its task, its start, the usual method
//! let motion = swing.solve(&Settings::new(Method::Taylor).rtol(1e-12))?;
//! let motion = swing.from([0.1, 0.0]).until(4.0).run()?;
//! motion.at(4.0)[Swing::PHI]; motion.value("pull", 4.0)?; motion.measure("F_max")?; motion.estimated_error("pull")?;
//! four_bar.sweep(0.0..=TAU, 361)?.output("theta")?;              // (driver, value)
//! four_bar.tolerance("theta").at("phi", 1.5).monte_carlo(100_000)?;
//! ```
//!
//! It does not matter to them whether a scene has modes, repeats, or stands still: there is one [`Question`] and one
//! [`Motion`].

mod changes;
mod error;
mod estimate;
mod extremes;
mod motion;
mod moved;
mod position;
mod question;
mod run;
mod status;

pub use crate::settings::{Method, Settings, UnknownMethod};
pub use error::Error;
pub use estimate::Estimate;
pub use extremes::{End, Ends, Samples};
pub use motion::{Motion, Repeats};
pub use moved::{Move, Sweep, Tolerance};
pub use position::Position;
pub use question::{Question, Solve};
pub use status::Status;
