//! Finds the terms of a sum that may cancel: those that differ in one factor, be they terms of sums themselves.

use super::graph::{Expression, Graph, Node};
use super::hash::Map;
use super::stable::difference;

/// A term of a sum, or of a sum that is one of its terms.
struct Part {
    /// Place in the outer sum.
    place: usize,
    /// Whether it stands alone there.
    alone: bool,
    coefficient: f64,
    factor: Expression,
}

/// The stable form of a sum of terms, two of which may cancel. Terms that are sums themselves are opened if a part of
/// one cancels with a part of another.
pub fn sum(graph: &mut Graph, terms: &[Expression]) -> Option<Vec<Expression>> {
    if graph.made.settled.contains(terms) {
        return None;
    }
    let parts = parts(graph, terms);
    let found = alike(graph, &parts).or_else(|| beside_equal_factors(graph, &parts));
    let Some((i, j, stable)) = found else {
        graph.made.settled.insert(terms.into());
        return None;
    };
    let opened = [parts[i].place, parts[j].place];
    let mut list: Vec<_> = (0..terms.len())
        .filter(|place| !opened.contains(place))
        .map(|place| terms[place])
        .collect();
    for (index, part) in parts.iter().enumerate() {
        if opened.contains(&part.place) && index != i && index != j {
            list.push(graph.scale(part.coefficient, part.factor));
        }
    }
    list.push(stable);
    Some(list)
}

fn parts(graph: &mut Graph, terms: &[Expression]) -> Vec<Part> {
    let mut parts = Vec::with_capacity(terms.len());
    for (place, term) in terms.iter().enumerate() {
        let (sign, sum) = split(graph, *term);
        let inner = match graph.node(sum) {
            Node::Sum(inner) if sign.abs() == 1.0 => inner.to_vec(),
            _ => vec![sum],
        };
        graph.budget().spend(inner.len());
        for one in &inner {
            let (coefficient, factor) = split(graph, *one);
            parts.push(Part {
                place,
                alone: inner.len() == 1,
                coefficient: sign * coefficient,
                factor,
            });
        }
    }
    parts
}

/// Whether two parts of opposite coefficients may be taken together: those of one term are left to that term.
fn may_cancel(a: &Part, b: &Part) -> bool {
    a.place != b.place || a.alone
}

/// Two parts `c*f` and `-c*g`, and `c*(f - g)`, if `f - g` has a stable form.
fn alike(graph: &mut Graph, parts: &[Part]) -> Option<(usize, usize, Expression)> {
    let mut places: Map<u64, Vec<usize>> = Map::default();
    for (j, part) in parts.iter().enumerate() {
        let opposite = places.get(&(-part.coefficient).to_bits()).into_iter().flatten();
        for &i in opposite {
            graph.budget().spend(1);
            if may_cancel(&parts[i], part)
                && let Some(stable) = signed(graph, &parts[i], parts[i].factor, part.factor)
            {
                return Some((i, j, stable));
            }
        }
        places.entry(part.coefficient.to_bits()).or_default().push(j);
    }
    None
}

/// Two parts `k*f` and `-k*g` with equal factors `k`, and `k*(f - g)`, if `f - g` has a stable form.
fn beside_equal_factors(graph: &mut Graph, parts: &[Part]) -> Option<(usize, usize, Expression)> {
    /// Parts with the same other factors, each with the factor that is its own.
    type Places = Map<(u64, Vec<Expression>), Vec<(usize, Expression)>>;
    let mut places = Places::default();
    for (j, part) in parts.iter().enumerate() {
        let Node::Product(factors) = graph.node(part.factor).clone() else {
            continue;
        };
        for (own, g) in factors.iter().enumerate() {
            let mut others = factors.to_vec();
            others.remove(own);
            graph.budget().spend(1);
            let mut key = ((-part.coefficient).to_bits(), others);
            for &(i, f) in places.get(&key).into_iter().flatten() {
                graph.budget().spend(1);
                if may_cancel(&parts[i], part)
                    && let Some(stable) = signed(graph, &parts[i], f, *g)
                {
                    let others = graph.product(&key.1);
                    return Some((i, j, graph.mul(others, stable)));
                }
            }
            key.0 = part.coefficient.to_bits();
            places.entry(key).or_default().push((j, *g));
        }
    }
    None
}

/// `c*(f - g)` with the coefficient of a part, written with a positive one.
fn signed(graph: &mut Graph, part: &Part, f: Expression, g: Expression) -> Option<Expression> {
    let stable = match part.coefficient > 0.0 {
        true => difference(graph, f, g),
        false => difference(graph, g, f),
    };
    stable.map(|stable| graph.scale(part.coefficient.abs(), stable))
}

/// As [`Graph::split_coefficient`], with a number as a multiple of one.
fn split(graph: &mut Graph, term: Expression) -> (f64, Expression) {
    match graph.as_number(term) {
        Some(number) => (number, graph.one()),
        None => graph.split_coefficient(term),
    }
}
