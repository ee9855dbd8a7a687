//! Forces of closures on which other forces depend, as friction does: both are found together.
//!
//! What is felt, `F`, is given while the equations of motion are solved, and they say which forces the closures take,
//! `Λ(F)`. It has to be the same, `F = Λ(F)`: one step of Newton's method where a force depends linearly on what is felt; else
//! a number of steps, from the forces without friction on, whose last one says whether they have settled. Slopes follow
//! from `dF = ∂Λ/∂y·dy + ∂Λ/∂F·dF`.

use std::collections::{BTreeMap, BTreeSet};

use super::quantities::state_symbols;
use crate::expression::{Expression, Function, Graph, Map, Symbol};
use crate::lower::Lowering;
use crate::motion::Solved;
use crate::program;
use crate::statements::Parts;

/// Newton steps where forces do not depend linearly on what is felt. Friction of pins takes three.
const STEPS: usize = 5;
/// The last step over what is felt, as squares: what it leaves is about the square of it.
const SETTLED: f64 = 1e-12;
/// What is felt is never exactly nothing where slopes are taken: the length of a vector has none there. In SI units.
const NOTHING: f64 = 1e-30;
/// Changes no number that exists.
const NO_CHANGE: f64 = 1e-200;

/// The scalar closures whose forces are felt.
pub fn of(parts: &Parts, low: &Lowering<'_>) -> Vec<u32> {
    let forces: Vec<_> = parts.energies.forces.iter().map(|one| one.0).collect();
    let found = low.graph.symbols(&forces).into_iter().filter_map(|symbol| match symbol {
        Symbol::Felt(index) => Some(index),
        _ => None,
    });
    found.collect::<BTreeSet<u32>>().into_iter().collect()
}

/// Finds what is felt, binds it, and takes it into account in the slopes of the motion, whose last columns are by what is
/// felt.
pub fn settle(
    felt: &[u32],
    solved: &mut Solved,
    bindings: &mut Map<Symbol, Expression>,
    low: &mut Lowering<'_>,
) {
    if felt.is_empty() {
        return;
    }
    let states = state_symbols(low.names).len();
    let slopes = slopes(felt, solved, bindings, low);
    let graph = &mut low.graph;
    let reactions: Vec<_> =
        felt.iter().map(|index| graph.symbol(Symbol::Reaction(*index))).collect();
    let reactions = program::bind(graph, &reactions, bindings);
    let count = felt.len();
    let zero = graph.zero();
    let entry = |row: usize, column: usize| slopes[row].get(&column).copied().unwrap_or(zero);
    let matrix: Vec<Vec<_>> = (0..count)
        .map(|row| (0..count).map(|column| entry(row, states + column)).collect())
        .collect();
    let own = program::bind(graph, &matrix.concat(), bindings);
    let newton = Newton { felt, reactions, own };
    for (index, value) in felt.iter().zip(newton.solve(graph)) {
        bindings.insert(Symbol::Felt(*index), value);
    }
    let matrix = unit_less(graph, &matrix.concat(), count);
    let mut rates: Vec<BTreeMap<usize, Expression>> =
        vec![BTreeMap::new(); solved.derivatives.len()];
    for (row, column, value) in std::mem::take(&mut solved.partials) {
        rates[row].insert(column, value);
    }
    for column in 0..states {
        let right: Vec<_> = (0..count).map(|row| entry(row, column)).collect();
        if right.iter().all(|one| *one == zero) {
            continue;
        }
        let change = solve(graph, &matrix, &right);
        for row in &mut rates {
            let shares = change.iter().enumerate().filter_map(|(index, change)| {
                let slope = *row.get(&(states + index))?;
                Some((slope, *change))
            });
            let shares: Vec<_> = shares.collect();
            let mut terms: Vec<_> = shares.into_iter().map(|(a, b)| graph.mul(a, b)).collect();
            terms.extend(row.get(&column));
            row.insert(column, graph.sum(&terms));
        }
    }
    let all = rates.into_iter().enumerate().flat_map(|(row, columns)| {
        let own = columns.into_iter().filter(|(column, value)| *column < states && *value != zero);
        own.map(move |(column, value)| (row, column, value)).collect::<Vec<_>>()
    });
    solved.partials = all.collect();
}

/// The slopes of the forces that the closures take, by the state vector and by what is felt, the motion following.
fn slopes(
    felt: &[u32],
    solved: &mut Solved,
    bindings: &Map<Symbol, Expression>,
    low: &mut Lowering<'_>,
) -> Vec<BTreeMap<usize, Expression>> {
    let mut rows: Vec<BTreeMap<usize, Expression>> = vec![BTreeMap::new(); felt.len()];
    let given: Vec<Symbol> = state_symbols(low.names)
        .into_iter()
        .chain(felt.iter().map(|one| Symbol::Felt(*one)))
        .collect();
    let mut slopes = low.slopes.take();
    match &mut slopes {
        Some(slopes) => {
            let own: Vec<_> =
                felt.iter().map(|index| bindings[&Symbol::Reaction(*index)]).collect();
            let own = low.written_out(&own);
            let highest = (0..solved.derivatives.len() as u32).map(Symbol::Acceleration);
            let symbols: Vec<_> = given.iter().copied().chain(highest).collect();
            for (row, column, value) in slopes.jacobian(&mut low.graph, &own, &symbols) {
                match column.checked_sub(given.len()) {
                    None => add(&mut low.graph, &mut rows[row], column, value),
                    Some(highest) => {
                        let follow = solved.partials.iter().filter(|one| one.0 == highest);
                        for (_, column, slope) in follow {
                            let share = low.graph.mul(value, *slope);
                            add(&mut low.graph, &mut rows[row], *column, share);
                        }
                    }
                }
            }
        }
        None => {
            for (row, column, value) in &solved.reaction_partials {
                if let Some(place) = felt.iter().position(|index| *index as usize == *row) {
                    rows[place].insert(*column, *value);
                }
            }
        }
    }
    low.slopes = slopes;
    // Where slopes are taken.
    let graph = &mut low.graph;
    let nothing = graph.number(NOTHING);
    let aside = felt.iter().map(|index| {
        let symbol = Symbol::Felt(*index);
        let value = graph.symbol(symbol);
        (symbol, graph.add(value, nothing))
    });
    let aside: Map<_, _> = aside.collect();
    for row in &mut rows {
        for value in row.values_mut() {
            *value = graph.substitute(&[*value], &aside)[0];
        }
    }
    for (_, _, value) in &mut solved.partials {
        *value = graph.substitute(&[*value], &aside)[0];
    }
    rows
}

fn add(graph: &mut Graph, row: &mut BTreeMap<usize, Expression>, column: usize, value: Expression) {
    let sum = match row.get(&column) {
        Some(known) => graph.add(*known, value),
        None => value,
    };
    row.insert(column, sum);
}

/// The equations `F = Λ(F)`.
struct Newton<'a> {
    felt: &'a [u32],
    /// `Λ`.
    reactions: Vec<Expression>,
    /// `∂Λ/∂F`, row by row.
    own: Vec<Expression>,
}

impl Newton<'_> {
    fn solve(&self, graph: &mut Graph) -> Vec<Expression> {
        let is_felt = |symbol: Symbol| matches!(symbol, Symbol::Felt(_));
        let is_linear = self.own.iter().all(|one| !graph.depends_on(*one, is_felt));
        let nothing = vec![graph.zero(); self.felt.len()];
        let mut now = self.at(graph, &self.reactions, &nothing);
        if is_linear {
            let matrix = unit_less(graph, &self.own, self.felt.len());
            return solve(graph, &matrix, &now);
        }
        let mut step = nothing;
        for _ in 0..STEPS {
            let there = self.at(graph, &self.reactions, &now);
            let right: Vec<_> = there.iter().zip(&now).map(|(a, b)| graph.sub(*a, *b)).collect();
            let own = self.at(graph, &self.own, &now);
            let matrix = unit_less(graph, &own, self.felt.len());
            step = solve(graph, &matrix, &right);
            now = now.iter().zip(&step).map(|(a, b)| graph.add(*a, *b)).collect();
        }
        self.settled(graph, &now, &step)
    }

    /// The numbers; none where the last step is no small one, by a root that does not exist then.
    fn settled(
        &self,
        graph: &mut Graph,
        now: &[Expression],
        step: &[Expression],
    ) -> Vec<Expression> {
        let mut squares = |all: &[Expression]| {
            let all: Vec<_> = all.iter().map(|one| graph.powi(*one, 2)).collect();
            graph.sum(&all)
        };
        let (size, last) = (squares(now), squares(step));
        let permitted = graph.scale(SETTLED, size);
        let least = graph.number(NOTHING);
        let room = graph.add(permitted, least);
        let room = graph.sub(room, last);
        let root = graph.call(Function::Sqrt, &[room]);
        let root = graph.scale(NO_CHANGE, root);
        let one = graph.one();
        let factor = graph.add(one, root);
        now.iter().map(|one| graph.mul(*one, factor)).collect()
    }

    /// Expressions where these forces are felt.
    fn at(
        &self,
        graph: &mut Graph,
        expressions: &[Expression],
        forces: &[Expression],
    ) -> Vec<Expression> {
        let symbols = self.felt.iter().map(|index| Symbol::Felt(*index));
        graph.substitute(expressions, &symbols.zip(forces.iter().copied()).collect())
    }
}

/// The identity less a matrix, by rows.
fn unit_less(graph: &mut Graph, entries: &[Expression], count: usize) -> Vec<Vec<Expression>> {
    let one = graph.one();
    let rows = entries.chunks(count.max(1)).enumerate();
    let rows = rows.map(|(row, entries)| {
        let entries = entries.iter().enumerate();
        entries
            .map(|(column, entry)| match row == column {
                true => graph.sub(one, *entry),
                false => graph.neg(*entry),
            })
            .collect()
    });
    rows.collect()
}

fn solve(graph: &mut Graph, matrix: &[Vec<Expression>], right: &[Expression]) -> Vec<Expression> {
    match (matrix, right) {
        ([row], [right]) => vec![graph.div(*right, row[0])],
        _ => graph.solve_general(matrix, right),
    }
}
