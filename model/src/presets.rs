//! Presets, and facts about scenes and presets.

use std::collections::BTreeSet;

use crate::checked::PresetInfo;
use crate::compile::Seen;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::homogeneity::{agree, unlike};
use crate::lower::Lowering;
use crate::nearest::nearest;
use crate::syntax::tree::{File, Name, Scene, StatementKind, Target, Term, is_unread};
use crate::unroll;

/// Facts about scenes that do not exist.
pub fn check_facts(file: &File, scenes: &[(&Scene, &[String])], diagnostics: &mut Diagnostics) {
    let presets: Vec<&str> = file
        .statements
        .iter()
        .filter_map(|statement| {
            if let StatementKind::Preset { name, .. } = &statement.kind {
                Some(name.text.as_str())
            } else {
                None
            }
        })
        .collect();
    for statement in &file.statements {
        let StatementKind::Expect(expect) = &statement.kind else {
            continue;
        };
        let wanted = [
            (
                expect.scene.as_ref(),
                "scene",
                scenes.iter().map(|(scene, _)| scene.name.text.as_str()).collect::<Vec<_>>(),
            ),
            (expect.preset.as_ref(), "preset", presets.clone()),
        ];
        for (name, what, known) in wanted {
            let missing = |name: &&Name| {
                !known.contains(&name.text.as_str()) && !is_unread(&file.unread, &name.text)
            };
            let Some(name) = name.filter(missing) else {
                continue;
            };
            let report =
                Diagnostic::error(name.span, format!("there is no {what} `{}`", name.text));
            let near = nearest(&name.text, known.iter().copied());
            let otherwise = format!("the file declares {}", known.join(", "));
            diagnostics.push(report.meant(near, otherwise));
        }
    }
}

/// The presets, with every name and unit checked against the constants of any scene; where not all are compiled, what none
/// of these has is left out.
pub fn read(
    file: &File,
    (seen, is_all): (&Seen, bool),
    diagnostics: &mut Diagnostics,
) -> Vec<PresetInfo> {
    let mut list = Vec::new();
    for statement in &file.statements {
        let StatementKind::Preset { name, text, values } = &statement.kind else {
            continue;
        };
        let documentation = || statement.documentation.join("\n").trim().to_string();
        let values = values.iter();
        let values = values.filter_map(|one| value(one, &file.unread, (seen, is_all), diagnostics));
        list.push(PresetInfo {
            name: name.text.clone(),
            summary: text.clone().unwrap_or_else(documentation),
            values: values.collect(),
        });
    }
    list
}

/// Name and value of a constant in a preset.
fn value(
    (target, term): &(Target, Term),
    unread: &BTreeSet<String>,
    (seen, is_all): (&Seen, bool),
    diagnostics: &mut Diagnostics,
) -> Option<(String, f64)> {
    let Name { text: name, span } = unroll::target_name(target, diagnostics)?;
    let Some((kind, declared)) = seen.constants.get(&name) else {
        if is_all && !is_unread(unread, &name) {
            let message = format!("there is no dimension or parameter `{name}`");
            let mut report = Diagnostic::error(span, message);
            if let Some(near) = nearest(&name, seen.constants.keys().map(String::as_str)) {
                report = report.hint(format!("did you mean `{near}`?"));
            }
            diagnostics.push(report);
        }
        return None;
    };
    let (nothing, survey, selected) = Default::default();
    let budget = seen.budget.clone();
    let mut low = Lowering::new(&nothing, &survey, &selected, diagnostics, budget);
    let (value, found) = low.fixed(term)?;
    if agree(found, *kind).is_none() {
        let message = unlike(&format!("`{name}`"), *kind, found);
        let report = Diagnostic::error(term.span, message);
        diagnostics.push(report.related(*declared, "declared here"));
        return None;
    }
    Some((name, value))
}
