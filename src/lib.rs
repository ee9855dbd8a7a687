//! Assur.
