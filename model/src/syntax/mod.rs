//! What a file says: its tree, how it is read and how it is written.

pub mod parser;
pub mod print;
pub mod tree;
pub mod words;
