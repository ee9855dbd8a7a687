//! Windows in a row, through the positions in which all of their links lie flat.

use std::time::Instant;

use assur::answer::{Method, Settings, Solve};
use assur_equations::{four_bar_chain, four_bar_row};

use crate::table::{Table, number, power};

/// Numbers of windows, and the first crank's angle after 10 s: a Taylor series of all links in parallel, with 25 digits.
const EXACT: [(usize, f64); 3] =
    [(1, -30.343_944_970_943_13), (2, -30.179_800_860_191_205), (40, -30.026_637_417_190_84)];
/// End, in seconds.
const END: f64 = 10.0;
/// Relative tolerances.
const RTOLS: [f64; 4] = [1e-6, 1e-7, 1e-8, 1e-10];
/// Seconds after which a run is not repeated, and most rounds.
const LONG: f64 = 0.5;
const ROUNDS: usize = 10;

/// Measures and prints.
pub fn report() {
    let title =
        "Windows in a row over 10 s, through ten positions in which all links lie flat, DOP853";
    let columns =
        ["windows", "rtol", "evaluations", "error, rad", "time, ms", "per evaluation, us"];
    let mut table = Table::new(title, &columns);
    for (count, exact) in EXACT {
        for rtol in RTOLS {
            let settings = Settings::new(Method::Dop853).rtol(rtol);
            let (angle, evaluations, seconds) = match count {
                1 => run(&four_bar_chain::One::default(), &settings),
                2 => run(&four_bar_chain::Two::default(), &settings),
                _ => run(&four_bar_row::Falls::default(), &settings),
            };
            table.row([
                count.to_string(),
                format!("{rtol:.0e}"),
                evaluations.to_string(),
                power((angle - exact).abs()),
                number(Some(seconds * 1e3)),
                number(Some(seconds * 1e6 / evaluations as f64)),
            ]);
        }
    }
    table.print();
}

/// The first crank's angle at the end, evaluations, and the shortest time in seconds.
fn run<C: Solve>(scene: &C, settings: &Settings) -> (f64, usize, f64) {
    let mut best = f64::INFINITY;
    let (mut angle, mut evaluations) = (f64::NAN, 0);
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let motion = scene.ask().until(END).solve(settings);
        best = best.min(start.elapsed().as_secs_f64());
        let motion = motion.expect("a motion");
        angle = motion.value("th[0]", END).expect("an angle");
        evaluations = motion.statistics().evaluations;
        if best > LONG {
            break;
        }
    }
    (angle, evaluations, best)
}
