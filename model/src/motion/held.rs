//! Coordinates that closures hold: the last equations are the second time derivatives of the closures, and behind them the
//! third ones, which say what the second do not where closures depend on each other for an instant. The forces of the
//! closures are unknown beside the accelerations.

use std::ops::Range;

use super::{Equation, UnknownName};
use crate::expression::Symbol;
use crate::structure::Incidence;

/// The equations that belong together because closures hold their coordinates.
pub struct Held<'a> {
    /// Lagrange's equations, each with its coordinate.
    pub moved: Vec<(usize, usize)>,
    /// The second time derivatives of the closures; as many third ones follow.
    pub closures: Range<usize>,
    /// How many of them are independent.
    pub rank: usize,
    /// How large their slopes are.
    pub sizes: &'a [f64],
    /// Number of the highest derivatives, behind which the forces are counted.
    highest: usize,
}

impl<'a> Held<'a> {
    /// Of equations for so many highest derivatives; those that are too many are closures, of which a number is
    /// independent, with the sizes of their slopes.
    pub fn of(equations: &[Equation], highest: usize, (rank, sizes): (usize, &'a [f64])) -> Self {
        let count = equations.len();
        let closures = match rank {
            0 => count..count,
            _ => highest.min(count)..highest.min(count) + count.saturating_sub(highest) / 2,
        };
        let derived = equations.iter().enumerate();
        let moved = derived.filter_map(|(row, equation)| Some((row, equation.lagrange?))).collect();
        Self { moved, closures, rank, sizes, highest }
    }

    /// The forces of the closures.
    pub fn forces(&self) -> impl Iterator<Item = Symbol> {
        (0..self.closures.len() as u32).map(Symbol::Reaction)
    }

    /// What the forces are called.
    pub fn names(&self, equations: &[Equation]) -> Vec<UnknownName> {
        let closures = equations[self.closures.clone()].iter();
        let name = |one: &Equation| UnknownName {
            name: format!("reaction({})", one.name),
            span: one.span,
        };
        closures.map(name).collect()
    }

    /// Lets every equation of these be solved together with the others.
    pub fn join(&self, incidence: &mut Incidence) {
        if self.closures.is_empty() {
            return;
        }
        let forces = self.highest..self.highest + self.closures.len();
        let unknowns: Vec<usize> = self.moved.iter().map(|one| one.1).chain(forces).collect();
        let rows = self.moved.iter().map(|one| one.0).chain(self.closures.clone());
        for row in rows {
            let own = &mut incidence.rows[row];
            own.extend(&unknowns);
            own.sort_unstable();
            own.dedup();
        }
    }

    /// The third time derivatives of the closures.
    pub fn thirds(&self) -> Range<usize> {
        self.closures.end..self.closures.end + self.closures.len()
    }

    /// The unknowns of some equations if they are these and no others: the coordinates, then the forces; with the equations in
    /// that order, the third derivatives of the closures behind them.
    pub fn order(&self, equations: &[usize]) -> Option<(Vec<usize>, Vec<usize>)> {
        let rows: Vec<usize> =
            self.moved.iter().map(|one| one.0).chain(self.closures.clone()).collect();
        let is_all =
            rows.len() == equations.len() && rows.iter().all(|row| equations.contains(row));
        let forces = self.highest..self.highest + self.closures.len();
        let unknowns = self.moved.iter().map(|one| one.1).chain(forces).collect();
        let rows = rows.into_iter().chain(self.thirds()).collect();
        (is_all && !self.closures.is_empty()).then_some((rows, unknowns))
    }
}
