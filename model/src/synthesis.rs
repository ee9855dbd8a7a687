//! What a scene seeks: constants that are varied, conditions that are kept, and what is made small.
//!
//! A condition is kept by a margin, and a margin is a measure as any other: so is what is made small. A synthesis is
//! therefore a study of the scene that chooses its own values.

mod solved;

pub use solved::{Condition, read as condition};

use crate::checked::{ConstantInfo, SceneModel, SynthesisInfo, VariedInfo};
use crate::declare::quantity;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::Symbol;
use crate::homogeneity::describe;
use crate::linkage::Linkage;
use crate::lower::{Kind, Lowering};
use crate::measures::Measures;
use crate::nearest::nearest;
use crate::resolve::Names;
use crate::syntax::print;
use crate::syntax::tree::{
    Among, BinaryOperator, Name, Output, Scene, SceneItem, Term, TermKind, UnitTerm, Varied,
};
use crate::token::Span;
use crate::unit::{Dimension, Unit};
use crate::unroll::target_name;

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

/// Adds the measures of whose squares what a scene makes small is the sum, and says which they are; none if it is no sum of
/// squares. Polishing then knows each of them, where the sum alone hides how they change.
pub fn squares(scene: &Scene, measures: &mut Measures, low: &mut Lowering<'_>) -> Vec<usize> {
    let mut all = scene.items.iter().filter_map(|item| match item {
        SceneItem::Minimise { what } => Some(what),
        _ => None,
    });
    let Some(what) = all.next() else { return Vec::new() };
    let (objective, is_named) = (sought(what), what.name.is_some());
    let mut quantities = measures.quantities.iter();
    let Some(index) = quantities.position(|one| one.name == objective) else { return Vec::new() };
    let dimension = measures.kinds[index].dimension().pow(1, 2);
    let terms = low.graph.squares(measures.values[index]);
    let (Some(terms), Some(dimension)) = (terms, dimension) else { return Vec::new() };
    let (unit, first) = (Unit::for_dimension(&dimension), measures.values.len());
    let what = if is_named { objective.as_str() } else { "misfit" };
    for (index, term) in terms.into_iter().enumerate() {
        let text = format!("one of the numbers of whose squares {objective} is the sum");
        let quantity = quantity(&format!("{what} {}", index + 1), &text, &dimension, &unit);
        measures.add(quantity, Kind::Of(dimension), term, low);
    }
    (first..measures.values.len()).collect()
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

/// Between which values a constant is varied.
fn bounds(
    one: &Varied,
    constants: &[Option<ConstantInfo>],
    low: &mut Lowering<'_>,
) -> Option<VariedInfo> {
    let name = &target_name(&one.constant, low.diagnostics)?;
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
    let mut values = Vec::new();
    let ((from, to), place) = match &one.among {
        Among::Permitted => (declared, name.span),
        Among::Range(from, to) => {
            let ends = (low.fixed_of(from, kind, &what)?, low.fixed_of(to, kind, &what)?);
            let place = from.span.to(to.span);
            if ends.0 >= ends.1 {
                let message = "the range is empty: its lower end is not below its upper end";
                low.diagnostics.push(Diagnostic::error(place, message));
                return None;
            }
            (ends, place)
        }
        Among::Values(terms) => {
            for term in terms {
                values.push(low.fixed_of(term, kind, &what)?);
            }
            values.sort_by(f64::total_cmp);
            values.dedup();
            let place = terms[0].span.to(terms[terms.len() - 1].span);
            if values.len() < 2 {
                let report = Diagnostic::error(place, "there is nothing to choose from");
                let hint = format!("give two values or more: `vary {} in {{-1, 1}};`", name.text);
                low.diagnostics.push(report.hint(hint));
                return None;
            }
            ((values[0], values[values.len() - 1]), place)
        }
    };
    if from < declared.0 || to > declared.1 {
        let message = format!("{what} is not permitted everywhere in this range");
        let report = Diagnostic::error(place, message);
        low.diagnostics.push(
            report.related(
                names.constants[index].name.span,
                "declared here, with its permitted range",
            ),
        );
        return None;
    }
    if !(from.is_finite() && to.is_finite()) {
        let message = format!("nothing says between which values {what} is varied");
        let hint = format!("write `vary {} in lowest .. highest;`", name.text);
        low.diagnostics.push(Diagnostic::error(name.span, message).hint(hint));
        return None;
    }
    Some(VariedInfo { name: name.text.clone(), place: name.span, constant: 0, from, to, values })
}

/// Reports values that a motion cannot choose from: those that pick the assembly mode of loops which it carries along, of which it
/// keeps that of the file. The last requirements of the scene, so many, say that.
pub fn check_modes(model: &SceneModel, modes: usize, low: &mut Lowering<'_>) {
    let kept = &model.requirements[model.requirements.len() - modes..];
    let varied = model.synthesis.iter().flat_map(|synthesis| &synthesis.varied);
    for one in varied.filter(|one| !one.values.is_empty()) {
        let is_it = |index: &usize| model.constants[*index].quantity.name == one.name;
        if let Some(loops) = kept.iter().find(|requirement| requirement.names.iter().any(is_it)) {
            let message = format!(
                "`{}` picks the assembly mode of {}, and a scene with coordinates keeps the one that the file picks",
                one.name, loops.message
            );
            let report = Diagnostic::error(one.place, message);
            low.diagnostics
                .push(report.hint("state a file, or a preset and a scene, for each mode"));
        }
    }
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
