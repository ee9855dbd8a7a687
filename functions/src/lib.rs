//! Functions of the language that the standard library does not have, on `f64`: of numbers, and of functions, as the mean over a
//! range, the root in it and the largest value; and of points, as the curve through them.
//!
//! The evaluator of the language and the numbers of the solvers may not know each other, and one program has to give the
//! same numbers in both: so both take them from here.

mod error_function;
pub mod fault;
mod hill;
mod mean;
mod root;
pub mod table;

pub use error_function::{erf, normal_cdf};
pub use hill::{Sense, Top, highest, top};
pub use mean::{End, Mean, MeanFault, POINTS, Part, mean};
pub use root::{Root, root, sign_changes};
pub use table::{Ends, Spline, Table, TableFault};
