//! Products as operations: in which order their factors are multiplied, so that they share what they have in common.

use super::emit::{Emitter, STAGES};
use super::{OperationKind, Stage, Value};
use crate::expression::{Expression, Node};

/// The factors of a product with their stages, in the order in which they are multiplied.
type Factors = Vec<(Stage, Expression)>;

impl Emitter<'_> {
    /// Counts how a product begins and ends.
    pub(super) fn count(&mut self, expression: Expression) {
        let Node::Product(factors) = self.graph.node(expression).clone() else {
            return;
        };
        let has_minus = self.graph.as_number(factors[0]) == Some(-1.0);
        let (numerators, denominators) = self.quotient(&factors[usize::from(has_minus)..]);
        if let (Some((earlier, own)), []) = (split(&numerators), &denominators[..]) {
            let beginning = (earlier, own[0]);
            *self.beginnings.entry(beginning).or_insert(0) += 1;
            *self.endings.entry(own).or_insert(0) += 1;
        }
    }

    /// Whether a product shares with others what it begins with, and not what it ends with.
    fn begins_alike(&self, numerators: &Factors) -> bool {
        split(numerators).is_some_and(|(earlier, own)| {
            let beginning = (earlier, own[0]);
            self.beginnings.get(&beginning) > Some(&1) && self.endings.get(&own) == Some(&1)
        })
    }

    /// The factors of a product that multiply, and those that divide.
    fn quotient(&mut self, factors: &[Expression]) -> (Factors, Factors) {
        let mut numerators = Factors::new();
        let mut denominators = Factors::new();
        for factor in factors {
            let stage = self.expression_stage(*factor);
            let inverse = match self.graph.node(*factor) {
                Node::Power(base, exponent) => match self.graph.as_number(*exponent) {
                    // What divides once is a denominator; what divides often is inverted once.
                    Some(number) if number < 0.0 && self.uses.get(factor) == Some(&1) => {
                        Some((*base, -number))
                    }
                    _ => None,
                },
                _ => None,
            };
            match inverse {
                Some((base, exponent)) => {
                    let exponent = self.graph.number(exponent);
                    denominators.push((stage, self.graph.pow(base, exponent)));
                }
                None => numerators.push((stage, *factor)),
            }
        }
        numerators.sort_by_key(|(stage, factor)| {
            (*stage, std::cmp::Reverse(self.frequency.get(factor).copied()), *factor)
        });
        denominators.sort();
        (numerators, denominators)
    }

    /// A product as its last operation: two values to multiply, or one value.
    pub(super) fn product_parts(&mut self, factors: &[Expression]) -> (Value, Option<Value>) {
        let (numerators, denominators) = self.quotient(factors);
        let alike = denominators.is_empty() && self.begins_alike(&numerators);
        // What is left of earlier stages; then what this stage multiplies, folded before it meets the rest, so that
        // products of the same factors with other coefficients share it.
        let mut earlier: Option<Value> = None;
        let mut parts: Vec<Value> = Vec::new();
        for stage in STAGES {
            let own: Vec<Value> = numerators
                .iter()
                .filter(|(own, _)| *own == stage)
                .map(|one| one.1)
                .collect::<Vec<_>>()
                .into_iter()
                .map(|one| self.value(one))
                .collect();
            let below: Vec<Expression> =
                denominators.iter().filter(|(own, _)| *own == stage).map(|one| one.1).collect();
            if own.is_empty() && below.is_empty() {
                continue;
            }
            let later = numerators.iter().chain(&denominators).any(|(own, _)| *own > stage);
            parts = earlier.into_iter().collect();
            if let Some((last, others)) = own.split_last() {
                match (others.split_first(), parts.is_empty()) {
                    // The first of a pair, or of many, is folded; the last operation is left to whoever adds.
                    (Some((first, more)), true) => {
                        parts.push(
                            more.iter().fold(*first, |product, one| self.multiply(product, *one)),
                        );
                        parts.push(*last);
                    }
                    (Some(_), false) if alike && !later => {
                        parts.extend(others);
                        parts = vec![self.folded(&parts), *last];
                    }
                    (Some((first, more)), false) => {
                        let folded = more
                            .iter()
                            .chain([last])
                            .fold(*first, |product, one| self.multiply(product, *one));
                        parts.push(folded);
                    }
                    (None, _) => parts.push(*last),
                }
            }
            if !below.is_empty() {
                let above = self.folded(&parts);
                let divisor: Vec<Value> =
                    below.into_iter().map(|factor| self.value(factor)).collect();
                let divisor = self.folded(&divisor);
                parts = vec![self.combine(OperationKind::Divide(above, divisor))];
            }
            if later {
                parts = vec![self.folded(&parts)];
            }
            earlier = parts.first().copied();
        }
        match parts.as_slice() {
            [a, b] => (*a, Some(*b)),
            [one] => (*one, None),
            _ => (self.number(1.0), None),
        }
    }

    /// The product of some values; 1 if there are none.
    fn folded(&mut self, values: &[Value]) -> Value {
        match values.split_first() {
            None => self.number(1.0),
            Some((first, rest)) => {
                rest.iter().fold(*first, |product, one| self.multiply(product, *one))
            }
        }
    }

    pub(super) fn product(&mut self, factors: &[Expression]) -> Value {
        if self.graph.as_number(factors[0]) == Some(-1.0) {
            let positive = self.product(&factors[1..]);
            return self.combine(OperationKind::Negate(positive));
        }
        match self.product_parts(factors) {
            (a, Some(b)) => self.multiply(a, b),
            (one, None) => one,
        }
    }
}

/// The factors of earlier stages and the two or more of the last one, if there are such.
fn split(numerators: &Factors) -> Option<(Vec<Expression>, Vec<Expression>)> {
    let last = numerators.last()?.0;
    let count = numerators.partition_point(|(stage, _)| *stage < last);
    let (earlier, own) = numerators.split_at(count);
    let all = |list: &[(Stage, Expression)]| list.iter().map(|one| one.1).collect();
    (!earlier.is_empty() && own.len() > 1).then(|| (all(earlier), all(own)))
}
