//! Which coordinates stay independent where closures bind more of them than are declared dependent.
//!
//! Coordinates that enter all closures linearly with numbers, such as the places of bodies, are determined first: that
//! never fails. Of the others those that are declared last give way, unless the closures then determine them badly where
//! the motion begins.

use std::collections::BTreeSet;

use super::Loops;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Symbol};
use crate::lower::Lowering;
use crate::motion::Equation;

/// What a column has to keep of its size beside the columns before it: a good choice, one that will do, any.
const LEFT: [f64; 3] = [0.3, 1e-2, 1e-7];
/// What is less, over the size of its row, is zero.
const NOTHING: f64 = 1e-9;

/// A coordinate that may be determined, with its column of the Jacobian.
pub(super) struct Column {
    pub symbol: Symbol,
    pub entries: Vec<f64>,
    pub size: f64,
}

/// The coordinates that the closures determine, rising; none where the declared dependent ones are as many as the
/// equations. `at` gives a value for each symbol where the motion begins. With what is wrong if the closures are too many.
pub fn bound(
    loops: &Loops,
    at: &dyn Fn(Symbol) -> f64,
    low: &mut Lowering<'_>,
) -> (Vec<usize>, Option<Diagnostic>) {
    let residuals: Vec<_> = loops.equations.iter().map(|one| one.residual).collect();
    let dependents = low.names.dependents.len();
    let coordinates = low.names.coordinates.len();
    let wanted = residuals.len().saturating_sub(dependents);
    let occurring = low.graph.symbols(&residuals);
    let binds = |index: &usize| occurring.contains(&Symbol::Coordinate(*index as u32));
    let candidates: Vec<usize> = (0..coordinates).filter(binds).collect();
    if wanted == 0 || candidates.is_empty() {
        return (Vec::new(), None);
    }
    let mut symbols: Vec<Symbol> = (0..dependents as u32).map(Symbol::Dependent).collect();
    symbols.extend(order(&mut low.graph, &residuals, &candidates));
    let columns = columns(&mut low.graph, &residuals, &symbols, at);
    let chosen = choose(columns, residuals.len(), dependents);
    let redundant = match chosen.len() < residuals.len() {
        true => redundant(&loops.equations, &chosen),
        false => None,
    };
    let mut bound: Vec<usize> = chosen
        .into_iter()
        .filter_map(|(symbol, _)| match symbol {
            Symbol::Coordinate(index) => Some(index as usize),
            _ => None,
        })
        .collect();
    bound.sort_unstable();
    (bound, redundant)
}

/// Some coordinates in the order in which closures determine them.
pub(super) fn order(
    graph: &mut Graph,
    residuals: &[Expression],
    coordinates: &[usize],
) -> Vec<Symbol> {
    let symbols = coordinates.iter().rev().map(|index| Symbol::Coordinate(*index as u32));
    let mut symbols: Vec<Symbol> = symbols.collect();
    symbols.sort_by_key(|symbol| !is_linear(graph, residuals, *symbol));
    symbols
}

/// Whether a symbol enters all equations linearly with numbers.
fn is_linear(graph: &mut Graph, residuals: &[Expression], symbol: Symbol) -> bool {
    let slopes = graph.jacobian(residuals, &[symbol]);
    slopes.iter().all(|(_, _, slope)| graph.as_number(*slope).is_some())
}

/// The columns of the Jacobian where the motion begins, each row over its largest entry.
fn columns(
    graph: &mut Graph,
    residuals: &[Expression],
    symbols: &[Symbol],
    at: &dyn Fn(Symbol) -> f64,
) -> Vec<Column> {
    let mut columns: Vec<Column> = symbols
        .iter()
        .map(|symbol| Column { symbol: *symbol, entries: vec![0.0; residuals.len()], size: 0.0 })
        .collect();
    let slopes = graph.jacobian(residuals, symbols);
    let values: Vec<_> = slopes.iter().map(|one| one.2).collect();
    for ((row, column, _), value) in slopes.iter().zip(graph.evaluate(&values, at)) {
        columns[*column].entries[*row] = value;
    }
    for row in 0..residuals.len() {
        let largest = columns.iter().fold(0.0_f64, |most, one| most.max(one.entries[row].abs()));
        if largest > 0.0 {
            columns.iter_mut().for_each(|one| one.entries[row] /= largest);
        }
    }
    columns.iter_mut().for_each(Column::measure);
    columns
}

impl Column {
    /// Finds how large it is.
    pub fn measure(&mut self) {
        self.size = self.entries.iter().map(|one| one * one).sum::<f64>().sqrt();
    }
}

/// Eliminates column by column in their order, as long as enough is left of one; none but the first ones before all of these
/// have been tried. Gives the columns with their rows.
pub(super) fn choose(mut columns: Vec<Column>, rows: usize, first: usize) -> Vec<(Symbol, usize)> {
    let mut chosen: Vec<(Symbol, usize)> = Vec::new();
    let mut used: BTreeSet<usize> = BTreeSet::new();
    let mut left_of_first = first.min(columns.len());
    let levels = LEFT.map(|left| (left, true)).into_iter().chain(LEFT.map(|left| (left, false)));
    for (left, is_first) in levels {
        let mut index = 0;
        while index < if is_first { left_of_first } else { columns.len() } && chosen.len() < rows {
            let free = (0..rows).filter(|row| !used.contains(row));
            let size = |row: &usize| columns[index].entries[*row].abs();
            let best = free.max_by(|a, b| size(a).total_cmp(&size(b)));
            let Some(row) = best.filter(|row| {
                let column = &columns[index];
                let rest = column.entries.iter().enumerate();
                let rest = rest.filter(|one| !used.contains(&one.0)).map(|one| one.1 * one.1);
                size(row) > NOTHING && rest.sum::<f64>().sqrt() > left * column.size
            }) else {
                index += 1;
                continue;
            };
            let column = columns.remove(index);
            left_of_first -= usize::from(is_first);
            for other in &mut columns {
                let factor = other.entries[row] / column.entries[row];
                for (entry, own) in other.entries.iter_mut().zip(&column.entries) {
                    *entry -= factor * own;
                }
                // What the row has had is kept beside what is left.
                other.entries[row] = factor * column.entries[row];
            }
            used.insert(row);
            chosen.push((column.symbol, row));
        }
    }
    chosen
}

fn redundant(equations: &[Equation], chosen: &[(Symbol, usize)]) -> Option<Diagnostic> {
    let rest = (0..equations.len()).filter(|row| chosen.iter().all(|one| one.1 != *row));
    let rest: Vec<&Equation> = rest.map(|row| &equations[row]).collect();
    let names: Vec<_> = rest.iter().map(|one| format!("`{}`", one.name)).collect();
    let message = format!(
        "where the motion begins only {} of the {} scalar closures are independent: {} says what the others say, or contradicts them",
        chosen.len(),
        equations.len(),
        names.join(", "),
    );
    Some(Diagnostic::error(rest.first()?.span, message).hint(
        "a mechanism needs one closure for each independent loop: leave the redundant one out, or begin elsewhere",
    ))
}
