//! Errors to first and second order, and when the second one matters.
//!
//! | file | what it finds |
//! |---|---|
//! | `influence`, [`linear`](fn@super::linear) | greatest error and deviation to first order, what each source contributes |
//! | `second` | the same to second order |
//! | [`corners`](fn@super::corners), [`differences`](fn@super::differences) | extremes, and what both orders miss |
//! | `variation`, `rounding` | derivatives by dual numbers; how far numbers may be off by rounding |

pub(super) mod corners;
pub(super) mod differences;
pub(super) mod influence;
pub(super) mod linear;
pub(super) mod rounding;
pub(super) mod second;
pub(super) mod variation;
