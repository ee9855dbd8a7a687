//! Linear systems: small symmetric ones written out, others as operations of their own.

use super::graph::{Expression, Graph, Node};
use super::linear::Form;

/// Largest system that is written out.
const WRITTEN_OUT: usize = 3;

impl Graph {
    /// Solves a symmetric positive system, given by its lower triangle row by row, by `L·D·Lᵀ`.
    pub fn solve_symmetric(
        &mut self,
        lower: &[Expression],
        right: &[Expression],
    ) -> Vec<Expression> {
        let size = right.len();
        if size <= WRITTEN_OUT {
            return self.written_out(lower, right);
        }
        let factor = self.intern(Node::Factor(Form::Symmetric, size as u32, lower.into()));
        self.solve_factored(factor, right)
    }

    /// Solves any system with one solution, given by its rows, by factors with pivoting.
    pub fn solve_general(
        &mut self,
        rows: &[Vec<Expression>],
        right: &[Expression],
    ) -> Vec<Expression> {
        let entries = rows.concat().into();
        let factor = self.intern(Node::Factor(Form::General, right.len() as u32, entries));
        self.solve_factored(factor, right)
    }

    /// Solves for unknowns that closures bind, and for the forces of these: the lower triangle of [`Form::Bound`], row by row,
    /// with so many unknowns and at most so many independent closures. As many zeros follow as there are closures.
    pub fn solve_bound(
        &mut self,
        (unknowns, rank): (usize, usize),
        lower: &[Expression],
        right: &[Expression],
    ) -> Vec<Expression> {
        let form = Form::Bound { unknowns: unknowns as u32, rank: rank as u32 };
        let factor = self.intern(Node::Factor(form, right.len() as u32, lower.into()));
        self.solve_factored(factor, right)
    }

    /// Solves a system whose matrix is factored.
    pub(super) fn solve_factored(
        &mut self,
        factor: Expression,
        right: &[Expression],
    ) -> Vec<Expression> {
        let solution = self.intern(Node::Solve(factor, right.into()));
        (0..right.len() as u32).map(|index| self.intern(Node::Element(solution, index))).collect()
    }

    fn written_out(&mut self, lower: &[Expression], right: &[Expression]) -> Vec<Expression> {
        let size = right.len();
        let at = |row: usize, column: usize| row * (row + 1) / 2 + column;
        // `scaled[i][j] = L[i][j]·D[j]`, and `unit` is L.
        let (mut scaled, mut unit) = (lower.to_vec(), lower.to_vec());
        for row in 0..size {
            for column in 0..=row {
                let mut value = lower[at(row, column)];
                for k in 0..column {
                    let share = self.mul(unit[at(row, k)], scaled[at(column, k)]);
                    value = self.sub(value, share);
                }
                scaled[at(row, column)] = value;
                unit[at(row, column)] = self.div(value, scaled[at(column, column)]);
            }
        }
        let mut solution = right.to_vec();
        for row in 1..size {
            for column in 0..row {
                let share = self.mul(unit[at(row, column)], solution[column]);
                let negated = self.neg(share);
                solution[row] = self.sum(&[solution[row], negated]);
            }
        }
        for row in (0..size).rev() {
            let mut value = self.div(solution[row], scaled[at(row, row)]);
            for below in row + 1..size {
                let share = self.mul(unit[at(below, row)], solution[below]);
                let negated = self.neg(share);
                value = self.sum(&[value, negated]);
            }
            solution[row] = value;
        }
        solution
    }
}
