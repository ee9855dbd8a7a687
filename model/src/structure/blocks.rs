//! Block-triangular order: the smallest groups of equations that have to be solved together, each after those it needs.
//!
//! R. Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1 (1972).

use super::{Incidence, Matching};

/// Equations that are solved together for as many unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// The equations, rising.
    pub equations: Vec<usize>,
    /// The unknowns, in the order of the equations that are matched with them.
    pub unknowns: Vec<usize>,
}

/// The blocks of a balanced system, in an order in which each needs only unknowns of earlier ones.
pub fn blocks(incidence: &Incidence, matching: &Matching) -> Vec<Block> {
    let size = incidence.rows.len();
    let mut search = Search {
        incidence,
        matching,
        order: vec![None; size],
        low: vec![0; size],
        on_stack: vec![false; size],
        stack: Vec::new(),
        count: 0,
        found: Vec::new(),
    };
    for equation in 0..size {
        if search.order[equation].is_none() {
            search.visit(equation);
        }
    }
    search.found
}

struct Search<'a> {
    incidence: &'a Incidence,
    matching: &'a Matching,
    order: Vec<Option<usize>>,
    low: Vec<usize>,
    on_stack: Vec<bool>,
    stack: Vec<usize>,
    count: usize,
    found: Vec<Block>,
}

impl Search<'_> {
    /// Depth-first search with its own stack, so that no long chain of equations can exhaust the machine's.
    fn visit(&mut self, root: usize) {
        let mut path: Vec<(usize, usize)> = Vec::new();
        self.enter(root);
        path.push((root, 0));
        while let Some((equation, next)) = path.last().copied() {
            if let Some(&unknown) = self.incidence.rows[equation].get(next) {
                if let Some(last) = path.last_mut() {
                    last.1 += 1;
                }
                let Some(needed) = self.matching.equation_of[unknown] else {
                    continue;
                };
                match self.order[needed] {
                    None => {
                        self.enter(needed);
                        path.push((needed, 0));
                    }
                    Some(order) if self.on_stack[needed] => {
                        self.low[equation] = self.low[equation].min(order);
                    }
                    Some(_) => {}
                }
            } else {
                path.pop();
                if let Some((parent, _)) = path.last() {
                    self.low[*parent] = self.low[*parent].min(self.low[equation]);
                }
                if self.order[equation] == Some(self.low[equation]) {
                    self.close(equation);
                }
            }
        }
    }

    fn enter(&mut self, equation: usize) {
        self.order[equation] = Some(self.count);
        self.low[equation] = self.count;
        self.count += 1;
        self.stack.push(equation);
        self.on_stack[equation] = true;
    }

    fn close(&mut self, root: usize) {
        let mut equations = Vec::new();
        while let Some(equation) = self.stack.pop() {
            self.on_stack[equation] = false;
            equations.push(equation);
            if equation == root {
                break;
            }
        }
        equations.sort_unstable();
        let unknowns =
            equations.iter().filter_map(|&equation| self.matching.unknown_of[equation]).collect();
        self.found.push(Block { equations, unknowns });
    }
}
