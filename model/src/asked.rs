//! Which scenes of a file are compiled: all of them, some, or one that is made of another.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::scene::Survey;
use crate::syntax::parser::Changes;
use crate::syntax::print;
use crate::syntax::tree::{Name, Scene, SceneItem, Selection};
use crate::token::Token;

/// The path under which changes of a scene are known among the files of parts.
pub const CHANGES: &str = "the command line";

/// The name of a scene that is made of another.
pub const UNNAMED: &str = "unnamed";

/// What is asked for of a file.
#[derive(Clone, Copy, Debug)]
pub enum Asked<'a> {
    /// All scenes, and whatever else is wrong in the file.
    All,
    /// The scenes of these names; the first one where there are none.
    Some(&'a [&'a str]),
    /// The scene of a name, or the first one, with changes: `with damping; without coupling; with crank.exact;`, and
    /// statements of scenes, `run time 0 s .. 2 s;`, that take the places of its own.
    Changed(Option<&'a str>, &'a [Token]),
    /// The scene of a name, or the first one, as each of the combinations that its effects and all choices make possible and
    /// that balance; those of the names of a list alone, if it has any. What is wrong in the others is not told.
    Combinations(Option<&'a str>, &'a [&'a str]),
}

impl Asked<'_> {
    /// Whether everything is compiled, so that what is missing is missing everywhere.
    pub fn is_all(self) -> bool {
        matches!(self, Self::All)
    }

    /// Whether the scene of a name is compiled.
    pub fn has(self, index: usize, name: &str) -> bool {
        match self {
            Self::All => true,
            Self::Some([]) => index == 0,
            Self::Some(names) => names.contains(&name),
            Self::Changed(..) | Self::Combinations(..) => false,
        }
    }
}

/// A scene with changes; none where they speak of what the file does not have, which is reported.
pub fn changed(
    base: &Scene,
    changes: Changes,
    survey: &Survey<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Scene> {
    let mut scene = Scene {
        name: Name { text: UNNAMED.to_owned(), span: base.name.span },
        text: None,
        ..base.clone()
    };
    for without in &changes.without {
        if !is_effect(without, survey, diagnostics) {
            return None;
        }
        scene
            .selection
            .retain(|one| one.alternative.is_some() || one.name.text != without.name.text);
    }
    for with in changes.with {
        let is_other = |one: &Selection| one.name.text != with.name.text;
        scene.selection.retain(is_other);
        scene.selection.push(with);
    }
    let is_task = |item: &SceneItem| {
        matches!(
            item,
            SceneItem::Periodic { .. }
                | SceneItem::Run { .. }
                | SceneItem::Rest { .. }
                | SceneItem::Sweep { .. }
        )
    };
    if changes.items.iter().any(is_task) {
        scene.items.retain(|item| !is_task(item));
    }
    if changes.items.iter().any(|item| matches!(item, SceneItem::StartIn { .. })) {
        scene.items.retain(|item| !matches!(item, SceneItem::StartIn { .. }));
    }
    let started = changes.items.iter().filter_map(|item| match item {
        SceneItem::Start { values } => Some(values),
        _ => None,
    });
    let started: Vec<String> = started.flatten().map(|(target, _)| print::term(target)).collect();
    for item in &mut scene.items {
        if let SceneItem::Start { values } = item {
            values.retain(|(target, _)| !started.contains(&print::term(target)));
        }
    }
    scene.items.retain(|item| !matches!(item, SceneItem::Start { values } if values.is_empty()));
    scene.items.extend(changes.items);
    Some(scene)
}

/// Whether something is an effect of the file; reports it where it is not.
fn is_effect(selection: &Selection, survey: &Survey<'_>, diagnostics: &mut Diagnostics) -> bool {
    let name = &selection.name;
    let mut effects = survey.effects.iter().map(|effect| effect.0.text.as_str());
    if selection.alternative.is_none() && effects.clone().any(|one| one == name.text) {
        return true;
    }
    let report = Diagnostic::error(name.span, format!("there is no effect `{}`", name.text));
    let near = nearest(&name.text, effects.clone());
    let known: Vec<&str> = effects.by_ref().collect();
    let otherwise = match known.as_slice() {
        [] => "the file has no effects".to_owned(),
        known => format!("the file has {}", known.join(", ")),
    };
    diagnostics.push(report.meant(near, otherwise));
    false
}
