//! Tests of positions against published numbers and closed forms, and the hard cases.

mod all_modes;
mod extremes;
mod facets;
mod hard;
pub(crate) mod linkages;
mod nearest;
mod published;
mod revolution;
