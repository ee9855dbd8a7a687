//! The golden files compile, and the tests that they contain pass.
#![allow(missing_docs, reason = "what is tested is the emitted code")]

#[rustfmt::skip]
#[path = "../src/golden/batten_elastic.rs"]
mod batten_elastic;
#[rustfmt::skip]
#[path = "../src/golden/pendulum.rs"]
mod pendulum;
