//! The stations of a task, reached from where the linkage is put together.
//!
//! Along a line the first driver moves and the others stand, or the time runs. A driver whose start lies inside its
//! range goes from there to both ends, so that a dead point on one side does not hide the other.

use assur::closure::{ClosureError, Event, Sample};
use assur::problem::Span;

use super::case::{Axis, Case, Task};
use super::{places, round};
use crate::error::Failure;

/// Stations that differ in the fastest axis alone.
pub struct Line {
    /// The stations.
    pub stations: Vec<Vec<f64>>,
    /// The linkage at each of them; none where it does not get.
    pub samples: Vec<Option<Sample>>,
    /// What happened on the way.
    pub met: Vec<Event>,
    /// Why stations at the ends are not reached.
    pub stops: Vec<ClosureError>,
    /// Groups whose assembly mode had to be assumed.
    pub assumed: Vec<usize>,
}

impl Line {
    /// The stations that are reached, with the linkage there.
    pub fn reached(&self) -> impl Iterator<Item = (&[f64], &Sample)> {
        let pairs = self.stations.iter().zip(&self.samples);
        pairs.filter_map(|(station, sample)| Some((station.as_slice(), sample.as_ref()?)))
    }

    /// Goes through stations from the first to the last of these, and notes what is found.
    fn go(
        &mut self,
        case: &Case,
        hub: Option<&Vec<f64>>,
        order: impl Iterator<Item = usize>,
    ) -> Result<(), ClosureError> {
        let order: Vec<_> = order.collect();
        if order.is_empty() {
            return Ok(());
        }
        let way = order.iter().map(|&index| &self.stations[index]);
        let way: Vec<_> = hub.into_iter().chain(way).cloned().collect();
        let path = case.follow(&way)?;
        let found = path.samples.into_iter().skip(usize::from(hub.is_some()));
        for (index, sample) in order.into_iter().zip(found) {
            self.samples[index] = Some(sample);
        }
        self.met.extend(path.events.into_iter().map(|(_, event)| event));
        self.stops.extend(path.stopped);
        self.assumed = path.start.assumed;
        Ok(())
    }
}

impl Case {
    /// Follows the linkage along a line.
    ///
    /// # Errors
    /// Why it cannot be put together.
    pub fn line(&self, stations: Vec<Vec<f64>>) -> Result<Line, ClosureError> {
        self.line_along(0, stations)
    }

    /// Follows the linkage along a line on which this axis moves.
    ///
    /// # Errors
    /// Why it cannot be put together.
    pub fn line_along(&self, axis: usize, stations: Vec<Vec<f64>>) -> Result<Line, ClosureError> {
        let mut line = Line {
            samples: vec![None; stations.len()],
            stations,
            met: Vec::new(),
            stops: Vec::new(),
            assumed: Vec::new(),
        };
        let count = line.stations.len();
        let Some(hub) = self.hub(axis, &line.stations) else {
            line.go(self, None, 0..count)?;
            return Ok(line);
        };
        // Where it is put together it need not go first.
        let way = Some(&hub).filter(|hub| self.place(hub) != self.standing());
        let rises = line.stations[0][axis] < line.stations[count - 1][axis];
        let split = line.stations.partition_point(|station| {
            (station[axis] < hub[axis]) == rises && station[axis] != hub[axis]
        });
        line.go(self, way, split..count)?;
        line.go(self, way, (0..split).rev())?;
        // Both ways begin alike.
        if line.stops.len() > 1 && line.samples.iter().all(Option::is_none) {
            line.stops.truncate(1);
        }
        Ok(line)
    }

    /// The station between others at which the driver that moves starts, if there is one.
    fn hub(&self, axis: usize, stations: &[Vec<f64>]) -> Option<Vec<f64>> {
        let Task::Sweep(drivers) = &self.moved.task else {
            return None;
        };
        let (first, last) = (stations.first()?, stations.last()?);
        let mut hub = first.clone();
        hub[axis] = self.moved.ranges[*drivers.get(axis)?].start;
        let (low, high) = (first[axis].min(last[axis]), first[axis].max(last[axis]));
        (low < hub[axis] && hub[axis] < high).then_some(hub)
    }

    /// The lines of a grid: the fastest axis in so many parts, the others in fewer.
    ///
    /// # Errors
    /// Why the linkage cannot be put together.
    pub fn grid(&self, stations: &Grid) -> Result<Vec<Line>, ClosureError> {
        let Some((first, others)) = stations.axes.split_first() else {
            return Ok(Vec::new());
        };
        let mut rows = vec![Vec::new()];
        for axis in others {
            let longer = |row: Vec<f64>| {
                let extend = move |position: &f64| [row.as_slice(), &[*position]].concat();
                axis.iter().map(extend).collect::<Vec<_>>()
            };
            rows = rows.into_iter().flat_map(longer).collect();
        }
        let line = |row: Vec<f64>| {
            let station = |position: &f64| [&[*position], row.as_slice()].concat();
            self.line(first.iter().map(station).collect())
        };
        rows.into_iter().map(line).collect()
    }
}

/// Values along each axis of a task.
pub struct Grid {
    axes: Vec<Vec<f64>>,
}

impl Grid {
    /// A few values at round numbers, to read.
    pub fn coarse(case: &Case) -> Self {
        if let Some(times) = at_round_positions(case) {
            return Self { axes: vec![times] };
        }
        let axes = case.axes();
        Self { axes: a_few(&axes) }
    }

    /// Many values of the first axis, a few of the second; the others stand in the middle.
    pub fn family(case: &Case) -> Self {
        let axes = case.axes().into_iter().enumerate();
        let axes = axes.map(|(index, axis)| {
            let between = |parts| round::positions(&axis.quantity, axis.from, axis.to, parts);
            match index {
                0 => between(180),
                1 => between(4),
                _ => vec![(axis.from + axis.to) / 2.0],
            }
        });
        Self { axes: axes.collect() }
    }

    /// So many values of each axis as `--places` says, evenly apart.
    ///
    /// # Errors
    /// What is no number of places, or of no axis.
    pub fn even(case: &Case, places: &str, most: usize) -> Result<Self, Failure> {
        let axes = case.axes();
        let counts = places::read(&axes, places, most)?;
        Ok(Self {
            axes: axes.iter().zip(counts).map(|(axis, count)| evenly(axis, count)).collect(),
        })
    }

    /// As many values as curves and extremes need.
    pub fn fine(case: &Case) -> Self {
        let axes = case.axes();
        let parts = match axes.len() {
            0 | 1 => 360,
            2 => 36,
            _ => 12,
        };
        let along = axes.iter();
        let axes =
            along.map(|axis| round::positions(&axis.quantity, axis.from, axis.to, parts)).collect();
        Self { axes }
    }
}

/// Values evenly apart, both ends included.
fn evenly(axis: &Axis, count: usize) -> Vec<f64> {
    let last = count - 1;
    let value = |index: usize| match index == last {
        true => axis.to,
        false => axis.from + (axis.to - axis.from) * (index as f64 / last as f64),
    };
    (0..count).map(value).collect()
}

/// A few values of each axis at round numbers.
fn a_few(axes: &[Axis]) -> Vec<Vec<f64>> {
    let few = |parts: usize| {
        let axes = axes.iter();
        axes.map(|axis| round::positions(&axis.quantity, axis.from, axis.to, parts))
            .collect::<Vec<_>>()
    };
    let (sizes, most) = match axes.len() {
        0 | 1 => (6..=10, 13),
        _ => (4..=8, 9),
    };
    let fits = |axes: &Vec<Vec<f64>>| axes.iter().all(|axis| axis.len() <= most);
    sizes.rev().map(few).find(fits).unwrap_or_else(|| few(4))
}

/// The times at which the first driver has round positions, if it moves in time and never turns round.
fn at_round_positions(case: &Case) -> Option<Vec<f64>> {
    let Task::Time(span) = &case.moved.task else {
        return None;
    };
    let (from, to) = span.limits();
    let position = |time: f64| case.place(&[time]).first().copied().unwrap_or(f64::NAN);
    let axis = Axis { quantity: *case.drivers.first()?, from: position(from), to: position(to) };
    let wanted = a_few(&[axis]).pop()?;
    let (last, between) = wanted.get(1..)?.split_last()?;
    let run = Span::Run(from, to);
    let times = between.iter().map(|wanted| run.time_of(position, *wanted).ok());
    let times: Vec<f64> =
        [Some(from)].into_iter().chain(times).chain([Some(to)]).collect::<Option<_>>()?;
    let advances = times.windows(2).all(|pair| pair[0] < pair[1]);
    (advances && last.is_finite()).then_some(times)
}
