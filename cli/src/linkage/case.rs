//! A linkage with its values: how its drivers move, and what is reported.

use assur::closure::{AnyLinkage, ClosureError, Range};
use assur::problem::Span;
use assur::registry::{Path, Sample, SceneEntry};
use assur::shape::{LinkageEntry, Quantity};

use crate::case;
use crate::constants::Constants;
use crate::error::Failure;
use crate::number;
use crate::values::TIME;
use crate::variables::{self, Variable};
use assur::shape::Subject;

/// A linkage with its values.
pub struct Case {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// Its loops.
    pub entry: &'static LinkageEntry,
    /// Its dimensions and parameters.
    pub constants: Constants,
    /// What is reported.
    pub variables: Vec<Variable>,
    /// The drivers, angles in degrees.
    pub drivers: Vec<Quantity>,
    /// Where they move.
    pub ranges: Vec<Range>,
    /// What is done.
    pub task: Task,
    run: Box<dyn AnyLinkage>,
}

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
            entry,
            variables: variables::of_linkage(scene, entry),
            constants,
            drivers: scene.drivers.iter().map(shown).collect(),
            ranges,
            task,
            run,
        })
    }

    /// The linkage as the solvers see it.
    pub fn run(&self) -> &dyn AnyLinkage {
        self.run.as_ref()
    }

    /// What the task varies, the fastest first.
    pub fn axes(&self) -> Vec<Axis> {
        match &self.task {
            Task::Sweep(drivers) => drivers
                .iter()
                .map(|&index| Axis {
                    quantity: self.drivers[index],
                    from: self.ranges[index].from,
                    to: self.ranges[index].to,
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
        match &self.task {
            Task::Time(_) => {
                let time = station.first().copied().unwrap_or(f64::NAN);
                self.run.drive(time).unwrap_or_default()
            }
            Task::Sweep(drivers) => {
                let mut place = self.standing();
                for (&index, position) in drivers.iter().zip(station) {
                    place[index] = *position;
                }
                place
            }
            Task::Open => self.standing(),
        }
    }

    /// The positions of the drivers where they start.
    pub fn standing(&self) -> Vec<f64> {
        self.ranges.iter().map(|range| range.start).collect()
    }

    /// The linkage at the independent variables.
    ///
    /// # Errors
    /// Why it does not get there.
    pub fn at(&self, place: Vec<f64>) -> Result<Sample, ClosureError> {
        let mut path = self.run.follow(&[place])?;
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
        self.run.follow(&places)
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

    /// Positions of drivers in words, `phi4 = 90 deg`.
    pub fn label(&self, independents: &[f64]) -> String {
        label(&self.drivers, independents)
    }
}

/// Positions of drivers in words, `phi4 = 90 deg`.
pub fn label(drivers: &[Quantity], independents: &[f64]) -> String {
    let parts = drivers
        .iter()
        .zip(independents)
        .map(|(driver, position)| format!("{} = {}", driver.name, amount(driver, *position)));
    parts.collect::<Vec<_>>().join(", ")
}

/// A value with its unit, `90 deg`.
pub fn amount(quantity: &Quantity, value: f64) -> String {
    let number = number::short(value / quantity.factor);
    format!("{number} {}", quantity.unit).trim_end().to_owned()
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
