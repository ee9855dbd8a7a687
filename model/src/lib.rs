//! The equation language of Assur: from text to a checked model to a straight line of operations.

pub mod checked;
pub mod diagnostic;
pub mod program;
pub mod structure;
pub mod token;
pub mod unroll;
/// The syntax of an equation file.
pub mod syntax {
    pub mod tree;
}
