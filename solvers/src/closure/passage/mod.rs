//! The way to a position where one step is not certain to keep the modes.
//!
//! | file | what it does |
//! |---|---|
//! | `continuation`, `crossing`, `meeting`, `stand` | small steps, and where modes meet |
//! | `undetermined` | what has no value there |
//! | `arc`, `turn` | dead points, and passing through them by the length of the curve of positions |

pub(super) mod arc;
pub(super) mod continuation;
pub(super) mod crossing;
pub(super) mod meeting;
pub(super) mod stand;
pub(super) mod turn;
pub(super) mod undetermined;
