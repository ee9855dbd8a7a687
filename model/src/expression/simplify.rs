//! Simplifies what has been derived: opens sums that are used once, collects again, puts in forms that do not cancel.

use super::cancel;
use super::graph::{Expression, Graph, Node};
use super::hash::Map;

/// Rounds until nothing changes, at most.
const ROUNDS: usize = 6;

impl Graph {
    /// Simpler expressions with the same values. The first so many are evaluated most often: what they use once is
    /// taken into them, even if the others use it as well.
    pub fn simplify(&mut self, roots: &[Expression], often: usize) -> Vec<Expression> {
        let mut current = roots.to_vec();
        for _ in 0..ROUNDS {
            let next = self.round(&current, often);
            if next == current {
                break;
            }
            current = next;
        }
        current
    }

    fn round(&mut self, roots: &[Expression], often: usize) -> Vec<Expression> {
        let reachable = self.reachable(roots);
        let uses = self.uses(roots, often);
        let mut new: Map<Expression, Expression> = Map::default();
        for old in reachable {
            let node = self.node(old).clone();
            let value = match &node {
                Node::Sum(terms) => self.open_sum(terms, &uses, &new),
                Node::Product(factors) => self.distribute_sign(factors, &uses, &new),
                _ => self.rebuild(&node, &|operand| new[&operand]),
            };
            self.carry_name(old, value);
            new.insert(old, value);
        }
        roots.iter().map(|root| new[root]).collect()
    }

    /// How often each node is an operand or a root, counted among the first so many roots wherever it occurs there.
    pub fn uses(&self, roots: &[Expression], often: usize) -> Map<Expression, usize> {
        let mut uses = self.uses_in(roots);
        uses.extend(self.uses_in(&roots[..often.min(roots.len())]));
        uses
    }

    fn uses_in(&self, roots: &[Expression]) -> Map<Expression, usize> {
        let mut uses: Map<Expression, usize> = Map::default();
        for root in roots {
            *uses.entry(*root).or_insert(0) += 1;
        }
        for one in self.reachable(roots) {
            for operand in self.node(one).operands() {
                *uses.entry(operand).or_insert(0) += 1;
            }
        }
        uses
    }

    /// A sum whose terms that are sums, with a sign, and used nowhere else are opened.
    fn open_sum(
        &mut self,
        terms: &[Expression],
        uses: &Map<Expression, usize>,
        new: &Map<Expression, Expression>,
    ) -> Expression {
        // What cancels is looked for in what was derived, before the terms take forms of their own.
        if let Some(better) = cancel::sum(self, terms) {
            return self.sum(&better);
        }
        let mut list = Vec::new();
        for term in terms {
            let value = new[term];
            let (coefficient, rest) = self.split_coefficient(value);
            // The inner sum of `-(a + b)` is an operand of the product, which is an operand of this one.
            let inner = match self.node(*term) {
                Node::Product(factors) if factors.len() == 2 => factors[1],
                _ => *term,
            };
            let alone = uses.get(term) == Some(&1) && uses.get(&inner) == Some(&1);
            match self.node(rest).clone() {
                Node::Sum(inner) if alone && coefficient.abs() == 1.0 => {
                    for one in inner.iter() {
                        list.push(self.scale(coefficient, *one));
                    }
                }
                _ => list.push(value),
            }
        }
        while let Some(better) = cancel::sum(self, &list) {
            list = better;
        }
        self.sum(&list)
    }

    /// `-1*(a - b)*c` is `(b - a)*c`, if the sum is used nowhere else.
    fn distribute_sign(
        &mut self,
        factors: &[Expression],
        uses: &Map<Expression, usize>,
        new: &Map<Expression, Expression>,
    ) -> Expression {
        let mut values: Vec<_> = factors.iter().map(|factor| new[factor]).collect();
        let negative = self.as_number(values[0]).is_some_and(|number| number < 0.0);
        let alone = |graph: &Graph, index: usize| {
            uses.get(&factors[index]) == Some(&1)
                && graph.name_of(factors[index]).is_none()
                && matches!(graph.node(values[index]), Node::Sum(_))
        };
        if negative && let Some(index) = (1..values.len()).find(|index| alone(self, *index)) {
            let Node::Sum(terms) = self.node(values[index]).clone() else {
                return self.product(&values);
            };
            let turned: Vec<_> = terms.iter().map(|term| self.neg(*term)).collect();
            values[index] = self.sum(&turned);
            values[0] = self.neg(values[0]);
        }
        self.product(&values)
    }
}
