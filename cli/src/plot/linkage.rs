//! The figure of a linkage: its outputs over the first driver, of a grid a family of curves for each output.

use assur::shape::At;

use super::across::Across;
use super::coefficients;
use super::figure::{Figure, lead};
use super::kind::Kind;
use super::marks::{self, Mark};
use super::name::{self, Name};
use super::panels::{self, Data, Panel, Published};
use super::selection::Selection;
use super::study::{self, Layer, Map};
use crate::ask::variables::Variable;
use crate::linkage::case::{Axis, MARGIN, Task};
use crate::linkage::line::{Grid, Line};
use crate::linkage::report::Report;
use crate::linkage::wording;
use crate::show::number;

/// Curves of a family that can be told apart.
const FAMILY: usize = 7;
/// Curves whose common range is so many times the largest of their own are drawn apart.
const APART: f64 = 3.0;
/// Most curves that are drawn apart.
const ALONE: usize = 4;

/// Draws the figure of a report.
pub fn draw(report: &Report, selection: &Selection) -> String {
    let axes = report.case.axes();
    if let ([along, up], true) = (axes.as_slice(), report.case.is_sheet()) {
        return maps(report, selection, (along, up));
    }
    let across = across(report, &axes);
    let (positions, panels, beside) = match axes.len() {
        0 | 1 => curves(report, selection, &across),
        _ => {
            let (positions, panels) = families(report, selection, &axes);
            (positions, panels, Vec::new())
        }
    };
    Figure {
        bands: Vec::new(),
        title: format!(
            "{}: {}",
            report.case.constants.mechanism.title,
            report.case.task_in_words()
        ),
        lead: lead(&report.case.constants),
        marks: marks(report, &across, &positions),
        panels,
        beside,
        made: made(report),
        positions: positions.into_iter().map(|position| position / across.factor).collect(),
        across,
    }
    .draw()
}

/// A formula sheet over two quantities: a map of each output, with the lines beyond which a condition does not hold.
fn maps(report: &Report, selection: &Selection, (along, up): (&Axis, &Axis)) -> String {
    let case = &report.case;
    let outputs = &case.variables[..wanted(report, selection)];
    let of = |index: usize| -> Vec<f64> {
        let lines = report.lines.iter();
        lines.flat_map(|line| column(report, line, &case.variables[index], index)).collect()
    };
    let is_margin = |variable: &Variable| variable.name.starts_with(MARGIN);
    let margins = outputs.iter().enumerate().filter(|(_, one)| is_margin(one));
    let limits: Vec<(String, Vec<f64>)> = margins
        .map(|(index, one)| (case.scene.outputs[index].summary.to_owned(), one, of(index)))
        .map(|(words, one, values)| {
            (if words.is_empty() { one.name[MARGIN.len()..].to_owned() } else { words }, values)
        })
        .collect();
    let scaled = |axis: &Axis, at: f64| at / axis.quantity.factor;
    let first = report.lines.first().map_or(&[][..], |line| &line.stations);
    let columns: Vec<f64> = first.iter().map(|station| scaled(along, station[0])).collect();
    let rows = report.lines.iter().filter_map(|line| line.stations.first());
    let rows: Vec<f64> = rows.map(|station| scaled(up, station[1])).collect();
    let titled = |name: &str, unit: &str| {
        let parts = [name::set(name).text, name::unit(unit)];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    };
    let shown = outputs.iter().enumerate();
    let shown = shown.filter(|(_, one)| !is_margin(one) && selection.admits(&one.name));
    let layers: Vec<Layer> = shown
        .map(|(index, one)| {
            Layer::Map(Map {
                along: titled(along.quantity.name, along.quantity.unit),
                up: titled(up.quantity.name, up.quantity.unit),
                name: titled(&one.name, &one.unit),
                columns: columns.clone(),
                rows: rows.clone(),
                values: of(index),
                limits: limits.clone(),
            })
        })
        .collect();
    let title = format!("{}: {}", case.constants.mechanism.title, case.task_in_words());
    study::sheets(&title, &lead(&case.constants), &layers)
}

/// The horizontal axis: the first driver, or the time where that driver turns round.
fn across(report: &Report, axes: &[Axis]) -> Across {
    let driver = report.case.drivers.first().filter(|_| is_driven(report));
    let swept = axes.first().map(|axis| &axis.quantity);
    match driver.or(swept) {
        Some(quantity) => Across::along(quantity),
        None => Across::along(&crate::ask::values::TIME),
    }
}

/// Whether the drivers move in time and the first one always advances.
fn is_driven(report: &Report) -> bool {
    let case = &report.case;
    let first = |station: &Vec<f64>| case.place(station).first().copied().unwrap_or(f64::NAN);
    let line = report.lines.first();
    matches!(case.moved.task, Task::Time(_))
        && line.is_some_and(|line| {
            line.stations.windows(2).all(|pair| first(&pair[0]) < first(&pair[1]))
        })
}

/// Horizontal position of a station, SI units.
fn abscissa(report: &Report, station: &[f64], driven: bool) -> f64 {
    let place = match driven {
        true => report.case.place(station),
        false => station.to_vec(),
    };
    place.first().copied().unwrap_or(f64::NAN)
}

/// Panels of the variables over a single axis, and of coefficients.
fn curves(
    report: &Report,
    selection: &Selection,
    across: &Across,
) -> (Vec<f64>, Vec<Panel>, Vec<Panel>) {
    let case = &report.case;
    let Some(line) = report.lines.first() else {
        return (Vec::new(), Vec::new(), Vec::new());
    };
    let wanted = wanted(report, selection);
    let driven = is_driven(report);
    let mut order: Vec<usize> = (0..line.stations.len()).collect();
    let position = |index: usize| abscissa(report, &line.stations[index], driven);
    // A sweep may run backwards, an axis does not.
    if order.windows(2).any(|pair| position(pair[1]) < position(pair[0])) {
        order.reverse();
    }
    let positions: Vec<f64> = order.iter().map(|&index| position(index)).collect();
    let values = order.iter().map(|&index| match &line.samples[index] {
        Some(sample) => case.values(sample)[..wanted].to_vec(),
        None => vec![f64::NAN; wanted],
    });
    let values: Vec<_> = values.collect();
    let reached = |index: &usize| {
        let sample = line.samples[*index].as_ref();
        sample.map(|_| line.stations[*index].clone())
    };
    let reached: Vec<_> = order.iter().map(reached).collect();
    let beside = coefficients::panels(report, selection, across, &reached);
    let published = published(report, across, driven);
    let variables = &case.variables[..wanted];
    if !is_apart(variables, &values) {
        let panels = choose(variables, &values, published, selection);
        return (positions, panels, beside);
    }
    let one = |index: usize| {
        let values: Vec<_> = values.iter().map(|row| vec![row[index]]).collect();
        let known = published.iter().filter(|known| known.variable == index);
        let known = known.map(|known| Published { variable: 0, ..*known });
        let mut panels = choose(&variables[index..=index], &values, known.collect(), selection);
        let lines = panels.iter_mut().flat_map(|panel| &mut panel.curves);
        lines.for_each(|line| line.colour = Some(index));
        panels
    };
    let panels = (0..variables.len()).flat_map(one).collect();
    (positions, panels, beside)
}

fn choose(
    variables: &[Variable],
    values: &[Vec<f64>],
    published: Vec<Published>,
    selection: &Selection,
) -> Vec<Panel> {
    let data = Data { variables, values, errors: &vec![0.0; variables.len()], published };
    panels::choose(&data, selection)
}

/// Whether a few curves of one kind change so little beside their distance that each needs a panel of its own.
fn is_apart(variables: &[Variable], values: &[Vec<f64>]) -> bool {
    let alike = variables.windows(2).all(|pair| Kind::of(&pair[0]) == Kind::of(&pair[1]));
    if !alike || !(2..=ALONE).contains(&variables.len()) {
        return false;
    }
    let ends = |index: usize| {
        let column = values.iter().map(|row| row[index]).filter(|value| value.is_finite());
        column.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        })
    };
    let each: Vec<_> = (0..variables.len()).map(ends).collect();
    let most = each.iter().map(|(low, high)| high - low).fold(0.0, f64::max);
    let low = each.iter().fold(f64::INFINITY, |low, one| low.min(one.0));
    let high = each.iter().fold(f64::NEG_INFINITY, |high, one| high.max(one.1));
    high - low > APART * most
}

/// How many variables are shown: the outputs, unless others are asked for or there is none.
fn wanted(report: &Report, selection: &Selection) -> usize {
    let outputs = report.case.scene.outputs.len();
    match selection {
        Selection::Usual if outputs > 0 => outputs,
        _ => report.case.variables.len(),
    }
}

/// Published values, on the axis where the other drivers stand.
fn published(report: &Report, across: &Across, driven: bool) -> Vec<Published> {
    let known = report.published.iter().filter(|one| one.comparable);
    let list = known.filter_map(|one| {
        let at = match (one.fact.at, one.time) {
            (_, Some(time)) => Some(abscissa(report, &[time], driven)),
            (At::Position([(index, position)]), _) => swept(report, *index).then_some(*position),
            (At::Driver(index, position), _) => swept(report, index).then_some(position),
            _ => None,
        };
        Some(Published {
            variable: one.variable?,
            at: at.map(|at| at / across.factor),
            value: one.fact.value,
            is_extreme: matches!(one.fact.at, At::Maximum | At::Minimum | At::Amplitude),
        })
    });
    list.collect()
}

/// Whether this driver is the horizontal axis.
fn swept(report: &Report, index: usize) -> bool {
    matches!(&report.case.moved.task, Task::Sweep(drivers) if drivers.first() == Some(&index))
}

/// For each output a panel with a curve for each position of the second driver.
fn families(report: &Report, selection: &Selection, axes: &[Axis]) -> (Vec<f64>, Vec<Panel>) {
    let case = &report.case;
    let mut lines = case.grid(&Grid::family(case)).unwrap_or_default();
    lines.truncate(FAMILY);
    let Some(first) = lines.first() else {
        return (Vec::new(), Vec::new());
    };
    let mut positions: Vec<f64> = first.stations.iter().map(|station| station[0]).collect();
    let backwards = positions.windows(2).any(|pair| pair[1] < pair[0]);
    if backwards {
        positions.reverse();
    }
    let shown = &case.variables[..wanted(report, selection)];
    let shown = shown.iter().enumerate().filter(|(_, one)| selection.admits(&one.name));
    let panels = shown.map(|(index, variable)| {
        let curves = lines.iter().map(|line| {
            let mut values = column(report, line, variable, index);
            if backwards {
                values.reverse();
            }
            (member(&axes[1], line), values)
        });
        Panel::family(variable, curves.collect())
    });
    (positions, panels.collect())
}

fn column(report: &Report, line: &Line, variable: &Variable, index: usize) -> Vec<f64> {
    let samples = line.samples.iter().map(|sample| match sample {
        Some(sample) => variable.in_unit(report.case.values(sample)[index]),
        None => f64::NAN,
    });
    samples.collect()
}

/// What distinguishes a curve of a family, `β = 30°`.
fn member(axis: &Axis, line: &Line) -> Name {
    let position = line.stations.first().map_or(f64::NAN, |station| station[1]);
    let value = number::short(position / axis.quantity.factor);
    let unit = name::unit(axis.quantity.unit);
    let space = if unit == "°" { "" } else { " " };
    let letter = name::set(axis.quantity.name).text;
    Name { text: format!("{letter} = {value}{space}{unit}").trim_end().to_owned(), italic: false }
}

/// Where the way ends or modes meet, the marks of the equation file, and what was asked for.
fn marks(report: &Report, across: &Across, positions: &[f64]) -> Vec<Mark> {
    let case = &report.case;
    let mark = |at: f64, label: &str, asked: bool| Mark {
        at: at / across.factor,
        label: label.to_owned(),
        asked,
    };
    let driven = is_driven(report);
    let lines = || report.lines.iter().filter(|_| report.lines.len() == 1);
    let first = match &case.moved.task {
        Task::Sweep(drivers) => drivers.first().copied(),
        _ => driven.then_some(0),
    };
    let along = |at: &[f64]| first.and_then(|first| at.get(first).copied());
    let stops = lines().flat_map(|line| &line.stops);
    let stops = stops.filter_map(|error| Some(mark(along(wording::place(error)?)?, "stops", true)));
    let met = lines().flat_map(|line| &line.met);
    let met =
        met.filter_map(|event| Some(mark(along(wording::place_of(event)?)?, "modes meet", false)));
    let stated = case.scene.marks.iter().filter_map(|stated| {
        let at = match stated.at {
            At::Driver(index, position) if Some(index) == first => position,
            At::Position([(index, position)]) if Some(*index) == first => *position,
            At::Time(time) if first.is_none() => time,
            _ => return None,
        };
        Some(mark(at, stated.text, false))
    });
    let asked = report.places.iter().filter_map(|one| {
        let at = match one.place.time {
            Some(time) => abscissa(report, &[time], driven),
            None => along(&one.place.independents)?,
        };
        Some(mark(at, &one.place.label, true))
    });
    let positions: Vec<_> = positions.iter().map(|position| position / across.factor).collect();
    marks::sort(stops.chain(met).chain(stated).chain(asked), &positions)
}

fn made(report: &Report) -> String {
    let kinds = report.case.moved.entry.groups.iter();
    let iterated =
        kinds.filter(|group| !group.kind.has_modes() && group.equations.len() > 1).count();
    match (report.is_complete(), iterated) {
        _ if report.case.is_sheet() => String::new(),
        (false, _) => "the linkage does not get to all positions".to_owned(),
        (true, 0) => "loops closed in closed form".to_owned(),
        (true, _) => "loops closed to rounding".to_owned(),
    }
}
