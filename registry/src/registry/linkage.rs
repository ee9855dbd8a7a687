//! A linkage with its values, as whoever does not know its type has it.

use assur_solvers::closure::{AnyLinkage, Linkage};
use assur_solvers::problem::Refused;

/// Checks the values of a linkage.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind_linkage<L: Linkage>(linkage: L) -> Result<Box<dyn AnyLinkage>, Refused> {
    linkage.check()?;
    Ok(Box::new(linkage))
}
