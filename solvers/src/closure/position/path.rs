//! A linkage moved through positions.

use std::hint::black_box;
use std::time::Instant;

use crate::closure::{AnyLinkage, ClosureError, Event, Guide, Start};

/// A linkage at one position.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Positions of the drivers, and behind them how they move where that is known.
    pub independents: Vec<f64>,
    /// The dependent coordinates, angles continued over whole turns.
    pub dependents: Vec<f64>,
    /// The outputs.
    pub outputs: Vec<f64>,
    /// The points, x and y of each.
    pub points: Vec<f64>,
    /// Kinematic coefficients: for each driver the derivatives of the dependent coordinates.
    pub coefficients: Vec<Vec<f64>>,
    /// Assembly mode of each group, ±1.
    pub modes: Vec<f64>,
    /// Sine of the transmission angle of each group; small near a dead point.
    pub sines: Vec<f64>,
    /// What is left of each loop equation.
    pub residuals: Vec<f64>,
}

/// The positions that were reached.
#[derive(Clone, Debug)]
pub struct Path {
    /// What had to be assumed to put the linkage together.
    pub start: Start,
    /// The positions, in the order of those asked for.
    pub samples: Vec<Sample>,
    /// What happened on the way, each with the number of the sample that it came before.
    pub events: Vec<(usize, Event)>,
    /// Why the last positions were not reached.
    pub stopped: Option<ClosureError>,
}

/// Positions between which the time of a move is measured.
const PLACES: usize = 256;

impl dyn AnyLinkage + '_ {
    /// Puts the linkage together where its start values are meant and moves it through the places, in their order. Each is
    /// the positions of the drivers, and behind them how these move where that is known ([`AnyLinkage::drive`]).
    ///
    /// # Errors
    /// Why it cannot be put together. Where the way ends before the last place the path says so.
    pub fn follow(&self, places: &[Vec<f64>]) -> Result<Path, ClosureError> {
        let mut assembly = self.assemble();
        let start = assembly.guide().start()?;
        let mut path = Path {
            start,
            samples: Vec::with_capacity(places.len()),
            events: Vec::new(),
            stopped: None,
        };
        for place in places {
            let (drivers, motion) = place.split_at(place.len().min(self.shape().drivers.len()));
            // Where it stands already there is no way whose direction could be kept.
            let moved = match drivers == assembly.guide().independents {
                true => Ok(()),
                false => assembly.move_to(drivers),
            };
            let (count, mut guide) = (path.samples.len(), assembly.guide());
            let events = guide.take_events().into_iter();
            path.events.extend(events.map(|event| (count, event)));
            if let Err(error) = moved {
                path.stopped = Some(error);
                break;
            }
            path.samples.push(self.sample(guide, motion));
        }
        Ok(path)
    }

    /// The place where an assembly stands.
    fn sample(&self, mut guide: Guide<'_, f64>, motion: &[f64]) -> Sample {
        let (shape, loops) = (self.shape(), guide.loops);
        let (entry, drivers) = (shape.loops(), guide.independents.to_vec());
        let instant = loops.instant_row(&drivers, self.motion(motion));
        let mut outputs = vec![0.0; shape.outputs.len()];
        loops.outputs(&instant, guide.position, &mut outputs);
        guide.strike_undetermined(&instant, &mut outputs);
        let mut points = vec![0.0; shape.places()];
        loops.points(&instant, guide.position, &mut points);
        let dependents = entry.dependents.len();
        let mut columns = vec![0.0; dependents * drivers.len()];
        loops.coefficients(&instant, guide.position, &mut columns);
        if guide.is_singular() {
            columns.fill(f64::NAN);
        }
        let mut residuals = vec![0.0; dependents];
        loops.residual(&instant, guide.position, &mut residuals);
        let groups = 0..entry.groups.len();
        let column = |driver: usize| columns[driver * dependents..][..dependents].to_vec();
        Sample {
            coefficients: (0..drivers.len()).map(column).collect(),
            independents: drivers.into_iter().chain(motion.iter().copied()).collect(),
            dependents: guide.coordinates(),
            outputs,
            points,
            modes: groups.clone().map(|group| guide.mode(group)).collect(),
            sines: groups.map(|group| guide.sine(group)).collect(),
            residuals,
        }
    }

    /// Influence coefficients at a place: outputs by variables, row by row.
    ///
    /// # Errors
    /// Why the linkage does not get there.
    pub fn influence(&self, place: &[f64]) -> Result<Vec<f64>, ClosureError> {
        let shape = self.shape();
        let mut assembly = self.assemble();
        assembly.guide().start()?;
        let (drivers, motion) = place.split_at(place.len().min(shape.drivers.len()));
        assembly.move_to(drivers)?;
        let guide = assembly.guide();
        let instant = guide.loops.instant_row(drivers, self.motion(motion));
        let mut values = vec![0.0; shape.outputs.len() * shape.loops().variables.len()];
        guide.loops.influence(&instant, guide.position, &mut values);
        if guide.is_singular() {
            values.fill(f64::NAN);
        }
        Ok(values)
    }

    /// Nanoseconds of one move between neighbouring positions of the task, outputs included, measured over this many;
    /// not a number if it has no two positions that are reached.
    pub fn time_position(&self, moves: usize) -> f64 {
        let mut assembly = self.assemble();
        if assembly.guide().start().is_err() {
            return f64::NAN;
        }
        let drivers = self.shape().drivers.len();
        let reached = |place: &Vec<f64>| assembly.move_to(&place[..drivers]).is_ok();
        let places: Vec<_> = self.places().into_iter().take_while(reached).collect();
        if places.len() < 2 {
            return f64::NAN;
        }
        let mut outputs = vec![0.0; self.shape().outputs.len()];
        let clock = Instant::now();
        let back = places.iter().rev().skip(1);
        let back_and_forth = back.chain(places.iter().skip(1)).cycle();
        for place in back_and_forth.take(moves) {
            if assembly.move_to(&place[..drivers]).is_err() {
                return f64::NAN;
            }
            assembly.guide().outputs(&mut outputs);
            black_box(&outputs);
        }
        clock.elapsed().as_secs_f64() * 1e9 / moves as f64
    }

    /// Positions along the task, all drivers moving at once.
    fn places(&self) -> Vec<Vec<f64>> {
        let share = |index: usize| index as f64 / PLACES as f64;
        let (first, last) = self.span().limits();
        let ranges = self.ranges();
        let place = |index: usize| {
            let moving = self.drive(first + share(index) * (last - first));
            moving.unwrap_or_else(|| {
                let along = ranges.iter();
                along.map(|range| range.from + share(index) * (range.to - range.from)).collect()
            })
        };
        (0..=PLACES).map(place).collect()
    }
}
