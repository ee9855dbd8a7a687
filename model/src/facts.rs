//! What a scene is asked for: outputs, its task, start values, presets.

use std::collections::BTreeSet;

use crate::checked::{QuantityInfo, SpanKind};
use crate::declare::quantity;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, describe, fitting_value, over};
use crate::lower::{Kind, Lowering, Typed, second};
use crate::nearest::nearest;
use crate::resolve::{Declared, Names};
use crate::syntax::print;
use crate::syntax::tree::{File, Output, Scene, SceneItem, StatementKind, Term, TermKind};
use crate::token::Span;
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
        let own_name = Term {
            span: output.name.span,
            kind: name_kind(&output.name.text),
        };
        let value = output.what.value.as_ref();
        let term = match (value, output.name.text.is_empty()) {
            (Some(value), true) => value,
            _ => &own_name,
        };
        let typed = low.term(term);
        let name = if output.name.text.is_empty() {
            print::term(term)
        } else {
            output.name.text.clone()
        };
        let shown = value.unwrap_or(term);
        let (values, kind) = match &typed {
            Typed::Quantity(quantity) => (quantity.values(), quantity.kind),
            Typed::Wrong => continue,
            other => {
                let message = format!("a quantity is reported, and this is {}", other.describe());
                low.diagnostics
                    .push(Diagnostic::error(output.what.span, message));
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
                    low.diagnostics
                        .push(Diagnostic::error(written.span, message));
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
                low.diagnostics
                    .push(Diagnostic::warning(output.what.span, message));
                continue;
            }
            outputs
                .quantities
                .push(quantity(&label, &output.summary, &unit.dimension, &unit));
            outputs.values.push(*value);
            outputs
                .free
                .push(kind == Kind::Any && output.what.unit.is_none());
        }
    }
    low.begin(None);
    outputs
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
    let mut task = TaskValues {
        kind: SpanKind::Open,
        values: Vec::new(),
    };
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
            SceneItem::Sweep { .. } => (SpanKind::Sweep, Vec::new()),
            _ => continue,
        };
        if task.kind != SpanKind::Open {
            let place = terms.first().map(|term| term.span).unwrap_or_default();
            low.diagnostics.push(Diagnostic::error(
                place,
                "a scene has one task, and this is its second",
            ));
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
                    low.diagnostics
                        .push(Diagnostic::error(term.span, message).hint(match task.kind {
                            SpanKind::Run => "a time has a unit: `run time 0 s .. 3 s;`",
                            _ => "a period in terms of a speed `n` is `2*pi/n`",
                        }));
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
    low.diagnostics
        .push(Diagnostic::error(place, message).hint(hint));
}

/// Start values of the state vector; the mode in which the motion begins holds some coordinates.
pub fn start(
    low: &mut Lowering<'_>,
    names: &Names,
    scene: Option<&Scene>,
    needed: bool,
    held: &[usize],
) -> Vec<Expression> {
    let zero = low.graph.zero();
    let coordinates = names.coordinates.len();
    let mut start = vec![zero; 2 * coordinates + names.states.len()];
    let mut given = vec![false; start.len()];
    let mut places = Vec::new();
    for (index, declared) in names.coordinates.iter().enumerate() {
        let symbol = Symbol::Coordinate(index as u32);
        places.push((index, declared.what.start.clone(), low.kind_of(symbol)));
        let speed = over(low.kind_of(symbol), Kind::Of(second())).unwrap_or(Kind::Any);
        places.push((coordinates + index, declared.what.start_rate.clone(), speed));
        // A coordinate with a start value starts at rest unless it says more.
        given[coordinates + index] = declared.what.start.is_some();
    }
    for (index, declared) in names.states.iter().enumerate() {
        let symbol = Symbol::State(index as u32);
        places.push((
            2 * coordinates + index,
            declared.what.start.clone(),
            low.kind_of(symbol),
        ));
    }
    let own: Vec<_> = scene
        .iter()
        .flat_map(|scene| &scene.items)
        .filter_map(|item| {
            if let SceneItem::Start { values } = item {
                Some(values)
            } else {
                None
            }
        })
        .flatten()
        .cloned()
        .collect();
    let mut said: Vec<(usize, Span)> = Vec::new();
    for (target, value) in own {
        let found = low
            .scalar(&target)
            .map(|(value, kind)| (low.given_symbol(value), kind));
        let slot = match found {
            Some((Some(Symbol::Coordinate(index)), kind)) => Some((index as usize, kind)),
            Some((Some(Symbol::Speed(index)), kind)) => Some((coordinates + index as usize, kind)),
            Some((Some(Symbol::State(index)), kind)) => {
                Some((2 * coordinates + index as usize, kind))
            }
            Some(_) => {
                low.diagnostics.push(
                    Diagnostic::error(
                        target.span,
                        "only a coordinate, its `dot`, or a state can be started",
                    )
                    .hint("the rest follows from them"),
                );
                None
            }
            None => None,
        };
        let Some((slot, kind)) = slot else { continue };
        if let Some((_, earlier)) = said.iter().find(|(other, _)| *other == slot) {
            let message = format!("`{}` is started twice", print::term(&target));
            low.diagnostics.push(
                Diagnostic::error(target.span, message)
                    .related(*earlier, "the first time")
                    .hint("take one of the two away"),
            );
        }
        said.push((slot, target.span));
        places.push((slot, Some(value), kind));
    }
    let mut speeds: Vec<Option<Span>> = vec![None; coordinates];
    for (slot, term, kind) in places {
        let Some(term) = term else { continue };
        let Some((value, found)) = low.scalar(&term) else {
            continue;
        };
        if agree(found, kind).is_none() {
            let message = format!(
                "the start value of {} is {}",
                describe(kind.dimension()),
                describe(found.dimension())
            );
            let (name, of) = started(names, slot);
            let place = Diagnostic::error(term.span, message).related(of, "declared here");
            low.diagnostics.push(place.hint(fitting_value(kind, &name)));
        } else if !low.is_constant(value) {
            low.diagnostics.push(Diagnostic::error(
                term.span,
                "a start value can depend on constants alone",
            ));
        }
        start[slot] = value;
        given[slot] = true;
        if slot < coordinates {
            given[coordinates + slot] = true;
        } else if slot < 2 * coordinates {
            speeds[slot - coordinates] = Some(term.span);
        }
    }
    // What only another mode has begins with that mode.
    for (index, declared) in names.coordinates.iter().enumerate() {
        if names.absent.contains_key(&declared.name.text) {
            (start[index], start[coordinates + index]) = (zero, zero);
        }
    }
    for index in held.iter().filter(|index| **index < coordinates) {
        let speed = low.graph.as_number(start[coordinates + index]);
        if let (Some(place), Some(speed)) = (speeds[*index], speed)
            && speed != 0.0
        {
            let name = &names.coordinates[*index].name;
            let message = format!(
                "`{}` cannot start with a speed: the motion begins in a mode that holds it",
                name.text
            );
            low.diagnostics.push(
                Diagnostic::error(place, message)
                    .related(name.span, "declared here")
                    .hint(format!(
                        "start at rest, `start dot({}) = 0;`, or in another mode, `start mode;`",
                        name.text
                    )),
            );
        }
    }
    if needed {
        let all = names
            .coordinates
            .iter()
            .map(|one| (&one.name, 0))
            .chain(names.states.iter().map(|one| (&one.name, coordinates)));
        for (index, (name, skip)) in all.enumerate() {
            if !given[index + skip] && !names.absent.contains_key(&name.text) {
                low.diagnostics.push(
                    Diagnostic::error(
                        name.span,
                        format!(
                            "`{}` has no start value, and a scene runs from the start",
                            name.text
                        ),
                    )
                    .hint("write it after the unit, as in `coordinate x: m = 0;`"),
                );
            }
        }
    }
    start
}

/// Which component of the state vector has a start value, and where it is declared.
fn started(names: &Names, slot: usize) -> (String, Span) {
    let coordinates = names.coordinates.len();
    let (name, is_speed) = match slot {
        slot if slot < coordinates => (&names.coordinates[slot].name, false),
        slot if slot < 2 * coordinates => (&names.coordinates[slot - coordinates].name, true),
        slot => (&names.states[slot - 2 * coordinates].name, false),
    };
    match is_speed {
        true => (format!("dot({})", name.text), name.span),
        false => (name.text.clone(), name.span),
    }
}

/// The preset of a scene: its name and values.
pub fn preset(
    low: &mut Lowering<'_>,
    file: &File,
    scene: &Scene,
) -> Option<(String, Vec<(String, f64)>)> {
    let chosen = scene.items.iter().find_map(|item| {
        if let SceneItem::Preset { name } = item {
            Some(name)
        } else {
            None
        }
    })?;
    let all = file
        .statements
        .iter()
        .filter_map(|statement| match &statement.kind {
            StatementKind::Preset { name, values, .. } => Some((name, values)),
            _ => None,
        });
    let known: Vec<_> = all.collect();
    let Some((name, values)) = known.iter().find(|(name, _)| name.text == chosen.text) else {
        let report =
            Diagnostic::error(chosen.span, format!("there is no preset `{}`", chosen.text));
        low.diagnostics.push(
            match nearest(
                &chosen.text,
                known.iter().map(|(name, _)| name.text.as_str()),
            ) {
                Some(near) => report.hint(format!("did you mean `{near}`?")),
                None => report.hint("declare it with `preset NAME { … }`"),
            },
        );
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
        !self
            .graph
            .depends_on(value, |symbol| !matches!(symbol, Symbol::Parameter(_)))
    }

    /// The symbol that an expression is.
    pub fn given_symbol(&self, value: Expression) -> Option<Symbol> {
        match self.graph.node(value) {
            crate::expression::Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }
}
