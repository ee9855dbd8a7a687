//! What a stored value is, as a formula in the names of the file: the documentation of the fields.

use std::collections::BTreeSet;

use assur_model::program::{Function, Input, OperationKind, Relation, Search, Value};

use crate::expression::Binding;
use crate::layout::Layout;

/// Longest formula, in characters.
const LONGEST: usize = 100;

/// The formula of a value in terms of named and of other stored values; nothing when it would be long.
pub fn of(layout: &Layout<'_>, value: Value, stored: &BTreeSet<Value>) -> Option<String> {
    let printer = Printer { layout, stored, of: value };
    let (text, _) = printer.text(value);
    (text.chars().count() <= LONGEST).then_some(text)
}

struct Printer<'a> {
    layout: &'a Layout<'a>,
    stored: &'a BTreeSet<Value>,
    of: Value,
}

impl Printer<'_> {
    /// The text of a value and how tightly it holds together.
    fn text(&self, value: Value) -> (String, Binding) {
        let operation = &self.layout.program().operations[value.0 as usize];
        let name = match (&operation.kind, &operation.name) {
            (OperationKind::Input(input), _) => Some(self.input(*input)),
            (_, Some(name)) if value != self.of => Some(name.clone()),
            _ if value != self.of && self.stored.contains(&value) => {
                Some(self.layout.names.of(value).to_string())
            }
            _ => None,
        };
        match name {
            Some(name) => (name, Binding::Whole),
            None => self.operation(&operation.kind),
        }
    }

    fn input(&self, input: Input) -> String {
        let scene = self.layout.scene;
        let quantity = match input {
            Input::Time => return "time".to_owned(),
            Input::Parameter(index) => {
                let constant = scene.constants.get(index as usize);
                constant.map(|constant| &constant.quantity)
            }
            Input::State(index) => scene.states.get(index as usize),
            Input::Driver(_)
            | Input::Position(_)
            | Input::Mode(_)
            | Input::Side(_)
            | Input::Measured(_)
            | Input::Change(_)
            | Input::Captured(_)
            | Input::Place => {
                return crate::names::given(scene, input).unwrap_or_default();
            }
        };
        quantity.map_or_else(String::new, |quantity| quantity.name.clone())
    }

    fn operation(&self, kind: &OperationKind) -> (String, Binding) {
        use Binding::{Product, Sign, Sum, Whole};
        use OperationKind as Kind;
        let read = kind.operands();
        let at = |index: usize, binding: Binding| {
            let (text, own) = self.text(read[index]);
            if own < binding { format!("({text})") } else { text }
        };
        let list = || {
            let texts: Vec<String> = read.iter().map(|value| self.text(*value).0).collect();
            texts.join(", ")
        };
        let product = || match read[0] == read[1] {
            true => (format!("{}^2", at(0, Whole)), Sign),
            false => (format!("{}*{}", at(0, Product), at(1, Sign)), Product),
        };
        match kind {
            Kind::Number(number) if *number < 0.0 => (format!("{number}"), Sum),
            Kind::Number(number) => (format!("{number}"), Whole),
            Kind::Add(..) => (format!("{} + {}", at(0, Sum), at(1, Product)), Sum),
            Kind::Subtract(..) => (format!("{} - {}", at(0, Sum), at(1, Product)), Sum),
            Kind::Multiply(..) => product(),
            Kind::Divide(..) => (format!("{}/{}", at(0, Product), at(1, Whole)), Product),
            Kind::Negate(_) => (format!("-{}", at(0, Product)), Sum),
            Kind::MultiplyAdd(..) => (format!("{} + {}", product().0, at(2, Product)), Sum),
            Kind::MultiplySubtract(..) => (format!("{} - {}", product().0, at(2, Product)), Sum),
            Kind::NegateMultiplyAdd(..) => (format!("{} - {}", at(2, Sum), product().0), Sum),
            Kind::Call(function, _) => (format!("{}({})", name(*function), list()), Whole),
            Kind::Compare(relation, ..) => {
                let sign = match relation {
                    Relation::Less => "<",
                    Relation::LessEqual => "<=",
                    Relation::Equal => "==",
                };
                (format!("({} {sign} {})", at(0, Sum), at(1, Sum)), Whole)
            }
            Kind::And(..) => (format!("({} and {})", at(0, Sum), at(1, Sum)), Whole),
            Kind::Or(..) => (format!("({} or {})", at(0, Sum), at(1, Sum)), Whole),
            Kind::Not(_) => (format!("not {}", at(0, Whole)), Whole),
            Kind::Select { .. } => {
                (format!("if {} {{ {} }} else {{ {} }}", at(0, Sum), at(1, Sum), at(2, Sum)), Sum)
            }
            Kind::Factor { .. } => (format!("factors({})", list()), Whole),
            Kind::Solve { .. } => (format!("solve({})", list()), Whole),
            Kind::Element { index, .. } => (format!("{}[{index}]", at(0, Whole)), Whole),
            Kind::Table { .. } => (format!("table({})", list()), Whole),
            Kind::Search { search, .. } => (format!("{}({})", found(*search), list()), Whole),
            Kind::Input(input) => (self.input(*input), Whole),
        }
    }
}

/// The name of a search in the language.
fn found(search: Search) -> &'static str {
    match search {
        Search::Mean => "mean",
        Search::Root => "root",
        Search::Highest => "peak",
        Search::HighestPlace => "peak_at",
    }
}

/// The name of a function in the language.
fn name(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Atan => "atan",
        Function::Atan2 => "atan2",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Log10 => "log10",
        Function::Sqrt => "sqrt",
        Function::Hypot => "hypot",
        Function::Erf => "erf",
        Function::NormalCdf => "normal_cdf",
        Function::Floor => "floor",
        Function::Abs => "abs",
        Function::Sign => "sign",
        Function::Max => "max",
        Function::Min => "min",
        Function::Power => "power",
        Function::ExpM1 => "exp_m1",
        Function::Ln1p => "ln_1p",
    }
}
