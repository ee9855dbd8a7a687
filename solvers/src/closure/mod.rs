//! Positions of a linkage: its loops closed.
//!
//! | file | what it does |
//! |---|---|
//! | [`problem`](self) | what is asked of a linkage: [`Closure`], [`Linkage`] |
//! | `any`, `loops` | [`AnyLinkage`]: a linkage and its loops behind a pointer, for what is compiled once for all |
//! | `newton`, `scaled` | one group that has no closed form |
//! | `assembly`, `step` | [`Assembly`]: all groups in their modes, moved by one certain step |
//! | `guide`, `start`, `nearest`, `predict` | the same whichever linkage it is: put together, groups iterated |
//! | `continuation`, `crossing`, `meeting`, `stand` | the same where a step is not certain to keep the modes |
//! | `undetermined` | what has no value where modes meet |
//! | `arc`, `turn` | dead points, and passing through them by the length of the curve of positions |
//! | `sweep`, `positions` | positions over a grid |
//! | `limits` | how far a driver can go |
//! | `strokes`, `track`, `rates` | limit positions and strokes of outputs and dependent coordinates |
//! | `extremes`, `breaks`, `noise` | where a function turns round, jumps, or goes beyond all bounds |
//! | `modes`, `branch` | all assembly modes at one position |
//! | `path`, `listing` | the same of any linkage, with all that it amounts to |

mod any;
mod arc;
mod assembly;
mod branch;
mod breaks;
mod continuation;
mod crossing;
mod error;
mod extremes;
mod guide;
mod limits;
mod listing;
mod loops;
mod meeting;
mod modes;
mod nearest;
mod newton;
mod noise;
mod path;
mod positions;
mod predict;
mod problem;
mod rates;
mod root;
mod scaled;
mod stand;
mod start;
mod step;
mod strokes;
mod sweep;
#[cfg(test)]
mod tests;
mod track;
mod turn;
mod undetermined;

pub use crate::shape::{Group, GroupKind, Variable};
pub use any::AnyLinkage;
pub use assembly::{Assembly, Event};
pub use breaks::Break;
pub use error::ClosureError;
pub use extremes::{Extreme, Limit};
#[doc(hidden)]
pub use guide::Guide;
pub(crate) use guide::Moves;
pub use limits::{End, Stretch, stretch};
pub use listing::{Listed, Listing};
pub(crate) use loops::Loops;
#[doc(hidden)]
pub use loops::{Answers, Apart, Square, instant_at};
pub use modes::{Mode, Modes, Search, modes};
pub(crate) use newton::Newton;
pub use path::{Path, Sample};
pub use positions::Positions;
pub use problem::{Closure, Linkage, Range};
pub use start::{Contradiction, Start};
pub use strokes::{Stroke, strokes};
pub use sweep::{AtDeadPoint, Axis, sweep};
pub use track::Along;
