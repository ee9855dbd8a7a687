//! The order in which the loops are closed.

use super::eliminate::Combined;
use super::{Group, Loops, angles};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Symbol};
use crate::lower::{Kind, Lowering};
use crate::motion::{Equation, Hints, UnknownName, report_imbalance};
use crate::resolve::Names;
use crate::slopes::Slopes;
use crate::structure::{Block, Incidence, Matching, blocks};

/// Largest group whose matrix is inverted by its cofactors.
const LARGEST: usize = 6;

const HINTS: Hints = Hints {
    over: "take a closure away, or declare what else it determines with `dependent`",
    under: "add a `closure` that holds it, or make it a `driver`",
};

/// The loops of a scene in their order.
#[derive(Default)]
pub struct Linkage {
    /// The scalar equations.
    pub equations: Vec<Equation>,
    /// Their kinds.
    pub kinds: Vec<Kind>,
    /// The groups, each after those it needs.
    pub groups: Vec<Group>,
    /// Which dependent coordinates are angles, the same after a turn.
    pub angles: Vec<bool>,
    /// How the equations are made of the written ones; none where they are these.
    pub combined: Option<Combined>,
}

impl Linkage {
    /// Orders the loops and recognises their groups; the derivatives of the dependent coordinates become known to
    /// `low`. `place` says in messages where this is.
    pub fn of(
        mut loops: Loops,
        names: &Names,
        place: &str,
        low: &mut Lowering<'_>,
    ) -> Option<Self> {
        let count = names.dependents.len();
        let mut ordered = Ordered::of(&loops, names, place, low)?;
        let is_iterated = |ordered: &Ordered| ordered.groups.iter().any(|one| one.closed.is_none());
        let mut combined = None;
        if is_iterated(&ordered) {
            combined = Combined::of(&mut low.graph, &mut loops, count);
            if combined.is_some() {
                ordered = Ordered::of(&loops, names, place, low)?;
            }
        }
        let Ordered { groups, blocks, angles } = ordered;
        if let Some(large) = blocks.iter().find(|block| block.unknowns.len() > LARGEST) {
            report_large(&large.equations, &loops.equations, low);
            return None;
        }
        let residuals: Vec<_> = loops.equations.iter().map(|one| one.residual).collect();
        let slopes = Slopes::new(&mut low.graph, &residuals, &blocks, count);
        let dependent = groups.iter().find(|group| is_redundant(&low.graph, &slopes, group));
        if let Some(group) = dependent {
            report_redundant(group, &loops.equations, low);
            return None;
        }
        low.slopes = Some(slopes);
        Some(Self { equations: loops.equations, kinds: loops.kinds, groups, angles, combined })
    }
}

impl Linkage {
    /// Loops that are not solved for: they hold coordinates.
    pub fn held(loops: Loops) -> Self {
        Self { equations: loops.equations, kinds: loops.kinds, ..Self::default() }
    }

    /// Whether all groups have a closed form.
    pub fn is_closed_form(&self) -> bool {
        self.groups.iter().all(|group| group.closed.is_some())
    }
}

/// Equations in the order in which they are closed.
struct Ordered {
    groups: Vec<Group>,
    blocks: Vec<Block>,
    angles: Vec<bool>,
}

impl Ordered {
    fn of(loops: &Loops, names: &Names, place: &str, low: &mut Lowering<'_>) -> Option<Self> {
        let residuals: Vec<_> = loops.equations.iter().map(|one| one.residual).collect();
        let count = names.dependents.len();
        let incidence = incidence(&low.graph, &residuals, count);
        let matching = Matching::of(&incidence);
        let unknowns: Vec<UnknownName> = names
            .dependents
            .iter()
            .map(|one| UnknownName { name: one.name.text.clone(), span: one.name.span })
            .collect();
        if !report_imbalance(
            &incidence,
            &matching,
            &loops.equations,
            &unknowns,
            (place, &HINTS),
            low.diagnostics,
        ) {
            return None;
        }
        let mut concerned: Vec<Vec<Expression>> = vec![Vec::new(); count];
        for (residual, row) in residuals.iter().zip(&incidence.rows) {
            row.iter().for_each(|column| concerned[*column].push(*residual));
        }
        let angles: Vec<bool> = (0..count as u32)
            .map(Symbol::Dependent)
            .zip(&concerned)
            .map(|(symbol, residuals)| {
                low.kind_of(symbol) == Kind::NUMBER
                    && angles::is_turn(&mut low.graph, residuals, symbol)
            })
            .collect();
        let mut blocks = blocks(&incidence, &matching);
        blocks.iter_mut().for_each(|block| block.unknowns.sort_unstable());
        let groups = blocks.iter().enumerate().map(|(mode, block)| {
            let (equations, unknowns) = (block.equations.clone(), block.unknowns.clone());
            let alike = alike(low, &loops.written, &equations, &unknowns);
            let mode = (mode as u32, &alike[..]);
            Group::of(&mut low.graph, &loops.written, equations, unknowns, &angles, mode)
        });
        let groups = groups.collect();
        Some(Self { groups, blocks, angles })
    }
}

/// The positions in the equations of a group that are of the kind of its first unknown, but for that.
fn alike(
    low: &Lowering<'_>,
    residuals: &[Expression],
    equations: &[usize],
    unknowns: &[usize],
) -> Vec<Symbol> {
    let own = Symbol::Dependent(unknowns[0] as u32);
    let residuals: Vec<_> = equations.iter().map(|row| residuals[*row]).collect();
    let symbols = low.graph.symbols(&residuals).into_iter();
    let is_alike = |symbol: &Symbol| {
        use Symbol::{Coordinate, Dependent, Driver};
        let moves = matches!(symbol, Coordinate(_) | Dependent(_) | Driver(_));
        moves && *symbol != own && low.kind_of(*symbol) == low.kind_of(own)
    };
    symbols.filter(is_alike).collect()
}

fn incidence(graph: &Graph, residuals: &[Expression], columns: usize) -> Incidence {
    let dependent = |symbol| match symbol {
        Symbol::Dependent(index) => Some(index as usize),
        _ => None,
    };
    // The order of columns decides which matching is found.
    let occurs = |residual: &Expression| {
        let symbols = graph.symbols(&[*residual]).into_iter();
        symbols.filter_map(dependent).collect()
    };
    Incidence { rows: residuals.iter().map(occurs).collect(), columns }
}

fn named(group: &[usize], equations: &[Equation]) -> String {
    let names: Vec<_> = group.iter().map(|row| format!("`{}`", equations[*row].name)).collect();
    names.join(", ")
}

fn report_large(group: &[usize], equations: &[Equation], low: &mut Lowering<'_>) {
    let message = format!(
        "{} loop equations have to be closed together ({}); at most {LARGEST} can be in this version of Assur",
        group.len(),
        named(group, equations)
    );
    let place = equations[group[0]].span;
    low.diagnostics.push(
        Diagnostic::error(place, message).hint("state the linkage by more and shorter loops"),
    );
}

/// Whether the equations of a group depend on each other at every position: then the determinant of their matrix is zero
/// wherever it is tried.
fn is_redundant(graph: &Graph, slopes: &Slopes, group: &Group) -> bool {
    (1..=3).all(|place| {
        let given = |symbol: Symbol| Graph::somewhere(symbol, place);
        let entry = |row: &usize, column: &usize| {
            slopes.entry(*row, *column).map_or(0.0, |entry| graph.evaluate(&[entry], &given)[0])
        };
        let mut matrix: Vec<Vec<f64>> = group
            .equations
            .iter()
            .map(|row| group.unknowns.iter().map(|column| entry(row, column)).collect())
            .collect();
        let size = matrix.iter().flatten().fold(0.0_f64, |most, one| most.max(one.abs()));
        smallest_pivot(&mut matrix) <= 1e-10 * size
    })
}

/// The smallest pivot of an elimination with complete pivoting.
fn smallest_pivot(matrix: &mut Vec<Vec<f64>>) -> f64 {
    let mut smallest = f64::INFINITY;
    while !matrix.is_empty() {
        let places =
            (0..matrix.len()).flat_map(|row| (0..matrix.len()).map(move |column| (row, column)));
        let size = |place: &(usize, usize)| matrix[place.0][place.1].abs();
        let best = places.max_by(|a, b| size(a).total_cmp(&size(b)));
        let (row, column) = best.unwrap_or_default();
        let pivot = matrix.swap_remove(row);
        smallest = smallest.min(pivot[column].abs());
        for other in matrix.iter_mut() {
            let factor = other[column] / pivot[column];
            other.iter_mut().zip(&pivot).for_each(|(a, b)| *a -= factor * b);
            other.remove(column);
        }
    }
    smallest
}

fn report_redundant(group: &Group, equations: &[Equation], low: &mut Lowering<'_>) {
    let message = format!(
        "the loop equations {} depend on each other: one of them follows from the others at every position",
        named(&group.equations, equations)
    );
    let place = group.equations.last().map_or(Default::default(), |row| equations[*row].span);
    low.diagnostics.push(Diagnostic::error(place, message).hint(
        "a mechanism needs one closure for each independent loop: leave the redundant one out",
    ));
}
