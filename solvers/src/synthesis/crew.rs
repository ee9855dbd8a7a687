//! Threads that judge designs for as long as a search takes.

use super::problem::{Judge, Score};
use crate::threads;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::Scope;

/// Fewest and most designs that are judged together; packs of numbers divide the most.
const BLOCK: (usize, usize) = (4, 64);
/// Blocks for each thread, where there are designs enough.
const BLOCKS: usize = 4;

/// Designs with their scores, the first of which has this place.
type Block = (usize, Vec<f64>, Vec<Score>);

/// Threads, or the caller alone.
pub(super) struct Crew<'a> {
    judge: &'a dyn Judge,
    threads: usize,
    work: Option<(Sender<Block>, Receiver<std::thread::Result<Block>>)>,
}

impl<'a> Crew<'a> {
    /// So many threads; zero for as many as the machine has.
    pub fn new<'scope>(
        judge: &'a dyn Judge,
        threads: usize,
        scope: &'scope Scope<'scope, 'a>,
    ) -> Self {
        let threads = threads::count(threads);
        if threads == 1 {
            return Self { judge, threads, work: None };
        }
        let (sender, blocks) = channel::<Block>();
        let (done, receiver) = channel();
        let blocks = Arc::new(Mutex::new(blocks));
        for _ in 0..threads {
            let (blocks, done) = (Arc::clone(&blocks), done.clone());
            scope.spawn(move || {
                loop {
                    let taken = blocks.lock().unwrap_or_else(PoisonError::into_inner).recv();
                    let Ok((first, designs, mut scores)) = taken else { break };
                    let judged = catch_unwind(AssertUnwindSafe(|| {
                        judge.judge(&designs, &mut scores);
                        (first, designs, scores)
                    }));
                    if done.send(judged).is_err() {
                        break;
                    }
                }
            });
        }
        Self { judge, threads, work: Some((sender, receiver)) }
    }

    /// Judges designs in blocks; each goes to the thread that comes first.
    pub fn judge(&self, designs: &[f64], scores: &mut [Score]) {
        let n = self.judge.sought().len();
        let block = scores.len().div_ceil(BLOCKS * self.threads).clamp(BLOCK.0, BLOCK.1);
        let Some((sender, receiver)) = self.work.as_ref().filter(|_| block < scores.len()) else {
            for (designs, scores) in designs.chunks(BLOCK.1 * n).zip(scores.chunks_mut(BLOCK.1)) {
                self.judge.judge(designs, scores);
            }
            return;
        };
        let blocks = designs.chunks(block * n).zip(scores.chunks(block)).enumerate();
        let sent = blocks.filter(|(index, (designs, scores))| {
            sender.send((index * block, designs.to_vec(), scores.to_vec())).is_ok()
        });
        for _ in 0..sent.count() {
            let Ok(judged) = receiver.recv() else { break };
            let (first, _, found) = judged.unwrap_or_else(|panic| resume_unwind(panic));
            scores[first..][..found.len()].copy_from_slice(&found);
        }
    }
}
