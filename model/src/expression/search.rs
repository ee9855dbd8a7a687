//! What is found of a function over a range: its integral, where it is zero, its largest value.
//!
//! The function is a body in which the place is a bound symbol, from 0 to 1, so that what is found has no limits of its own: they
//! stand in the body, and derivatives along them are those of the body. A bound symbol has a level, higher than those of all
//! that is found inside the body; equal searches are one node, and none captures what belongs to another.

use assur_functions::{End, highest, mean, root};

use super::function::Function;
use super::graph::{Expression, Graph, Node, Symbol};
use super::hash::Map;

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Search {
    /// The mean. It has two bodies, for the first and the second half of the range: the bound symbol is the distance from the
    /// nearer end, so that nothing is lost beside it. Behind these stand, for its derivative alone, the formula with the bound
    /// symbol as its variable and the ends of the range, if it is not a derivative itself.
    Mean,
    /// Where the body is zero.
    Root,
    /// The largest value.
    Highest,
    /// Where that is.
    HighestPlace,
}

impl Search {
    /// How many bodies are evaluated.
    pub fn bodies(self) -> usize {
        if self == Self::Mean { 2 } else { 1 }
    }

    /// Finds it, given the value of each body at a place.
    pub fn find(self, at: &dyn Fn(usize, f64) -> f64) -> f64 {
        match self {
            Self::Mean => {
                let found = mean(&mut |part, values| {
                    for (index, value) in values.iter_mut().enumerate() {
                        let (end, distance) = part.point(index);
                        *value = at(usize::from(end == End::Far), distance);
                    }
                });
                found.value
            }
            Self::Root => root(&mut |place| at(0, place)).place(),
            Self::Highest => highest(&mut |place| at(0, place)).value,
            Self::HighestPlace => highest(&mut |place| at(0, place)).place,
        }
    }
}

impl Graph {
    /// The length of a range and the mean of a body over it, whose product is `∫ body dx` from `low` to `high`.
    pub fn integral(
        &mut self,
        body: Expression,
        x: Symbol,
        (low, high): (Expression, Expression),
    ) -> (Expression, Expression) {
        let length = self.sub(high, low);
        let share = self.symbol(x);
        let places = self.from_both_ends((low, high), share);
        let [near, far] = places.map(|place| self.at_place(body, x, place));
        (length, self.search(Search::Mean, x, &[near, far, body, low, high]))
    }

    /// The places at a share of a range from its begin and from its end, each the sum of the end and the distance. Whatever else
    /// the ends are added to or taken from, the distance stays whole: beside an end nothing else is left.
    pub fn from_both_ends(
        &mut self,
        (low, high): (Expression, Expression),
        share: Expression,
    ) -> [[Expression; 2]; 2] {
        let length = self.sub(high, low);
        let part = self.mul(length, share);
        let part = self.whole(part);
        let away = self.neg(part);
        [[low, part], [high, away]]
    }

    /// A body at a place that is a sum. Sums in the body take its terms: what cancels beside an end cancels exactly.
    pub fn at_place(&mut self, body: Expression, x: Symbol, place: [Expression; 2]) -> Expression {
        let whole = self.sum(&place);
        let mut new: Map<Expression, Expression> = Map::default();
        for old in self.reachable(&[body]) {
            if !self.depends_on(old, |symbol| symbol == x) {
                continue;
            }
            let node = self.node(old).clone();
            let value = match &node {
                Node::Symbol(_) => whole,
                Node::Sum(terms) => {
                    let mut list = Vec::new();
                    for term in terms {
                        let (coefficient, rest) = self.split_coefficient(*term);
                        match self.node(rest) {
                            Node::Symbol(symbol) if *symbol == x => {
                                list.extend(place.map(|one| self.scale(coefficient, one)));
                            }
                            _ => list.push(new.get(term).copied().unwrap_or(*term)),
                        }
                    }
                    self.sum(&list)
                }
                _ => self.rebuild_with(&node, &new),
            };
            self.carry(old, value);
            new.insert(old, value);
        }
        new.get(&body).copied().unwrap_or(body)
    }

    /// Where, as a share of the range, or how large what is looked for is between `low` and `high`.
    pub fn found_between(
        &mut self,
        search: Search,
        body: Expression,
        x: Symbol,
        (low, high): (Expression, Expression),
    ) -> Expression {
        let share = self.symbol(x);
        let place = self.between((low, high), share);
        let body = self.substitute(&[body], &Map::from_iter([(x, place)]));
        self.search(search, x, &body)
    }

    /// The place at a share of a range.
    pub fn between(
        &mut self,
        (low, high): (Expression, Expression),
        share: Expression,
    ) -> Expression {
        let length = self.sub(high, low);
        let part = self.mul(length, share);
        self.add(low, part)
    }

    /// Looks for something in bodies that a symbol stands in.
    fn search(&mut self, search: Search, x: Symbol, bodies: &[Expression]) -> Expression {
        if !self.depends_on(bodies[0], |symbol| symbol == x)
            && let Search::Mean | Search::Highest = search
        {
            return bodies[0];
        }
        let inner = self.reachable(bodies).into_iter().filter_map(|one| match self.node(one) {
            Node::Search(_, level, _) => Some(level + 1),
            _ => None,
        });
        let level = inner.max().unwrap_or(0);
        let bound = self.symbol(Symbol::Bound(level));
        let bodies = self.substitute(bodies, &Map::from_iter([(x, bound)]));
        self.intern(Node::Search(search, level, bodies.into()))
    }

    /// Whether something changes from trial to trial of a search.
    pub fn is_tried(&self, one: Expression) -> bool {
        self.depends_on(one, |symbol| matches!(symbol, Symbol::Bound(_)))
    }

    /// How what is found changes along a direction, in which its bodies change by `rates`.
    pub(super) fn rate_of_search(
        &mut self,
        found: Expression,
        rates: &Map<Expression, Expression>,
    ) -> Expression {
        let zero = self.zero();
        let Node::Search(search, level, bodies) = self.node(found).clone() else {
            return zero;
        };
        let bound = Symbol::Bound(level);
        let rates: Vec<_> =
            bodies.iter().map(|body| rates.get(body).copied().unwrap_or(zero)).collect();
        match search {
            Search::Mean => match *bodies {
                // The formula does not change, but its ends.
                [_, _, body, low, high] if rates[2] == zero => {
                    let ends = [(low, rates[3]), (high, rates[4])];
                    self.rate_by_ends(found, bound, body, ends)
                }
                _ => self.mean_of(level, &rates[..2]),
            },
            // The place does not count where the slope is zero; at an end it stays.
            Search::Highest => {
                let place = self.intern(Node::Search(Search::HighestPlace, level, bodies));
                self.substitute(&rates, &Map::from_iter([(bound, place)]))[0]
            }
            Search::Root => self.place_rate(found, bound, (bodies[0], rates[0])),
            Search::HighestPlace => {
                let one = self.one();
                let along = Map::from_iter([(bound, one)]);
                let slopes = self.tangent(&[bodies[0], rates[0]], &along);
                let inside = self.place_rate(found, bound, (slopes[0], slopes[1]));
                let begins = self.compare(super::Relation::Less, zero, found);
                let ends = self.compare(super::Relation::Less, found, one);
                let is_inside = self.and(begins, ends);
                let is_smooth = self.is_smooth_top(found, bound, slopes[0]);
                let moves = self.and(is_inside, is_smooth);
                self.select(moves, inside, zero)
            }
        }
    }

    /// The mean of bodies that have the bound symbol of a level already.
    fn mean_of(&mut self, level: u32, bodies: &[Expression]) -> Expression {
        let bound = |symbol: Symbol| symbol == Symbol::Bound(level);
        match bodies.iter().any(|body| self.depends_on(*body, bound)) {
            true => self.intern(Node::Search(Search::Mean, level, bodies.into())),
            false => bodies[0],
        }
    }

    /// How the mean of a formula changes with the ends of its range: `(f(b)·ḃ - f(a)·ȧ - mean·(ḃ - ȧ))/(b - a)`.
    fn rate_by_ends(
        &mut self,
        mean: Expression,
        bound: Symbol,
        body: Expression,
        [(low, low_rate), (high, high_rate)]: [(Expression, Expression); 2],
    ) -> Expression {
        // As the product of mean and length has it, from whose rate it falls out.
        let growth = self.sub(high_rate, low_rate);
        let widening = self.mul(mean, growth);
        let mut terms = vec![self.neg(widening)];
        for (sign, end, rate) in [(-1.0, low, low_rate), (1.0, high, high_rate)] {
            // At an end that stays the formula may be infinite.
            if self.as_number(rate) != Some(0.0) {
                let value = self.substitute(&[body], &Map::from_iter([(bound, end)]))[0];
                let change = self.mul(value, rate);
                terms.push(self.scale(sign, change));
            }
        }
        let (sum, length) = (self.sum(&terms), self.sub(high, low));
        self.div(sum, length)
    }

    /// Whether the slope vanishes where a body is largest, as it does but for kinks: there the place stays.
    fn is_smooth_top(&mut self, place: Expression, bound: Symbol, slope: Expression) -> Expression {
        /// Part of the range within which a parabola with this slope has its top.
        const NEAR: f64 = 1e-3;
        let one = self.one();
        let bend = self.tangent(&[slope], &Map::from_iter([(bound, one)]))[0];
        let there = self.substitute(&[slope, bend], &Map::from_iter([(bound, place)]));
        let [steep, bend] = [there[0], there[1]].map(|one| self.call(Function::Abs, &[one]));
        let near = self.scale(NEAR, bend);
        self.compare(super::Relation::LessEqual, steep, near)
    }

    /// How a place at which a body is zero changes, where the body there changes by a rate.
    fn place_rate(
        &mut self,
        place: Expression,
        bound: Symbol,
        (body, rate): (Expression, Expression),
    ) -> Expression {
        let one = self.one();
        let slope = self.tangent(&[body], &Map::from_iter([(bound, one)]))[0];
        let there = self.substitute(&[rate, slope], &Map::from_iter([(bound, place)]));
        let quotient = self.div(there[0], there[1]);
        self.neg(quotient)
    }

    /// A body in which what the bound symbol of a level does not change is taken together, wherever sums and products have it
    /// beside what changes.
    pub(crate) fn with_steady_parts(&mut self, body: Expression, level: u32) -> Expression {
        let changes = |graph: &Self, one: Expression| {
            graph.depends_on(one, |symbol| symbol == Symbol::Bound(level))
        };
        let mut new: Map<Expression, Expression> = Map::default();
        for old in self.reachable(&[body]) {
            if !changes(self, old) {
                continue;
            }
            let node = self.node(old).clone();
            let together = |graph: &mut Self, list: &[Expression], join: Join| {
                let (moving, steady): (Vec<Expression>, Vec<Expression>) =
                    list.iter().partition(|one| changes(graph, **one));
                let mut all: Vec<Expression> = moving.iter().map(|one| new[one]).collect();
                if !steady.is_empty() {
                    all.push(join(graph, &steady));
                }
                join(graph, &all)
            };
            let value = match &node {
                Node::Sum(list) => together(self, list, Self::sum),
                Node::Product(list) => together(self, list, Self::product),
                _ => self.rebuild_with(&node, &new),
            };
            self.carry(old, value);
            new.insert(old, value);
        }
        new.get(&body).copied().unwrap_or(body)
    }
}

/// Adds or multiplies.
type Join = fn(&mut Graph, &[Expression]) -> Expression;
