//! Functions: those of the language, as a table of what they take and give, and those of the file.

use super::{Kind, Lowering, Typed, second};
use crate::diagnostic::Diagnostic;
use crate::expression::Expression;
use crate::homogeneity::{agree, describe, disagreement, over, power};
use crate::nearest::nearest;
use crate::program::Function;
use crate::resolve::Role;
use crate::syntax::tree::{Name, Term, TermKind};
use crate::syntax::words::{FUNCTIONS, MEASURING};
use crate::token::Span;

/// What a function does to the kinds of its arguments.
#[derive(Clone, Copy, PartialEq)]
enum Rule {
    /// Pure numbers (or angles) to a pure number.
    Number,
    /// Any kind to its square root.
    Root,
    /// Any kind, kept.
    Keep,
    /// Any kind to a pure number.
    Forget,
    /// Two of one kind to a pure number.
    Ratio,
    /// Two or more of one kind, kept.
    Same,
}

/// Name, function, number of arguments, rule.
const TABLE: &[(&str, Function, usize, Rule)] = &[
    ("sin", Function::Sin, 1, Rule::Number),
    ("cos", Function::Cos, 1, Rule::Number),
    ("tan", Function::Tan, 1, Rule::Number),
    ("asin", Function::Asin, 1, Rule::Number),
    ("acos", Function::Acos, 1, Rule::Number),
    ("atan", Function::Atan, 1, Rule::Number),
    ("atan2", Function::Atan2, 2, Rule::Ratio),
    ("sinh", Function::Sinh, 1, Rule::Number),
    ("cosh", Function::Cosh, 1, Rule::Number),
    ("tanh", Function::Tanh, 1, Rule::Number),
    ("exp", Function::Exp, 1, Rule::Number),
    ("ln", Function::Ln, 1, Rule::Number),
    ("log10", Function::Log10, 1, Rule::Number),
    ("erf", Function::Erf, 1, Rule::Number),
    ("normal_cdf", Function::NormalCdf, 1, Rule::Number),
    ("floor", Function::Floor, 1, Rule::Number),
    ("sqrt", Function::Sqrt, 1, Rule::Root),
    ("abs", Function::Abs, 1, Rule::Keep),
    ("sign", Function::Sign, 1, Rule::Forget),
    ("hypot", Function::Hypot, 2, Rule::Same),
    ("max", Function::Max, 2, Rule::Same),
    ("min", Function::Min, 2, Rule::Same),
];

/// That a quantity is called.
fn not_a_function(name: &Name) -> Diagnostic {
    let text = &name.text;
    if !MEASURING.contains(&text.as_str()) {
        let report = Diagnostic::error(name.span, format!("`{text}` is not a function"));
        return report.hint("a product needs `*`");
    }
    let message = format!("`{text}` is a quantity here, which hides the function of measures");
    Diagnostic::error(name.span, message).hint("give the quantity another name")
}

impl Lowering<'_> {
    pub(super) fn call(&mut self, name: &Name, arguments: &[Term], span: Span) -> Typed {
        match name.text.as_str() {
            "dot" | "ddot" | "diff" => return self.derivative(name, arguments, span),
            "inner" | "cross" | "norm" | "dir" | "rot" | "rotx" | "roty" | "rotz" => {
                return self.vector_function(name, arguments, span);
            }
            _ => {}
        }
        let names = self.names;
        if let Some(entry) = names.table.get(&name.text) {
            let Role::Function(parameters, body) = &entry.role else {
                // A quantity may be called after what it is: `output energy = energy(kinetic);`.
                if let Some(found) = self.of_motion(name, arguments, span) {
                    return found;
                }
                self.used.insert(name.text.clone());
                let report = not_a_function(name);
                return self.error(report.related(entry.span, "declared here"));
            };
            self.used.insert(name.text.clone());
            if !self.count(name, arguments.len(), parameters.len(), span) {
                return Typed::Wrong;
            }
            let values = arguments.iter().map(|one| self.term(one)).collect();
            return self.apply(name, parameters, body, values, span);
        }
        if name.text == "mod" {
            return self.modulo(name, arguments, span);
        }
        if let Some(found) = self.measuring(name, arguments, span) {
            return found;
        }
        if let Some(found) = self.of_motion(name, arguments, span) {
            return found;
        }
        let Some((_, function, expected, rule)) = TABLE.iter().find(|row| row.0 == name.text)
        else {
            return self.unknown_function(name);
        };
        let many = matches!(function, Function::Max | Function::Min) && arguments.len() > 2;
        if !many && !self.count(name, arguments.len(), *expected, span) {
            return Typed::Wrong;
        }
        self.function(*function, *rule, arguments)
    }

    /// That there is no such function, and which may be meant.
    fn unknown_function(&mut self, name: &Name) -> Typed {
        if self.survey.is_unread(&name.text) {
            return Typed::Wrong;
        }
        let report = Diagnostic::error(name.span, format!("there is no function `{}`", name.text));
        if self.diagnostics.is_crowded() {
            return self.error(report);
        }
        if let Some(hint) = super::notation::elsewhere(&name.text) {
            return self.error(report.hint(hint));
        }
        let declared = self.names.table.iter();
        let own = declared.filter(|(_, entry)| matches!(entry.role, Role::Function(..)));
        let known = own.map(|(one, _)| one.as_str()).chain(FUNCTIONS.iter().copied());
        let otherwise = "declare it with `let`, as in `let f(x) = …;`";
        self.error(report.meant(nearest(&name.text, known), otherwise))
    }

    pub(super) fn count(&mut self, name: &Name, found: usize, expected: usize, span: Span) -> bool {
        if found == expected {
            return true;
        }
        let plural = if expected == 1 { "" } else { "s" };
        let message =
            format!("`{}` takes {expected} argument{plural}, and this gives it {found}", name.text);
        let report = Diagnostic::error(span, message);
        self.diagnostics.push(match super::notation::other_count(&name.text, found) {
            Some(hint) => report.hint(hint),
            None => report,
        });
        false
    }

    fn function(&mut self, function: Function, rule: Rule, arguments: &[Term]) -> Typed {
        let mut values: Vec<Expression> = Vec::new();
        let mut common = Kind::Any;
        for (index, argument) in arguments.iter().enumerate() {
            let Some((value, kind)) = self.scalar(argument) else {
                return Typed::Wrong;
            };
            if rule == Rule::Number && agree(kind, Kind::NUMBER).is_none() {
                let message = format!(
                    "a pure number or an angle is expected here, and this is {}",
                    describe(kind.dimension())
                );
                let is_rate = over(Kind::NUMBER, Kind::Of(second())) == Some(kind);
                return self.error(Diagnostic::error(argument.span, message).hint(match is_rate {
                    true => "the angle that a constant speed `n` has turned is `n*time`",
                    false => "divide its unit out, as in `exp(-time/(1 s))`",
                }));
            }
            match agree(common, kind) {
                Some(kind) => common = kind,
                None => {
                    let first = arguments[index - 1].span;
                    return self.error(disagreement(
                        "the arguments are",
                        (first, common),
                        (argument.span, kind),
                    ));
                }
            }
            if let Function::Sin | Function::Cos | Function::Tan = function {
                self.check_angle(argument, value);
            }
            values.push(value);
        }
        let kind = match rule {
            Rule::Number | Rule::Forget | Rule::Ratio => Some(Kind::NUMBER),
            Rule::Root => power(common, 0.5),
            Rule::Keep | Rule::Same => Some(common),
        };
        let Some(kind) = kind else {
            let message =
                format!("{} has no square root with a simple unit", describe(common.dimension()));
            return self.error(Diagnostic::error(arguments[0].span, message));
        };
        let mut value = values[0];
        match (function, values.len()) {
            (Function::Sqrt, _) => value = self.graph.sqrt(value),
            (_, 1) => value = self.graph.call(function, &values),
            _ => {
                for next in &values[1..] {
                    value = self.graph.call(function, &[value, *next]);
                }
            }
        }
        Typed::scalar(value, kind)
    }

    /// `mod(a, b) = a - b*floor(a/b)`, between zero and `b`.
    fn modulo(&mut self, name: &Name, arguments: &[Term], span: Span) -> Typed {
        if !self.count(name, arguments.len(), 2, span) {
            return Typed::Wrong;
        }
        let (Some((a, p)), Some((b, q))) = (self.scalar(&arguments[0]), self.scalar(&arguments[1]))
        else {
            return Typed::Wrong;
        };
        let Some(kind) = agree(p, q) else {
            return self.error(disagreement(
                "the arguments are",
                (arguments[0].span, p),
                (arguments[1].span, q),
            ));
        };
        let quotient = self.graph.div(a, b);
        let whole = self.graph.call(Function::Floor, &[quotient]);
        let kind_of_term = TermKind::Call { name: name.clone(), arguments: arguments.to_vec() };
        let term = Term { span, kind: kind_of_term };
        self.written.insert(whole, &term);
        let part = self.graph.mul(b, whole);
        Typed::scalar(self.graph.sub(a, part), kind)
    }
}
