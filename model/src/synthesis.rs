//! What a scene seeks: constants that are varied, conditions that are kept, and what is made small.
//!
//! A condition is kept by a margin, and a margin is a measure as any other: so is what is made small. A synthesis is
//! therefore a study of the scene that chooses its own values.

mod solved;
mod squares;
mod varied;

pub use solved::{Condition, read as condition};
pub use squares::read as squares;
pub use varied::{check_modes, settle};

use varied::bounds;

use crate::checked::{ConstantInfo, SceneModel, SynthesisInfo, VariedInfo};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::homogeneity::describe;
use crate::linkage::Linkage;
use crate::lower::{Kind, Lowering};
use crate::nearest::nearest;
use crate::resolve::Names;
use crate::syntax::print;
use crate::syntax::tree::{
    BinaryOperator, Name, Output, Scene, SceneItem, Term, TermKind, UnitTerm, Varied,
};
use crate::token::Span;
use crate::unit::{Dimension, Unit};

/// Declares the measures that a scene makes small, and those by which it keeps its conditions, under their own texts.
pub fn declare(scene: Option<&Scene>, names: &mut Names, diagnostics: &mut Diagnostics) {
    for item in scene.into_iter().flat_map(|scene| &scene.items) {
        match item {
            SceneItem::Require { condition, text } | SceneItem::Prefer { condition, text, .. } => {
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
    (constants, linkage): (&[Option<ConstantInfo>], &Linkage),
    (condition, squares): (Option<Condition>, Vec<usize>),
    low: &mut Lowering<'_>,
) -> Option<SynthesisInfo> {
    let (mut varied, mut objectives) = (Vec::new(), Vec::new());
    let (mut conditions, mut preferences) = (Vec::new(), Vec::new());
    for item in &scene.items {
        match item {
            SceneItem::Vary { constants } => varied.extend(constants),
            SceneItem::Require { condition, .. } => {
                conditions.push((print::term(condition), condition.span));
            }
            SceneItem::Prefer { condition, weight, .. } => {
                preferences.push((print::term(condition), condition.span, weight));
            }
            SceneItem::Minimise { what } => objectives.push((sought(what), what.span)),
            _ => {}
        }
    }
    // What is solved for while designs are sought is varied as all others when one is polished.
    varied.extend(solved::constants(scene));
    let Some((objective, place)) = objectives.first().cloned() else {
        conditions.extend(preferences.iter().map(|(name, place, _)| (name.clone(), *place)));
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
    let conditions: Vec<usize> = conditions.collect::<Option<_>>()?;
    let preferences = preferences.iter().map(|(name, place, weight)| {
        let measure = found(name, *place, model, low)?;
        if conditions.contains(&measure) {
            let report = Diagnostic::error(*place, "what is required is preferred as well");
            low.diagnostics.push(report.hint("leave one of the two out"));
            return None;
        }
        Some((measure, priced((measure, objective), (*place, weight.as_ref()), model, low)?))
    });
    let preferences = preferences.collect::<Option<_>>()?;
    let mut all: Vec<VariedInfo> = Vec::new();
    for one in varied {
        let info = bounds(one, constants, low)?;
        if all.iter().any(|other| other.name == info.name) {
            let message = format!("`{}` is varied twice", info.name);
            low.diagnostics.push(Diagnostic::error(info.place, message));
            return None;
        }
        all.push(info);
    }
    let solved = match condition {
        Some(condition) => Some(condition.solved(all.len(), linkage, low)?),
        None => None,
    };
    Some(SynthesisInfo { varied: all, conditions, preferences, objective, squares, solved })
}

/// What a preference that is missed costs, per unit of what it is missed by: in the unit of what is made small.
fn priced(
    (measure, objective): (usize, usize),
    (place, weight): (Span, Option<&Term>),
    model: &SceneModel,
    low: &mut Lowering<'_>,
) -> Option<f64> {
    let (value, kind) = match weight {
        Some(weight) => low.fixed(weight)?,
        None => (1.0, Kind::NUMBER),
    };
    let place = weight.map_or(place, |weight| weight.span);
    let dimension = |measure: usize| Dimension::of(model.measures[measure].quantity.dimension);
    let [missed, small] = [measure, objective].map(dimension);
    if kind.dimension().mul(&missed) != Some(small) {
        let ratio =
            small.div(&missed).map_or_else(String::new, |one| Unit::for_dimension(&one).symbol);
        let [missed, small] = [missed, small].map(describe);
        let message = format!(
            "this is missed by {missed}, and what is made small is {small}: the weight says what the one is worth in the other"
        );
        let hint = format!("give it in {ratio}: `prefer … < … weight 0.2 [{ratio}];`");
        low.diagnostics.push(Diagnostic::error(place, message).hint(hint));
        return None;
    }
    if value <= 0.0 {
        let report =
            Diagnostic::error(place, format!("a weight is above zero, and this is {value}"));
        low.diagnostics.push(report);
        return None;
    }
    Some(value)
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
    let first = varied.first().map(|one| one.constant.name.span);
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
