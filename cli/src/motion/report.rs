//! Everything that `assur run` has to say, as numbers in SI units; how it is printed is decided elsewhere.

use std::path::Path;
use std::time::Instant;

use assur::answer::{Ends, Motion, Settings};
use assur::problem::Span;
use assur::shape::Subject;
use serde::Serialize;

use super::case::Case;
use super::curves::Curves;
use super::found::Found;
use super::multipliers::{self, Multiplier};
use super::{csv, json, rest, table};
use crate::answer::Answer;
use crate::arguments::Rows;
use crate::ask::case::amount_of;
use crate::ask::place::Place;
use crate::error::Failure;
use crate::plot;
use crate::published::{self, Comparison};
use crate::run::Shown;
use crate::show::measures::Measured;
use crate::show::number;
use crate::show::page::Page;

/// An error that is more than this share of the amplitude of its variable, and more than the tolerance leads to, is too large.
const INACCURATE: f64 = 1e-2;
/// What is less than this share of its unit, or of variables of the same dimension, is zero.
const ZERO: f64 = 1e-9;
/// The same where closures hold the coordinates, of positions and speeds and of accelerations: what vanishes is known to
/// rounding over how near they come to depend on each other.
const HELD: [f64; 2] = [1e-6, 1e-3];

/// All results of a run.
pub struct Report {
    /// The scene with its values.
    pub case: Case,
    /// The motion.
    pub motion: Motion,
    /// The curves.
    pub curves: Curves,
    /// Estimated global error of each variable, the largest over the task.
    pub errors: Vec<f64>,
    /// Everything at the beginning of the task.
    pub start: Snapshot,
    /// Smallest and largest value of each variable over the task; none where it has no length.
    pub extremes: Vec<Ends>,
    /// When the motion passes a change point, in seconds.
    pub changes: Vec<f64>,
    /// Errors of the times of all events.
    pub events: Vec<f64>,
    /// Numbers of the whole task.
    pub measures: Vec<Measured>,
    /// Everything at the places that were asked for.
    pub places: Vec<Snapshot>,
    /// Published values beside the computed ones.
    pub published: Vec<Comparison>,
    /// Floquet multipliers of a steady state.
    pub multipliers: Vec<Multiplier>,
    /// Estimated error of the time after which the motion repeats, in seconds; zero where that is given.
    pub period_error: f64,
    /// What it cost.
    pub cost: Cost,
    /// What is wanted of it.
    pub shown: Shown,
}

impl Report {
    /// Number of free motions that nothing determines.
    pub fn free(&self) -> usize {
        self.motion.repeats().map_or(0, |repeats| repeats.free)
    }

    /// What multipliers or vibrations say, a sentence each.
    pub fn conclusions(&self) -> Vec<String> {
        if let Some(rest) = self.motion.rest() {
            return rest::conclusions(self.motion.shape(), rest);
        }
        let turn = self.case.turn();
        let followed = self.motion.repeats().and_then(|repeats| repeats.followed);
        multipliers::conclusions(&self.multipliers, turn, self.free(), followed)
    }

    /// The period with its estimated error, where it is a result.
    pub fn period(&self) -> Option<(f64, f64)> {
        let (_, to) = self.case.moved.task.limits();
        (self.case.run().span() == Span::Autonomous).then_some((to, self.period_error))
    }

    /// Whether a value may be so wrong that the motion is not to be trusted.
    pub fn is_inaccurate(&self) -> bool {
        let permitted = INACCURATE.max(10.0 * self.motion.settings.rtol);
        self.cost.worst.is_some_and(|(_, share)| share > permitted)
    }

    /// Whether the task is a steady state that repeats.
    pub fn is_cycle(&self) -> bool {
        matches!(self.case.moved.task, Span::Periodic(_))
    }
}

impl Answer for Report {
    fn figure(&self) -> Option<String> {
        (!self.curves.times.is_empty()).then(|| plot::draw(self, &self.shown.curves))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        table::render(page, self, figure);
    }

    fn csv(&self) -> String {
        match self.shown.rows {
            Rows::Events => csv::events(self),
            _ => csv::render(self),
        }
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        json::run(self, figure)
    }

    fn outcome(&self) -> Result<(), Failure> {
        let Some((index, share)) = self.cost.worst.filter(|_| self.is_inaccurate()) else {
            return Ok(());
        };
        let failure = Failure::numerical(format!(
            "the motion is not accurate: `{}` may be wrong by {} of its amplitude",
            self.case.variables[index].name,
            number::error(share)
        ));
        Err(match self.motion.statistics().rounded_steps {
            0 => failure
                .reason("with other tolerances the motion is another one")
                .remedy(
                    "try a smaller --rtol; where that changes nothing, errors grow without bound, as in a chaotic motion, \
                     or a spike comes a little earlier or later: look at measures and extremes, which have errors of their \
                     own",
                ),
            rounded => failure
                .reason(format!(
                    "in {} steps rounding is larger than the tolerance: states that are large are told from each other by \
                     their last digits",
                    number::count(rounded)
                ))
                .remedy("take the small difference as a coordinate, and one of the large ones as what follows from it"),
        })
    }
}

/// All variables at one instant.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// The place in words, `theta = 110 deg`.
    pub label: String,
    /// The time within the task.
    pub time: f64,
    /// Positions of the drivers.
    pub drivers: Vec<f64>,
    /// Values of the variables.
    pub values: Vec<f64>,
    /// Their estimated errors.
    pub errors: Vec<f64>,
}

/// Time and accuracy.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Seconds of the solution that is printed.
    pub solve: f64,
    /// Seconds of everything, the estimate of the error included.
    pub total: f64,
    /// The largest error relative to the amplitude of its variable, with the index of that variable.
    pub worst: Option<(usize, f64)>,
    /// How many times the work of the printed solution ten times more accuracy takes; unknown at the limit of double
    /// precision.
    pub tenfold: Option<f64>,
    /// Whether that was cut off because it takes too long.
    pub is_cut_off: bool,
}

/// Runs a scene and collects what there is to say about it.
///
/// # Errors
/// When the solvers do not succeed or a place is not reached.
pub fn collect(
    mut case: Case,
    settings: &Settings,
    places: &[Place],
    shown: Shown,
) -> Result<Report, Failure> {
    let clock = Instant::now();
    let motion = case.solve(settings)?;
    case.repeat(&motion);
    let time_of = |index, position| case.run().time_of(index, position);
    let times = places.iter().map(|place| place.in_time(&case, case.moved.task, time_of));
    let times: Vec<_> = times.collect::<Result<_, _>>()?;
    let found = Found::of(case, motion)?;
    let published = published::compare(&found)?;
    let Found { case, motion, curves, estimate, extremes, measures } = found;
    let subjects = case.subjects();
    let errors = estimate.largest(&motion, &subjects, &curves.times);
    let snapshot = |time: f64, label: String, asked: Option<f64>| Snapshot {
        label,
        time,
        drivers: case.drivers_at(time),
        values: case.sample(&motion, time),
        errors: estimate.at(&motion, &subjects, asked.unwrap_or(time)),
    };
    let (from, _) = case.moved.task.limits();
    let (leading, position) = case.leading(from);
    let start = snapshot(from, amount_of(&leading, position), None);
    let asked = times.into_iter().zip(places);
    let places = asked.map(|((time, label), place)| snapshot(time, label, place.time())).collect();
    let worst = errors.iter().enumerate();
    let worst = worst
        .filter_map(|(index, error)| Some((index, error / size(&case, &extremes, index)?)))
        .max_by(|(_, a), (_, b)| a.total_cmp(b));
    let cost = Cost {
        solve: motion.seconds,
        total: clock.elapsed().as_secs_f64(),
        worst,
        tenfold: estimate.tenfold,
        is_cut_off: estimate.is_cut_off,
    };
    Ok(Report {
        changes: motion.change_points(),
        events: estimate.events(&motion),
        multipliers: multipliers::read(motion.multipliers()),
        period_error: estimate.period(&motion),
        case,
        motion,
        curves,
        errors,
        start,
        extremes,
        measures,
        places,
        published,
        cost,
        shown,
    })
}

/// What the error of a variable is compared with: its amplitude. None where that is nothing, as of a residual or a
/// difference that vanishes.
fn size(case: &Case, extremes: &[Ends], index: usize) -> Option<f64> {
    let own = &case.variables[index];
    let variables = case.variables.iter().zip(extremes);
    let alike = variables.filter(|(other, _)| other.dimension == own.dimension);
    let largest = alike.map(|(_, extremes)| extremes.furthest().value.abs());
    let largest = largest.fold(own.factor, f64::max);
    let amplitude = extremes.get(index)?.furthest().value.abs();
    let is_rate = matches!(own.origin, Subject::Rate(_));
    let zero = match case.scene.augmented {
        Some(_) => HELD[usize::from(is_rate)],
        None => ZERO,
    };
    (amplitude > zero * largest).then_some(amplitude)
}
