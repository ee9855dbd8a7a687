//! Panels of coefficients over the range of a linkage: kinematic coefficients of the outputs, and the influence of the
//! dimensions on them.

use assur::closure::Variable as By;
use assur::shape::{At, Quantity, Subject};

use super::across::Across;
use super::kind::Kind;
use super::name::{self, Name};
use super::panels::{Fact, Panel};
use super::selection::Selection;
use crate::ask::variables::Variable;
use crate::linkage::case::Task;
use crate::linkage::influence::{self, unit_of};
use crate::linkage::report::Report;

/// Most curves of a panel.
const CURVES: usize = 7;
/// Outputs whose influence coefficients are all drawn unless some are asked for; of more only the first one's.
const OUTPUTS: usize = 3;
/// Units that are changed for a finer one when all values are small.
const FINER: [(&str, &str); 2] = [("rad/", "mrad/"), ("mm/", "um/")];

/// A coefficient over the range.
struct Track {
    output: usize,
    variable: usize,
    by: Quantity,
    /// Unit with its SI value.
    unit: (String, f64),
    /// Values in that unit.
    values: Vec<f64>,
}

/// The panels of the coefficients at these stations; none where the linkage does not get.
pub fn panels(
    report: &Report,
    selection: &Selection,
    across: &Across,
    stations: &[Option<Vec<f64>>],
) -> Vec<Panel> {
    let tracks = tracks(report, selection, &sample(report, stations));
    let drivers = tracks.iter().filter(|track| is_driver(report, track));
    let mut panels = Vec::new();
    // A panel for each driver and unit: all outputs together.
    for group in grouped(drivers, |track| (track.variable, track.unit.0.clone())) {
        let letter = name::set(group[0].by.name).text;
        let title = format!("Kinematic coefficients by {letter}");
        panels.extend(panel(report, across, &group, title, |track| {
            report.case.scene.outputs[track.output].name
        }));
    }
    // A panel for each output and unit: all dimensions together.
    let others = tracks.iter().filter(|track| !is_driver(report, track));
    for group in grouped(others, |track| (track.output, track.unit.0.clone())) {
        let letter = name::set(report.case.scene.outputs[group[0].output].name).text;
        let title = match group.len() > CURVES {
            true => format!("Influence on {letter}, largest {CURVES} of {}", group.len()),
            false => format!("Influence on {letter}"),
        };
        panels.extend(panel(report, across, &group, title, |track| track.by.name));
    }
    panels
}

/// The coefficients at each station, outputs by variables.
fn sample(report: &Report, stations: &[Option<Vec<f64>>]) -> Vec<Vec<f64>> {
    let case = &report.case;
    let all = case.moved.entry.variables.len() * case.scene.outputs.len();
    let at = |station: &Option<Vec<f64>>| {
        let place = case.place(station.as_ref()?);
        case.run().influence(&place).ok()
    };
    let found = stations.iter().map(at);
    found.map(|values| values.unwrap_or_else(|| vec![f64::NAN; all])).collect()
}

/// The coefficients that are wanted and are not zero everywhere.
fn tracks(report: &Report, selection: &Selection, found: &[Vec<f64>]) -> Vec<Track> {
    let case = &report.case;
    let width = case.moved.entry.variables.len();
    let mut tracks = Vec::new();
    for (output, shown) in case.variables[..case.scene.outputs.len()].iter().enumerate() {
        for (variable, of) in case.moved.entry.variables.iter().enumerate() {
            let Some(by) = influence::quantity(case, *of) else {
                continue;
            };
            let driven = matches!(of, By::Driver(_));
            if !is_wanted(report, selection, (output, shown), (driven, &by)) {
                continue;
            }
            let (unit, factor) = unit_of(shown, &by);
            let column = found.iter().map(|row| row[output * width + variable] / factor);
            let values: Vec<f64> = column.collect();
            if size(&values) > 0.0 {
                tracks.push(Track { output, variable, by, unit: (unit, factor), values });
            }
        }
    }
    tracks
}

/// Unless coefficients are named: those of positions alone, by drivers that move, and of many outputs the influence on
/// the first one.
fn is_wanted(
    report: &Report,
    selection: &Selection,
    (output, shown): (usize, &Variable),
    (driven, by): (bool, &Quantity),
) -> bool {
    let outputs = &report.case.variables[..report.case.scene.outputs.len()];
    match selection {
        Selection::Named(_) => selection.admits(&format!("diff({}, {})", shown.name, by.name)),
        Selection::All => true,
        Selection::Usual if !Kind::of(shown).is_position() => false,
        Selection::Usual if driven => shown.name != by.name && moves(report, by.name),
        Selection::Usual => {
            let positions = |one: &Variable| Kind::of(one).is_position();
            outputs.len() <= OUTPUTS || outputs.iter().position(positions) == Some(output)
        }
    }
}

/// Whether a driver moves during the task.
fn moves(report: &Report, driver: &str) -> bool {
    match &report.case.moved.task {
        Task::Sweep(drivers) => {
            let mut names = drivers.iter().map(|&index| report.case.drivers[index].name);
            names.any(|name| name == driver)
        }
        _ => true,
    }
}

fn is_driver(report: &Report, track: &Track) -> bool {
    matches!(report.case.moved.entry.variables[track.variable], By::Driver(_))
}

/// Tracks with the same key together, in the order of the first of each.
fn grouped<'a, K: PartialEq>(
    tracks: impl Iterator<Item = &'a Track>,
    key: impl Fn(&Track) -> K,
) -> Vec<Vec<&'a Track>> {
    let mut groups: Vec<Vec<&Track>> = Vec::new();
    for track in tracks {
        let same = |group: &&mut Vec<&Track>| key(group[0]) == key(track);
        match groups.iter_mut().find(same) {
            Some(group) => group.push(track),
            None => groups.push(vec![track]),
        }
    }
    groups
}

/// The largest curves of a group, in their order.
fn panel(
    report: &Report,
    across: &Across,
    group: &[&Track],
    title: String,
    called: impl Fn(&Track) -> &'static str,
) -> Option<Panel> {
    let mut order: Vec<usize> = (0..group.len()).collect();
    order.sort_by(|a, b| size(&group[*b].values).total_cmp(&size(&group[*a].values)));
    order.truncate(CURVES);
    order.sort_unstable();
    let shown: Vec<&Track> = order.into_iter().map(|index| group[index]).collect();
    let most = shown.iter().map(|track| size(&track.values)).fold(0.0, f64::max);
    let (unit, finer) = finer(&shown.first()?.unit.0, most);
    let curves = shown.iter().map(|track| {
        let values = track.values.iter().map(|value| value * finer).collect();
        (name::set(called(track)), values)
    });
    let curves: Vec<(Name, Vec<f64>)> = curves.collect();
    let facts = shown.iter().enumerate().flat_map(|(curve, track)| {
        let known = facts(report, track).into_iter();
        known.map(move |(at, value)| Fact {
            at: at / across.factor,
            value: value / track.unit.1 * finer,
            curve,
        })
    });
    let facts = facts.collect();
    Some(Panel::of(title, name::unit(&unit), curves, facts))
}

/// Published values of a coefficient, SI units.
fn facts(report: &Report, track: &Track) -> Vec<(f64, f64)> {
    let known = report.published.iter().filter(|one| one.comparable);
    let list = known.filter_map(|one| {
        let of = Subject::Influence(track.output, track.variable);
        let at = match one.fact.at {
            At::Position([(0, position)]) => *position,
            At::Driver(0, position) => position,
            _ => return None,
        };
        let counts = one.time.is_none() && one.fact.subject == of;
        counts.then_some((at, one.fact.value))
    });
    list.collect()
}

/// The largest absolute value.
fn size(values: &[f64]) -> f64 {
    let finite = values.iter().filter(|value| value.is_finite());
    finite.fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// A finer unit where all values are small, with the number of them in one of the unit.
fn finer(unit: &str, most: f64) -> (String, f64) {
    let found = FINER.iter().find(|(coarse, _)| unit.starts_with(coarse));
    match found.filter(|_| most < 0.1) {
        Some((coarse, fine)) => (unit.replacen(coarse, fine, 1), 1e3),
        None => (unit.to_owned(), 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_coefficients_have_a_finer_unit() {
        assert_eq!(finer("rad/mm", 0.0045), ("mrad/mm".to_owned(), 1e3));
        assert_eq!(finer("rad/mm", 2.0), ("rad/mm".to_owned(), 1.0));
        assert_eq!(finer("", 0.001), (String::new(), 1.0));
    }
}
