//! What a scene is asked for: outputs, its task, start values, presets.

mod start;

use std::collections::BTreeSet;

pub use start::start;

use crate::checked::{QuantityInfo, SpanKind};
use crate::declare::quantity;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, describe};
use crate::lower::{Kind, Limit, Lowering, Typed, second};
use crate::nearest::nearest;
use crate::resolve::Declared;
use crate::syntax::print;
use crate::syntax::tree::{
    BinaryOperator, File, Output, Scene, SceneItem, StatementKind, Term, TermKind,
};
use crate::unit;

/// The reported quantities with their values.
#[derive(Default)]
pub struct Outputs {
    /// Names and units.
    pub quantities: Vec<QuantityInfo>,
    /// Values, in the same order.
    pub values: Vec<Expression>,
    /// Which of them are zero, and so of any kind.
    pub free: Vec<bool>,
}

/// Lowers the reported quantities; a vector becomes its components.
pub fn outputs(low: &mut Lowering<'_>, declared: &[Declared<Output>]) -> Outputs {
    let mut outputs = Outputs::default();
    let mut known = BTreeSet::new();
    for output in declared {
        low.begin(Some(output.what.span));
        let own_name = Term { span: output.name.span, kind: name_kind(&output.name.text) };
        let value = output.what.value.as_ref();
        let term = match (value, output.name.text.is_empty()) {
            (Some(value), true) => value,
            _ => &own_name,
        };
        let typed = low.term(term);
        let name =
            if output.name.text.is_empty() { print::term(term) } else { output.name.text.clone() };
        let shown = value.unwrap_or(term);
        let (values, kind) = match &typed {
            Typed::Quantity(quantity) => (quantity.values(), quantity.kind),
            Typed::Wrong => continue,
            other => {
                let message = format!("a quantity is reported, and this is {}", other.describe());
                low.diagnostics.push(Diagnostic::error(output.what.span, message));
                continue;
            }
        };
        let unit = match &output.what.unit {
            Some(written) => match unit::resolve(written, low.diagnostics) {
                Some(unit) if agree(Kind::Of(unit.dimension), kind).is_some() => unit,
                Some(unit) => {
                    let message = format!(
                        "`{name}` is {}, which cannot be printed in {}",
                        describe(kind.dimension()),
                        unit.symbol
                    );
                    low.diagnostics.push(Diagnostic::error(written.span, message));
                    continue;
                }
                None => continue,
            },
            None => low.natural_unit(shown, kind),
        };
        let components = ["x", "y", "z"];
        for (index, value) in values.iter().enumerate() {
            let label = if values.len() > 1 {
                format!("{name}.{}", components[index])
            } else {
                name.clone()
            };
            if !known.insert(label.clone()) {
                let message = format!("`{label}` is reported twice");
                low.diagnostics.push(Diagnostic::warning(output.what.span, message));
                continue;
            }
            outputs.quantities.push(quantity(&label, &output.summary, &unit.dimension, &unit));
            outputs.values.push(*value);
            outputs.free.push(kind == Kind::Any && output.what.unit.is_none());
        }
    }
    low.begin(None);
    limited(low, &mut outputs);
    outputs
}

/// Takes the values of all outputs away where a condition on what is swept does not hold, and reports by how much each holds.
fn limited(low: &mut Lowering<'_>, outputs: &mut Outputs) {
    let limits = std::mem::take(&mut low.limits);
    let Some(all) = limits.iter().map(|limit| limit.value).reduce(|a, b| low.graph.and(a, b))
    else {
        return;
    };
    let nothing = low.graph.number(-1.0);
    let nothing = low.graph.sqrt(nothing);
    for value in &mut outputs.values {
        *value = low.graph.select(all, *value, nothing);
    }
    for Limit { condition, message, .. } in limits {
        let TermKind::Binary(operator, left, right) = &condition.kind else {
            continue;
        };
        use BinaryOperator::{Greater, GreaterEqual, Less, LessEqual};
        let (larger, smaller) = match operator {
            Greater | GreaterEqual => (left, right),
            Less | LessEqual => (right, left),
            _ => continue,
        };
        let margin = TermKind::Binary(BinaryOperator::Subtract, larger.clone(), smaller.clone());
        let margin = Term { span: condition.span, kind: margin };
        let Some((value, kind)) = low.scalar(&margin) else {
            continue;
        };
        let unit = low.natural_unit(larger, kind);
        let name = format!("margin of {}", print::term(&condition));
        outputs.quantities.push(quantity(&name, &message, &unit.dimension, &unit));
        outputs.values.push(value);
        outputs.free.push(kind == Kind::Any);
    }
}

/// A name, or an indexed name, as a term.
fn name_kind(text: &str) -> TermKind {
    TermKind::Name(text.to_string())
}

/// Task of a scene with its times.
pub struct TaskValues {
    /// Which task.
    pub kind: SpanKind,
    /// The period, nothing if it is a result, or start and end.
    pub values: Vec<Expression>,
}

impl TaskValues {
    /// Whether the period is a result.
    pub fn is_clock(&self) -> bool {
        self.kind == SpanKind::Periodic && self.values.is_empty()
    }
}

/// Lowers the task.
pub fn task(low: &mut Lowering<'_>, scene: Option<&Scene>) -> TaskValues {
    let mut task = TaskValues { kind: SpanKind::Open, values: Vec::new() };
    for item in scene.iter().flat_map(|scene| &scene.items) {
        let (kind, terms) = match item {
            SceneItem::Periodic { period } => (SpanKind::Periodic, period.iter().collect()),
            SceneItem::Run { variable, from, to } => {
                if variable.text != "time" {
                    low.diagnostics.push(
                        Diagnostic::error(variable.span, "a scene runs over `time`")
                            .hint("write `run time 0 s .. 3 s;`"),
                    );
                    continue;
                }
                (SpanKind::Run, vec![from, to])
            }
            SceneItem::Rest { .. } => (SpanKind::Rest, Vec::new()),
            SceneItem::Sweep { .. } => (SpanKind::Sweep, Vec::new()),
            _ => continue,
        };
        if task.kind != SpanKind::Open {
            let place = match (item, terms.first()) {
                (SceneItem::Rest { place }, _) => *place,
                (_, first) => first.map(|term| term.span).unwrap_or_default(),
            };
            low.diagnostics
                .push(Diagnostic::error(place, "a scene has one task, and this is its second"));
            continue;
        }
        task.kind = kind;
        for term in &terms {
            if let Some((value, found)) = low.scalar(term) {
                if agree(found, Kind::Of(second())).is_none() {
                    let message = format!(
                        "a time is expected here, and this is {}",
                        describe(found.dimension())
                    );
                    low.diagnostics.push(Diagnostic::error(term.span, message).hint(
                        match task.kind {
                            SpanKind::Run => "a time has a unit: `run time 0 s .. 3 s;`",
                            _ => "a period in terms of a speed `n` is `2*pi/n`",
                        },
                    ));
                } else if !low.is_constant(value) {
                    low.diagnostics.push(Diagnostic::error(
                        term.span,
                        "the task of a scene can depend on constants alone",
                    ));
                }
                task.values.push(value);
            }
        }
        check_stretch(low, &task.values, &terms);
    }
    task
}

/// A run ends after it begins, and a period is longer than nothing; what depends on constants is seen when it runs.
fn check_stretch(low: &mut Lowering<'_>, values: &[Expression], terms: &[&Term]) {
    let numbers: Option<Vec<f64>> = values.iter().map(|one| low.graph.as_number(*one)).collect();
    let (place, message, hint) = match (numbers.as_deref(), terms) {
        (Some(&[from, to]), [first, last]) if to <= from => (
            first.span.to(last.span),
            match to < from {
                true => "the run ends before it begins",
                false => "the run ends where it begins",
            },
            "write the earlier time first, as in `run time 0 s .. 3 s;`",
        ),
        (Some(&[period]), [term]) if period <= 0.0 => (
            term.span,
            "a period is longer than nothing",
            "a period in terms of a speed `n` is `2*pi/n`",
        ),
        _ => return,
    };
    low.diagnostics.push(Diagnostic::error(place, message).hint(hint));
}

/// The preset of a scene: its name and values.
pub fn preset(
    low: &mut Lowering<'_>,
    file: &File,
    scene: &Scene,
) -> Option<(String, Vec<(String, f64)>)> {
    let chosen = scene
        .items
        .iter()
        .find_map(|item| if let SceneItem::Preset { name } = item { Some(name) } else { None })?;
    let all = file.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Preset { name, values, .. } => Some((name, values)),
        _ => None,
    });
    let known: Vec<_> = all.collect();
    let Some((name, values)) = known.iter().find(|(name, _)| name.text == chosen.text) else {
        let report =
            Diagnostic::error(chosen.span, format!("there is no preset `{}`", chosen.text));
        let names = known.iter().map(|(name, _)| name.text.as_str());
        let near = nearest(&chosen.text, names);
        low.diagnostics.push(report.meant(near, "declare it with `preset NAME { … }`"));
        return None;
    };
    let mut list = Vec::new();
    for (target, term) in values.iter() {
        let Some(name) = crate::unroll::target_name(target, low.diagnostics) else {
            continue;
        };
        if let Some((value, _)) = low.fixed(term) {
            list.push((name.text, value));
        }
    }
    Some((name.text.clone(), list))
}

impl Lowering<'_> {
    /// Whether a value depends on dimensions and parameters alone.
    pub fn is_constant(&self, value: Expression) -> bool {
        !self.graph.depends_on(value, |symbol| !matches!(symbol, Symbol::Parameter(_)))
    }

    /// The symbol that an expression is.
    pub fn given_symbol(&self, value: Expression) -> Option<Symbol> {
        match self.graph.node(value) {
            crate::expression::Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }
}
