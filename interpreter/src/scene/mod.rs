//! Scenes as the solvers ask for them.
//!
//! | file | what it is |
//! |---|---|
//! | `functions` | the functions of a program, each built when it is first called, and their prepared values |
//! | `motion` | a scene that moves by its equations: [`Scene`](assur_solvers::problem::Scene) |
//! | `equations`, `reports`, `events` | what it gives on numbers of any kind |
//! | `staged`, `products` | it for the stages of a step, with products of its Jacobian |
//! | `linkage`, `closure` | a linkage: [`Linkage`](assur_solvers::closure::Linkage) |
//! | `few`, `room` | room for numbers whose count the run knows |
//! | `values` | what depends on the values of the constants alone |

mod closure;
mod equations;
mod events;
mod few;
mod functions;
mod linkage;
mod motion;
mod products;
mod reports;
mod room;
mod staged;
mod values;

pub use linkage::{Loops, Moved};
pub use motion::{Motion, Moving};
