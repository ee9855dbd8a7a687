//! Differences of nearly equal numbers: what is computed is right to a few units in the last place, what is written is
//! not.

use super::{Expression, Function, Graph, X, Y, value};

/// A difference that cancels: how it is built, what it is without cancellation, and what it is as it is written.
struct Case {
    name: &'static str,
    build: fn(&mut Graph, Expression, Expression) -> Expression,
    exact: fn(f64, f64) -> f64,
    written: fn(f64, f64) -> f64,
}

fn call(graph: &mut Graph, function: Function, argument: Expression) -> Expression {
    graph.call(function, &[argument])
}

/// `x` is small, `y` is about one.
const CASES: &[Case] = &[
    Case {
        name: "1 - cos x",
        build: |g, x, _| {
            let (one, cosine) = (g.one(), call(g, Function::Cos, x));
            g.sub(one, cosine)
        },
        exact: |x, _| 2.0 * (x / 2.0).sin().powi(2),
        written: |x, _| 1.0 - x.cos(),
    },
    Case {
        name: "y*(cos x - 1)",
        build: |g, x, y| {
            let (one, cosine) = (g.one(), call(g, Function::Cos, x));
            let difference = g.sub(cosine, one);
            g.mul(y, difference)
        },
        exact: |x, y| -2.0 * y * (x / 2.0).sin().powi(2),
        written: |x, y| y * (x.cos() - 1.0),
    },
    Case {
        name: "sqrt(1 + x) - 1",
        build: |g, x, _| {
            let one = g.one();
            let sum = g.add(one, x);
            let root = g.sqrt(sum);
            g.sub(root, one)
        },
        exact: |x, _| x / ((1.0 + x).sqrt() + 1.0),
        written: |x, _| (1.0 + x).sqrt() - 1.0,
    },
    Case {
        name: "1 - sqrt(1 - x^2)",
        build: |g, x, _| {
            let (one, square) = (g.one(), g.powi(x, 2));
            let inner = g.sub(one, square);
            let root = g.sqrt(inner);
            g.sub(one, root)
        },
        exact: |x, _| x * x / (1.0 + (1.0 - x * x).sqrt()),
        written: |x, _| 1.0 - (1.0 - x * x).sqrt(),
    },
    Case {
        name: "sqrt(y + x) - sqrt(y)",
        build: |g, x, y| {
            let sum = g.add(y, x);
            let (root, other) = (g.sqrt(sum), g.sqrt(y));
            g.sub(root, other)
        },
        exact: |x, y| x / ((y + x).sqrt() + y.sqrt()),
        written: |x, y| (y + x).sqrt() - y.sqrt(),
    },
    Case {
        name: "cos(y + x) - cos(y)",
        build: |g, x, y| {
            let sum = g.add(y, x);
            let (near, far) = (call(g, Function::Cos, sum), call(g, Function::Cos, y));
            g.sub(near, far)
        },
        exact: |x, y| -2.0 * (y + x / 2.0).sin() * (x / 2.0).sin(),
        written: |x, y| (y + x).cos() - y.cos(),
    },
    Case {
        name: "sin(y) - sin(y - x)",
        build: |g, x, y| {
            let difference = g.sub(y, x);
            let (near, far) = (call(g, Function::Sin, y), call(g, Function::Sin, difference));
            g.sub(near, far)
        },
        exact: |x, y| 2.0 * (y - x / 2.0).cos() * (x / 2.0).sin(),
        written: |x, y| y.sin() - (y - x).sin(),
    },
    Case {
        name: "exp(x) - 1",
        build: |g, x, _| {
            let (one, power) = (g.one(), call(g, Function::Exp, x));
            g.sub(power, one)
        },
        exact: |x, _| x.exp_m1(),
        written: |x, _| x.exp() - 1.0,
    },
    Case {
        name: "2 - 2*exp(x)",
        build: |g, x, _| {
            let (two, power) = (g.number(2.0), call(g, Function::Exp, x));
            let twice = g.mul(two, power);
            g.sub(two, twice)
        },
        exact: |x, _| -2.0 * x.exp_m1(),
        written: |x, _| 2.0 - 2.0 * x.exp(),
    },
    Case {
        name: "ln(1 + x)",
        build: |g, x, _| {
            let one = g.one();
            let sum = g.add(one, x);
            call(g, Function::Ln, sum)
        },
        exact: |x, _| x.ln_1p(),
        written: |x, _| (1.0 + x).ln(),
    },
    Case {
        name: "acos(1 - x^2)",
        build: |g, x, _| {
            let (one, square) = (g.one(), g.powi(x, 2));
            let difference = g.sub(one, square);
            call(g, Function::Acos, difference)
        },
        exact: |x, _| 2.0 * (x / std::f64::consts::SQRT_2).abs().asin(),
        written: |x, _| (1.0 - x * x).acos(),
    },
    Case {
        name: "(y + x)^2 - y^2",
        build: |g, x, y| {
            let sum = g.add(y, x);
            let (near, far) = (g.powi(sum, 2), g.powi(y, 2));
            g.sub(near, far)
        },
        exact: |x, y| x * (2.0 * y + x),
        written: |x, y| (y + x).powi(2) - y.powi(2),
    },
    Case {
        name: "y*sin(y)^2 - y*sin(y - x)^2",
        build: |g, x, y| {
            let lag = g.sub(y, x);
            let mut term = |angle| {
                let sine = call(g, Function::Sin, angle);
                let square = g.powi(sine, 2);
                g.mul(y, square)
            };
            let (near, far) = (term(y), term(lag));
            g.sub(near, far)
        },
        exact: |x, y| y * (2.0 * y - x).sin() * x.sin(),
        written: |x, y| y * y.sin().powi(2) - y * (y - x).sin().powi(2),
    },
    Case {
        name: "X(y) - X(y - x), X(a) = 3*(1 - cos(a)) + y*(1 - sqrt(1 - sin(a)^2/16))",
        build: |g, x, y| {
            let lag = g.sub(y, x);
            let (near, far) = (crank(g, y, y), crank(g, lag, y));
            g.sub(near, far)
        },
        exact: |x, y| {
            let root = |a: f64| (1.0 - a.sin().powi(2) / 16.0).sqrt();
            let squares = (2.0 * y - x).sin() * x.sin() / 16.0;
            6.0 * (y - x / 2.0).sin() * (x / 2.0).sin() + y * squares / (root(y) + root(y - x))
        },
        written: |x, y| {
            let root = |a: f64| (1.0 - a.sin().powi(2) / 16.0).sqrt();
            let travel = |a: f64| 3.0 * (1.0 - a.cos()) + y * (1.0 - root(a));
            travel(y) - travel(y - x)
        },
    },
];

/// The travel of a slider-crank: a sum whose parts cancel with those of another.
fn crank(graph: &mut Graph, angle: Expression, length: Expression) -> Expression {
    let one = graph.one();
    let cosine = call(graph, Function::Cos, angle);
    let versine = graph.sub(one, cosine);
    let first = graph.scale(3.0, versine);
    let sine = call(graph, Function::Sin, angle);
    let quarter = graph.scale(0.25, sine);
    let square = graph.powi(quarter, 2);
    let inner = graph.sub(one, square);
    let root = graph.sqrt(inner);
    let rest = graph.sub(one, root);
    let second = graph.mul(length, rest);
    graph.add(first, second)
}

#[test]
fn differences_keep_their_digits() {
    for case in CASES {
        let mut graph = Graph::new();
        let (x, y) = (graph.symbol(X), graph.symbol(Y));
        let root = (case.build)(&mut graph, x, y);
        let simple = graph.simplify(&[root], 1)[0];
        let mut lost = 0.0_f64;
        for (small, large) in [(1.7e-3, 0.9), (-3.1e-5, 1.2), (2.3e-7, 0.4), (-7.7e-9, 1.9)] {
            let exact = (case.exact)(small, large);
            let found = value(&graph, simple, [small, large, 0.0]);
            let error = (found / exact - 1.0).abs();
            assert!(error <= 8.0 * f64::EPSILON, "{} at {small}, {large}: {error:e}", case.name);
            lost = lost.max(((case.written)(small, large) / exact - 1.0).abs());
        }
        assert!(lost > 1e-10, "{}: as it is written it loses only {lost:e}", case.name);
    }
}

/// The same differences among other terms, and several of them in one sum.
#[test]
fn differences_are_found_in_longer_sums() {
    let mut graph = Graph::new();
    let (x, y) = (graph.symbol(X), graph.symbol(Y));
    // (1 - cos x) + (exp x - 1) - x: each pair alone, though the ones cancel.
    let cosine = call(&mut graph, Function::Cos, x);
    let sum = graph.add(y, x);
    let roots = [graph.sqrt(sum), graph.sqrt(y)];
    let one = graph.one();
    let versine = graph.sub(one, cosine);
    let root_difference = graph.sub(roots[0], roots[1]);
    let total = graph.add(versine, root_difference);
    let simple = graph.simplify(&[total], 1)[0];
    let (small, large) = (2.3e-6_f64, 0.8_f64);
    let exact = 2.0 * (small / 2.0).sin().powi(2) + small / ((large + small).sqrt() + large.sqrt());
    let found = value(&graph, simple, [small, large, 0.0]);
    assert!((found / exact - 1.0).abs() <= 8.0 * f64::EPSILON, "{found} instead of {exact}");
}
