//! The golden files compile, and the tests that they contain pass.
#![allow(missing_docs, reason = "what is tested is the emitted code")]

#[rustfmt::skip]
#[path = "../src/golden/pendulum.rs"]
mod pendulum;

#[rustfmt::skip]
#[path = "../src/golden/ball.rs"]
mod ball;

#[rustfmt::skip]
#[path = "../src/golden/four_bar.rs"]
mod four_bar;

/// The pieces of one emitted module, which has the same attributes.
#[allow(
    clippy::all,
    rustdoc::all,
    non_snake_case,
    non_upper_case_globals,
    dead_code,
    unused_variables
)]
mod batten_elastic {
    include!("../src/golden/batten_elastic/elastic.rs");
    include!("../src/golden/batten_elastic/elastic_equations.rs");
    include!("../src/golden/batten_elastic/elastic_instant.rs");
    include!("../src/golden/batten_elastic/shapes.rs");
}
