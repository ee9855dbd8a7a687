//! What an event may watch: a quantity that moves, and that passes zero without a jump.

use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Node, Symbol};
use crate::lower::{Lowering, is_of_motion};
use crate::program::{self, Function};
use crate::syntax::print;
use crate::syntax::tree::{BinaryOperator, Direction, Term, TermKind};

/// The time derivative of what an event watches; a quantity that passes zero nowhere is reported.
pub fn rate(
    low: &mut Lowering<'_>,
    guard: Expression,
    term: &Term,
    direction: Direction,
) -> Option<Expression> {
    let has = |low: &Lowering<'_>, wanted: fn(Symbol) -> bool| low.graph.depends_on(guard, wanted);
    if !has(low, |symbol| !matches!(symbol, Symbol::Parameter(_))) {
        let report = Diagnostic::error(term.span, "this never changes, so it passes zero nowhere");
        low.diagnostics.push(
            report.hint("watch something that moves; what holds for all time is a `require`"),
        );
        return None;
    }
    if let Some(inner) = touched(low, guard) {
        let message = format!(
            "`{}` has the same sign on both sides of its zeros: it touches zero and does not pass it",
            print::term(term)
        );
        let watched = written(low, guard, term).unwrap_or_else(|| low.graph.display(inner));
        low.diagnostics.push(
            Diagnostic::error(term.span, message)
                .hint(format!("watch what changes its sign: `when {watched} crosses`")),
        );
        return None;
    }
    let rates = low.direction()?;
    // Of a force and an acceleration it is known only in the motion as it is.
    let moving = match has(low, is_highest) {
        true => program::bind(&mut low.graph, &[guard], &low.bound)[0],
        false => guard,
    };
    let rate = low.graph.tangent(&[moving], &rates)[0];
    if low.graph.as_number(rate) == Some(0.0) || is_remainder(term) {
        let message = format!(
            "`{}` jumps, and an event is where a quantity passes zero without a jump",
            print::term(term)
        );
        let hint = steady(low, guard, term, direction);
        low.diagnostics.push(Diagnostic::error(term.span, message).hint(hint));
        return None;
    }
    Some(rate)
}

/// Whether a symbol stands for what the equations of motion determine.
fn is_highest(symbol: Symbol) -> bool {
    let highest = matches!(symbol, Symbol::Acceleration(_) | Symbol::DependentAcceleration(_));
    highest || is_of_motion(symbol)
}

/// What has to be zero where this is, if it is of one sign everywhere else: `x` of `abs(x)` and of `-c*x^2`.
fn touched(low: &Lowering<'_>, guard: Expression) -> Option<Expression> {
    let graph = &low.graph;
    match graph.node(guard) {
        Node::Product(factors) => {
            let mut moving = factors.iter().filter(|factor| !low.is_constant(**factor));
            match (moving.next(), moving.next()) {
                (Some(factor), None) => touched(low, *factor),
                _ => None,
            }
        }
        Node::Call(Function::Abs, arguments) => Some(arguments[0]),
        Node::Power(base, exponent) => {
            let number = graph.as_number(*exponent)?;
            (number > 0.0 && number % 2.0 == 0.0).then_some(*base)
        }
        _ => None,
    }
}

/// Whether a term is `mod(x, y)`, which falls back to zero by a jump.
fn is_remainder(term: &Term) -> bool {
    matches!(&term.kind, TermKind::Call { name, .. } if name.text == "mod")
}

/// What to watch instead of something that jumps.
fn steady(low: &mut Lowering<'_>, guard: Expression, term: &Term, direction: Direction) -> String {
    let (coefficient, core) = low.graph.split_coefficient(guard);
    if let Node::Call(Function::Sign, arguments) = low.graph.node(core) {
        let word = print::direction(match coefficient < 0.0 {
            true => direction.turned(),
            false => direction,
        });
        let inner = written(low, core, term).unwrap_or_else(|| low.graph.display(arguments[0]));
        return format!("watch what the sign is taken of: `when {inner} {word}`");
    }
    let (name, arguments) = match &term.kind {
        TermKind::Call { name, arguments } => (name.text.as_str(), arguments.as_slice()),
        _ => ("", [].as_slice()),
    };
    match (name, arguments) {
        ("floor", [x]) => format!(
            "where `{}` passes a whole number, `sin(pi*{})` crosses zero",
            print::term(x),
            factor(x)
        ),
        ("mod", [x, y]) => format!(
            "where `{}` passes a multiple of `{}`, `sin(pi*{}/{})` crosses zero",
            print::term(x),
            print::term(y),
            factor(x),
            factor(y)
        ),
        _ => "watch the quantity that is zero where this jumps".into(),
    }
}

/// The argument of `sign` or `abs`, or the base of a power, as it is written.
fn written(low: &Lowering<'_>, function: Expression, term: &Term) -> Option<String> {
    let meant = low.meant(function, term).map(|(meant, _)| meant);
    match &meant.as_ref().unwrap_or(term).kind {
        TermKind::Call { name, arguments } => match (name.text.as_str(), arguments.as_slice()) {
            ("sign" | "abs", [argument]) => Some(print::term(argument)),
            _ => None,
        },
        TermKind::Binary(BinaryOperator::Power, base, _) => Some(print::term(base)),
        _ => None,
    }
}

/// A term as a factor.
fn factor(term: &Term) -> String {
    let text = print::term(term);
    match term.kind {
        TermKind::Name(_) | TermKind::Index { .. } | TermKind::Call { .. } => text,
        _ => format!("({text})"),
    }
}
