//! What a scene seeks: constants that are varied, conditions that are kept, and what is made small.
//!
//! A condition is kept by a margin, and a margin is a measure as any other: so is what is made small. A synthesis is
//! therefore a study of the scene that chooses its own values.

use crate::checked::{ConstantInfo, SceneModel, SynthesisInfo, VariedInfo};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::Symbol;
use crate::lower::Lowering;
use crate::nearest::nearest;
use crate::resolve::Names;
use crate::syntax::print;
use crate::syntax::tree::{
    BinaryOperator, Name, Output, Scene, SceneItem, Term, TermKind, UnitTerm, Varied,
};
use crate::token::Span;

/// Declares the measures that a scene makes small, and those by which it keeps its conditions, under their own texts.
pub fn declare(scene: Option<&Scene>, names: &mut Names, diagnostics: &mut Diagnostics) {
    for item in scene.into_iter().flat_map(|scene| &scene.items) {
        match item {
            SceneItem::Require { condition, text } => {
                let Some((margin, unit)) = margin(condition) else {
                    let message = "a synthesis keeps conditions between two numbers";
                    let report = Diagnostic::error(condition.span, message);
                    diagnostics.push(
                        report.hint(
                            "write `require peak(x) < 2 mm;`, each in a statement of its own",
                        ),
                    );
                    continue;
                };
                let name = Name { text: print::term(condition), span: condition.span };
                names.seek(name, margin, text.clone(), unit);
            }
            SceneItem::Minimise { what: Output { name: None, value: Some(value), unit, .. } } => {
                let name = Name { text: print::term(value), span: value.span };
                names.seek(name, value.clone(), None, unit.clone());
            }
            SceneItem::Minimise { what } if what.value.is_some() => {
                names.declare_measure(what, "", diagnostics);
            }
            _ => {}
        }
    }
}

/// By how much a condition is kept: the larger side less the smaller one, in the unit of the side that is a number.
fn margin(condition: &Term) -> Option<(Term, Option<UnitTerm>)> {
    let TermKind::Binary(operator, left, right) = &condition.kind else {
        return None;
    };
    let (larger, smaller) = match operator {
        BinaryOperator::Less | BinaryOperator::LessEqual => (right, left),
        BinaryOperator::Greater | BinaryOperator::GreaterEqual => (left, right),
        _ => return None,
    };
    let unit = [right, left].into_iter().find_map(|side| match &side.kind {
        TermKind::Number { unit, .. } => unit.clone(),
        TermKind::Unary(_, inner) => match &inner.kind {
            TermKind::Number { unit, .. } => unit.clone(),
            _ => None,
        },
        _ => None,
    });
    let kind = TermKind::Binary(BinaryOperator::Subtract, larger.clone(), smaller.clone());
    Some((Term { span: condition.span, kind }, unit))
}

/// What a scene seeks, by all constants of the file; none if it seeks nothing, or something is wrong.
pub fn read(
    scene: &Scene,
    model: &SceneModel,
    constants: &[Option<ConstantInfo>],
    low: &mut Lowering<'_>,
) -> Option<SynthesisInfo> {
    let (mut varied, mut conditions, mut objectives) = (Vec::new(), Vec::new(), Vec::new());
    for item in &scene.items {
        match item {
            SceneItem::Vary { constants } => varied.extend(constants),
            SceneItem::Require { condition, .. } => {
                conditions.push((print::term(condition), condition.span));
            }
            SceneItem::Minimise { what } => objectives.push((sought(what), what.span)),
            _ => {}
        }
    }
    let Some((objective, place)) = objectives.first().cloned() else {
        report_without(scene, &varied, &conditions, low);
        return None;
    };
    if let Some((_, second)) = objectives.get(1) {
        let report = Diagnostic::error(*second, "a scene makes one number small");
        let hint = "add the numbers up, each with a weight: `minimise peak(x) + 0.1*peak(y);`";
        low.diagnostics.push(report.related(place, "the first one").hint(hint));
        return None;
    }
    if varied.is_empty() {
        let report = Diagnostic::error(place, "nothing is varied that might make this small");
        low.diagnostics.push(report.hint("say what may change: `vary l1 in 5 mm .. 60 mm;`"));
        return None;
    }
    let objective = found(&objective, place, model, low)?;
    let conditions = conditions.iter().map(|(name, place)| found(name, *place, model, low));
    let conditions = conditions.collect::<Option<_>>()?;
    let mut all: Vec<VariedInfo> = Vec::new();
    for one in varied {
        let info = bounds(one, constants, low)?;
        if all.iter().any(|other| other.name == info.name) {
            let message = format!("`{}` is varied twice", info.name);
            low.diagnostics.push(Diagnostic::error(one.constant.span, message));
            return None;
        }
        all.push(info);
    }
    Some(SynthesisInfo { varied: all, conditions, objective })
}

/// The name of the measure that is made small.
fn sought(what: &Output) -> String {
    match (&what.name, &what.value) {
        (Some(target), _) => target.name.text.clone(),
        (None, value) => value.as_ref().map(print::term).unwrap_or_default(),
    }
}

/// Reports what says something of a synthesis that makes nothing small.
fn report_without(
    scene: &Scene,
    varied: &[&Varied],
    conditions: &[(String, Span)],
    low: &mut Lowering<'_>,
) {
    let first = varied.first().map(|one| one.constant.span);
    let Some(place) = first.or(conditions.first().map(|one| one.1)) else {
        return;
    };
    let message = format!("the scene `{}` does not say what is to be small", scene.name.text);
    let hint =
        "add `minimise peak(abs(error));`; what any design has to keep stands outside the scenes";
    low.diagnostics.push(Diagnostic::error(place, message).hint(hint));
}

/// The place of a measure.
fn found(name: &str, place: Span, model: &SceneModel, low: &mut Lowering<'_>) -> Option<usize> {
    let names = || model.measures.iter().map(|one| one.quantity.name.as_str());
    if let Some(index) = names().position(|one| one == name) {
        return Some(index);
    }
    let report = Diagnostic::error(place, format!("this scene has no measure `{name}`"));
    let otherwise =
        "it needs a task of which this is a number: `sweep phi;` or `run time 0 s .. 1 s;`";
    low.diagnostics.push(report.meant(nearest(name, names()), otherwise.to_owned()));
    None
}

/// Between which values a constant is varied.
fn bounds(
    one: &Varied,
    constants: &[Option<ConstantInfo>],
    low: &mut Lowering<'_>,
) -> Option<VariedInfo> {
    let name = &one.constant;
    let names = low.names;
    let known = || names.constants.iter().map(|constant| constant.name.text.as_str());
    let Some(index) = known().position(|constant| constant == name.text) else {
        let message = format!("there is no dimension or parameter `{}`", name.text);
        let report = Diagnostic::error(name.span, message);
        let otherwise = "constants are varied: what follows from them follows";
        low.diagnostics.push(report.meant(nearest(&name.text, known()), otherwise.to_owned()));
        return None;
    };
    let kind = low.kind_of(Symbol::Parameter(index as u32));
    let what = format!("`{}`", name.text);
    let declared = constants[index].as_ref()?.range;
    let (from, to) = match &one.range {
        Some((from, to)) => {
            let ends = (low.fixed_of(from, kind, &what)?, low.fixed_of(to, kind, &what)?);
            let place = from.span.to(to.span);
            if ends.0 >= ends.1 {
                let message = "the range is empty: its lower end is not below its upper end";
                low.diagnostics.push(Diagnostic::error(place, message));
                return None;
            }
            if ends.0 < declared.0 || ends.1 > declared.1 {
                let message = format!("{what} is not permitted everywhere in this range");
                let report = Diagnostic::error(place, message);
                low.diagnostics.push(report.related(
                    names.constants[index].name.span,
                    "declared here, with its permitted range",
                ));
                return None;
            }
            ends
        }
        None => declared,
    };
    if !(from.is_finite() && to.is_finite()) {
        let message = format!("nothing says between which values {what} is varied");
        let hint = format!("write `vary {} in lowest .. highest;`", name.text);
        low.diagnostics.push(Diagnostic::error(name.span, message).hint(hint));
        return None;
    }
    Some(VariedInfo { name: name.text.clone(), place: name.span, constant: 0, from, to })
}

/// Finds the constants that are varied among those of a whole scene, and reports those that change nothing in it.
pub fn settle(model: &mut SceneModel, diagnostics: &mut Diagnostics) {
    let varied = model.synthesis.iter_mut().flat_map(|synthesis| &mut synthesis.varied);
    for one in varied {
        let mut constants = model.constants.iter();
        match constants.position(|constant| constant.quantity.name == one.name) {
            Some(index) => one.constant = index,
            None => {
                let message =
                    format!("nothing in the scene `{}` depends on `{}`", model.name, one.name);
                diagnostics.push(Diagnostic::error(one.place, message).hint("leave it out"));
            }
        }
    }
}
