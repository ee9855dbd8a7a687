//! What no crate can test alone: equation file to emitted Rust to solver to number.
//!
//! | module | what it holds |
//! |---|---|
//! | [`boundaries`] | which package may know which |
//! | [`batten`] | a mechanism against an independent computation, closed forms, limits, energy |
//! | [`linkages`] | loops against an independent computation, and the misprints of a paper |
//! | [`hybrid`] | modes and events against closed forms |
//! | [`hard`] | cases in which the naive way fails, beside ours |

mod batten;
mod boundaries;
mod hard;
mod hybrid;
mod linkages;
mod measures;
mod solved;
