//! Pulls common factors out of sums, those first that change most often: what multiplies a coordinate then becomes a
//! coefficient that is computed once an instant.

use super::build::Request;
use crate::expression::{Expression, Graph, Map, Node, Set, collect_like};

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
                        // What is used elsewhere as well, with a minus maybe, is left whole.
                        let used = |term: &Expression| uses.get(term).copied().unwrap_or(0);
                        let whole = used(term) + used(&graph.neg(*term)) > 1;
                        Term::read(graph, new[term], whole)
                    })
                    .collect();
                let counts = count(graph, &terms);
                factored(graph, terms, counts, request)
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
                match new.get(&opposite).copied().filter(|_| known.contains(&opposite)) {
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

/// A term as a number and powers of factors, rising.
struct Term {
    coefficient: f64,
    powers: Vec<(Expression, f64)>,
}

impl Term {
    fn read(graph: &mut Graph, term: Expression, whole: bool) -> Self {
        let (coefficient, rest) = match graph.as_number(term) {
            Some(number) => (number, graph.one()),
            None => graph.split_coefficient(term),
        };
        let factors: &[Expression] = match graph.node(rest) {
            Node::Product(factors) if !whole => factors,
            Node::Number(_) => &[],
            _ => &[rest],
        };
        let power = |factor: &Expression| match graph.node(*factor) {
            Node::Power(base, exponent) => match graph.as_number(*exponent) {
                Some(number) if number.fract() == 0.0 => (*base, number),
                _ => (*factor, 1.0),
            },
            _ => (*factor, 1.0),
        };
        let mut powers: Vec<_> = factors.iter().map(power).collect();
        collect_like(&mut powers);
        Self { coefficient, powers }
    }

    /// Place and exponent of a factor that stands above the line, or below it.
    fn find(&self, (base, above): Factor) -> Option<(usize, f64)> {
        let place = self.powers.binary_search_by_key(&base, |one| one.0).ok()?;
        let exponent = self.powers[place].1;
        ((exponent > 0.0) == above).then_some((place, exponent.abs()))
    }

    fn write(&self, graph: &mut Graph) -> Expression {
        let mut factors = vec![graph.number(self.coefficient)];
        for (base, exponent) in &self.powers {
            factors.push(graph.powi(*base, *exponent as i32));
        }
        graph.product(&factors)
    }
}

/// A factor, and whether it stands above the line.
type Factor = (Expression, bool);

/// In how many terms each factor occurs.
type Counts = Map<Factor, usize>;

fn count(graph: &Graph, terms: &[Term]) -> Counts {
    let mut counts = Counts::default();
    for term in terms {
        graph.budget().spend(term.powers.len());
        for (base, exponent) in &term.powers {
            *counts.entry((*base, *exponent > 0.0)).or_insert(0) += 1;
        }
    }
    counts
}

/// A sum with its common factors pulled out.
fn factored(
    graph: &mut Graph,
    mut terms: Vec<Term>,
    mut counts: Counts,
    request: &Request,
) -> Expression {
    let (mut done, mut of_all) = (Vec::new(), Vec::new());
    while let Some(common) = most_common(graph, &counts, request) {
        let has = |term: &Term| term.find(common).is_some();
        if done.is_empty() && terms.iter().all(has) {
            of_all.push((common.0, pull(common, &mut terms, &mut counts)));
            continue;
        }
        let (mut inside, outside): (Vec<Term>, Vec<Term>) = terms.into_iter().partition(has);
        let mut own = count(graph, &inside);
        for (factor, number) in &own {
            counts.entry(*factor).and_modify(|all| *all -= number);
        }
        let exponent = pull(common, &mut inside, &mut own);
        let sum = factored(graph, inside, own, request);
        let factor = graph.powi(common.0, exponent);
        done.push(graph.mul(factor, sum));
        terms = outside;
    }
    done.extend(terms.iter().map(|term| term.write(graph)));
    let mut factors = vec![graph.sum(&done)];
    let of_all = of_all.into_iter().rev();
    factors.extend(of_all.map(|(base, exponent)| graph.powi(base, exponent)));
    match factors.as_slice() {
        [sum] => *sum,
        _ => graph.product(&factors),
    }
}

/// Divides terms that have a factor by its lowest power, whose exponent this gives.
fn pull(common: Factor, terms: &mut [Term], counts: &mut Counts) -> i32 {
    let exponents = terms.iter().filter_map(|term| term.find(common));
    let least = exponents.map(|one| one.1).fold(f64::INFINITY, f64::min);
    let least = if common.1 { least } else { -least };
    for term in terms {
        let Some((place, _)) = term.find(common) else {
            continue;
        };
        term.powers[place].1 -= least;
        if term.powers[place].1 == 0.0 {
            term.powers.remove(place);
            counts.entry(common).and_modify(|all| *all -= 1);
        }
    }
    least as i32
}

/// The factor that is pulled out next: it changes as often as any, and occurs in most terms, at least two.
fn most_common(graph: &Graph, counts: &Counts, request: &Request) -> Option<Factor> {
    let common = counts.iter().filter(|(_, count)| **count > 1);
    let (factor, _) = common.max_by_key(|((base, above), count)| {
        let stage = request.stage(graph, *base);
        (stage, **count, *above, std::cmp::Reverse(*base))
    })?;
    Some(*factor)
}

#[cfg(test)]
mod tests {
    use super::super::share::share;
    use super::*;
    use crate::expression::Symbol;

    /// The rates of the kinetics of Robertson add up to zero: rounded as they are, if the parts that two of them have in
    /// common are the same numbers. A factor of such a part is not pulled out beside it.
    #[test]
    fn what_rows_have_in_common_is_left_whole() {
        let mut graph = Graph::new();
        let [y1, y2, y3] = [0, 1, 2].map(|index| graph.symbol(Symbol::Parameter(index)));
        let slow = graph.scale(0.04, y1);
        let both = graph.mul(y2, y3);
        let both = graph.scale(-1e4, both);
        let square = graph.powi(y2, 2);
        let fast = graph.scale(3e7, square);
        let minus = [slow, both, fast].map(|one| graph.neg(one));
        let roots =
            [graph.sum(&minus[..2]), graph.sum(&[slow, both, minus[2]]), graph.sum(&[fast])];
        let request = Request::default();
        let collected = collect(&mut graph, &roots, roots.len(), &request);
        let shared = share(&mut graph, &collected, &[0; 3], &request);
        let Node::Sum(terms) = graph.node(shared[1]).clone() else { panic!("no sum") };
        let opposite = graph.neg(shared[0]);
        assert!(terms.contains(&opposite), "{}", graph.display(shared[1]));
    }
}
