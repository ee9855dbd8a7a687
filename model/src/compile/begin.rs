//! Where the motion of a mode begins, as far as it is known before the closures are ordered.

use super::declare::Declared;
use super::{Here, choose};
use crate::expression::Symbol;
use crate::linkage::Places;
use crate::lower::Lowering;
use crate::syntax::tree::{SceneItem, Term};

/// A start value that the scene states: of the coordinate of an index, of its rate perhaps.
pub type Start = (usize, bool, Term);

/// The declared places, with the start values that the scene states for coordinates.
pub fn places(here: Here<'_>, declared: &Declared, low: &mut Lowering<'_>) -> (Places, Vec<Start>) {
    let names = low.names;
    let constants = choose::values(here, declared, low).values;
    let mut starts: Vec<Start> = Vec::new();
    for (index, coordinate) in names.coordinates.iter().enumerate() {
        starts.extend(coordinate.what.start.clone().map(|term| (index, false, term)));
    }
    let items = here.scene().into_iter().flat_map(|scene| &scene.items);
    let mut stated: Vec<Start> = Vec::new();
    for item in items {
        let SceneItem::Start { values } = item else { continue };
        for (target, value) in values {
            let symbol = low.scalar(target).and_then(|(symbol, _)| low.given_symbol(symbol));
            match symbol {
                Some(Symbol::Coordinate(index)) => {
                    stated.push((index as usize, false, value.clone()));
                }
                Some(Symbol::Speed(index)) => stated.push((index as usize, true, value.clone())),
                _ => {}
            }
        }
    }
    let mut state = vec![f64::NAN; names.coordinates.len()];
    let of = |symbol| match symbol {
        Symbol::Parameter(index) => constants.get(index as usize).copied().unwrap_or(f64::NAN),
        _ => f64::NAN,
    };
    let placed = starts.iter().chain(&stated).filter(|one| !one.1);
    for (index, _, term) in placed {
        if let Some((value, _)) = low.scalar(term) {
            state[*index] = low.graph.evaluate(&[value], &of)[0];
        }
    }
    let mut places =
        Places::of_state(low, &declared.drives, (&constants, &state)).unwrap_or(Places {
            constants: constants.clone(),
            drivers: Vec::new(),
            state,
            coordinates: names.coordinates.len(),
            dependents: Vec::new(),
        });
    for (place, dependent) in places.dependents.iter_mut().zip(&names.dependents) {
        if let Some((value, _)) = dependent.what.start.as_ref().and_then(|term| low.scalar(term)) {
            *place = low.graph.evaluate(&[value], &of)[0];
        }
    }
    (places, stated)
}
