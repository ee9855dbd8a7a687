//! A linkage on its way: one driver moves after the other.

use std::f64::consts::PI;

use assur::closure::{ClosureError, Sample};
use assur::shape::Quantity;

use super::geometry::{Frame, Geometry};
use super::{AROUND, FRAMES, POSITIONS, Shown};
use crate::arguments::DrawArguments;
use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::linkage::case::{Case, Task};
use crate::linkage::line::Line;
use crate::linkage::place;
use crate::linkage::report::sample;
use crate::linkage::wording::contradiction;
use crate::plot::name;
use crate::show::number;

/// Positions along the way, of which paths are made.
const FINE: usize = 240;
/// Seconds of one way.
const WAY: f64 = 4.0;

/// What is shown of a linkage.
///
/// # Errors
/// A wrong request, or a linkage that cannot be put together.
pub fn of(options: &DrawArguments, constants: Constants) -> Result<Shown, Failure> {
    let case = Case::new(constants)?;
    let places = options.at.iter().map(|text| place::read(&case, text));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    let asked = places
        .into_iter()
        .map(|place| Ok((place.label.clone(), sample(&case, &place)?)))
        .collect::<Result<Vec<_>, Failure>>()?;
    let way = Travel::follow(&case, asked.is_empty())?;
    let frame = |sample: &Sample| Frame::of(case.scene, &sample.points, &sample.outputs);
    let all = |samples: &[Sample]| samples.iter().map(frame).collect::<Vec<_>>();
    let ways: Vec<_> = way.samples.iter().map(|samples| all(samples)).collect();
    let shown: Vec<_> = asked.iter().map(|(_, sample)| frame(sample)).collect();
    let geometry = Geometry::new(case.scene.points.len(), &ways, shown.iter());
    let positions = match asked.is_empty() {
        true => way.some(&case, &geometry),
        false => asked,
    };
    let frames = all(&way.frames(&case, &geometry));
    Ok(Shown {
        label: label(&case.drivers, &positions),
        positions: positions.iter().map(|(_, sample)| frame(sample)).collect(),
        seconds: WAY * frames.len() as f64 / FRAMES as f64,
        pace: String::new(),
        note: contradiction(&case.constants, case.run()),
        constants: case.constants,
        geometry,
        frames,
        stop: way.stop,
    })
}

/// The ways of the linkage as far as they are reached: one driver moves after the other, the rest stand where they start.
struct Travel {
    /// For each axis the ends of what is reached.
    ends: Vec<(f64, f64)>,
    /// For each axis positions along it.
    samples: Vec<Vec<Sample>>,
    /// Where each axis stands while another one moves.
    standing: Vec<f64>,
    stop: Option<Failure>,
}

impl Travel {
    /// Follows the linkage along its ways.
    ///
    /// # Errors
    /// When it cannot be put together, or has no way to go and positions are wanted of it.
    fn follow(case: &Case, wanted: bool) -> Result<Self, Failure> {
        let mut way =
            Self { ends: Vec::new(), samples: Vec::new(), standing: standing(case), stop: None };
        let axes = case.axes();
        if axes.is_empty() && wanted {
            let driver = case.drivers.first().map_or("…", |driver| driver.name);
            let what = format!("scene `{}` has no range to go over", case.scene.name);
            let remedy = format!("say where to draw it: --at {driver}=…");
            return Err(Failure::request(what).remedy(remedy));
        }
        for (index, axis) in axes.iter().enumerate() {
            let share = |part: usize| axis.from + (axis.to - axis.from) * part as f64 / FINE as f64;
            let line = way.line(case, index, (0..=FINE).map(share).collect());
            let line = line
                .map_err(|error| case.tell(&error).failure("the linkage cannot be put together"))?;
            if let (Some(error), None) = (line.stops.first(), &way.stop) {
                let missing = line.stations.len() - line.reached().count();
                let share = number::rounded(100.0 * missing as f64 / (FINE + 1) as f64, 2);
                let what = format!(
                    "the linkage does not get over its whole range: {} % of it is missing",
                    number::short(share)
                );
                way.stop = Some(case.tell(error).failure(what));
            }
            let along: Vec<_> = line.reached().map(|(station, _)| station[index]).collect();
            let (Some(first), Some(last)) = (along.first(), along.last()) else {
                return Err(way.stop.unwrap_or_else(Failure::said));
            };
            way.ends.push((*first, *last));
            way.samples.push(line.reached().map(|(_, sample)| sample.clone()).collect());
        }
        Ok(way)
    }

    /// One axis goes through these values.
    fn line(&self, case: &Case, axis: usize, along: Vec<f64>) -> Result<Line, ClosureError> {
        let station = |value: f64| {
            let mut station = self.standing.clone();
            station[axis] = value;
            station
        };
        case.line_along(axis, along.into_iter().map(station).collect())
    }

    /// Some positions over the range of the first axis, evenly apart.
    fn some(&self, case: &Case, geometry: &Geometry) -> Vec<(String, Sample)> {
        let (count, parts) = match geometry.is_closed {
            true => (AROUND, AROUND),
            false => (POSITIONS, POSITIONS - 1),
        };
        let Some((first, last)) = self.ends.first() else {
            return Vec::new();
        };
        let value = |index: usize| first + (last - first) * index as f64 / parts as f64;
        let found = self.line(case, 0, (0..count).map(value).collect());
        let found = found.map(|line| line.samples).unwrap_or_default();
        let found = found.into_iter().flatten();
        found.map(|sample| (case.label(&sample.independents), sample)).collect()
    }

    /// Positions of a moving picture: once round, or there and back, slowly at the ends; one axis after the other.
    fn frames(&self, case: &Case, geometry: &Geometry) -> Vec<Sample> {
        let slowly = |share: f64| (1.0 - (PI * share).cos()) / 2.0;
        let values = |axis: usize| -> Vec<f64> {
            let (first, last) = self.ends[axis];
            let between = |from: f64, to: f64, count: usize| {
                let share = move |index: usize| slowly(index as f64 / count as f64);
                (1..=count).map(move |index| from + (to - from) * share(index))
            };
            if geometry.is_closed {
                let share = |index: usize| index as f64 / FRAMES as f64;
                return (0..=FRAMES).map(|index| first + (last - first) * share(index)).collect();
            }
            let begin = if self.ends.len() > 1 { self.standing[axis] } else { first };
            let begin = begin.clamp(first.min(last), first.max(last));
            let part = |from: f64, to: f64| {
                let share = (to - from).abs() / (last - first).abs();
                between(from, to, (share * FRAMES as f64).ceil() as usize)
            };
            [begin]
                .into_iter()
                .chain(part(begin, last))
                .chain(part(last, first))
                .chain(part(first, begin))
                .collect()
        };
        let line = |axis: usize| {
            let station = |value: f64| {
                let mut station = self.standing.clone();
                station[axis] = value;
                station
            };
            let stations: Vec<_> = values(axis).into_iter().map(station).collect();
            case.follow(&stations).map(|path| path.samples).unwrap_or_default()
        };
        (0..self.ends.len()).flat_map(line).collect()
    }
}

/// Where each axis stands while another one moves.
fn standing(case: &Case) -> Vec<f64> {
    match &case.moved.task {
        Task::Sweep(drivers) => {
            let ranges = drivers.iter().map(|&index| &case.moved.ranges[index]);
            ranges
                .map(|range| if range.start.is_finite() { range.start } else { range.from })
                .collect()
        }
        Task::Time(span) => vec![span.limits().0],
        Task::Open => Vec::new(),
    }
}

/// The positions in words, those of one driver together: `φ₄ = 60, 75, 90 °`.
fn label(drivers: &[Quantity], positions: &[(String, Sample)]) -> String {
    let of_driver = |(index, driver): (usize, &Quantity)| {
        let values = positions.iter().map(|(_, sample)| sample.independents[index] / driver.factor);
        let largest = values.clone().fold(0.0, |most, value| value.abs().max(most));
        let texts = values.map(|value| match value.abs() < 1e-9 * largest {
            true => number::short(0.0),
            false => number::short(number::rounded(value, 5)),
        });
        let mut texts: Vec<_> = texts.collect();
        if texts.iter().all(|text| Some(text) == texts.first()) {
            texts.truncate(1);
        }
        let unit = match name::unit(driver.unit).as_str() {
            "°" => "°".to_owned(),
            other => format!(" {other}"),
        };
        format!("{} = {}{unit}", name::set(driver.name).text, texts.join(", "))
            .trim_end()
            .to_owned()
    };
    let drivers = drivers.iter().enumerate().map(of_driver);
    drivers.collect::<Vec<_>>().join("; ")
}
