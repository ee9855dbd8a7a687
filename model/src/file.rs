//! A file from its tokens to all that it holds: parts in their places, effects and scenes surveyed, each scene compiled.

use std::collections::BTreeSet;

use crate::asked::{self, Asked};
use crate::checked::{ChoiceInfo, Compiled, Described, Model, PartFile, SceneModel};
use crate::combinations;
use crate::compile::{Seen, Task};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{self, Budget};
use crate::flatten::{self, Loader};
use crate::joined;
use crate::presets;
use crate::scene::{Selected, Survey};
use crate::syntax;
use crate::syntax::parser::Changes;
use crate::syntax::tree::{File, Scene};
use crate::synthesis;
use crate::token::{Span, Token};

/// Compiles the tokens of a mechanism on this thread.
pub fn compile(tokens: &[Token], asked: Asked<'_>, loader: &mut Loader<'_>) -> Compiled {
    let mut diagnostics = Diagnostics::default();
    let Some(mut file) = syntax::parser::parse(tokens, 0, &mut diagnostics) else {
        return Compiled {
            name: String::new(),
            scene_names: Vec::new(),
            model: None,
            diagnostics: diagnostics.into_sorted(),
            parts: Vec::new(),
            steps: 0,
        };
    };
    let (changes, first) = changes(asked, tokens.len(), &mut diagnostics);
    let mut parts = flatten::flatten(&mut file, first, loader, &mut diagnostics);
    if changes.is_some() {
        let (path, place) = (asked::CHANGES.to_owned(), file.name.span);
        parts.insert(0, PartFile { path, first: tokens.len() as u32, place });
    }
    let survey = Survey::of(&file, &mut diagnostics);
    let implicit = implicit_scene(&file);
    let mut scenes: Vec<Documented<'_>> = survey.scenes.clone();
    if scenes.is_empty() {
        scenes.push((&implicit, &[]));
    }
    let mut seen = Seen::new();
    let base = match asked {
        Asked::Changed(Some(name), _) | Asked::Combinations(Some(name), _) => {
            scenes.iter().find(|(one, _)| one.name.text == name)
        }
        _ => scenes.first(),
    };
    let other = match (changes, base) {
        (Some(changes), Some((base, _))) => {
            asked::changed(base, changes, &survey, &mut diagnostics)
        }
        _ => None,
    };
    let which = (&scenes[..], other.as_ref(), asked);
    let models = match (asked, base) {
        (Asked::Combinations(_, among), Some((base, _))) => {
            combined(&file, &survey, (base, among), &mut seen, &mut diagnostics)
        }
        _ => compile_scenes(&file, &survey, which, &mut seen, &mut diagnostics),
    };
    presets::check_facts(&file, &scenes, &mut diagnostics);
    let presets =
        expression::within(|| presets::read(&file, (&seen, asked.is_all()), &mut diagnostics));
    if !diagnostics.has_errors() && asked.is_all() {
        report_unused(&seen, &mut diagnostics);
    }
    let model = (!diagnostics.has_errors()).then(|| Model {
        name: file.name.text.clone(),
        documentation: file.documentation.join("\n").trim().to_string(),
        source: file.source.clone().unwrap_or_default(),
        effects: effects(&survey),
        choices: choices(&survey),
        presets: presets.unwrap_or_default(),
        scenes: models,
    });
    let names = scenes.iter().map(|(scene, _)| scene.name.text.clone());
    Compiled {
        name: file.name.text.clone(),
        scene_names: names.collect(),
        model,
        diagnostics: diagnostics.into_sorted(),
        parts,
        steps: seen.budget.spent(),
    }
}

/// A scene with its documentation.
type Documented<'a> = (&'a Scene, &'a [String]);

/// The changes that are asked for, and what the first token behind them is counted as.
fn changes(
    asked: Asked<'_>,
    tokens: usize,
    diagnostics: &mut Diagnostics,
) -> (Option<Changes>, usize) {
    match asked {
        Asked::Changed(_, own) => {
            let changes = syntax::parser::parse_changes(own, tokens as u32, diagnostics);
            (Some(changes), tokens + own.len())
        }
        _ => (None, tokens),
    }
}

/// Compiles the scenes that are asked for; with all of them what none shows.
fn compile_scenes(
    file: &File,
    survey: &Survey<'_>,
    (scenes, other, asked): (&[Documented<'_>], Option<&Scene>, Asked<'_>),
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Vec<SceneModel> {
    let mut models = Vec::new();
    let mut shown = BTreeSet::new();
    let named = scenes.iter().copied().enumerate();
    let named = named.filter(|(index, (scene, _))| asked.has(*index, &scene.name.text));
    let other = other.map(|scene| (scenes.len(), (scene, &[][..])));
    for (index, (scene, documentation)) in named.chain(other) {
        let Some(selected) = Selected::by(scene, survey, diagnostics) else {
            continue;
        };
        let task = Task {
            file,
            survey,
            selected: &selected,
            scene: Some((scene, documentation)),
            is_first: index == 0,
            is_unreduced: false,
        };
        models.extend(scene_within(&task, seen, diagnostics));
        shown.insert(selected);
    }
    if asked.is_all() {
        check_unshown(file, survey, &shown, seen, diagnostics);
    }
    models
}

/// Compiles the combinations that a scene makes possible. One that does not balance, or does not have what the scene reports,
/// is none.
fn combined(
    file: &File,
    survey: &Survey<'_>,
    (base, among): (&Scene, &[&str]),
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Vec<SceneModel> {
    let all = combinations::of(base, among, survey).unwrap_or_else(|count| {
        let most = combinations::MOST;
        let message = format!("`{}` has {count} combinations or more", base.name.text);
        let hint =
            format!("at most {most} are compiled: name those effects and choices that may differ");
        diagnostics.push(Diagnostic::error(base.name.span, message).hint(hint));
        Vec::new()
    });
    let models = all.iter().filter_map(|scene| {
        let selected = Selected::by(scene, survey, diagnostics)?;
        let task = Task {
            file,
            survey,
            selected: &selected,
            scene: Some((scene, &[])),
            is_first: false,
            is_unreduced: false,
        };
        // Each of them may take as much as a file, and what is wrong in one is not wrong in the file.
        let (mut own, mut told) = (Seen::new(), Diagnostics::default());
        let model = scene_within(&task, &mut own, &mut told);
        seen.constants.extend(own.constants);
        model.filter(|_| !told.has_errors())
    });
    models.collect()
}

/// Compiles one scene, unless the file has come to more than is allowed.
fn scene_within(
    task: &Task<'_>,
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Option<SceneModel> {
    if seen.budget.is_exhausted() {
        return None;
    }
    let budget = seen.budget.clone();
    let result = expression::within(|| {
        let mut model = joined::scene(task, seen, diagnostics)?;
        synthesis::settle(&mut model, diagnostics);
        if model.may_stop {
            model.unreduced = unreduced(task).map(Box::new);
        }
        Some(model)
    });
    result.unwrap_or_else(|| {
        diagnostics.push(too_large(&budget, task));
        None
    })
}

/// A motion that may come to a dead point once more, with all positions as coordinates; none where that grows too large. What
/// is wrong in the file has been said.
fn unreduced(task: &Task<'_>) -> Option<SceneModel> {
    let task = Task { is_unreduced: true, ..*task };
    let compile = || joined::scene(&task, &mut Seen::new(), &mut Diagnostics::default());
    let model = expression::within(compile).flatten()?;
    model.augmented.is_some().then_some(model)
}

/// Says which statement takes the most steps, or that a whole scene is too much.
fn too_large(budget: &Budget, task: &Task<'_>) -> Diagnostic {
    let limit = expression::STEPS / 1_000_000;
    let scene = task.scene.map_or(task.file.name.span, |(scene, _)| scene.name.span);
    match budget.largest() {
        Some(statement) => Diagnostic::error(
            statement,
            format!("this statement grows too large: most of the {limit} million steps that a file may take go into it"),
        )
        .hint("each derivative of a derivative and each function that calls another one twice doubles it: take fewer, or make what repeats a coordinate, a state or a driver of its own"),
        None => Diagnostic::error(
            scene,
            format!("the file is too large: with this scene it takes more than the {limit} million steps that it may take"),
        )
        .hint("divide it into several files, or take statements or scenes away"),
    }
}

/// A file without scenes has one, with no effect.
fn implicit_scene(file: &File) -> Scene {
    let name = syntax::tree::Name { text: "standard".into(), span: file.name.span };
    Scene { name, text: None, selection: Vec::new(), items: Vec::new() }
}

/// Compiles, for its mistakes alone, every effect and alternative that no scene shows.
fn check_unshown(
    file: &File,
    survey: &Survey<'_>,
    shown: &BTreeSet<Selected>,
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) {
    let mut check = |selected: Selected, diagnostics: &mut Diagnostics| {
        if !shown.contains(&selected) {
            let task = Task {
                file,
                survey,
                selected: &selected,
                scene: None,
                is_first: false,
                is_unreduced: false,
            };
            scene_within(&task, seen, diagnostics);
        }
    };
    for (name, ..) in &survey.effects {
        let mut all = shown.iter();
        if all.any(|selected| selected.effects.contains(&name.text)) {
            continue;
        }
        if !survey.scenes.is_empty() && !name.text.contains('.') {
            let message = format!("no scene shows the effect `{}`", name.text);
            let hint = format!("add one: `scene with_{0} = {0} {{ … }}`", name.text);
            diagnostics.push(Diagnostic::warning(name.span, message).hint(hint));
        }
        let mut selected = Selected::defaults(survey);
        selected.surround(&name.text, survey);
        selected.effects.insert(name.text.clone());
        check(selected, diagnostics);
    }
    for (name, _, _, alternatives) in &survey.choices {
        for alternative in alternatives.iter().map(|one| &one.name.text) {
            let mut all = shown.iter();
            if all.any(|selected| selected.choices.get(&name.text) == Some(alternative)) {
                continue;
            }
            let selected = shown.first().cloned();
            let mut selected = selected.unwrap_or_else(|| Selected::defaults(survey));
            selected.surround(&name.text, survey);
            selected.choices.insert(name.text.clone(), alternative.clone());
            check(selected, diagnostics);
        }
    }
}

/// Declarations that nothing refers to. Names with an index and names of parts are left alone: a repetition, and a
/// mechanism with a part, may need only some.
fn report_unused(seen: &Seen, diagnostics: &mut Diagnostics) {
    let mut reported: BTreeSet<(&str, Span)> = BTreeSet::new();
    for (name, span) in &seen.declared {
        let is_own = !name.contains(['[', '.']);
        if !seen.used.contains(name) && is_own && reported.insert((name, *span)) {
            diagnostics.push(
                Diagnostic::warning(*span, format!("nothing uses `{name}`"))
                    .hint("report it with `output`, or take it away"),
            );
        }
    }
}

fn effects(survey: &Survey<'_>) -> Vec<Described> {
    let one = |effect: &(&syntax::tree::Name, Option<&str>, &[String])| Described {
        name: effect.0.text.clone(),
        summary: effect.1.map_or_else(|| effect.2.join("\n").trim().to_string(), str::to_string),
    };
    survey.effects.iter().map(one).collect()
}

fn choices(survey: &Survey<'_>) -> Vec<ChoiceInfo> {
    survey
        .choices
        .iter()
        .map(|(name, text, documentation, alternatives)| ChoiceInfo {
            name: name.text.clone(),
            summary: text
                .map_or_else(|| documentation.join("\n").trim().to_string(), str::to_string),
            alternatives: alternatives
                .iter()
                .map(|alternative| alternative.name.text.clone())
                .collect(),
        })
        .collect()
}
