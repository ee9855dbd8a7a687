//! Constants that are varied, and between which values.

use crate::checked::{ConstantInfo, SceneModel, VariedInfo};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::Symbol;
use crate::lower::Lowering;
use crate::nearest::nearest;
use crate::syntax::tree::{Among, Varied};
use crate::unroll::target_name;

/// Between which values a constant is varied.
pub fn bounds(
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
