//! How far a linkage goes.
//!
//! | file | what it does |
//! |---|---|
//! | `limits` | how far a driver can go |
//! | `walk`, `measures` | numbers of a whole way |
//! | `sampled` | quantities at places of it |
//! | `survey` | which of many linkages lose beside others, by few places |
//! | `facets`, `known`, `course` | how these change with the constants |
//! | `strokes`, `track`, `rates` | limit positions and strokes of outputs and dependent coordinates |
//! | `extremes`, `breaks`, `noise`, `root` | where a function turns round, jumps, or goes beyond all bounds |

pub(super) mod breaks;
pub(super) mod course;
pub(super) mod extremes;
pub(super) mod facets;
pub(super) mod known;
pub(super) mod limits;
pub(super) mod measures;
pub(super) mod noise;
pub(super) mod rates;
pub(super) mod root;
pub(super) mod sampled;
pub(super) mod strokes;
pub(super) mod survey;
pub(super) mod track;
pub(super) mod walk;
