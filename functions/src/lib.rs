//! Functions of the language that the standard library does not have, on `f64`.
//!
//! The evaluator of the language and the numbers of the solvers may not know each other, and one program has to give the
//! same numbers in both: so both take them from here.

mod error_function;

pub use error_function::{erf, normal_cdf};
