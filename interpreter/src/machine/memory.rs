//! What a function has in its registers before it is called, and the memory for calling it.

use std::sync::Mutex;

use assur_model::program::Form;
use assur_solvers::dense::BoundRows;
use assur_solvers::scalar::Scalar;

use super::lanes::{Lanes, Masks};
use super::run;
use super::systems::solve_block;
use crate::code::{COLUMN, Code, Slot};

/// Registers of a short function, whose memory is on the stack.
const TINY: usize = 32;
/// Registers of a longer one, likewise.
const SMALL: usize = 128;
/// Registers of most of the others.
const LARGE: usize = 1024;
/// All that there are.
const ALL: usize = 1 << 16;

/// How many registers a function needs.
enum Class {
    Tiny,
    Small,
    Large,
}

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
    /// Whether conditions are prepared.
    has_conditions: bool,
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
        let has_conditions = !fixed.conditions.is_empty();
        Self { numbers, conditions, bounds, has_conditions, lines, idle: Mutex::new(Vec::new()) }
    }

    /// The same on several numbers side by side; none where they would have to go separate ways.
    pub fn widen(&self, code: &Code) -> Option<Image<Lanes<S>>> {
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

    /// How many registers a call needs.
    #[inline]
    fn class(&self, code: &Code) -> Class {
        let registers = code.registers.max(code.conditions);
        match self.bounds.is_empty() {
            true if registers <= TINY => Class::Tiny,
            true if registers <= SMALL => Class::Small,
            _ => Class::Large,
        }
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
        match self.class(code) {
            Class::Tiny => return self.call_of::<TINY>(code, given, results),
            Class::Small => return self.call_of::<SMALL>(code, given, results),
            Class::Large => {}
        }
        let mut memory = self.memory(code);
        memory.run(code, &self.lines, given, results);
        self.release(memory);
    }

    /// Computes them with registers on the stack.
    #[inline]
    fn call_of<const N: usize>(&self, code: &Code, given: &[&[S]], results: &mut [S]) {
        S::outline(
            #[inline(always)]
            || {
                let mut numbers = [S::ZERO; N];
                let mut conditions = [S::less(S::ZERO, S::ZERO); N];
                let mut files = self.files::<N>(&mut numbers, &mut conditions);
                files.load(code, given);
                files.run(code, &code.instructions, &self.lines);
                files.store(&code.results, results);
            },
        );
    }

    /// Registers with what stands in the first of them.
    #[inline(always)]
    fn files<'a, const N: usize>(
        &self,
        numbers: &'a mut [S; N],
        conditions: &'a mut [S::Mask; N],
    ) -> run::Files<'a, S, N> {
        numbers[..self.numbers.len()].copy_from_slice(&self.numbers);
        if self.has_conditions {
            conditions[..self.conditions.len()].copy_from_slice(&self.conditions);
        }
        run::Files { numbers, conditions, bounds: &mut [] }
    }

    /// Computes the results that are asked for once, and for each column the others. `put` takes each column that is behind
    /// another list of the caller's.
    pub fn call_columns(&self, code: &Code, given: &[&[S]], results: &mut [S], products: &mut [S]) {
        if let Class::Large = self.class(code) {
            let mut memory = self.memory(code);
            memory.run_columns(code, &self.lines, given, results, products);
            return self.release(memory);
        }
        S::outline(
            #[inline(always)]
            || {
                let mut numbers = [S::ZERO; SMALL];
                let mut conditions = [S::less(S::ZERO, S::ZERO); SMALL];
                let files = self.files::<SMALL>(&mut numbers, &mut conditions);
                columns(files, (code, &self.lines), given, (results, products));
            },
        );
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
        results: (&mut [S], &mut [S]),
    ) {
        let Some(files) = self.files::<N>() else { return };
        columns(files, (code, lines), given, results);
    }
}

/// Computes what is done once, and the rest for each of the columns, which its products take the places of.
#[inline(always)]
fn columns<S: Scalar, const N: usize>(
    mut files: run::Files<'_, S, N>,
    (code, lines): (&Code, &[Image<S>]),
    given: &[&[S]],
    (results, products): (&mut [S], &mut [S]),
) {
    files.load(code, given);
    let (once, each) = code.instructions.split_at(code.once);
    files.run(code, once, lines);
    let (first, last) = code.results.split_at(code.first);
    files.store(first, results);
    for product in products.chunks_exact_mut(last.len().max(1)) {
        files.load_list(code, COLUMN, product);
        files.run(code, each, lines);
        files.store(last, product);
    }
}
