//! A largest matching of equations with unknowns, and what Dulmage and Mendelsohn read from it.
//!
//! A. L. Dulmage, N. S. Mendelsohn, "Coverings of bipartite graphs", Canad. J. Math. 10 (1958).

use super::Incidence;

/// A largest matching.
#[derive(Clone, Debug)]
pub struct Matching {
    /// For each equation the unknown that it determines.
    pub unknown_of: Vec<Option<usize>>,
    /// For each unknown the equation that determines it.
    pub equation_of: Vec<Option<usize>>,
}

/// The parts of a system that are determined too often, or not at all.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Imbalance {
    /// Equations of which at least one is too many, with all unknowns that occur in them.
    pub overdetermined: Option<(Vec<usize>, Vec<usize>)>,
    /// Unknowns of which at least one is not determined, with all equations that could determine them.
    pub underdetermined: Option<(Vec<usize>, Vec<usize>)>,
}

impl Matching {
    /// Finds a largest matching by augmenting paths.
    pub fn of(incidence: &Incidence) -> Self {
        let mut matching = Self {
            unknown_of: vec![None; incidence.rows.len()],
            equation_of: vec![None; incidence.columns],
        };
        for equation in 0..incidence.rows.len() {
            matching.augment(incidence, equation);
        }
        matching
    }

    /// Looks for a path from a free equation to a free unknown, breadth first, and flips it.
    fn augment(&mut self, incidence: &Incidence, start: usize) {
        let mut came_from = vec![None; incidence.columns];
        let mut queue = std::collections::VecDeque::from([start]);
        while let Some(equation) = queue.pop_front() {
            for &unknown in &incidence.rows[equation] {
                if came_from[unknown].is_some() {
                    continue;
                }
                came_from[unknown] = Some(equation);
                match self.equation_of[unknown] {
                    Some(next) => queue.push_back(next),
                    None => {
                        self.flip(&came_from, unknown);
                        return;
                    }
                }
            }
        }
    }

    fn flip(&mut self, came_from: &[Option<usize>], end: usize) {
        let mut unknown = end;
        while let Some(equation) = came_from[unknown] {
            let previous = self.unknown_of[equation].replace(unknown);
            self.equation_of[unknown] = Some(equation);
            match previous {
                Some(next) => unknown = next,
                None => return,
            }
        }
    }

    /// What is determined too often or not at all.
    pub fn imbalance(&self, incidence: &Incidence) -> Imbalance {
        Imbalance {
            overdetermined: self.reached_by_free_equations(incidence),
            underdetermined: self.reached_by_free_unknowns(incidence),
        }
    }

    /// Everything on alternating paths from the equations that found no unknown.
    fn reached_by_free_equations(&self, incidence: &Incidence) -> Option<(Vec<usize>, Vec<usize>)> {
        let mut equations: Vec<bool> = self.unknown_of.iter().map(Option::is_none).collect();
        let mut unknowns = vec![false; incidence.columns];
        let mut stack: Vec<_> = (0..equations.len()).filter(|&row| equations[row]).collect();
        while let Some(equation) = stack.pop() {
            for &unknown in &incidence.rows[equation] {
                if !std::mem::replace(&mut unknowns[unknown], true)
                    && let Some(next) = self.equation_of[unknown]
                    && !std::mem::replace(&mut equations[next], true)
                {
                    stack.push(next);
                }
            }
        }
        let found = marked(&equations);
        (!found.is_empty()).then(|| (found, marked(&unknowns)))
    }

    /// Everything on alternating paths from the unknowns that found no equation.
    fn reached_by_free_unknowns(&self, incidence: &Incidence) -> Option<(Vec<usize>, Vec<usize>)> {
        let mut unknowns: Vec<bool> = self.equation_of.iter().map(Option::is_none).collect();
        let mut equations = vec![false; incidence.rows.len()];
        let mut changed = unknowns.contains(&true);
        while changed {
            changed = false;
            for (row, members) in incidence.rows.iter().enumerate() {
                if !equations[row] && members.iter().any(|&unknown| unknowns[unknown]) {
                    equations[row] = true;
                    if let Some(unknown) = self.unknown_of[row] {
                        unknowns[unknown] = true;
                    }
                    changed = true;
                }
            }
        }
        let found = marked(&unknowns);
        (!found.is_empty()).then(|| (found, marked(&equations)))
    }
}

fn marked(flags: &[bool]) -> Vec<usize> {
    (0..flags.len()).filter(|&index| flags[index]).collect()
}
