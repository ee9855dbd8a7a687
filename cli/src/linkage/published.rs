//! Published values of a linkage beside the computed ones.

use assur::closure::Stroke;
use assur::registry::{Mechanism, Sample};
use assur::shape::{At, Expectation, Subject};

use super::case::{Case, Task, amount};
use super::influence;
use super::line::{Grid, Line};
use super::place::time_of;
use super::reach;
use crate::constants::{Constants, find_preset};
use crate::error::Failure;
use crate::number;
use crate::published::Comparison;

/// Compares all published facts of the scene. A fact may ask for a preset; unless the user has chosen values, the linkage
/// is closed with it as well.
///
/// # Errors
/// When the mechanism refuses a preset.
pub fn compare(
    mechanism: &'static Mechanism,
    case: &Case,
    lines: &[Line],
    strokes: Option<&Vec<Stroke>>,
) -> Result<Vec<Comparison>, Failure> {
    let changed = case.constants.changed();
    let mut others: Vec<(Case, Vec<Line>, Option<Vec<Stroke>>)> = Vec::new();
    let mut list = Vec::new();
    for fact in case.scene.expectations {
        let preset = match fact.preset {
            "" => case.scene.preset,
            named => named,
        };
        let own = preset == case.constants.preset;
        if own || changed {
            list.extend(one(fact, case, (lines, strokes), own && !changed));
            continue;
        }
        if others.iter().all(|(other, ..)| other.constants.preset != preset) {
            let mut constants = Constants::declared(case.scene);
            constants.apply(find_preset(mechanism, preset)?);
            let other = Case::new(constants)?;
            // What does not close has no value, which the comparison shows.
            let lines = other.grid(&Grid::fine(&other)).unwrap_or_default();
            let strokes = reach::strokes(&other);
            others.push((other, lines, strokes));
        }
        let found = others.iter().find(|(other, ..)| other.constants.preset == preset);
        if let Some((other, lines, strokes)) = found {
            let known = (&lines[..], strokes.as_ref());
            list.extend(one(fact, other, known, true).map(|compared| Comparison {
                place: format!("{}, preset {preset}", compared.place),
                ..compared
            }));
        }
    }
    Ok(list)
}

fn one(
    fact: &'static Expectation,
    case: &Case,
    (lines, strokes): (&[Line], Option<&Vec<Stroke>>),
    comparable: bool,
) -> Option<Comparison> {
    let quantity = case.scene.quantity(fact.subject)?;
    let variable = case.variables.iter().position(|variable| variable.name == quantity.name)?;
    let value = |sample: &Sample| case.values(sample)[variable];
    let at = |place: Vec<f64>| match fact.subject {
        Subject::Influence(output, by) => {
            let width = case.entry.variables.len();
            let values = case.run().influence(&place).unwrap_or_default();
            values.get(output * width + by).copied().unwrap_or(f64::NAN)
        }
        _ => case.at(place).map_or(f64::NAN, |sample| value(&sample)),
    };
    let limits = || match reach::extremes(case, lines, strokes, variable) {
        Some((low, high)) => (low.value, high.value),
        None => (f64::NAN, f64::NAN),
    };
    let (place, time, computed) = match fact.at {
        At::Maximum => ("maximum".to_owned(), None, limits().1),
        At::Minimum => ("minimum".to_owned(), None, limits().0),
        At::Amplitude => {
            let (low, high) = limits();
            ("amplitude".to_owned(), None, low.abs().max(high.abs()))
        }
        At::Run => return None,
        At::Position(positions) => {
            let mut place = case.standing();
            for (index, position) in positions {
                place[*index] = *position;
            }
            (position_label(case, positions), None, at(place))
        }
        At::Driver(driver, position) => {
            let label = position_label(case, &[(driver, position)]);
            let time = match &case.task {
                Task::Time(span) => time_of(case, *span, driver, position).ok(),
                _ => None,
            };
            let mut place = case.standing();
            place[driver] = position;
            let place = time.map_or(place, |time| case.place(&[time]));
            (label, time, at(place))
        }
        At::Time(time) => {
            let within = match &case.task {
                Task::Time(span) => span.reduce(time),
                _ => None,
            };
            let computed = within.map_or(f64::NAN, |time| at(case.place(&[time])));
            (format!("time = {} s", number::short(time)), within, computed)
        }
    };
    let printed = &case.variables[variable];
    let (name, (unit, factor), variable) = match fact.subject {
        Subject::Influence(_, by) => {
            let by = influence::quantity(case, *case.entry.variables.get(by)?)?;
            let name = format!("diff({}, {})", printed.name, by.name);
            (name, influence::unit_of(printed, &by), None)
        }
        _ => (printed.name.clone(), (printed.unit.clone(), printed.factor), Some(variable)),
    };
    Some(Comparison {
        fact,
        name,
        unit,
        factor,
        variable,
        place,
        time,
        computed,
        error: 1e-12 * computed.abs(),
        comparable,
    })
}

fn position_label(case: &Case, positions: &[(usize, f64)]) -> String {
    let parts = positions.iter().map(|(index, position)| {
        let driver = &case.drivers[*index];
        format!("{} = {}", driver.name, amount(driver, *position))
    });
    parts.collect::<Vec<_>>().join(", ")
}
