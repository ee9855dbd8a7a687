//! Andrews' squeezing mechanism, 0.03 s: the equation file with its three loops against the mechanism reduced by hand.

use std::hint::black_box;

use assur::answer::{Method, Settings};
use assur::model::{Bound, Flow};
use assur::ode::{Explicit, Options, Workspace, integrate};
use assur::problem::Scene;
use assur::shape::Subject;
use assur_equations::andrews::Squeeze;

use crate::count::{Case, measure};
use crate::hand_freedom::Run;
use crate::hand_squeezer;
use crate::table::{Table, number, power, ratio, verdict};

/// End, in seconds.
const END: f64 = 0.03;
/// Relative tolerance of the comparison.
const RTOL: f64 = 1e-6;
/// Absolute tolerance per unit of the relative one, that of the emitted code too.
const SCALE: f64 = 1e-3;
/// The end, from the IVP test set.
const REFERENCE: [f64; 2] = [15.8107711951537, 1139.92030225911];
/// Largest ratio of the emitted code to the hand-written one.
const GOAL: f64 = 1.15;

/// The emitted code by a method.
#[inline(never)]
fn emitted(method: Explicit, rtol: f64) -> Run {
    let scene = Squeeze::default();
    let bound = Bound::new(&scene);
    let flow = Flow::new(&bound, 0);
    let options = Options::scaled(rtol, Squeeze::shape().scales);
    let mut workspace = Workspace::new(method, &flow);
    let done = integrate(&flow, (0.0, END), &scene.start(), &options, &mut workspace, &mut ());
    let mut end = [f64::NAN; 2];
    end.copy_from_slice(workspace.state());
    Run { end, evaluations: done.map_or(0, |statistics| statistics.evaluations) }
}

/// Relative error of the angle and the speed at the end.
fn error(run: &Run) -> f64 {
    let pairs = run.end.iter().zip(REFERENCE);
    pairs.map(|(one, exact)| (one / exact - 1.0).abs()).fold(0.0, f64::max)
}

/// The motion as a program asks for it, recorded.
fn asked() -> f64 {
    let settings = Settings::new(Method::Dop853).rtol(RTOL);
    let motion = assur::answer::Solve::solve(&Squeeze::default(), &settings);
    motion.map_or(f64::NAN, |motion| motion.at(END)[Subject::State(0)])
}

/// A code with its name.
type Kind = (&'static str, fn() -> Run);

const KINDS: [Kind; 3] = [
    ("reduced by hand, fused, DOP853", || hand_squeezer::run(END, RTOL, SCALE)),
    ("emitted, DOP853", || emitted(Explicit::Dop853, RTOL)),
    ("emitted, Tsit5", || emitted(Explicit::Tsit5, RTOL)),
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
    let columns = [
        "code",
        "evaluations",
        "error",
        "instructions",
        "ratio",
        "per evaluation",
        "time, us",
        "ratio",
    ];
    let mut table = Table::new("Andrews' squeezing mechanism to 0.03 s, rtol 1e-6", &columns);
    for ((kind, code), one) in KINDS.into_iter().zip(&measures) {
        let run = code();
        let each = one.instructions.map(|all| all / run.evaluations as f64);
        table.row([
            kind.to_owned(),
            run.evaluations.to_string(),
            power(error(&run)),
            number(one.instructions),
            ratio(one.instructions, measures[0].instructions),
            number(each),
            number(one.microseconds()),
            ratio(one.microseconds(), measures[0].microseconds()),
        ]);
    }
    table.print();
    let (ours, hand) = (&measures[1], &measures[0]);
    let title = |unit| format!("emitted / reduced by hand, {unit}");
    verdict(&title("instructions"), ours.instructions, hand.instructions, GOAL);
    verdict(&title("time"), ours.microseconds(), hand.microseconds(), GOAL);
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
        for run in [hand_squeezer::run(END, 1e-12, SCALE), emitted(Explicit::Dop853, 1e-12)] {
            assert!(error(&run) < 1e-10, "{run:?}");
        }
    }
}
