//! `assur cost`: what accuracy costs in time, by each method.

mod arguments;
mod figure;
mod json;
mod linkage;
mod made;
mod table;

pub use arguments::{CostArguments, EXAMPLES};

use std::path::Path;
use std::time::Instant;

use assur::answer::{Method, Settings};
use assur::shape::{Quantity, Subject};
use assur::study::cost::{Costs, Look, Work, cost};
use serde::Serialize;

use crate::answer::{Answer, give};
use crate::ask::For;
use crate::ask::constants::Constants;
use crate::ask::lookup::{Registry, suggestion};
use crate::ask::settings::RTOL;
use crate::ask::wanted::{Difference, Wanted};
use crate::error::Failure;
use crate::motion::case::Case;
use crate::show::csv::{cell, line, quoted, title};
use crate::show::output::Stoppable;
use crate::show::page::Page;
use crate::show::progress::Progress;
use crate::show::unit;
use made::Spread;

/// What is known to about as much as what it is compared with.
const NEAR: f64 = 3.0;

/// What keeps the most accurate way from more.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
enum Limited {
    /// The reference is not known better.
    Reference,
    /// No smaller tolerance was tried.
    Tolerances,
    /// Smaller tolerances gained nothing.
    Rounding,
}

/// The answers as objects.
#[cfg(test)]
#[expect(dead_code, reason = "the schema is derived from it")]
#[derive(Serialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum Object {
    Motion(json::Object),
    Linkage(linkage::Object),
}

/// What is not known to this part of its size is nothing but rounding.
const KNOWN: f64 = 1e-3;

/// Finds what accuracy costs.
///
/// # Errors
/// A wrong request, or a task of which no reference comes out.
pub fn execute(options: &CostArguments, registry: Registry) -> Result<(), Failure> {
    let constants = options.asked.find(registry, "cost", For::All)?;
    let (format, plot) = (options.format, options.plot.as_deref());
    match constants.scene.linkage {
        Some(_) => give(format, plot, || linkage::Cost::find(options, constants)),
        None => give(format, plot, || Cost::find(options, constants)),
    }
}

/// Whether it is all that was asked for.
fn whole(is_whole: bool) -> Result<(), Failure> {
    match is_whole {
        true => Ok(()),
        false => {
            Err(Failure::interrupted("it was stopped: what is told is not all that was asked for"))
        }
    }
}

/// Whether an accuracy is reached, where one is asked for.
fn reached(wanted: Option<&Wanted>, is_reached: impl Fn(&Wanted) -> bool) -> Result<(), Failure> {
    match wanted {
        Some(wanted) if !is_reached(wanted) => {
            Err(Failure::numerical("the accuracy that is asked for is not reached")
                .place(format!("--for {}", wanted.text)))
        }
        _ => Ok(()),
    }
}

/// What is looked at: a variable of the motion or a measure.
pub struct Shown {
    /// What it is, with its unit.
    pub quantity: Quantity,
    /// Its place among the variables that are looked at, or among the measures.
    place: Place,
}

#[derive(Clone, Copy)]
enum Place {
    Variable(usize),
    Measure(usize),
}

/// The answer.
pub struct Cost {
    case: Case,
    shown: Vec<Shown>,
    costs: Costs,
    wanted: Option<Wanted>,
    /// What mechanisms as they are made differ by, where an accuracy is asked for.
    made: Option<Spread>,
    /// How many ways were to be tried.
    asked: usize,
    /// Whether nobody stopped it.
    is_whole: bool,
    seconds: f64,
}

impl Cost {
    fn find(options: &CostArguments, constants: Constants) -> Result<Self, Failure> {
        let clock = Instant::now();
        let scene = constants.scene;
        if scene.states.is_empty() {
            return Err(Failure::request(format!(
                "nothing is integrated in scene `{}`",
                scene.name
            ))
            .reason("what has no states is evaluated to rounding, at one cost")
            .remedy("name a scene that moves by its equations of motion"));
        }
        let (subjects, shown) = shown(scene, options.of.as_deref())?;
        let quantities: Vec<Quantity> = shown.iter().map(|of| of.quantity).collect();
        let wanted = options.wanted.as_deref();
        let wanted = wanted.map(|text| Wanted::read("--for", text, &quantities)).transpose()?;
        let case = Case::new(constants)?;
        let methods =
            if options.method.is_empty() { Method::ALL.to_vec() } else { options.method.clone() };
        let settings = settings(&methods, options.rtol)?;
        let look = Look { settings: &settings, subjects: &subjects, seconds: options.seconds };
        let what = format!("{}, cost", case.constants.mechanism.name);
        let bar = Progress::start(what, 0);
        let stoppable = Stoppable::begin();
        let costs = cost(&case.model(), &look, &|| {
            bar.advance();
            !stoppable.is_stopped()
        });
        let made = wanted.as_ref().filter(|_| !stoppable.is_stopped());
        let made = made.and_then(|_| Spread::of(&case, &subjects));
        let is_whole = !stoppable.is_stopped();
        drop((bar, stoppable));
        let costs = costs.map_err(|reason| {
            Failure::numerical("there is no reference to compare with")
                .reason(reason)
                .remedy("look at the scene with `assur run`, at a small --rtol")
        })?;
        let seconds = clock.elapsed().as_secs_f64();
        let asked = settings.len();
        Ok(Self { case, shown, costs, wanted, made, asked, is_whole, seconds })
    }

    /// The error of what is shown, SI units: at least that of the reference.
    fn error(&self, work: &Work, of: &Shown) -> f64 {
        let error = match of.place {
            Place::Variable(index) => work.errors[index],
            Place::Measure(index) => work.measures[index],
        };
        if error.is_nan() { error } else { error.max(self.doubt(of)) }
    }

    /// Its size over the task, SI units.
    fn size(&self, of: &Shown) -> f64 {
        match of.place {
            Place::Variable(index) => self.costs.sizes.0[index],
            Place::Measure(index) => self.costs.sizes.1[index],
        }
    }

    /// By how much it is not known, SI units.
    fn doubt(&self, of: &Shown) -> f64 {
        match of.place {
            Place::Variable(index) => self.costs.doubt.0[index],
            Place::Measure(index) => self.costs.doubt.1[index],
        }
    }

    /// Its standard deviation over mechanisms as they are made, SI units; not a number where that is not known.
    fn deviation(&self, of: &Shown) -> f64 {
        match (&self.made, of.place) {
            (Some(made), Place::Variable(index)) => made.subjects[index],
            (Some(made), Place::Measure(index)) => made.measures[index],
            (None, _) => f64::NAN,
        }
    }

    /// Whether it is more than rounding, as the work of a turn without losses is not.
    fn is_known(&self, of: &Shown) -> bool {
        self.doubt(of) < KNOWN * self.size(of)
    }

    /// The largest error over its size, and of what. What is nothing but rounding, and measures that the run does not have, do not
    /// count.
    fn worst(&self, work: &Work) -> (f64, &'static str) {
        let errors = self.shown.iter().map(|of| {
            let relative = self.error(work, of) / self.size(of);
            (if self.is_known(of) { relative } else { f64::NAN }, of.quantity.name)
        });
        let known = errors.filter(|(error, _)| error.is_finite());
        known.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::NAN, ""))
    }
}

impl Cost {
    /// By how much the reference is not known, the largest over its size.
    fn doubts(&self) -> f64 {
        let known = self.shown.iter().filter(|of| self.is_known(of));
        let shares = known.map(|of| self.doubt(of) / self.size(of));
        shares.filter(|share| share.is_finite()).fold(0.0, f64::max)
    }

    /// The cheapest way to a part of the permitted error.
    fn cheapest(&self, wanted: &Wanted, part: f64) -> Option<(Settings, Work, f64)> {
        let reaching = self.ways(wanted).filter(|one| one.2 <= part);
        reaching.min_by(|a, b| a.1.times.median.total_cmp(&b.1.times.median))
    }

    /// The most accurate way.
    fn nearest(&self, wanted: &Wanted) -> Option<(Settings, Work, f64)> {
        self.ways(wanted).min_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// What keeps the most accurate way from more.
    fn limited(&self, wanted: &Wanted, nearest: &(Settings, Work, f64)) -> Limited {
        let of_it = self.ways(wanted).filter(|one| one.0.method == nearest.0.method);
        let finest = of_it.map(|one| one.0.rtol).fold(f64::INFINITY, f64::min);
        match self.limit(wanted) {
            doubt if nearest.2 <= NEAR * doubt => Limited::Reference,
            _ if nearest.0.rtol <= finest => Limited::Tolerances,
            _ => Limited::Rounding,
        }
    }

    /// The largest error over what is permitted.
    fn share(&self, wanted: &Wanted, work: &Work) -> f64 {
        wanted.share(|index| self.differs(index, |of| self.error(work, of)))
    }

    /// The same of what the reference is not known by.
    fn limit(&self, wanted: &Wanted) -> f64 {
        wanted.share(|index| self.differs(index, |of| self.doubt(of)))
    }

    /// The same of what mechanisms as they are made differ by, and of what; none where nothing has a tolerance.
    fn spread(&self, wanted: &Wanted) -> Option<(&'static str, f64)> {
        let worst = wanted.worst(|index| self.differs(index, |of| self.deviation(of)));
        worst.map(|(index, share)| (self.shown[index].quantity.name, share))
    }

    fn differs(&self, index: usize, error: impl Fn(&Shown) -> f64) -> Difference {
        let of = &self.shown[index];
        let size = if self.is_known(of) { self.size(of) } else { f64::NAN };
        Difference { error: error(of), size }
    }

    /// All ways, each with its error over what is permitted.
    fn ways(&self, wanted: &Wanted) -> impl Iterator<Item = (Settings, Work, f64)> {
        let ways = self.costs.trials.iter().filter_map(|trial| {
            let work = trial.outcome.as_ref().ok()?;
            Some((trial.settings.clone(), work.clone(), self.share(wanted, work)))
        });
        ways.filter(|one| one.2.is_finite())
    }

    /// Of each reason why nothing comes of a trial the first with it.
    fn lost(&self) -> Vec<(&Settings, &str)> {
        let mut lost: Vec<(&Settings, &str)> = Vec::new();
        for trial in &self.costs.trials {
            if let Err(reason) = &trial.outcome
                && !lost.iter().any(|known| known.0.method == trial.settings.method)
            {
                lost.push((&trial.settings, reason));
            }
        }
        lost
    }
}

/// What is looked at: what is asked for, or all outputs and measures, states where there are no outputs.
fn shown(
    scene: &'static assur::registry::SceneEntry,
    names: Option<&str>,
) -> Result<(Vec<Subject>, Vec<Shown>), Failure> {
    let outputs = scene.outputs.iter().enumerate().map(|(at, one)| (*one, Subject::Output(at)));
    let states = scene.states.iter().enumerate().map(|(at, one)| (*one, Subject::State(at)));
    let measures = scene.measures.iter().enumerate();
    let all: Vec<(Quantity, Option<Subject>, usize)> = { outputs.chain(states) }
        .map(|(quantity, subject)| (quantity, Some(subject), 0))
        .chain(measures.map(|(at, one)| (*one, None, at)))
        .collect();
    let chosen: Vec<_> = match names {
        Some(names) => {
            let known: Vec<&str> = all.iter().map(|one| one.0.name).collect();
            let wanted = names.split(',').map(str::trim).map(|name| {
                all.iter().find(|one| one.0.name == name).ok_or_else(|| {
                    Failure::request(format!("scene `{}` has no `{name}`", scene.name))
                        .place(format!("--of {names}"))
                        .remedy(suggestion(name, &known))
                })
            });
            wanted.collect::<Result<_, _>>()?
        }
        None => {
            let is_told = |subject: &Option<Subject>| match subject {
                Some(Subject::State(_)) => scene.outputs.is_empty(),
                _ => true,
            };
            all.iter().filter(|one| is_told(&one.1)).collect()
        }
    };
    let (mut subjects, mut shown) = (Vec::new(), Vec::new());
    for (quantity, subject, measure) in chosen {
        let place = match subject {
            Some(subject) => {
                subjects.push(*subject);
                Place::Variable(subjects.len() - 1)
            }
            None => Place::Measure(*measure),
        };
        shown.push(Shown { quantity: *quantity, place });
    }
    Ok((subjects, shown))
}

/// Each method at each tolerance, one for each power of ten.
fn settings(methods: &[Method], (from, to): (f64, f64)) -> Result<Vec<Settings>, Failure> {
    // A power of ten has a logarithm that is whole to rounding.
    let exact = |value: f64| {
        let power = value.log10();
        if (power - power.round()).abs() < 1e-9 { power.round() } else { power }
    };
    let (low, high) = (exact(from.min(to)).ceil() as i32, exact(from.max(to)).floor() as i32);
    if low > high {
        return Err(Failure::request("no power of ten lies between")
            .place(format!("--rtol {from:e}..{to:e}"))
            .remedy("each power of ten is tried: 1e-9..1e-6"));
    }
    if low < exact(RTOL.0) as i32 || high > exact(RTOL.1) as i32 {
        return Err(Failure::request("a tolerance is out of range")
            .place(format!("--rtol {from:e}..{to:e}"))
            .remedy(format!("tolerances lie between {:e} and {:e}", RTOL.0, RTOL.1)));
    }
    let each = methods.iter().flat_map(|method| {
        (low..=high).rev().map(|power| Settings::new(*method).rtol(10f64.powi(power)))
    });
    Ok(each.collect())
}

impl Answer for Cost {
    fn figure(&self) -> Option<String> {
        Some(figure::draw(self))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        table::render(page, self, figure);
    }

    fn csv(&self) -> String {
        let heads = ["method", "rtol", "steps", "evaluations"].map(quoted);
        let times = ["seconds", "quartile_low", "quartile_high"].map(|name| title(name, "s"));
        let errors = self
            .shown
            .iter()
            .map(|of| title(&format!("error({})", of.quantity.name), of.quantity.unit));
        let mut text = line(heads.into_iter().chain(times).chain(errors));
        for trial in &self.costs.trials {
            let way =
                [trial.settings.method.name().to_owned(), format!("{:e}", trial.settings.rtol)];
            let Ok(work) = &trial.outcome else {
                let empty = (0..5 + self.shown.len()).map(|_| String::new());
                text += &line(way.into_iter().chain(empty));
                continue;
            };
            let cells = [
                work.steps.to_string(),
                work.evaluations.to_string(),
                cell(work.times.median),
                cell(work.times.quartiles.0),
                cell(work.times.quartiles.1),
            ];
            let errors = self
                .shown
                .iter()
                .map(|of| cell(unit::stated(self.error(work, of), of.quantity.factor)));
            text += &line(way.into_iter().chain(cells).chain(errors));
        }
        text
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        json::Object::of(self, figure)
    }

    fn outcome(&self) -> Result<(), Failure> {
        whole(self.is_whole)?;
        reached(self.wanted.as_ref(), |wanted| self.cheapest(wanted, 1.0).is_some())
    }
}
