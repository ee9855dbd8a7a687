//! The figure of a run: panels of curves over one cycle, chosen from the data of the scene alone.

mod across;
mod axis;
mod cluster;
mod column;
mod curve;
mod figure;
mod kind;
mod legend;
mod linkage;
mod marks;
mod motion;
mod name;
mod panels;
mod scale;
mod selection;
mod svg;

pub use linkage::draw as draw_linkage;
pub use motion::draw;
pub use selection::Selection;
