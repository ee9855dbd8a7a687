//! Stiff motions as equation files: the oscillator of van der Pol and the kinetics of Robertson, against Radau written out for
//! each, and at equal achieved error.

use std::hint::black_box;

use assur::answer::{Method, Settings, Solve};
use assur::model::{Bound, Flow};
use assur::ode::Options;
use assur::problem::Scene;
use assur::shape::Subject;
use assur::stiff::{Implicit, Workspace, integrate};

use crate::count::{Case, measure};
use crate::equal::{Peer, Point, all_runs, at_error, peer, points};
use crate::hand_radau::{self, Run, System};
use crate::table::{Table, number, power, ratio, verdict};

assur::mechanism! {
    /// An oscillator that goes to and fro between two states, at once.
    VanDerPol from "Hairer, Wanner: Solving ordinary differential equations II, (IV.10.3)";
    parameter T = 1 s, epsilon = 1e-6;
    state x: 1 = 2, v: 1 = 0;
    motion T*dot(x) = v;
    motion epsilon*T*dot(v) = (1 - x^2)*v - x;
    output x, v;
    scene relaxation "a good period" { run time 0 s .. 2 s; }
}

mod kinetics {
    assur::mechanism! {
        /// Three reactions of very different speeds.
        Robertson from "Hairer, Wanner: Solving ordinary differential equations II, (IV.10.2)";
        parameter T = 1 s;
        state y1: 1 = 1, y2: 1 = 0, y3: 1 = 0;
        motion T*dot(y1) = -0.04*y1 + 1e4*y2*y3;
        motion T*dot(y2) = 0.04*y1 - 1e4*y2*y3 - 3e7*y2^2;
        motion T*dot(y3) = 3e7*y2^2;
        output y1, y2, y3;
        scene long "until nearly all has reacted" { run time 0 s .. 1e11 s; }
    }
}

/// A problem with `N` states: its scene, the same by hand, and its end from the IVP test set.
pub trait Problem<const N: usize>: System<N> + Default {
    type Scene: Scene + Clone + Default;
    const NAME: &'static str;
    const START: [f64; N];
    /// The end, and the first step of what is written by hand.
    const TIMES: (f64, f64);
    const EXACT: [f64; N];
    /// Absolute tolerances over the relative one.
    const SCALES: [f64; N];
    /// An achieved error at which times are compared.
    const ERRORS: [f64; 2];
}

/// The oscillator by hand.
#[derive(Default)]
pub struct Oscillator;

impl System<2> for Oscillator {
    #[inline(always)]
    fn rates(&self, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, ((1.0 - x * x) * v - x) * 1e6]
    }

    #[inline(always)]
    fn slopes(&self, [x, v]: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.0, 1.0], [(-2.0 * x * v - 1.0) * 1e6, (1.0 - x * x) * 1e6]]
    }
}

impl Problem<2> for Oscillator {
    type Scene = Relaxation;
    const NAME: &'static str = "van der Pol";
    const START: [f64; 2] = [2.0, 0.0];
    const TIMES: (f64, f64) = (2.0, 1e-6);
    const EXACT: [f64; 2] = [1.706_167_732_170_483, -0.892_809_701_024_797_5];
    const SCALES: [f64; 2] = [1.0; 2];
    const ERRORS: [f64; 2] = [1e-5, 1e-7];
}

/// The kinetics by hand.
#[derive(Default)]
pub struct Kinetics;

impl System<3> for Kinetics {
    #[inline(always)]
    fn rates(&self, y: &[f64; 3]) -> [f64; 3] {
        let (first, last) = (-0.04 * y[0] + 1e4 * y[1] * y[2], 3e7 * y[1] * y[1]);
        [first, -first - last, last]
    }

    #[inline(always)]
    fn slopes(&self, y: &[f64; 3]) -> [[f64; 3]; 3] {
        [
            [-0.04, 1e4 * y[2], 1e4 * y[1]],
            [0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1]],
            [0.0, 6e7 * y[1], 0.0],
        ]
    }
}

impl Problem<3> for Kinetics {
    type Scene = kinetics::Long;
    const NAME: &'static str = "Robertson";
    const START: [f64; 3] = [1.0, 0.0, 0.0];
    const TIMES: (f64, f64) = (1e11, 1e-6);
    const EXACT: [f64; 3] =
        [2.083_340_149_701_255e-8, 8.333_360_770_334_713e-14, 0.999_999_979_166_505];
    const SCALES: [f64; 3] = [1e-8, 1e-14, 1.0];
    const ERRORS: [f64; 2] = [1e-5, 1e-7];
}

/// The largest relative error at the end.
pub fn error<const N: usize, P: Problem<N>>(run: &Run<N>) -> f64 {
    let pairs = run.end.iter().zip(P::EXACT);
    pairs.map(|(one, exact)| (one / exact - 1.0).abs()).fold(0.0, f64::max)
}

/// By hand.
#[inline(never)]
fn by_hand<const N: usize, P: Problem<N>>(rtol: f64) -> Option<Run<N>> {
    let atol = P::SCALES.map(|scale| scale * rtol);
    hand_radau::run(&P::default(), P::TIMES, P::START, rtol, atol)
}

/// The stepper of Assur on emitted code; nothing is recorded.
#[inline(never)]
fn emitted<const N: usize, P: Problem<N>>(method: Implicit, rtol: f64) -> Option<Run<N>> {
    let scene = P::Scene::default();
    let bound = Bound::new(&scene);
    let flow = Flow::new(&bound, 0);
    let options = Options::scaled(rtol, &P::SCALES);
    let mut workspace = Workspace::new(method, &flow);
    let times = (0.0, P::TIMES.0);
    let done = integrate(&flow, times, &P::START, &options, &mut workspace, &mut ()).ok()?;
    let mut end = [0.0; N];
    end.copy_from_slice(workspace.state());
    Some(Run { end, evaluations: done.evaluations })
}

/// As a program asks for it, recorded.
#[inline(never)]
fn asked<const N: usize, P: Problem<N>>(rtol: f64) -> Option<Run<N>> {
    let atol = P::SCALES.map(|scale| Some(scale * rtol)).to_vec();
    let settings = Settings { atol, ..Settings::new(Method::Auto).rtol(rtol) };
    let motion = P::Scene::default().solve(&settings).ok()?;
    let place = motion.at(P::TIMES.0);
    let end = std::array::from_fn(|index| place[Subject::State(index)]);
    Some(Run { end, evaluations: motion.statistics().evaluations })
}

/// Everything that is compared, the hand-written code first.
fn kinds<const N: usize, P: Problem<N>>() -> [Peer<Run<N>>; 5] {
    [
        peer("hand-written", "radau", by_hand::<N, P>),
        peer("Assur, emitted", "radau", |rtol| emitted::<N, P>(Implicit::Radau, rtol)),
        peer("Assur, emitted", "rosenbrock", |rtol| emitted::<N, P>(Implicit::Rosenbrock, rtol)),
        peer("Assur, emitted", "auto", |rtol| emitted::<N, P>(Implicit::Automatic, rtol)),
        peer("Assur, as a program asks", "auto", asked::<N, P>),
    ]
}

/// Relative tolerance at which instructions are counted.
const RTOL: f64 = 1e-6;
/// Largest ratio of emitted code to the hand-written one, at equal error.
const GOAL: f64 = 1.1;

/// The methods of a problem at the tolerance of the workload.
fn cases_of<const N: usize, P: Problem<N>>(names: [&'static str; 5]) -> Vec<Case<'static>> {
    let kinds = names.into_iter().zip(kinds::<N, P>());
    let cases = kinds.map(|(name, kind)| {
        Case::new(name, 1, move || {
            black_box((kind.run)(black_box(RTOL)));
        })
    });
    cases.collect()
}

/// Everything that is measured.
pub fn cases() -> Vec<Case<'static>> {
    let oscillator = ["vdp-hand", "vdp-radau", "vdp-rosenbrock", "vdp-auto", "vdp-asked"];
    let kinetics = ["rob-hand", "rob-radau", "rob-rosenbrock", "rob-auto", "rob-asked"];
    let mut cases = cases_of::<2, Oscillator>(oscillator);
    cases.extend(cases_of::<3, Kinetics>(kinetics));
    cases
}

/// Measures and prints.
pub fn report() {
    let measures = measure("stiff", &mut cases(), 200);
    let (first, second) = measures.split_at(5);
    let columns =
        ["code", "method", "evaluations", "error", "instructions", "ratio", "time, us", "ratio"];
    for (which, title) in [(0, Oscillator::NAME), (1, Kinetics::NAME)] {
        let mut table = Table::new(&format!("{title}, rtol {RTOL:e}"), &columns);
        let measures = if which == 0 { first } else { second };
        let said = if which == 0 { told::<2, Oscillator>() } else { told::<3, Kinetics>() };
        for (([library, method], run), one) in said.iter().zip(measures) {
            let (evaluations, error) = run.map_or((None, f64::NAN), |run| (Some(run.0), run.1));
            table.row([
                (*library).to_owned(),
                (*method).to_owned(),
                number(evaluations.map(|count| count as f64)),
                power(error),
                number(one.instructions),
                ratio(one.instructions, measures[0].instructions),
                number(one.microseconds()),
                one.over(&measures[0]),
            ]);
        }
        table.print();
    }
    compared::<2, Oscillator>(Vec::new(), |_| ());
    compared::<3, Kinetics>(Vec::new(), |_| ());
}

/// Names, evaluations and errors of the methods at the tolerance of the workload.
type Told = Vec<([&'static str; 2], Option<(usize, f64)>)>;

fn told<const N: usize, P: Problem<N>>() -> Told {
    let said = |run: Run<N>| (run.evaluations, error::<N, P>(&run));
    kinds::<N, P>().map(|kind| ([kind.library, kind.method], (kind.run)(RTOL).map(said))).into()
}

/// Names of methods, and what each takes.
pub type Measured = (Vec<[&'static str; 2]>, Vec<Vec<Option<Point>>>);

/// Compares at equal error, with more methods behind ours: libraries, and what is measured elsewhere.
pub fn compared<const N: usize, P: Problem<N>>(
    more: Vec<Peer<Run<N>>>,
    elsewhere: impl FnOnce(&mut Measured),
) {
    let peers: Vec<_> = kinds::<N, P>().into_iter().chain(more).collect();
    let points = points(&peers, |run| (error::<N, P>(run), run.evaluations));
    let mut measured = (peers.iter().map(|peer| [peer.library, peer.method]).collect(), points);
    elsewhere(&mut measured);
    let (names, points) = measured;
    all_runs(&format!("{}, all runs", P::NAME), "error", &names, &points);
    for error in P::ERRORS {
        let title = format!("{}, time for a relative error of {error:e}", P::NAME);
        at_error(&title, error, &names, &points, [("hand-written", 0), ("Assur's radau", 1)]);
        let time = |index: usize| crate::equal::time_at(error, &points[index]);
        let ours = [1, 2, 3].into_iter().filter_map(time).reduce(f64::min);
        let what = format!("{}, best of Assur / hand-written, error {error:e}", P::NAME);
        verdict(&what, ours, time(0), GOAL);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const N: usize, P: Problem<N>>() {
        for kind in kinds::<N, P>() {
            let run = (kind.run)(1e-9).expect(kind.method);
            let error = error::<N, P>(&run);
            assert!(error < 1e-5, "{} {}: {error}", kind.library, kind.method);
        }
    }

    #[test]
    fn all_give_the_published_ends() {
        check::<2, Oscillator>();
        check::<3, Kinetics>();
    }
}
