//! What a mode says of itself: names, units and texts beside its program.

use super::quantities::{driver_quantities, state_quantities};
use super::{Compiled, Mode, felt};
use crate::checked::{EventInfo, SceneModel};
use crate::expression::Symbol;
use crate::lower::Lowering;
use crate::published;
use crate::syntax::tree::Scene;

/// Absolute tolerance per unit of relative tolerance, as a part of the unit that a quantity is declared in: what is
/// declared in metres is right to a micrometre at `rtol = 1e-3`, and to 1e-12 m at `rtol = 1e-9`.
const SCALE: f64 = 1e-3;

/// The scene as if it had no other mode, without its program and what follows from the constants that it keeps.
pub fn scene(
    mode: &Mode<'_>,
    scene: &Scene,
    documentation: &[String],
    low: &mut Lowering<'_>,
) -> SceneModel {
    let (asked, task) = (&mode.asked, mode.here.task);
    // What stands inside an effect that is absent is absent as well.
    let holds = |name: &str| task.selected.holds_around(name, task.survey);
    let effects = task.selected.effects.iter().filter(|effect| holds(effect));
    let choices = task.selected.choices.iter().filter(|(choice, _)| holds(choice));
    let states = state_quantities(low.names, &mode.declared.units);
    SceneModel {
        name: scene.name.text.clone(),
        summary: summary(scene.text.as_deref(), documentation),
        effects: effects.cloned().collect(),
        choices: choices.map(|(choice, made)| (choice.clone(), made.clone())).collect(),
        drivers: driver_quantities(low, low.names),
        scales: states.iter().map(|state| SCALE * state.factor).collect(),
        states,
        outputs: asked.outputs.quantities.clone(),
        measures: asked.measures.info(),
        primitives: asked.measures.primitives.clone(),
        coordinates: low.names.coordinates.len(),
        equations: mode.parts.texts.clone(),
        requirements: mode.parts.requirements.clone(),
        span: asked.span.kind,
        conservative: is_conservative(mode, low),
        literal: asked.literal.clone(),
        felt: felt(mode, low),
        points: asked.geometry.names.clone(),
        links: asked.geometry.links.clone(),
        arrows: asked.geometry.arrows.clone(),
        marks: published::marks(low, &mode.here.phase().statements),
        ..SceneModel::default()
    }
}

/// The names of the closures whose forces others depend on.
fn felt(mode: &Mode<'_>, low: &Lowering<'_>) -> Vec<String> {
    let felt = felt::of(&mode.parts, low).into_iter();
    felt.map(|index| mode.linkage.equations[index as usize].name.clone()).collect()
}

fn summary(text: Option<&str>, documentation: &[String]) -> String {
    let lines = documentation.join("\n").trim().to_string();
    match (text, lines.is_empty()) {
        (Some(text), true) => text.to_string(),
        (Some(text), false) => format!("{text}\n{lines}"),
        (None, _) => lines,
    }
}

/// Whether the sum of the energies stays constant.
fn is_conservative(mode: &Mode<'_>, low: &Lowering<'_>) -> bool {
    let energies = &mode.parts.energies;
    let stated = !energies.kinetic.is_empty()
        && energies.dissipation.is_empty()
        && energies.forces.is_empty();
    let closures = mode.augmented.as_ref().map_or(0, |one| 2 * one.closures);
    let mut equations = mode.equations[..mode.equations.len() - closures].iter();
    let derived = equations.all(|equation| equation.lagrange.is_some());
    // What loops determine may move with a driver.
    let follows = !low.names.drivers.is_empty();
    let driven = |symbol| match symbol {
        Symbol::Time | Symbol::Driver(_) => true,
        Symbol::Dependent(_) | Symbol::DependentRate(_) => follows,
        _ => false,
    };
    let mut terms = energies.kinetic.iter().chain(&energies.potential);
    stated && derived && terms.all(|term| !low.graph.depends_on(*term, driven))
}

/// The mode with its events, those of the file before the switching surfaces.
pub fn compiled(mode: Mode<'_>, scene: SceneModel, kept: Vec<usize>) -> Compiled {
    let here = mode.here;
    let place = here.scene().map(|scene| scene.name.span).unwrap_or_default();
    let surfaces = scene.program.surfaces.iter().enumerate();
    let surfaces =
        surfaces.map(|(index, guard)| EventInfo::surface(index, guard, here.index, place));
    let own = mode.asked.events.into_iter().map(|(_, info)| info);
    let events = own.chain(surfaces).collect();
    let coordinates = scene.coordinates;
    let speeds = mode.still.iter().filter(|index| **index < coordinates);
    Compiled {
        free: [mode.asked.outputs.free, mode.asked.measures.free()],
        held: speeds.map(|index| coordinates + index).collect(),
        events,
        scene,
        kept,
    }
}
