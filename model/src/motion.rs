//! The equations of motion as a system: balanced, ordered into blocks, and solved for the highest derivatives.
//!
//! The highest derivatives `w` (accelerations of coordinates, rates of first-order states) are symbols. They occur
//! linearly, `A·w + r₀ = 0`. Partial derivatives of the motion follow with `w` held: `A·∂w/∂y = −∂(A·w + r₀)/∂y`, so
//! nothing is ever differentiated through a solution.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::structure::{Block, Incidence, Matching, blocks};
use crate::token::Span;

/// Largest block that is not symmetric and written out.
const WRITTEN_OUT: usize = 4;

/// One scalar equation, `residual = 0`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// What must vanish.
    pub residual: Expression,
    /// Its name in messages.
    pub name: String,
    /// Where it stands.
    pub span: Span,
    /// The coordinate whose Lagrange equation it is.
    pub lagrange: Option<usize>,
}

/// An unknown, for messages.
#[derive(Clone, Debug)]
pub struct UnknownName {
    /// The highest derivative, `ddot(phi2)`.
    pub name: String,
    /// Where it is declared.
    pub span: Span,
}

/// The solved system.
#[derive(Clone, Debug, Default)]
pub struct Solved {
    /// The highest derivatives.
    pub derivatives: Vec<Expression>,
    /// Their nonzero partial derivatives with respect to the given symbols: row, column, value.
    pub partials: Vec<(usize, usize, Expression)>,
    /// Lower triangle of the mass matrix over the coordinates, where every equation is Lagrange's.
    pub mass: Vec<Expression>,
    /// What must not be zero: equation, unknown, and what multiplies the unknown in it, of single equations and on the
    /// diagonal of symmetric systems.
    pub pivots: Vec<(usize, usize, Expression)>,
}

/// Solves the equations for the highest derivatives; `given` are the symbols of the state vector, `scene` says in
/// messages where this is, `in the scene `elastic``.
pub fn solve(
    graph: &mut Graph,
    equations: &[Equation],
    unknowns: &[UnknownName],
    given: &[Symbol],
    scene: &str,
    diagnostics: &mut Diagnostics,
) -> Option<Solved> {
    let residuals: Vec<_> = equations.iter().map(|equation| equation.residual).collect();
    let symbols: Vec<_> = (0..unknowns.len() as u32)
        .map(Symbol::Acceleration)
        .collect();
    let entries = graph.jacobian(&residuals, &symbols);
    let mut incidence = Incidence {
        rows: vec![Vec::new(); equations.len()],
        columns: unknowns.len(),
    };
    let mut matrix: Map<(usize, usize), Expression> = Map::default();
    for (row, column, value) in entries {
        if graph.as_number(value) == Some(0.0) {
            continue;
        }
        if graph.depends_on(value, |symbol| matches!(symbol, Symbol::Acceleration(_))) {
            diagnostics.push(
                Diagnostic::error(equations[row].span, format!("this is not linear in `{}`", unknowns[column].name))
                    .related(unknowns[column].span, "declared here")
                    .hint("the highest derivatives may be multiplied by anything that does not contain one"),
            );
            return None;
        }
        incidence.rows[row].push(column);
        matrix.insert((row, column), value);
    }
    incidence
        .rows
        .iter_mut()
        .for_each(|row| row.sort_unstable());
    let matching = Matching::of(&incidence);
    if !report_imbalance(
        &incidence,
        &matching,
        equations,
        unknowns,
        (scene, &HINTS),
        diagnostics,
    ) {
        return None;
    }

    let at_rest: Map<_, _> = symbols
        .iter()
        .map(|symbol| (*symbol, graph.zero()))
        .collect();
    let constant_parts = graph.substitute(&residuals, &at_rest);
    let slopes = graph.jacobian(&residuals, given);
    let mut by_row: Vec<BTreeMap<usize, Expression>> = vec![BTreeMap::new(); equations.len()];
    for (row, column, value) in slopes {
        by_row[row].insert(column, value);
    }

    let mut solved = Solved {
        derivatives: vec![graph.zero(); unknowns.len()],
        ..Solved::default()
    };
    let mut partials: Vec<BTreeMap<usize, Expression>> = vec![BTreeMap::new(); unknowns.len()];
    for block in blocks(&incidence, &matching) {
        let system = System::of(&block, &matrix, equations);
        solved.pivots.extend(system.pivots());
        let right: Vec<_> = system
            .equations
            .iter()
            .map(|&row| {
                let mut sum = constant_parts[row];
                for &column in incidence.rows[row]
                    .iter()
                    .filter(|column| !system.unknowns.contains(column))
                {
                    let earlier = graph.symbol(symbols[column]);
                    let share = graph.mul(matrix[&(row, column)], earlier);
                    sum = graph.add(sum, share);
                }
                graph.neg(sum)
            })
            .collect();
        let values = system.solve(graph, &right);
        for (unknown, value) in system.unknowns.iter().zip(values) {
            solved.derivatives[*unknown] = value;
        }
        // The columns in which the equations of the block, or the unknowns solved before it, have an entry.
        let mut columns: BTreeSet<usize> = BTreeSet::new();
        for &row in &system.equations {
            columns.extend(by_row[row].keys());
            let earlier = incidence.rows[row].iter();
            let earlier = earlier.filter(|other| !system.unknowns.contains(other));
            earlier.for_each(|other| columns.extend(partials[*other].keys()));
        }
        for column in columns {
            let mut any = false;
            let mut right = Vec::new();
            for &row in &system.equations {
                let mut sum = by_row[row].get(&column).copied().unwrap_or(graph.zero());
                for &other in incidence.rows[row]
                    .iter()
                    .filter(|other| !system.unknowns.contains(other))
                {
                    if let Some(earlier) = partials[other].get(&column).copied() {
                        let share = graph.mul(matrix[&(row, other)], earlier);
                        sum = graph.add(sum, share);
                    }
                }
                any |= graph.as_number(sum) != Some(0.0);
                right.push(graph.neg(sum));
            }
            if any {
                let values = system.solve(graph, &right);
                for (unknown, value) in system.unknowns.iter().zip(values) {
                    partials[*unknown].insert(column, value);
                }
            }
        }
    }
    for (row, columns) in partials.into_iter().enumerate() {
        for (column, value) in columns {
            if graph.as_number(value) != Some(0.0) {
                solved.partials.push((row, column, value));
            }
        }
    }
    if !equations.is_empty() && equations.iter().all(|equation| equation.lagrange.is_some()) {
        solved.mass = mass_matrix(graph, equations, &matrix);
    }
    Some(solved)
}

/// A block as a small linear system.
struct System {
    equations: Vec<usize>,
    unknowns: Vec<usize>,
    /// Row by row.
    entries: Vec<Vec<Option<Expression>>>,
    symmetric: bool,
}

impl System {
    fn of(block: &Block, matrix: &Map<(usize, usize), Expression>, equations: &[Equation]) -> Self {
        let mut unknowns = block.unknowns.clone();
        let owners: Option<Vec<_>> = block
            .equations
            .iter()
            .map(|&row| equations[row].lagrange)
            .collect();
        // Lagrange's equations of some coordinates in the accelerations of the same coordinates are symmetric.
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
        let entries = block
            .equations
            .iter()
            .map(|&row| {
                unknowns
                    .iter()
                    .map(|&column| matrix.get(&(row, column)).copied())
                    .collect()
            })
            .collect();
        Self {
            equations: block.equations.clone(),
            unknowns,
            entries,
            symmetric,
        }
    }

    /// Equations and unknowns with what multiplies the one in the other, where that must not be zero.
    fn pivots(&self) -> impl Iterator<Item = (usize, usize, Expression)> {
        let size = if self.symmetric || self.equations.len() == 1 {
            self.equations.len()
        } else {
            0
        };
        (0..size).filter_map(|index| {
            let entry = self.entries[index][index]?;
            Some((self.equations[index], self.unknowns[index], entry))
        })
    }

    fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let zero = graph.zero();
        let rows: Vec<Vec<_>> = self
            .entries
            .iter()
            .map(|row| row.iter().map(|entry| entry.unwrap_or(zero)).collect())
            .collect();
        if let ([row], [value]) = (rows.as_slice(), right) {
            return vec![graph.div(*value, row[0])];
        }
        if self.symmetric {
            let lower: Vec<_> = rows
                .iter()
                .enumerate()
                .flat_map(|(i, row)| row[..=i].to_vec())
                .collect();
            return graph.solve_symmetric(&lower, right);
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
        sum = if column % 2 == 0 {
            graph.add(sum, share)
        } else {
            graph.sub(sum, share)
        };
    }
    sum
}

fn mass_matrix(
    graph: &mut Graph,
    equations: &[Equation],
    matrix: &Map<(usize, usize), Expression>,
) -> Vec<Expression> {
    let zero = graph.zero();
    let mut row_of: Vec<_> = equations
        .iter()
        .enumerate()
        .filter_map(|(row, equation)| Some((equation.lagrange?, row)))
        .collect();
    row_of.sort_unstable();
    let columns: Vec<_> = row_of.iter().map(|(coordinate, _)| *coordinate).collect();
    let entry = |row: usize, column: usize| matrix.get(&(row, column)).copied().unwrap_or(zero);
    row_of
        .iter()
        .enumerate()
        .flat_map(|(i, (_, row))| {
            columns[..=i]
                .iter()
                .map(|column| entry(*row, *column))
                .collect::<Vec<_>>()
        })
        .collect()
}

fn listed(names: impl Iterator<Item = String>) -> String {
    names
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ")
}

/// What to do about an unbalanced system.
pub struct Hints {
    /// Too many equations.
    pub over: &'static str,
    /// Too few.
    pub under: &'static str,
}

const HINTS: Hints = Hints {
    over: "take an equation away, or declare what else it determines",
    under: "add a `motion` equation or an energy with this unknown, or take the unknown away; a coordinate without mass is a `state`",
};

/// Reports what is determined too often or not at all, and says whether nothing is.
pub fn report_imbalance(
    incidence: &Incidence,
    matching: &Matching,
    equations: &[Equation],
    unknowns: &[UnknownName],
    (scene, hints): (&str, &Hints),
    diagnostics: &mut Diagnostics,
) -> bool {
    let imbalance = matching.imbalance(incidence);
    let count = |number: usize, word: &str| {
        format!("{number} {word}{}", if number == 1 { "" } else { "s" })
    };
    if let Some((rows, columns)) = &imbalance.overdetermined {
        let named = listed(rows.iter().map(|row| equations[*row].name.clone()));
        let message = format!(
            "{} ({named}) would have to determine {}{}",
            count(rows.len(), "equation"),
            count(columns.len(), "unknown"),
            if columns.is_empty() {
                String::new()
            } else {
                format!(
                    " ({})",
                    listed(columns.iter().map(|column| unknowns[*column].name.clone()))
                )
            }
        );
        let last = rows
            .last()
            .map_or(Span::default(), |row| equations[*row].span);
        let report = Diagnostic::error(last, format!("{scene} {message}"));
        diagnostics.push_once(message, report.hint(hints.over));
    }
    if let Some((columns, rows)) = &imbalance.underdetermined {
        let named = listed(columns.iter().map(|column| unknowns[*column].name.clone()));
        let message = if rows.is_empty() {
            format!("nothing determines {named}")
        } else {
            format!(
                "{} ({named}) have to be determined by {} ({})",
                count(columns.len(), "unknown"),
                count(rows.len(), "equation"),
                listed(rows.iter().map(|row| equations[*row].name.clone()))
            )
        };
        let place = columns
            .first()
            .map_or(Span::default(), |column| unknowns[*column].span);
        diagnostics.push_once(
            message.clone(),
            Diagnostic::error(place, format!("{scene} {message}")).hint(hints.under),
        );
    }
    imbalance.overdetermined.is_none() && imbalance.underdetermined.is_none()
}
