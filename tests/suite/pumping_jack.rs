//! A pumping jack and its packet reducer against closed forms; beside each hard case the naive way and what it gives.

use assur::answer::Sweep;
use assur::closure::ClosureError;
use assur::prelude::*;
use assur_equations::packet_reducer::{Meshes, Stand};
use assur_equations::pumping_jack::{Evenly, Steady, Torque, Turn};
use std::f64::consts::{PI, TAU};

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-12);

#[track_caller]
fn check(what: &str, found: f64, expected: f64, permitted: f64) {
    assert!((found - expected).abs() <= permitted, "{what}: {found}, expected {expected}");
}

/// Values of an output over a sweep.
fn column(path: &Sweep, name: &str) -> Vec<f64> {
    let pairs = path.output(name).expect("an output");
    pairs.into_iter().map(|pair| pair.1).collect()
}

/// Values of outputs at an angle of the crank.
fn at<const N: usize>(jack: &Turn, theta: f64, names: [&str; N]) -> [f64; N] {
    let path = jack.sweep(theta..=theta, 1).expect("it closes");
    names.map(|name| column(&path, name)[0])
}

/// Measures of a turn that is even.
fn measured<const N: usize>(jack: &Evenly, names: [&str; N]) -> [f64; N] {
    let motion = jack.solve(&FINE).expect("a turn");
    names.map(|name| motion.measure(name).expect("a measure"))
}

/// From the loop, by sines, and as a slope by differences. Over a turn its mean is nothing.
#[test]
fn the_torque_factor_is_the_same_three_ways() {
    let steps = 720;
    let path = Turn::default().sweep(0.0..=TAU, steps + 1).expect("it turns");
    let [height, factor, by_sines] = ["s", "TF", "TF_sines"].map(|name| column(&path, name));
    assert_eq!(height.len(), steps + 1);
    let step = TAU / steps as f64;
    for place in 0..steps {
        check("by sines", by_sines[place], factor[place], 1e-14);
        let s = |ahead: usize| height[(place + steps + ahead - 4) % steps];
        let slope = (672.0 * (s(5) - s(3)) - 168.0 * (s(6) - s(2)) + 32.0 * (s(7) - s(1))
            - 3.0 * (s(8) - s(0)))
            / (840.0 * step);
        check("by difference", factor[place], slope, 1e-12);
    }
    check("mean", factor[..steps].iter().sum::<f64>() / steps as f64, 0.0, 1e-15);
}

/// What drives the crank is what loads, counterweights and inertia take of it, by formulas for all of them: evenly and under the
/// motor. Without the inertia that changes with the angle, the naive way, a quarter of the rated torque is missing somewhere.
#[test]
fn the_equation_of_motion_is_that_of_the_formulas() {
    let path = Turn::default().sweep(0.0..=TAU, 361).expect("it turns");
    let [drive, taken, naive] = ["T_drive", "T_taken", "T"].map(|name| column(&path, name));
    let mut missing: f64 = 0.0;
    for place in 0..drive.len() {
        check("evenly", taken[place], drive[place], 1e-9);
        missing = missing.max((naive[place] - drive[place]).abs());
    }
    assert!(missing > 6963.0 / 4.0, "{missing}");
    let motion = Steady::default().solve(&FINE).expect("a turn");
    for step in 0..=50 {
        let [drive, taken] = ["T_drive", "T_taken"]
            .map(|name| motion.value(name, 0.1 * f64::from(step)).expect("a torque"));
        check("under the motor", taken, drive, 1e-8);
    }
}

/// Where crank and frame lie in line the torque factor is `-A*R/(K + R)`, however little is left to the limit of Grashof. The
/// angle between pitman and beam nears half a turn there, and by the arc cosine of the naive way half the digits are lost.
/// Beyond the limit the crank does not get past.
#[test]
fn near_the_limit_of_grashof_the_loop_keeps_the_digits() {
    let jack = Turn::default();
    let (frame, in_line) = (f64::hypot(jack.I, jack.h), PI + f64::atan2(jack.I, jack.h));
    let limit = jack.P + jack.C - frame;
    for (slack, by_loop, naive) in [(1e-6, 1e-12, 1e-11), (1e-8, 1e-12, 1e-10), (1e-12, 1e-8, 1e-5)]
    {
        let crank = limit * (1.0 - slack);
        let [factor, by_sines] = at(&Turn { R: crank, ..jack }, in_line, ["TF", "TF_sines"]);
        let expected = -jack.A * crank / (frame + crank);
        check("by the loop", factor, expected, by_loop);
        assert!((by_sines - expected).abs() > naive, "{slack}: {by_sines} {expected}");
    }
    let long = Turn { R: limit * (1.0 + 1e-6), ..jack };
    let refused = assur::registry::bind(Evenly { R: long.R, ..Evenly::default() });
    assert!(refused.is_err_and(|error| error.to_string().contains("the crank could not turn")));
    let path = long.sweep(0.0..=TAU, 721).expect("it closes at its start");
    let end = path.positions().end.as_ref();
    assert!(matches!(end, Some(ClosureError::DeadPoint { .. })), "{end:?}");
    let reached = path.output("TF").expect("an output").last().expect("a place").0;
    check("the end", reached, in_line, TAU / 720.0);
}

/// The load jumps where the rods turn round, at 4.53 and 195.00 degrees. By halves of a turn of the crank, the naive way, some of the
/// work is lost.
#[test]
fn the_load_changes_in_the_dead_centres() {
    let jack = Evenly::default();
    let [lifted] = measured(&jack, ["lifted"]);
    check("work", lifted, 12e3 * 1.5, 1e-6);
    let turn = Turn::default();
    let height = |theta: f64| at(&turn, theta, ["s"])[0];
    let naive = 12e3 * (height(PI) - height(0.0));
    assert!(naive < 0.99 * lifted, "{naive} {lifted}");
}

/// The peaks of both strokes are the same, and any other counterweight has a larger one: that for a rod that moves as a sine, the
/// naive choice, has 4.4 % more.
#[test]
fn the_counterweight_makes_the_largest_torque_least() {
    let jack = Evenly::default();
    let peaks =
        |moment: f64| measured(&Evenly { M: moment, ..jack }, ["peak_T", "peak_up", "peak_down"]);
    let [least, up, down] = peaks(jack.M);
    check("peaks", up, down, 1e-8);
    for share in [0.99, 0.999, 1.001, 1.01] {
        let [peak, up, down] = peaks(share * jack.M);
        assert!(peak > least + 1.0 && (up > down) == (share < 1.0), "{share}: {peak} {up} {down}");
    }
    let sine = (jack.W_up + jack.W_down) / 2.0 * 1.5 / 2.0;
    let [peak, ..] = peaks(sine);
    assert!(peak > 1.04 * least, "{peak} {least}");
    assert!(least < 6963.0, "{least}");

    // The closed form, with the places of the peaks.
    let path = Turn::default().sweep(0.0..=TAU, 36_001).expect("it turns");
    let (torque, factor) = (column(&path, "T"), column(&path, "TF"));
    let place = |is_up: bool| {
        let own = (0..torque.len()).filter(|index| (factor[*index] > 0.0) == is_up);
        own.max_by(|a, b| torque[*a].total_cmp(&torque[*b])).expect("a stroke")
    };
    let (u, d) = (place(true), place(false));
    let sine = |index: usize| f64::sin(TAU * index as f64 / 36_000.0);
    let closed = (factor[u] * jack.W_up - factor[d] * jack.W_down) / (sine(u) - sine(d));
    check("counterweight", closed, jack.M, 1e-2);
}

/// Where the load pulls the crank on, the motor gets less than the load gives. An efficiency that is the same both ways, the naive
/// one, gives the motor more than that: 1.3 % of the work are missing.
#[test]
fn power_that_flows_back_is_lost_on_its_way_too() {
    let jack = Evenly { gear_f_A: 0.0, gear_f_B: 0.0, ..Evenly::default() };
    let [work, losses, lowest] = measured(&jack, ["work", "losses", "lowest_T"]);
    let eta: f64 = 0.95 * 0.98_f64.powi(3);
    assert!(lowest < 0.0, "{lowest}");
    let naive = 18e3 / eta;
    let path = jack_torque(&jack);
    let back = path.iter().map(|torque| torque.min(0.0)).sum::<f64>() * TAU / path.len() as f64;
    check("work", work, naive - back * (1.0 / eta - eta), 1.0);
    check("losses", losses, work - 18e3, 1e-6);
    assert!(naive < 0.99 * work, "{naive} {work}");
}

/// Torque of the shaft over a turn.
fn jack_torque(jack: &Evenly) -> Vec<f64> {
    let motion = jack.solve(&FINE).expect("a turn");
    let period = TAU * 2.0 * (62.0_f64 / 18.0).powi(3) / jack.n;
    let times = (0..20_000).map(|step| period * f64::from(step) / 20_000.0);
    times.map(|time| motion.value("T_shaft", time).expect("a torque")).collect()
}

/// With every torque, also where some mesh bears none.
#[test]
fn the_reducer_loses_power_both_ways() {
    for torque in [-6963.0, -200.0, -125.3, -38.384, -1.0, 0.0, 4.0, 10.7512, 11.0, 300.0, 6963.0] {
        let path = Stand { T: torque, ..Stand::default() }.sweep(0.0..=0.0, 1).expect("a place");
        let value = |name: &str| column(&path, name)[0];
        check("the torque that comes back", value("again"), torque, 1e-11);
        check("power", value("left"), 0.0, 1e-10);
        let (rubbed, meshed) = (value("rubbed"), value("meshed"));
        check("bearings", rubbed, 151.573_154_3, 1e-6);
        assert!(meshed > 0.0, "{torque}: {meshed}");
        // An efficiency that is the same both ways.
        let naive = (torque / 0.98_f64.powi(3) - torque) / value("i") * 500.0 * TAU / 60.0;
        assert!((naive < 0.0) == (torque < 0.0), "{torque}: {naive}");
    }
    let blocks = |jack: Meshes| column(&jack.sweep(0.0..=0.0, 1).expect("a place"), "J_felt")[0];
    let all = blocks(Meshes::default());
    let lighter = blocks(Meshes { J_bB: 0.2, ..Meshes::default() });
    check("blocks on shaft B", all - lighter, 2.0 * 0.25 * (18.0_f64 / 62.0).powi(2), 1e-15);
}

/// Teeth press and do not pull: each flow bears from nothing to all. By the two springs alone, the naive way, one would pull.
#[test]
fn a_flow_bears_no_less_than_nothing_and_no_more_than_all() {
    let path = Torque::default().sweep(0.0..=TAU, 721).expect("it turns");
    let [torque, first, second] = ["T_shaft", "F_1", "F_2"].map(|name| column(&path, name));
    let mut pulled = 0;
    for ((torque, first), second) in torque.into_iter().zip(first).zip(second) {
        let whole = 2.0 * torque / 0.31;
        check("both", first + second, whole, 1e-9);
        assert!(first * whole >= 0.0 && second * whole >= 0.0, "{torque}: {first} {second}");
        let naive = whole / 2.0 + 1.2e9 * 10e-6 / 2.0;
        match naive * whole < 0.0 || (whole - naive) * whole < 0.0 {
            true => pulled += 1,
            false => check("shared", first, naive, 1e-9),
        }
    }
    assert!(pulled > 20, "{pulled}");
}
