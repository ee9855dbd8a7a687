//! Ten revolutions with DOP853, and the periodic motion: whole solves against a hand-written loop.

use std::hint::black_box;

use assur::answer::{Method, Settings};
use assur::dispatch::is_fused;
use assur::model::{Bound, Flow};
use assur::ode::{Explicit, Options, Workspace, integrate};
use assur::periodic;
use assur::problem::{Scene, Span};
use assur_equations::batten::Elastic;

use crate::count::{Case, measure, shortest};
use crate::hand::Batten;
use crate::hand_best;
use crate::hand_loop::{self, Run};
use crate::hand_system;
use crate::table::{Table, number, power, ratio, verdict};

/// Ten revolutions at 250 rpm, in seconds.
pub const END: f64 = 2.4;
/// Near the periodic motion.
pub const START: [f64; 6] =
    [0.0, -0.000_377_352_429_5, -0.000_376_442_960_1, 0.080_250_353_39, 0.0, 0.0];
/// Absolute tolerance per unit of the relative one, that of the emitted code too.
pub const SCALE: f64 = 1e-3;
/// Relative tolerance of the comparison.
const RTOL: f64 = 1e-9;
/// Relative tolerance of the reference.
const REFERENCE_RTOL: f64 = 1e-14;
/// Natural frequency of the ends of the bar, rad/s, which turns errors of speeds into errors of deflections.
const FREQUENCY: f64 = 314.0;
/// Largest ratio of the emitted code to the hand-written loop.
const GOAL: f64 = 1.1;

/// Ten revolutions of a scene of the batten with a stepper of Assur.
pub fn stepped<C: Scene>(scene: &C, method: Explicit, rtol: f64) -> Run {
    let bound = Bound::new(scene);
    let flow = Flow::new(&bound, 0);
    let options = Options::scaled(rtol, scene.shape().scales);
    let mut workspace = Workspace::new(method, &flow);
    let times = (0.0, END);
    let statistics = integrate(&flow, times, &START, &options, &mut workspace, &mut ());
    let mut end = [f64::NAN; 6];
    end.copy_from_slice(workspace.state());
    Run { end, evaluations: statistics.map_or(0, |statistics| statistics.evaluations) }
}

/// Ten revolutions of the emitted code.
#[inline(never)]
pub fn emitted(method: Explicit, rtol: f64) -> Run {
    stepped(&Elastic::default(), method, rtol)
}

#[inline(never)]
fn hand<const KERNEL: bool>(rtol: f64) -> Run {
    hand_loop::run::<KERNEL>(&Batten::default(), END, START, rtol, SCALE)
}

/// The best that is written by hand.
#[inline(never)]
fn best(rtol: f64) -> Run {
    hand_best::run(&Batten::default(), END, START, rtol, SCALE)
}

/// The periodic motion as a program asks for it.
fn periodic_motion() -> periodic::Orbit {
    let scene = Elastic::default();
    let Span::Periodic(period) = scene.span() else {
        panic!("the scene is not periodic");
    };
    let settings = Settings::new(Method::Dop853).rtol(RTOL);
    periodic::solve(&scene, period, &settings).expect("the batten has a periodic motion")
}

/// The state at the end, far more accurate than what is compared with it.
pub fn reference() -> [f64; 6] {
    emitted(Explicit::Dop853, REFERENCE_RTOL).end
}

/// Error of the deflections of the bar at the end, in metres.
///
/// It is the amplitude of the vibration by which a motion is wrong, from deflection and speed: the deflection alone
/// passes through zero now and then, and a bad motion would look good.
pub fn error(end: &[f64; 6], reference: &[f64; 6]) -> f64 {
    let amplitude = |w: usize| {
        let speed = (end[w + 3] - reference[w + 3]) / FREQUENCY;
        (end[w] - reference[w]).hypot(speed)
    };
    amplitude(1).max(amplitude(2))
}

/// An integration at a relative tolerance, with its name.
type Kind = (&'static str, fn(f64) -> Run);

/// All integrations.
const KINDS: [Kind; 5] = [
    ("hand, sine of std", hand::<false>),
    ("hand, sine of Assur", hand::<true>),
    ("hand-written equations, Assur's stepper", |rtol| hand_system::run(Explicit::Dop853, rtol)),
    ("emitted", |rtol| emitted(Explicit::Dop853, rtol)),
    ("hand, fused, sines of a step packed", best),
];

/// Everything that is measured.
pub fn cases() -> Vec<Case<'static>> {
    let names = ["loop-std", "loop-kernel", "loop-stepper", "loop-emitted", "loop-best"];
    let loops = names.into_iter().zip(KINDS).map(|(name, (_, code))| {
        Case::new(name, 1, move || {
            black_box(code(black_box(RTOL)));
        })
    });
    let periodic = Case::new("periodic", 1, || {
        black_box(periodic_motion());
    });
    loops.chain([periodic]).collect()
}

/// Measures and prints.
pub fn report() {
    let measures = measure("revolutions", &mut cases(), 100);
    let reference = reference();
    let check = error(&hand::<false>(REFERENCE_RTOL).end, &reference);
    let columns = [
        "code",
        "evaluations",
        "error, m",
        "instructions",
        "ratio",
        "per evaluation",
        "time, us",
        "ratio",
    ];
    let mut table = Table::new("Ten revolutions with DOP853, rtol 1e-9", &columns);
    for ((kind, code), one) in KINDS.into_iter().zip(&measures) {
        let run = code(RTOL);
        let each = one.instructions.map(|all| all / run.evaluations as f64);
        table.row([
            kind.to_owned(),
            run.evaluations.to_string(),
            power(error(&run.end, &reference)),
            number(one.instructions),
            ratio(one.instructions, measures[1].instructions),
            number(each),
            number(one.microseconds()),
            one.over(&measures[1]),
        ]);
    }
    table.print();
    println!("Emitted and hand-written code differ by {check:.1e} m at rtol 1e-14.");
    let fused = if is_fused() { "fused" } else { "plain" };
    println!("The steps of Assur run on {fused} numbers here.\n");
    let plain = |get: fn(&crate::count::Measure) -> Option<f64>| {
        let [first, second] = [get(&measures[0])?, get(&measures[1])?];
        Some(first.min(second))
    };
    let time = plain(|one| one.microseconds());
    let count = plain(|one| one.instructions);
    let (ours, limit) = (&measures[3], &measures[4]);
    let name = |unit| format!("emitted / hand-written loop on plain numbers, {unit}");
    verdict(&name("instructions"), ours.instructions, count, GOAL);
    verdict(&name("time"), ours.microseconds(), time, GOAL);
    let title = |unit| format!("emitted / best hand-written loop, {unit}");
    verdict(&title("instructions"), ours.instructions, limit.instructions, GOAL);
    verdict(&title("time"), ours.microseconds(), limit.microseconds(), GOAL);

    let orbit = periodic_motion();
    let columns = ["periodic::solve", "instructions", "time, us"];
    let mut table = Table::new("The periodic motion with DOP853, rtol 1e-9", &columns);
    let one = &measures[5];
    table.row(["elastic batten".to_owned(), number(one.instructions), number(one.microseconds())]);
    table.print();
    let worst = orbit.estimated_error[1].max(orbit.estimated_error[2]);
    println!(
        "Residual {:.1e}, estimated error of the deflections {worst:.1e} m, condition {:.0}.",
        orbit.residual, orbit.condition
    );
}

/// Prints the shortest times of all integrations in microseconds, for `native.sh`.
pub fn brief() {
    let seconds = shortest(&mut cases(), 200);
    let times: Vec<String> = seconds.iter().map(|one| format!("{:.1}", one * 1e6)).collect();
    println!("{}", times.join(" "));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_loops_give_the_same_motion() {
        let reference = reference();
        for (kind, code) in KINDS {
            let run = code(RTOL);
            assert!(error(&run.end, &reference) < 1e-11, "{kind}: {run:?}");
            assert!(error(&code(1e-13).end, &reference) < 1e-14, "{kind}");
        }
    }
}
