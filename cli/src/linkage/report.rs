//! Everything that `assur run` has to say about a linkage, as numbers in SI units; how it is printed is decided elsewhere.

use std::cell::Cell;
use std::path::Path;
use std::time::Instant;

use assur::closure::{ClosureError, Sample, Stroke};
use assur::scalar::fault;
use serde::Serialize;

use super::case::{Case, MARGIN};
use super::found::Found;
use super::group;
use super::influence::{self, Influence};
use super::line::{Grid, Line};
use super::place::Place;
use super::reach::{self, Reach};
use super::rounding;
use super::search::{Extreme, smallest};
use super::undefined;
use super::wording::{Terms, contradiction, event};
use super::{csv, json, table};
use crate::answer::Answer;
use crate::arguments::Rows;
use crate::error::{Failure, Told};
use crate::plot;
use crate::published::{self, Comparison};
use crate::run::Shown;
use crate::show::measures::Measured;
use crate::show::number;
use crate::show::page::Page;

/// All results of a run of a linkage.
pub struct Report {
    /// The linkage with its values.
    pub case: Case,
    /// Finely along the task.
    pub lines: Vec<Line>,
    /// At a few round positions.
    pub rows: Vec<Line>,
    /// Smallest and largest value of each variable.
    pub limits: Vec<Option<(Extreme, Extreme)>>,
    /// How far both may be off by rounding; not numbers where that is not known.
    pub errors: Vec<(f64, f64)>,
    /// How far each driver goes in this assembly mode.
    pub reach: Vec<Reach>,
    /// Strokes over the task where it has one axis, see [`reach::strokes`].
    pub strokes: Option<Vec<Stroke>>,
    /// Numbers of the whole task.
    pub measures: Vec<Measured>,
    /// Where each group transmits worst, its sine being smallest.
    pub transmissions: Vec<(usize, Extreme)>,
    /// That it is put together far from its start values, or why its measures are missing, in words.
    pub note: Option<String>,
    /// What happened on the way, place and event in words.
    pub met: Vec<(String, String)>,
    /// Why positions of the task are not reached, in words, each once.
    pub stops: Vec<Told>,
    /// Everything at the places that were asked for.
    pub places: Vec<Snapshot>,
    /// Published values beside the computed ones.
    pub published: Vec<Comparison>,
    /// What it cost.
    pub cost: Cost,
    /// What is wanted of it.
    pub shown: Shown,
}

/// The linkage at one place.
pub struct Snapshot {
    /// The place.
    pub place: Place,
    /// The linkage there.
    pub sample: Sample,
    /// How far each variable may be off by rounding; not a number where that is not known.
    pub errors: Vec<f64>,
    /// What each driver and dimension does to the outputs there.
    pub influence: Vec<Influence>,
}

/// Work and its quality.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Positions of the task.
    pub positions: usize,
    /// Those that were reached.
    pub reached: usize,
    /// Seconds that they took.
    pub closing: f64,
    /// Seconds of everything.
    pub total: f64,
    /// By which share of the size of what is integrated an integral may be wrong at most; zero where there is none.
    pub doubt: f64,
    /// The loop equation that is left worst, and what is left of it in SI units.
    pub gap: Option<(usize, f64)>,
}

impl Report {
    /// How far a variable may be off at a place of the task, SI units; not a number where that is not known.
    pub fn error(&self, place: &Extreme, variable: usize) -> f64 {
        let errors = rounding::at(&self.case, &self.case.place(&place.station));
        rounding::or_more(errors[variable], self.cost.doubt * place.value.abs())
    }

    /// Whether every position of the task was reached.
    pub fn is_complete(&self) -> bool {
        self.stops.is_empty()
    }
}

impl Answer for Report {
    fn figure(&self) -> Option<String> {
        (!self.lines.is_empty()).then(|| plot::draw_linkage(self, &self.shown.curves))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        table::render(page, self, figure);
    }

    fn csv(&self) -> String {
        match self.shown.rows {
            Rows::Limits => csv::limits(self),
            _ => csv::render(self),
        }
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        json::run(self, figure)
    }

    fn outcome(&self) -> Result<(), Failure> {
        let mut stops = self.stops.iter();
        let Some(first) = stops.next() else {
            return Ok(());
        };
        let what = format!(
            "the linkage does not reach the whole task: {} of {} positions are missing",
            self.cost.positions - self.cost.reached,
            self.cost.positions
        );
        let failure = first.clone().failure(what);
        Err(stops.take(3).fold(failure, |failure, stop| failure.reason(stop.reason.as_str())))
    }
}

/// Moves a linkage through its task, over a grid of it, and collects what there is to say about it.
///
/// # Errors
/// When it cannot be put together, or a place that was asked for is not reached.
pub fn collect(
    case: Case,
    grid: &Grid,
    places: Vec<Place>,
    shown: Shown,
) -> Result<Report, Failure> {
    let clock = Instant::now();
    fault::take_doubt();
    let apart = |case: &Case, error: &ClosureError| {
        case.tell(error).failure("the linkage cannot be put together")
    };
    let found = Found::on(grid, case).map_err(|found| apart(&found.0, &found.1))?;
    let published = published::compare(&found)?;
    let Found { case, lines, strokes, measures, unmeasured, seconds: closing } = found;
    let doubt = fault::take_doubt();
    let rows = case.grid(&Grid::coarse(&case)).map_err(|error| apart(&case, &error))?;
    let places: Vec<_> =
        places.into_iter().map(|place| snapshot(&case, place, doubt)).collect::<Result<_, _>>()?;
    let variables = 0..case.variables.len();
    let limits = variables.map(|index| reach::extremes(&case, &lines, strokes.as_ref(), index));
    let limits: Vec<_> = limits.collect();
    let errors = rounding::of_limits(&case, &limits, doubt);
    let transmissions = (0..case.moved.entry.groups.len())
        .filter(|&index| group::transmits(&case.moved.entry.groups[index]))
        .filter_map(|index| {
            let dead = strokes.as_ref().and_then(|_| reach::dead_end(&case, index));
            let worst = || smallest(&case, &lines, |sample| sample.sines[index].abs());
            Some((index, dead.or_else(worst)?))
        });
    let transmissions = transmissions.collect();
    let names = Terms { entry: case.moved.entry, drivers: &case.drivers };
    let mut met: Vec<_> =
        lines.iter().flat_map(|line| &line.met).map(|one| event(names, one)).collect();
    met.dedup();
    let mut stops: Vec<Told> = Vec::new();
    for told in lines.iter().flat_map(|line| &line.stops).map(|error| case.tell(error)) {
        if !stops.contains(&told) {
            stops.push(told);
        }
    }
    let reach = reach::of(&case);
    let note = contradiction(&case.constants, case.run())
        .or_else(|| unfound(&case, &rows, &places))
        .or_else(|| unmeasured.filter(|_| stops.is_empty()).map(|error| without(&case, &error)));
    let cost = Cost {
        positions: lines.iter().map(|line| line.stations.len()).sum(),
        reached: lines.iter().map(|line| line.reached().count()).sum(),
        closing,
        total: clock.elapsed().as_secs_f64(),
        doubt,
        gap: gap(&lines, &places),
    };
    Ok(Report {
        lines,
        rows,
        limits,
        errors,
        reach,
        strokes,
        measures,
        transmissions,
        note,
        met,
        stops,
        places,
        published,
        cost,
        case,
        shown,
    })
}

/// Why something that is looked for has no value, or none that is known well, at the first place where that is so.
fn unfound(case: &Case, rows: &[Line], asked: &[Snapshot]) -> Option<String> {
    let is_read = Cell::new(false);
    let fault_at = |place: Vec<f64>| {
        fault::take();
        let sample = case.at(place.clone()).ok()?;
        // What a branch that does not hold lacks is no matter.
        let is_none = sample.outputs.iter().any(|value| value.is_nan());
        match fault::take() {
            Some(fault) => (is_none || fault.is_rough()).then(|| fault.to_string()),
            None if is_none && case.is_sheet() && !is_refused(case, &sample) => {
                // The equations are read once.
                (!is_read.replace(true)).then(|| undefined::tell(case, &place)).flatten()
            }
            None => None,
        }
    };
    let mut stations = rows.iter().flat_map(Line::reached).map(|(station, _)| station);
    let on_the_way = stations.find_map(|station| {
        Some((station_in_words(case, station), fault_at(case.place(station))?))
    });
    let there = || {
        asked.iter().find_map(|one| {
            Some((one.place.label.clone(), fault_at(one.place.independents.clone())?))
        })
    };
    let (place, why) = on_the_way.or_else(there)?;
    Some(format!("at {place}: {why}"))
}

/// Whether a condition does not hold, whose margin is among the outputs.
pub fn is_refused(case: &Case, sample: &Sample) -> bool {
    let outputs = case.scene.outputs.iter().zip(&sample.outputs);
    outputs.into_iter().any(|(output, value)| output.name.starts_with(MARGIN) && *value <= 0.0)
}

/// `u = 3 deg, y = 2 mm`
fn station_in_words(case: &Case, station: &[f64]) -> String {
    let axes = case.axes();
    let places = axes.iter().zip(station).map(|(axis, at)| {
        let quantity = &axis.quantity;
        let at = number::short(at / quantity.factor);
        format!("{} = {at} {}", quantity.name, quantity.unit).trim_end().to_owned()
    });
    places.collect::<Vec<_>>().join(", ")
}

/// The linkage at a place that was asked for.
///
/// # Errors
/// Why it does not get there.
pub fn sample(case: &Case, place: &Place) -> Result<Sample, Failure> {
    case.at(place.independents.clone()).map_err(|error| {
        case.tell(&error)
            .failure(format!("the linkage does not get to {}", place.label))
            .place(place.option.as_str())
    })
}

/// The same with all that is told of it, where integrals are known to this part of their size.
fn snapshot(case: &Case, place: Place, doubt: f64) -> Result<Snapshot, Failure> {
    let sample = sample(case, &place)?;
    let mut influence = influence::at(case, &place.independents);
    for value in influence.iter_mut().flat_map(|one| one.values.iter_mut().zip(&sample.outputs)) {
        // What has no value does not change.
        if value.1.is_nan() {
            *value.0 = f64::NAN;
        }
    }
    rounding::of_influence(case, &place.independents, &mut influence);
    let errors = rounding::at(case, &place.independents).into_iter().zip(case.values(&sample));
    let errors = errors.map(|(error, value)| rounding::or_more(error, doubt * value.abs()));
    let errors = errors.collect();
    Ok(Snapshot { influence, errors, sample, place })
}

/// The loop equation that is left worst.
fn gap(lines: &[Line], places: &[Snapshot]) -> Option<(usize, f64)> {
    let swept = lines.iter().flat_map(Line::reached).map(|(_, sample)| sample);
    let all = swept.chain(places.iter().map(|place| &place.sample));
    let left = all.flat_map(|sample| sample.residuals.iter().map(|left| left.abs()).enumerate());
    left.max_by(|(_, a), (_, b)| a.total_cmp(b))
}

/// That the measures of a task that is gone through are missing.
fn without(case: &Case, error: &ClosureError) -> String {
    format!("The measures of the task are missing: {}.", case.tell(error).reason)
}
