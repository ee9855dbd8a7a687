//! The loop equations as they are written.

use crate::checked::EquationInfo;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::agree;
use crate::lower::{Closure, Kind, Lowering, Moved, Typed};
use crate::motion::Equation;
use crate::syntax::print;
use crate::syntax::tree::{Statement, StatementKind, Term};
use crate::token::Span;
use crate::unit::{Dimension, Unit};
use crate::unroll::equation_name;

/// The loop equations of a scene.
#[derive(Default)]
pub struct Loops {
    /// Scalar equations, a vector's components one after the other.
    pub equations: Vec<Equation>,
    /// What must vanish, as it is written: with sines of sums.
    pub written: Vec<Expression>,
    /// Their kinds.
    pub kinds: Vec<Kind>,
    /// The closures as text.
    pub texts: Vec<EquationInfo>,
}

impl Loops {
    /// Reads all closures.
    pub fn read(statements: &[Statement], low: &mut Lowering<'_>) -> Self {
        let mut loops = Self::default();
        for statement in statements {
            if let StatementKind::Closure { label, left, right } = &statement.kind {
                let name = equation_name(label, (left, right), low.diagnostics);
                low.begin(Some(statement.span));
                loops.take(&name, left, right, statement, low);
            }
        }
        low.begin(None);
        loops.report_repeated(low);
        loops
    }

    fn take(
        &mut self,
        name: &str,
        left: &Term,
        right: &Term,
        statement: &Statement,
        low: &mut Lowering<'_>,
    ) {
        let Some((residuals, kind)) = low.balance(left, right) else {
            return;
        };
        // Positions keep cosine and sine of each coordinate, what moves in time those of each link.
        let expanded = match low.moved {
            Moved::InTime => residuals.clone(),
            Moved::Swept | Moved::Given => super::expand(&mut low.graph, &residuals),
        };
        let many = expanded.len() > 1;
        let first = self.equations.len();
        let both = expanded.into_iter().zip(residuals);
        for ((residual, written), component) in both.zip(["x", "y", "z"]) {
            if !self.is_usable(residual, left.span.to(right.span), low) {
                continue;
            }
            self.equations.push(Equation {
                residual,
                name: if many { format!("{name}.{component}") } else { name.to_string() },
                span: statement.span,
                lagrange: None,
            });
            self.written.push(written);
            self.kinds.push(kind);
        }
        let place = match low.aside(|low| low.term(left)) {
            Typed::Quantity(place) if agree(kind, Kind::Of(Dimension::base(0))).is_some() => {
                <[Expression; 2]>::try_from(place.values()).ok()
            }
            _ => None,
        };
        low.closures.push(Closure {
            name: name.to_string(),
            equations: first..self.equations.len(),
            kind,
            place,
        });
        self.texts.push(EquationInfo {
            text: print::statement(statement),
            unit: Unit::for_dimension(&kind.dimension()).symbol,
            span: statement.span,
        });
    }

    /// A loop is closed by dependent coordinates, at every position of the drivers.
    fn is_usable(&self, residual: Expression, span: Span, low: &mut Lowering<'_>) -> bool {
        let depends = |low: &Lowering<'_>, kind: &dyn Fn(Symbol) -> bool| {
            low.graph.depends_on(residual, kind)
        };
        let report = match () {
            () if depends(low, &|symbol| symbol == Symbol::Time) => {
                Diagnostic::error(span, "a closure cannot depend on the time by itself")
                    .hint("say with a `driver` what moves")
            }
            () if depends(low, &|symbol| matches!(symbol, Symbol::State(_))) => {
                Diagnostic::error(span, "a closure binds positions, and a `state` is no position")
                    .hint("a closure can hold drivers, coordinates and dependent coordinates")
            }
            () if depends(low, &|symbol| {
                use Symbol::{Acceleration, DriverAcceleration, DriverRate, Speed};
                matches!(symbol, DriverRate(_) | DriverAcceleration(_) | Speed(_) | Acceleration(_))
            }) =>
            {
                Diagnostic::error(
                    span,
                    "a closure binds positions, and this holds a time derivative",
                )
            }
            () if !depends(low, &|symbol| {
                matches!(symbol, Symbol::Dependent(_) | Symbol::Coordinate(_))
            }) =>
            {
                let zero = low.graph.as_number(residual) == Some(0.0);
                let report = Diagnostic::error(
                    span,
                    "no dependent coordinate occurs in this equation, so it closes nothing",
                );
                match zero {
                    true => report.hint("one component of the vector equation says 0 = 0"),
                    false => report
                        .hint("declare what it determines with `dependent`, or write a `require`"),
                }
            }
            () => return true,
        };
        low.diagnostics.push(report);
        false
    }

    /// Two equations that say the same.
    fn report_repeated(&self, low: &mut Lowering<'_>) {
        for (index, one) in self.equations.iter().enumerate() {
            let opposite = low.graph.neg(one.residual);
            let same =
                |other: &&Equation| other.residual == one.residual || other.residual == opposite;
            if let Some(earlier) = self.equations[..index].iter().find(same) {
                let message =
                    format!("the closures `{}` and `{}` say the same", earlier.name, one.name);
                low.diagnostics.push(
                    Diagnostic::error(one.span, message)
                        .related(earlier.span, "the first one")
                        .hint("take one of them away: it determines nothing"),
                );
            }
        }
    }
}
