//! Motions with events: the presser foot, by the solvers and by hand.

use std::hint::black_box;

use assur::answer::{Method, Settings};
use assur::hybrid::{self, Cycle, Motion};
use assur::problem::Scene;
use assur_equations::presser_foot::Elliptic;

use crate::count::{Case, Measure, measure};
use crate::hand_foot::Foot;
use crate::hand_modes::HandFoot;
use crate::hand_walk;
use crate::table::{Table, number, power, ratio, verdict};

/// A turn of the shaft, in seconds.
pub const PERIOD: f64 = std::f64::consts::TAU / 300.0;
/// The motion that repeats, at the bottom of the return stroke, where the foot is in the air.
pub const START: [f64; 2] = [8.200_937_991_467_597e-5, -0.063_942_622_666_161_2];
/// The mode in which it is there.
pub const AIR: usize = 1;
/// Natural frequency of the foot on the fabric, rad/s, which turns errors of speeds into errors of places.
const FREQUENCY: f64 = 816.0;
/// Relative tolerance of the comparison.
const RTOL: f64 = 1e-9;
/// Turns of the long run.
const MANY: f64 = 100.0;
/// Largest ratio to the hand-written loop.
const GOAL: f64 = 1.15;
/// The same of a single turn, with its set-up.
const ALONE: f64 = 1.3;

/// Where a run ends.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    pub end: [f64; 2],
    pub evaluations: usize,
    pub events: usize,
}

/// The motion as a program asks for it.
pub fn motion<C: Scene>(foot: &C, turns: f64, settings: &Settings) -> Motion {
    let times = (0.0, turns * PERIOD);
    hybrid::march_in(foot, AIR, times, &START, settings).expect("the foot moves on")
}

/// The same, and where it ends.
pub fn assur_by(method: Method, turns: f64, rtol: f64) -> Run {
    end_of(&motion(&Elliptic::default(), turns, &Settings::new(method).rtol(rtol)))
}

fn end_of(motion: &Motion) -> Run {
    Run {
        end: [motion.end[0], motion.end[1]],
        evaluations: motion.statistics.evaluations,
        events: motion.events.len(),
    }
}

#[inline(never)]
fn assur(turns: f64, rtol: f64) -> Run {
    assur_by(Method::Dop853, turns, rtol)
}

/// The same by Taylor series.
#[inline(never)]
fn taylor(turns: f64, rtol: f64) -> Run {
    assur_by(Method::Taylor, turns, rtol)
}

/// Hand-written equations in the same solver.
#[inline(never)]
fn by_hand(turns: f64, rtol: f64) -> Run {
    let method = Method::Dop853;
    end_of(&motion(&HandFoot, turns, &Settings::new(method).rtol(rtol)))
}

/// The same by hand.
#[inline(never)]
pub fn hand<const KERNEL: bool, const KEEP: bool>(turns: f64, rtol: f64) -> Run {
    let walk = hand_walk::run::<KERNEL, KEEP>(&Foot::default(), START, turns * PERIOD, rtol);
    Run { end: walk.state, evaluations: walk.evaluations, events: walk.changes }
}

/// Error of the place at the end in metres: the amplitude of the vibration by which the state is wrong.
pub fn error(end: &[f64; 2], reference: &[f64; 2]) -> f64 {
    (end[0] - reference[0]).hypot((end[1] - reference[1]) / FREQUENCY)
}

/// So many turns at a relative tolerance, with its name.
type Kind = (&'static str, fn(f64, f64) -> Run);

/// All integrations.
const KINDS: [Kind; 7] = [
    ("hand, sine of std, end alone", hand::<false, false>),
    ("hand, sine of Assur, end alone", hand::<true, false>),
    ("hand, sine of std, motion kept", hand::<false, true>),
    ("hand, sine of Assur, motion kept", hand::<true, true>),
    ("hand-written equations, Assur's solver", by_hand),
    ("Assur, emitted, motion kept", assur),
    ("Assur, emitted, Taylor, motion kept", taylor),
];
/// Their names under valgrind, for one turn and for many.
const NAMES: [[&str; 7]; 2] = [
    ["std", "kernel", "std-kept", "kernel-kept", "modes", "assur", "taylor"],
    ["stds", "kernels", "stds-kept", "kernels-kept", "modess", "assurs", "taylors"],
];

/// Everything that is measured.
pub fn cases() -> Vec<Case<'static>> {
    // A single turn is over before the processor has got used to it.
    let runs = NAMES.into_iter().zip([(1.0, 20), (MANY, 1)]);
    let cases = runs.flat_map(|(names, (turns, pieces))| {
        names.into_iter().zip(KINDS).map(move |(name, (_, code))| {
            Case::new(name, pieces, move || {
                for _ in 0..pieces {
                    black_box(code(black_box(turns), black_box(RTOL)));
                }
            })
        })
    });
    let search = Case::new("cycle", 1, || {
        black_box(repeating());
    });
    cases.chain([search]).collect()
}

/// The motion that repeats, looked for from the declared start.
fn repeating() -> Cycle {
    let method = Method::Dop853;
    let settings = Settings::new(method).rtol(RTOL);
    hybrid::cycle(&Elliptic::default(), PERIOD, &settings)
        .expect("the foot has a motion that repeats")
}

/// Measures and prints.
pub fn report() {
    assert_eq!(Elliptic::shape().modes[AIR].name, "flight");
    let measures = measure("foot", &mut cases(), 300);
    let (runs, search) = measures.split_at(2 * KINDS.len());
    let (one, many) = runs.split_at(KINDS.len());
    turns_of("A turn of the presser foot", 1.0, one);
    turns_of("A hundred turns of the presser foot", MANY, many);
    let reference = assur(1.0, 1e-14).end;
    let apart = |(_, code): &Kind| error(&code(1.0, 1e-14).end, &reference);
    let apart = KINDS.iter().map(apart).fold(0.0, f64::max);
    println!("At rtol 1e-14 the ends of a turn differ by {apart:.1e} m.");
    let (events, states) = kept_apart(1e-14);
    println!("The events of a turn differ by {events:.1e} s, the kept motions by {states:.1e} m.");
    let cycle = repeating();
    let columns = ["hybrid::cycle", "instructions", "time, us"];
    let mut table = Table::new("The motion of the foot that repeats, rtol 1e-9", &columns);
    table.row([
        "presser foot".to_owned(),
        number(search[0].instructions),
        number(search[0].microseconds()),
    ]);
    table.print();
    println!(
        "Followed for {} turns, closed in {} steps, residual {:.1e}.",
        cycle.followed, cycle.iterations, cycle.residual
    );
}

/// By how much the instants of the events differ, and the kept motions on the way.
fn kept_apart(rtol: f64) -> (f64, f64) {
    let method = Method::Dop853;
    let ours = motion(&Elliptic::default(), 1.0, &Settings::new(method).rtol(rtol));
    let hand = hand_walk::run::<true, true>(&Foot::default(), START, PERIOD, rtol);
    let changes = ours.events.iter().filter(|one| one.from != one.to);
    let times: Vec<f64> = changes.map(|one| one.time).collect();
    assert_eq!(times.len(), hand.events.len());
    let pairs = times.iter().zip(&hand.events);
    let events = pairs.map(|(one, (other, _))| (one - other).abs());
    let states = (0..1000).map(|k| {
        let time = (f64::from(k) + 0.5) / 1000.0 * PERIOD;
        let ((mode, one), (flying, other)) = (ours.at(time), hand.at(time));
        assert_eq!(mode == AIR, flying, "{time}");
        error(&[one[0], one[1]], &other)
    });
    (events.fold(0.0, f64::max), states.fold(0.0, f64::max))
}

/// The table of a run, and whether it keeps its goals.
fn turns_of(what: &str, turns: f64, measures: &[Measure]) {
    let columns = [
        "code",
        "evaluations",
        "events",
        "error, m",
        "instructions",
        "ratio",
        "per evaluation",
        "time, us",
        "ratio",
    ];
    let mut table = Table::new(&format!("{what}, DOP853 unless said, rtol {RTOL:e}"), &columns);
    // The motion repeats.
    let reference = START;
    let (hand, [modes, ours, series]) = measures.split_at(KINDS.len() - 3) else {
        return;
    };
    let least = |hand: &[Measure], get: fn(&Measure) -> Option<f64>| {
        let all: Option<Vec<f64>> = hand.iter().map(get).collect();
        all?.into_iter().reduce(f64::min)
    };
    let instructions = |one: &Measure| one.instructions;
    let time = |one: &Measure| one.microseconds();
    let (end, kept) = hand.split_at(2);
    let (count, span) = (least(kept, instructions), least(kept, time));
    for ((kind, code), one) in KINDS.into_iter().zip(measures) {
        let run = code(turns, RTOL);
        table.row([
            kind.to_owned(),
            run.evaluations.to_string(),
            run.events.to_string(),
            power(error(&run.end, &reference)),
            number(one.instructions),
            ratio(one.instructions, count),
            number(one.instructions.map(|all| all / run.evaluations as f64)),
            number(one.microseconds()),
            ratio(one.microseconds(), span),
        ]);
    }
    table.print();
    let goal = if turns == 1.0 { ALONE } else { GOAL };
    let same = std::slice::from_ref(modes);
    let against = [
        ("Assur", ours, "hand-written equations in the same solver", same),
        ("Assur", ours, "best hand-written loop, motion kept", kept),
        ("Assur, Taylor", series, "best hand-written loop, motion kept", kept),
        ("Assur, Taylor", series, "best hand-written loop, end alone", end),
    ];
    for (who, ours, name, hand) in against {
        let many = if turns == 1.0 { "one turn" } else { "many" };
        let title = |unit| format!("{many}, {who} / {name}, {unit}");
        let (count, span) = (least(hand, instructions), least(hand, time));
        verdict(&title("instructions"), ours.instructions, count, goal);
        verdict(&title("time"), ours.microseconds(), span, goal);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_motion_repeats_whoever_follows_it() {
        for (kind, code) in KINDS {
            for turns in [1.0, 10.0] {
                let run = code(turns, 1e-13);
                assert!(error(&run.end, &START) < 1e-14, "{kind}: {run:?}");
                let coarse = code(turns, RTOL);
                assert!(error(&coarse.end, &START) < 1e-11, "{kind}: {coarse:?}");
            }
        }
    }

    #[test]
    fn events_and_kept_motions_agree() {
        let (events, states) = kept_apart(1e-13);
        assert!(events < 2e-15 && states < 1e-14, "{events} {states}");
    }
}
