//! All combinations of what a scene shows: each subset of its effects, with each alternative of the choices that remain.

use crate::asked::CHANGES;
use crate::diagnostic::Diagnostics;
use crate::scene::{Selected, Survey};
use crate::syntax::tree::{Name, Scene, Selection};

/// Most combinations that are compiled.
pub const MOST: usize = 1024;

/// The scene as each of the combinations that it makes possible, itself among them, named by what they show; how many there
/// would be at least, where that is too many.
///
/// An effect or a choice that stands inside another one is only there with that. What does not hold in a combination stands
/// at its default, so that no two of them are the same. With names in `among` all others stay as they are.
///
/// # Errors
/// The number.
pub fn of(base: &Scene, among: &[&str], survey: &Survey<'_>) -> Result<Vec<Scene>, usize> {
    let Some(whole) = Selected::by(base, survey, &mut Diagnostics::default()) else {
        return Ok(Vec::new());
    };
    let differs = |name: &str| among.is_empty() || among.contains(&name);
    let mut all = vec![Selected::defaults(survey)];
    let mut left: Vec<&str> = survey.names().collect();
    while !left.is_empty() {
        // What stands in nothing that is still to be decided.
        let (ready, waiting): (Vec<&str>, Vec<&str>) =
            left.iter().partition(|name| !survey.around(name).any(|outer| left.contains(&outer)));
        // Nothing stands inside itself.
        if ready.is_empty() {
            break;
        }
        for name in ready {
            let extended = all.iter().flat_map(|one| {
                let mut more = Vec::new();
                if one.holds_around(name, survey) {
                    let alternatives = survey.alternatives(name).filter(|alternative| {
                        let own = whole.choices.get(name);
                        differs(name) || own.is_some_and(|own| own == alternative)
                    });
                    more.extend(alternatives.map(|alternative| one.choosing(name, alternative)));
                    if whole.effects.contains(name) {
                        more.extend(differs(name).then(|| one.clone()));
                        more.push(one.showing(name));
                    }
                }
                if more.is_empty() { vec![one.clone()] } else { more }
            });
            all = extended.collect();
            if all.len() > MOST {
                return Err(all.len());
            }
        }
        left = waiting;
    }
    Ok(all.iter().map(|selected| scene(base, selected, survey)).collect())
}

/// The scene with another selection.
fn scene(base: &Scene, selected: &Selected, survey: &Survey<'_>) -> Scene {
    let name = |text: &str| Name { text: text.to_owned(), span: base.name.span };
    let effects = selected.effects.iter();
    let effects = effects.map(|effect| Selection { name: name(effect), alternative: None });
    let choices = selected.choices.iter();
    let choices = choices.filter(|(choice, _)| selected.holds_around(choice, survey));
    let choices = choices.map(|(choice, alternative)| Selection {
        name: name(choice),
        alternative: Some(name(alternative)),
    });
    let selection: Vec<_> = effects.chain(choices).collect();
    let words = selection.iter().map(|one| match &one.alternative {
        Some(alternative) => format!("{}.{}", one.name.text, alternative.text),
        None => one.name.text.clone(),
    });
    let words: Vec<_> = words.collect();
    let text = if words.is_empty() { CHANGES.to_owned() } else { words.join(" + ") };
    Scene { name: name(&text), text: None, selection, ..base.clone() }
}
