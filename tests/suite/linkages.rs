//! Linkages: loops closed, their derivatives, their assembly modes.

mod misprints;
mod reference;
