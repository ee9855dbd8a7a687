//! A linkage with its values: how its drivers move, and what is reported.

use assur::closure::{AnyLinkage, ClosureError, Measured, Path, Range, Sample};
use assur::problem::Span;
use assur::shape::{LinkageEntry, Quantity, Subject};

use super::wording::{self, Terms};
use crate::ask::case;
use crate::ask::constants::Constants;
use crate::ask::values::TIME;
use crate::ask::variables::{self, Variable};
use crate::error::{Failure, Told};
use crate::show::number;

/// How the outputs begin that say by how much a condition holds.
pub const MARGIN: &str = "margin of ";

/// What moves it.
pub struct Moves {
    /// Its loops.
    pub entry: &'static LinkageEntry,
    /// Where the drivers move.
    pub ranges: Vec<Range>,
    /// What is done.
    pub task: Task,
    run: Box<dyn AnyLinkage>,
}

/// A linkage with its values, angles of its drivers in degrees.
pub type Case = case::Case<Moves>;

/// What moves the drivers. A station of it is a position of each driver that is swept, or a time.
#[derive(Clone, Debug, PartialEq)]
pub enum Task {
    /// The drivers of these indices go over their ranges, the first one the fastest.
    Sweep(Vec<usize>),
    /// All drivers move in time.
    Time(Span),
    /// Nothing: positions are evaluated where they are asked for.
    Open,
}

/// Something that a task varies.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The driver, or the time.
    pub quantity: Quantity,
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

impl Case {
    /// Fixes the values.
    ///
    /// # Errors
    /// When the mechanism refuses them, with its reason; when the scene is none that closes loops.
    pub fn new(constants: Constants) -> Result<Self, Failure> {
        let scene = constants.scene;
        let run = scene
            .bind
            .linkage(&constants.values)
            .map_err(|refused| case::refused(&constants, &refused))?;
        let Some(entry) = &scene.linkage else {
            return Err(Failure::request(format!("scene `{}` is no linkage", scene.name)));
        };
        let ranges = run.ranges();
        let task = match run.span() {
            Span::Open => swept(&ranges),
            span => Task::Time(span),
        };
        Ok(Self {
            scene,
            variables: variables::of_linkage(scene, entry),
            constants,
            drivers: scene.drivers.iter().map(shown).collect(),
            moved: Moves { entry, ranges, task, run },
        })
    }

    /// The linkage as the solvers see it.
    pub fn run(&self) -> &dyn AnyLinkage {
        self.moved.run.as_ref()
    }

    /// Whether it closes no loops: a formula sheet.
    pub fn is_sheet(&self) -> bool {
        self.moved.entry.loops.is_empty()
    }

    /// What is found at each place.
    pub fn found_in_words(&self) -> &'static str {
        if self.is_sheet() { "values" } else { "positions" }
    }

    /// What is made anew with other values, and what each of these does if nothing goes wrong.
    pub fn made_in_words(&self) -> (&'static str, &'static str) {
        if self.is_sheet() { ("sets of values", "have results") } else { ("linkages", "assemble") }
    }

    /// What the task varies, the fastest first.
    pub fn axes(&self) -> Vec<Axis> {
        match &self.moved.task {
            Task::Sweep(drivers) => drivers
                .iter()
                .map(|&index| Axis {
                    quantity: self.drivers[index],
                    from: self.moved.ranges[index].from,
                    to: self.moved.ranges[index].to,
                })
                .collect(),
            Task::Time(span) => {
                let (from, to) = span.limits();
                vec![Axis { quantity: TIME, from, to }]
            }
            Task::Open => Vec::new(),
        }
    }

    /// The independent variables at a station of the task.
    pub fn place(&self, station: &[f64]) -> Vec<f64> {
        match &self.moved.task {
            Task::Time(_) => {
                let time = station.first().copied().unwrap_or(f64::NAN);
                self.moved.run.drive(time).unwrap_or_default()
            }
            Task::Sweep(drivers) => {
                self.standing_but(drivers.iter().copied().zip(station.iter().copied()))
            }
            Task::Open => self.standing(),
        }
    }

    /// The positions of the drivers where they start.
    pub fn standing(&self) -> Vec<f64> {
        self.moved.ranges.iter().map(|range| range.start).collect()
    }

    /// The positions of the drivers where they start, but for some that stand elsewhere.
    pub fn standing_but(&self, others: impl IntoIterator<Item = (usize, f64)>) -> Vec<f64> {
        let mut place = self.standing();
        for (index, position) in others {
            place[index] = position;
        }
        place
    }

    /// When a driver first has a position, where all of them move in time.
    ///
    /// # Errors
    /// The lowest and the highest position that it has; neither is a number where they do not move in time.
    pub fn time_of(&self, driver: usize, position: f64) -> Result<f64, (f64, f64)> {
        let Task::Time(span) = self.moved.task else { return Err((f64::NAN, f64::NAN)) };
        let at = |time: f64| self.place(&[time]).get(driver).copied().unwrap_or(f64::NAN);
        span.time_of(at, position)
    }

    /// An error in words.
    pub fn tell(&self, error: &ClosureError) -> Told {
        wording::tell(Terms { entry: self.moved.entry, drivers: &self.drivers }, error)
    }

    /// The task in words.
    pub fn task_in_words(&self) -> String {
        let names = |drivers: &[usize]| {
            let names = drivers.iter().map(|&index| self.drivers[index].name);
            names.collect::<Vec<_>>().join(" and ")
        };
        let found = self.found_in_words();
        match &self.moved.task {
            Task::Sweep(drivers) => format!("{found} over {}", names(drivers)),
            Task::Time(Span::Periodic(period)) => {
                format!("{found} over one period of {} s", number::short(*period))
            }
            Task::Time(span) => {
                let (from, to) = span.limits();
                let [from, to] = [from, to].map(number::short);
                format!("{found} from {from} s to {to} s")
            }
            Task::Open => found.to_owned(),
        }
    }

    /// The linkage at the independent variables.
    ///
    /// # Errors
    /// Why it does not get there.
    pub fn at(&self, place: Vec<f64>) -> Result<Sample, ClosureError> {
        let mut path = self.moved.run.follow(&[place])?;
        match (path.samples.pop(), path.stopped) {
            (Some(sample), None) => Ok(sample),
            (_, Some(error)) => Err(error),
            (None, None) => {
                Err(ClosureError::BadRange { reason: "there is no position to go to".to_owned() })
            }
        }
    }

    /// The linkage through stations of the task.
    ///
    /// # Errors
    /// Why it cannot be put together.
    pub fn follow(&self, stations: &[Vec<f64>]) -> Result<Path, ClosureError> {
        let places: Vec<_> = stations.iter().map(|station| self.place(station)).collect();
        self.moved.run.follow(&places)
    }

    /// The measures over the task, which are none over a grid.
    ///
    /// # Errors
    /// Why it does not get through it.
    pub fn measures(&self) -> Result<Vec<Measured>, ClosureError> {
        match self.run().way() {
            Some(way) if !self.scene.measures.is_empty() => self.run().measures(way),
            _ => Ok(Vec::new()),
        }
    }

    /// The values of the variables, SI units.
    pub fn values(&self, sample: &Sample) -> Vec<f64> {
        self.values_of(&sample.dependents, &sample.outputs)
    }

    /// The values of the variables where the dependent coordinates and the outputs have these, SI units.
    pub fn values_of(&self, dependents: &[f64], outputs: &[f64]) -> Vec<f64> {
        let value = |variable: &Variable| match variable.origin {
            Subject::State(index) => dependents.get(index).copied(),
            Subject::Output(index) => outputs.get(index).copied(),
            _ => None,
        };
        let values = self.variables.iter().map(value);
        values.map(|value| value.unwrap_or(f64::NAN)).collect()
    }
}

/// A driver as it is shown: nobody reads a crank angle in radians.
pub fn shown(driver: &Quantity) -> Quantity {
    match driver.unit {
        "rad" => Quantity { unit: "deg", factor: 1f64.to_radians(), ..*driver },
        _ => *driver,
    }
}

/// The drivers that have a range go over it.
fn swept(ranges: &[Range]) -> Task {
    let goes = |range: &Range| range.from.is_finite() && range.to != range.from;
    let moving: Vec<_> = (0..ranges.len()).filter(|&index| goes(&ranges[index])).collect();
    let stands = |range: &Range| range.start.is_finite();
    match moving.is_empty() || !ranges.iter().all(|range| goes(range) || stands(range)) {
        true => Task::Open,
        false => Task::Sweep(moving),
    }
}
