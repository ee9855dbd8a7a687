//! The golden files compile, and the tests that they contain pass.
#![allow(missing_docs, reason = "what is tested is the emitted code")]

#[rustfmt::skip]
#[path = "../src/golden/pendulum.rs"]
mod pendulum;

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
    include!("../src/golden/batten_elastic/elastic_reports.rs");
    include!("../src/golden/batten_elastic/shapes.rs");
}

/// The same of a motion with modes.
#[allow(
    clippy::all,
    rustdoc::all,
    non_snake_case,
    non_upper_case_globals,
    dead_code,
    unused_variables
)]
mod ball {
    include!("../src/golden/ball/fall.rs");
    include!("../src/golden/ball/fall_in_flight_equations.rs");
    include!("../src/golden/ball/fall_in_contact_equations.rs");
    include!("../src/golden/ball/fall_equations.rs");
    include!("../src/golden/ball/fall_reports.rs");
    include!("../src/golden/ball/fall_events.rs");
    include!("../src/golden/ball/shapes.rs");
}

/// The same of a linkage.
#[allow(
    clippy::all,
    rustdoc::all,
    non_snake_case,
    non_upper_case_globals,
    dead_code,
    unused_variables
)]
mod four_bar {
    include!("../src/golden/four_bar/turn.rs");
    include!("../src/golden/four_bar/turn_equations.rs");
    include!("../src/golden/four_bar/shapes.rs");
}
