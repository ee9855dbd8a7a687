//! What compiled scenes seek.
//!
//! | module | what it holds |
//! |---|---|
//! | [`follows`] | what follows from a condition follows as in the interpreter |
//! | [`rivals`] | a design that is judged beside a rival is the better one if it is so by itself |

mod follows;
mod rivals;
