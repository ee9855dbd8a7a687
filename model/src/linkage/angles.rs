//! Angles of the dependent coordinates: every sine and cosine is made one of a single coordinate, because these are kept
//! beside the coordinate and cost nothing.

use crate::expression::{Expression, Graph, Map, Node, Symbol};
use crate::program::Function;

/// The expressions with `sin(a ± b)` written out wherever `a` is a dependent coordinate.
pub fn expand(graph: &mut Graph, roots: &[Expression]) -> Vec<Expression> {
    expand_where(graph, roots, &|symbol| matches!(symbol, Symbol::Dependent(_)))
}

/// The expressions with `sin(a ± b)` written out wherever `a` is a symbol that is `wanted`.
pub fn expand_where(
    graph: &mut Graph,
    roots: &[Expression],
    wanted: &dyn Fn(Symbol) -> bool,
) -> Vec<Expression> {
    let mut new: Map<Expression, Expression> = Map::default();
    for old in graph.reachable(roots) {
        if !graph.depends_on(old, wanted) {
            continue;
        }
        let node = graph.node(old).clone();
        let value = match &node {
            Node::Call(function @ (Function::Sin | Function::Cos), arguments) => {
                let argument = new.get(&arguments[0]).copied().unwrap_or(arguments[0]);
                let (cosine, sine) = of(graph, argument, wanted);
                if *function == Function::Sin { sine } else { cosine }
            }
            _ => graph.rebuild_with(&node, &new),
        };
        graph.carry(old, value);
        new.insert(old, value);
    }
    roots.iter().map(|root| new.get(root).copied().unwrap_or(*root)).collect()
}

/// Cosine and sine of an angle.
fn of(
    graph: &mut Graph,
    angle: Expression,
    wanted: &dyn Fn(Symbol) -> bool,
) -> (Expression, Expression) {
    let whole = |graph: &mut Graph| {
        (graph.call(Function::Cos, &[angle]), graph.call(Function::Sin, &[angle]))
    };
    let terms = terms(graph, angle);
    if terms.len() < 2 {
        return whole(graph);
    }
    let single = terms.iter().position(|term| {
        let (coefficient, rest) = graph.split_coefficient(*term);
        let symbol = matches!(graph.node(rest), Node::Symbol(symbol) if wanted(*symbol));
        symbol && coefficient.abs() == 1.0
    });
    let Some(index) = single else {
        return whole(graph);
    };
    let one = terms[index];
    let others: Vec<Expression> = terms.iter().copied().filter(|term| *term != one).collect();
    let rest = graph.sum(&others);
    let (cos_a, sin_a) = (graph.call(Function::Cos, &[one]), graph.call(Function::Sin, &[one]));
    let (cos_b, sin_b) = of(graph, rest, wanted);
    let products = [
        graph.mul(cos_a, cos_b),
        graph.mul(sin_a, sin_b),
        graph.mul(sin_a, cos_b),
        graph.mul(cos_a, sin_b),
    ];
    (graph.sub(products[0], products[1]), graph.add(products[2], products[3]))
}

/// The terms of a sum, those of sums in it that have a name of their own among them.
pub fn terms(graph: &mut Graph, sum: Expression) -> Vec<Expression> {
    let (coefficient, rest) = graph.split_coefficient(sum);
    match graph.node(rest).clone() {
        Node::Sum(inner) if coefficient.abs() == 1.0 => {
            let inner: Vec<_> = inner.iter().flat_map(|term| terms(graph, *term)).collect();
            inner.into_iter().map(|term| graph.scale(coefficient, term)).collect()
        }
        _ => vec![sum],
    }
}

/// The expressions with some of them replaced by others.
pub fn replace(
    graph: &mut Graph,
    roots: &[Expression],
    map: &Map<Expression, Expression>,
) -> Vec<Expression> {
    let mut new: Map<Expression, Expression> = Map::default();
    for old in graph.reachable(roots) {
        let value = match map.get(&old) {
            Some(other) => *other,
            None => {
                let node = graph.node(old).clone();
                graph.rebuild_with(&node, &new)
            }
        };
        new.insert(old, value);
    }
    roots.iter().map(|root| new[root]).collect()
}

/// Whether the expressions stay the same when an angle turns once: it occurs in them only as the argument of sines and
/// cosines.
pub fn is_turn(graph: &mut Graph, roots: &[Expression], angle: Symbol) -> bool {
    let expanded = expand_where(graph, roots, &|symbol| symbol == angle);
    let free = free_of(graph, &expanded, &[angle]);
    free.iter().all(|root| !graph.depends_on(*root, |symbol| symbol == angle))
}

/// The expressions with the cosine of each angle replaced by `Argument(2k)` and its sine by `Argument(2k + 1)`.
pub fn free_of(graph: &mut Graph, roots: &[Expression], angles: &[Symbol]) -> Vec<Expression> {
    let mut map = Map::default();
    for (k, symbol) in angles.iter().enumerate() {
        let angle = graph.symbol(*symbol);
        let k = 2 * k as u32;
        for (function, index) in [(Function::Cos, k), (Function::Sin, k + 1)] {
            let call = graph.call(function, &[angle]);
            let argument = graph.symbol(Symbol::Argument(index));
            map.insert(call, argument);
        }
    }
    replace(graph, roots, &map)
}

/// Most turns after which something may be the same again.
const TURNS: u32 = 12;

/// The period of an angle of which the expressions hold sines and cosines alone; none if they hold it otherwise, or not.
pub fn period(graph: &mut Graph, roots: &[Expression], angle: Symbol) -> Option<f64> {
    let mut map = Map::default();
    let mut factors = Vec::new();
    let gone = graph.zero();
    for one in graph.reachable(roots) {
        let Node::Call(Function::Sin | Function::Cos, arguments) = graph.node(one).clone() else {
            continue;
        };
        if !graph.depends_on(arguments[0], |symbol| symbol == angle) {
            continue;
        }
        let along = Map::from_iter([(angle, graph.one())]);
        let slope = graph.tangent(&arguments, &along)[0];
        if let Some(factor) = graph.as_number(slope) {
            factors.push(factor);
            map.insert(one, gone);
        }
    }
    let left = replace(graph, roots, &map);
    if factors.is_empty() || left.iter().any(|one| graph.depends_on(*one, |other| other == angle)) {
        return None;
    }
    let is_whole = |number: f64| (number - number.round()).abs() < 1e-9;
    let mut turns = (1..=TURNS).map(f64::from);
    let turns = turns.find(|turns| factors.iter().all(|factor| is_whole(factor * turns)))?;
    Some(turns * std::f64::consts::TAU)
}
