//! The request, read and checked.

use assur::answer::Settings;
use assur::registry::SceneEntry;
use assur::shape::{Constant, Quantity};
use assur::study::{self, Outcome};

use super::arguments::{MOST, StudyArguments};
use super::tolerance;
use crate::ask::For;
use crate::ask::constants::Constants;
use crate::ask::lookup::Registry;
use crate::ask::lookup::suggestion;
use crate::ask::range::{self, Range};
use crate::ask::values::TIME;
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::motion::solve;

/// What is asked.
pub struct Question {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// The values that all runs have in common.
    pub constants: Constants,
    /// What differs.
    pub way: Plan,
    /// The measures, by index.
    pub measures: Vec<usize>,
    /// The method and its accuracy.
    pub settings: Settings,
    /// Number of threads.
    pub threads: usize,
}

/// How the runs differ.
pub enum Plan {
    /// Over one range, or two.
    Grid(Vec<Range>),
    /// With values made at random: the constants with their tolerances, the number of runs, the seed.
    Random(Vec<Constant>, usize, u64),
}

impl Question {
    /// Reads it.
    ///
    /// # Errors
    /// Whatever is unknown, cannot be, or does not go together.
    pub fn read(options: &StudyArguments, registry: Registry) -> Result<Self, Failure> {
        let scenes = if options.resonances { For::All } else { For::Measured };
        let constants = options.asked.find(registry, "study", scenes)?;
        let scene = constants.scene;
        let way = match options.samples {
            Some(samples) => random(options, scene, &constants, samples)?,
            None => grid(options, scene, &constants)?,
        };
        Ok(Self {
            scene,
            constants,
            way,
            measures: measures(scene, options.measure.as_deref())?,
            settings: match scene.linkage {
                Some(_) => options.accuracy.none_for_linkages()?,
                None => options.accuracy.settings(scene)?,
            },
            threads: options.threads as usize,
        })
    }

    /// The value that is gone through, with its values in SI units.
    pub fn over(&self) -> (&'static Quantity, &[f64]) {
        match &self.way {
            Plan::Grid(ranges) => match ranges.first() {
                Some(Range { constant, values }) => {
                    (&self.scene.constants[*constant].quantity, values)
                }
                None => (&TIME, &[]),
            },
            Plan::Random(..) => (&TIME, &[]),
        }
    }

    /// Number of runs.
    pub fn count(&self) -> usize {
        match &self.way {
            Plan::Grid(ranges) => ranges.iter().map(|range| range.values.len()).product(),
            Plan::Random(_, samples, _) => *samples,
        }
    }

    /// The measures with these values (SI units); or why there are none.
    pub fn measures_with(&self, values: &[f64]) -> Outcome {
        match self.scene.linkage {
            Some(_) => {
                let case = Case::new(self.constants.with_values(values));
                let case = case.map_err(|failure| failure.why().unwrap_or_default().to_owned())?;
                let found = case.measures().map_err(|error| case.tell(&error).reason)?;
                Ok(found.into_iter().map(|one| one.value).collect())
            }
            None => {
                let run = self.scene.bind.motion(values);
                let run = run.map_err(|refused| refused.to_string())?;
                solve::measures(self.scene, run, &self.settings)
            }
        }
    }

    /// The values of a run, SI units. Of two ranges the first changes fastest.
    pub fn values(&self, index: usize) -> Vec<f64> {
        let mut values = self.constants.values.clone();
        match &self.way {
            Plan::Grid(ranges) => {
                let mut rest = index;
                for range in ranges {
                    values[range.constant] = range.values[rest % range.values.len()];
                    rest /= range.values.len();
                }
                values
            }
            Plan::Random(constants, _, seed) => study::drawn(constants, &values, *seed, index),
        }
    }
}

fn grid(
    options: &StudyArguments,
    scene: &SceneEntry,
    constants: &Constants,
) -> Result<Plan, Failure> {
    let ranges = options.over.iter().map(|text| range::read(scene, text, None));
    let ranges: Vec<Range> = ranges.collect::<Result<_, _>>()?;
    if options.sensitivity {
        return Ok(Plan::Grid(ranges));
    }
    for (is_asked, what) in
        [(options.attractors, "what attracts is"), (options.resonances, "resonances are")]
    {
        if is_asked && ranges.len() != 1 {
            return Err(Failure::request(format!("{what} looked for over one range"))
                .remedy("add --over NAME=FROM..TO:COUNT once"));
        }
    }
    if ranges.is_empty() || ranges.len() > 2 {
        return Err(Failure::request(
            "a study goes through one range or two, or makes values at random",
        )
        .remedy("add --over NAME=FROM..TO:COUNT once or twice, or --samples 1000"));
    }
    if ranges.len() == 2 && ranges[0].constant == ranges[1].constant {
        return Err(Failure::request("both ranges are of the same value")
            .place(format!("--over {}", options.over[1]))
            .remedy("name another one"));
    }
    let given = constants.given_names();
    for (range, text) in ranges.iter().zip(&options.over) {
        let name = scene.constants[range.constant].quantity.name;
        if given.contains(&name) {
            return Err(Failure::request(format!(
                "`{name}` is given twice, with --over and --set"
            ))
            .place(format!("--over {text}"))
            .remedy("leave one of them out"));
        }
    }
    let count: usize = ranges.iter().map(|range| range.values.len()).product();
    if count as u64 > MOST {
        return Err(Failure::request(format!("{count} runs are too many"))
            .remedy(format!("a study has {MOST} at most")));
    }
    Ok(Plan::Grid(ranges))
}

fn random(
    options: &StudyArguments,
    scene: &SceneEntry,
    values: &Constants,
    samples: u64,
) -> Result<Plan, Failure> {
    let constants = tolerance::made(&options.tolerance, scene, values)?;
    if constants.iter().all(|one| one.tolerance == 0.0) {
        return Err(Failure::request(format!(
            "nothing in scene `{}` has a tolerance, so all runs would be the same",
            scene.name
        ))
        .place(format!("--samples {samples}"))
        .remedy("give one: --tolerance NAME=10%"));
    }
    Ok(Plan::Random(constants, samples as usize, options.seed))
}

/// The measures that are asked for, by index.
fn measures(scene: &SceneEntry, names: Option<&str>) -> Result<Vec<usize>, Failure> {
    let known: Vec<&str> = scene.measures.iter().map(|one| one.name).collect();
    let Some(names) = names else {
        return Ok((0..known.len()).collect());
    };
    let wanted = names.split(',').map(str::trim);
    wanted
        .map(|name| {
            known.iter().position(|one| *one == name).ok_or_else(|| {
                Failure::request(format!("scene `{}` has no measure `{name}`", scene.name))
                    .place(format!("--measure {names}"))
                    .remedy(suggestion(name, &known))
            })
        })
        .collect()
}
