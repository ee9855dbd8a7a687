//! The benchmark of Assur: emitted code against code written by hand, and against other libraries.
//!
//! See `README.md` for what is fair and what is not.

mod bars;
mod chain;
mod count;
mod equal;
mod evaluate;
mod foot;
mod freedom;
mod hand;
mod hand_bars;
mod hand_best;
mod hand_curve;
mod hand_dop853;
mod hand_ends;
mod hand_event;
mod hand_flank;
mod hand_foot;
mod hand_freedom;
mod hand_linkage;
mod hand_loop;
mod hand_map;
mod hand_modes;
mod hand_radau;
mod hand_random;
mod hand_run_up;
mod hand_search;
mod hand_squeezer;
mod hand_system;
mod hand_walk;
mod interpreter;
mod linkage;
mod monte_carlo;
mod page;
#[cfg(feature = "peers")]
mod peers;
mod revolutions;
mod row;
mod run_ups;
mod search;
mod sheets;
mod spread;
mod squeezer;
mod stiff;
mod table;
mod tolerance;

use std::process::ExitCode;

/// What is printed when the command is wrong.
const USAGE: &str = "\
usage: assur-benches [COMMAND]

  evaluate      one evaluation of emitted and of hand-written code
  linkage       positions and influence coefficients of a six-bar
  revolutions   ten revolutions and the periodic motion
  stiff         van der Pol and Robertson, against Radau by hand
  squeezer      Andrews' squeezing mechanism, three loops with masses
  chain         how long a chain of 30 pendulums takes to derive
  monte-carlo   ten thousand six-bars made at random
  foot          a turn of the presser foot, with its events
  run-ups       a thousand run-ups of a table on one thread and on two
  bars          a slider-crank and a four-bar with masses
  row           forty windows in a row, through flat positions
  interpreter   equation files that nobody has compiled
  sheets        a map, a gear flank and curves, at many places
  tolerance     a million heald linkages made at random
  search        a hundred thousand designs of a dwell six-bar
  all           all of these (default)
  peers [WORKLOAD]
                other libraries on linkage, revolutions, stiff, squeezer, monte-carlo, foot,
                search
                (all, if none is named); needs `--features peers`, and Python with SciPy,
                CasADi and numba for their part
  page          docs/benchmarks.md, to standard output; needs what `peers` needs
  brief         the times of `revolutions` alone, as numbers";

/// A command with its report.
type Report = (&'static str, fn());

/// Reports that count instructions.
const COUNTED: [Report; 9] = [
    ("evaluate", evaluate::report),
    ("linkage", linkage::report),
    ("revolutions", revolutions::report),
    ("stiff", stiff::report),
    ("squeezer", squeezer::report),
    ("foot", foot::report),
    ("run-ups", run_ups::report),
    ("bars", bars::report),
    ("sheets", sheets::report),
];
/// Reports of times alone.
const TIMED: [Report; 6] = [
    ("chain", chain::report),
    ("monte-carlo", monte_carlo::report),
    ("row", row::report),
    ("interpreter", interpreter::report),
    ("tolerance", tolerance::report),
    ("search", search::report),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        [] | ["all"] => {
            count::announce();
            COUNTED.iter().chain(&TIMED).for_each(|(_, report)| report());
            if cfg!(feature = "peers") {
                return run_peers(None);
            }
            println!("\nOther libraries are compared with `--features peers`.");
        }
        ["peers"] => return run_peers(None),
        ["peers", workload] => return run_peers(Some(workload)),
        ["page"] => return page::print(),
        ["brief"] => revolutions::brief(),
        ["count", group, name] => return run_counted(group, name),
        [word] => match COUNTED.iter().chain(&TIMED).find(|(name, _)| name == word) {
            Some((name, report)) => {
                if COUNTED.iter().any(|(counted, _)| counted == name) {
                    count::announce();
                }
                report();
            }
            None => return wrong(),
        },
        _ => return wrong(),
    }
    ExitCode::SUCCESS
}

fn wrong() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}

/// What the program does under valgrind.
fn run_counted(group: &str, name: &str) -> ExitCode {
    let mut cases = match group {
        "evaluate" => evaluate::cases(),
        "revolutions" => revolutions::cases(),
        "foot" => foot::cases(),
        "linkage" => linkage::cases(),
        "sheets" => sheets::cases(),
        "run-ups" => run_ups::cases(),
        "squeezer" => squeezer::cases(),
        "bars" => bars::cases(),
        "stiff" => stiff::cases(),
        _ => Vec::new(),
    };
    if count::run_counted(&mut cases, name) {
        ExitCode::SUCCESS
    } else {
        eprintln!("there is no case `{name}` in the group `{group}`");
        ExitCode::from(2)
    }
}

#[cfg(feature = "peers")]
fn run_peers(workload: Option<&str>) -> ExitCode {
    if peers::compare(workload) { ExitCode::SUCCESS } else { wrong() }
}

#[cfg(not(feature = "peers"))]
fn run_peers(_workload: Option<&str>) -> ExitCode {
    eprintln!("the libraries are not built in: cargo run --release --features peers -- peers");
    ExitCode::from(2)
}
