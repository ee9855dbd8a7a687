//! Measures of work: the shortest time of interleaved repetitions, and instructions counted by valgrind.
//!
//! Clock times on a shared machine are noisy from above alone, hence the minimum; repeating the cases in turn makes a
//! slow moment hit all of them. Instructions are exact and repeat, but say nothing of latencies and of what runs in
//! parallel. The program counts them by running itself under valgrind, one case at a time: what is counted is what
//! happens inside [`assur_measured`].

use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use crate::spread::Spread;

/// A piece of work that is measured.
pub struct Case<'a> {
    /// Its name, by which the program that runs under valgrind finds it again.
    pub name: &'static str,
    /// Pieces in one run of `work`.
    pub pieces: usize,
    /// The work.
    pub work: Box<dyn FnMut() + 'a>,
}

impl<'a> Case<'a> {
    /// A piece of work, `pieces` times in one call.
    pub fn new(name: &'static str, pieces: usize, work: impl FnMut() + 'a) -> Self {
        Self { name, pieces, work: Box::new(work) }
    }
}

/// What a piece of work takes.
#[derive(Clone, Debug)]
pub struct Measure {
    /// Instructions, where they could be counted.
    pub instructions: Option<f64>,
    /// Seconds, the shortest of all rounds.
    pub seconds: f64,
    /// Seconds of each round.
    rounds: Vec<f64>,
}

impl Measure {
    /// Time in nanoseconds.
    pub fn nanoseconds(&self) -> Option<f64> {
        Some(self.seconds * 1e9)
    }

    /// Time in microseconds.
    pub fn microseconds(&self) -> Option<f64> {
        Some(self.seconds * 1e6)
    }

    /// Time over that of another in the same rounds, with its spread.
    pub fn over(&self, reference: &Self) -> String {
        Spread::text(Spread::of(&self.rounds, &reference.rounds).as_ref())
    }
}

/// Does a piece of work. Valgrind counts from its entry to its exit.
#[inline(never)]
pub fn assur_measured(work: &mut dyn FnMut()) {
    work();
    // Nothing is left to do after a tail call, and then there is no exit.
    black_box(());
}

/// Measures the cases of a group, the times over so many rounds.
pub fn measure(group: &str, cases: &mut [Case<'_>], rounds: usize) -> Vec<Measure> {
    let seconds = timed(cases, rounds);
    let counted = cases.iter().map(|case| instructions(group, case));
    let measure = |(instructions, rounds): (_, Vec<f64>)| Measure {
        instructions,
        seconds: rounds.iter().copied().fold(f64::INFINITY, f64::min),
        rounds,
    };
    counted.zip(seconds).map(measure).collect()
}

/// Shortest time of one piece of each case, in seconds.
pub fn shortest(cases: &mut [Case<'_>], rounds: usize) -> Vec<f64> {
    let least = |rounds: Vec<f64>| rounds.into_iter().fold(f64::INFINITY, f64::min);
    timed(cases, rounds).into_iter().map(least).collect()
}

/// Times of one piece of each case in each round, in seconds.
fn timed(cases: &mut [Case<'_>], rounds: usize) -> Vec<Vec<f64>> {
    let mut all = vec![Vec::new(); cases.len()];
    for _ in 0..rounds {
        for (case, times) in cases.iter_mut().zip(&mut all) {
            let start = Instant::now();
            assur_measured(&mut case.work);
            times.push(start.elapsed().as_secs_f64() / case.pieces as f64);
        }
    }
    all
}

/// What this program does under valgrind: one case of a group, once before the count and once in it.
pub fn run_counted(cases: &mut [Case<'_>], name: &str) -> bool {
    let Some(case) = cases.iter_mut().find(|case| case.name == name) else {
        return false;
    };
    (case.work)();
    assur_measured(&mut case.work);
    true
}

/// Whether valgrind is there.
pub fn has_valgrind() -> bool {
    let asked = Command::new("valgrind").arg("--version").output();
    asked.is_ok_and(|output| output.status.success())
}

/// Says once how instructions are counted, or why they are not.
pub fn announce() {
    if has_valgrind() {
        println!("Instructions are counted by valgrind, times are the shortest of many rounds.");
    } else {
        println!("Instructions are not counted: valgrind is not installed.");
    }
}

/// Instructions of one piece of a case. None without valgrind, and where it lacks instructions of the processor, as
/// with `target-cpu=native` under AVX-512.
fn instructions(group: &str, case: &Case<'_>) -> Option<f64> {
    let program = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg("--toggle-collect=*assur_measured*")
        .arg(program)
        .args(["count", group, case.name])
        .output()
        .ok()?;
    if !output.status.success() {
        return None;
    }
    let total = collected(&String::from_utf8_lossy(&output.stderr))?;
    Some(total / case.pieces as f64)
}

/// The count in what callgrind prints at its end, `==123== Collected : 4567`.
fn collected(text: &str) -> Option<f64> {
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    let count: f64 = line.rsplit(':').next()?.trim().parse().ok()?;
    (count > 0.0).then_some(count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_read() {
        assert_eq!(
            collected("==7== Events    : Ir\n==7== Collected : 1630004\n"),
            Some(1_630_004.0)
        );
        assert_eq!(collected("==7== Collected : 0\n"), None);
        assert_eq!(collected("Illegal instruction\n"), None);
    }

    #[test]
    fn times_are_those_of_one_piece() {
        let mut cases = [Case::new("sleep", 2, || {
            std::thread::sleep(std::time::Duration::from_millis(4));
        })];
        let seconds = shortest(&mut cases, 2)[0];
        assert!((0.002..0.1).contains(&seconds), "{seconds}");
    }

    #[test]
    fn an_unknown_case_is_refused() {
        assert!(!run_counted(&mut [], "none"));
    }
}
