//! Switching surfaces: where a branch, `abs`, `sign`, `max` or `min` goes over to its other side.
//!
//! A step of an integration must not straddle one, and where it begins on one, rounding must not choose the side. So the
//! side is an input, 1 or −1, that whoever integrates holds fixed until the surface is reached; 0 leaves it to the
//! values, which is what everyone else wants.

use super::build::Request;
use super::{Event, Function, Input, Relation, Stage};
use crate::expression::{Expression, Graph, Map, Node, Set, Symbol};

/// Roots in which every branch asks for its side, and the surfaces with their rates.
pub struct Frozen {
    /// The roots.
    pub roots: Vec<Expression>,
    /// What else is asked of positions.
    pub asked: Vec<Expression>,
    /// For each side the guard that passes zero where it changes: it is positive on side 1.
    pub surfaces: Vec<Event<Expression>>,
    /// What passes zero there, in the words of the file.
    pub texts: Vec<String>,
}

/// Makes the sides of all branches inputs. `derivative` are the rates of the state, everything bound. Of what else is asked of
/// positions only branches that go over to the other side with one of these do the same: so both speak of the same motion.
pub fn freeze(
    graph: &mut Graph,
    roots: &[Expression],
    asked: &[Expression],
    derivative: &[Expression],
    request: &mut Request,
) -> Frozen {
    let mut freezer = Freezer {
        guards: Vec::new(),
        texts: Vec::new(),
        known: Map::default(),
        new: Map::default(),
        is_closed: false,
    };
    freezer.renew(graph, roots, request);
    freezer.is_closed = true;
    freezer.renew(graph, asked, request);
    let renew = |list: &[Expression]| -> Vec<Expression> {
        let new = |one: &Expression| freezer.new.get(one).copied().unwrap_or(*one);
        list.iter().map(new).collect()
    };
    let (roots, asked) = (renew(roots), renew(asked));
    let rates = renew(derivative);
    let surfaces = moving(graph, &freezer.guards, &rates, request);
    for index in 0..freezer.guards.len() as u32 {
        request.inputs.insert(Symbol::Side(index), Input::Side(index));
    }
    Frozen { roots, asked, surfaces, texts: freezer.texts }
}

/// The kinks of guards: where a branch that a guard sees goes over to its other side, and is no surface. Between the ends
/// of a step a guard is smooth but for them. Everything is bound.
pub fn kinks(
    graph: &mut Graph,
    guards: &[Expression],
    derivative: &[Expression],
    surfaces: &[Event<Expression>],
    request: &Request,
) -> Vec<Event<Expression>> {
    let mut kinks: Vec<Expression> = Vec::new();
    let mut known: Set<Expression> = surfaces.iter().map(|event| event.guard).collect();
    for one in graph.reachable(guards) {
        if request.stage(graph, one) <= Stage::Parameter || graph.is_tried(one) {
            continue;
        }
        let difference = match graph.node(one).clone() {
            Node::Compare(Relation::Less | Relation::LessEqual, a, b) => graph.sub(b, a),
            Node::Call(Function::Abs | Function::Sign, arguments) => arguments[0],
            Node::Call(Function::Max | Function::Min, arguments) => {
                graph.sub(arguments[0], arguments[1])
            }
            _ => continue,
        };
        let turned = graph.neg(difference);
        let is_new = !known.contains(&turned) && known.insert(difference);
        if graph.as_number(difference).is_none() && is_new {
            kinks.push(difference);
        }
    }
    moving(graph, &kinks, derivative, request)
}

/// The angles of which guards have the sine or cosine: how far they turn says in how many parts a step has to be looked
/// at.
pub fn turns(
    graph: &mut Graph,
    guards: &[Expression],
    derivative: &[Expression],
    request: &Request,
) -> Vec<Event<Expression>> {
    let mut angles: Vec<Expression> = Vec::new();
    let mut known: Set<Expression> = Set::default();
    for one in graph.reachable(guards) {
        if let Node::Call(Function::Sin | Function::Cos | Function::Tan, arguments) =
            graph.node(one)
            && request.stage(graph, arguments[0]) >= Stage::Instant
            && !graph.is_tried(arguments[0])
            && known.insert(arguments[0])
        {
            angles.push(arguments[0]);
        }
    }
    moving(graph, &angles, derivative, request)
}

/// Guards with their rates.
fn moving(
    graph: &mut Graph,
    guards: &[Expression],
    derivative: &[Expression],
    request: &Request,
) -> Vec<Event<Expression>> {
    let mut direction = Map::from_iter([(Symbol::Time, graph.one())]);
    for (symbol, input) in &request.inputs {
        if let Input::State(index) = input {
            direction.insert(*symbol, derivative[*index as usize]);
        }
    }
    let rates = graph.tangent(guards, &direction);
    let pairs = guards.iter().zip(rates);
    let events = pairs.map(|(guard, rate)| Event {
        guard: *guard,
        rate,
        condition: None,
        after: Vec::new(),
        slopes: Default::default(),
    });
    events.collect()
}

struct Freezer {
    guards: Vec<Expression>,
    texts: Vec<String>,
    /// Place of each guard.
    known: Map<Expression, usize>,
    new: Map<Expression, Expression>,
    /// Whether there are no more surfaces: other branches stay as they are.
    is_closed: bool,
}

impl Freezer {
    /// Renews all that roots are made of.
    fn renew(&mut self, graph: &mut Graph, roots: &[Expression], request: &Request) {
        for old in graph.reachable(roots) {
            if self.new.contains_key(&old) {
                continue;
            }
            let node = graph.node(old).clone();
            let value = match request.stage(graph, old) {
                Stage::Constant | Stage::Parameter => old,
                // Of what a search tries the sides change from trial to trial.
                _ if graph.is_tried(old) => graph.rebuild_with(&node, &self.new),
                _ => self.rebuild(graph, old, &node),
            };
            graph.carry(old, value);
            self.new.insert(old, value);
        }
    }

    fn rebuild(&mut self, graph: &mut Graph, old: Expression, node: &Node) -> Expression {
        let at = |new: &Map<Expression, Expression>, one: &Expression| {
            new.get(one).copied().unwrap_or(*one)
        };
        match node {
            Node::Compare(relation @ (Relation::Less | Relation::LessEqual), a, b) => {
                let (a, b) = (at(&self.new, a), at(&self.new, b));
                let guard = graph.sub(b, a);
                let free = graph.compare(*relation, a, b);
                self.condition(graph, old, guard, free).unwrap_or(free)
            }
            Node::Call(function @ (Function::Abs | Function::Sign), arguments) => {
                let x = at(&self.new, &arguments[0]);
                let (zero, one) = (graph.zero(), graph.one());
                let free = graph.compare(Relation::Less, zero, x);
                let Some(is_positive) = self.condition(graph, old, x, free) else {
                    return graph.rebuild_with(node, &self.new);
                };
                let (above, below) = match function {
                    Function::Abs => (x, graph.neg(x)),
                    _ => (one, graph.number(-1.0)),
                };
                graph.select(is_positive, above, below)
            }
            Node::Call(function @ (Function::Max | Function::Min), arguments) => {
                let (a, b) = (at(&self.new, &arguments[0]), at(&self.new, &arguments[1]));
                let guard = graph.sub(a, b);
                let free = graph.compare(Relation::Less, b, a);
                let Some(is_first_larger) = self.condition(graph, old, guard, free) else {
                    return graph.rebuild_with(node, &self.new);
                };
                match function {
                    Function::Max => graph.select(is_first_larger, a, b),
                    _ => graph.select(is_first_larger, b, a),
                }
            }
            _ => graph.rebuild_with(node, &self.new),
        }
    }

    /// Whether the guard of a branch is positive: as its side says, or as its values say where no side is given. None of a branch
    /// that has no side.
    fn condition(
        &mut self,
        graph: &mut Graph,
        branch: Expression,
        guard: Expression,
        free: Expression,
    ) -> Option<Expression> {
        if graph.as_number(guard).is_some() {
            return Some(free);
        }
        // A guard and its negative are one surface.
        let turned = graph.neg(guard);
        let (kept, sign) = match turned < guard {
            true => (turned, -1.0),
            false => (guard, 1.0),
        };
        if self.is_closed && !self.known.contains_key(&kept) {
            return None;
        }
        let index = *self.known.entry(kept).or_insert_with(|| {
            let words = graph.switch_of(branch).map(|words| words.to_string());
            self.texts.push(words.unwrap_or_else(|| graph.display(kept)));
            self.guards.push(kept);
            self.guards.len() - 1
        });
        let side = graph.symbol(Symbol::Side(index as u32));
        let (zero, one) = (graph.zero(), graph.number(sign));
        let other = graph.neg(one);
        let is_free = graph.compare(Relation::Equal, side, zero);
        let by_values = graph.select(free, one, other);
        let effective = graph.select(is_free, by_values, side);
        Some(match sign > 0.0 {
            true => graph.compare(Relation::Less, zero, effective),
            false => graph.compare(Relation::Less, effective, zero),
        })
    }
}
