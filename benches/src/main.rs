//! The benchmark of Assur: emitted code against code written by hand, and against other libraries.
//!
//! See `README.md` for what is fair and what is not.

mod bars;
mod chain;
mod count;
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
mod hand_run_up;
mod hand_squeezer;
mod hand_system;
mod hand_walk;
mod interpreter;
mod linkage;
#[cfg(feature = "peers")]
mod peers;
mod revolutions;
mod row;
mod run_ups;
mod sheets;
mod squeezer;
mod table;
mod tolerance;

use std::process::ExitCode;

/// What is printed when the command is wrong.
const USAGE: &str = "\
usage: assur-benches [COMMAND]

  evaluate      one evaluation of emitted and of hand-written code
  revolutions   ten revolutions and the periodic motion
  peers         other libraries on the same equations; needs `--features peers`
  foot          a turn of the presser foot, with its events
  foot-peers    other libraries on it; needs `--features peers`, and SciPy for its part
  run-ups       a thousand run-ups of a table on one thread and on two
  squeezer      Andrews' squeezing mechanism, three loops with masses
  bars          a slider-crank and a four-bar with masses
  row           forty windows in a row, through flat positions
  interpreter   equation files that nobody has compiled
  linkage       positions and influence coefficients of a six-bar
  sheets        a map, a gear flank and curves, at many places
  tolerance     a million heald linkages made at random
  chain         how long a chain of 30 pendulums takes to derive
  all           all of these (default)
  brief         the times of `revolutions` alone, as numbers";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["evaluate"] => with_counts(&[evaluate::report]),
        ["revolutions"] => with_counts(&[revolutions::report]),
        ["foot"] => with_counts(&[foot::report]),
        ["run-ups"] => with_counts(&[run_ups::report]),
        ["squeezer"] => with_counts(&[squeezer::report]),
        ["bars"] => with_counts(&[bars::report]),
        ["peers"] => return run_peers(Peers::Batten),
        ["foot-peers"] => return run_peers(Peers::Foot),
        ["row"] => row::report(),
        ["chain"] => chain::report(),
        ["linkage"] => with_counts(&[linkage::report]),
        ["sheets"] => with_counts(&[sheets::report]),
        ["interpreter"] => interpreter::report(),
        ["tolerance"] => tolerance::report(),
        ["brief"] => revolutions::brief(),
        [] | ["all"] => {
            with_counts(&[
                evaluate::report,
                revolutions::report,
                foot::report,
                linkage::report,
                sheets::report,
                run_ups::report,
                squeezer::report,
                bars::report,
            ]);
            row::report();
            interpreter::report();
            tolerance::report();
            chain::report();
            if cfg!(feature = "peers") {
                return run_peers(Peers::All);
            }
            println!("\nOther libraries are compared with `--features peers`.");
        }
        ["count", group, name] => return run_counted(group, name),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}

/// Prints reports that count instructions.
fn with_counts(reports: &[fn()]) {
    count::announce();
    for report in reports {
        report();
    }
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
        _ => Vec::new(),
    };
    if count::run_counted(&mut cases, name) {
        ExitCode::SUCCESS
    } else {
        eprintln!("there is no case `{name}` in the group `{group}`");
        ExitCode::from(2)
    }
}

/// What other libraries are compared on.
#[derive(Clone, Copy, PartialEq)]
enum Peers {
    Batten,
    Foot,
    All,
}

#[cfg(feature = "peers")]
fn run_peers(which: Peers) -> ExitCode {
    if which != Peers::Foot {
        peers::report();
    }
    if which != Peers::Batten {
        peers::foot::report();
    }
    ExitCode::SUCCESS
}

#[cfg(not(feature = "peers"))]
fn run_peers(which: Peers) -> ExitCode {
    let word = if which == Peers::Foot { "foot-peers" } else { "peers" };
    eprintln!("the libraries are not built in: cargo run --release --features peers {word}");
    ExitCode::from(2)
}
