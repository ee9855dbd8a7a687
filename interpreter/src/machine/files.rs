//! The registers of a call.
//!
//! Instructions name registers, and reading and writing these is most of what running them takes. So that it need not be
//! looked at each time whether they are there, it is looked at once: functions are [`Checked`] when they are built.

use std::marker::PhantomData;
use std::ops::Range;

use assur_solvers::dense::BoundRows;
use assur_solvers::scalar::Scalar;

use super::memory::Memory;
use crate::code::{Checked, Code, Register};

/// The registers of a call of a function.
pub(super) struct Files<'a, S: Scalar> {
    pub code: &'a Code,
    pub registers: Registers<S>,
    /// How many numbers there are.
    count: usize,
    pub bounds: &'a mut [BoundRows<S>],
    memory: PhantomData<&'a mut S>,
}

/// Where the registers of a checked function stand.
#[derive(Clone, Copy)]
pub(super) struct Registers<S: Scalar> {
    numbers: *mut S,
    conditions: *mut S::Mask,
}

impl<S: Scalar> Registers<S> {
    /// The number in a register.
    #[inline(always)]
    pub fn at(self, register: Register) -> S {
        // SAFETY: all registers that a checked function names lie in its memory, see `Files::of`.
        unsafe { *self.numbers.add(usize::from(register)) }
    }

    /// Writes a number into a register.
    #[inline(always)]
    pub fn put(self, register: Register, value: S) {
        // SAFETY: as above.
        unsafe { *self.numbers.add(usize::from(register)) = value }
    }

    /// The condition in a register.
    #[inline(always)]
    pub fn holds(self, register: Register) -> S::Mask {
        // SAFETY: as above.
        unsafe { *self.conditions.add(usize::from(register)) }
    }

    /// Writes a condition into a register.
    #[inline(always)]
    pub fn decide(self, register: Register, mask: S::Mask) {
        // SAFETY: as above.
        unsafe { *self.conditions.add(usize::from(register)) = mask }
    }
}

impl<'a, S: Scalar> Files<'a, S> {
    /// The registers of a function in memory that is long enough for it; none where it is not.
    #[inline(always)]
    pub fn of(code: &'a Checked, memory: &'a mut Memory<S>) -> Option<Self> {
        let Memory { numbers, conditions, bounds } = memory;
        let fits = numbers.len() >= code.registers && conditions.len() >= code.conditions;
        let registers =
            Registers { numbers: numbers.as_mut_ptr(), conditions: conditions.as_mut_ptr() };
        let (count, memory) = (numbers.len(), PhantomData);
        fits.then_some(Self { code, registers, count, bounds, memory })
    }

    /// All numbers.
    #[inline(always)]
    pub fn numbers(&mut self) -> &mut [S] {
        // SAFETY: so many numbers stand there, and nothing else reaches them as long as these are borrowed.
        unsafe { std::slice::from_raw_parts_mut(self.registers.numbers, self.count) }
    }

    /// Copies what the caller gives.
    #[inline(always)]
    pub fn load(&mut self, given: &[&[S]]) {
        for load in &self.code.loads {
            let list = given.get(load.list).copied().unwrap_or_default();
            self.copy(load.at, load.count, list.get(load.from..).unwrap_or_default());
        }
    }

    /// Copies one of the lists anew.
    #[inline(always)]
    pub fn load_list(&mut self, list: usize, given: &[S]) {
        for load in self.code.loads.iter().filter(|load| load.list == list) {
            self.copy(load.at, load.count, given.get(load.from..).unwrap_or_default());
        }
    }

    /// Copies so many numbers; those that are not given are zero.
    #[inline(always)]
    fn copy(&mut self, at: usize, count: usize, list: &[S]) {
        let target = &mut self.numbers()[at..][..count];
        let known = count.min(list.len());
        for (target, value) in target[..known].iter_mut().zip(list) {
            *target = *value;
        }
        target[known..].fill(S::ZERO);
    }

    /// Copies some results into a list of the caller's; what is no result is no number: the function could not be run.
    #[inline(always)]
    pub fn store(&self, results: Range<usize>, list: &mut [S]) {
        let results = &self.code.results[results];
        for (value, register) in list.iter_mut().zip(results) {
            *value = self.registers.at(*register);
        }
        if results.len() < list.len() {
            list[results.len()..].fill(S::from_f64(f64::NAN));
        }
    }
}
