//! Linkages: loops closed, their derivatives, their assembly modes.

mod carried;
mod extremes;
mod misprints;
mod reference;
