//! `assur synth`: the values for which a scene is as it should be.

mod arguments;
mod held;
mod json;
mod picture;
mod resume;
mod search;
mod table;
mod verdict;

pub use arguments::{EXAMPLES, SynthArguments};
pub use json::Object;

use std::path::Path;
use std::time::Instant;

use assur::closure::Along;
use assur::registry::Bind;
use assur::shape::{Quantity, Synthesis};
use assur::study::{Candidate, Design, Polish, settle};
use serde::Serialize;

use crate::answer::{Answer, give};
use crate::ask::For;
use crate::ask::constants::Constants;
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::csv::{cell, line, title};
use crate::show::number;
use crate::show::output::{Destination, Stoppable};
use crate::show::page::Page;
use crate::show::unit;

/// Digits of values in pictures.
const DIGITS: usize = 7;

/// Seeks values for a scene.
///
/// # Errors
/// A wrong request. That no design keeps all conditions is told after the one that comes nearest.
pub fn execute(options: &SynthArguments, registry: Registry) -> Result<(), Failure> {
    let drawing = options.draw.as_deref().map(Destination::figure).transpose()?;
    give(options.format, options.plot.as_deref(), || {
        let found = Found::find(options, registry)?;
        if let Some(drawing) = &drawing
            && let Some(best) = found.best()
        {
            drawing.write(picture::positions(best)?.as_bytes())?;
        }
        Ok(found)
    })
}

/// The designs that were found.
struct Found {
    constants: Constants,
    synthesis: Synthesis,
    designs: Vec<Proposal>,
    /// What moves the linkage along its way, if it is one driver.
    way: Option<&'static Quantity>,
    /// Designs that were judged.
    evaluations: u64,
    seed: u64,
    seconds: f64,
    /// Whether nobody stopped it.
    is_whole: bool,
    /// What the best design does over its task; none if that was not asked for.
    curves: Option<String>,
}

/// A design that was found.
struct Proposal {
    candidate: Candidate,
    /// How it was polished; none where that made it no better.
    polish: Option<Polish>,
    /// What is made small where it is made within tolerances; none where nothing has any.
    made: Option<f64>,
    /// Its measures with their errors; why it has none in words.
    measures: Result<Vec<(f64, f64)>, String>,
    /// How it is put together otherwise than is meant, in words; none where it is not.
    contradiction: Option<String>,
}

impl Found {
    fn find(options: &SynthArguments, registry: Registry) -> Result<Self, Failure> {
        let clock = Instant::now();
        let constants = options.asked.find(registry, "synth", For::Synthesis)?;
        let scene = constants.scene;
        let settings = match scene.linkage {
            Some(_) => options.accuracy.none_for_linkages()?,
            None => options.accuracy.settings(scene)?,
        };
        let design = Design::of(scene, &constants.values, &settings);
        let design = design.ok_or_else(|| Failure::request("the scene seeks nothing"))?;
        refuse_given(&constants, design.synthesis())?;
        if options.robust {
            refuse_exact(&constants)?;
        }
        let stoppable = Stoppable::begin();
        let (found, evaluations) =
            search::run(options, &constants, (&design, &settings), &stoppable)?;
        let threads = options.threads as usize;
        let settled = settle(&design, found, threads, &|| stoppable.is_stopped());
        let is_whole = !stoppable.is_stopped();
        drop(stoppable);
        let designs = settled.into_iter().map(|settled| Proposal {
            made: design.made(&settled.candidate.design),
            measures: verdict::measures(&design, &constants, &settled.candidate.design),
            contradiction: verdict::contradiction(&design, &constants, &settled.candidate.design),
            candidate: settled.candidate,
            polish: settled.polish,
        });
        let mut designs: Vec<_> = designs.collect();
        if options.robust {
            robust_first(&mut designs);
        }
        let best = designs.first().map(|best| design.values(&best.candidate.design));
        let found = Self {
            synthesis: design.synthesis(),
            way: best.and_then(|values| driven(&constants, &values)),
            designs,
            constants,
            evaluations,
            seed: options.seed,
            seconds: clock.elapsed().as_secs_f64(),
            is_whole,
            curves: None,
        };
        let curves = match (&options.plot, found.best()) {
            (Some(_), Some(best)) => picture::curves(best, &settings)?,
            _ => None,
        };
        Ok(Self { curves, ..found })
    }

    /// The scene as the best design has it, if that gets through its task; its values with as many digits as a picture shows.
    fn best(&self) -> Option<Constants> {
        let best = self.designs.first().filter(|best| best.measures.is_ok())?;
        let mut values = self.constants.values.clone();
        let varied = self.varied().zip(self.synthesis.varied);
        for ((quantity, one), value) in varied.zip(&best.candidate.design) {
            let shown = number::significant(value / quantity.factor, DIGITS).parse::<f64>();
            values[one.constant] = shown.map_or(*value, |shown| shown * quantity.factor);
        }
        Some(self.constants.with_values(&values))
    }

    fn varied(&self) -> impl Iterator<Item = &'static Quantity> {
        let constants = self.constants.scene.constants;
        self.synthesis.varied.iter().map(|one| &constants[one.constant].quantity)
    }

    fn measure(&self, index: usize) -> &'static Quantity {
        &self.constants.scene.measures[index]
    }

    /// The measures of interest: what is made small, then the margins of conditions, then those of preferences.
    fn measures(&self) -> impl Iterator<Item = (usize, &'static Quantity)> {
        let preferences = self.synthesis.preferences.iter().map(|one| &one.0);
        let margins = self.synthesis.conditions.iter().chain(preferences);
        let all = std::iter::once(&self.synthesis.objective).chain(margins);
        all.map(|index| (*index, self.measure(*index)))
    }

    /// What a unit that a preference is missed by costs, with the unit of that.
    fn cost(&self, (index, cost): (usize, f64)) -> (f64, String) {
        let (quantity, objective) = (self.measure(index), self.measure(self.synthesis.objective));
        (cost * quantity.factor / objective.factor, unit::ratio(objective.unit, quantity.unit))
    }
}

/// Puts designs that keep all conditions first, and of these those that are best where they are made within tolerances.
fn robust_first(designs: &mut [Proposal]) {
    designs.sort_by(|a, b| {
        let of =
            |one: &Proposal| (!one.candidate.score.is_kept(), one.made.unwrap_or(f64::INFINITY));
        let (a, b) = (of(a), of(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
}

/// What is made exactly, and a motion, cannot be ranked by what tolerances make of it.
fn refuse_exact(constants: &Constants) -> Result<(), Failure> {
    let scene = constants.scene;
    let refused = |what: &str, remedy: &str| {
        Err(Failure::request(what.to_owned()).place("--robust").remedy(remedy.to_owned()))
    };
    if scene.linkage.is_none() {
        let what = "what tolerances make of a design is known of linkages alone, and this scene moves by itself";
        return refused(
            what,
            "leave --robust out; `assur study --sensitivity` says what changes the best design how much",
        );
    }
    if scene.constants.iter().all(|constant| constant.tolerance <= 0.0) {
        let what = "nothing that the design is made of has a tolerance";
        return refused(
            what,
            "give dimensions a tolerance: `dimension l1 = 20 mm +- 0.02 mm in 5 mm .. 60 mm;`",
        );
    }
    Ok(())
}

/// The only driver of a linkage that goes a way.
fn driven(constants: &Constants, values: &[f64]) -> Option<&'static Quantity> {
    let Bind::Linkage(bind) = constants.scene.bind else { return None };
    let linkage = bind(values).ok()?;
    match linkage.way()? {
        Along::Driver(index, _) => Some(&linkage.shape().drivers[index]),
        Along::Time(..) => None,
    }
}

/// A value that is varied cannot be given.
fn refuse_given(constants: &Constants, synthesis: Synthesis) -> Result<(), Failure> {
    let given = constants.given_names();
    for one in synthesis.varied {
        let name = constants.scene.constants[one.constant].quantity.name;
        if given.contains(&name) {
            return Err(Failure::request(format!("`{name}` is varied, and cannot be given"))
                .place(format!("--set {name}=…"))
                .remedy("leave it out, or state another scene that does not vary it"));
        }
    }
    Ok(())
}

impl Proposal {
    /// A measure with its error.
    fn measure(&self, index: usize) -> (f64, f64) {
        self.measures.as_ref().map_or((f64::NAN, f64::NAN), |all| all[index])
    }

    /// The statement of an equation file that gives its values.
    fn preset(&self, found: &Found, number: usize) -> String {
        let values = found.varied().zip(&self.candidate.design).map(|(quantity, value)| {
            let stated = unit::stated(*value, quantity.factor);
            match quantity.unit {
                "" => format!("{} = {stated};", quantity.name),
                unit if unit.contains(['/', ' ', '^', '*', '(']) => {
                    format!("{} = {stated} [{unit}];", quantity.name)
                }
                unit => format!("{} = {stated} {unit};", quantity.name),
            }
        });
        let values: Vec<String> = values.collect();
        format!("preset found_{number} \"by synthesis\" {{ {} }}", values.join(" "))
    }
}

impl Answer for Found {
    fn figure(&self) -> Option<String> {
        self.curves.clone()
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        table::render(page, self, figure);
    }

    fn csv(&self) -> String {
        let measures: Vec<_> = self.measures().collect();
        let heads = self.varied().chain(measures.iter().map(|one| one.1));
        let mut text = line(heads.map(|one| title(one.name, one.unit)));
        for proposal in &self.designs {
            let values = self.varied().zip(&proposal.candidate.design);
            let values = values.map(|(quantity, value)| cell(value / quantity.factor));
            let found = measures
                .iter()
                .map(|(index, quantity)| cell(proposal.measure(*index).0 / quantity.factor));
            text += &line(values.chain(found));
        }
        text
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        Object::of(self, figure)
    }

    fn outcome(&self) -> Result<(), Failure> {
        if !self.is_whole {
            let what = "it was stopped: more may be found with the whole effort";
            return Err(Failure::interrupted(what));
        }
        if self.designs.iter().any(|one| one.candidate.score.is_kept()) {
            return Ok(());
        }
        Err(Failure::numerical("no design was found that keeps all conditions")
            .reason(self.hardest())
            .remedy("widen the bounds, relax what is missed, or seek longer: --evaluations"))
    }
}
