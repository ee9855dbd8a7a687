//! The language of Assur: from the text of an equation file to a checked model with one program for each scene.
//!
//! ```text
//! lex -> parse -> put parts in their places -> survey effects and scenes -> for each scene:
//!     specialise -> resolve names -> lower terms, checking units -> derive (Lagrange)
//!     -> balance and order -> solve for the highest derivatives -> simplify and share -> program
//! ```
//!
//! A file is specialised to a scene *before* its names are resolved, because a name may mean one thing with an effect
//! and another without it. A mistake that shows in several scenes is reported once. Branches that no scene shows are
//! compiled as well, for their mistakes alone.
//!
//! The crate knows nothing of rustc: the macro and the command hand it [`token::Token`]s and get
//! [`checked::Compiled`], plain data.
#![doc = include_str!("../GRAMMAR.md")]

pub mod checked;
mod compile;
mod declare;
pub mod diagnostic;
pub mod expression;
mod facts;
pub mod flatten;
mod homogeneity;
mod joined;
mod lagrange;
pub mod lexer;
mod linkage;
mod lower;
mod measures;
mod modes;
mod motion;
pub mod nearest;
mod parts;
pub mod program;
mod published;
mod resolve;
mod scene;
mod slopes;
pub mod structure;
pub mod syntax;
pub mod texts;
pub mod token;
pub mod unit;
mod unroll;

use std::collections::BTreeSet;
use std::sync::mpsc;

use checked::{ChoiceInfo, Compiled, Described, Model, PresetInfo};
use compile::{Seen, Task};
use diagnostic::{Diagnostic, Diagnostics};
use expression::Budget;
use flatten::{Loader, Wanted};
use lexer::Unreadable;
use scene::{Selected, Survey};
use syntax::tree::{File, Scene, StatementKind, is_unread};
use token::{Span, Token};

/// Stack of the thread that compiles: nesting is limited, and this holds the deepest that is allowed.
const STACK: usize = 256 << 20;

/// Compiles the tokens of a mechanism without parts, those inside `mechanism! { … }`.
///
/// Never panics and never loops: nesting, repetition and size are limited, and a limit that is met is an error.
pub fn compile(tokens: &[Token]) -> Compiled {
    compile_with(tokens, &mut no_file)
}

/// The loader that has no files.
fn no_file(wanted: &Wanted) -> Result<Vec<Token>, Unreadable> {
    Err(Unreadable {
        range: 0..0,
        message: format!("there is no file `{}` here", wanted.path),
        hint: None,
    })
}

/// Compiles the tokens of a mechanism. Files of its parts come from `loader`, which is called on this thread.
pub fn compile_with(tokens: &[Token], loader: &mut Loader<'_>) -> Compiled {
    let (ask, asked) = mpsc::channel::<Wanted>();
    let (give, given) = mpsc::channel();
    let work = move || {
        compile_here(tokens, &mut |wanted| {
            let answer = ask
                .send(wanted.clone())
                .ok()
                .and_then(|()| given.recv().ok());
            answer.unwrap_or_else(|| no_file(wanted))
        })
    };
    // `give` goes with this closure, so that the thread that asks ends even if `loader` panics.
    std::thread::scope(move |scope| {
        let worker = std::thread::Builder::new()
            .stack_size(STACK)
            .spawn_scoped(scope, work);
        let Ok(worker) = worker else {
            return compile_here(tokens, loader);
        };
        for wanted in asked {
            let _ = give.send(loader(&wanted));
        }
        match worker.join() {
            Ok(compiled) => compiled,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

fn compile_here(tokens: &[Token], loader: &mut Loader<'_>) -> Compiled {
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
    let parts = flatten::flatten(&mut file, tokens.len(), loader, &mut diagnostics);
    let survey = Survey::of(&file, &mut diagnostics);
    let implicit = implicit_scene(&file);
    let mut scenes: Vec<(&Scene, &[String])> = survey.scenes.clone();
    if scenes.is_empty() {
        scenes.push((&implicit, &[]));
    }
    let mut seen = Seen::new();
    let mut models = Vec::new();
    let mut shown = BTreeSet::new();
    for (index, (scene, documentation)) in scenes.iter().enumerate() {
        let Some(selected) = Selected::by(scene, &survey, &mut diagnostics) else {
            continue;
        };
        let task = Task {
            file: &file,
            survey: &survey,
            selected: &selected,
            scene: Some((scene, documentation)),
            is_first: index == 0,
        };
        models.extend(scene_within(&task, &mut seen, &mut diagnostics));
        shown.insert(selected);
    }
    check_unshown(&file, &survey, &shown, &mut seen, &mut diagnostics);
    check_facts(&file, &scenes, &mut diagnostics);
    let presets =
        expression::within(|| presets(&file, &seen, &mut diagnostics)).unwrap_or_default();
    if !diagnostics.has_errors() {
        report_unused(&seen, &mut diagnostics);
    }
    let model = (!diagnostics.has_errors()).then(|| Model {
        name: file.name.text.clone(),
        documentation: file.documentation.join("\n").trim().to_string(),
        source: file.source.clone().unwrap_or_default(),
        effects: effects(&survey),
        choices: choices(&survey),
        presets,
        scenes: models,
    });
    Compiled {
        name: file.name.text.clone(),
        scene_names: scenes
            .iter()
            .map(|(scene, _)| scene.name.text.clone())
            .collect(),
        model,
        diagnostics: diagnostics.into_sorted(),
        parts,
        steps: seen.budget.spent(),
    }
}

/// Compiles one scene, unless the file has come to more than is allowed.
fn scene_within(
    task: &Task<'_>,
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Option<checked::SceneModel> {
    if seen.budget.is_exhausted() {
        return None;
    }
    let budget = seen.budget.clone();
    let result = expression::within(|| joined::scene(task, seen, diagnostics));
    result.unwrap_or_else(|| {
        diagnostics.push(too_large(&budget, task));
        None
    })
}

/// Says which statement takes the most steps, or that a whole scene is too much.
fn too_large(budget: &Budget, task: &Task<'_>) -> Diagnostic {
    let limit = expression::STEPS / 1_000_000;
    let scene = task
        .scene
        .map_or(task.file.name.span, |(scene, _)| scene.name.span);
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
    let name = syntax::tree::Name {
        text: "standard".into(),
        span: file.name.span,
    };
    Scene {
        name,
        text: None,
        selection: Vec::new(),
        items: Vec::new(),
    }
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
            };
            scene_within(&task, seen, diagnostics);
        }
    };
    for (name, ..) in &survey.effects {
        if !shown
            .iter()
            .any(|selected| selected.effects.contains(&name.text))
        {
            if !survey.scenes.is_empty() && !name.text.contains('.') {
                diagnostics.push(
                    Diagnostic::warning(
                        name.span,
                        format!("no scene shows the effect `{}`", name.text),
                    )
                    .hint(format!(
                        "add one: `scene with_{0} = {0} {{ … }}`",
                        name.text
                    )),
                );
            }
            let mut selected = Selected::defaults(survey);
            selected.surround(&name.text, survey);
            selected.effects.insert(name.text.clone());
            check(selected, diagnostics);
        }
    }
    for (name, _, _, alternatives) in &survey.choices {
        for alternative in alternatives.iter() {
            let chosen = Some(&alternative.name.text);
            if !shown
                .iter()
                .any(|selected| selected.choices.get(&name.text) == chosen)
            {
                let mut selected = shown
                    .first()
                    .cloned()
                    .unwrap_or_else(|| Selected::defaults(survey));
                selected.surround(&name.text, survey);
                selected
                    .choices
                    .insert(name.text.clone(), alternative.name.text.clone());
                check(selected, diagnostics);
            }
        }
    }
}

/// Facts about scenes that do not exist.
fn check_facts(file: &File, scenes: &[(&Scene, &[String])], diagnostics: &mut Diagnostics) {
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
                scenes
                    .iter()
                    .map(|(scene, _)| scene.name.text.as_str())
                    .collect::<Vec<_>>(),
            ),
            (expect.preset.as_ref(), "preset", presets.clone()),
        ];
        for (name, what, known) in wanted {
            let missing = |name: &&syntax::tree::Name| {
                !known.contains(&name.text.as_str()) && !is_unread(&file.unread, &name.text)
            };
            let Some(name) = name.filter(missing) else {
                continue;
            };
            let report =
                Diagnostic::error(name.span, format!("there is no {what} `{}`", name.text));
            let near = nearest::nearest(&name.text, known.iter().copied());
            let otherwise = format!("the file declares {}", known.join(", "));
            diagnostics.push(report.meant(near, otherwise));
        }
    }
}

/// The presets, with every name and unit checked against the constants of any scene.
fn presets(file: &File, seen: &Seen, diagnostics: &mut Diagnostics) -> Vec<PresetInfo> {
    let mut list = Vec::new();
    for statement in &file.statements {
        let StatementKind::Preset { name, text, values } = &statement.kind else {
            continue;
        };
        let mut info = PresetInfo {
            name: name.text.clone(),
            summary: text
                .clone()
                .unwrap_or_else(|| statement.documentation.join("\n").trim().to_string()),
            values: Vec::new(),
        };
        let nothing = resolve::Names::default();
        let survey = Survey::default();
        let selected = Selected::default();
        for (target, term) in values {
            let Some(target) = unroll::target_name(target, diagnostics) else {
                continue;
            };
            let Some((kind, declared)) = seen.constants.get(&target.text) else {
                if is_unread(&file.unread, &target.text) {
                    continue;
                }
                let report = Diagnostic::error(
                    target.span,
                    format!("there is no dimension or parameter `{}`", target.text),
                );
                diagnostics.push(
                    match nearest::nearest(&target.text, seen.constants.keys().map(String::as_str))
                    {
                        Some(near) => report.hint(format!("did you mean `{near}`?")),
                        None => report,
                    },
                );
                continue;
            };
            let mut low = lower::Lowering::new(
                &nothing,
                &survey,
                &selected,
                diagnostics,
                seen.budget.clone(),
            );
            let Some((value, found)) = low.fixed(term) else {
                continue;
            };
            if homogeneity::agree(found, *kind).is_none() {
                let message = homogeneity::unlike(&format!("`{}`", target.text), *kind, found);
                diagnostics.push(
                    Diagnostic::error(term.span, message).related(*declared, "declared here"),
                );
                continue;
            }
            info.values.push((target.text, value));
        }
        list.push(info);
    }
    list
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
        summary: effect
            .1
            .map_or_else(|| effect.2.join("\n").trim().to_string(), str::to_string),
    };
    survey.effects.iter().map(one).collect()
}

fn choices(survey: &Survey<'_>) -> Vec<ChoiceInfo> {
    survey
        .choices
        .iter()
        .map(|(name, text, documentation, alternatives)| ChoiceInfo {
            name: name.text.clone(),
            summary: text.map_or_else(
                || documentation.join("\n").trim().to_string(),
                str::to_string,
            ),
            alternatives: alternatives
                .iter()
                .map(|alternative| alternative.name.text.clone())
                .collect(),
        })
        .collect()
}
