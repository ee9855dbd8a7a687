//! Pulls common factors out of sums, those first that change most often: what multiplies a coordinate then becomes a
//! coefficient that is computed once an instant.

use std::collections::BTreeMap;

use super::Stage;
use super::build::Request;
use crate::expression::{Expression, Graph, Map, Node, Set};

/// The expressions with common factors pulled out.
pub fn collect(
    graph: &mut Graph,
    roots: &[Expression],
    often: usize,
    request: &Request,
) -> Vec<Expression> {
    let reachable = graph.reachable(roots);
    let uses = graph.uses(roots, often);
    let mut new: Map<Expression, Expression> = Map::default();
    for old in reachable {
        let node = graph.node(old).clone();
        let value = match &node {
            Node::Sum(terms) => {
                let terms: Vec<Term> = terms
                    .iter()
                    .map(|term| {
                        // What is used elsewhere as well is left whole.
                        let whole = uses.get(term).copied().unwrap_or(0) > 1;
                        Term::read(graph, new[term], whole)
                    })
                    .collect();
                factored(graph, terms, request)
            }
            _ => graph.rebuild_with(&node, &new),
        };
        graph.carry(old, value);
        new.insert(old, value);
    }
    let collected: Vec<_> = roots.iter().map(|root| new[root]).collect();
    share_signs(graph, &collected)
}

/// Of a sum and its negative one is computed: the other is minus it.
fn share_signs(graph: &mut Graph, roots: &[Expression]) -> Vec<Expression> {
    let reachable = graph.reachable(roots);
    let known: Set<Expression> = reachable.iter().copied().collect();
    let mut new: Map<Expression, Expression> = Map::default();
    for old in reachable {
        let node = graph.node(old).clone();
        let value = match &node {
            Node::Sum(terms) => {
                let turned: Vec<_> = terms.iter().map(|term| graph.neg(*term)).collect();
                let opposite = graph.sum(&turned);
                match new
                    .get(&opposite)
                    .copied()
                    .filter(|_| known.contains(&opposite))
                {
                    Some(earlier) => graph.neg(earlier),
                    None => graph.rebuild_with(&node, &new),
                }
            }
            _ => graph.rebuild_with(&node, &new),
        };
        graph.carry(old, value);
        new.insert(old, value);
    }
    roots.iter().map(|root| new[root]).collect()
}

/// A term as a number and powers of factors.
#[derive(Clone)]
struct Term {
    coefficient: f64,
    powers: BTreeMap<Expression, f64>,
}

impl Term {
    fn read(graph: &mut Graph, term: Expression, whole: bool) -> Self {
        let (coefficient, rest) = match graph.as_number(term) {
            Some(number) => (number, graph.one()),
            None => graph.split_coefficient(term),
        };
        let factors = match graph.node(rest) {
            Node::Product(factors) if !whole => factors.to_vec(),
            Node::Number(_) => Vec::new(),
            _ => vec![rest],
        };
        let mut powers = BTreeMap::new();
        for factor in factors {
            let (base, exponent) = match graph.node(factor) {
                Node::Power(base, exponent) => match graph.as_number(*exponent) {
                    Some(number) if number.fract() == 0.0 => (*base, number),
                    _ => (factor, 1.0),
                },
                _ => (factor, 1.0),
            };
            *powers.entry(base).or_insert(0.0) += exponent;
        }
        Self {
            coefficient,
            powers,
        }
    }

    fn write(&self, graph: &mut Graph) -> Expression {
        let mut factors = vec![graph.number(self.coefficient)];
        for (base, exponent) in &self.powers {
            factors.push(graph.powi(*base, *exponent as i32));
        }
        graph.product(&factors)
    }
}

/// A sum with its common factors pulled out.
fn factored(graph: &mut Graph, mut terms: Vec<Term>, request: &Request) -> Expression {
    let mut done = Vec::new();
    while let Some((base, sign)) = most_common(graph, &terms, request) {
        let has = |term: &Term| {
            term.powers
                .get(&base)
                .is_some_and(|exponent| exponent * sign > 0.0)
        };
        let (mut inside, outside): (Vec<Term>, Vec<Term>) = terms.into_iter().partition(has);
        let least = inside
            .iter()
            .map(|term| term.powers[&base].abs())
            .fold(f64::INFINITY, f64::min);
        for term in &mut inside {
            let left = term.powers[&base] - sign * least;
            term.powers.remove(&base);
            if left != 0.0 {
                term.powers.insert(base, left);
            }
        }
        let sum = factored(graph, inside, request);
        let factor = graph.powi(base, (sign * least) as i32);
        done.push(graph.mul(factor, sum));
        terms = outside;
    }
    done.extend(terms.iter().map(|term| term.write(graph)));
    graph.sum(&done)
}

/// The factor that is pulled out next, with the sign of its exponents: it changes as often as any, and occurs in most
/// terms, at least two.
fn most_common(graph: &Graph, terms: &[Term], request: &Request) -> Option<(Expression, f64)> {
    let mut counts: BTreeMap<(Expression, bool), usize> = BTreeMap::new();
    for term in terms {
        graph.budget().spend(term.powers.len());
        for (base, exponent) in &term.powers {
            *counts.entry((*base, *exponent > 0.0)).or_insert(0) += 1;
        }
    }
    counts
        .into_iter()
        .filter(|(_, count)| *count > 1)
        .max_by_key(|((base, positive), count)| {
            let stage: Stage = request.stage(graph, *base);
            (stage, *count, *positive, std::cmp::Reverse(*base))
        })
        .map(|((base, positive), _)| (base, if positive { 1.0 } else { -1.0 }))
}
