//! A scene: what one mode is compiled to, or several of them joined.

use std::collections::{BTreeMap, BTreeSet};

use crate::checked::{ConstantInfo, ModeModel, QuantityInfo, SceneModel};
use crate::compile::{Compiled, Here, Seen, Task, mode};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::modes::{Phase, Phases};
use crate::scene::specialise;
use crate::syntax::tree::{Statement, StatementKind};

/// Steps that a mode of a scene takes in any case.
const SCENE: usize = 5000;

/// Steps that it takes for a statement that says hardly anything.
const STATEMENT: usize = 100;

/// Steps that a scene takes whatever its expressions are: what stands outside of its modes is read for each of them.
fn least(statements: &[Statement], task: &Task<'_>) -> usize {
    let bodies = statements.iter().filter_map(|one| match &one.kind {
        StatementKind::Mode { body, .. } => Some(body.len()),
        _ => None,
    });
    let (modes, own) = bodies.fold((0, 0), |(modes, own), body| (modes + 1, own + body));
    let common = SCENE + task.selected.choices.len() + STATEMENT * (statements.len() - modes);
    modes.max(1) * common + STATEMENT * own
}

/// Compiles one scene. Mistakes go to `diagnostics`, and then there is no model.
pub fn scene(
    task: &Task<'_>,
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Option<SceneModel> {
    let statements = specialise(task.file, task.survey, task.selected, diagnostics);
    seen.budget.spend(least(&statements, task));
    let phases = Phases::of(statements, task.scene.map(|(scene, _)| scene), diagnostics);
    // What is bound in some modes only is a coordinate in all.
    let binds = phases.is_hybrid() && phases.all.iter().any(binds);
    let is_unreduced = task.is_unreduced || binds;
    let task = &Task { is_unreduced, ..*task };
    match phases.is_hybrid() {
        true => join(task, &phases, seen, diagnostics),
        false => {
            let mut all = modes(task, &phases, &[], seen, diagnostics)?;
            all.pop().map(only)
        }
    }
}

/// Whether closures hold in a mode that do not hold in others.
fn binds(phase: &Phase) -> bool {
    let own = phase.statements.iter().skip(phase.common);
    own.into_iter().any(|one| matches!(one.kind, StatementKind::Closure { .. }))
}

/// Compiles all modes of a scene, and joins them: they have one state vector, the same constants, and the same outputs.
fn join(
    task: &Task<'_>,
    phases: &Phases,
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Option<SceneModel> {
    let mut all = modes(task, phases, &[], seen, diagnostics)?;
    if let Some(phase) = unlike(phases, &all) {
        if !task.is_unreduced {
            return join(&Task { is_unreduced: true, ..*task }, phases, seen, diagnostics);
        }
        report_unlike(phase, diagnostics);
        return None;
    }
    let union: BTreeSet<usize> = all.iter().flat_map(|mode| mode.kept.clone()).collect();
    let union: Vec<usize> = union.into_iter().collect();
    // Influence coefficients are taken by the same constants in every mode.
    if all.iter().any(|mode| mode.scene.linkage.is_some() && mode.kept != union) {
        all = modes(task, phases, &union, seen, diagnostics)?;
    }
    unite(&mut all);
    report_unconnected(phases, &all, diagnostics);
    draw_alike(&mut all);
    let mut model = all.get(phases.first)?.scene.clone();
    model.conservative = false;
    model.may_stop = all.iter().any(|mode| mode.scene.may_stop);
    model.program.linear = false;
    model.first = phases.first;
    take_kinds(&mut model, &all);
    for (phase, compiled) in phases.all.iter().zip(all) {
        check_outputs(&model, &compiled, phase, diagnostics)?;
        model.modes.push(ModeModel {
            name: phase.name.clone(),
            summary: phase.summary.clone(),
            equations: compiled.scene.equations,
            events: compiled.events,
            held: compiled.held,
            augmented: compiled.scene.augmented,
            program: compiled.scene.program,
        });
    }
    Some(model)
}

/// Leaves of what is drawn that which all modes have: points, if they have the same, and of forces those of closures that
/// hold in all.
fn draw_alike(all: &mut [Compiled]) {
    let points: Vec<_> = all.iter().map(|mode| mode.scene.points.clone()).collect();
    let same = points.windows(2).all(|pair| pair[0] == pair[1]);
    let arrows: Vec<_> = all.iter().map(|mode| mode.scene.arrows.clone()).collect();
    for mode in all {
        let scene = &mut mode.scene;
        let places = std::mem::take(&mut scene.program.results.points);
        if !same {
            (scene.points, scene.links, scene.arrows) = (Vec::new(), Vec::new(), Vec::new());
            continue;
        }
        let (points, forces) = places.split_at((2 * scene.points.len()).min(places.len()));
        let own = scene.arrows.clone().into_iter().zip(forces.chunks(2));
        let kept = own.filter(|(arrow, _)| arrows.iter().all(|other| other.contains(arrow)));
        let (arrows, forces): (Vec<usize>, Vec<_>) = kept.unzip();
        scene.program.results.points = [points, &forces.concat()].concat();
        scene.arrows = arrows;
    }
}

/// A mode that has other coordinates than the first: what closures determine in one may be free in another.
fn unlike<'a>(phases: &'a Phases, all: &[Compiled]) -> Option<&'a Phase> {
    let names = |mode: &Compiled| -> Vec<String> {
        mode.scene.states.iter().map(|state| state.name.clone()).collect()
    };
    let first = names(all.first()?);
    let mut modes = phases.all.iter().zip(all);
    modes.find(|(_, mode)| names(mode) != first).map(|(phase, _)| phase)
}

fn report_unlike(phase: &Phase, diagnostics: &mut Diagnostics) {
    let message = format!("the mode `{}` has other coordinates than the first one", phase.name);
    diagnostics.push(
        Diagnostic::error(phase.span, message)
            .hint("state all of them by `coordinate`, and what binds them in a mode by `closure`"),
    );
}

/// Compiles every mode, for its mistakes even if another one has some; each with these constants in any case.
fn modes(
    task: &Task<'_>,
    phases: &Phases,
    constants: &[usize],
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Compiled>> {
    let compile = |index| {
        let here = Here { task, phases, index, constants };
        mode(here, seen, diagnostics)
    };
    let all: Vec<Option<Compiled>> = (0..phases.all.len()).map(compile).collect();
    all.into_iter().collect()
}

/// Gives all modes the constants that any of them depends on.
fn unite(all: &mut [Compiled]) {
    let mut union: BTreeMap<usize, ConstantInfo> = BTreeMap::new();
    for mode in all.iter() {
        let kept = mode.kept.iter().copied();
        union.extend(kept.zip(mode.scene.constants.iter().cloned()));
    }
    let places: BTreeMap<usize, usize> = union.keys().copied().zip(0..).collect();
    for mode in all {
        let new = |old: usize| places[&mode.kept[old]];
        mode.scene.program.renumber_parameters(union.len(), new);
        let requirements = mode.scene.requirements.iter_mut();
        let names = requirements.flat_map(|requirement| &mut requirement.names);
        names.for_each(|name| *name = new(*name));
        mode.scene.constants = union.values().cloned().collect();
    }
}

/// A scene without modes. Where its motion meets switching surfaces it has one, without a name.
fn only(compiled: Compiled) -> SceneModel {
    let mut model = compiled.scene;
    if !compiled.events.is_empty() {
        model.conservative = false;
        model.modes.push(ModeModel {
            name: String::new(),
            summary: String::new(),
            equations: model.equations.clone(),
            events: compiled.events,
            held: Vec::new(),
            augmented: model.augmented.clone(),
            program: model.program.clone(),
        });
    }
    model
}

/// What is zero in the first mode has the unit that it has elsewhere.
fn take_kinds(model: &mut SceneModel, all: &[Compiled]) {
    let of_kind = |list: usize, index: usize| {
        let mut modes = all.iter();
        modes.find(|mode| !mode.free[list].get(index).copied().unwrap_or(true))
    };
    for (index, output) in model.outputs.iter_mut().enumerate() {
        if let Some(mode) = of_kind(0, index) {
            *output = mode.scene.outputs[index].clone();
        }
    }
    for (index, measure) in model.measures.iter_mut().enumerate() {
        if let Some(mode) = of_kind(1, index) {
            measure.quantity = mode.scene.measures[index].quantity.clone();
        }
    }
}

/// Every mode reports the same quantities in the same units.
fn check_outputs(
    model: &SceneModel,
    other: &Compiled,
    phase: &Phase,
    diagnostics: &mut Diagnostics,
) -> Option<()> {
    let differs = |a: &QuantityInfo, b: &QuantityInfo, free: bool| {
        a.name != b.name || (!free && a.dimension != b.dimension)
    };
    let outputs = model.outputs.iter().zip(&other.scene.outputs);
    let outputs = outputs.zip(&other.free[0]);
    let outputs = outputs.map(|((a, b), free)| (a, b, *free));
    let measures = model.measures.iter().zip(&other.scene.measures);
    let measures = measures.zip(&other.free[1]);
    let measures = measures.map(|((a, b), free)| (&a.quantity, &b.quantity, *free));
    let found = outputs.chain(measures).find(|(a, b, free)| differs(a, b, *free));
    if model.outputs.len() == other.scene.outputs.len() && found.is_none() {
        return Some(());
    }
    let name = found.map_or("an output", |(a, ..)| a.name.as_str());
    let message = format!("`{name}` is something else in the mode `{}`", phase.name);
    diagnostics.push(
        Diagnostic::error(phase.span, message)
            .hint("every mode has to report the same quantities, of the same kind"),
    );
    None
}

/// Modes into which nothing leads, and modes out of which nothing leads.
fn report_unconnected(phases: &Phases, all: &[Compiled], diagnostics: &mut Diagnostics) {
    let mut reached = BTreeSet::from([phases.first]);
    let mut open = vec![phases.first];
    while let Some(here) = open.pop() {
        for next in ways(here, all) {
            if reached.insert(next) {
                open.push(next);
            }
        }
    }
    for (index, phase) in phases.all.iter().enumerate() {
        if reached.contains(&index) {
            if phases.all.len() > 1 && ways(index, all).next().is_none() {
                report_dead_end(phase, &all[index].scene.name, diagnostics);
            }
        } else {
            let message = format!("the mode `{}` is never entered", phase.name);
            let hint = format!(
                "lead to it by an event, `when … rises -> {0};`, or begin in it, `start {0};`",
                phase.name
            );
            diagnostics.push(Diagnostic::warning(phase.span, message).hint(hint));
        }
    }
}

/// The modes to which the events of a mode lead.
fn ways(here: usize, all: &[Compiled]) -> impl Iterator<Item = usize> {
    let events = all[here].events.iter();
    let targets = events.filter(|event| !event.is_idle).map(|event| event.target);
    targets.filter(move |target| *target != here)
}

/// A motion may well be meant to end in a mode.
fn report_dead_end(phase: &Phase, scene: &str, diagnostics: &mut Diagnostics) {
    let message = format!("nothing leads out of the mode `{}`", phase.name);
    let note = Diagnostic::note(phase.span, format!("in the scene `{scene}` {message}"));
    diagnostics.push_once(
        message,
        note.hint(
            "if the motion is not meant to stay in it, add an event, `when … rises -> mode;`",
        ),
    );
}
