//! Derivatives that a file asks for: `dot(x)`, `ddot(x)` in time and `diff(f, x)`.

use std::collections::HashMap;

use super::breaks::Wanted;
use super::{Kind, Lowering, Typed, second};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::over;
use crate::syntax::tree::{Name, Term, TermKind};
use crate::token::Span;

impl Lowering<'_> {
    pub(super) fn derivative(&mut self, name: &Name, arguments: &[Term], span: Span) -> Typed {
        let expected = if name.text == "diff" { 2 } else { 1 };
        if arguments.len() != expected {
            let message = format!(
                "`{}` takes {expected} argument(s), and this gives it {}",
                name.text,
                arguments.len()
            );
            return self.error(Diagnostic::error(span, message));
        }
        match name.text.as_str() {
            "diff" => self.partial(&arguments[0], &arguments[1], span),
            "dot" => self.dot(&arguments[0], span),
            _ => {
                let once = self.dot(&arguments[0], span);
                self.dot_of(once, &arguments[0], span)
            }
        }
    }

    fn dot(&mut self, term: &Term, span: Span) -> Typed {
        let typed = self.term(term);
        self.dot_of(typed, term, span)
    }

    /// The time derivative of a value, which a term came to.
    fn dot_of(&mut self, typed: Typed, term: &Term, span: Span) -> Typed {
        let (values, kind, scalar) = match typed {
            Typed::Scalar { value, kind, .. } => (vec![value], kind, true),
            Typed::Vector { values, kind, .. } => (values, kind, false),
            Typed::Wrong => return Typed::Wrong,
            other => {
                return self.error(Diagnostic::error(
                    span,
                    format!("{} has no time derivative", other.describe()),
                ));
            }
        };
        let Some(kind) = over(kind, Kind::Of(second())) else {
            return Typed::Wrong;
        };
        let positions = |symbol: Symbol| {
            matches!(
                symbol,
                Symbol::Speed(_) | Symbol::State(_) | Symbol::Acceleration(_)
            )
        };
        let rate = !values
            .iter()
            .any(|value| self.graph.depends_on(*value, positions));
        if values.iter().any(|value| {
            self.graph
                .depends_on(*value, |symbol| matches!(symbol, Symbol::Acceleration(_)))
        }) {
            return self.error(
                Diagnostic::error(span, "this is a derivative of an acceleration, which no equation determines")
                    .hint("at most the second derivative of a coordinate and the first of a state can be used"),
            );
        }
        let Some(direction) = self.direction() else {
            return Typed::Wrong;
        };
        let moves = |symbol| direction.contains_key(&symbol);
        if !self.is_differentiable(&values, &moves, &Wanted::explicitly(term, span)) {
            return Typed::Wrong;
        }
        let values = self.graph.tangent(&values, &direction);
        match (scalar, values.as_slice()) {
            (true, [value]) => Typed::Scalar {
                value: *value,
                kind,
                rate,
            },
            _ => Typed::Vector { values, kind, rate },
        }
    }

    /// How everything given moves with time: `dq/dt = u`, `du/dt = a`. None when the motion of a driver is wrong.
    pub fn direction(&mut self) -> Option<HashMap<Symbol, Expression>> {
        let coordinates = self.names.coordinates.len() as u32;
        let mut direction = HashMap::new();
        direction.insert(Symbol::Time, self.graph.one());
        for index in 0..coordinates {
            direction.insert(
                Symbol::Coordinate(index),
                self.graph.symbol(Symbol::Speed(index)),
            );
            direction.insert(
                Symbol::Speed(index),
                self.graph.symbol(Symbol::Acceleration(index)),
            );
        }
        for index in 0..self.names.states.len() as u32 {
            direction.insert(
                Symbol::State(index),
                self.graph.symbol(Symbol::Acceleration(coordinates + index)),
            );
        }
        for index in 0..self.names.drivers.len() {
            match self.driver_motions[index] {
                Some((_, rate)) => {
                    direction.insert(Symbol::Driver(index as u32), rate);
                }
                // While positions are read, no other driver can occur in them; afterwards this one is a mistake, which
                // has been reported.
                None if !self.drivers_read => {}
                None => return None,
            }
        }
        Some(direction)
    }

    /// `diff(f, x)`: the partial derivative with everything else fixed.
    fn partial(&mut self, function: &Term, variable: &Term, span: Span) -> Typed {
        if let TermKind::Name(name) = &variable.kind
            && let Some(Typed::Scalar { value, kind, .. }) = self
                .locals
                .last()
                .and_then(|scope| scope.get(name))
                .cloned()
        {
            return self.partial_in_argument(function, name, (value, kind), span);
        }
        let Some((value, kind)) = self.scalar(variable) else {
            return Typed::Wrong;
        };
        let given = match self.graph.node(value) {
            crate::expression::Node::Symbol(symbol) => *symbol,
            _ => {
                return self.error(
                    Diagnostic::error(variable.span, "`diff` needs something given as its variable, and this is computed")
                        .hint("a coordinate, a driver, the time, a parameter, `dot` of a coordinate, or an argument of the function it stands in"),
                );
            }
        };
        let typed = self.term(function);
        // What is constant passes through no jump.
        let moves = |symbol| symbol == given && !matches!(given, Symbol::Parameter(_));
        let wanted = Wanted::explicitly(function, span);
        if !self.is_differentiable(typed.values(), &moves, &wanted) {
            return Typed::Wrong;
        }
        self.quotient(typed, given, kind, function.span)
    }

    /// The variable is an argument of the function around: it is varied by itself, then replaced by its value.
    fn partial_in_argument(
        &mut self,
        function: &Term,
        name: &str,
        (value, kind): (Expression, Kind),
        span: Span,
    ) -> Typed {
        let symbol = Symbol::Argument(self.arguments);
        self.arguments += 1;
        let free = Typed::scalar(self.graph.symbol(symbol), kind);
        let mut scope = self.locals.last().cloned().unwrap_or_default();
        scope.insert(name.to_string(), free);
        self.locals.push(scope);
        let typed = self.term(function);
        self.locals.pop();
        let is_fixed = self.is_fixed(value);
        let moves = |other| other == symbol && !is_fixed;
        let wanted = Wanted::explicitly(function, span);
        if !self.is_differentiable(typed.values(), &moves, &wanted) {
            return Typed::Wrong;
        }
        let varied = self.quotient(typed, symbol, kind, function.span);
        let map = HashMap::from([(symbol, value)]);
        self.written.substitute(&mut self.graph, symbol, value);
        match varied {
            Typed::Scalar { value, kind, .. } => {
                Typed::scalar(self.graph.substitute(&[value], &map)[0], kind)
            }
            Typed::Vector { values, kind, .. } => Typed::Vector {
                values: self.graph.substitute(&values, &map),
                kind,
                rate: false,
            },
            other => other,
        }
    }

    fn quotient(&mut self, typed: Typed, given: Symbol, kind: Kind, span: Span) -> Typed {
        let direction = HashMap::from([(given, self.graph.one())]);
        match typed {
            Typed::Scalar {
                value, kind: own, ..
            } => match over(own, kind) {
                Some(kind) => Typed::scalar(self.graph.tangent(&[value], &direction)[0], kind),
                None => Typed::Wrong,
            },
            Typed::Vector {
                values, kind: own, ..
            } => match over(own, kind) {
                Some(kind) => Typed::Vector {
                    values: self.graph.tangent(&values, &direction),
                    kind,
                    rate: false,
                },
                None => Typed::Wrong,
            },
            Typed::Wrong => Typed::Wrong,
            other => self.error(Diagnostic::error(
                span,
                format!("{} has no derivative", other.describe()),
            )),
        }
    }
}
