//! Positions: a linkage put together, and moved by certain steps.
//!
//! | file | what it does |
//! |---|---|
//! | `newton`, `scaled` | one group that has no closed form |
//! | `assembly`, `step` | [`Assembly`](super::Assembly): all groups in their modes, moved by one certain step |
//! | `guide`, `start`, `nearest`, `predict` | the same whichever linkage it is: put together, groups iterated |
//! | `sweep`, `positions` | positions over a grid |
//! | `path` | positions with all that they amount to |

pub(super) mod assembly;
pub(super) mod guide;
pub(super) mod nearest;
pub(super) mod newton;
pub(super) mod path;
pub(super) mod positions;
pub(super) mod predict;
pub(super) mod scaled;
pub(super) mod start;
pub(super) mod step;
pub(super) mod sweep;
