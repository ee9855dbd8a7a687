//! Functions that are called again and again: what stands in their registers at each call is put there once.

use assur_solvers::scalar::{Lanes, Masks, Scalar, WIDTH};

use super::files::Files;
use super::memory::{Image, Memory};
use crate::code::{COLUMN, Checked};

/// A function with memory of its own.
pub struct Calls<'a, S: Scalar> {
    code: &'a Checked,
    image: &'a Image<S>,
    /// None only where it has been taken out.
    memory: Option<Box<Memory<S>>>,
}

impl<'a, S: Scalar> Calls<'a, S> {
    /// Takes the memory.
    #[inline]
    pub fn new(code: &'a Checked, image: &'a Image<S>) -> Self {
        Self { code, image, memory: Some(image.memory(code)) }
    }

    /// The memory, as the last call has left it.
    pub(super) fn into_memory(mut self) -> Box<Memory<S>> {
        self.memory.take().unwrap_or_else(|| self.image.memory(self.code))
    }

    #[inline(always)]
    fn files(&mut self) -> Option<Files<'_, S>> {
        Files::of(self.code, self.memory.as_mut()?)
    }

    /// Computes the results from lists that the caller gives.
    #[inline]
    pub fn call(&mut self, given: &[&[S]], results: &mut [S]) {
        let image = self.image;
        S::outline(
            #[inline(always)]
            || {
                let Some(mut files) = self.files() else { return };
                files.load(given);
                files.run(0..files.code.instructions.len(), &image.lines);
                files.store(0..files.code.results.len(), results);
            },
        );
    }
}

impl<S: Scalar> Drop for Calls<'_, S> {
    #[inline]
    fn drop(&mut self) {
        if let Some(memory) = self.memory.take() {
            self.image.release(memory);
        }
    }
}

/// Does all instructions of a function that needs nothing prepared and gives no results.
pub(super) fn prepare<S: Scalar>(code: &Checked, memory: &mut Memory<S>, given: &[&[S]]) {
    let lines: Vec<Image<S>> = code.lines.iter().map(|line| Image::bare(line)).collect();
    S::outline(
        #[inline(always)]
        || {
            let Some(mut files) = Files::of(code, memory) else { return };
            files.load(given);
            files.run(0..code.instructions.len(), &lines);
        },
    );
}

/// A function some results of which are asked for once, and the others for each column of a matrix.
pub struct Columns<'a, S: Scalar> {
    once: Calls<'a, S>,
    /// What is done for each column, for several of them side by side; none where these would have to go separate ways.
    each: Option<Calls<'a, Lanes<S>>>,
}

impl<'a, S: Scalar> Columns<'a, S> {
    /// Takes the memory.
    pub fn new(code: &'a Checked, image: &'a Image<S>, wide: Option<&'a Image<Lanes<S>>>) -> Self {
        Self { once: Calls::new(code, image), each: wide.map(|wide| Calls::new(code, wide)) }
    }

    /// Computes the results that are asked for once, and for each column the others, which take its place.
    pub fn call(&mut self, given: &[&[S]], results: &mut [S], products: &mut [S]) {
        S::outline(
            #[inline(always)]
            || columns(&mut self.once, self.each.as_mut(), given, results, products),
        );
    }
}

#[inline(always)]
fn columns<S: Scalar>(
    once: &mut Calls<'_, S>,
    each: Option<&mut Calls<'_, Lanes<S>>>,
    given: &[&[S]],
    results: &mut [S],
    products: &mut [S],
) {
    let (code, lines) = (once.code, &once.image.lines[..]);
    let Some(mut files) = once.files() else { return };
    let (count, first, last) =
        (code.instructions.len(), 0..code.first, code.first..code.results.len());
    files.load(given);
    files.run(0..code.once, lines);
    files.store(first, results);
    if last.is_empty() {
        return products.fill(S::from_f64(f64::NAN));
    }
    let length = last.len();
    let wide = each.filter(|_| products.len() > length);
    let Some(mut wide) = wide.and_then(Calls::files) else {
        for product in products.chunks_exact_mut(length) {
            files.load_list(COLUMN, product);
            files.run(code.once..count, lines);
            files.store(last.clone(), product);
        }
        return;
    };
    for register in &code.again.numbers {
        wide.registers.put(*register, Lanes::splat(files.registers.at(*register)));
    }
    for register in &code.again.conditions {
        wide.registers.decide(*register, Masks::splat(files.registers.holds(*register)));
    }
    for products in products.chunks_mut(WIDTH * length) {
        for load in code.loads.iter().filter(|load| load.list == COLUMN) {
            for (place, number) in wide.numbers()[load.at..][..load.count].iter_mut().enumerate() {
                *number = lanes(products, length, load.from + place);
            }
        }
        wide.run(code.once..count, &[]);
        for (row, register) in code.results[last.clone()].iter().enumerate() {
            let all = wide.registers.at(*register);
            for (product, lane) in products.chunks_exact_mut(length).zip(all.0) {
                product[row] = lane;
            }
        }
    }
}

/// A row of some columns side by side, which stand one behind the other; what is left is like the first.
#[inline(always)]
fn lanes<S: Scalar>(columns: &[S], length: usize, row: usize) -> Lanes<S> {
    let mut all = Lanes::splat(columns[row]);
    for (lane, column) in all.0.iter_mut().zip(columns.chunks_exact(length)) {
        *lane = column[row];
    }
    all
}
