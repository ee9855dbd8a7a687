//! Which words of the file jump or bend.
//!
//! Equal expressions are one, so a function may be written in several places. Of these the one is meant that stands in
//! the term that is differentiated, or in what its names stand for.

use std::collections::BTreeMap;

use super::{Lowering, Typed};
use crate::diagnostic::Diagnostics;
use crate::expression::{Expression, Graph, Node, Set, Symbol};
use crate::program::Function;
use crate::resolve::Role;
use crate::syntax::print;
use crate::syntax::tree::{BinaryOperator, Name, Term, TermKind};
use crate::token::Span;
use crate::unroll::whole_number;

/// Functions that jump or bend, as they are written.
#[derive(Default)]
pub(super) struct Written {
    /// The terms that came to each, the latest last.
    terms: BTreeMap<Expression, Vec<Term>>,
    /// The bends whose slope each is.
    bends: BTreeMap<Expression, Vec<Expression>>,
}

impl Written {
    /// Takes up that a term came to a function that jumps or bends.
    pub fn insert(&mut self, value: Expression, term: &Term) {
        let terms = self.terms.entry(value).or_default();
        terms.retain(|other| other.span != term.span);
        terms.push(term.clone());
    }

    /// Whether a branch is written as one, or is the slope of a bend.
    pub fn is_step(&self, value: Expression) -> bool {
        self.terms.contains_key(&value) || self.bends.contains_key(&value)
    }

    /// Knows all that contains an argument also with its value.
    pub fn substitute(
        &mut self,
        graph: &mut Graph,
        argument: Symbol,
        put: &dyn Fn(&mut Graph, Expression) -> Expression,
    ) {
        // What contains the argument was built after it.
        let first = graph.symbol(argument);
        let free =
            |graph: &Graph, one: Expression| graph.depends_on(one, |other| other == argument);
        let terms = self.terms.range(first..);
        let terms: Vec<_> = terms
            .filter(|(one, _)| free(graph, **one))
            .map(|(one, terms)| (*one, terms.clone()))
            .collect();
        let bends = self.bends.range(first..);
        let bends: Vec<_> = bends
            .filter(|(slope, _)| free(graph, **slope))
            .map(|(slope, bends)| (*slope, bends.clone()))
            .collect();
        let mut with_value = |one: Expression| {
            let value = put(graph, one);
            graph.split_coefficient(value).1
        };
        for (one, terms) in terms {
            let one = with_value(one);
            terms.iter().for_each(|term| self.insert(one, term));
        }
        for (slope, bends) in bends {
            let slope = with_value(slope);
            for bend in bends {
                self.bends_to(with_value(bend), slope);
            }
        }
    }

    /// Takes up the slope of a bend.
    pub fn bends_to(&mut self, bend: Expression, slope: Expression) {
        let bends = self.bends.entry(slope).or_default();
        if !bends.contains(&bend) {
            bends.push(bend);
        }
    }
}

/// The difference of two terms as text; what is compared with zero stands alone.
fn difference(a: &Term, b: &Term) -> String {
    let is_zero = |term: &Term| matches!(term.kind, TermKind::Number { value: 0.0, .. });
    match (is_zero(a), is_zero(b)) {
        (_, true) => print::term(a),
        (true, _) => print::term(b),
        _ => print::term(&Term {
            span: a.span,
            kind: TermKind::Binary(
                BinaryOperator::Subtract,
                Box::new(a.clone()),
                Box::new(b.clone()),
            ),
        }),
    }
}

impl Lowering<'_> {
    /// Takes up what a term came to, if that jumps or bends, and says what passes zero there.
    pub(super) fn take_up(&mut self, term: &Term, typed: &Typed) {
        if let (Typed::Condition(value), TermKind::Binary(..)) = (typed, &term.kind) {
            self.name_switch(*value, term);
        }
        let function = match &term.kind {
            TermKind::Call { name, .. } => match name.text.as_str() {
                "sign" => Some(Function::Sign),
                "floor" => Some(Function::Floor),
                "max" => Some(Function::Max),
                "min" => Some(Function::Min),
                "abs" | "sqrt" | "norm" => Some(Function::Abs),
                _ => return,
            },
            TermKind::Binary(BinaryOperator::Power, ..) => Some(Function::Abs),
            TermKind::If { .. } => None,
            _ => return,
        };
        for value in typed.values() {
            let mut inner = vec![self.graph.split_coefficient(*value).1];
            while let Some(one) = inner.pop() {
                match self.graph.node(one) {
                    Node::Select(..) if function.is_none() => self.written.insert(one, term),
                    Node::Call(found, arguments) if Some(*found) == function => {
                        // The largest of three is the larger of one and the larger of two.
                        if arguments.len() == 2 {
                            inner.push(arguments[0]);
                        }
                        self.written.insert(one, term);
                        self.name_switch(one, term);
                    }
                    _ => {}
                }
            }
        }
    }

    /// Says what passes zero where a comparison or a function goes over to its other side: in the words of the file, or
    /// in a function of the file, whose words are arguments, as it is with their values.
    fn name_switch(&mut self, branch: Expression, term: &Term) {
        let in_function = self.locals.last().is_some_and(|scope| !scope.is_empty());
        let words = match &term.kind {
            _ if in_function => None,
            TermKind::Call { name, arguments } => {
                match (name.text.as_str(), arguments.as_slice()) {
                    ("abs" | "sign", [argument]) => Some(print::term(argument)),
                    ("max" | "min", [a, b]) => Some(difference(a, b)),
                    _ => None,
                }
            }
            TermKind::Binary(
                BinaryOperator::Less
                | BinaryOperator::LessEqual
                | BinaryOperator::Greater
                | BinaryOperator::GreaterEqual,
                a,
                b,
            ) => Some(difference(a, b)),
            _ => None,
        };
        let (words, graph) = (words, &mut self.graph);
        let words = words.or_else(|| {
            let guard = match graph.node(branch).clone() {
                Node::Call(Function::Max | Function::Min, arguments) => {
                    graph.sub(arguments[0], arguments[1])
                }
                Node::Call(_, arguments) => arguments[0],
                Node::Compare(_, a, b) => graph.sub(b, a),
                _ => return None,
            };
            Some(graph.display(guard))
        });
        if let Some(words) = words {
            self.graph.name_switch(branch, words);
        }
    }

    /// The term that came to a jump, of those in a differentiated term if there is one, and whether it bends and is
    /// differentiated for the second time.
    pub fn meant(&self, jump: Expression, differentiated: &Term) -> Option<(Term, bool)> {
        let written = |value: &Expression| self.written.terms.get(value).into_iter().flatten();
        let bends = self.written.bends.get(&jump).into_iter().flatten();
        let known: Vec<(&Term, bool)> = bends
            .flat_map(written)
            .map(|term| (term, true))
            .chain(written(&jump).map(|term| (term, false)))
            .collect();
        let places = known.iter().map(|(term, _)| term.span).collect();
        let inside = self.first_inside(differentiated, &places);
        let meant = known.iter().find(|(term, _)| Some(term.span) == inside);
        let (term, bends) = meant.or(known.last())?;
        Some(((*term).clone(), *bends))
    }

    /// The first of some places in a term and in whatever its names stand for.
    fn first_inside(&self, term: &Term, places: &Set<Span>) -> Option<Span> {
        let arguments: Vec<&str> = self
            .locals
            .last()
            .into_iter()
            .flat_map(|scope| scope.keys().map(String::as_str))
            .collect();
        let mut seen = Set::default();
        let mut stack = vec![(term, arguments)];
        while let Some((term, arguments)) = stack.pop() {
            if places.contains(&term.span) {
                return Some(term.span);
            }
            let full = match &term.kind {
                TermKind::Name(name) if !arguments.contains(&name.as_str()) => name.clone(),
                TermKind::Call { name, .. } => name.text.clone(),
                TermKind::Index { name, index } => {
                    let number = whole_number(index, &mut Diagnostics::default());
                    number.map_or_else(String::new, |number| format!("{}[{number}]", name.text))
                }
                _ => String::new(),
            };
            if let Some((meaning, own)) = self.meaning(&full)
                && seen.insert(full)
            {
                stack.push((meaning, own.iter().map(|one| one.text.as_str()).collect()));
            }
            let parts = term.parts().into_iter().rev();
            stack.extend(parts.map(|part| (part, arguments.clone())));
        }
        None
    }

    /// The term that a name stands for, with its arguments.
    fn meaning(&self, name: &str) -> Option<(&Term, &[Name])> {
        match &self.names.table.get(name)?.role {
            Role::Let(value) => Some((value, &[])),
            Role::Function(arguments, body) => Some((body, arguments)),
            Role::Driver(index) => {
                let position = &self.names.drivers[*index as usize].what.motion;
                position.as_ref().map(|term| (term, [].as_slice()))
            }
            _ => None,
        }
    }
}
