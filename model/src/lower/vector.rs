//! Vectors and rotations.

use super::{Kind, Lowering, Quantity, Typed};
use crate::diagnostic::Diagnostic;
use crate::expression::Expression;
use crate::homogeneity::{agree, describe, disagreement, times};
use crate::program::Function;
use crate::syntax::tree::{Name, Term, TermKind};
use crate::syntax::words::COMPONENTS;
use crate::token::Span;

impl Lowering<'_> {
    /// `[x, y]` or `[x, y, z]`.
    pub(super) fn vector(&mut self, items: &[Term], span: Span) -> Typed {
        if !(2..=3).contains(&items.len()) {
            let message =
                format!("a vector has two or three components, and this has {}", items.len());
            return self.error(Diagnostic::error(span, message));
        }
        let mut values = Vec::new();
        let mut common = Kind::Any;
        let mut all_rates = true;
        for item in items {
            let component = match self.term(item) {
                Typed::Quantity(one) if !one.is_vector() => one,
                Typed::Wrong => return Typed::Wrong,
                other => {
                    let message =
                        format!("a component has to be a number, and this is {}", other.describe());
                    return self.error(Diagnostic::error(item.span, message));
                }
            };
            let Some(kind) = agree(common, component.kind) else {
                let (first, this) = ((items[0].span, common), (item.span, component.kind));
                return self.error(disagreement("the components are", first, this));
            };
            common = kind;
            let value = component.values()[0];
            all_rates &= component.rate || self.is_fixed(value);
            values.push(value);
        }
        Quantity::of(&values, common).rated(all_rates)
    }

    /// Whether `base.x` asks for a component: what stands before the point is a value, and no choice.
    pub(super) fn has_components(&self, base: &Term, name: &Name) -> bool {
        let is_value = match &base.kind {
            TermKind::Name(name) => {
                self.names.table.contains_key(name)
                    || self.locals.last().is_some_and(|scope| scope.contains_key(name))
            }
            TermKind::Member { .. } => false,
            _ => true,
        };
        COMPONENTS.contains(&name.text.as_str()) && is_value
    }

    /// `v.x`, `v.y`, `v.z`
    pub(super) fn component(&mut self, base: &Term, name: &Name) -> Typed {
        match self.term(base) {
            Typed::Quantity(vector) if vector.is_vector() => {
                let values = vector.values();
                let index = COMPONENTS.iter().position(|one| *one == name.text);
                match index.and_then(|index| values.get(index)) {
                    Some(value) => Quantity::of(&[*value], vector.kind).rated(vector.rate),
                    None => {
                        let message = format!("the vector has {} components", values.len());
                        self.error(Diagnostic::error(name.span, message))
                    }
                }
            }
            other => self.not_a_vector(other, base.span),
        }
    }

    pub(super) fn vector_function(&mut self, name: &Name, arguments: &[Term], span: Span) -> Typed {
        let expected = if matches!(name.text.as_str(), "inner" | "cross") { 2 } else { 1 };
        if arguments.len() != expected {
            let message = format!(
                "`{}` takes {expected} argument(s), and this gives it {}",
                name.text,
                arguments.len()
            );
            return self.error(Diagnostic::error(span, message));
        }
        match name.text.as_str() {
            "dir" | "rot" | "rotx" | "roty" | "rotz" => self.rotation(&name.text, &arguments[0]),
            "norm" => match self.term(&arguments[0]) {
                Typed::Quantity(one) if one.is_vector() => {
                    let square = self.inner_sum(one.values(), one.values());
                    Typed::scalar(self.graph.sqrt(square), one.kind)
                }
                other => self.not_a_vector(other, arguments[0].span),
            },
            _ => match (self.term(&arguments[0]), self.term(&arguments[1])) {
                (Typed::Quantity(u), Typed::Quantity(v)) if u.is_vector() && v.is_vector() => {
                    self.product_of_vectors(&name.text, (&u, &v), span)
                }
                (Typed::Quantity(u), other) if u.is_vector() => {
                    self.not_a_vector(other, arguments[1].span)
                }
                (other, _) => self.not_a_vector(other, arguments[0].span),
            },
        }
    }

    /// `inner(u, v)` or `cross(u, v)`.
    fn product_of_vectors(
        &mut self,
        name: &str,
        (u, v): (&Quantity, &Quantity),
        span: Span,
    ) -> Typed {
        let (x, y) = (u.values(), v.values());
        if x.len() != y.len() {
            let message = format!("the vectors have {} and {} components", x.len(), y.len());
            return self.error(Diagnostic::error(span, message));
        }
        match times(u.kind, v.kind) {
            None => Typed::Wrong,
            Some(kind) if name == "inner" => Typed::scalar(self.inner_sum(x, y), kind),
            Some(kind) => self.cross(x, y, kind),
        }
    }

    fn not_a_vector(&mut self, other: Typed, span: Span) -> Typed {
        if matches!(other, Typed::Wrong) {
            return other;
        }
        let message = format!("a vector is expected here, and this is {}", other.describe());
        self.error(Diagnostic::error(span, message).hint("write it with its components, `[x, y]`"))
    }

    /// In the plane the cross product is a number.
    fn cross(&mut self, u: &[Expression], v: &[Expression], kind: Kind) -> Typed {
        let mut minor = |i: usize, j: usize| {
            let (a, b) = (self.graph.mul(u[i], v[j]), self.graph.mul(u[j], v[i]));
            self.graph.sub(a, b)
        };
        if u.len() == 2 {
            return Typed::scalar(minor(0, 1), kind);
        }
        Quantity::of(&[minor(1, 2), minor(2, 0), minor(0, 1)], kind).into()
    }

    fn rotation(&mut self, name: &str, argument: &Term) -> Typed {
        let Some((angle, kind)) = self.scalar(argument) else {
            return Typed::Wrong;
        };
        if agree(kind, Kind::NUMBER).is_none() {
            let message =
                format!("an angle is expected here, and this is {}", describe(kind.dimension()));
            return self.error(Diagnostic::error(argument.span, message));
        }
        self.check_angle(argument, angle);
        let (sine, cosine) =
            (self.graph.call(Function::Sin, &[angle]), self.graph.call(Function::Cos, &[angle]));
        let (minus, zero, one) = (self.graph.neg(sine), self.graph.zero(), self.graph.one());
        match name {
            "dir" => Quantity::of(&[cosine, sine], Kind::NUMBER).into(),
            "rot" => Typed::Matrix(vec![vec![cosine, minus], vec![sine, cosine]]),
            "rotx" => Typed::Matrix(vec![
                vec![one, zero, zero],
                vec![zero, cosine, minus],
                vec![zero, sine, cosine],
            ]),
            "roty" => Typed::Matrix(vec![
                vec![cosine, zero, sine],
                vec![zero, one, zero],
                vec![minus, zero, cosine],
            ]),
            _ => Typed::Matrix(vec![
                vec![cosine, minus, zero],
                vec![sine, cosine, zero],
                vec![zero, zero, one],
            ]),
        }
    }
}
