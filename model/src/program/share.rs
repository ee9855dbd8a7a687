//! Parts that several sums have in common, computed once.
//!
//! Another order of adding loses no digits where every term of the part is rounded itself: what rounding the part adds to
//! the errors of its terms is no larger than they are. Terms that are exact, like a dimension or a difference, are left
//! where they stand: with them a sum may be exact that another order rounds.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::build::Request;
use super::{Function, Stage};
use crate::expression::{Expression, Graph, Map, Node, Symbol};

/// Most terms of a sum that is looked at.
const LONG: usize = 40;

/// What a sum adds, but for its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Item {
    /// A term.
    Term(Expression),
    /// A part that was found, by index.
    Part(usize),
}

/// Two items, and whether their signs differ.
type Pair = (Item, Item, bool);

/// Items, and whether they have a minus.
type Items = BTreeMap<Item, bool>;

/// A sum that is looked at.
struct Host {
    /// Terms that may be put together.
    items: Items,
    /// The other terms.
    rest: Vec<Expression>,
    /// The functions that need the sum, as bits.
    functions: u64,
}

struct Sharer {
    hosts: Vec<Host>,
    stages: Map<Item, Stage>,
    /// For each pair the sums that had it once.
    pairs: Map<Pair, Vec<usize>>,
    heap: BinaryHeap<(usize, Reverse<Pair>)>,
    parts: Vec<Items>,
}

/// The expressions with common parts of sums in sums of their own. `functions` says for each root which function computes
/// it: what changes at every evaluation is worth sharing within one function only.
pub fn share(
    graph: &mut Graph,
    roots: &[Expression],
    functions: &[usize],
    request: &Request,
) -> Vec<Expression> {
    let reachable = graph.reachable(roots);
    let mut masks: Map<Expression, u64> = Map::default();
    for (root, function) in roots.iter().zip(functions) {
        *masks.entry(*root).or_insert(0) |= 1 << function.min(&63);
    }
    let mut sharer = Sharer {
        hosts: Vec::new(),
        stages: Map::default(),
        pairs: Map::default(),
        heap: BinaryHeap::new(),
        parts: Vec::new(),
    };
    let mut places: Map<Expression, usize> = Map::default();
    // Where the positive of a term comes from.
    let mut origins: Map<Item, (Expression, bool)> = Map::default();
    for one in reachable.iter().rev() {
        let functions = masks[one];
        for operand in graph.node(*one).operands() {
            *masks.entry(operand).or_insert(0) |= functions;
        }
        let Node::Sum(terms) = graph.node(*one).clone() else {
            continue;
        };
        let mut host = Host { items: Items::new(), rest: Vec::new(), functions };
        for term in terms {
            let negative = graph.split_coefficient(term).0 < 0.0;
            let positive = if negative { graph.neg(term) } else { term };
            if !is_rounded(graph, positive) {
                host.rest.push(term);
                continue;
            }
            let item = Item::Term(positive);
            host.items.insert(item, negative);
            let origin = origins.entry(item).or_insert((term, negative));
            *origin = (term, negative).min(*origin);
            let stage = || request.stage(graph, positive);
            sharer.stages.entry(item).or_insert_with(stage);
        }
        if host.items.len() > 1 && host.items.len() <= LONG {
            places.insert(*one, sharer.hosts.len());
            sharer.hosts.push(host);
        }
    }
    sharer.find();
    if sharer.parts.is_empty() {
        return roots.to_vec();
    }
    sharer.open();
    let mut new: Map<Expression, Expression> = Map::default();
    for old in reachable {
        let value = match places.get(&old).map(|place| &sharer.hosts[*place]) {
            Some(host) => {
                let mut terms: Vec<_> = host.rest.iter().map(|term| new[term]).collect();
                terms.extend(sharer.terms(graph, &host.items, &origins, &new));
                graph.sum(&terms)
            }
            None => {
                let node = graph.node(old).clone();
                graph.rebuild_with(&node, &new)
            }
        };
        graph.carry(old, value);
        new.insert(old, value);
    }
    roots.iter().map(|root| new[root]).collect()
}

/// Whether a value carries a rounding error of its own.
fn is_rounded(graph: &Graph, expression: Expression) -> bool {
    match graph.node(expression) {
        Node::Product(factors) => {
            let mut others = factors.iter().filter(|factor| !is_sign(graph, **factor));
            match (others.next(), others.next()) {
                (Some(one), None) => is_rounded(graph, *one),
                (first, _) => first.is_some(),
            }
        }
        Node::Power(..) | Node::Element(..) => true,
        Node::Call(function, _) => !matches!(
            function,
            Function::Abs | Function::Sign | Function::Floor | Function::Max | Function::Min
        ),
        _ => false,
    }
}

/// Whether multiplying by something is exact.
fn is_sign(graph: &Graph, factor: Expression) -> bool {
    match graph.node(factor) {
        Node::Symbol(Symbol::Mode(_) | Symbol::Side(_)) | Node::Call(Function::Sign, _) => true,
        Node::Number(number) => number.get().abs().log2().fract() == 0.0,
        _ => false,
    }
}

impl Sharer {
    /// Finds parts, those first that most sums have.
    fn find(&mut self) {
        for host in 0..self.hosts.len() {
            let items: Vec<Item> = self.hosts[host].items.keys().copied().collect();
            for (index, a) in items.iter().enumerate() {
                for b in &items[index + 1..] {
                    self.note(host, *a, *b);
                }
            }
        }
        for pair in self.pairs.keys().copied().collect::<Vec<_>>() {
            self.push(pair);
        }
        while let Some((count, Reverse(pair))) = self.heap.pop() {
            let hosts = self.having(&pair);
            if hosts.len() < count {
                self.pairs.insert(pair, self.all_having(&pair));
                self.push(pair);
            } else {
                self.take(pair, &hosts);
                self.push(pair);
            }
        }
    }

    /// Notes a pair that a sum has.
    fn note(&mut self, host: usize, a: Item, b: Item) -> Option<Pair> {
        if self.stages[&a] != self.stages[&b] {
            return None;
        }
        let (a, b) = (a.min(b), a.max(b));
        let items = &self.hosts[host].items;
        let pair = (a, b, items[&a] != items[&b]);
        self.pairs.entry(pair).or_default().push(host);
        Some(pair)
    }

    /// The sums that still have a pair.
    fn all_having(&self, (a, b, differ): &Pair) -> Vec<usize> {
        let hosts = self.pairs.get(&(*a, *b, *differ)).into_iter().flatten();
        let has = |host: &usize| {
            let items = &self.hosts[*host].items;
            let signs = items.get(a).zip(items.get(b));
            signs.is_some_and(|(a, b)| (a != b) == *differ)
        };
        hosts.copied().filter(has).collect()
    }

    /// The sums that are worth sharing a pair: what an instant keeps serves all functions, the rest only one.
    fn having(&self, pair: &Pair) -> Vec<usize> {
        let hosts = self.all_having(pair);
        if self.stages[&pair.0] < Stage::State {
            return hosts;
        }
        let of = |function: u32| {
            let needs = |host: &&usize| self.hosts[**host].functions >> function & 1 == 1;
            hosts.iter().filter(needs).copied().collect::<Vec<_>>()
        };
        let all = hosts.iter().map(|host| self.hosts[*host].functions);
        let functions: u64 = all.fold(0, |seen, one| seen | one);
        (0..u64::BITS)
            .filter(|function| functions >> function & 1 == 1)
            .map(of)
            .reduce(|most, one| if one.len() > most.len() { one } else { most })
            .unwrap_or_default()
    }

    fn push(&mut self, pair: Pair) {
        let count = self.having(&pair).len();
        if count > 1 {
            self.heap.push((count, Reverse(pair)));
        }
    }

    /// Makes a pair a part of some sums.
    fn take(&mut self, (a, b, differ): Pair, hosts: &[usize]) {
        let part = Item::Part(self.parts.len());
        self.parts.push(Items::from([(a, false), (b, differ)]));
        self.stages.insert(part, self.stages[&a]);
        let mut found = Vec::new();
        for host in hosts {
            let items = &mut self.hosts[*host].items;
            let negative = items.remove(&a).unwrap_or_default();
            items.remove(&b);
            items.insert(part, negative);
            let others: Vec<Item> = items.keys().copied().filter(|one| *one != part).collect();
            for other in others {
                found.extend(self.note(*host, part, other));
            }
        }
        found.sort_unstable();
        found.dedup();
        for pair in found {
            self.push(pair);
        }
    }

    /// Opens parts that occur once.
    fn open(&mut self) {
        let mut uses = vec![0; self.parts.len()];
        let hosts = self.hosts.iter().map(|host| &host.items);
        for item in hosts.chain(&self.parts).flat_map(Items::keys) {
            if let Item::Part(index) = item {
                uses[*index] += 1;
            }
        }
        // A part is made of earlier ones.
        for index in 0..self.parts.len() {
            let mut items = std::mem::take(&mut self.parts[index]);
            let inner: Vec<(Item, bool)> =
                items.iter().map(|(item, sign)| (*item, *sign)).collect();
            for (item, negative) in inner {
                if let Item::Part(earlier) = item
                    && uses[earlier] == 1
                {
                    items.remove(&item);
                    let own = self.parts[earlier].iter();
                    items.extend(own.map(|(item, sign)| (*item, *sign != negative)));
                }
            }
            self.parts[index] = items;
        }
    }

    /// The terms that items stand for.
    fn terms(
        &self,
        graph: &mut Graph,
        items: &Items,
        origins: &Map<Item, (Expression, bool)>,
        new: &Map<Expression, Expression>,
    ) -> Vec<Expression> {
        let mut terms = Vec::new();
        for (item, negative) in items {
            let (value, turned) = match item {
                Item::Term(_) => {
                    let (origin, turned) = origins[item];
                    (new[&origin], turned)
                }
                Item::Part(index) => {
                    let inner = self.terms(graph, &self.parts[*index], origins, new);
                    (graph.sum(&inner), false)
                }
            };
            terms.push(if *negative == turned { value } else { graph.neg(value) });
        }
        terms
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shares parts of `x² + y² + a` and `b − x² − y²`, with terms made by `term` of `x` and `y`.
    fn shared(
        term: fn(&mut Graph, Expression) -> Expression,
        functions: [usize; 2],
        request: &Request,
    ) -> Vec<String> {
        let mut graph = Graph::new();
        let [x, y, a, b] = [0, 1, 2, 3].map(|index| graph.symbol(Symbol::Parameter(index)));
        let [x, y] = [x, y].map(|one| term(&mut graph, one));
        let (minus_x, minus_y) = (graph.neg(x), graph.neg(y));
        let roots = [graph.sum(&[x, y, a]), graph.sum(&[b, minus_x, minus_y])];
        let roots = share(&mut graph, &roots, &functions, request);
        let sums = graph.reachable(&roots).into_iter();
        let sums: Vec<_> = sums.filter(|one| matches!(graph.node(*one), Node::Sum(_))).collect();
        sums.into_iter().map(|one| graph.display(one)).collect()
    }

    fn square(graph: &mut Graph, one: Expression) -> Expression {
        graph.powi(one, 2)
    }

    #[test]
    fn rounded_terms_are_added_once() {
        let sums = shared(square, [0, 0], &Request::default());
        assert_eq!(sums.len(), 3, "{sums:?}");
    }

    #[test]
    fn exact_terms_stay_where_they_are() {
        assert_eq!(shared(|_, one| one, [0, 0], &Request::default()).len(), 2);
        let twice = |graph: &mut Graph, one| graph.scale(2.0, one);
        assert_eq!(shared(twice, [0, 0], &Request::default()).len(), 2);
    }

    #[test]
    fn functions_share_what_an_instant_keeps() {
        let sums = shared(square, [0, 1], &Request::default());
        assert_eq!(sums.len(), 2, "{sums:?}");
        let inputs =
            (0..4).map(|index| (Symbol::Parameter(index), super::super::Input::Driver(index)));
        let request = Request { inputs: inputs.collect(), ..Request::default() };
        assert_eq!(shared(square, [0, 1], &request).len(), 3);
    }
}
