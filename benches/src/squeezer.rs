//! Andrews' squeezing mechanism, 0.03 s: the equation file with its three loops against the mechanism reduced by hand.

use std::hint::black_box;

use assur::answer::{Method, Settings};
use assur::ode::Explicit;
use assur::shape::Subject;
use assur_equations::andrews::Squeeze;

use crate::count::{Case, measure};
use crate::freedom::{self, Kind, emitted};
use crate::hand_squeezer;
use crate::table::number;

/// End, in seconds.
pub const END: f64 = 0.03;
/// Relative tolerance of the comparison.
const RTOL: f64 = 1e-6;
/// Absolute tolerance per unit of the relative one, that of the emitted code too.
pub const SCALE: f64 = 1e-3;
/// The end, from the IVP test set.
pub const REFERENCE: [f64; 2] = [15.8107711951537, 1139.92030225911];
/// Largest ratio of the emitted code to the hand-written one.
const GOAL: f64 = 1.15;

/// The motion as a program asks for it, recorded.
fn asked() -> f64 {
    let settings = Settings::new(Method::Dop853).rtol(RTOL);
    let motion = assur::answer::Solve::solve(&Squeeze::default(), &settings);
    motion.map_or(f64::NAN, |motion| motion.at(END)[Subject::State(0)])
}

const KINDS: [Kind; 3] = [
    ("reduced by hand, fused, DOP853", || hand_squeezer::run(END, RTOL, SCALE)),
    ("emitted, DOP853", || emitted(&Squeeze::default(), Explicit::Dop853, (END, RTOL))),
    ("emitted, Tsit5", || emitted(&Squeeze::default(), Explicit::Tsit5, (END, RTOL))),
];

/// Everything that is measured.
pub fn cases() -> Vec<Case<'static>> {
    let names = ["hand", "emitted", "tsit5"];
    let all = names.into_iter().zip(KINDS).map(|(name, (_, code))| {
        Case::new(name, 1, move || {
            black_box(code());
        })
    });
    let asked = Case::new("asked", 1, || {
        black_box(asked());
    });
    all.chain([asked]).collect()
}

/// Measures and prints.
pub fn report() {
    let measures = measure("squeezer", &mut cases(), 300);
    let title = "Andrews' squeezing mechanism to 0.03 s, rtol 1e-6";
    freedom::print(title, REFERENCE, &KINDS, &measures);
    freedom::judge("Andrews", &measures, GOAL);
    println!(
        "As a program asks for it, with set-up and record: {} us.",
        number(measures[3].microseconds())
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_give_the_published_end() {
        for run in [
            hand_squeezer::run(END, 1e-12, SCALE),
            emitted(&Squeeze::default(), Explicit::Dop853, (END, 1e-12)),
        ] {
            assert!(freedom::error(&run, REFERENCE) < 1e-10, "{run:?}");
        }
    }
}
