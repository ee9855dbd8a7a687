//! Equation files run without compiling them: the same traits and the same entries of a registry as emitted code.
//!
//! | module | what it is |
//! |---|---|
//! | [`code`] | a function of a program as instructions on registers |
//! | [`machine`] | the loop that runs them, on numbers of any kind |
//! | [`scene`] | a scene with its values, as the solvers ask for it |
//! | [`mechanism`](fn@mechanism) | a checked model as a mechanism of the registry |
//! | [`tests`](fn@tests) | the tests that the compiler generates from a model |

pub mod code;
pub mod machine;
mod mechanism;
mod read;
pub mod scene;
mod shape;
mod tests;

pub use mechanism::{Origin, mechanism};
pub use read::again;
pub use tests::{Test, tests};
