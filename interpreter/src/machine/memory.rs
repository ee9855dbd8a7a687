//! What a function has in its registers before it is called, and the memory for calling it.

use std::sync::Mutex;

use assur_solvers::dense::BoundRows;
use assur_solvers::scalar::Scalar;

use super::run;
use crate::code::{Code, Slot};

/// Registers of a function whose memory is on the stack.
const SMALL: usize = 64;
/// Registers of most of the others.
const LARGE: usize = 1024;
/// All that there are.
const ALL: usize = 1 << 16;

/// The registers of a function with their files.
pub(super) struct Memory<S: Scalar> {
    numbers: Box<[S]>,
    conditions: Box<[S::Mask]>,
    bounds: Vec<BoundRows<S>>,
}

/// A function with its prepared values, on numbers of one kind.
pub struct Image<S: Scalar> {
    numbers: Vec<S>,
    conditions: Vec<S::Mask>,
    bounds: Vec<BoundRows<S>>,
    /// The functions inside of searches.
    pub(super) lines: Vec<Image<S>>,
    /// Memory that nobody uses now.
    idle: Mutex<Vec<Memory<S>>>,
}

/// Prepared values, as the function that prepares them has left them.
pub struct Kept<S: Scalar>(Memory<S>);

impl<S: Scalar> Image<S> {
    /// Of a function that needs nothing prepared.
    pub fn bare(code: &Code) -> Self {
        Self::with(code, None)
    }

    /// Of a function that reads prepared values.
    pub fn of(code: &Code, kept: &Kept<S>) -> Self {
        Self::with(code, Some(&kept.0))
    }

    fn with(code: &Code, kept: Option<&Memory<S>>) -> Self {
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
            for (from, length, at) in &fixed.kept {
                numbers[*at..][..*length].copy_from_slice(&kept.numbers[*from..][..*length]);
            }
            for (from, at) in &fixed.conditions {
                conditions[*at] = kept.conditions[*from];
            }
            for (from, at) in &fixed.bounds {
                bounds[*at] = kept.bounds[*from].clone();
            }
        }
        let lines = code.lines.iter().map(Self::bare).collect();
        Self { numbers, conditions, bounds, lines, idle: Mutex::new(Vec::new()) }
    }

    /// Whether the memory of a call is on the stack.
    fn is_small(&self, code: &Code) -> bool {
        code.registers.max(code.conditions) <= SMALL && self.bounds.is_empty()
    }

    fn memory(&self, code: &Code) -> Memory<S> {
        let idle = self.idle.lock().map(|mut idle| idle.pop());
        idle.ok().flatten().unwrap_or_else(|| {
            let size = match code.registers.max(code.conditions) <= LARGE {
                true => LARGE,
                false => ALL,
            };
            let mut numbers = vec![S::ZERO; size].into_boxed_slice();
            numbers[..self.numbers.len()].copy_from_slice(&self.numbers);
            let mut conditions = vec![S::less(S::ZERO, S::ZERO); size].into_boxed_slice();
            conditions[..self.conditions.len()].copy_from_slice(&self.conditions);
            Memory { numbers, conditions, bounds: self.bounds.clone() }
        })
    }

    fn release(&self, memory: Memory<S>) {
        if let Ok(mut idle) = self.idle.lock() {
            idle.push(memory);
        }
    }

    /// Computes the results from lists that the caller gives.
    pub fn call(&self, code: &Code, given: &[&[S]], results: &mut [S]) {
        if self.is_small(code) {
            return S::outline(
                #[inline(always)]
                || {
                    let mut numbers = [S::ZERO; SMALL];
                    numbers[..self.numbers.len()].copy_from_slice(&self.numbers);
                    let mut conditions = [S::less(S::ZERO, S::ZERO); SMALL];
                    conditions[..self.conditions.len()].copy_from_slice(&self.conditions);
                    let mut files = run::Files {
                        numbers: &mut numbers,
                        conditions: &mut conditions,
                        bounds: &mut [],
                    };
                    files.load(code, given);
                    files.run(code, &code.instructions, &self.lines);
                    files.store(&code.results, results);
                },
            );
        }
        let mut memory = self.memory(code);
        memory.run(code, &self.lines, given, results);
        self.release(memory);
    }

    /// Computes the results that are asked for once, and for each column the others. `put` takes each column that is behind
    /// another list of the caller's.
    pub fn call_columns(
        &self,
        code: &Code,
        given: &[&[S]],
        results: &mut [S],
        products: &mut [S],
    ) {
        let mut memory = self.memory(code);
        memory.run_columns(code, &self.lines, given, results, products);
        self.release(memory);
    }

    /// Computes what is prepared.
    pub fn keep(&self, code: &Code, given: &[&[S]]) -> Kept<S> {
        let mut memory = self.memory(code);
        memory.run(code, &self.lines, given, &mut []);
        Kept(memory)
    }
}

impl<S: Scalar> Kept<S> {
    /// The number that stands in a slot; none where it is no number.
    pub fn number(&self, slot: Slot) -> Option<S> {
        match slot {
            Slot::Number(at) => self.0.numbers.get(at).copied(),
            _ => None,
        }
    }
}

impl<S: Scalar> Memory<S> {
    /// Does something with the registers, of which it is known how many there are.
    fn run(&mut self, code: &Code, lines: &[Image<S>], given: &[&[S]], results: &mut [S]) {
        S::outline(
            #[inline(always)]
            || match self.numbers.len() {
                LARGE => self.run_of::<LARGE>(code, lines, given, results),
                _ => self.run_of::<ALL>(code, lines, given, results),
            },
        );
    }

    #[inline(always)]
    fn files<const N: usize>(&mut self) -> Option<run::Files<'_, S, N>> {
        Some(run::Files {
            numbers: self.numbers.first_chunk_mut::<N>()?,
            conditions: self.conditions.first_chunk_mut::<N>()?,
            bounds: &mut self.bounds,
        })
    }

    #[inline(always)]
    fn run_of<const N: usize>(
        &mut self,
        code: &Code,
        lines: &[Image<S>],
        given: &[&[S]],
        results: &mut [S],
    ) {
        let Some(mut files) = self.files::<N>() else { return };
        files.load(code, given);
        files.run(code, &code.instructions, lines);
        let count = code.results.len().min(results.len());
        files.store(&code.results[..count], results);
    }

    fn run_columns(
        &mut self,
        code: &Code,
        lines: &[Image<S>],
        given: &[&[S]],
        results: &mut [S],
        products: &mut [S],
    ) {
        S::outline(
            #[inline(always)]
            || match self.numbers.len() {
                LARGE => self.run_columns_of::<LARGE>(code, lines, given, (results, products)),
                _ => self.run_columns_of::<ALL>(code, lines, given, (results, products)),
            },
        );
    }

    #[inline(always)]
    fn run_columns_of<const N: usize>(
        &mut self,
        code: &Code,
        lines: &[Image<S>],
        given: &[&[S]],
        (results, products): (&mut [S], &mut [S]),
    ) {
        let Some(mut files) = self.files::<N>() else { return };
        files.load(code, given);
        let (once, each) = code.instructions.split_at(code.once);
        files.run(code, once, lines);
        let (first, last) = code.results.split_at(code.first);
        files.store(first, results);
        let length = last.len().max(1);
        for product in products.chunks_exact_mut(length) {
            files.load_list(code, 3, product);
            files.run(code, each, lines);
            files.store(last, product);
        }
    }
}
