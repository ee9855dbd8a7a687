//! Identities, as a table: name, where it holds, what it does.

use super::build::collect_like;
use super::function::Function;
use super::graph::{Expression, Graph, Node};

/// An identity of functions.
struct Law {
    /// Its name.
    #[cfg_attr(not(test), expect(dead_code, reason = "names are for the reader and the tests"))]
    name: &'static str,
    /// The functions that it concerns.
    functions: &'static [Function],
    /// The simpler form.
    apply: fn(&mut Graph, Function, &[Expression]) -> Option<Expression>,
}

/// The identities; each holds wherever its left side exists.
#[rustfmt::skip]
const LAWS: &[Law] = &[
    Law { name: "f(-x) = -f(x)",  functions: ODD,  apply: odd },
    Law { name: "f(-x) = f(x)",   functions: EVEN, apply: even },
    Law { name: "sin(asin x) = x", functions: &[Function::Sin], apply: |g, _, a| inverse(g, a[0], Function::Asin) },
    Law { name: "cos(acos x) = x", functions: &[Function::Cos], apply: |g, _, a| inverse(g, a[0], Function::Acos) },
    Law { name: "tan(atan x) = x", functions: &[Function::Tan], apply: |g, _, a| inverse(g, a[0], Function::Atan) },
    Law { name: "exp(ln x) = x",   functions: &[Function::Exp], apply: |g, _, a| inverse(g, a[0], Function::Ln) },
    Law { name: "ln(exp x) = x",   functions: &[Function::Ln],  apply: |g, _, a| inverse(g, a[0], Function::Exp) },
    Law { name: "||x|| = |x|",     functions: &[Function::Abs], apply: |g, f, a| matches!(g.node(a[0]), Node::Call(inner, _) if *inner == f).then_some(a[0]) },
    Law { name: "max(x, x) = x",   functions: &[Function::Max, Function::Min], apply: |_, _, a| (a[0] == a[1]).then_some(a[0]) },
];

const ODD: &[Function] = &[
    Function::Sin,
    Function::Tan,
    Function::Asin,
    Function::Atan,
    Function::Sinh,
    Function::Tanh,
    Function::Erf,
    Function::Sign,
];

const EVEN: &[Function] = &[Function::Cos, Function::Cosh, Function::Abs];

/// The simpler form of a function, if an identity gives one.
pub fn function(
    graph: &mut Graph,
    function: Function,
    arguments: &[Expression],
) -> Option<Expression> {
    LAWS.iter()
        .filter(|law| law.functions.contains(&function))
        .find_map(|law| (law.apply)(graph, function, arguments))
}

/// The argument without its minus, if it has one.
fn positive(graph: &mut Graph, argument: Expression) -> Option<Expression> {
    let (coefficient, _) = graph.split_coefficient(argument);
    (coefficient < 0.0).then(|| graph.neg(argument))
}

fn odd(graph: &mut Graph, function: Function, arguments: &[Expression]) -> Option<Expression> {
    let argument = positive(graph, arguments[0])?;
    let value = graph.call(function, &[argument]);
    Some(graph.neg(value))
}

fn even(graph: &mut Graph, function: Function, arguments: &[Expression]) -> Option<Expression> {
    let argument = positive(graph, arguments[0])?;
    Some(graph.call(function, &[argument]))
}

fn inverse(graph: &Graph, argument: Expression, of: Function) -> Option<Expression> {
    match graph.node(argument) {
        Node::Call(function, inner) if *function == of => Some(inner[0]),
        _ => None,
    }
}

/// `c*sin(x)^2 + c*cos(x)^2 = c` for terms with equal coefficients, rising.
pub fn pythagoras(graph: &mut Graph, like: &mut Vec<(Expression, f64)>, constant: &mut f64) {
    if like.len() < 2 {
        return;
    }
    let terms: Vec<Expression> = like.iter().map(|one| one.0).collect();
    for term in terms {
        let place =
            |like: &[(Expression, f64)], wanted| like.binary_search_by_key(&wanted, |one| one.0);
        let Ok(here) = place(like, term) else {
            continue;
        };
        let coefficient = like[here].1;
        let factors: &[Expression] = match graph.node(term) {
            Node::Product(factors) => factors,
            _ => &[term],
        };
        if factors.iter().all(|factor| squared(graph, *factor, Function::Sin).is_none()) {
            continue;
        }
        let factors = factors.to_vec();
        for (index, factor) in factors.iter().enumerate() {
            let Some(angle) = squared(graph, *factor, Function::Sin) else {
                continue;
            };
            let cosine = graph.call(Function::Cos, &[angle]);
            let square = graph.powi(cosine, 2);
            let mut others = factors.clone();
            others.remove(index);
            let rest = graph.product(&others);
            others.push(square);
            let partner = graph.product(&others);
            let Ok(there) = place(like, partner) else {
                continue;
            };
            if like[there].1 == coefficient {
                like.remove(here.max(there));
                like.remove(here.min(there));
                match graph.as_number(rest) {
                    Some(number) => *constant += coefficient * number,
                    None => {
                        like.push((rest, coefficient));
                        collect_like(like);
                        like.retain(|one| one.1 != 0.0);
                    }
                }
                break;
            }
        }
    }
}

/// The angle of `f(angle)^2`.
fn squared(graph: &Graph, factor: Expression, of: Function) -> Option<Expression> {
    let Node::Power(base, exponent) = graph.node(factor) else {
        return None;
    };
    match graph.node(*base) {
        Node::Call(function, arguments)
            if *function == of && graph.as_number(*exponent) == Some(2.0) =>
        {
            Some(arguments[0])
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Symbol;

    #[test]
    fn every_law_keeps_the_value() {
        for law in LAWS {
            for function in law.functions {
                check(law, *function);
            }
        }
    }

    /// Applies a law to arguments of each form that it may meet.
    fn check(law: &Law, function: Function) {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Parameter(0));
        let minus = graph.neg(x);
        let inner = [
            Function::Asin,
            Function::Acos,
            Function::Atan,
            Function::Exp,
            Function::Ln,
            Function::Abs,
        ];
        let mut forms = vec![minus, x];
        forms.extend(inner.map(|inner| graph.intern(Node::Call(inner, [x].into()))));
        let mut met = false;
        for form in forms {
            let arguments =
                vec![form; if matches!(function, Function::Max | Function::Min) { 2 } else { 1 }];
            let Some(simpler) = (law.apply)(&mut graph, function, &arguments) else {
                continue;
            };
            met = true;
            let naive = graph.intern(Node::Call(function, arguments.into()));
            let values = graph.evaluate(&[naive, simpler], &|_| 0.37);
            assert!((values[0] - values[1]).abs() < 1e-15, "{}: {values:?}", law.name);
        }
        assert!(met, "the law {} is never met by {function:?}", law.name);
    }

    #[test]
    fn the_squares_of_sine_and_cosine_add_to_one() {
        let mut graph = Graph::new();
        let (x, r) = (graph.symbol(Symbol::Time), graph.symbol(Symbol::Parameter(0)));
        let squares = [Function::Sin, Function::Cos].map(|function| {
            let value = graph.call(function, &[x]);
            let square = graph.powi(value, 2);
            graph.mul(r, square)
        });
        assert_eq!(graph.sum(&squares), r);
        let other = graph.scale(2.0, squares[1]);
        assert_ne!(graph.sum(&[squares[0], other]), r);
    }
}
