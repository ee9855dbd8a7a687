//! Events within the steps of a mode.
//!
//! | file | what it does |
//! |---|---|
//! | `watch` | looks for events in every step, and ends the integration at the first one |
//! | `within` | the guards within a step: where they bend, and where they pass zero |
//! | `crossing` | the first zero of a guard between two points |
//! | `narrow` | that zero to the last bits |
//! | `cubic` | the cubic through two points |
//! | `guard` | what is remembered of a guard from step to step |
//! | `rounding` | how large the terms are of which a guard is made |
//! | `room` | memory for the guards of a mode |

pub(super) mod crossing;
pub(super) mod cubic;
pub(super) mod guard;
pub(super) mod narrow;
pub(super) mod room;
pub(super) mod rounding;
pub(super) mod watch;
pub(super) mod within;
