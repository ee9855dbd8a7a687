//! What accuracy costs of a linkage. Loops are closed to rounding, at one cost; how an output errs by the tolerances is found in
//! several ways, and says what accuracy a position can have in the end.

mod json;
mod table;

pub use json::Object;

use std::path::Path;
use std::time::Instant;

use assur::scalar::fault;
use assur::shape::Quantity;
use assur::study::cost::{Made, MadeTrial, Way, front, made};
use assur::tolerance::{Linear, Study, ToleranceError, linear, worst_place};
use serde::Serialize;

use super::CostArguments;
use crate::answer::Answer;
use crate::ask::constants::Constants;
use crate::ask::wanted::{Difference, Wanted};
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::linkage::rounding;
use crate::plot::{Decades, Line, decades};
use crate::show::csv::{cell, line, quoted, title};
use crate::show::output::Stoppable;
use crate::show::page::Page;
use crate::show::progress::Progress;
use crate::tolerance::{Names, Unit, range};

/// Positions in one measurement of the time that they take, and measurements, of which the shortest counts.
const MOVES: usize = 5000;
const REPEATS: usize = 5;
/// Places over the range.
const PLACES: usize = 61;

/// The answer.
pub struct Cost {
    case: Case,
    /// Seconds of a position; not a number where the task has no two.
    position: f64,
    /// What rounding of the values makes of each output, the largest over the range, and how large that is.
    roundings: Vec<Difference>,
    /// The output that is looked at.
    output: usize,
    errs: Option<Errs>,
    wanted: Option<Wanted>,
    is_whole: bool,
    seconds: f64,
}

/// How an output errs by the tolerances, where that is most.
struct Errs {
    output: &'static Quantity,
    unit: Unit,
    place: Vec<f64>,
    linear: Linear,
    made: Made,
}

impl Cost {
    /// Finds it.
    ///
    /// # Errors
    /// A wrong request, or a linkage that does not get to a place.
    pub fn find(options: &CostArguments, constants: Constants) -> Result<Self, Failure> {
        let clock = Instant::now();
        let case = Case::new(constants)?;
        if !options.method.is_empty() {
            return Err(Failure::request("nothing is integrated in a linkage")
                .place("--method")
                .remedy("leave it away: loops are closed to rounding, at one cost"));
        }
        let names = Names { scene: case.scene, linkage: case.moved.entry, case: &case };
        let output = names.output(options.of.as_deref(), "--of")?;
        let quantity = &case.scene.outputs[output];
        let wanted = options.wanted.as_deref();
        let wanted = wanted.map(|text| Wanted::read("--for", text, &[*quantity])).transpose()?;
        let said = |error: &ToleranceError| match error {
            ToleranceError::Closure(error) => {
                case.tell(error).failure("the linkage does not get to all places")
            }
            other => Failure::request(other.to_string()),
        };
        let bar = Progress::start(format!("{}, cost", case.constants.mechanism.name), 0);
        let stoppable = Stoppable::begin();
        let goes_on = || {
            bar.advance();
            !stoppable.is_stopped()
        };
        let times = (0..REPEATS).map(|_| case.run().time_position(MOVES));
        let position = times.fold(f64::NAN, f64::min) * 1e-9;
        let sources = names.declared();
        let study = Study { output, places: range(case.run(), PLACES), sources };
        let roundings = roundings(&case, &study.places);
        let errs = match study.sources.is_empty() {
            true => None,
            false => {
                let errs = Errs::find(&case, study, quantity, options.seconds, &goes_on);
                Some(errs.map_err(|error| said(&error))?)
            }
        };
        let is_whole = !stoppable.is_stopped();
        drop((bar, stoppable));
        let seconds = clock.elapsed().as_secs_f64();
        Ok(Self { case, position, roundings, output, errs, wanted, is_whole, seconds })
    }

    /// What roundings make of the output that is looked at, over what is permitted.
    fn rounded(&self, wanted: &Wanted) -> f64 {
        wanted.share(|_| self.roundings[self.output])
    }

    /// Whether an accuracy is reached: of the spread, where there is one, else of the output itself.
    fn reaches(&self, wanted: &Wanted) -> bool {
        match &self.errs {
            Some(errs) => errs.cheapest(wanted, 1.0).is_some(),
            None => self.rounded(wanted) <= 1.0,
        }
    }
}

/// What rounding of the values makes of each output, where that is most, and what integrals are not known by; not a number where that
/// is not known.
fn roundings(case: &Case, places: &[Vec<f64>]) -> Vec<Difference> {
    let mut all = vec![Difference { error: 0.0, size: 0.0 }; case.scene.outputs.len()];
    fault::take_doubt();
    for place in places {
        let errors = rounding::at(case, place);
        let values = case.at(place.clone()).map(|sample| sample.outputs).unwrap_or_default();
        for ((most, error), value) in all.iter_mut().zip(errors).zip(values) {
            most.error = rounding::or_more(error, most.error);
            most.size = most.size.max(value.abs());
        }
    }
    let doubt = fault::take_doubt();
    for most in &mut all {
        most.error = rounding::or_more(most.error, doubt * most.size);
    }
    all
}

impl Errs {
    fn find(
        case: &Case,
        study: Study,
        output: &'static Quantity,
        seconds: f64,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Self, ToleranceError> {
        let run = case.run();
        let mut along = linear(&run.influences(&study)?, &study.sources)?;
        let worst = worst_place(&along);
        let place = study.places[worst].clone();
        let there = Study { places: vec![place.clone()], ..study };
        let made = made(run, &there, seconds, goes_on)?;
        let (unit, linear) = (Unit::of(output), along.swap_remove(worst));
        Ok(Self { output, unit, place, linear, made })
    }

    /// The error of a way, at least that of the reference; SI units.
    fn error(&self, trial: &MadeTrial) -> f64 {
        trial.error.max(self.made.doubt)
    }

    /// The largest error over what is permitted.
    fn share(&self, wanted: &Wanted, error: f64) -> f64 {
        wanted.share(|_| Difference { error, size: self.made.reference.1.deviation })
    }

    /// The cheapest way to a part of the permitted error.
    fn cheapest(&self, wanted: &Wanted, part: f64) -> Option<&MadeTrial> {
        let trials = self.made.trials.iter();
        let reaching = trials.filter(|one| self.share(wanted, self.error(one)) <= part);
        reaching.min_by(|a, b| a.times.median.total_cmp(&b.times.median))
    }

    /// The most accurate way.
    fn nearest(&self) -> Option<&MadeTrial> {
        let trials = self.made.trials.iter();
        trials.min_by(|a, b| self.error(a).total_cmp(&self.error(b)))
    }

    /// The ways that nothing cheaper is better than.
    fn front(&self) -> Vec<usize> {
        front(self.made.trials.iter().map(|one| (one.times.median, self.error(one))))
    }
}

/// What a way is called.
fn name(way: Way) -> &'static str {
    match way {
        Way::First => "first order",
        Way::Second => "second order",
        Way::Made(_) => "made at random",
    }
}

impl Answer for Cost {
    fn figure(&self) -> Option<String> {
        let errs = self.errs.as_ref()?;
        let deviation = errs.made.reference.1.deviation;
        let point = |one: &MadeTrial| (one.times.median, errs.error(one) / deviation);
        let mut lines: Vec<Line> = Vec::new();
        for trial in &errs.made.trials {
            match lines.iter_mut().find(|line| line.name == name(trial.way)) {
                Some(line) => line.points.push(point(trial)),
                None => lines
                    .push(Line { name: name(trial.way).to_owned(), points: vec![point(trial)] }),
            }
        }
        let front = errs.front().into_iter().map(|index| point(&errs.made.trials[index]));
        Some(decades(&Decades {
            title: format!(
                "{}, scene {}: what accuracy of the spread of {} costs",
                self.case.constants.mechanism.title, self.case.scene.name, errs.output.name
            ),
            along: "time, s".to_owned(),
            up: "error of mean and standard deviation, over the latter".to_owned(),
            lines,
            front: front.collect(),
            labels: Vec::new(),
            mark: None,
        }))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        table::render(page, self, figure);
    }

    fn csv(&self) -> String {
        let unit = self.errs.as_ref().map_or("", |errs| errs.output.unit);
        let heads = ["way", "linkages"].map(quoted).into_iter();
        let times = ["seconds", "quartile_low", "quartile_high"].map(|name| title(name, "s"));
        let found = ["mean", "standard_deviation", "error"].map(|name| title(name, unit));
        let mut text = line(heads.chain(times).chain(found));
        for (errs, trial) in { self.errs.iter() }
            .flat_map(|errs| errs.made.trials.iter().map(move |trial| (errs, trial)))
        {
            let factor = errs.output.factor;
            let (times, found) = (trial.times, trial.found);
            let numbers = [times.median, times.quartiles.0, times.quartiles.1].map(cell);
            let values = [found.mean, found.deviation, errs.error(trial)];
            let linkages = match trial.way {
                Way::Made(linkages) => linkages.to_string(),
                _ => String::new(),
            };
            let cells = [name(trial.way).to_owned(), linkages].into_iter().chain(numbers);
            text += &line(cells.chain(values.map(|value| cell(value / factor))));
        }
        text
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        Object::of(self, figure)
    }

    fn outcome(&self) -> Result<(), Failure> {
        super::whole(self.is_whole)?;
        super::reached(self.wanted.as_ref(), |wanted| self.reaches(wanted))
    }
}
