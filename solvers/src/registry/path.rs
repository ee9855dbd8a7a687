//! A linkage moved through positions.

use std::hint::black_box;
use std::time::Instant;

use crate::closure::{Assembly, Closure, ClosureError, Event, Linkage, Start};

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

/// Puts a linkage together where its start values are meant and moves it through the places, in their order.
///
/// # Errors
/// Why it cannot be put together. Where the way ends before the last place the path says so.
pub fn follow<L: Linkage>(linkage: &L, places: &[Vec<f64>]) -> Result<Path, ClosureError> {
    let mut assembly = Assembly::<L, f64>::new(linkage);
    let start = assembly.start()?;
    let mut path = Path {
        start,
        samples: Vec::with_capacity(places.len()),
        events: Vec::new(),
        stopped: None,
    };
    for place in places {
        let (drivers, motion) = place.split_at(place.len().min(L::INDEPENDENTS));
        // Where it stands already there is no way whose direction could be kept.
        let moved = match drivers == assembly.independents() {
            true => Ok(()),
            false => assembly.move_to(drivers),
        };
        let count = path.samples.len();
        path.events.extend(
            assembly
                .take_events()
                .into_iter()
                .map(|event| (count, event)),
        );
        if let Err(error) = moved {
            path.stopped = Some(error);
            break;
        }
        path.samples.push(sample(&mut assembly, motion));
    }
    Ok(path)
}

fn sample<L: Linkage>(assembly: &mut Assembly<L, f64>, motion: &[f64]) -> Sample {
    let closure = assembly.closure();
    let instant = match motion.len() == L::MOTION {
        true => closure.moving(assembly.independents(), motion),
        false => closure.instant(assembly.independents()),
    };
    let mut outputs = vec![0.0; L::OUTPUTS];
    closure.outputs(&instant, assembly.position(), &mut outputs);
    assembly.strike_undetermined(&instant, &mut outputs);
    let closure = assembly.closure();
    let position = assembly.position();
    let independents = assembly.independents();
    let mut points = vec![0.0; 2 * L::POINTS];
    closure.points(&instant, position, &mut points);
    let mut columns = vec![closure.zeros(); L::INDEPENDENTS];
    closure.coefficients(&instant, position, &mut columns);
    if assembly.is_singular() {
        columns
            .iter_mut()
            .for_each(|column| column.as_mut().fill(f64::NAN));
    }
    let dependents = |position: &<L::Closure<f64> as Closure<f64>>::Position| {
        position.as_ref()[..L::DEPENDENTS].to_vec()
    };
    let mut residuals = vec![0.0; L::DEPENDENTS];
    closure.residual(&instant, position, &mut residuals);
    let groups = 0..L::GROUPS.len();
    Sample {
        independents: independents.iter().chain(motion).copied().collect(),
        dependents: dependents(position),
        outputs,
        points,
        coefficients: columns.iter().map(dependents).collect(),
        modes: groups.clone().map(|group| assembly.mode(group)).collect(),
        sines: groups.map(|group| assembly.sine(group)).collect(),
        residuals,
    }
}

/// Influence coefficients at one place: outputs by variables, row by row.
///
/// # Errors
/// Why the linkage does not get there.
pub fn influence<L: Linkage>(linkage: &L, place: &[f64]) -> Result<Vec<f64>, ClosureError> {
    let mut assembly = Assembly::<L, f64>::new(linkage);
    assembly.start()?;
    let (drivers, motion) = place.split_at(place.len().min(L::INDEPENDENTS));
    assembly.move_to(drivers)?;
    let closure = assembly.closure();
    let instant = match motion.len() == L::MOTION {
        true => closure.moving(drivers, motion),
        false => closure.instant(drivers),
    };
    let mut values = vec![0.0; L::OUTPUTS * L::VARIABLES.len()];
    closure.influence(&instant, assembly.position(), &mut values);
    if assembly.is_singular() {
        values.fill(f64::NAN);
    }
    Ok(values)
}

/// Positions between which the time of a move is measured.
const PLACES: usize = 256;

/// Nanoseconds of one move between neighbouring positions of the task, outputs included; NaN if it has no two of them.
pub fn time_position<L: Linkage>(linkage: &L, moves: usize) -> f64 {
    let mut assembly = Assembly::<L, f64>::new(linkage);
    if assembly.start().is_err() {
        return f64::NAN;
    }
    let reached = |place: &Vec<f64>| assembly.move_to(&place[..L::INDEPENDENTS]).is_ok();
    let places: Vec<_> = places(linkage).into_iter().take_while(reached).collect();
    if places.len() < 2 {
        return f64::NAN;
    }
    let mut outputs = vec![0.0; L::OUTPUTS];
    let clock = Instant::now();
    let back = places.iter().rev().skip(1);
    let back_and_forth = back.chain(places.iter().skip(1)).cycle();
    for place in back_and_forth.take(moves) {
        if assembly.move_to(&place[..L::INDEPENDENTS]).is_err() {
            return f64::NAN;
        }
        assembly.outputs(&mut outputs);
        black_box(&outputs);
    }
    clock.elapsed().as_secs_f64() * 1e9 / moves as f64
}

/// Positions along the task, all drivers moving at once.
fn places<L: Linkage>(linkage: &L) -> Vec<Vec<f64>> {
    let share = |index: usize| index as f64 / PLACES as f64;
    let (first, last) = linkage.span().limits();
    let ranges = linkage.ranges();
    let place = |index: usize| {
        let moving = linkage.drive(first + share(index) * (last - first));
        moving.unwrap_or_else(|| {
            let along = ranges.iter();
            along
                .map(|range| range.from + share(index) * (range.to - range.from))
                .collect()
        })
    };
    (0..=PLACES).map(place).collect()
}
