//! Where the motion of a scene begins.

use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, describe, fitting_value, over};
use crate::lower::{Kind, Lowering, second};
use crate::resolve::Names;
use crate::syntax::print;
use crate::syntax::tree::{Name, Scene, SceneItem, Term};
use crate::token::Span;

/// A component of the state vector, the term of its start value and its kind.
type Slot = (usize, Term, Kind);

/// Start values of the state vector; the mode in which the motion begins holds some coordinates.
pub fn start(
    low: &mut Lowering<'_>,
    names: &Names,
    scene: Option<&Scene>,
    needed: bool,
    held: &[usize],
) -> Vec<Expression> {
    let zero = low.graph.zero();
    let coordinates = names.coordinates.len();
    let size = 2 * coordinates + names.states.len();
    let mut starts = Starts {
        names,
        values: vec![zero; size],
        given: vec![false; size],
        speeds: vec![None; coordinates],
    };
    let mut places = starts.declared(low);
    places.extend(stated(low, names, scene));
    for place in places {
        starts.take(place, low);
    }
    // What only another mode has begins with that mode.
    for (index, declared) in names.coordinates.iter().enumerate() {
        if names.absent.contains_key(&declared.name.text) {
            (starts.values[index], starts.values[coordinates + index]) = (zero, zero);
        }
    }
    starts.check_held(held, low);
    if needed {
        starts.check_given(low);
    }
    starts.values
}

/// The start values that the scene states.
fn stated(low: &mut Lowering<'_>, names: &Names, scene: Option<&Scene>) -> Vec<Slot> {
    let coordinates = names.coordinates.len();
    let mut places: Vec<Slot> = Vec::new();
    let mut said: Vec<(String, Span)> = Vec::new();
    let items = scene.into_iter().flat_map(|scene| &scene.items);
    let values = items.filter_map(|item| match item {
        SceneItem::Start { values } => Some(values),
        _ => None,
    });
    for (target, value) in values.flatten() {
        let Some((started, kind)) = low.scalar(target) else {
            continue;
        };
        let text = print::term(target);
        let slot = match low.given_symbol(started) {
            Some(Symbol::Coordinate(index)) => Some(index as usize),
            Some(Symbol::Speed(index)) => Some(coordinates + index as usize),
            Some(Symbol::State(index)) => Some(2 * coordinates + index as usize),
            // What closures determine is compared with them, or picks the assembly mode.
            Some(Symbol::Dependent(_)) => None,
            Some(Symbol::DependentRate(index)) if names.bound.contains_key(&(index as usize)) => {
                None
            }
            Some(Symbol::Driver(_)) if !names.dependents.is_empty() => None,
            _ => {
                let message = match names.dependents.is_empty() {
                    true => "only a coordinate, its `dot`, or a state can be started",
                    false => {
                        "only a coordinate, its `dot`, a state, a dependent coordinate or a driver can be started"
                    }
                };
                let report = Diagnostic::error(target.span, message);
                low.diagnostics.push(report.hint("the rest follows from them"));
                continue;
            }
        };
        if let Some((_, earlier)) = said.iter().find(|(other, _)| *other == text) {
            let message = format!("`{text}` is started twice");
            low.diagnostics.push(
                Diagnostic::error(target.span, message)
                    .related(*earlier, "the first time")
                    .hint("take one of the two away"),
            );
        }
        said.push((text, target.span));
        places.extend(slot.map(|slot| (slot, value.clone(), kind)));
    }
    places
}

/// The start values that have been found.
struct Starts<'a> {
    names: &'a Names,
    values: Vec<Expression>,
    /// Which of them are stated.
    given: Vec<bool>,
    /// Where the speeds are stated.
    speeds: Vec<Option<Span>>,
}

impl Starts<'_> {
    /// The start values that stand where coordinates and states are declared.
    fn declared(&mut self, low: &Lowering<'_>) -> Vec<Slot> {
        let coordinates = self.names.coordinates.len();
        let mut places = Vec::new();
        for (index, declared) in self.names.coordinates.iter().enumerate() {
            let kind = low.kind_of(Symbol::Coordinate(index as u32));
            let speed = over(kind, Kind::Of(second())).unwrap_or(Kind::Any);
            let (start, rate) = (&declared.what.start, &declared.what.start_rate);
            places.extend(start.clone().map(|term| (index, term, kind)));
            places.extend(rate.clone().map(|term| (coordinates + index, term, speed)));
            // A coordinate with a start value starts at rest unless it says more.
            self.given[coordinates + index] = start.is_some();
        }
        for (index, declared) in self.names.states.iter().enumerate() {
            let kind = low.kind_of(Symbol::State(index as u32));
            let start = declared.what.start.clone();
            places.extend(start.map(|term| (2 * coordinates + index, term, kind)));
        }
        places
    }

    /// Takes up a start value.
    fn take(&mut self, (slot, term, kind): Slot, low: &mut Lowering<'_>) {
        let Some((value, found)) = low.scalar(&term) else {
            return;
        };
        if agree(found, kind).is_none() {
            let message = format!(
                "the start value of {} is {}",
                describe(kind.dimension()),
                describe(found.dimension())
            );
            let (name, of) = self.started(slot);
            let report = Diagnostic::error(term.span, message).related(of, "declared here");
            low.diagnostics.push(report.hint(fitting_value(kind, &name)));
        } else if !low.is_constant(value) {
            low.diagnostics
                .push(Diagnostic::error(term.span, "a start value can depend on constants alone"));
        }
        let coordinates = self.names.coordinates.len();
        self.values[slot] = value;
        self.given[slot] = true;
        if slot < coordinates {
            self.given[coordinates + slot] = true;
        } else if slot < 2 * coordinates {
            self.speeds[slot - coordinates] = Some(term.span);
        }
    }

    /// Which component of the state vector has a start value, and where it is declared.
    fn started(&self, slot: usize) -> (String, Span) {
        let coordinates = self.names.coordinates.len();
        let plain = |name: &Name| (name.text.clone(), name.span);
        let position = |index: usize| &self.names.coordinates[index].name;
        match slot {
            _ if slot < coordinates => plain(position(slot)),
            _ if slot < 2 * coordinates => {
                let name = position(slot - coordinates);
                (format!("dot({})", name.text), name.span)
            }
            _ => plain(&self.names.states[slot - 2 * coordinates].name),
        }
    }

    /// What the mode holds in which the motion begins has no speed.
    fn check_held(&self, held: &[usize], low: &mut Lowering<'_>) {
        let coordinates = self.names.coordinates.len();
        for index in held.iter().filter(|index| **index < coordinates) {
            let speed = low.graph.as_number(self.values[coordinates + index]);
            let (Some(place), Some(speed)) = (self.speeds[*index], speed) else {
                continue;
            };
            if speed != 0.0 {
                let name = &self.names.coordinates[*index].name;
                let message = format!(
                    "`{}` cannot start with a speed: the motion begins in a mode that holds it",
                    name.text
                );
                low.diagnostics.push(
                    Diagnostic::error(place, message)
                        .related(name.span, "declared here")
                        .hint(format!(
                            "start at rest, `start dot({}) = 0;`, or in another mode, `start mode;`",
                            name.text
                        )),
                );
            }
        }
    }

    /// A scene that runs from the start needs all start values.
    fn check_given(&self, low: &mut Lowering<'_>) {
        let names = self.names;
        let positions = names.coordinates.iter().zip(&self.given);
        let states = self.given[2 * names.coordinates.len()..].iter();
        for (declared, given) in positions.chain(names.states.iter().zip(states)) {
            let name = &declared.name;
            if !given && !names.absent.contains_key(&name.text) {
                let message = format!(
                    "`{}` has no start value, from which a scene runs, or a position of rest is sought",
                    name.text
                );
                low.diagnostics.push(
                    Diagnostic::error(name.span, message)
                        .hint("write it after the unit, as in `coordinate x: m = 0;`"),
                );
            }
        }
    }
}
