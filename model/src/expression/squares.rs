//! Sums of squares, term by term.

use super::graph::{Expression, Graph, Node};

impl Graph {
    /// The numbers of which an expression is the sum of the squares; none if it is no such sum.
    pub fn squares(&mut self, expression: Expression) -> Option<Vec<Expression>> {
        match self.node(expression).clone() {
            Node::Whole(inner) => self.squares(inner),
            Node::Sum(terms) => {
                let each = terms.iter().map(|term| self.squares(*term));
                Some(each.collect::<Option<Vec<_>>>()?.concat())
            }
            Node::Product(factors) => self.product_of_squares(&factors),
            _ => Some(vec![self.square_root(expression)?]),
        }
    }

    /// All factors are squares but one at most, which is a sum of them.
    fn product_of_squares(&mut self, factors: &[Expression]) -> Option<Vec<Expression>> {
        let roots: Vec<_> =
            factors.iter().map(|factor| (*factor, self.square_root(*factor))).collect();
        let mut others = roots.iter().filter(|(_, root)| root.is_none());
        let sum = others.next().map(|(factor, _)| *factor);
        if others.next().is_some() {
            return None;
        }
        let common: Vec<Expression> = roots.iter().filter_map(|(_, root)| *root).collect();
        let common = self.product(&common);
        let Some(sum) = sum else { return Some(vec![common]) };
        let terms = self.squares(sum)?;
        Some(terms.into_iter().map(|term| self.product(&[common, term])).collect())
    }

    /// What an expression is the square of, as far as it shows.
    fn square_root(&mut self, expression: Expression) -> Option<Expression> {
        match *self.node(expression) {
            Node::Number(value) if value.get() >= 0.0 => Some(self.number(value.get().sqrt())),
            Node::Power(base, exponent) => {
                let half = 0.5 * self.as_number(exponent)?;
                let half = (half.fract() == 0.0).then(|| self.number(half))?;
                Some(self.pow(base, half))
            }
            _ => None,
        }
    }
}
