//! Hashing of nodes and handles: a multiplication a word, after `rustc-hash` (Orson Peters). Files do not choose the
//! handles, so nobody can aim at collisions, and the order of nodes never depends on a hash.

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// A map whose keys are nodes, handles or symbols.
pub type Map<K, V> = HashMap<K, V, BuildHasherDefault<WordHasher>>;

/// A set of nodes, handles or symbols.
pub type Set<K> = HashSet<K, BuildHasherDefault<WordHasher>>;

/// Finds handles by the hashes of what they stand for, which is kept elsewhere, and so only once.
#[derive(Debug, Default)]
pub struct Index {
    /// Hash and handle, at a place that the hash says or behind it; as many as a power of two.
    slots: Vec<Option<(u32, u32)>>,
    count: usize,
}

impl Index {
    /// The handle with this hash that is what is looked for.
    pub fn find(&self, hash: u32, is_wanted: impl Fn(u32) -> bool) -> Option<u32> {
        let mask = self.slots.len().wrapping_sub(1);
        let mut place = hash as usize & mask;
        while let Some((own, handle)) = *self.slots.get(place)? {
            if own == hash && is_wanted(handle) {
                return Some(handle);
            }
            place = (place + 1) & mask;
        }
        None
    }

    /// Adds a handle that is not there.
    pub fn insert(&mut self, hash: u32, handle: u32) {
        if 2 * self.count >= self.slots.len() {
            let empty = vec![None; (2 * self.slots.len()).max(64)];
            let old = std::mem::replace(&mut self.slots, empty);
            old.into_iter().flatten().for_each(|(hash, handle)| self.put(hash, handle));
        }
        self.count += 1;
        self.put(hash, handle);
    }

    fn put(&mut self, hash: u32, handle: u32) {
        let mask = self.slots.len() - 1;
        let mut place = hash as usize & mask;
        while self.slots[place].is_some() {
            place = (place + 1) & mask;
        }
        self.slots[place] = Some((hash, handle));
    }
}

/// Takes a word at a time.
#[derive(Clone, Copy, Debug, Default)]
pub struct WordHasher(u64);

impl WordHasher {
    fn add(&mut self, word: u64) {
        self.0 = self.0.wrapping_add(word).wrapping_mul(0xf135_7aea_2e62_a9c5);
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
