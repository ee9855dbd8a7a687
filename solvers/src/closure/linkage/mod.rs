//! A linkage as it is asked for, and behind a pointer.
//!
//! | file | what it is |
//! |---|---|
//! | `problem` | what is asked of a linkage: [`Closure`](super::Closure), [`Linkage`](super::Linkage) |
//! | `any`, `loops` | [`AnyLinkage`](super::AnyLinkage): a linkage and its loops behind a pointer, for what is compiled once for all |

pub(super) mod any;
pub(super) mod loops;
pub(super) mod problem;
