//! A block of equations that are solved together.

use super::held::Held;
use super::{Equation, Matrix};
use crate::expression::{Expression, Graph};
use crate::structure::Block;

/// Largest block that is not symmetric and written out.
const WRITTEN_OUT: usize = 4;

/// A block as a small linear system.
pub struct System {
    /// The equations.
    pub equations: Vec<usize>,
    /// The unknowns.
    pub unknowns: Vec<usize>,
    /// Row by row.
    entries: Vec<Vec<Option<Expression>>>,
    form: Form,
    /// How large the slopes of closures are; their equations stand behind the others, and the third derivatives last.
    sizes: Vec<f64>,
}

/// What kind of system it is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    General,
    /// Lagrange's equations of some coordinates in the accelerations of the same coordinates.
    Symmetric,
    /// So many of these, and closures that hold the coordinates, of which a number is independent; the last unknowns are
    /// their forces.
    Held(usize, usize),
}

impl System {
    /// The equations of a block, which may be symmetric.
    pub fn of(block: &Block, matrix: &Matrix, equations: &[Equation], held: &Held<'_>) -> Self {
        if let Some((rows, unknowns)) = held.order(&block.equations) {
            let form = Form::Held(held.moved.len(), held.rank);
            let sizes = held.sizes.to_vec();
            return Self { sizes, ..Self::with(rows, unknowns, matrix, form) };
        }
        let mut unknowns = block.unknowns.clone();
        let owners: Option<Vec<_>> =
            block.equations.iter().map(|&row| equations[row].lagrange).collect();
        let symmetric = owners.is_some_and(|owners| {
            let mut sorted = unknowns.clone();
            sorted.sort_unstable();
            let mut rising = owners.clone();
            rising.sort_unstable();
            let same = sorted == rising;
            if same {
                unknowns = owners;
            }
            same
        });
        let form = if symmetric { Form::Symmetric } else { Form::General };
        Self::with(block.equations.clone(), unknowns, matrix, form)
    }

    fn with(equations: Vec<usize>, unknowns: Vec<usize>, matrix: &Matrix, form: Form) -> Self {
        let entry = |row: usize, column: &usize| matrix.get(&(row, *column)).copied();
        let row = |row: &usize| unknowns.iter().map(|column| entry(*row, column)).collect();
        let entries = equations.iter().map(row).collect();
        Self { equations, unknowns, entries, form, sizes: Vec::new() }
    }

    /// Equations and unknowns with what multiplies the one in the other, where that must not be zero.
    pub fn pivots(&self) -> impl Iterator<Item = (usize, usize, Expression)> {
        let size = match self.form {
            Form::Symmetric => self.equations.len(),
            Form::General if self.equations.len() == 1 => 1,
            Form::General | Form::Held(..) => 0,
        };
        (0..size).filter_map(|index| {
            let entry = self.entries[index][index]?;
            Some((self.equations[index], self.unknowns[index], entry))
        })
    }

    /// The unknowns for a right-hand side.
    pub fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let zero = graph.zero();
        let rows: Vec<Vec<_>> = self
            .entries
            .iter()
            .map(|row| row.iter().map(|entry| entry.unwrap_or(zero)).collect())
            .collect();
        if let ([row], [value]) = (rows.as_slice(), right) {
            return vec![graph.div(*value, row[0])];
        }
        let lower = || -> Vec<_> {
            let row = |(index, row): (usize, &Vec<Expression>)| {
                let mut row = row.clone();
                row.resize(index + 1, zero);
                row
            };
            rows.iter().enumerate().flat_map(row).collect()
        };
        match self.form {
            Form::Symmetric => return graph.solve_symmetric(&lower(), right),
            Form::Held(unknowns, rank) => {
                // Closures over their sizes; their forces stand on the other side of Lagrange's equations.
                let over: Vec<_> = self.sizes.iter().map(|size| graph.number(1.0 / size)).collect();
                let mut scaled = lower();
                let mut right = right.to_vec();
                for (index, over) in over.iter().chain(&over).enumerate() {
                    let row = unknowns + index;
                    let begin = row * (row + 1) / 2;
                    for entry in &mut scaled[begin..begin + unknowns] {
                        *entry = graph.mul(*entry, *over);
                    }
                    right[row] = graph.mul(right[row], *over);
                }
                let mut values = graph.solve_bound((unknowns, rank), &scaled, &right);
                for (force, over) in values[unknowns..].iter_mut().zip(&over) {
                    let force_over = graph.mul(*force, *over);
                    *force = graph.neg(force_over);
                }
                values.truncate(self.unknowns.len());
                return values;
            }
            Form::General => {}
        }
        if rows.len() > WRITTEN_OUT {
            return graph.solve_general(&rows, right);
        }
        // Cramer's rule: the block is small.
        let denominator = determinant(graph, &rows);
        (0..right.len())
            .map(|column| {
                let mut replaced = rows.clone();
                for (row, value) in replaced.iter_mut().zip(right) {
                    row[column] = *value;
                }
                let numerator = determinant(graph, &replaced);
                graph.div(numerator, denominator)
            })
            .collect()
    }
}

/// Expansion by the first row.
fn determinant(graph: &mut Graph, rows: &[Vec<Expression>]) -> Expression {
    if let [row] = rows {
        return row[0];
    }
    let mut sum = graph.zero();
    for column in 0..rows.len() {
        let minor: Vec<Vec<_>> = rows[1..]
            .iter()
            .map(|row| {
                row.iter()
                    .enumerate()
                    .filter(|(index, _)| *index != column)
                    .map(|(_, entry)| *entry)
                    .collect()
            })
            .collect();
        let below = determinant(graph, &minor);
        let share = graph.mul(rows[0][column], below);
        sum = if column % 2 == 0 { graph.add(sum, share) } else { graph.sub(sum, share) };
    }
    sum
}
