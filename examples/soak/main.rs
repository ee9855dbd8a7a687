//! Runs every motion with values made at random, by every method and at many tolerances, and compares each printed number
//! with that of a far more accurate run by another method: values at times, extremes and their times, events, measures.
//! A number is judged by the error that stands beside it, as its reader does: the command itself is asked, for its JSON.
//!
//! Beside them it is watched that loops stay closed, and that energy stays where nothing takes or gives any.
//!
//! What is found is made as simple as it can be, with as few values changed and as few digits, and printed as a command line
//! that shows it. A case follows from its number and the seed alone, so that a soak goes on with `--from` where another
//! ended, and `--case` repeats one.
//!
//! | file | what it holds |
//! |---|---|
//! | `case` | a scene with values, a method and a tolerance made at random |
//! | `answer` | what the command says of it, as numbers with their errors |
//! | `watch` | what stays in a motion: closed loops, energy |
//! | `judge` | what is to be said of a case, and the simplest one of which the same is to be said |
//! | `tally` | how errors compare with their estimates, and what was worst |
//!
//!     cargo run --release --example soak -- --minutes 10

mod answer;
mod case;
mod judge;
mod tally;
mod watch;

use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use case::{Case, Precision};
use judge::{judge, simplest};
use tally::Tally;

const USAGE: &str =
    "soak [--minutes N] [--seed N] [--from CASE] [--case CASE] [--only MECHANISM] [--threads N]";

/// What is to be done.
struct Options {
    minutes: f64,
    seed: u64,
    from: u64,
    /// The end of the cases, without it that of the time.
    until: u64,
    only: Option<String>,
    threads: usize,
}

impl Options {
    fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options =
            Self { minutes: 10.0, seed: 1, from: 0, until: u64::MAX, only: None, threads: 2 };
        while let Some(word) = words.next() {
            let value = words.next().ok_or(format!("{word} needs a value"))?;
            let wrong = |_| format!("{word} does not take `{value}`");
            match word.as_str() {
                "--minutes" => options.minutes = value.parse().map_err(|_| wrong(()))?,
                "--seed" => options.seed = value.parse().map_err(|_| wrong(()))?,
                "--from" => options.from = value.parse().map_err(|_| wrong(()))?,
                "--case" => {
                    options.from = value.parse().map_err(|_| wrong(()))?;
                    options.until = options.from + 1;
                }
                "--only" => options.only = Some(value),
                "--threads" => options.threads = value.parse().map_err(|_| wrong(()))?,
                _ => return Err(format!("there is no option {word}")),
            }
        }
        Ok(options)
    }
}

fn main() -> ExitCode {
    let options = match Options::read(std::env::args().skip(1)) {
        Ok(options) => options,
        Err(why) => {
            eprintln!("{why}\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    let command = match command() {
        Ok(path) => path,
        Err(why) => {
            eprintln!("{why}");
            return ExitCode::from(2);
        }
    };
    let tally = Mutex::new(Tally::default());
    let next = AtomicU64::new(options.from);
    let end = Instant::now() + Duration::from_secs_f64(options.minutes * 60.0);
    std::thread::scope(|scope| {
        for _ in 0..options.threads.max(1) {
            scope.spawn(|| {
                while Instant::now() < end {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= options.until {
                        break;
                    }
                    let case = Case::make(options.seed, number, options.only.as_deref());
                    let mut verdict = judge(&command, &case);
                    let found = verdict.finding.take().map(|finding| {
                        // Told at once: to make it simple takes as many runs as there are things to leave out.
                        eprintln!("case {number}: {}", finding.what);
                        eprintln!("  {}", case.line(Precision::Tried));
                        simplest(&command, case, finding)
                    });
                    let mut tally = tally.lock().unwrap_or_else(|broken| broken.into_inner());
                    tally.add(&verdict);
                    if let Some((case, finding)) = found {
                        tally.find(finding, &case);
                    }
                    if number % 100 == 99 {
                        eprintln!("{} cases, {}", number + 1, tally.line());
                    }
                }
            });
        }
    });
    let tally = tally.into_inner().unwrap_or_else(|broken| broken.into_inner());
    print!("{tally}");
    println!("next: --seed {} --from {}", options.seed, next.into_inner());
    match tally.is_clean() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}

/// The command of this build, built if it is missing or old.
fn command() -> Result<PathBuf, String> {
    let example = std::env::current_exe().map_err(|error| error.to_string())?;
    let folder = example.ancestors().nth(2).ok_or("the example stands in no build folder")?;
    let mut build = Command::new(env!("CARGO"));
    build.args(["build", "--quiet", "--bin", "assur"]);
    build.args(["--manifest-path", concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")]);
    if !cfg!(debug_assertions) {
        build.arg("--release");
    }
    match build.status() {
        Ok(status) if status.success() => {
            Ok(folder.join(format!("assur{}", std::env::consts::EXE_SUFFIX)))
        }
        Ok(status) => Err(format!("the command could not be built: {status}")),
        Err(error) => Err(format!("cargo could not be started: {error}")),
    }
}
