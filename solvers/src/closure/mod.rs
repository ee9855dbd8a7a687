//! Positions of a linkage: its loops closed.
//!
//! | folder | what it finds |
//! |---|---|
//! | `linkage` | nothing: what is asked of a linkage, [`Linkage`], and the same behind a pointer, [`AnyLinkage`] |
//! | `position` | positions: put together and moved by certain steps, [`Assembly`], [`sweep`] |
//! | `passage` | the way where a step is not certain to keep the modes, and through dead points |
//! | `extent` | how far drivers go, limit positions and strokes of outputs |
//! | `modes` | all assembly modes at one position |

mod error;
mod extent;
mod linkage;
mod modes;
mod passage;
mod position;
#[cfg(test)]
pub(crate) mod tests;

pub use crate::shape::{Group, GroupKind, Variable};
pub use error::ClosureError;
pub use extent::breaks::Break;
pub use extent::extremes::{Extreme, Limit};
pub use extent::facets::{Facet, Facets};
pub use extent::limits::{End, Stretch, stretch};
pub use extent::measures::Measured;
pub use extent::strokes::{Stroke, strokes};
#[doc(hidden)]
pub use extent::survey::Sides;
pub use extent::survey::losers;
pub use extent::track::Along;
pub use linkage::any::AnyLinkage;
#[doc(hidden)]
pub use linkage::any::Bounds;
pub(crate) use linkage::derivative::{duals, keep_closed};
#[doc(hidden)]
pub use linkage::loops::{Answers, Apart, Loops, Square, Trials};
pub use linkage::problem::{Closure, Linkage, Range};
pub use modes::listing::{Listed, Listing};
pub use modes::{AssemblyMode, AssemblyModes, Search, modes};
pub use position::assembly::{Assembly, Event};
#[doc(hidden)]
pub use position::guide::Guide;
pub(crate) use position::guide::Moves;
pub(crate) use position::newton::Newton;
pub use position::path::{Path, Sample};
pub use position::positions::Positions;
pub use position::start::{Contradiction, Start};
pub use position::sweep::{AtDeadPoint, Axis, sweep};
