//! The nodes, each kept once.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::hash::{BuildHasher, BuildHasherDefault};
use std::rc::Rc;
use std::sync::Arc;

use assur_functions::Spline;

use super::budget::Budget;
use super::build::Made;
use super::function::{Function, Relation};
use super::hash::{Index, Map, WordHasher};
use super::linear::Form;
use super::search::Search;
use super::support::Supports;

/// Nodes may stand in each other this deep: what walks through them goes as deep.
const DEEPEST: u32 = 20_000;

/// A handle to a node. Operands have smaller handles than what is made of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expression(pub(super) u32);

/// Something given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Symbol {
    /// A dimension or parameter.
    Parameter(u32),
    /// The time.
    Time,
    /// A driver, that is its position.
    Driver(u32),
    /// The speed of a driver.
    DriverRate(u32),
    /// The acceleration of a driver.
    DriverAcceleration(u32),
    /// A dependent coordinate, which closures determine.
    Dependent(u32),
    /// The time derivative of a dependent coordinate.
    DependentRate(u32),
    /// The second time derivative of a dependent coordinate.
    DependentAcceleration(u32),
    /// The force of a scalar closure, by the index of its equation.
    Reaction(u32),
    /// The same as other forces depend on it.
    Felt(u32),
    /// The force that the motion of a driver takes.
    Effort(u32),
    /// Kinetic energy, potential energy, dissipated power of the whole.
    Energy(u32),
    /// The assembly mode of a group, 1 or −1.
    Mode(u32),
    /// On which side of a switching surface the motion is, 1 or −1; 0 where its values say it.
    Side(u32),
    /// What has been found of a run for a measure.
    Measured(u32),
    /// A generalized coordinate.
    Coordinate(u32),
    /// The time derivative of a coordinate.
    Speed(u32),
    /// A first-order state.
    State(u32),
    /// A highest derivative: of a coordinate the second, of a state (counted behind the coordinates) the first.
    Acceleration(u32),
    /// An argument of a function while it is differentiated.
    Argument(u32),
    /// By how much a component of the state vector changes in a column that the Jacobian is multiplied with.
    Change(u32),
    /// The place at which a search of this level tries its body, a share of the range.
    Bound(u32),
}

/// A number that can be compared and hashed; never NaN, and zero has no sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Real(u64);

impl Real {
    /// Wraps a number.
    pub fn new(value: f64) -> Self {
        Self((value + 0.0).to_bits())
    }

    /// The number.
    pub fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// A node.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// Something given.
    Symbol(Symbol),
    /// A number.
    Number(Real),
    /// A sum, terms rising.
    Sum(Box<[Expression]>),
    /// A product, factors rising; a number stands first.
    Product(Box<[Expression]>),
    /// A power.
    Power(Expression, Expression),
    /// A function.
    Call(Function, Box<[Expression]>),
    /// A value that many others contain: it is computed once, and never taken apart into them.
    Whole(Expression),
    /// A condition.
    Compare(Relation, Expression, Expression),
    /// Both conditions.
    And(Expression, Expression),
    /// Either condition.
    Or(Expression, Expression),
    /// Not the condition.
    Not(Expression),
    /// The second where the first holds, else the third.
    Select(Expression, Expression, Expression),
    /// Factors of a matrix: its form, its size and the entries that the form asks for.
    Factor(Form, u32, Box<[Expression]>),
    /// Solution of a factored system.
    Solve(Expression, Box<[Expression]>),
    /// An element of a solution.
    Element(Expression, u32),
    /// What is found of bodies in which the bound symbol of this level goes from 0 to 1.
    Search(Search, u32, Box<[Expression]>),
    /// A derivative of a sampled curve at a place.
    Table(Arc<Spline>, u32, Expression),
}

impl Node {
    /// The operands.
    pub fn operands(&self) -> impl Iterator<Item = Expression> + '_ {
        let (first, list): ([Option<Expression>; 3], &[Expression]) = match self {
            Node::Symbol(_) | Node::Number(_) => ([None; 3], &[]),
            Node::Sum(list)
            | Node::Product(list)
            | Node::Call(_, list)
            | Node::Factor(_, _, list)
            | Node::Search(_, _, list) => ([None; 3], list),
            Node::Solve(factor, right) => ([Some(*factor), None, None], right),
            Node::Not(a) | Node::Element(a, _) | Node::Whole(a) | Node::Table(_, _, a) => {
                ([Some(*a), None, None], &[])
            }
            Node::Power(a, b) | Node::Compare(_, a, b) | Node::And(a, b) | Node::Or(a, b) => {
                ([Some(*a), Some(*b), None], &[])
            }
            Node::Select(a, b, c) => ([Some(*a), Some(*b), Some(*c)], &[]),
        };
        first.into_iter().flatten().chain(list.iter().copied())
    }
}

/// All expressions of a scene.
#[derive(Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    index: Index,
    names: Map<Expression, String>,
    switches: Map<Expression, Rc<str>>,
    /// For each node the set of its symbols.
    support: Vec<u32>,
    supports: Supports,
    /// For each node how many nodes stand in each other.
    depth: Vec<u32>,
    visit: RefCell<Visit>,
    pub(super) made: Made,
    budget: Rc<Budget>,
}

/// Which walk met each node last, so that a walk costs what it meets and not the whole graph.
#[derive(Debug, Default)]
struct Visit {
    now: u32,
    last: Vec<u32>,
}

impl Visit {
    /// The number of a walk that begins.
    fn begin(&mut self, nodes: usize) -> u32 {
        self.last.resize(nodes, 0);
        if self.now == u32::MAX {
            self.last.fill(0);
            self.now = 0;
        }
        self.now += 1;
        self.now
    }
}

impl Graph {
    /// An empty graph that may grow as it likes.
    pub fn new() -> Self {
        Self::within(Rc::default())
    }

    /// An empty graph whose steps are counted.
    pub fn within(budget: Rc<Budget>) -> Self {
        Self { budget, ..Self::default() }
    }

    /// What the graph may cost.
    pub fn budget(&self) -> &Rc<Budget> {
        &self.budget
    }

    /// The handle of a node.
    pub(super) fn intern(&mut self, node: Node) -> Expression {
        self.budget.spend(1 + node.operands().count());
        let hash = BuildHasherDefault::<WordHasher>::default().hash_one(&node) as u32;
        if let Some(known) = self.index.find(hash, |known| self.nodes[known as usize] == node) {
            return Expression(known);
        }
        let support = match &node {
            Node::Symbol(symbol) => self.supports.single(*symbol),
            _ => {
                let sets = node.operands().map(|operand| self.support[operand.0 as usize]);
                let all = self.supports.union(sets);
                match node {
                    Node::Search(_, level, _) => self.supports.without(all, Symbol::Bound(level)),
                    _ => all,
                }
            }
        };
        let depths = node.operands().map(|operand| 1 + self.depth[operand.0 as usize]);
        let depth = depths.max().unwrap_or(0);
        if depth > DEEPEST {
            self.budget.exhaust();
        }
        self.depth.push(depth);
        let handle = Expression(self.nodes.len() as u32);
        self.nodes.push(node);
        self.support.push(support);
        self.index.insert(hash, handle.0);
        handle
    }

    /// The node.
    pub fn node(&self, expression: Expression) -> &Node {
        &self.nodes[expression.0 as usize]
    }

    /// The number that an expression is.
    pub fn as_number(&self, expression: Expression) -> Option<f64> {
        match self.node(expression) {
            Node::Number(value) => Some(value.get()),
            _ => None,
        }
    }

    /// Gives an expression the name that it has in the file, unless it has one.
    pub fn name(&mut self, expression: Expression, name: &str) {
        if !matches!(self.node(expression), Node::Number(_)) {
            self.names.entry(expression).or_insert_with(|| name.to_string());
        }
    }

    /// The name of an expression.
    pub fn name_of(&self, expression: Expression) -> Option<&str> {
        self.names.get(&expression).map(String::as_str)
    }

    /// Says in the words of the file what passes zero where a branch, or a function that jumps or bends, goes over to its
    /// other side; the first words stay.
    pub fn name_switch(&mut self, branch: Expression, words: impl Into<Rc<str>>) {
        self.switches.entry(branch).or_insert_with(|| words.into());
    }

    /// What passes zero where a branch goes over to its other side, in the words of the file.
    pub fn switch_of(&self, branch: Expression) -> Option<&Rc<str>> {
        self.switches.get(&branch)
    }

    /// Lets a branch go over where another one does, of which it is the slope or the copy.
    pub(super) fn carry_switch(&mut self, old: Expression, new: Expression) {
        if let (Some(words), true) = (self.switches.get(&old).cloned(), old != new) {
            self.name_switch(new, words);
        }
    }

    /// Whether a symbol of a kind occurs.
    pub fn depends_on(&self, expression: Expression, kind: impl Fn(Symbol) -> bool) -> bool {
        let set = self.support(expression);
        self.budget.spend(1 + self.supports.words(set));
        self.supports.symbols(set).any(kind)
    }

    /// The set of the symbols that occur, by number: equal sets have equal numbers.
    pub fn support(&self, expression: Expression) -> u32 {
        self.support[expression.0 as usize]
    }

    /// The symbols that occur, in no order that means anything.
    pub fn occurring(&self, expression: Expression) -> impl Iterator<Item = Symbol> + '_ {
        self.supports.symbols(self.support(expression))
    }

    /// The symbols that occur in some expressions, rising.
    pub fn symbols(&self, expressions: &[Expression]) -> BTreeSet<Symbol> {
        let sets: BTreeSet<u32> = expressions.iter().map(|one| self.support(*one)).collect();
        let sets = sets.into_iter();
        sets.flat_map(|set| self.supports.symbols(set)).collect()
    }

    /// All nodes that some expressions are made of, operands first.
    pub fn reachable(&self, roots: &[Expression]) -> Vec<Expression> {
        let mut visit = self.visit.borrow_mut();
        let now = visit.begin(self.nodes.len());
        let mut found: Vec<Expression> = Vec::new();
        let mut stack: Vec<Expression> = roots.to_vec();
        while let Some(one) = stack.pop() {
            if std::mem::replace(&mut visit.last[one.0 as usize], now) != now {
                found.push(one);
                stack.extend(self.node(one).operands());
            }
        }
        self.budget.spend(found.len());
        found.sort_unstable();
        found
    }

    /// Number of nodes that some expressions are made of.
    pub fn size(&self, roots: &[Expression]) -> usize {
        self.reachable(roots).len()
    }

    /// Rebuilds a node with other operands.
    pub(super) fn rebuild(
        &mut self,
        node: &Node,
        operand: &dyn Fn(Expression) -> Expression,
    ) -> Expression {
        let list = |items: &[Expression]| items.iter().map(|one| operand(*one)).collect::<Vec<_>>();
        match node {
            Node::Symbol(symbol) => self.symbol(*symbol),
            Node::Number(value) => self.number(value.get()),
            Node::Sum(terms) => self.sum(&list(terms)),
            Node::Product(factors) => self.product(&list(factors)),
            Node::Power(base, exponent) => self.pow(operand(*base), operand(*exponent)),
            Node::Call(function, arguments) => self.call(*function, &list(arguments)),
            Node::Compare(relation, a, b) => self.compare(*relation, operand(*a), operand(*b)),
            Node::And(a, b) => self.and(operand(*a), operand(*b)),
            Node::Or(a, b) => self.or(operand(*a), operand(*b)),
            Node::Whole(a) => self.whole(operand(*a)),
            Node::Not(a) => self.not(operand(*a)),
            Node::Table(spline, order, a) => self.sampled(spline.clone(), *order, operand(*a)),
            Node::Select(c, a, b) => self.select(operand(*c), operand(*a), operand(*b)),
            Node::Factor(form, size, entries) => {
                let entries = list(entries).into();
                self.intern(Node::Factor(*form, *size, entries))
            }
            Node::Solve(factor, right) => {
                let right = list(right).into();
                self.intern(Node::Solve(operand(*factor), right))
            }
            Node::Element(solution, index) => {
                self.intern(Node::Element(operand(*solution), *index))
            }
            Node::Search(search, level, bodies) => {
                let bodies = list(bodies).into();
                self.intern(Node::Search(*search, *level, bodies))
            }
        }
    }

    /// The expressions with symbols replaced, all at once.
    pub fn substitute(
        &mut self,
        roots: &[Expression],
        map: &Map<Symbol, Expression>,
    ) -> Vec<Expression> {
        let touched = |graph: &Graph, one: Expression| {
            graph.depends_on(one, |symbol| map.contains_key(&symbol))
        };
        let mut new: Map<Expression, Expression> = Map::default();
        for old in self.reachable(roots) {
            if !touched(self, old) {
                continue;
            }
            let node = self.node(old).clone();
            let value = match &node {
                Node::Symbol(symbol) => map[symbol],
                _ => self.rebuild(&node, &|operand| new.get(&operand).copied().unwrap_or(operand)),
            };
            self.carry_name(old, value);
            new.insert(old, value);
        }
        roots.iter().map(|root| new.get(root).copied().unwrap_or(*root)).collect()
    }

    /// The name of an expression goes to what has taken its place, unless that is something given.
    pub(super) fn carry_name(&mut self, old: Expression, new: Expression) {
        self.carry_switch(old, new);
        let given =
            matches!(self.node(old), Node::Symbol(_)) != matches!(self.node(new), Node::Symbol(_));
        if let (Some(name), false) = (self.names.get(&old).cloned(), old == new || given) {
            self.name(new, &name);
        }
    }
}

impl Graph {
    /// Rebuilds a node from operands that have been rebuilt.
    pub(crate) fn rebuild_with(
        &mut self,
        node: &Node,
        new: &Map<Expression, Expression>,
    ) -> Expression {
        self.rebuild(node, &|operand| new.get(&operand).copied().unwrap_or(operand))
    }

    /// Carries a name over; see [`Graph::simplify`].
    pub(crate) fn carry(&mut self, old: Expression, new: Expression) {
        self.carry_name(old, new);
    }
}
