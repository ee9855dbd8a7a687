//! The figure of a run: panels of curves over one cycle, chosen from the data of the scene alone.

mod axis;
mod curve;
mod figure;
mod kind;
mod marks;
mod name;
mod panels;
mod scale;
mod svg;

pub use figure::draw;
