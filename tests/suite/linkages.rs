//! Linkages: loops closed, their derivatives, their assembly modes.

mod carried;
mod extremes;
mod groups;
mod misprints;
mod reference;
