//! Equations.
