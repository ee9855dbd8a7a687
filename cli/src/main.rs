//! The command assur.
fn main() {}
