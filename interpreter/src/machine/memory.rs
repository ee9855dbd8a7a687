//! What a function has in its registers before it is called, and the memory for calling it.

use assur_model::program::Form;
use assur_solvers::dense::BoundRows;
use assur_solvers::scalar::{Lanes, Masks, Scalar};

use super::calls::{self, Calls};
use super::idle::Idle;
use super::systems::solve_block;
use crate::code::{Checked, Fixed, Slot};

/// The registers of a function with their files, and in the first of them what stands there at each call.
pub(super) struct Memory<S: Scalar> {
    pub(super) numbers: Box<[S]>,
    pub(super) conditions: Box<[S::Mask]>,
    pub(super) bounds: Vec<BoundRows<S>>,
}

/// A function with its prepared values, on numbers of one kind.
pub struct Image<S: Scalar> {
    numbers: Vec<S>,
    conditions: Vec<S::Mask>,
    bounds: Vec<BoundRows<S>>,
    /// The functions inside of searches.
    pub(super) lines: Vec<Image<S>>,
    /// Memory that nobody uses now.
    idle: Idle<Memory<S>>,
}

/// Prepared values, as the function that prepares them has left them.
pub struct Kept<S: Scalar>(Box<Memory<S>>);

impl<S: Scalar> Image<S> {
    /// Of a function that needs nothing prepared.
    pub fn bare(code: &Checked) -> Self {
        Self::with(code, None)
    }

    /// Of a function that reads prepared values.
    pub fn of(code: &Checked, kept: &Kept<S>) -> Self {
        Self::with(code, Some(&kept.0))
    }

    fn with(code: &Checked, kept: Option<&Memory<S>>) -> Self {
        let fixed = &code.fixed;
        let mut numbers = vec![S::ZERO; fixed.count];
        for (register, number) in &fixed.numbers {
            numbers[usize::from(*register)] = S::from_f64(*number);
        }
        let none = S::less(S::ZERO, S::ZERO);
        let mut conditions = vec![none; code.conditions];
        let sizes = code.bounds.iter();
        let mut bounds: Vec<_> =
            sizes.map(|[rows, unknowns, rank]| BoundRows::new(*rows, *unknowns, *rank)).collect();
        if let Some(kept) = kept {
            kept.copy(fixed, (&mut numbers, &mut conditions, &mut bounds));
        }
        let lines = code.lines.iter().map(Self::bare).collect();
        Self { numbers, conditions, bounds, lines, idle: Idle::new() }
    }

    /// Takes other prepared values.
    pub fn renew(&mut self, code: &Checked, kept: &Kept<S>) {
        let fixed = &code.fixed;
        kept.0.copy(fixed, (&mut self.numbers, &mut self.conditions, &mut self.bounds));
        if let Some(mut idle) = self.idle.take() {
            let Memory { numbers, conditions, bounds } = &mut *idle;
            kept.0.copy(fixed, (numbers, conditions, bounds));
            self.idle.give(idle);
        }
    }

    /// The same on several numbers side by side; none where they would have to go separate ways.
    pub fn widen(&self, code: &Checked) -> Option<Image<Lanes<S>>> {
        if !code.bounds.is_empty() || !code.lines.is_empty() {
            return None;
        }
        let mut wide = Image::<Lanes<S>>::bare(code);
        for (wide, own) in wide.numbers.iter_mut().zip(&self.numbers) {
            *wide = Lanes::splat(*own);
        }
        for (wide, own) in wide.conditions.iter_mut().zip(&self.conditions) {
            *wide = Masks::splat(*own);
        }
        Some(wide)
    }

    /// Memory for calling it.
    #[inline]
    pub(super) fn memory(&self, code: &Checked) -> Box<Memory<S>> {
        self.idle.take().unwrap_or_else(|| self.begin(code))
    }

    /// Memory with what stands in the first registers.
    #[cold]
    fn begin(&self, code: &Checked) -> Box<Memory<S>> {
        let mut numbers = vec![S::ZERO; code.registers].into_boxed_slice();
        numbers[..self.numbers.len()].copy_from_slice(&self.numbers);
        let mut conditions = vec![S::less(S::ZERO, S::ZERO); code.conditions].into_boxed_slice();
        conditions[..self.conditions.len()].copy_from_slice(&self.conditions);
        Box::new(Memory { numbers, conditions, bounds: self.bounds.clone() })
    }

    /// Gives memory back.
    #[inline]
    pub(super) fn release(&self, memory: Box<Memory<S>>) {
        self.idle.give(memory);
    }

    /// Computes the results from lists that the caller gives.
    #[inline]
    pub fn call(&self, code: &Checked, given: &[&[S]], results: &mut [S]) {
        Calls::new(code, self).call(given, results);
    }

    /// Computes what is prepared.
    pub fn keep(&self, code: &Checked, given: &[&[S]]) -> Kept<S> {
        let mut calls = Calls::new(code, self);
        calls.call(given, &mut []);
        Kept(calls.into_memory())
    }
}

impl<S: Scalar> Memory<S> {
    /// Copies what a function reads of prepared values into its first registers.
    fn copy(
        &self,
        fixed: &Fixed,
        (numbers, conditions, bounds): (&mut [S], &mut [S::Mask], &mut [BoundRows<S>]),
    ) {
        for (from, length, at) in &fixed.kept {
            for (target, value) in numbers[*at..][..*length].iter_mut().zip(&self.numbers[*from..])
            {
                *target = *value;
            }
        }
        for (from, at) in &fixed.conditions {
            conditions[*at] = self.conditions[*from];
        }
        for (from, at) in &fixed.bounds {
            bounds[*at].clone_from(&self.bounds[*from]);
        }
    }
}

impl<S: Scalar> Kept<S> {
    /// Prepares from other values, in the same memory.
    pub fn renew(&mut self, code: &Checked, given: &[&[S]]) {
        calls::prepare(code, &mut self.0, given);
    }

    /// The number that stands in a slot; none where it is no number.
    pub fn number(&self, slot: Slot) -> Option<S> {
        match slot {
            Slot::Number(at) => self.0.numbers.get(at).copied(),
            _ => None,
        }
    }

    /// The condition that stands in a slot; none where it is none.
    pub fn condition(&self, slot: Slot) -> Option<S::Mask> {
        match slot {
            Slot::Condition(at) => self.0.conditions.get(at).copied(),
            _ => None,
        }
    }

    /// Solves in place with prepared factors.
    pub fn solve(&self, slot: Slot, form: Form, x: &mut [S]) {
        let n = x.len();
        match slot {
            Slot::Bound(at) => self.0.bounds[at].solve(x, &mut vec![S::ZERO; n]),
            Slot::Number(at) => {
                let (block, mut room) = (&self.0.numbers[at..][..n * (n + 2)], vec![S::ZERO; n]);
                solve_block(form, block, x, &mut room);
            }
            Slot::Condition(_) => {}
        }
    }
}
