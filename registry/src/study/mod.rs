//! Many runs of one scene with different values: over a grid, or with values made at random.
//!
//! Runs know nothing of each other, so they go to whichever thread is free. What a run says depends on its number
//! alone: the answer is the same, bit for bit, for any number of threads.

mod attractors;
pub mod cost;
mod draw;
mod resonances;
mod sensitivity;
mod spread;
mod synthesis;
mod trust;

pub use attractors::{Attractor, Found, Look, attractors};
pub use draw::drawn;
pub use resonances::{
    GROWTH, Meets, NEAR, Resonance, Resonances, Spectrum, Unstable, resonances, spectrum,
};
pub use sensitivity::{Slope, slopes};
pub use spread::{Spread, share, spread};
pub use synthesis::{Candidate, Design, Stand, Unmeasured, seek};
#[cfg(feature = "synthesis")]
pub use synthesis::{Held, Polish, Settled, settle};
pub use trust::{Told, Trust, trust};

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::registry::Bind;
use assur_solvers::answer::{Error, Question, Settings};
use assur_solvers::measure::Missing;
use assur_solvers::problem::Span;
use assur_solvers::threads;

/// What a run came to: its measures, each with its value or why there is none; or why there is no motion.
pub type Outcome = Result<Vec<Result<f64, Missing>>, String>;

/// Runs a scene `count` times, with the values (SI units) that `values` gives for each number. `progress` hears how many
/// runs more are done; `threads` is zero for as many as the machine has.
pub fn runs(
    bind: &Bind,
    count: usize,
    values: &(dyn Fn(usize) -> Vec<f64> + Sync),
    settings: &Settings,
    threads: usize,
    progress: &(dyn Fn(u64) + Sync),
) -> Vec<Outcome> {
    each(count, threads, progress, &|index| {
        let failed = |error: &dyn std::fmt::Display| error.to_string();
        match bind {
            Bind::Motion(bind) => {
                let run = bind(&values(index)).map_err(|refused| failed(&refused))?;
                let motion = Question::of(run.into()).solve(settings);
                let motion = motion.map_err(|error| failed(&error))?;
                match motion.task() {
                    Span::Open => Err(failed(&Error::NoTask)),
                    _ => Ok(motion.measures()),
                }
            }
            Bind::Linkage(bind) => {
                let linkage = bind(&values(index)).map_err(|refused| failed(&refused))?;
                let way = linkage.way().ok_or_else(|| failed(&Error::NoTask))?;
                let found = linkage.measures(way).map_err(|error| failed(&error))?;
                Ok(found.into_iter().map(|one| one.value).collect())
            }
        }
    })
}

/// Does work for each number below `count`, on several threads, and gives the results in their order.
pub fn each<T: Send>(
    count: usize,
    threads: usize,
    progress: &(dyn Fn(u64) + Sync),
    work: &(dyn Fn(usize) -> T + Sync),
) -> Vec<T> {
    let threads = threads::count(threads);
    let next = AtomicUsize::new(0);
    let gathered = Mutex::new(Vec::with_capacity(count));
    let part = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                break;
            }
            done.push((index, work(index)));
            progress(1);
        }
        let mut all = gathered.lock().unwrap_or_else(|poison| poison.into_inner());
        all.extend(done);
    };
    std::thread::scope(|scope| {
        for _ in 1..threads.clamp(1, count.clamp(1, 1024)) {
            scope.spawn(part);
        }
        part();
    });
    let mut all = gathered.into_inner().unwrap_or_else(|poison| poison.into_inner());
    all.sort_unstable_by_key(|(index, _)| *index);
    all.into_iter().map(|(_, one)| one).collect()
}

#[cfg(test)]
mod tests;
