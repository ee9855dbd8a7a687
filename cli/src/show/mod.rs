//! How what was found is shown: numbers with their units, tables, JSON, comma-separated values, files.

pub mod csv;
pub mod json;
pub mod measures;
pub mod number;
pub mod output;
pub mod page;
pub mod progress;
pub mod style;
pub mod text;
pub mod unit;
