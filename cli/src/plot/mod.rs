//! The figure of a run: panels of curves over one cycle, chosen from the data of the scene alone.

mod across;
pub mod axis;
mod bands;
mod cluster;
mod coefficients;
mod column;
mod contour;
mod contributions;
pub mod curve;
mod decades;
pub mod figure;
mod kind;
mod labels;
pub mod legend;
mod linkage;
mod marks;
mod motion;
pub mod name;
mod panels;
mod scale;
mod selection;
mod study;
pub mod svg;

pub use contributions::{Band, Chart, contributions};
pub use decades::{Decades, Line, decades};
pub use linkage::draw as draw_linkage;
pub use motion::draw;
pub use selection::Selection;
pub use study::{Layer, Map, Sheet, sheets};
