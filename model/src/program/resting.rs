//! On which operations results rest while a switching surface is known to be on one side.

use std::collections::BTreeSet;

use super::{Input, OperationKind as Kind, Program, Value};

impl Program {
    /// The operations on which results rest; those of branches that are not taken while a surface, by index, is on a side,
    /// 1 or −1, are left out.
    pub fn resting(&self, wanted: &[Value], side: Option<(u32, f64)>) -> BTreeSet<Value> {
        let known = self.known(side);
        let at = |value: &Value| known[value.0 as usize];
        let (mut resting, mut open) = (BTreeSet::new(), wanted.to_vec());
        while let Some(value) = open.pop() {
            if at(&value).is_some() || !resting.insert(value) {
                continue;
            }
            let kind = &self.operations[value.0 as usize].kind;
            match kind {
                Kind::Select { condition, then, otherwise } if at(condition).is_some() => {
                    open.push(if at(condition) == Some(0.0) { *otherwise } else { *then });
                }
                Kind::MultiplyAdd(a, b, c)
                | Kind::MultiplySubtract(a, b, c)
                | Kind::NegateMultiplyAdd(a, b, c)
                    if [a, b].iter().any(|one| at(one) == Some(0.0)) =>
                {
                    open.push(*c);
                }
                _ => open.extend(kind.operands()),
            }
        }
        resting
    }

    /// The values that are numbers then. Zero times whatever is zero.
    fn known(&self, side: Option<(u32, f64)>) -> Vec<Option<f64>> {
        let mut known: Vec<Option<f64>> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let at = |value: &Value| known[value.0 as usize];
            let both = |a: &Value, b: &Value| Some((at(a)?, at(b)?));
            let product = |a: &Value, b: &Value| match (at(a), at(b)) {
                (Some(0.0), _) | (_, Some(0.0)) => Some(0.0),
                (a, b) => Some(a? * b?),
            };
            let truth = |holds: bool| if holds { 1.0 } else { 0.0 };
            let value = match &operation.kind {
                Kind::Number(number) => Some(*number),
                Kind::Input(Input::Side(surface)) => {
                    side.filter(|(index, _)| index == surface).map(|(_, side)| side)
                }
                Kind::Add(a, b) => both(a, b).map(|(a, b)| a + b),
                Kind::Subtract(a, b) => both(a, b).map(|(a, b)| a - b),
                Kind::Multiply(a, b) => product(a, b),
                Kind::Negate(a) => at(a).map(|a| -a),
                Kind::MultiplyAdd(a, b, c) => product(a, b).and_then(|ab| Some(ab + at(c)?)),
                Kind::MultiplySubtract(a, b, c) => product(a, b).and_then(|ab| Some(ab - at(c)?)),
                Kind::NegateMultiplyAdd(a, b, c) => product(a, b).and_then(|ab| Some(at(c)? - ab)),
                Kind::Compare(relation, a, b) => {
                    both(a, b).map(|(a, b)| truth(relation.holds(a, b)))
                }
                Kind::And(a, b) => match (at(a), at(b)) {
                    (Some(0.0), _) | (_, Some(0.0)) => Some(0.0),
                    (a, b) => a.and(b),
                },
                Kind::Or(a, b) => match (at(a), at(b)) {
                    (Some(a), Some(b)) => Some(a.max(b)),
                    (a, b) => a.or(b).filter(|one| *one != 0.0),
                },
                Kind::Not(a) => at(a).map(|a| truth(a == 0.0)),
                Kind::Select { condition, then, otherwise } => match at(condition) {
                    Some(0.0) => at(otherwise),
                    Some(_) => at(then),
                    None => None,
                },
                _ => None,
            };
            known.push(value);
        }
        known
    }
}
