//! Writes expressions down as operations.
//!
//! A sum or product whose operands belong to different stages is split: the part of each stage is computed in that
//! stage. A product that is added once is added by one operation. Equal operations are written once.

use std::hash::{Hash, Hasher};

use super::build::Request;
use super::latency;
use super::search::Frame;
use super::{Function, Input, Operation, OperationKind, Stage, Value};
use crate::expression::{Expression, Graph, Map, Node, Symbol};

/// All stages, rising.
pub(super) const STAGES: [Stage; 5] =
    [Stage::Constant, Stage::Parameter, Stage::Instant, Stage::State, Stage::Trial];

/// Writes operations.
pub struct Emitter<'a> {
    /// The operations so far.
    pub operations: Vec<Operation>,
    pub(super) graph: &'a mut Graph,
    request: &'a Request,
    pub(super) uses: Map<Expression, usize>,
    /// In how many products of three factors and more a factor occurs, and in how many of two: what long ones have in
    /// common is worth multiplying first.
    pub(super) frequency: Map<Expression, (usize, usize)>,
    /// How many products begin with what earlier stages leave and this first factor of the last one.
    pub(super) beginnings: Map<(Vec<Expression>, Expression), usize>,
    /// How many products have these factors of their last stage.
    pub(super) endings: Map<Vec<Expression>, usize>,
    pub(super) known: Map<Key, Value>,
    /// How long each operation takes after the state is known, in additions.
    pub(super) depths: Vec<u32>,
    pub(super) done: Map<Expression, Value>,
    /// The level of the search whose line is written, if one is, and what its lines capture.
    pub(super) level: Option<(u32, Vec<Value>)>,
    /// What stands around the line that is written.
    pub(super) frames: Vec<Frame>,
}

/// An operation as a key of a map: numbers by their bits, what commutes in one order.
pub(super) struct Key(OperationKind);

impl Key {
    fn of(kind: &OperationKind) -> Self {
        Self(match kind.clone() {
            OperationKind::Add(a, b) => OperationKind::Add(a.min(b), a.max(b)),
            OperationKind::Multiply(a, b) => OperationKind::Multiply(a.min(b), a.max(b)),
            kind => kind,
        })
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (OperationKind::Number(a), OperationKind::Number(b)) => a.to_bits() == b.to_bits(),
            (a, b) => a == b,
        }
    }
}

impl Eq for Key {}

impl Hash for Key {
    fn hash<H: Hasher>(&self, state: &mut H) {
        std::mem::discriminant(&self.0).hash(state);
        match &self.0 {
            OperationKind::Number(number) => number.to_bits().hash(state),
            OperationKind::Input(input) => input.hash(state),
            OperationKind::Element { solution, index } => (solution, index).hash(state),
            kind => kind.operands().hash(state),
        }
    }
}

impl<'a> Emitter<'a> {
    /// Begins to write what some expressions are made of.
    pub fn new(
        graph: &'a mut Graph,
        request: &'a Request,
        roots: &[Expression],
        often: usize,
    ) -> Self {
        let reachable = graph.reachable(roots);
        let uses = graph.uses(roots, often);
        let mut frequency = Map::default();
        for one in &reachable {
            if let Node::Product(factors) = graph.node(*one) {
                let is_number = |factor: &&Expression| graph.as_number(**factor).is_some();
                let is_long = factors.len() - factors.iter().filter(is_number).count() > 2;
                for factor in factors {
                    let (long, short) = frequency.entry(*factor).or_insert((0, 0));
                    *(if is_long { long } else { short }) += 1;
                }
            }
        }
        let mut emitter = Self {
            operations: Vec::new(),
            graph,
            request,
            uses,
            frequency,
            beginnings: Map::default(),
            endings: Map::default(),
            known: Map::default(),
            depths: Vec::new(),
            done: Map::default(),
            level: None,
            frames: Vec::new(),
        };
        for one in reachable {
            emitter.count(one);
        }
        emitter
    }

    /// The value of an expression.
    pub fn value(&mut self, expression: Expression) -> Value {
        if let Some(done) = self.done.get(&expression) {
            return *done;
        }
        if self.is_captured(expression) {
            let value = self.capture(expression);
            self.done.insert(expression, value);
            return value;
        }
        let value = self.write(expression);
        if let Some(name) = self.graph.name_of(expression) {
            let slot = &mut self.operations[value.0 as usize].name;
            if slot.is_none() {
                *slot = Some(name.to_string());
            }
        }
        self.done.insert(expression, value);
        value
    }

    fn values(&mut self, list: &[Expression]) -> Vec<Value> {
        list.iter().map(|one| self.value(*one)).collect()
    }

    fn write(&mut self, expression: Expression) -> Value {
        match self.graph.node(expression).clone() {
            Node::Symbol(Symbol::Bound(_)) => {
                self.push(OperationKind::Input(Input::Place), Stage::Trial)
            }
            Node::Symbol(symbol) => match self.request.inputs.get(&symbol) {
                Some(input) => {
                    self.push(OperationKind::Input(*input), self.request.stage_of(symbol))
                }
                // Nothing else is left when everything is bound.
                None => self.number(f64::NAN),
            },
            Node::Number(value) => self.number(value.get()),
            Node::Sum(terms) => self.sum(&terms),
            Node::Product(factors) => self.product(&factors),
            Node::Power(base, exponent) => self.power(base, exponent),
            Node::Call(function @ (Function::Sin | Function::Cos), arguments)
                if self.kept_angle(arguments[0]).is_some() =>
            {
                let place = self.kept_angle(arguments[0]).unwrap_or_default() as u32;
                let place = place + u32::from(function == Function::Sin);
                self.push(OperationKind::Input(Input::Position(place)), Stage::State)
            }
            Node::Call(function, arguments) => {
                let arguments = self.values(&arguments);
                self.call(function, arguments)
            }
            Node::Compare(relation, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.combine(OperationKind::Compare(relation, a, b))
            }
            Node::And(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.combine(OperationKind::And(a, b))
            }
            Node::Or(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.combine(OperationKind::Or(a, b))
            }
            Node::Whole(a) => self.value(a),
            Node::Not(a) => {
                let a = self.value(a);
                self.combine(OperationKind::Not(a))
            }
            Node::Select(condition, then, otherwise) => {
                let (condition, then, otherwise) =
                    (self.value(condition), self.value(then), self.value(otherwise));
                self.combine(OperationKind::Select { condition, then, otherwise })
            }
            Node::Factor(form, size, entries) => {
                let entries = self.values(&entries);
                self.combine(OperationKind::Factor { form, size, entries })
            }
            Node::Solve(factor, right) => {
                let factor = self.value(factor);
                let right = self.values(&right);
                self.combine(OperationKind::Solve { factor, right })
            }
            Node::Table(spline, order, at) => {
                let at = self.value(at);
                let solution = self.combine(OperationKind::Table { spline, at });
                self.combine(OperationKind::Element { solution, index: order })
            }
            Node::Search(..) => self.search(expression),
            Node::Element(solution, index) => {
                let solution = self.value(solution);
                self.combine(OperationKind::Element { solution, index })
            }
        }
    }

    /// Where the position keeps the cosine of an angle, if it is a dependent coordinate.
    fn kept_angle(&self, angle: Expression) -> Option<usize> {
        match self.graph.node(angle) {
            Node::Symbol(Symbol::Dependent(index)) => {
                *self.request.results.closing.cosines.get(*index as usize)?
            }
            _ => None,
        }
    }

    pub(super) fn number(&mut self, value: f64) -> Value {
        self.push(OperationKind::Number(value), Stage::Constant)
    }

    fn call(&mut self, function: Function, arguments: Vec<Value>) -> Value {
        self.combine(OperationKind::Call(function, arguments))
    }

    /// Adds an operation in the latest stage of its operands.
    pub(super) fn combine(&mut self, kind: OperationKind) -> Value {
        let latest =
            kind.operands().iter().map(|value| self.stage(*value)).max().unwrap_or(Stage::Constant);
        // A row of an instant keeps numbers, and factors are more than that: those of a matrix that depends on the time
        // alone are found at each evaluation.
        let stage = match (&kind, latest) {
            (OperationKind::Factor { .. }, Stage::Instant) => Stage::State,
            _ => latest,
        };
        self.push(kind, stage)
    }

    fn stage(&self, value: Value) -> Stage {
        self.operations[value.0 as usize].stage
    }

    pub(super) fn push(&mut self, kind: OperationKind, stage: Stage) -> Value {
        let key = Key::of(&kind);
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let value = Value(self.operations.len() as u32);
        let depth = match stage {
            Stage::State => latency::of(&kind, |value| self.depths[value.0 as usize]),
            _ => 0,
        };
        self.depths.push(depth);
        self.operations.push(Operation { kind, stage, name: None });
        self.known.insert(key, value);
        value
    }

    pub(super) fn multiply(&mut self, a: Value, b: Value) -> Value {
        self.combine(OperationKind::Multiply(a, b))
    }

    pub(super) fn expression_stage(&self, expression: Expression) -> Stage {
        self.request.stage(self.graph, expression)
    }

    /// `base^exponent` by products and roots where the exponent is a whole or a half number.
    fn power(&mut self, base: Expression, exponent: Expression) -> Value {
        let value = self.value(base);
        let Some(number) = self.graph.as_number(exponent) else {
            let exponent = self.value(exponent);
            return self.call(Function::Power, vec![value, exponent]);
        };
        let doubled = 2.0 * number.abs();
        if doubled.fract() != 0.0 || doubled > 64.0 {
            let exponent = self.number(number);
            return self.call(Function::Power, vec![value, exponent]);
        }
        let whole = number.abs().trunc() as u32;
        let mut result = (whole > 0).then(|| self.whole_power(value, whole));
        if number.fract() != 0.0 {
            let root = self.call(Function::Sqrt, vec![value]);
            result = Some(result.map_or(root, |power| self.multiply(power, root)));
        }
        let one = self.number(1.0);
        let result = result.unwrap_or(one);
        if number < 0.0 { self.combine(OperationKind::Divide(one, result)) } else { result }
    }

    /// By repeated squaring.
    fn whole_power(&mut self, base: Value, exponent: u32) -> Value {
        if exponent == 1 {
            return base;
        }
        let half = self.whole_power(base, exponent / 2);
        let square = self.multiply(half, half);
        if exponent.is_multiple_of(2) { square } else { self.multiply(square, base) }
    }

    fn sum(&mut self, terms: &[Expression]) -> Value {
        let mut total: Option<Value> = None;
        for stage in STAGES {
            let own: Vec<Expression> = terms
                .iter()
                .copied()
                .filter(|term| self.expression_stage(*term) == stage)
                .collect();
            if !own.is_empty() {
                total = Some(self.add_terms(total, &own));
            }
        }
        match total {
            Some(total) => total,
            None => self.number(0.0),
        }
    }

    /// Adds terms of one stage to a value.
    fn add_terms(&mut self, total: Option<Value>, terms: &[Expression]) -> Value {
        let mut list: Vec<Summand> = terms.iter().map(|term| self.summand(*term)).collect();
        // What takes longest is added last: the processor does not wait for it before it adds the others.
        list.sort_by_key(|one| self.depth_of(one));
        if total.is_none() {
            // A total to begin with: what is no product and has no minus first.
            let first = (0..list.len()).min_by_key(|index| {
                let one = &list[*index];
                (one.negative, one.second.is_some(), *index)
            });
            list[..=first.unwrap_or(0)].rotate_right(1);
        }
        let mut rest = list.into_iter();
        let mut sum = match total {
            Some(total) => total,
            None => match rest.next() {
                None => return self.number(0.0),
                Some(first) => self.first(first, &mut rest),
            },
        };
        for one in rest {
            sum = match (one.negative, one.second) {
                (false, None) => self.combine(OperationKind::Add(sum, one.first)),
                (true, None) => self.combine(OperationKind::Subtract(sum, one.first)),
                (false, Some(second)) => {
                    self.combine(OperationKind::MultiplyAdd(one.first, second, sum))
                }
                (true, Some(second)) => {
                    self.combine(OperationKind::NegateMultiplyAdd(one.first, second, sum))
                }
            };
        }
        sum
    }

    /// The first of a sum's terms, if need be together with the second.
    fn first(&mut self, first: Summand, rest: &mut std::vec::IntoIter<Summand>) -> Value {
        match (first.negative, first.second) {
            (false, None) => first.first,
            (false, Some(second)) => {
                // `a*b - c` is one operation.
                let follows = rest
                    .as_slice()
                    .first()
                    .filter(|next| next.negative && next.second.is_none())
                    .map(|next| next.first);
                match follows {
                    Some(next) => {
                        rest.next();
                        self.combine(OperationKind::MultiplySubtract(first.first, second, next))
                    }
                    None => self.multiply(first.first, second),
                }
            }
            (true, _) => {
                // All terms have a minus: the sum of the others has it once.
                let turned: Vec<Summand> = rest.by_ref().collect();
                let mut sum = self.plain(&first);
                for one in turned {
                    sum = match one.second {
                        None => self.combine(OperationKind::Add(sum, one.first)),
                        Some(second) => {
                            self.combine(OperationKind::MultiplyAdd(one.first, second, sum))
                        }
                    };
                }
                self.combine(OperationKind::Negate(sum))
            }
        }
    }

    /// How long a term of a sum takes.
    fn depth_of(&self, summand: &Summand) -> u32 {
        let depth = |value: Value| self.depths[value.0 as usize];
        match summand.second {
            Some(second) => 1 + depth(summand.first).max(depth(second)),
            None => depth(summand.first),
        }
    }

    fn plain(&mut self, summand: &Summand) -> Value {
        match summand.second {
            Some(second) => self.multiply(summand.first, second),
            None => summand.first,
        }
    }

    /// A term as it is added: a product that is used nowhere else stays two values.
    fn summand(&mut self, term: Expression) -> Summand {
        let (coefficient, _) = self.graph.split_coefficient(term);
        let alone = self.uses.get(&term) == Some(&1) && self.graph.name_of(term).is_none();
        let negative = coefficient < 0.0;
        let positive = if negative { self.graph.neg(term) } else { term };
        match self.graph.node(positive).clone() {
            Node::Product(factors) if alone && !self.done.contains_key(&positive) => {
                let (first, second) = self.product_parts(&factors);
                let named = second.is_none() && self.graph.name_of(positive).is_some();
                let first = if named { self.value(positive) } else { first };
                Summand { negative, first, second }
            }
            _ => {
                // The number of a shared term keeps its sign, or `x` and `-x` would be computed twice.
                if negative && coefficient != -1.0 && self.uses.get(&term).copied().unwrap_or(0) > 1
                {
                    return Summand { negative: false, first: self.value(term), second: None };
                }
                Summand { negative, first: self.value(positive), second: None }
            }
        }
    }
}

/// A term of a sum: one value, or two to be multiplied.
struct Summand {
    negative: bool,
    first: Value,
    second: Option<Value>,
}
