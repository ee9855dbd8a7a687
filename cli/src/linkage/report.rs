//! Everything that `assur run` has to say about a linkage, as numbers in SI units; how it is printed is decided elsewhere.

use std::time::Instant;

use assur::closure::{ClosureError, Stroke};
use assur::problem::Span;
use assur::registry::{Mechanism, Sample};

use super::case::{Case, Task};
use super::group;
use super::influence::{self, Influence};
use super::line::{Grid, Line};
use super::place::Place;
use super::published;
use super::reach::{self, Reach};
use super::search::{Extreme, smallest};
use super::wording::{Names, Told, contradiction, event, tell};
use crate::error::Failure;
use crate::published::Comparison;

/// All results of a run of a linkage.
pub struct Report {
    /// The mechanism.
    pub mechanism: &'static Mechanism,
    /// The linkage with its values.
    pub case: Case,
    /// Finely along the task.
    pub lines: Vec<Line>,
    /// At a few round positions.
    pub rows: Vec<Line>,
    /// Smallest and largest value of each variable.
    pub limits: Vec<Option<(Extreme, Extreme)>>,
    /// How far each driver goes in this assembly mode.
    pub reach: Vec<Reach>,
    /// Strokes over the task where it has one axis, see [`reach::strokes`].
    pub strokes: Option<Vec<Stroke>>,
    /// Where each group transmits worst, its sine being smallest.
    pub transmissions: Vec<(usize, Extreme)>,
    /// That it is put together far from its start values, in words.
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
}

/// The linkage at one place.
pub struct Snapshot {
    /// The place.
    pub place: Place,
    /// The linkage there.
    pub sample: Sample,
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
    /// The loop equation that is left worst, and what is left of it in SI units.
    pub gap: Option<(usize, f64)>,
}

impl Report {
    /// Whether every position of the task was reached.
    pub fn is_complete(&self) -> bool {
        self.stops.is_empty()
    }

    /// Why the linkage does not get everywhere, once everything else is printed.
    ///
    /// # Errors
    /// The reasons.
    pub fn outcome(self) -> Result<(), Failure> {
        let mut stops = self.stops.into_iter();
        let Some(first) = stops.next() else {
            return Ok(());
        };
        let what = format!(
            "the linkage does not reach the whole task: {} of {} positions are missing",
            self.cost.positions - self.cost.reached,
            self.cost.positions
        );
        let failure = first.failure(what);
        Err(stops.take(3).fold(failure, |failure, stop| failure.reason(stop.reason)))
    }
}

/// Moves a linkage through its task and collects what there is to say about it.
///
/// # Errors
/// When it cannot be put together, or a place that was asked for is not reached.
pub fn collect(
    mechanism: &'static Mechanism,
    case: Case,
    places: Vec<Place>,
) -> Result<Report, Failure> {
    let names = Names { entry: case.entry, drivers: &case.drivers };
    let clock = Instant::now();
    let apart = |error: ClosureError| {
        let told = tell(names, &error);
        told.failure("the linkage cannot be put together")
    };
    let lines = case.grid(&Grid::fine(&case)).map_err(apart)?;
    let closing = clock.elapsed().as_secs_f64();
    let rows = case.grid(&Grid::coarse(&case)).map_err(apart)?;
    let places: Vec<_> =
        places.into_iter().map(|place| snapshot(&case, place)).collect::<Result<_, _>>()?;
    let strokes = reach::strokes(&case);
    let variables = 0..case.variables.len();
    let limits = variables.map(|index| reach::extremes(&case, &lines, strokes.as_ref(), index));
    let limits = limits.collect();
    let transmissions = (0..case.entry.groups.len())
        .filter(|&index| group::transmits(&case.entry.groups[index]))
        .filter_map(|index| {
            let dead = strokes.as_ref().and_then(|_| reach::dead_end(&case, index));
            let worst = || smallest(&case, &lines, |sample| sample.sines[index].abs());
            Some((index, dead.or_else(worst)?))
        });
    let transmissions = transmissions.collect();
    let mut met: Vec<_> =
        lines.iter().flat_map(|line| &line.met).map(|one| event(names, one)).collect();
    met.dedup();
    let mut stops: Vec<Told> = Vec::new();
    for told in lines.iter().flat_map(|line| &line.stops).map(|error| tell(names, error)) {
        if !stops.contains(&told) {
            stops.push(told);
        }
    }
    let published = published::compare(mechanism, &case, &lines, strokes.as_ref())?;
    let reach = reach::of(&case);
    let note = contradiction(mechanism, case.scene, case.run());
    let cost = Cost {
        positions: lines.iter().map(|line| line.stations.len()).sum(),
        reached: lines.iter().map(|line| line.reached().count()).sum(),
        closing,
        total: clock.elapsed().as_secs_f64(),
        gap: gap(&lines, &places),
    };
    Ok(Report {
        mechanism,
        lines,
        rows,
        limits,
        reach,
        strokes,
        transmissions,
        note,
        met,
        stops,
        places,
        published,
        cost,
        case,
    })
}

/// The linkage at a place that was asked for.
///
/// # Errors
/// Why it does not get there.
pub fn snapshot(case: &Case, place: Place) -> Result<Snapshot, Failure> {
    let sample = case.at(place.independents.clone()).map_err(|error| {
        let names = Names { entry: case.entry, drivers: &case.drivers };
        tell(names, &error)
            .failure(format!("the linkage does not get to {}", place.label))
            .place(place.option.as_str())
    })?;
    Ok(Snapshot { influence: influence::at(case, &place.independents), sample, place })
}

/// The loop equation that is left worst.
fn gap(lines: &[Line], places: &[Snapshot]) -> Option<(usize, f64)> {
    let swept = lines.iter().flat_map(Line::reached).map(|(_, sample)| sample);
    let all = swept.chain(places.iter().map(|place| &place.sample));
    let left = all.flat_map(|sample| sample.residuals.iter().map(|left| left.abs()).enumerate());
    left.max_by(|(_, a), (_, b)| a.total_cmp(b))
}

/// The task in words.
pub fn task(case: &Case) -> String {
    let names = |drivers: &[usize]| {
        let names = drivers.iter().map(|&index| case.drivers[index].name);
        names.collect::<Vec<_>>().join(" and ")
    };
    match &case.task {
        Task::Sweep(drivers) => format!("positions over {}", names(drivers)),
        Task::Time(Span::Periodic(period)) => {
            format!("positions over one period of {} s", crate::number::short(*period))
        }
        Task::Time(span) => {
            let (from, to) = span.limits();
            let [from, to] = [from, to].map(crate::number::short);
            format!("positions from {from} s to {to} s")
        }
        Task::Open => "positions".to_owned(),
    }
}
