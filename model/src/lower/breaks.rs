//! Derivatives that do not exist: of what jumps, such as `sign`, and second ones of what bends, such as `abs`.
//!
//! The expressions say whether there is one; [`super::written`] which words of the file to point at.

use super::Lowering;
use crate::diagnostic::Diagnostic;
use crate::expression::{Breaks, Course, Expression, Symbol};
use crate::syntax::print;
use crate::syntax::tree::{BinaryOperator, EnergyKind, Term, TermKind};
use crate::token::Span;

/// A derivative that the file asks for, or that follows from it.
pub(super) struct Wanted<'a> {
    /// What is differentiated.
    pub term: &'a Term,
    /// What asks for the derivative.
    pub place: Span,
    /// A few words on that.
    pub words: &'a str,
    /// What to do instead.
    pub instead: &'a str,
}

impl<'a> Wanted<'a> {
    /// By `dot`, `ddot` or `diff`.
    pub fn explicitly(term: &'a Term, place: Span) -> Self {
        Self {
            term,
            place,
            words: "differentiated here",
            instead: "or put the whole into the branches of an `if`, which has the derivative of the branch that holds",
        }
    }
}

impl Lowering<'_> {
    /// Whether some values have a derivative where these move. Reports each function that prevents it.
    pub(super) fn is_differentiable(
        &mut self,
        values: &[Expression],
        moves: &dyn Fn(Symbol) -> bool,
        wanted: &Wanted<'_>,
    ) -> bool {
        let found = self.breaks(values, moves);
        for jump in &found.jumps {
            self.report_jump(*jump, wanted);
        }
        for bend in found.bends {
            for slope in self.graph.slopes_of_bend(bend) {
                self.written.bends_to(bend, slope);
            }
        }
        found.jumps.is_empty()
    }

    fn breaks(&mut self, values: &[Expression], moves: &dyn Fn(Symbol) -> bool) -> Breaks {
        let (motions, written, followed) = (&self.driver_motions, &self.written, &self.followed);
        let behind = |symbol| match symbol {
            Symbol::Driver(index) => motions[index as usize].map(|(position, _)| position),
            Symbol::DriverRate(_) => followed.get(&symbol).copied(),
            _ => None,
        };
        let course = Course { moves, behind: &behind, is_step: &|one| written.is_step(one) };
        self.graph.breaks(values, &course)
    }

    /// Whether Lagrange's equations of an energy exist.
    pub fn has_forces(
        &mut self,
        kind: EnergyKind,
        energy: Expression,
        term: &Term,
        place: Span,
    ) -> bool {
        let wanted = Wanted {
            term,
            place,
            words: "the forces are derivatives of this energy",
            instead: "or state the forces themselves by `force` or `motion`: they may jump",
        };
        let position = |symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Dependent(_));
        let speed = |symbol| matches!(symbol, Symbol::Speed(_) | Symbol::DependentRate(_));
        match kind {
            EnergyKind::Potential => self.is_differentiable(&[energy], &position, &wanted),
            EnergyKind::Dissipation => self.is_differentiable(&[energy], &speed, &wanted),
            EnergyKind::Kinetic => {
                let Some(direction) = self.direction() else {
                    return true;
                };
                let all = |symbol| direction.contains_key(&symbol);
                let found = self.breaks(&[energy], &all);
                if found.jumps.is_empty() && found.bends.is_empty() {
                    return true;
                }
                let either = |symbol| position(symbol) || speed(symbol);
                if !self.is_differentiable(&[energy], &either, &wanted) {
                    return false;
                }
                // The momenta are differentiated once more.
                let symbols = self.graph.symbols(&[energy]).into_iter();
                let speeds: Vec<_> = symbols.filter(|one| speed(*one)).collect();
                let one = self.graph.one();
                let momenta = self.graph.gradient(&[(energy, one)], &speeds);
                self.is_differentiable(&momenta, &all, &wanted)
            }
        }
    }

    /// Whether a force can act on a position.
    pub fn has_directions(&mut self, position: &[Expression], term: &Term, place: Span) -> bool {
        let wanted = Wanted {
            words: "a force acts along the derivatives of its position",
            ..Wanted::explicitly(term, place)
        };
        let moves = |symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Dependent(_));
        self.is_differentiable(position, &moves, &wanted)
    }

    fn report_jump(&mut self, jump: Expression, wanted: &Wanted<'_>) {
        let (span, message, smooth) = match self.meant(jump, wanted.term) {
            Some((term, bends)) => {
                let (message, smooth) = describe(&term, bends);
                (term.span, message, smooth)
            }
            None => {
                let message = format!("`{}` has no derivative: it jumps", self.graph.display(jump));
                (wanted.place, message, "smooth it".into())
            }
        };
        let mut report =
            Diagnostic::error(span, message).hint(format!("{smooth}, {}", wanted.instead));
        if wanted.place != span {
            report = report.related(wanted.place, wanted.words);
        }
        self.diagnostics.push_once("no derivative".into(), report);
    }
}

/// What is wrong with differentiating a term that jumps or, once more, one that bends; and how to smooth it.
fn describe(term: &Term, bends: bool) -> (String, String) {
    let text = print::term(term);
    let no = if bends {
        format!("`{text}` has no second derivative: the first one jumps")
    } else {
        format!("`{text}` has no derivative: it jumps")
    };
    let (name, arguments) = match &term.kind {
        TermKind::Call { name, arguments } => (name.text.as_str(), arguments.as_slice()),
        TermKind::If { condition, .. } => {
            let message = format!(
                "this `if` has no derivative: it jumps where `{}` begins or ceases to hold",
                print::term(condition)
            );
            return (message, "let its branches meet there".into());
        }
        _ => ("", [].as_slice()),
    };
    let argument = |index: usize| arguments.get(index).map(print::term).unwrap_or_default();
    let first = argument(0);
    let two = TermKind::Number { value: 2.0, unit: None };
    match name {
        "sign" => (
            format!("{no} where `{first}` passes zero"),
            format!(
                "smooth it, as in `tanh({})` with a small `eps`",
                joined(&arguments[0], BinaryOperator::Divide, TermKind::Name("eps".into()))
            ),
        ),
        "floor" => (
            format!("{no} where `{first}` passes a whole number"),
            "leave it out, as its derivative between the jumps is zero".into(),
        ),
        "mod" => (
            format!("{no} where `{first}` passes a multiple of `{}`", argument(1)),
            format!("take `{first}` instead, as it has the same derivative between the jumps"),
        ),
        "max" | "min" => (
            format!(
                "{no} where another argument becomes the {}",
                if name == "max" { "largest" } else { "smallest" }
            ),
            format!(
                "smooth it, as in `(a + b {} sqrt((a - b)^2 + eps^2))/2` with a small `eps`",
                if name == "max" { '+' } else { '-' }
            ),
        ),
        "abs" => (
            format!("{no} where `{first}` passes zero"),
            format!(
                "smooth it, as in `sqrt({} + eps^2)` with a small `eps`",
                joined(&arguments[0], BinaryOperator::Power, two)
            ),
        ),
        _ => (
            format!("{no} where it is zero"),
            "smooth it, as in `sqrt(x^2 + eps^2)` with a small `eps`".into(),
        ),
    }
}

/// A term with an operator and another one, as text.
fn joined(left: &Term, operator: BinaryOperator, right: TermKind) -> String {
    let span = left.span;
    let right = Term { span, kind: right };
    let kind = TermKind::Binary(operator, Box::new(left.clone()), Box::new(right));
    print::term(&Term { span, kind })
}
