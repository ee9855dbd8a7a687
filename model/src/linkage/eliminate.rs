//! Closures combined such that coordinates that enter linearly with numbers, the places of bodies above all, each stand in
//! one of them: what is left of the others are loops of links.

use super::Loops;
use crate::expression::{Expression, Graph, Node, Symbol};

/// Equations as combinations of the written ones.
#[derive(Clone, Debug, Default)]
pub struct Combined {
    /// For each equation its shares of the written ones.
    shares: Vec<Vec<f64>>,
}

impl Combined {
    /// Combines the equations of some loops. None where there is nothing to combine.
    pub fn of(graph: &mut Graph, loops: &mut Loops, dependents: usize) -> Option<Self> {
        let count = loops.equations.len();
        let residuals: Vec<_> = loops.equations.iter().map(|one| one.residual).collect();
        let symbols: Vec<_> = (0..dependents as u32).map(Symbol::Dependent).collect();
        let mut columns: Vec<Option<Vec<f64>>> = vec![Some(vec![0.0; count]); dependents];
        for (row, column, slope) in graph.jacobian(&residuals, &symbols) {
            match (graph.as_number(slope), &mut columns[column]) {
                (Some(number), Some(entries)) => entries[row] = number,
                _ => columns[column] = None,
            }
        }
        let mut linear: Vec<Vec<f64>> = columns.into_iter().flatten().collect();
        let mut shares: Vec<Vec<f64>> = (0..count)
            .map(|row| (0..count).map(|other| f64::from(u8::from(row == other))).collect())
            .collect();
        let mut used = vec![false; count];
        let mut is_changed = false;
        for index in 0..linear.len() {
            let size = |row: &usize| linear[index][*row].abs();
            let free = (0..count).filter(|row| !used[*row]);
            let Some(pivot) = free.max_by(|a, b| size(a).total_cmp(&size(b))) else {
                break;
            };
            if size(&pivot) == 0.0 {
                continue;
            }
            used[pivot] = true;
            for row in (0..count).filter(|row| *row != pivot) {
                let factor = linear[index][row] / linear[index][pivot];
                if factor == 0.0 {
                    continue;
                }
                is_changed = true;
                for column in &mut linear {
                    column[row] -= factor * column[pivot];
                }
                let own = shares[pivot].clone();
                for (share, own) in shares[row].iter_mut().zip(own) {
                    *share -= factor * own;
                }
            }
        }
        if !is_changed {
            return None;
        }
        let combined = Self { shares };
        let sums = combined.forward(graph, &residuals);
        let names: Vec<String> = loops.equations.iter().map(|one| one.name.clone()).collect();
        for ((equation, residual), shares) in
            loops.equations.iter_mut().zip(sums).zip(&combined.shares)
        {
            equation.residual = residual;
            let parts = names.iter().zip(shares).filter(|(_, share)| **share != 0.0);
            let parts: Vec<&str> = parts.map(|(name, _)| name.as_str()).collect();
            equation.name = parts.join(" and ");
        }
        loops.written = combined.forward(graph, &loops.written);
        Some(combined)
    }

    /// The combinations of some expressions, one for each equation.
    fn forward(&self, graph: &mut Graph, written: &[Expression]) -> Vec<Expression> {
        // Term by term, so that what cancels is gone.
        let sum = |graph: &mut Graph, shares: &[f64]| {
            let mut terms = Vec::new();
            for (share, one) in shares.iter().zip(written).filter(|(share, _)| **share != 0.0) {
                let own = match graph.node(*one) {
                    Node::Sum(terms) => terms.to_vec(),
                    _ => vec![*one],
                };
                terms.extend(own.into_iter().map(|term| graph.scale(*share, term)));
            }
            graph.sum(&terms)
        };
        self.shares.iter().map(|shares| sum(graph, shares)).collect()
    }

    /// The multipliers of the written equations from those of the combined ones.
    pub fn back(&self, graph: &mut Graph, multipliers: &[Expression]) -> Vec<Expression> {
        let count = multipliers.len();
        let of = |graph: &mut Graph, written: usize| {
            let pairs = self.shares.iter().zip(multipliers);
            let terms: Vec<_> =
                pairs.map(|(shares, one)| graph.scale(shares[written], *one)).collect();
            graph.sum(&terms)
        };
        (0..count).map(|written| of(graph, written)).collect()
    }
}
