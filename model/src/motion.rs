//! The equations of motion as a system: balanced, ordered into blocks, and solved for the highest derivatives.
//!
//! The highest derivatives `w` (accelerations of coordinates, rates of first-order states) are symbols. They occur
//! linearly, `A·w + r₀ = 0`. Partial derivatives of the motion follow with `w` held: `A·∂w/∂y = −∂(A·w + r₀)/∂y`, so
//! nothing is ever differentiated through a solution.

mod balance;
mod held;
mod system;

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::slopes::Slopes;
use crate::structure::{Incidence, Matching, blocks};
use crate::token::Span;

pub use balance::{Hints, report_imbalance};
use held::Held;
use system::System;

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
    /// The forces of the closures that are not solved for.
    pub reactions: Vec<Expression>,
    /// Their nonzero partial derivatives by the columns: row, column, value.
    pub partials: Vec<(usize, usize, Expression)>,
    /// The same of the forces of the closures.
    pub reaction_partials: Vec<(usize, usize, Expression)>,
    /// Lower triangle of the mass matrix over the coordinates, where every equation is Lagrange's.
    pub mass: Vec<Expression>,
    /// What must not be zero: equation, unknown, and what multiplies the unknown in it, of single equations and on the
    /// diagonal of symmetric systems.
    pub pivots: Vec<(usize, usize, Expression)>,
}

/// By what the highest derivatives are differentiated, beside the dependent coordinates that follow.
#[derive(Clone, Copy)]
pub enum Columns<'a> {
    /// By each of these.
    Each(&'a [Symbol]),
    /// By all of these at once, each of which changes by [`Symbol::Change`]: one column. There are no dependent coordinates.
    Along(&'a [Symbol]),
}

/// What multiplies a highest derivative in an equation: equation, unknown, factor.
type Matrix = Map<(usize, usize), Expression>;

const HINTS: Hints = Hints {
    over: "take an equation away, or declare what else it determines",
    under: "add a `motion` equation or an energy with this unknown, or take the unknown away; a coordinate without mass is a `state`",
};

/// Solves the equations for the highest derivatives, and for their partial derivatives by columns of the state vector, which
/// dependent coordinates follow as `slopes` say; `scene` says in messages where this is, `in the scene `elastic``.
///
/// Where there are more equations than unknowns and a rank, the last ones are closures that are not solved for, of which so
/// many are independent, with slopes of these sizes: their second time derivatives, then the third ones. Their forces are
/// unknown as well.
pub fn solve(
    graph: &mut Graph,
    equations: &[Equation],
    (unknowns, (rank, sizes)): (&[UnknownName], (usize, &[f64])),
    (columns, slopes): (Columns<'_>, Option<&mut Slopes>),
    scene: &str,
    diagnostics: &mut Diagnostics,
) -> Option<Solved> {
    let residuals: Vec<_> = equations.iter().map(|equation| equation.residual).collect();
    let held = Held::of(equations, unknowns.len(), (rank, sizes));
    let highest = unknowns.len();
    let symbols = (0..highest as u32).map(Symbol::Acceleration);
    let symbols: Vec<_> = symbols.chain(held.forces()).collect();
    let unknowns = &[unknowns, &held.names(equations)].concat()[..];
    let matrix = matrix(graph, equations, unknowns, &symbols, diagnostics)?;
    let mut incidence = incidence(&matrix, equations.len(), unknowns.len());
    held.join(&mut incidence);
    // The third derivatives of closures determine nothing beside the second ones.
    let thirds = incidence.rows.split_off(held.thirds().start);
    let matching = Matching::of(&incidence);
    let place = (scene, &HINTS);
    if !report_imbalance(&incidence, &matching, equations, unknowns, place, diagnostics) {
        return None;
    }
    let zero = graph.zero();
    let at_rest: Map<_, _> = symbols.iter().map(|symbol| (*symbol, zero)).collect();
    let constant_parts = graph.substitute(&residuals, &at_rest);
    // What holds for an instant alone has no slopes.
    let lasting = &residuals[..held.thirds().start];
    let entries = match (columns, slopes) {
        (Columns::Each(given), Some(slopes)) => slopes.jacobian(graph, lasting, given),
        (Columns::Each(given), None) => graph.jacobian(lasting, given),
        (Columns::Along(given), _) => along(graph, lasting, given),
    };
    let mut slopes: Vec<BTreeMap<usize, Expression>> = vec![BTreeMap::new(); equations.len()];
    for (row, column, value) in entries {
        slopes[row].insert(column, value);
    }
    let blocks = blocks(&incidence, &matching);
    incidence.rows.extend(thirds);
    let mut elimination = Elimination {
        matrix,
        incidence,
        constant_parts,
        slopes,
        symbols,
        derivatives: vec![zero; unknowns.len()],
        partials: vec![BTreeMap::new(); unknowns.len()],
    };
    let mut pivots = Vec::new();
    for block in blocks {
        let system = System::of(&block, &elimination.matrix, equations, &held);
        pivots.extend(system.pivots());
        elimination.derive(graph, &system);
        for column in elimination.columns(&system) {
            elimination.differentiate(graph, &system, column);
        }
    }
    let own = &equations[..held.closures.start];
    let all_derived = own.iter().all(|equation| equation.lagrange.is_some());
    let mass = match all_derived && !own.is_empty() {
        true => mass_matrix(graph, own, &elimination.matrix),
        false => Vec::new(),
    };
    let reactions = elimination.derivatives.split_off(highest);
    let of_forces = elimination.partials.split_off(highest);
    let entries = |rows: Vec<BTreeMap<usize, Expression>>| {
        let rows = rows.into_iter().enumerate();
        let all = rows.flat_map(|(row, columns)| {
            columns.into_iter().map(move |(column, value)| (row, column, value))
        });
        all.filter(|one| one.2 != zero).collect()
    };
    Some(Solved {
        derivatives: elimination.derivatives,
        reactions,
        partials: entries(elimination.partials),
        reaction_partials: entries(of_forces),
        mass,
        pivots,
    })
}

/// The derivatives of some expressions where all that is given changes, as a column.
fn along(
    graph: &mut Graph,
    rows: &[Expression],
    given: &[Symbol],
) -> Vec<(usize, usize, Expression)> {
    let changes = given.iter().zip(0..);
    let changes = changes.map(|(symbol, index)| (*symbol, graph.symbol(Symbol::Change(index))));
    let changes: Map<_, _> = changes.collect();
    let zero = graph.zero();
    let rows = graph.tangent(rows, &changes).into_iter().enumerate();
    rows.filter(|(_, value)| *value != zero).map(|(row, value)| (row, 0, value)).collect()
}

/// What multiplies the highest derivatives, in which the equations have to be linear.
fn matrix(
    graph: &mut Graph,
    equations: &[Equation],
    unknowns: &[UnknownName],
    symbols: &[Symbol],
    diagnostics: &mut Diagnostics,
) -> Option<Matrix> {
    let residuals: Vec<_> = equations.iter().map(|equation| equation.residual).collect();
    let mut matrix = Matrix::default();
    for (row, column, value) in graph.jacobian(&residuals, symbols) {
        let is_unknown = |symbol| matches!(symbol, Symbol::Acceleration(_) | Symbol::Reaction(_));
        if graph.depends_on(value, is_unknown) {
            let unknown = &unknowns[column];
            let message = format!("this is not linear in `{}`", unknown.name);
            diagnostics.push(
                Diagnostic::error(equations[row].span, message)
                    .related(unknown.span, "declared here")
                    .hint("the highest derivatives may be multiplied by anything that does not contain one"),
            );
            return None;
        }
        matrix.insert((row, column), value);
    }
    Some(matrix)
}

fn incidence(matrix: &Matrix, rows: usize, columns: usize) -> Incidence {
    let mut incidence = Incidence { rows: vec![Vec::new(); rows], columns };
    for (row, column) in matrix.keys() {
        incidence.rows[*row].push(*column);
    }
    let rows = incidence.rows.iter_mut();
    rows.for_each(|row| row.sort_unstable());
    incidence
}

/// The equations, solved block by block.
struct Elimination {
    matrix: Matrix,
    incidence: Incidence,
    /// The equations where all highest derivatives are zero.
    constant_parts: Vec<Expression>,
    /// For each equation its nonzero partial derivatives by the given symbols.
    slopes: Vec<BTreeMap<usize, Expression>>,
    symbols: Vec<Symbol>,
    derivatives: Vec<Expression>,
    /// For each unknown its nonzero partial derivatives by the given symbols.
    partials: Vec<BTreeMap<usize, Expression>>,
}

impl Elimination {
    /// The highest derivatives of a block, in terms of those of earlier ones.
    fn derive(&mut self, graph: &mut Graph, system: &System) {
        let right = self.right(graph, system, |all, graph, row, other| match other {
            None => Some(all.constant_parts[row]),
            Some(other) => Some(graph.symbol(all.symbols[other])),
        });
        let values = system.solve(graph, &right);
        for (unknown, value) in system.unknowns.iter().zip(values) {
            self.derivatives[*unknown] = value;
        }
    }

    /// The partial derivatives of a block by one of the given symbols.
    fn differentiate(&mut self, graph: &mut Graph, system: &System, column: usize) {
        let zero = graph.zero();
        let right = self.right(graph, system, |all, _, row, other| match other {
            None => Some(all.slopes[row].get(&column).copied().unwrap_or(zero)),
            Some(other) => all.partials[other].get(&column).copied(),
        });
        if right.iter().any(|one| *one != zero) {
            let values = system.solve(graph, &right);
            for (unknown, value) in system.unknowns.iter().zip(values) {
                self.partials[*unknown].insert(column, value);
            }
        }
    }

    /// The given symbols by which the equations of a block, or the unknowns solved before it, have a derivative.
    fn columns(&self, system: &System) -> BTreeSet<usize> {
        let mut columns = BTreeSet::new();
        for &row in &system.equations {
            columns.extend(self.slopes[row].keys());
            let earlier = self.earlier(system, row);
            earlier.for_each(|other| columns.extend(self.partials[other].keys()));
        }
        columns
    }

    /// The unknowns in an equation that have been solved before.
    fn earlier<'a>(&'a self, system: &'a System, row: usize) -> impl Iterator<Item = usize> + 'a {
        let all = self.incidence.rows[row].iter().copied();
        all.filter(|other| !system.unknowns.contains(other))
    }

    /// Minus what is known of each equation of a block: what it has by itself, and what each earlier unknown adds.
    fn right(
        &self,
        graph: &mut Graph,
        system: &System,
        known: impl Fn(&Self, &mut Graph, usize, Option<usize>) -> Option<Expression>,
    ) -> Vec<Expression> {
        let zero = graph.zero();
        let mut right = Vec::new();
        for &row in &system.equations {
            let mut sum = known(self, graph, row, None).unwrap_or(zero);
            for other in self.earlier(system, row) {
                if let Some(value) = known(self, graph, row, Some(other)) {
                    let share = graph.mul(self.matrix[&(row, other)], value);
                    sum = graph.add(sum, share);
                }
            }
            right.push(graph.neg(sum));
        }
        right
    }
}

fn mass_matrix(graph: &mut Graph, equations: &[Equation], matrix: &Matrix) -> Vec<Expression> {
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
            columns[..=i].iter().map(|column| entry(*row, *column)).collect::<Vec<_>>()
        })
        .collect()
}
