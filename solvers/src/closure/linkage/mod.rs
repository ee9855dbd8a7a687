//! A linkage as it is asked for, and behind a pointer.
//!
//! | file | what it is |
//! |---|---|
//! | `problem` | what is asked of a linkage: [`Closure`](super::Closure), [`Linkage`](super::Linkage) |
//! | `any`, `loops` | [`AnyLinkage`](super::AnyLinkage): a linkage and its loops behind a pointer, for what is compiled once for all |
//! | `derivative` | closed positions of neighbouring linkages, by dual numbers |

pub(super) mod any;
pub(super) mod derivative;
pub(super) mod loops;
pub(super) mod problem;
