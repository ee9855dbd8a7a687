//! `assur draw`: a linkage at some positions, and moving.
//!
//! | file | what it does |
//! |---|---|
//! | `geometry` | which points stand, which move, which move straight |
//! | `sheet` | the paper: scale, title, legend, scale bar |
//! | `joints`, `names` | pivots and slides at one position, names of points |
//! | `still`, `moving` | the two pictures |

mod geometry;
mod joints;
mod moving;
mod names;
mod sheet;
mod still;

use std::f64::consts::PI;
use std::path::PathBuf;

use assur::closure::{ClosureError, Sample};
use assur::shape::Quantity;

use crate::arguments::DrawArguments;
use crate::ask::For;
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::linkage::case::{Case, Task};
use crate::linkage::line::Line;
use crate::linkage::place;
use crate::linkage::report::snapshot;
use crate::linkage::wording::contradiction;
use crate::plot::name;
use crate::show::number;
use crate::show::output::{self, Destination};
use geometry::Geometry;

/// Positions that are drawn unless others are asked for.
const POSITIONS: usize = 5;
/// Positions that are drawn of a motion that comes back to its beginning.
const AROUND: usize = 6;
/// Positions along the way, of which paths are made.
const FINE: usize = 240;
/// Positions of the moving picture.
const FRAMES: usize = 96;

/// Draws a linkage.
///
/// # Errors
/// A wrong request, nothing being written then; or a linkage that does not get everywhere, after the rest of its way has
/// been drawn.
pub fn execute(options: &DrawArguments, registry: Registry) -> Result<(), Failure> {
    let constants = options.asked.find(registry, "draw", For::Linkages)?;
    let (mechanism, scene) = (constants.mechanism, constants.scene);
    let directory = options.out.clone().unwrap_or_else(|| PathBuf::from("."));
    let file = |what: &str| {
        let name = format!("{}-{}-{what}.svg", mechanism.name, scene.name);
        Destination::check(&directory.join(name))
    };
    let (still, moving) = (file("positions")?, file("moving")?);
    let case = Case::new(constants)?;
    if case.moved.entry.points.is_empty() {
        return Err(Failure::request(format!("scene `{}` has no points", scene.name))
            .remedy("state them in the equation file: point A = [0, 0]; link A - B \"crank\";"));
    }
    let places = options.at.iter().map(|text| place::read(&case, text));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    let asked = places
        .into_iter()
        .map(|place| Ok((place.label.clone(), snapshot(&case, place)?.sample)))
        .collect::<Result<Vec<_>, Failure>>()?;
    let way = Travel::follow(&case, asked.is_empty())?;
    let geometry = Geometry::new(&case, &way.samples, asked.iter().map(|(_, sample)| sample));
    let positions = match asked.is_empty() {
        true => way.some(&case, &geometry),
        false => asked,
    };
    let picture =
        Picture { case: &case, geometry: &geometry, label: label(&case.drivers, &positions) };
    let shown: Vec<_> = positions.iter().map(|(_, sample)| sample).collect();
    still.write(still::draw(&picture, &shown).as_bytes())?;
    let mut text = format!(
        "{}, scene {}: {}\nPositions: {}\n",
        mechanism.title,
        scene.name,
        picture.label,
        still.path().display()
    );
    if let Some(note) = contradiction(&case.constants, case.run()) {
        text += &format!("Note:      {note}\n");
    }
    let frames = way.frames(&case, &geometry);
    if frames.len() > 1 {
        moving.write(moving::draw(&picture, &frames).as_bytes())?;
        text += &format!("Moving:    {}\n", moving.path().display());
    }
    output::print(&text)?;
    way.stop.map_or(Ok(()), Err)
}

/// What a picture shows.
pub struct Picture<'a> {
    /// The linkage with its values.
    pub case: &'a Case,
    /// Its points along the way.
    pub geometry: &'a Geometry,
    /// The positions in words.
    pub label: String,
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
