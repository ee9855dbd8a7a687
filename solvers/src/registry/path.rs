//! A linkage moved through positions.

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
        let moved = assembly.move_to(drivers);
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
        path.samples.push(sample(&assembly, motion));
    }
    Ok(path)
}

fn sample<L: Linkage>(assembly: &Assembly<L, f64>, motion: &[f64]) -> Sample {
    let closure = assembly.closure();
    let position = assembly.position();
    let independents = assembly.independents();
    let instant = match motion.len() == L::MOTION {
        true => closure.moving(independents, motion),
        false => closure.instant(independents),
    };
    let mut outputs = vec![0.0; L::OUTPUTS];
    closure.outputs(&instant, position, &mut outputs);
    let mut points = vec![0.0; 2 * L::POINTS];
    closure.points(&instant, position, &mut points);
    let mut columns = vec![closure.zeros(); L::INDEPENDENTS];
    closure.coefficients(&instant, position, &mut columns);
    let dependents = |position: &<L::Closure<f64> as Closure<f64>>::Position| {
        position.as_ref()[..L::DEPENDENTS].to_vec()
    };
    let groups = 0..L::GROUPS.len();
    Sample {
        independents: independents.iter().chain(motion).copied().collect(),
        dependents: dependents(position),
        outputs,
        points,
        coefficients: columns.iter().map(dependents).collect(),
        modes: groups.clone().map(|group| assembly.mode(group)).collect(),
        sines: groups.map(|group| assembly.sine(group)).collect(),
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
    Ok(values)
}
