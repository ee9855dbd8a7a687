//! Motions: scenes that move by their equations of motion.
//!
//! | file | what it does |
//! |---|---|
//! | `case`, `solve` | a motion with its values, and how it is found |
//! | `found`, `curves`, `events`, `multipliers`, `rest` | what is said of it |
//! | `report` | all of that together |
//! | `table`, `json`, `csv` | how it is shown |
//! | `turn`, `unclosed`, `unfollowed` | periods and errors in words |

pub mod case;
pub mod csv;
pub mod curves;
pub mod events;
pub mod found;
pub mod json;
pub mod multipliers;
pub mod report;
pub mod rest;
pub mod solve;
pub mod table;
pub mod turn;
pub mod unclosed;
pub mod unfollowed;
