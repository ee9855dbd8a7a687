//! Linear systems, sampled curves and searches.

use assur_model::program::{Form, Search};
use assur_solvers::dense::{factor_rows, pivot_rows, solve_pivoted, solve_rows};
use assur_solvers::scalar::Scalar;

use super::files::Files;
use super::memory::Image;
use crate::code::{Code, Factor, Finding, Lookup, Solve};

impl<S: Scalar> Files<'_, S> {
    #[inline(always)]
    pub(super) fn factor(&mut self, factor: &Factor) {
        let n = factor.rows;
        if let Form::Bound { .. } = factor.form {
            let registers = self.registers;
            self.bounds[factor.target].factor(|matrix| {
                for (row, column, register) in &factor.entries {
                    matrix.put(usize::from(*row), usize::from(*column), registers.at(*register));
                }
            });
            return;
        }
        for (row, column, register) in &factor.entries {
            let at = factor.target + usize::from(*row) * n + usize::from(*column);
            let entry = self.registers.at(*register);
            self.numbers()[at] = entry;
        }
        factor_block(factor.form, &mut self.numbers()[factor.target..][..n * (n + 2)]);
    }

    #[inline(always)]
    pub(super) fn solve(&mut self, solve: &Solve) {
        let n = solve.right.len();
        for (index, register) in solve.right.iter().enumerate() {
            let value = self.registers.at(*register);
            self.numbers()[solve.target + index] = value;
        }
        if let Form::Bound { .. } = solve.form {
            let bounds = std::mem::take(&mut self.bounds);
            let (x, room) = self.numbers()[solve.target..][..2 * n].split_at_mut(n);
            bounds[solve.factor].solve(x, room);
            self.bounds = bounds;
            return;
        }
        // What is factored stands before its solution, or was prepared.
        let (before, behind) = self.numbers().split_at_mut(solve.target);
        let (x, room) = behind[..2 * n].split_at_mut(n);
        solve_block(solve.form, &before[solve.factor..][..n * (n + 2)], x, room);
    }

    #[inline(always)]
    pub(super) fn table(&mut self, lookup: &Lookup) {
        let found = self.registers.at(lookup.at).table(&lookup.spline.table());
        self.numbers()[lookup.target..][..found.len()].copy_from_slice(&found);
    }

    #[inline(always)]
    pub(super) fn search(&mut self, finding: &Finding, lines: &[Image<S>]) {
        let captured: Vec<S> =
            finding.captured.iter().map(|register| self.registers.at(*register)).collect();
        let found = find(self.code, finding, lines, &captured);
        self.registers.put(finding.target, found);
    }
}

/// Factors a matrix in its place: `n` rows, and behind them `2 n` numbers that belong to its factors.
#[inline(always)]
pub(super) fn factor_block<S: Scalar>(form: Form, block: &mut [S]) {
    let n = rows(block.len());
    let (matrix, rest) = block.split_at_mut(n * n);
    let (reciprocals, more) = rest.split_at_mut(n);
    match form {
        Form::General => pivot_rows(matrix, reciprocals, more),
        _ => factor_rows(matrix, reciprocals, more),
    }
}

/// Solves in place with what [`factor_block`] has left, and with as much room.
#[inline(always)]
pub(super) fn solve_block<S: Scalar>(form: Form, block: &[S], x: &mut [S], room: &mut [S]) {
    let n = x.len();
    let (matrix, rest) = block.split_at(n * n);
    let (reciprocals, more) = rest.split_at(n);
    match form {
        Form::General => {
            room.copy_from_slice(x);
            solve_pivoted((matrix, reciprocals, more), room, x);
        }
        _ => solve_rows(matrix, reciprocals, x),
    }
}

/// The number of rows of a matrix whose block has `n (n + 2)` numbers.
#[inline(always)]
fn rows(length: usize) -> usize {
    (length + 1).isqrt() - 1
}

/// What is found of the functions.
fn find<S: Scalar>(code: &Code, finding: &Finding, lines: &[Image<S>], captured: &[S]) -> S {
    let line = |number: usize| {
        let index = finding.lines.get(number).copied().unwrap_or_default();
        let (code, image) = (&code.lines[index], &lines[index]);
        move |place: S| {
            let mut value = [S::ZERO];
            image.call(code, &[captured, &[place]], &mut value);
            value[0]
        }
    };
    match finding.search {
        Search::Mean => S::mean(&finding.text, line(0), line(1)),
        Search::Root => S::root(&finding.text, line(0)),
        Search::Highest => S::highest(line(0)),
        Search::HighestPlace => S::highest_place(line(0)),
    }
}
