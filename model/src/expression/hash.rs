//! Hashing of nodes and handles: a multiplication a word, after `rustc-hash` (Orson Peters). Files do not choose the
//! handles, so nobody can aim at collisions, and the order of nodes never depends on a hash.

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// A map whose keys are nodes, handles or symbols.
pub type Map<K, V> = HashMap<K, V, BuildHasherDefault<WordHasher>>;

/// A set of nodes, handles or symbols.
pub type Set<K> = HashSet<K, BuildHasherDefault<WordHasher>>;

/// Takes a word at a time.
#[derive(Clone, Copy, Debug, Default)]
pub struct WordHasher(u64);

impl WordHasher {
    fn add(&mut self, word: u64) {
        self.0 = self
            .0
            .wrapping_add(word)
            .wrapping_mul(0xf135_7aea_2e62_a9c5);
    }
}

impl Hasher for WordHasher {
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.add(u64::from_le_bytes(word));
        }
    }

    fn write_u8(&mut self, word: u8) {
        self.add(u64::from(word));
    }

    fn write_u32(&mut self, word: u32) {
        self.add(u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        self.add(word);
    }

    fn write_usize(&mut self, word: usize) {
        self.add(word as u64);
    }

    fn finish(&self) -> u64 {
        // The upper bits are the best, and tables take the lower ones.
        self.0.rotate_left(26)
    }
}
