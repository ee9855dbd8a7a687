//! Linkages: loops closed, their derivatives, their assembly modes.

mod carried;
mod misprints;
mod reference;
