//! The first phase: names with their meanings, and the quantities that they declare with kinds and units.

use super::Here;
use crate::checked::ConstantInfo;
use crate::declare::Drive;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::Symbol;
use crate::lower::{Lowering, Moved};
use crate::resolve::Names;
use crate::syntax::tree::{EnergyKind, Output, Scene, SceneItem, StatementKind, Term, TermKind};
use crate::syntax::words::{MEASURING, POSITIONAL};
use crate::synthesis;
use crate::unit::Unit;

/// The declared quantities.
pub struct Declared {
    /// Dimensions and parameters.
    pub constants: Vec<Option<ConstantInfo>>,
    /// Units of the coordinates, then of the states.
    pub units: Vec<Option<Unit>>,
    /// Units of the dependent coordinates.
    pub dependent_units: Vec<Option<Unit>>,
    /// Motions of the drivers.
    pub drives: Vec<Drive>,
    /// What moves them.
    pub moved: Moved,
}

impl Declared {
    /// Whether the scene is a linkage, whose drivers are given from outside.
    pub fn is_linkage(&self) -> bool {
        self.moved != Moved::InTime
    }
}

/// The names of a mode, and the first of its outputs that is reported.
pub fn names(here: Here<'_>, diagnostics: &mut Diagnostics) -> (Names, usize) {
    let mut names = Names::of(&here.phase().statements, diagnostics);
    names.absent = here.phase().absent.clone();
    let swept =
        here.scene().into_iter().flat_map(|scene| &scene.items).filter_map(|item| match item {
            SceneItem::Sweep { drivers } => Some(drivers),
            _ => None,
        });
    let swept: Vec<&str> = swept.flatten().map(|one| one.driver.text.as_str()).collect();
    for item in here.scene().iter().flat_map(|scene| &scene.items) {
        let SceneItem::Hold { drivers } = item else { continue };
        for driver in drivers {
            match swept.contains(&driver.text.as_str()) {
                true => diagnostics.push(
                    Diagnostic::error(driver.span, format!("`{}` is held and swept", driver.text))
                        .hint("leave one of the two out"),
                ),
                false => names.hold(driver, diagnostics),
            }
        }
    }
    names.drive(&swept);
    for item in here.scene().iter().flat_map(|scene| &scene.items) {
        if let SceneItem::Start { values } = item {
            values.iter().for_each(|(target, value)| names.start(target, value));
        }
    }
    let shared = names.outputs.len();
    for item in here.scene().iter().flat_map(|scene| &scene.items) {
        if let SceneItem::Output(output) = item {
            names.declare_output(output, String::new(), diagnostics);
        }
    }
    synthesis::declare(here.scene(), &mut names, diagnostics);
    // A scene that says what it reports reports only that.
    let has_own = names.outputs.len() > shared;
    (names, if has_own { shared } else { 0 })
}

/// Declares kinds and units, and takes the motions of the drivers.
pub fn quantities(here: Here<'_>, low: &mut Lowering<'_>) -> Declared {
    let names = low.names;
    let indexed = |index: usize| index as u32;
    let constants = names
        .constants
        .iter()
        .enumerate()
        .map(|(index, declared)| low.aside(|low| low.constant(indexed(index), declared)));
    let constants = constants.collect();
    let coordinates = names.coordinates.iter().enumerate();
    let coordinates = coordinates.map(|(index, one)| (Symbol::Coordinate(indexed(index)), one));
    let states = names.states.iter().enumerate();
    let states = states.map(|(index, one)| (Symbol::State(indexed(index)), one));
    let unknowns = coordinates.chain(states);
    let units = unknowns.map(|(symbol, one)| low.unknown(symbol, one)).collect();
    low.moved = moved(low, here.scene());
    low.has_speeds = here
        .phase()
        .statements
        .iter()
        .any(|one| matches!(&one.kind, StatementKind::Energy { kind, .. } if *kind != EnergyKind::Potential));
    let drives = low.drivers(names, low.moved);
    let dependents = names.dependents.iter().enumerate();
    let dependents = dependents.map(|(index, one)| low.dependent(indexed(index), one));
    let dependent_units = dependents.collect();
    Declared { constants, units, dependent_units, drives, moved: low.moved }
}

/// What moves the drivers. A scene without states that closes loops, or sweeps, is a linkage.
fn moved(low: &mut Lowering<'_>, scene: Option<&Scene>) -> Moved {
    let names = low.names;
    let items = || scene.iter().flat_map(|scene| &scene.items);
    let sweeps = items().any(|item| matches!(item, SceneItem::Sweep { .. }));
    let rests = items().any(|item| matches!(item, SceneItem::Rest { .. }));
    let timed = rests
        || items().any(|item| matches!(item, SceneItem::Run { .. } | SceneItem::Periodic { .. }));
    let state = names.coordinates.iter().chain(&names.states).next();
    match (state, names.dependents.first()) {
        (Some(_), _) if !sweeps => Moved::InTime,
        (None, None) if !sweeps => Moved::InTime,
        (None, _) if sweeps || !timed => Moved::Swept,
        // Measures that positions do not have look at a motion from its begin to its end.
        (None, _) if !rests && names.measures.iter().any(|one| asks_for_motion(&one.what)) => {
            Moved::InTime
        }
        (None, _) => Moved::Given,
        (Some(state), _) => {
            let message =
                "a scene with coordinates or states moves in time and has nothing to sweep";
            let place = scene.map_or(state.name.span, |scene| scene.name.span);
            low.diagnostics.push(
                Diagnostic::error(place, message).related(state.name.span, "this moves by itself"),
            );
            Moved::InTime
        }
    }
}

/// Whether a measure has a part that only a motion has.
fn asks_for_motion(measure: &Output) -> bool {
    fn asks(term: &Term) -> bool {
        let own = match &term.kind {
            TermKind::Call { name, .. } => {
                let word = name.text.as_str();
                MEASURING.contains(&word) && !POSITIONAL.contains(&word)
            }
            _ => false,
        };
        own || term.parts().into_iter().any(asks)
    }
    measure.value.as_ref().is_some_and(asks)
}
