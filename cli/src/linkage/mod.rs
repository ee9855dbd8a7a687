//! Linkages: scenes that are moved from outside, through positions of their drivers.
//!
//! | file | what it does |
//! |---|---|
//! | `case` | a linkage with its values, and what its task varies |
//! | `line`, `search` | the stations of a task, and where something is largest |
//! | `reach` | how far the drivers go, limit positions and strokes |
//! | `place`, `places` | what `--at` names, how many places `--places` wants |
//! | `influence`, `found` | influence coefficients, what is compared with published values |
//! | `rounding` | how far numbers may be off |
//! | `report` | all of that together |
//! | `table`, `json`, `csv` | how it is printed |
//! | `group`, `wording` | groups, errors and events in words |
//! | `undefined` | why an output of a formula sheet is no number |

pub mod case;
pub mod csv;
pub mod found;
pub mod group;
pub mod influence;
pub mod json;
pub mod line;
pub mod place;
mod places;

pub mod reach;
pub mod report;
pub mod round;
pub mod rounding;
pub mod search;
pub mod table;
mod undefined;
pub mod wording;
