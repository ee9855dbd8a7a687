//! Expressions as polynomials in some symbols.

use std::collections::BTreeMap;

use super::graph::{Expression, Graph, Node, Symbol};
use super::hash::Map;

/// Sum of the powers in a term at most.
const HIGHEST: u32 = 12;

/// Terms at most.
const MOST: usize = 200;

/// Coefficients by the powers of the symbols.
pub type Polynomial = BTreeMap<Vec<u32>, Expression>;

impl Graph {
    /// An expression as a polynomial in some symbols, on which its coefficients do not depend; none if it is none, or one of a
    /// high degree or of very many terms.
    pub fn polynomial(&mut self, expression: Expression, symbols: &[Symbol]) -> Option<Polynomial> {
        Expansion { graph: self, symbols, known: Map::default() }.of(expression)
    }
}

struct Expansion<'a> {
    graph: &'a mut Graph,
    symbols: &'a [Symbol],
    known: Map<Expression, Polynomial>,
}

impl Expansion<'_> {
    fn of(&mut self, expression: Expression) -> Option<Polynomial> {
        if !self.graph.depends_on(expression, |symbol| self.symbols.contains(&symbol)) {
            return Some(Polynomial::from([(vec![0; self.symbols.len()], expression)]));
        }
        if let Some(known) = self.known.get(&expression) {
            return Some(known.clone());
        }
        let found = match self.graph.node(expression).clone() {
            Node::Symbol(symbol) => {
                let own = self.symbols.iter().map(|one| u32::from(*one == symbol)).collect();
                Polynomial::from([(own, self.graph.one())])
            }
            Node::Sum(terms) => {
                let mut sum = Polynomial::new();
                for term in terms {
                    for (powers, coefficient) in self.of(term)? {
                        self.add(&mut sum, powers, coefficient);
                    }
                }
                sum
            }
            Node::Product(factors) => {
                let mut product =
                    Polynomial::from([(vec![0; self.symbols.len()], self.graph.one())]);
                for factor in factors {
                    let factor = self.of(factor)?;
                    product = self.product(&product, &factor)?;
                }
                product
            }
            Node::Power(base, exponent) => {
                let exponent = self.graph.as_number(exponent)?;
                let times = (0..=HIGHEST).find(|times| f64::from(*times) == exponent)?;
                let base = self.of(base)?;
                let mut power = Polynomial::from([(vec![0; self.symbols.len()], self.graph.one())]);
                for _ in 0..times {
                    power = self.product(&power, &base)?;
                }
                power
            }
            Node::Whole(inner) => self.of(inner)?,
            _ => return None,
        };
        self.known.insert(expression, found.clone());
        Some(found)
    }

    fn product(&mut self, a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
        let mut product = Polynomial::new();
        for (first, x) in a {
            for (second, y) in b {
                let powers: Vec<u32> = first.iter().zip(second).map(|(a, b)| a + b).collect();
                if powers.iter().sum::<u32>() > HIGHEST {
                    return None;
                }
                let coefficient = self.graph.mul(*x, *y);
                self.add(&mut product, powers, coefficient);
                if product.len() > MOST {
                    return None;
                }
            }
        }
        Some(product)
    }

    /// Adds a term; terms that cancel are none.
    fn add(&mut self, sum: &mut Polynomial, powers: Vec<u32>, coefficient: Expression) {
        let there = sum.remove(&powers).unwrap_or_else(|| self.graph.zero());
        let all = self.graph.add(there, coefficient);
        if all != self.graph.zero() {
            sum.insert(powers, all);
        }
    }
}
