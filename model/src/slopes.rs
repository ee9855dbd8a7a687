//! How the dependent coordinates change: `∂F/∂z·dz = −∂F/∂x·dx`, group after group.

use std::collections::BTreeMap;

use crate::expression::{Expression, Graph, Map, Symbol};
use crate::structure::Block;

/// Partial derivatives of the loop equations, and of the dependent coordinates by anything else.
#[derive(Default)]
pub struct Slopes {
    residuals: Vec<Expression>,
    /// For each equation its partial derivatives by dependent coordinates.
    rows: Vec<BTreeMap<usize, Expression>>,
    groups: Vec<Inverse>,
    by: Map<Symbol, Vec<Expression>>,
    unknowns: usize,
}

/// A group with the inverse of its matrix.
struct Inverse {
    equations: Vec<usize>,
    unknowns: Vec<usize>,
    /// The cofactors, one row for each unknown.
    rows: Vec<Vec<Expression>>,
    /// One over the determinant.
    scale: Expression,
}

impl Slopes {
    /// Takes the derivatives of ordered equations.
    pub fn new(
        graph: &mut Graph,
        residuals: &[Expression],
        groups: &[Block],
        unknowns: usize,
    ) -> Self {
        let symbols: Vec<_> = (0..unknowns as u32).map(Symbol::Dependent).collect();
        let mut rows = vec![BTreeMap::new(); residuals.len()];
        for (row, column, value) in graph.jacobian(residuals, &symbols) {
            rows[row].insert(column, value);
        }
        let zero = graph.zero();
        let groups = groups
            .iter()
            .map(|group| {
                let entry =
                    |row: &usize, column: &usize| rows[*row].get(column).copied().unwrap_or(zero);
                let matrix: Vec<Vec<_>> = group
                    .equations
                    .iter()
                    .map(|row| group.unknowns.iter().map(|column| entry(row, column)).collect())
                    .collect();
                let (rows, scale) = inverse(graph, &matrix);
                let (equations, unknowns) = (group.equations.clone(), group.unknowns.clone());
                Inverse { equations, unknowns, rows, scale }
            })
            .collect();
        Self { residuals: residuals.to_vec(), rows, groups, by: Map::default(), unknowns }
    }

    /// Entry of the matrix `∂F/∂z`.
    pub fn entry(&self, row: usize, column: usize) -> Option<Expression> {
        self.rows[row].get(&column).copied()
    }

    /// Derivatives of all dependent coordinates by something given, everything else given being held.
    pub fn by(&mut self, graph: &mut Graph, symbol: Symbol) -> Vec<Expression> {
        if let Some(known) = self.by.get(&symbol) {
            return known.clone();
        }
        let direction = Map::from_iter([(symbol, graph.one())]);
        let direct = graph.tangent(&self.residuals, &direction);
        let right: Vec<_> = direct.iter().map(|one| graph.neg(*one)).collect();
        let values = self.solve(graph, &right);
        self.by.insert(symbol, values.clone());
        values
    }

    /// Derivatives of a quantity by several things given, the dependent coordinates following: the equations are added to
    /// it with multipliers such that it does not depend on those, `∂f/∂z + λ·∂F/∂z = 0`. One such sum serves all that is
    /// given, where [`Self::by`] solves the equations for each.
    pub fn influence(
        &self,
        graph: &mut Graph,
        quantity: Expression,
        given: &[Symbol],
    ) -> Vec<Expression> {
        let one = graph.one();
        let symbols: Vec<_> = (0..self.unknowns as u32).map(Symbol::Dependent).collect();
        let along = graph.gradient(&[(quantity, one)], &symbols);
        let right: Vec<_> = along.iter().map(|one| graph.neg(*one)).collect();
        let multipliers = self.solve_transposed(graph, &right);
        let mut weighted = vec![(quantity, one)];
        let zero = graph.zero();
        let pairs = self.residuals.iter().copied().zip(multipliers);
        weighted.extend(pairs.filter(|(_, multiplier)| *multiplier != zero));
        graph.gradient(&weighted, given)
    }

    /// The `x` of `∂F/∂z·x = right`, one entry for each dependent coordinate, group after group.
    pub fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let zero = graph.zero();
        let mut values = vec![zero; self.unknowns];
        for group in &self.groups {
            let own: Vec<_> = group
                .equations
                .iter()
                .map(|&row| {
                    let mut terms = vec![right[row]];
                    for (column, slope) in &self.rows[row] {
                        if !group.unknowns.contains(column) {
                            let share = graph.mul(*slope, values[*column]);
                            terms.push(graph.neg(share));
                        }
                    }
                    graph.sum(&terms)
                })
                .collect();
            for (unknown, row) in group.unknowns.iter().zip(&group.rows) {
                let terms: Vec<_> = row.iter().zip(&own).map(|(a, b)| graph.mul(*a, *b)).collect();
                let sum = graph.sum(&terms);
                let value = graph.mul(group.scale, sum);
                values[*unknown] = graph.whole(value);
            }
        }
        values
    }

    /// The `λ` of `(∂F/∂z)ᵀ·λ = right`, one entry for each equation, from the last group to the first.
    pub fn solve_transposed(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let zero = graph.zero();
        let mut rest = right.to_vec();
        let mut multipliers = vec![zero; self.residuals.len()];
        for group in self.groups.iter().rev() {
            for (index, &row) in group.equations.iter().enumerate() {
                let unknowns = group.unknowns.iter().zip(&group.rows);
                let terms: Vec<_> = unknowns
                    .map(|(unknown, inverse)| graph.mul(rest[*unknown], inverse[index]))
                    .collect();
                let sum = graph.sum(&terms);
                let value = graph.mul(group.scale, sum);
                multipliers[row] = graph.whole(value);
            }
            for &row in &group.equations {
                let multiplier = multipliers[row];
                if multiplier == zero {
                    continue;
                }
                for (column, slope) in &self.rows[row] {
                    if !group.unknowns.contains(column) {
                        let share = graph.mul(multiplier, *slope);
                        rest[*column] = graph.sub(rest[*column], share);
                    }
                }
            }
        }
        multipliers
    }

    /// The residuals of the equations, in their order.
    pub fn residuals(&self) -> &[Expression] {
        &self.residuals
    }

    /// Nonzero derivatives of some expressions by some things given, the dependent coordinates following: row, column,
    /// value.
    pub fn jacobian(
        &mut self,
        graph: &mut Graph,
        rows: &[Expression],
        given: &[Symbol],
    ) -> Vec<(usize, usize, Expression)> {
        if self.unknowns == 0 {
            return graph.jacobian(rows, given);
        }
        let zero = graph.zero();
        let mut entries = Vec::new();
        for (column, symbol) in given.iter().enumerate() {
            let direction = self.direction(graph, *symbol);
            let values = graph.tangent(rows, &direction).into_iter().enumerate();
            let nonzero = values.filter(|(_, value)| *value != zero);
            entries.extend(nonzero.map(|(row, value)| (row, column, value)));
        }
        entries.sort_by_key(|(row, column, _)| (*row, *column));
        entries
    }

    /// A direction in which something given changes by one, and the dependent coordinates follow.
    pub fn direction(&mut self, graph: &mut Graph, symbol: Symbol) -> Map<Symbol, Expression> {
        let zero = graph.zero();
        let follow = self.by(graph, symbol);
        let mut direction: Map<_, _> = (0..self.unknowns as u32)
            .map(Symbol::Dependent)
            .zip(follow)
            .filter(|(_, value)| *value != zero)
            .collect();
        direction.insert(symbol, graph.one());
        direction
    }
}

/// The inverse by cofactors, which share their minors, and one over the determinant.
fn inverse(graph: &mut Graph, matrix: &[Vec<Expression>]) -> (Vec<Vec<Expression>>, Expression) {
    let size = matrix.len();
    let one = graph.one();
    let all: Vec<usize> = (0..size).collect();
    let determinant = minor(graph, matrix, &all, &all);
    let rows = (0..size)
        .map(|unknown| {
            (0..size)
                .map(|equation| {
                    let without = |left_out: usize| -> Vec<usize> {
                        all.iter().copied().filter(|index| *index != left_out).collect()
                    };
                    let rest = match size {
                        1 => one,
                        _ => minor(graph, matrix, &without(equation), &without(unknown)),
                    };
                    let sign = if (unknown + equation) % 2 == 0 { 1.0 } else { -1.0 };
                    graph.scale(sign, rest)
                })
                .collect()
        })
        .collect();
    let scale = graph.powi(determinant, -1);
    (rows, graph.whole(scale))
}

/// The determinant of some rows and columns, by expansion along the first of the rows.
fn minor(
    graph: &mut Graph,
    matrix: &[Vec<Expression>],
    rows: &[usize],
    columns: &[usize],
) -> Expression {
    if let ([row], [column]) = (rows, columns) {
        return matrix[*row][*column];
    }
    let zero = graph.zero();
    let mut terms = Vec::new();
    for (index, column) in columns.iter().enumerate() {
        let entry = matrix[rows[0]][*column];
        if entry == zero {
            continue;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|other| other != column).collect();
        let below = minor(graph, matrix, &rows[1..], &others);
        let share = graph.mul(entry, below);
        terms.push(if index % 2 == 0 { share } else { graph.neg(share) });
    }
    graph.sum(&terms)
}
