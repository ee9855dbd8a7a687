//! One walk through the terms and declared names of a statement, for whoever changes them.

use super::{
    Among, Expect, ExpectAt, Name, Output, Scene, SceneItem, Selection, StatementKind, Target,
    Term, TermKind, Tolerance, Unknown, Varied, When,
};

/// What is done to the parts of a statement.
pub trait Visitor {
    /// Changes a term with all that stands in it.
    fn term(&mut self, term: &mut Term);

    /// Changes a name that is declared, perhaps with an index.
    fn target(&mut self, target: &mut Target);

    /// Changes the name of an effect, a choice, a mode or a part.
    fn name(&mut self, _: &mut Name) {}

    /// Changes the body of an abbreviation, in which its arguments hide other names.
    fn body(&mut self, arguments: &[Name], body: &mut Term);

    /// Changes what a scene selects.
    fn selection(&mut self, _: &mut Selection) {}
}

type Limits<'a> = (&'a mut Option<Tolerance>, &'a mut Option<(Term, Term)>);

impl StatementKind {
    /// Shows everything in it to a visitor but the statements of its blocks, see [`Self::blocks_mut`].
    pub fn visit(&mut self, visitor: &mut dyn Visitor) {
        match self {
            Self::Constant(constant) => {
                visitor.target(&mut constant.target);
                some(&mut constant.value, visitor);
                limits((&mut constant.tolerance, &mut constant.range), visitor);
            }
            Self::Preset { values, .. } => values.iter_mut().for_each(|(target, value)| {
                visitor.target(target);
                visitor.term(value);
            }),
            Self::Let { target, arguments, value } => {
                visitor.target(target);
                visitor.body(arguments.as_deref().unwrap_or_default(), value);
            }
            Self::Driver(driver) => {
                visitor.target(&mut driver.target);
                some(&mut driver.motion, visitor);
                some(&mut driver.start, visitor);
                limits((&mut driver.tolerance, &mut driver.range), visitor);
            }
            Self::Dependent(dependent) => {
                visitor.target(&mut dependent.target);
                some(&mut dependent.start, visitor);
            }
            Self::Closure { label, left, right } | Self::Motion { label, left, right } => {
                label.iter_mut().for_each(|label| visitor.target(label));
                pair((left, right), visitor);
            }
            Self::Point { target, value } => {
                visitor.target(target);
                visitor.term(value);
            }
            Self::Link { points, .. } => points.iter_mut().for_each(|one| visitor.term(one)),
            Self::Part { name, bindings, .. } => {
                visitor.name(name);
                for binding in bindings {
                    some(&mut binding.value, visitor);
                    some(&mut binding.start, visitor);
                    limits((&mut binding.tolerance, &mut binding.range), visitor);
                }
            }
            Self::Coordinate(Unknown { target, start, start_rate, .. })
            | Self::State(Unknown { target, start, start_rate, .. }) => {
                visitor.target(target);
                some(start, visitor);
                some(start_rate, visitor);
            }
            Self::Force { value, on } => pair((value, on), visitor),
            Self::Energy { value: term, .. }
            | Self::Mark { value: term, .. }
            | Self::Hold { target: term }
            | Self::Require { condition: term, .. }
            | Self::If { condition: term, .. } => visitor.term(term),
            Self::Effect { name, .. } | Self::Choice { name, .. } | Self::Mode { name, .. } => {
                visitor.name(name);
            }
            Self::When(event) => event.visit(visitor),
            Self::For { from, to, .. } => pair((from, to), visitor),
            Self::Scene(scene) => scene.visit(visitor),
            Self::Output(output) | Self::Measure { what: output, .. } => output.visit(visitor),
            Self::Expect(expect) => expect.visit(visitor),
        }
    }
}

impl When {
    fn visit(&mut self, visitor: &mut dyn Visitor) {
        let labels = self.label.iter_mut();
        labels.for_each(|label| visitor.target(label));
        visitor.term(&mut self.guard);
        some(&mut self.condition, visitor);
        self.target.iter_mut().for_each(|one| visitor.name(one));
        pairs(&mut self.resets, visitor);
    }
}

impl Scene {
    fn visit(&mut self, visitor: &mut dyn Visitor) {
        let selections = self.selection.iter_mut();
        selections.for_each(|one| visitor.selection(one));
        for item in &mut self.items {
            match item {
                SceneItem::Periodic { period } => some(period, visitor),
                SceneItem::Run { from, to, .. } => pair((from, to), visitor),
                SceneItem::Sweep { drivers } => {
                    let ranges = drivers.iter_mut().filter_map(|one| one.range.as_mut());
                    ranges.for_each(|(from, to)| pair((from, to), visitor));
                }
                SceneItem::Preset { .. } | SceneItem::Rest { .. } | SceneItem::Hold { .. } => {}
                SceneItem::StartIn { mode } => visitor.name(mode),
                SceneItem::Output(output) => output.visit(visitor),
                SceneItem::Start { values } => pairs(values, visitor),
                SceneItem::Vary { constants } => varied(constants, visitor),
                SceneItem::Solve { constants, left, right } => {
                    varied(constants, visitor);
                    pair((left, right), visitor);
                }
                SceneItem::Require { condition, .. } => visitor.term(condition),
                SceneItem::Prefer { condition, weight, .. } => {
                    visitor.term(condition);
                    some(weight, visitor);
                }
                SceneItem::Minimise { what } => what.visit(visitor),
            }
        }
    }
}

fn varied(constants: &mut [Varied], visitor: &mut dyn Visitor) {
    for one in constants {
        visitor.target(&mut one.constant);
        match &mut one.among {
            Among::Permitted => {}
            Among::Range(from, to) => pair((from, to), visitor),
            Among::Values(values) => values.iter_mut().for_each(|value| visitor.term(value)),
        }
    }
}

impl Output {
    fn visit(&mut self, visitor: &mut dyn Visitor) {
        self.name.iter_mut().for_each(|name| visitor.target(name));
        some(&mut self.value, visitor);
    }
}

impl Expect {
    fn visit(&mut self, visitor: &mut dyn Visitor) {
        if let ExpectAt::Value { places } = &mut self.at {
            places.iter_mut().for_each(|(_, value)| visitor.term(value));
        }
        visitor.term(&mut self.quantity);
        pair((&mut self.value, &mut self.tolerance), visitor);
    }
}

fn some(term: &mut Option<Term>, visitor: &mut dyn Visitor) {
    term.iter_mut().for_each(|term| visitor.term(term));
}

fn pair((left, right): (&mut Term, &mut Term), visitor: &mut dyn Visitor) {
    visitor.term(left);
    visitor.term(right);
}

fn pairs(list: &mut [(Term, Term)], visitor: &mut dyn Visitor) {
    let all = list.iter_mut();
    all.for_each(|(left, right)| pair((left, right), visitor));
}

fn limits((tolerance, range): Limits<'_>, visitor: &mut dyn Visitor) {
    let half_width = tolerance.iter_mut().map(|one| &mut one.half_width);
    half_width.for_each(|term| visitor.term(term));
    let range = range.iter_mut();
    range.for_each(|(low, high)| pair((low, high), visitor));
}

impl Term {
    /// The terms that stand directly in it, that in whose place another one is bound included.
    pub fn parts_mut(&mut self) -> Vec<&mut Term> {
        match &mut self.kind {
            TermKind::Number { .. } | TermKind::Name(_) => Vec::new(),
            TermKind::Index { index: inner, .. }
            | TermKind::Member { base: inner, .. }
            | TermKind::Unary(_, inner) => vec![inner],
            TermKind::Binary(_, left, right)
            | TermKind::Bound { value: left, instead: right, .. } => vec![left, right],
            TermKind::Vector(items) | TermKind::Call { arguments: items, .. } => {
                items.iter_mut().collect()
            }
            TermKind::If { condition: a, then: b, otherwise: c }
            | TermKind::Sum { from: a, to: b, body: c, .. }
            | TermKind::Search { from: a, to: b, body: c, .. } => vec![a, b, c],
            TermKind::Table(table) => table.parts_mut(),
        }
    }
}
