//! Finding things by name, and the nearest name when there is none.

use std::path::Path;

use assur::registry::{Mechanism, SceneEntry};
use assur_model::asked::Asked;
use assur_model::nearest::nearest;

use crate::ask::{For, file};
use crate::error::Failure;
use crate::source::Wanted;

/// The mechanisms that the command knows.
#[derive(Clone, Copy)]
pub struct Registry(pub &'static [Mechanism]);

impl Registry {
    /// The mechanism of this name.
    ///
    /// # Errors
    /// When there is none, the nearest name being offered; without a name those that the command is for.
    pub fn mechanism(
        self,
        name: Option<&str>,
        command: &str,
        scenes: For,
    ) -> Result<&'static Mechanism, Failure> {
        let Some(name) = name else {
            return Err(match scenes {
                For::Linkages | For::Loops => {
                    name_one("linkage", command, self.linkages().collect())
                }
                For::Drawn => name_one("mechanism", command, self.drawn().collect()),
                _ => name_one("mechanism", command, self.0.iter().collect()),
            });
        };
        if file::is_file(name) {
            return file::mechanism(&file::read(name)?, Wanted::Scenes(Asked::All));
        }
        if let Some(found) = self.0.iter().find(|mechanism| mechanism.name == name) {
            return Ok(found);
        }
        let names: Vec<_> = self.0.iter().map(|mechanism| mechanism.name).collect();
        let what = match name.trim() {
            "" => "the name of the mechanism is empty".to_owned(),
            _ => format!("there is no mechanism `{name}`"),
        };
        let with_ending = format!("{name}.eqn");
        if Path::new(name).is_dir() {
            return Err(Failure::request(format!("`{name}` is a directory")).remedy(format!(
                "name one of its equation files; `assur list {name}` shows them with their scenes"
            )));
        }
        let files = [name, &with_ending].map(|name| Path::new(name).is_file());
        let failure = match files {
            [_, true] => Failure::request(what)
                .remedy(format!("a file is named with its ending: `{with_ending}` is here")),
            [true, _] => Failure::request(what).remedy(format!(
                "an equation file ends in `.eqn`: rename `{name}`, or give it as `./{name}`"
            )),
            _ => Failure::request(what),
        };
        Err(failure.remedy(format!(
            "{}\n`assur list` shows them with their scenes",
            suggestion(name, &names)
        )))
    }

    /// The mechanisms with at least one scene that can be drawn.
    fn drawn(self) -> impl Iterator<Item = &'static Mechanism> {
        self.0.iter().filter(|mechanism| mechanism.scenes.iter().any(|one| For::Drawn.suits(one)))
    }

    /// The mechanisms with at least one scene that is a linkage.
    fn linkages(self) -> impl Iterator<Item = &'static Mechanism> {
        self.0.iter().filter(|mechanism| {
            let mut scenes = mechanism.scenes.iter();
            scenes.any(|scene| scene.linkage.is_some())
        })
    }
}

fn name_one(what: &str, command: &str, list: Vec<&'static Mechanism>) -> Failure {
    let names = list.iter().map(|mechanism| mechanism.name.len());
    let width = names.max().unwrap_or(0);
    let mut remedy = String::from("name one of these");
    for mechanism in &list {
        let line = mechanism.summary.lines().next().unwrap_or("");
        remedy += &format!("\n  {:width$}  {line}", mechanism.name);
    }
    if let Some(first) = list.first() {
        remedy += &format!("\nfor example: assur {command} {}", first.name);
    }
    Failure::request(format!("`assur {command}` needs a {what}")).remedy(remedy)
}

/// The scene of this name, the first one if none is given.
///
/// # Errors
/// When there is none; the nearest name is offered.
pub fn scene(
    mechanism: &'static Mechanism,
    name: Option<&str>,
) -> Result<&'static SceneEntry, Failure> {
    let Some(name) = name else {
        return mechanism
            .scenes
            .first()
            .ok_or_else(|| Failure::request(format!("`{}` has no scene", mechanism.name)));
    };
    if let Some(found) = mechanism.scenes.iter().find(|scene| scene.name == name) {
        return Ok(found);
    }
    let names: Vec<_> = mechanism.scenes.iter().map(|scene| scene.name).collect();
    let mut failure = Failure::request(format!("`{}` has no scene `{name}`", mechanism.name))
        .place(format!("--scene {name}"));
    if let Some(words) = with_feature(mechanism, name) {
        failure = failure.reason(words);
    }
    Err(failure.remedy(format!(
        "{}\n`assur scenes {}` compares them",
        suggestion(name, &names),
        mechanism.name
    )))
}

/// That a scene is no linkage.
pub fn no_linkage(registry: Registry, mechanism: &Mechanism, found: &SceneEntry) -> Failure {
    let others = mechanism.scenes.iter();
    let others = others.filter(|scene| scene.linkage.is_some());
    let others: Vec<_> = others.map(|scene| scene.name).collect();
    let everywhere: Vec<_> = registry.linkages().map(|one| one.name).collect();
    Failure::request(format!("scene `{}` of `{}` is no linkage", found.name, mechanism.name))
        .reason(match found.reduced.is_some() || found.augmented.is_some() {
            true => "it moves by its equations of motion, whose coordinates its loops bind; a linkage is moved by drivers alone",
            false => "it moves by its equations of motion, and closes no loops",
        })
        .remedy(match (others.as_slice(), everywhere.as_slice()) {
            ([], []) => "no mechanism has a linkage yet".to_owned(),
            ([], names) => format!("linkages are in: {}", names.join(", ")),
            (names, _) => format!("choose one: --scene {}", names.join(", --scene ")),
        })
}

/// That a scene has no measures.
pub fn no_measures(mechanism: &Mechanism, found: &SceneEntry) -> Failure {
    Failure::request(format!(
        "scene `{}` of `{}` has no measures",
        found.name, mechanism.name
    ))
    .remedy(
        "a measure is stated in the equation file, `measure x_max = peak(x);`, and holds for scenes that run",
    )
}

/// Why there is nothing to seek in a scene.
pub fn no_synthesis(mechanism: &Mechanism, found: &SceneEntry) -> Failure {
    let what = format!("scene `{}` of `{}` varies nothing", found.name, mechanism.name);
    Failure::request(what).remedy(
        "a scene says what it seeks: `vary l1 in 5 mm .. 60 mm; minimise peak(abs(error));`",
    )
}

/// If the name is that of an effect, of a choice or of an alternative: which scenes have it.
pub fn with_feature(mechanism: &Mechanism, name: &str) -> Option<String> {
    let scenes = |has: &dyn Fn(&SceneEntry) -> bool| {
        let names: Vec<_> =
            mechanism.scenes.iter().filter(|scene| has(scene)).map(|scene| scene.name).collect();
        if names.is_empty() {
            "no scene has it".to_owned()
        } else {
            format!("--scene {}", names.join(" or --scene "))
        }
    };
    if mechanism.effects.iter().any(|effect| effect.name == name) {
        let which = scenes(&|scene| scene.effects.contains(&name));
        return Some(format!("`{name}` is an effect, which a scene has or has not: {which}"));
    }
    if let Some(choice) = mechanism.choices.iter().find(|choice| choice.name == name) {
        let mut text = format!("`{name}` is a choice, which a scene makes:");
        for alternative in choice.alternatives {
            let which = scenes(&|scene| scene.choices.contains(&(choice.name, alternative)));
            text += &format!("\n  {name}.{alternative}: {which}");
        }
        return Some(text);
    }
    let choice = mechanism.choices.iter().find(|choice| choice.alternatives.contains(&name))?;
    let which = scenes(&|scene| scene.choices.contains(&(choice.name, name)));
    Some(format!("`{name}` is an alternative of the choice `{}`: {which}", choice.name))
}

/// The nearest of the names, or all of them. A name of a part may lack the part, or have another one.
pub fn suggestion(wanted: &str, names: &[&str]) -> String {
    let last = |name: &str| name.rsplit('.').next().map(str::to_owned);
    let alike = names.iter().filter(|name| name.contains('.') && last(name) == last(wanted));
    let alike: Vec<_> = alike.map(|name| format!("`{name}`")).collect();
    if !alike.is_empty() {
        return format!("did you mean {}?", alike.join(" or "));
    }
    if let Some(nearest) = nearest(wanted, names.iter().copied()) {
        return format!("did you mean `{nearest}`?");
    }
    match names {
        [] => "there is none".to_owned(),
        [only] => format!("there is only `{only}`"),
        _ => format!("there are: {}", names.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check_nearest(wanted: &str, expected: Option<&str>) {
        assert_eq!(nearest(wanted, ["batten", "table_drive", "n", "m1"]), expected);
    }

    #[test]
    fn slips_find_their_name() {
        check_nearest("baten", Some("batten"));
        check_nearest("BATTEN", Some("batten"));
        check_nearest("abtten", Some("batten"));
        check_nearest("tabledrive", Some("table_drive"));
        check_nearest("N", Some("n"));
    }

    #[test]
    fn other_words_find_nothing() {
        check_nearest("gearbox", None);
        check_nearest("theta", None);
    }

    #[test]
    fn names_of_parts_are_found_without_their_part() {
        let names = ["lift.e_v", "lift.O1_x", "stitch.O1_x"];
        assert_eq!(suggestion("feed.e_v", &names), "did you mean `lift.e_v`?");
        let both = "did you mean `lift.O1_x` or `stitch.O1_x`?";
        assert_eq!(suggestion("O1_x", &names), both);
    }

    #[test]
    fn all_names_are_listed_when_none_is_near() {
        assert_eq!(suggestion("gearbox", &["a1", "b2"]), "there are: a1, b2");
        assert_eq!(suggestion("gearbox", &["a1"]), "there is only `a1`");
    }
}
