//! One degree of freedom: what two codes give, beside each other.

use assur::model::{Bound, Flow};
use assur::ode::{Explicit, Options, Workspace, integrate};
use assur::problem::Scene;

use crate::count::Measure;
use crate::hand_freedom::Run;
use crate::table::{Table, number, power, ratio, verdict};

/// A code with its name.
pub type Kind = (&'static str, fn() -> Run);

/// The emitted code by a method, to `end`.
#[inline(never)]
pub fn emitted<C: Scene>(scene: &C, method: Explicit, (end, rtol): (f64, f64)) -> Run {
    let bound = Bound::new(scene);
    let flow = Flow::new(&bound, 0);
    let options = Options::scaled(rtol, scene.shape().scales);
    let mut workspace = Workspace::new(method, &flow);
    let done = integrate(&flow, (0.0, end), &scene.start(), &options, &mut workspace, &mut ());
    let mut state = [f64::NAN; 2];
    state.copy_from_slice(workspace.state());
    Run { end: state, evaluations: done.map_or(0, |statistics| statistics.evaluations) }
}

/// The larger relative error of position and speed at the end.
pub fn error(run: &Run, exact: [f64; 2]) -> f64 {
    let pairs = run.end.iter().zip(exact);
    pairs.map(|(one, exact)| (one / exact - 1.0).abs()).fold(0.0, f64::max)
}

/// Prints codes with their work; the first is the yardstick.
pub fn print(title: &str, exact: [f64; 2], kinds: &[Kind], measures: &[Measure]) {
    let columns = [
        "code",
        "evaluations",
        "error",
        "instructions",
        "ratio",
        "per evaluation",
        "ratio",
        "time, us",
        "ratio",
    ];
    let mut table = Table::new(title, &columns);
    let each =
        |measure: &Measure, run: &Run| measure.instructions.map(|all| all / run.evaluations as f64);
    let first = kinds[0].1();
    for ((kind, code), one) in kinds.iter().zip(measures) {
        let run = code();
        table.row([
            (*kind).to_owned(),
            run.evaluations.to_string(),
            power(error(&run, exact)),
            number(one.instructions),
            ratio(one.instructions, measures[0].instructions),
            number(each(one, &run)),
            ratio(each(one, &run), each(&measures[0], &first)),
            number(one.microseconds()),
            one.over(&measures[0]),
        ]);
    }
    table.print();
}

/// Says whether the second code is as fast as a goal asks for.
pub fn judge(what: &str, measures: &[Measure], goal: f64) {
    let (hand, ours) = (&measures[0], &measures[1]);
    let title = |unit| format!("{what}, emitted / reduced by hand, {unit}");
    verdict(&title("instructions"), ours.instructions, hand.instructions, goal);
    verdict(&title("time"), ours.microseconds(), hand.microseconds(), goal);
}
