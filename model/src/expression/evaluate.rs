//! Expressions on numbers.

use super::graph::{Expression, Graph, Node, Symbol};
use super::hash::Map;
use super::linear::solve;

impl Graph {
    /// The values of some expressions; conditions are 1 or 0.
    pub fn evaluate(&self, roots: &[Expression], given: &dyn Fn(Symbol) -> f64) -> Vec<f64> {
        let mut values: Map<Expression, f64> = Map::default();
        let mut solutions: Map<Expression, Vec<f64>> = Map::default();
        for one in self.reachable(roots) {
            let at = |operand: &Expression| values.get(operand).copied().unwrap_or(f64::NAN);
            let truth = |held: bool| if held { 1.0 } else { 0.0 };
            let value = match self.node(one) {
                Node::Symbol(symbol) => given(*symbol),
                Node::Number(number) => number.get(),
                Node::Sum(terms) => terms.iter().map(at).sum(),
                Node::Product(factors) => factors.iter().map(at).product(),
                Node::Power(base, exponent) => power(at(base), at(exponent)),
                Node::Call(function, arguments) => {
                    function.apply(&arguments.iter().map(at).collect::<Vec<_>>())
                }
                Node::Compare(relation, a, b) => truth(relation.holds(at(a), at(b))),
                Node::And(a, b) => truth(at(a) != 0.0 && at(b) != 0.0),
                Node::Or(a, b) => truth(at(a) != 0.0 || at(b) != 0.0),
                Node::Whole(a) => at(a),
                Node::Table(spline, order, a) => spline.table().value(at(a), *order),
                Node::Not(a) => truth(at(a) == 0.0),
                Node::Select(c, a, b) => {
                    if at(c) != 0.0 {
                        at(a)
                    } else {
                        at(b)
                    }
                }
                Node::Factor(..) => f64::NAN,
                Node::Solve(factor, right) => {
                    if let Node::Factor(form, _, entries) = self.node(*factor) {
                        let entries: Vec<f64> = entries.iter().map(at).collect();
                        let right: Vec<f64> = right.iter().map(at).collect();
                        solutions.insert(one, solve(*form, &entries, &right));
                    }
                    f64::NAN
                }
                Node::Element(solution, index) => solutions
                    .get(solution)
                    .and_then(|list| list.get(*index as usize))
                    .copied()
                    .unwrap_or(f64::NAN),
                Node::Search(search, level, bodies) => {
                    let at = |body: usize, place: f64| {
                        let given = |symbol: Symbol| match symbol {
                            Symbol::Bound(own) if own == *level => place,
                            other => given(other),
                        };
                        self.evaluate(&[bodies[body]], &given)[0]
                    };
                    search.find(&at)
                }
            };
            values.insert(one, value);
        }
        roots.iter().map(|root| values[root]).collect()
    }
}

fn power(base: f64, exponent: f64) -> f64 {
    match exponent {
        0.5 => base.sqrt(),
        _ if exponent.fract() == 0.0 && exponent.abs() < 64.0 => base.powi(exponent as i32),
        _ => base.powf(exponent),
    }
}
