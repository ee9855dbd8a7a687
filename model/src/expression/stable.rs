//! Forms that do not cancel.
//!
//! A difference of nearly equal numbers keeps the rounding errors of both and little else. Where a difference has an
//! equal that is a product or a quotient of differences that are exact, that one is taken:
//!
//! | written | computed | where the first loses its digits |
//! |---|---|---|
//! | `1 - cos(x)` | `2*sin(x/2)^2` | small `x` |
//! | `1 - sqrt(1 - y)` | `y/(1 + sqrt(1 - y))` | small `y` |
//! | `sqrt(a + b) - sqrt(a + c)` | `(b - c)/(sqrt(a + b) + sqrt(a + c))` | small `b - c` |
//! | `cos(x) - cos(y)` | `2*sin((x + y)/2)*sin((y - x)/2)` | equal parts of `x` and `y` |
//! | `sin(x) - sin(y)` | `2*cos((x + y)/2)*sin((x - y)/2)` | equal parts of `x` and `y` |
//! | `exp(x) - 1` | `expm1(x)` | small `x` |
//! | `ln(1 + x)` | `ln1p(x)` | small `x` |
//! | `acos(1 - y)` | `2*asin(sqrt(y/2))` | small `y` |
//! | `x^2 - y^2` | `(x - y)*(x + y)` | `x` near `y` |
//! | `sin(x)^2 - sin(y)^2` | `sin(x + y)*sin(x - y)` | equal parts of `x` and `y` |
//! | `k*(a + b) - k*(a + c)` | `k*(b - c)` | large `a` |
//!
//! They are put in after everything is derived, by [`Graph::simplify`]; [`super::cancel`] finds the terms.

use super::function::Function;
use super::graph::{Expression, Graph, Node};

/// The stable form of a function.
pub fn function(
    graph: &mut Graph,
    function: Function,
    arguments: &[Expression],
) -> Option<Expression> {
    let Node::Sum(terms) = graph.node(*arguments.first()?) else {
        return None;
    };
    let mut rest = terms.to_vec();
    let one = rest.iter().position(|term| graph.as_number(*term) == Some(1.0))?;
    rest.remove(one);
    let rest = graph.sum(&rest);
    match function {
        Function::Ln => Some(graph.call(Function::Ln1p, &[rest])),
        Function::Acos => {
            let half = graph.scale(-0.5, rest);
            let root = graph.sqrt(half);
            let angle = graph.call(Function::Asin, &[root]);
            Some(graph.scale(2.0, angle))
        }
        _ => None,
    }
}

/// `f - g`, if it has a stable form.
pub fn difference(graph: &mut Graph, f: Expression, g: Expression) -> Option<Expression> {
    let one = graph.one();
    if f == g {
        return Some(graph.zero());
    }
    match (graph.node(f).clone(), graph.node(g).clone()) {
        (_, Node::Call(Function::Cos, angle)) if f == one => Some(versine(graph, angle[0])),
        (Node::Call(Function::Cos, angle), _) if g == one => {
            let value = versine(graph, angle[0]);
            Some(graph.neg(value))
        }
        (Node::Call(Function::Exp, argument), _) if g == one => {
            Some(graph.call(Function::ExpM1, &argument))
        }
        (_, Node::Call(Function::Exp, argument)) if f == one => {
            let value = graph.call(Function::ExpM1, &argument);
            Some(graph.neg(value))
        }
        (Node::Call(Function::Cos, x), Node::Call(Function::Cos, y)) => {
            prosthaphaeresis(graph, Function::Sin, y[0], x[0])
        }
        (Node::Call(Function::Sin, x), Node::Call(Function::Sin, y)) => {
            prosthaphaeresis(graph, Function::Cos, x[0], y[0])
        }
        (Node::Power(a, p), Node::Power(b, q)) if p == q => match graph.as_number(p) {
            Some(0.5) => roots(graph, (f, a), (g, b)),
            Some(2.0) => squares(graph, a, b),
            _ => None,
        },
        (_, Node::Power(b, q)) if f == one && graph.as_number(q) == Some(0.5) => {
            roots(graph, (f, one), (g, b))
        }
        (Node::Power(a, p), _) if g == one && graph.as_number(p) == Some(0.5) => {
            roots(graph, (f, a), (g, one))
        }
        (Node::Sum(_), Node::Sum(_)) if shares(graph, f, g) => Some(graph.sub(f, g)),
        _ => None,
    }
}

/// `1 - cos(x) = 2*sin(x/2)^2`
fn versine(graph: &mut Graph, angle: Expression) -> Expression {
    let half = half(graph, angle);
    let sine = graph.call(Function::Sin, &[half]);
    let square = graph.powi(sine, 2);
    graph.scale(2.0, square)
}

/// Half of an angle; of a sum the sum of halves, so that equal parts of two such angles are seen.
fn half(graph: &mut Graph, angle: Expression) -> Expression {
    let terms = match graph.node(angle) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![angle],
    };
    let halves: Vec<_> = terms.iter().map(|term| graph.scale(0.5, *term)).collect();
    graph.sum(&halves)
}

/// `2*f((x + y)/2)*sin((x - y)/2)`, where `x - y` is shorter than `x` and `y`.
fn prosthaphaeresis(
    graph: &mut Graph,
    function: Function,
    x: Expression,
    y: Expression,
) -> Option<Expression> {
    if !shares(graph, x, y) {
        return None;
    }
    let (less, more) = (graph.sub(x, y), graph.add(x, y));
    let (less, more) = (half(graph, less), half(graph, more));
    let factors = [graph.call(function, &[more]), graph.call(Function::Sin, &[less])];
    let product = graph.product(&factors);
    Some(graph.scale(2.0, product))
}

/// `a^2 - b^2`, where `a - b` is shorter than `a` and `b`.
fn squares(graph: &mut Graph, a: Expression, b: Expression) -> Option<Expression> {
    let factors = match (graph.node(a).clone(), graph.node(b).clone()) {
        (Node::Call(Function::Sin, x), Node::Call(Function::Sin, y))
            if shares(graph, x[0], y[0]) =>
        {
            let (less, more) = (graph.sub(x[0], y[0]), graph.add(x[0], y[0]));
            [less, more].map(|angle| graph.call(Function::Sin, &[angle]))
        }
        _ if shares(graph, a, b) => [graph.sub(a, b), graph.add(a, b)],
        _ => return None,
    };
    Some(graph.mul(factors[0], factors[1]))
}

/// `sqrt(a) - sqrt(b) = (a - b)/(sqrt(a) + sqrt(b))`, where equal parts of `a` and `b` drop out.
fn roots(
    graph: &mut Graph,
    (f, a): (Expression, Expression),
    (g, b): (Expression, Expression),
) -> Option<Expression> {
    if !shares(graph, a, b) {
        return None;
    }
    let (less, more) = (graph.sub(a, b), graph.sum(&[f, g]));
    Some(graph.div(less, more))
}

/// Whether two expressions have a term in common, so that their difference is simpler than both.
fn shares(graph: &mut Graph, a: Expression, b: Expression) -> bool {
    let terms = |graph: &Graph, one: Expression| match graph.node(one) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![one],
    };
    let (left, right) = (terms(graph, a), terms(graph, b));
    left.iter().any(|term| right.contains(term))
}
