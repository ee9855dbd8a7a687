//! Where the motion of a mode begins, as far as it is known before the closures are ordered.

use super::declare::Declared;
use super::{Here, choose};
use crate::diagnostic::Diagnostic;
use crate::expression::Symbol;
use crate::linkage::{Augmented, Places, compare};
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
        let what = &coordinate.what;
        starts.extend(what.start.clone().map(|term| (index, false, term)));
        starts.extend(what.start_rate.clone().map(|term| (index, true, term)));
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
    let mut state = vec![f64::NAN; 2 * names.coordinates.len()];
    let of = |symbol| match symbol {
        Symbol::Parameter(index) => constants.get(index as usize).copied().unwrap_or(f64::NAN),
        _ => f64::NAN,
    };
    for (index, is_rate, term) in starts.iter().chain(&stated) {
        if let Some((value, _)) = low.scalar(term) {
            let slot = if *is_rate { names.coordinates.len() + index } else { *index };
            state[slot] = low.graph.evaluate(&[value], &of)[0];
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

/// Compares the stated start values of the first coordinates with what the closures make of them. Where freedoms appear for
/// an instant, the motion does not begin without a speed of each.
pub fn compare_starts(
    low: &mut Lowering<'_>,
    found: &Augmented,
    places: &Places,
    (count, stated): (usize, &[Start]),
) {
    let names = low.names;
    let at_change = found.rank_at_start < found.rank;
    for (index, declared) in names.coordinates.iter().enumerate().take(count) {
        let of = |is_rate: bool| {
            let mut own = stated.iter().rev().filter(|one| one.0 == index && one.1 == is_rate);
            let what = &declared.what;
            let term = if is_rate { &what.start_rate } else { &what.start };
            own.next().map(|one| one.2.clone()).or(term.clone())
        };
        let name = &declared.name;
        let is_kept = found.kept.contains(&index);
        if is_kept && at_change && of(true).is_none() {
            let message = format!(
                "the motion begins where freedoms appear for an instant: {} of {} closures are independent there, and nothing says how fast `{}` moves",
                found.rank_at_start, found.rank, name.text
            );
            let hint = format!("state its speed, `start dot({}) = …;`, or begin beside", name.text);
            low.diagnostics
                .push_once(message.clone(), Diagnostic::error(name.span, message).hint(hint));
        }
        if is_kept {
            continue;
        }
        let unit = low.unit_of(Symbol::Coordinate(index as u32));
        let (unit, factor) =
            unit.map_or((String::new(), 1.0), |one| (one.symbol.clone(), one.scale()));
        let closed = [found.start[index], found.speeds[index]];
        for (is_rate, closed) in [false, true].into_iter().zip(closed) {
            let Some(term) = of(is_rate) else { continue };
            let Some((value, _)) = low.scalar(&term) else { continue };
            let value = places.evaluate(low, value);
            let (name, unit) = match is_rate {
                false => (name.text.clone(), unit.clone()),
                true => (format!("dot({})", name.text), format!("{unit}/s")),
            };
            compare(low, (&name, &unit), (value / factor, closed / factor), term.span);
        }
    }
}
