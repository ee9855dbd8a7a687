//! Several searches, each from other designs, side by side.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{SyncSender, sync_channel};

use super::{Candidate, Design, Stand};
use assur_solvers::synthesis::{Effort, Found, Population, SynthesisError, search};
use assur_solvers::threads;

/// News that wait to be heard.
const WAITING: usize = 16;
/// What the seeds of two searches that follow each other differ by.
const APART: u64 = 0x9e37_79b9;

/// What is heard of a search.
enum News {
    /// It goes on, from this population.
    Going(Population),
    /// What it has come to, and whether by itself; else it was stopped. A panic is passed on.
    Over(std::thread::Result<Result<Found, SynthesisError>>, bool),
}

/// Seeks so many times, each time from other designs, and gives the distinct ones that were found, the best first. It goes on from
/// where `stand` stands, and what it comes to is what it would have come to without a stop, on any number of threads: searches
/// that are over count in their order. The effort is that of so many searches; others follow until `progress`, which hears where
/// the searches stand, ends them.
///
/// # Errors
/// [`SynthesisError`] if the problem makes no sense, or the searches belong to another one.
pub fn seek(
    design: &Design<'_>,
    effort: &Effort,
    searches: u64,
    stand: &mut Stand,
    progress: &mut dyn FnMut(&Stand) -> ControlFlow<()>,
) -> Result<Vec<Candidate>, SynthesisError> {
    let (searches, threads) = (searches.max(1), threads::count(effort.threads) as u64);
    let beside = threads.min(searches);
    let own = |number: u64| Effort {
        evaluations: effort.evaluations / searches,
        seed: effort.seed.wrapping_add(number.wrapping_mul(APART)),
        threads: (threads / beside) as usize,
        ..effort.clone()
    };
    let is_stopped = AtomicBool::new(progress(stand).is_break());
    let stop = || is_stopped.store(true, Ordering::Relaxed);
    let ended = std::thread::scope(|scope| {
        let (sender, receiver) = sync_channel(WAITING);
        let (mut ended, mut failed) = (BTreeMap::new(), None);
        let (mut next, mut going) = (stand.over, 0);
        loop {
            // One more than are asked for is begun when these are over.
            while going < beside
                && (next < searches || stand.over >= searches)
                && !is_stopped.load(Ordering::Relaxed)
            {
                let from = stand.population(next).clone();
                let (own, sender, is_stopped) = (own(next), sender.clone(), &is_stopped);
                scope.spawn(move || go(design, (&own, next), from, &sender, is_stopped));
                (next, going) = (next + 1, going + 1);
            }
            if going == 0 {
                return failed.map_or(Ok(ended), Err);
            }
            match receiver.recv() {
                Ok((number, News::Going(population))) => {
                    *stand.population(number) = Some(population);
                }
                Ok((number, News::Over(Ok(Ok(found)), by_itself))) => {
                    going -= 1;
                    *stand.population(number) = Some(found.population.clone());
                    ended.insert(number, (design.candidate(found), by_itself));
                    while let Some((candidate, true)) = ended.get(&stand.over) {
                        stand.end(design, candidate.clone());
                        ended.remove(&(stand.over - 1));
                    }
                }
                Ok((_, News::Over(Ok(Err(error)), _))) => {
                    going -= 1;
                    failed = Some(error);
                    stop();
                }
                Ok((_, News::Over(Err(panic), _))) => {
                    stop();
                    resume_unwind(panic);
                }
                // This thread has a sender itself.
                Err(_) => return failed.map_or(Ok(ended), Err),
            }
            if progress(stand).is_break() {
                stop();
            }
        }
    })?;
    // Of those that were stopped counts what they have found.
    let mut all = Stand { found: stand.found.clone(), ..Stand::default() };
    ended.into_values().for_each(|(candidate, _)| all.take(design, candidate));
    all.found.sort_by(|a, b| a.score.order(&b.score));
    Ok(all.found)
}

/// A search on a thread of its own.
fn go(
    design: &Design<'_>,
    (effort, number): (&Effort, u64),
    from: Option<Population>,
    sender: &SyncSender<(u64, News)>,
    is_stopped: &AtomicBool,
) {
    let mut by_itself = true;
    let mut heard = |population: &Population| {
        let is_heard = sender.send((number, News::Going(population.clone()))).is_ok();
        by_itself = is_heard && !is_stopped.load(Ordering::Relaxed);
        if by_itself { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let ended = catch_unwind(AssertUnwindSafe(|| search(design, effort, from, &mut heard)));
    // Where a search has failed nobody hears of the others.
    let _ = sender.send((number, News::Over(ended, by_itself)));
}

impl Design<'_> {
    /// What a search has found.
    fn candidate(&self, found: Found) -> Candidate {
        Candidate {
            design: self.permitted(&self.best(&found.design).0),
            score: found.score,
            evaluations: found.population.evaluations,
            is_gathered: found.is_gathered,
        }
    }
}
