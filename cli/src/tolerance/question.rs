//! From options to a question that the solvers understand.

use assur::closure::Variable;
use assur::registry::{Distribution, LinkageEntry, Mechanism, Quantity, RunLinkage, SceneEntry};
use assur::tolerance::{Candidate, Cost, Rule, Sampling, Source, Study};

use super::arguments::{Kind, ToleranceArguments};
use super::places::{along, range};
use crate::constants::Constants;
use crate::error::Failure;
use crate::linkage::case::shown;
use crate::lookup::{self, suggestion};
use crate::number;
use crate::values::{quantity, split};

/// Most places over the range.
const PLACES: usize = 10_000;

/// A question, and what its numbers are called.
pub struct Question {
    /// The mechanism.
    pub mechanism: &'static Mechanism,
    /// The scene.
    pub scene: &'static SceneEntry,
    /// The linkage with these values.
    pub run: Box<dyn RunLinkage>,
    /// Its drivers as they are shown, angles in degrees.
    pub drivers: Vec<Quantity>,
    /// What was given with --set, in words; empty if nothing.
    pub changed: String,
    /// What errs, over the range.
    pub study: Study,
    /// Whether the output was named; else it is the last one of the scene.
    pub is_named: bool,
    /// Places over the range of the first driver alone, where the study goes over a grid.
    pub along: Option<Vec<Vec<f64>>>,
    /// What each source is called.
    pub labels: Vec<Label>,
    /// Where `--at` looks.
    pub at: Option<Vec<f64>>,
    /// Which bands are wanted.
    pub kind: Kind,
    /// How linkages are made.
    pub sampling: Sampling,
    /// What is to be chosen.
    pub allocation: Option<Wanted>,
}

/// What a source of error is called.
#[derive(Clone, Copy)]
pub struct Label {
    /// The quantity that errs.
    pub quantity: &'static Quantity,
    /// Whether by play.
    pub is_play: bool,
}

/// Tolerances to be chosen.
pub struct Wanted {
    /// The band.
    pub band: f64,
    /// How the error is reckoned.
    pub rule: Rule,
    /// Which tolerances, in the order of the sources that are no play.
    pub candidates: Vec<Candidate>,
}

impl Question {
    /// Reads the options.
    ///
    /// # Errors
    /// A name, unit or number that is wrong, or a scene that is no linkage.
    pub fn read(options: &ToleranceArguments) -> Result<Self, Failure> {
        let Some(name) = &options.name else {
            return Err(lookup::no_linkage("tolerance"));
        };
        let mechanism = lookup::mechanism(name)?;
        let (scene, linkage) = scene(mechanism, options.scene.as_deref())?;
        let preset = options.preset.as_deref();
        let constants = Constants::from_options(mechanism, scene, preset, &options.set)?;
        let run = scene.bind.linkage(&constants.values).map_err(|refused| {
            Failure::request(format!(
                "scene `{}` does not accept these values",
                scene.name
            ))
            .reason(refused.to_string())
            .remedy("change the value with --set, or leave it out for the default")
        })?;
        if !(2..=PLACES).contains(&options.places) {
            return Err(
                Failure::request(format!("--places {} cannot be", options.places))
                    .remedy(format!("choose from 2 to {PLACES}")),
            );
        }
        let names = Names { scene, linkage };
        let (sources, labels) = names.sources(options)?;
        let study = Study {
            output: names.output(options.output.as_deref())?,
            places: range(&*run, options.places),
            sources,
        };
        let allocation = match &options.allocate {
            Some(band) => Some(names.wanted(options, band, &study, &labels)?),
            None => None,
        };
        Ok(Self {
            mechanism,
            scene,
            at: names.place(&*run, &options.at)?,
            along: along(&*run, options.places),
            drivers: scene.drivers.iter().map(shown).collect(),
            changed: changed(&constants),
            run,
            study,
            labels,
            is_named: options.output.is_some(),
            kind: options.kind,
            sampling: Sampling {
                samples: options.samples,
                seed: options.seed,
                ..Sampling::default()
            },
            allocation,
        })
    }

    /// The output.
    pub fn output(&self) -> &'static Quantity {
        &self.scene.outputs[self.study.output]
    }

    /// Names of the other outputs.
    pub fn other_outputs(&self) -> Vec<&'static str> {
        let outputs = self.scene.outputs.iter().enumerate();
        let others = outputs.filter(|(index, _)| *index != self.study.output);
        others.map(|(_, one)| one.name).collect()
    }
}

/// The values that were given with --set, in words.
fn changed(constants: &Constants) -> String {
    let all = constants.scene.constants.iter().enumerate();
    let given = all.filter(|(index, _)| constants.is_changed(*index));
    let words = given.map(|(index, constant)| {
        let quantity = &constant.quantity;
        let value = number::declared(constants.values[index] / quantity.factor);
        format!("{} = {value} {}", quantity.name, quantity.unit)
            .trim_end()
            .to_owned()
    });
    words.collect::<Vec<_>>().join(", ")
}

/// The scene, the first linkage if none is named.
fn scene(
    mechanism: &'static Mechanism,
    name: Option<&str>,
) -> Result<(&'static SceneEntry, &'static LinkageEntry), Failure> {
    let mut scenes = mechanism.scenes.iter();
    let first = scenes.find(|scene| scene.linkage.is_some());
    let scene = match (name, first) {
        (None, Some(first)) => first,
        _ => lookup::linkage(mechanism, name)?,
    };
    match &scene.linkage {
        Some(linkage) => Ok((scene, linkage)),
        None => Err(Failure::request(format!(
            "scene `{}` is no linkage",
            scene.name
        ))),
    }
}

/// The names of a scene.
struct Names {
    scene: &'static SceneEntry,
    linkage: &'static LinkageEntry,
}

impl Names {
    /// The quantity of a variable, its tolerance and how it is distributed.
    fn variable(&self, index: usize) -> (&'static Quantity, f64, Distribution) {
        match self.linkage.variables[index] {
            Variable::Constant(index) => {
                let one = &self.scene.constants[index];
                (&one.quantity, one.tolerance, one.distribution)
            }
            Variable::Driver(index) => {
                let (tolerance, distribution) = self.linkage.tolerances[index];
                (&self.scene.drivers[index], tolerance, distribution)
            }
        }
    }

    /// The index of a variable.
    fn find(&self, name: &str, option: &str) -> Result<usize, Failure> {
        let count = self.linkage.variables.len();
        let names: Vec<_> = (0..count).map(|one| self.variable(one).0.name).collect();
        names.iter().position(|one| *one == name).ok_or_else(|| {
            Failure::request(format!("nothing that can err is called `{name}`"))
                .place(format!("{option} {name}=…"))
                .remedy(suggestion(name, &names))
        })
    }

    /// Reads `NAME=VALUE` with the unit of the variable.
    fn read(&self, text: &str, option: &str) -> Result<(usize, f64), Failure> {
        let (name, value) = split(text, option, "l5=0.02mm")?;
        let index = self.find(name, option)?;
        let value = quantity(value, self.variable(index).0)
            .map_err(|failure| failure.place(format!("{option} {text}")))?;
        match value >= 0.0 {
            true => Ok((index, value)),
            false => Err(
                Failure::request(format!("`{name}` cannot err by less than nothing"))
                    .place(format!("{option} {text}"))
                    .remedy("give a half-width of zero or more"),
            ),
        }
    }

    /// What errs.
    fn sources(&self, options: &ToleranceArguments) -> Result<(Vec<Source>, Vec<Label>), Failure> {
        if !(options.scale > 0.0 && options.scale.is_finite()) {
            return Err(
                Failure::request(format!("--scale {} cannot be", options.scale))
                    .remedy("give a positive number"),
            );
        }
        let variables = 0..self.linkage.variables.len();
        let mut tolerances: Vec<f64> = variables.map(|one| self.variable(one).1).collect();
        for text in &options.tolerance {
            let (index, value) = self.read(text, "--tolerance")?;
            tolerances[index] = value;
        }
        let mut sources = Vec::new();
        let mut labels = Vec::new();
        for (variable, tolerance) in tolerances.into_iter().enumerate() {
            let (quantity, _, distribution) = self.variable(variable);
            if tolerance > 0.0 {
                sources.push(Source {
                    variable,
                    half_width: tolerance * options.scale,
                    distribution,
                });
                labels.push(Label {
                    quantity,
                    is_play: false,
                });
            }
        }
        for text in &options.play {
            let (variable, radial) = self.read(text, "--play")?;
            sources.push(Source::play(variable, radial));
            labels.push(Label {
                quantity: self.variable(variable).0,
                is_play: true,
            });
        }
        match sources.is_empty() {
            false => Ok((sources, labels)),
            true => Err(Failure::request("nothing has a tolerance in this scene")
                .remedy("state one in the file, `dimension l4 = 90 mm +- 0.05 mm;`, or with --tolerance NAME=VALUE")),
        }
    }

    /// The index of the output.
    fn output(&self, name: Option<&str>) -> Result<usize, Failure> {
        let names: Vec<_> = self.scene.outputs.iter().map(|one| one.name).collect();
        let Some(name) = name else {
            return names.len().checked_sub(1).ok_or_else(|| {
                Failure::request(format!("scene `{}` has no output", self.scene.name))
            });
        };
        names.iter().position(|one| *one == name).ok_or_else(|| {
            Failure::request(format!(
                "scene `{}` has no output `{name}`",
                self.scene.name
            ))
            .place(format!("--output {name}"))
            .remedy(suggestion(name, &names))
        })
    }

    /// Where `--at` looks.
    fn place(&self, run: &dyn RunLinkage, options: &[String]) -> Result<Option<Vec<f64>>, Failure> {
        if options.is_empty() {
            return Ok(None);
        }
        let mut place: Vec<f64> = run.ranges().iter().map(|range| range.start).collect();
        let mut time = None;
        for text in options.iter().flat_map(|text| text.split(',')) {
            match crate::values::place(self.scene, text)? {
                crate::values::Place::Time(at) => time = Some(at),
                crate::values::Place::Driver(index, value) => {
                    place[index] = value;
                    let at = |time| {
                        let drive = run.drive(time);
                        drive
                            .and_then(|all| all.get(index).copied())
                            .unwrap_or(f64::NAN)
                    };
                    time = time.or(run.span().time_of(at, value).ok());
                }
            }
        }
        let moving = time.and_then(|time| run.drive(time));
        Ok(Some(moving.unwrap_or(place)))
    }

    /// What is to be chosen.
    fn wanted(
        &self,
        options: &ToleranceArguments,
        band: &str,
        study: &Study,
        labels: &[Label],
    ) -> Result<Wanted, Failure> {
        let output = &self.scene.outputs[study.output];
        let band = quantity(band, output).map_err(|_| {
            let (unit, example) = match output.unit {
                "deg" | "rad" => ("mrad".to_owned(), "1mrad".to_owned()),
                unit if unit.chars().all(char::is_alphabetic) => {
                    (unit.to_owned(), format!("0.1{unit}"))
                }
                unit => (unit.to_owned(), format!("'0.1 [{unit}]'")),
            };
            Failure::request(format!("`{band}` is no band of `{}`", output.name))
                .place(format!("--allocate {band}"))
                .reason(format!("expected a number with a unit like {unit}"))
                .remedy(format!("for example: --allocate {example}"))
        })?;
        let mut weights = vec![1.0; self.linkage.variables.len()];
        for text in &options.cost {
            let (name, weight) = split(text, "--cost", "s=2")?;
            let index = self.find(name, "--cost")?;
            weights[index] = weight.parse().map_err(|_| {
                Failure::request(format!("`{weight}` is no weight"))
                    .place(format!("--cost {text}"))
                    .remedy("give a positive number, --cost s=2")
            })?;
        }
        let mut limits = vec![(0.0, f64::INFINITY); weights.len()];
        for text in &options.limit {
            let (index, limit) = self.limit(text)?;
            limits[index] = limit;
        }
        let own = study.sources.iter().zip(labels);
        let candidates = own.filter(|(_, label)| !label.is_play).map(|(source, _)| {
            let (least, most) = limits[source.variable];
            let (_, declared, _) = self.variable(source.variable);
            let present = if declared > 0.0 {
                declared
            } else {
                source.half_width
            };
            Candidate {
                variable: source.variable,
                distribution: source.distribution,
                cost: Cost {
                    fixed: 0.0,
                    factor: weights[source.variable] * present,
                    exponent: 1.0,
                },
                least,
                most,
            }
        });
        Ok(Wanted {
            band,
            rule: match options.kind {
                Kind::Rss => Rule::Deviation,
                _ => Rule::Worst,
            },
            candidates: candidates.collect(),
        })
    }

    /// Reads `NAME=LOW..HIGH`.
    fn limit(&self, text: &str) -> Result<(usize, (f64, f64)), Failure> {
        let (name, value) = split(text, "--limit", "s=0.05mm..0.2mm")?;
        let index = self.find(name, "--limit")?;
        let ends = value.split_once("..").ok_or_else(|| {
            Failure::request("--limit takes NAME=LOW..HIGH")
                .place(format!("--limit {text}"))
                .remedy("for example: --limit s=0.05mm..0.2mm")
        })?;
        let read = |text: &str| match text.trim() {
            "" => Ok(None),
            text => quantity(text, self.variable(index).0).map(Some),
        };
        let place = |failure: Failure| failure.place(format!("--limit {text}"));
        let low = read(ends.0).map_err(place)?.unwrap_or(0.0);
        let high = read(ends.1).map_err(place)?.unwrap_or(f64::INFINITY);
        Ok((index, (low, high)))
    }
}
