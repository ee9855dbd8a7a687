//! How many threads share a work.

use std::num::NonZeroUsize;

/// Most threads, whatever is asked for: a machine refuses more at some point, and refused threads are a panic.
const MOST: usize = 1024;

/// So many threads as are wanted, but no more than can be had; as many as the machine has for zero.
pub fn count(wanted: usize) -> usize {
    match wanted {
        0 => std::thread::available_parallelism().map_or(1, NonZeroUsize::get),
        wanted => wanted.min(MOST),
    }
}
