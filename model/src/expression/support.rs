//! Which symbols occur in each node. Few sets serve many nodes, so each is kept once, as bits.

use super::graph::Symbol;
use super::hash::Map;

/// The sets of symbols that occur together.
#[derive(Debug, Default)]
pub struct Supports {
    /// The bit of each symbol.
    places: Map<Symbol, usize>,
    /// The symbols, in the order of their bits.
    symbols: Vec<Symbol>,
    /// The sets, without words that are zero at their ends.
    sets: Vec<Box<[u64]>>,
    index: Map<Box<[u64]>, u32>,
    scratch: Vec<u64>,
}

impl Supports {
    /// The set of one symbol.
    pub fn single(&mut self, symbol: Symbol) -> u32 {
        let next = self.symbols.len();
        let place = *self.places.entry(symbol).or_insert(next);
        if place == next {
            self.symbols.push(symbol);
        }
        self.scratch.clear();
        self.scratch.resize(place / 64 + 1, 0);
        self.scratch[place / 64] = 1 << (place % 64);
        self.keep()
    }

    /// The union of some sets, of which there may be none.
    pub fn union(&mut self, sets: impl Iterator<Item = u32>) -> u32 {
        self.scratch.clear();
        let mut last = None;
        for set in sets {
            // Equal operands, one behind the other, are common.
            if last.replace(set) == Some(set) {
                continue;
            }
            let bits = &self.sets[set as usize];
            if self.scratch.len() < bits.len() {
                self.scratch.resize(bits.len(), 0);
            }
            let pairs = self.scratch.iter_mut().zip(bits);
            pairs.for_each(|(word, other)| *word |= other);
        }
        match last {
            Some(set) if *self.sets[set as usize] == *self.scratch => set,
            _ => self.keep(),
        }
    }

    /// A set without a symbol.
    pub fn without(&mut self, set: u32, symbol: Symbol) -> u32 {
        let Some(place) = self.places.get(&symbol).copied() else {
            return set;
        };
        self.scratch.clear();
        self.scratch.extend_from_slice(&self.sets[set as usize]);
        if let Some(word) = self.scratch.get_mut(place / 64) {
            *word &= !(1 << (place % 64));
        }
        while self.scratch.last() == Some(&0) {
            self.scratch.pop();
        }
        self.keep()
    }

    /// The set whose bits have been put together.
    fn keep(&mut self) -> u32 {
        if let Some(known) = self.index.get(self.scratch.as_slice()) {
            return *known;
        }
        let index = self.sets.len() as u32;
        let bits: Box<[u64]> = self.scratch.as_slice().into();
        self.sets.push(bits.clone());
        self.index.insert(bits, index);
        index
    }

    /// Length of the bits of a set.
    pub fn words(&self, set: u32) -> usize {
        self.sets[set as usize].len()
    }

    /// The symbols of a set, in no order that means anything.
    pub fn symbols(&self, set: u32) -> impl Iterator<Item = Symbol> + '_ {
        let words = self.sets[set as usize].iter().enumerate();
        words.flat_map(|(index, word)| {
            let mut rest = *word;
            std::iter::from_fn(move || {
                let bit = rest.trailing_zeros() as usize;
                rest &= rest.wrapping_sub(1);
                (bit < 64).then_some(64 * index + bit)
            })
            .map(|place| self.symbols[place])
        })
    }
}
