//! Expressions, and the units in them.

use std::sync::Arc;

use super::Name;
use crate::sheet::Sheet;
use crate::token::Span;

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// From its first token to its last.
    pub span: Span,
    /// What it is.
    pub kind: TermKind,
}

impl Term {
    /// The terms that it is made of, in the order of the file.
    pub fn parts(&self) -> Vec<&Term> {
        match &self.kind {
            TermKind::Number { .. } | TermKind::Name(_) => Vec::new(),
            TermKind::Index { index: inner, .. }
            | TermKind::Member { base: inner, .. }
            | TermKind::Unary(_, inner) => vec![inner],
            TermKind::Binary(_, left, right) => vec![left, right],
            TermKind::Vector(items) => items.iter().collect(),
            TermKind::Call { arguments, .. } => arguments.iter().collect(),
            TermKind::If { condition, then, otherwise } => vec![condition, then, otherwise],
            TermKind::Sum { from, to, body, .. } | TermKind::Search { from, to, body, .. } => {
                vec![from, to, body]
            }
            TermKind::Table(table) => table.parts(),
            TermKind::Bound { value, .. } => vec![value],
        }
    }

    /// What stands in its place: a value of its kind, for the quantity of a name.
    pub fn replaced(self, name: &str, value: &Self) -> Self {
        let kind = TermKind::Bound {
            name: name.to_owned(),
            value: Box::new(value.clone()),
            instead: Box::new(self),
        };
        Self { span: value.span, kind }
    }

    /// Whether it is made of numbers, `pi` and functions of them.
    pub fn is_made_of_numbers(&self) -> bool {
        match &self.kind {
            TermKind::Number { .. } => true,
            TermKind::Name(name) => name == "pi",
            TermKind::Unary(..)
            | TermKind::Binary(..)
            | TermKind::Call { .. }
            | TermKind::Bound { .. } => self.parts().into_iter().all(Self::is_made_of_numbers),
            _ => false,
        }
    }
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the example of each variant names its parts")]
pub enum TermKind {
    /// `75`, `75 mm`, `0.1 [kg m^2]`
    Number { value: f64, unit: Option<UnitTerm> },
    /// `x`
    Name(String),
    /// `x[k + 1]`
    Index { name: Name, index: Box<Term> },
    /// `crank.exact`, `feed.tooth`
    Member { base: Box<Term>, name: Name },
    /// `[x, y]`, `[x, y, z]`
    Vector(Vec<Term>),
    /// `-x`, `!c`
    Unary(UnaryOperator, Box<Term>),
    /// `x + y`
    Binary(BinaryOperator, Box<Term>, Box<Term>),
    /// `sin(x)`
    Call { name: Name, arguments: Vec<Term> },
    /// `if c { x } else { y }`
    If { condition: Box<Term>, then: Box<Term>, otherwise: Box<Term> },
    /// `sum(k in 1..5, x[k])`, both ends included.
    Sum { index: Name, from: Box<Term>, to: Box<Term>, body: Box<Term> },
    /// `integral(f, x, a .. b)`: what is found of `f` while `x` goes from `a` to `b`. In `solve(x in a .. b, l = r)` the body is
    /// `l - r`.
    Search { name: Name, variable: Name, from: Box<Term>, to: Box<Term>, body: Box<Term> },
    /// `table(x; 0: 1, 1: 3)`, `table("spring.csv", x)`.
    Table(Box<TableTerm>),
    /// What the quantity `name` is given instead of what is declared, both of one kind. It is not written so: the binding
    /// `e_v = 6 mm;` of a part makes it, or `start psi = 100 deg;` of a scene.
    Bound { name: String, value: Box<Term>, instead: Box<Term> },
}

/// A sampled curve at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct TableTerm {
    /// The place.
    pub at: Term,
    /// The points.
    pub points: Points,
    /// Whether it goes on periodically.
    pub is_periodic: bool,
    /// The standard error of the ordinates, if it is to be smoothed.
    pub error: Option<Term>,
}

impl TableTerm {
    fn parts(&self) -> Vec<&Term> {
        let points: &[(Term, Term)] = match &self.points {
            Points::Written(points) => points,
            Points::File { .. } => &[],
        };
        let points = points.iter().flat_map(|(x, y)| [x, y]);
        [&self.at].into_iter().chain(points).chain(&self.error).collect()
    }

    pub(super) fn parts_mut(&mut self) -> Vec<&mut Term> {
        let points: &mut [(Term, Term)] = match &mut self.points {
            Points::Written(points) => points,
            Points::File { .. } => &mut [],
        };
        let points = points.iter_mut().flat_map(|(x, y)| [x, y]);
        [&mut self.at].into_iter().chain(points).chain(&mut self.error).collect()
    }
}

/// The points of a curve.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the example of each variant names its parts")]
pub enum Points {
    /// `0 s: 1 mm, 1 s: 3 mm`
    Written(Vec<(Term, Term)>),
    /// `"spring.csv"`, and the head of the column with the ordinates if there is more than one; what stands in the file once it
    /// has been read.
    File { file: Name, column: Option<Name>, sheet: Option<Arc<Sheet>> },
}

/// An operator before its operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOperator {
    /// `-`
    Negate,
    /// `!`
    Not,
}

/// An operator between its operands, loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOperator {
    /// `||`
    Or,
    /// `&&`
    And,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`, to the right, tighter than a sign before it: `-x^2` is `-(x^2)`
    Power,
}

/// A unit as it is written: `mm`, `[kg m^2/s]`, `[1/s^2]`. After `/` only the next name is below the line
/// (`N m/rad` is N·m/rad, `J/kg K` is an error that asks for `J/(kg K)`).
#[derive(Clone, Debug, PartialEq)]
pub struct UnitTerm {
    /// Where it stands.
    pub span: Span,
    /// Names with their exponents (numerator, denominator), `/` applied.
    pub factors: Vec<(Name, (i8, i8))>,
}
