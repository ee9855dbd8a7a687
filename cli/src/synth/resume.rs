//! The file of where a search stands.
//!
//! Numbers are stored by their bits: a search that goes on comes to what it would have come to without a stop, to the last digit.

use std::path::Path;
use std::time::{Duration, Instant};

use assur::answer::Settings;
use assur::study::{Candidate, Stand};
use assur::synthesis::{Population, Score};
use serde::{Deserialize, Serialize};

use super::SynthArguments;
use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::show::output::Destination;

/// What such a file is.
const FORMAT: &str = "assur-search/2";
/// How long a search goes on before it is written down again.
const BETWEEN: Duration = Duration::from_secs(5);

/// Where a search stands, as it is stored.
#[derive(Serialize, Deserialize)]
struct Stored {
    format: String,
    /// What is sought, in words, and all that it follows from.
    problem: String,
    follows_from: String,
    over: u64,
    judged: u64,
    found: Vec<Found>,
    populations: Vec<Option<Designs>>,
}

#[derive(Serialize, Deserialize)]
struct Found {
    design: Vec<u64>,
    score: [u64; 2],
    evaluations: u64,
    is_gathered: bool,
}

#[derive(Serialize, Deserialize)]
struct Designs {
    designs: Vec<u64>,
    scores: Vec<[u64; 2]>,
    archive: Vec<u64>,
    memory: Vec<[u64; 2]>,
    next: usize,
    generation: u64,
    evaluations: u64,
}

/// A search that can go on.
pub struct Search {
    file: Option<Destination>,
    problem: String,
    follows_from: String,
    /// Numbers of a design, and how many of them are chosen.
    length: (usize, usize),
    written: Instant,
    /// Where it begins.
    pub stand: Stand,
}

impl Search {
    /// The search that is asked for, from its file if there is one.
    ///
    /// # Errors
    /// The file cannot be read or written, is none of a search, or one of another search.
    pub fn begin(
        options: &SynthArguments,
        constants: &Constants,
        settings: &Settings,
    ) -> Result<Self, Failure> {
        let problem = format!("{}, scene {}", constants.mechanism.name, constants.scene.name);
        let mut search = Self {
            file: None,
            follows_from: premises(options, constants, settings),
            length: constants
                .scene
                .shape
                .synthesis
                .map_or((0, 0), |one| (one.varied.len(), one.chosen())),
            problem,
            written: Instant::now(),
            stand: Stand::default(),
        };
        if let Some(path) = &options.resume {
            search.file = Some(Destination::check(path)?);
            if path.exists() {
                search.stand = search.read(path)?;
            }
        }
        Ok(search)
    }

    fn read(&self, path: &Path) -> Result<Stand, Failure> {
        let file = path.display();
        let text = std::fs::read_to_string(path)
            .map_err(|error| Failure::request(format!("{file} cannot be read: {error}")))?;
        let stored: Option<Stored> = serde_json::from_str(&text).ok();
        let stored = stored.filter(|stored| stored.format == FORMAT).ok_or_else(|| {
            Failure::request(format!("{file} is not the file of a search"))
                .place("--resume")
                .remedy("name a file that is not there yet, or one that such a search has written")
        })?;
        if stored.follows_from != self.follows_from {
            return Err(Failure::request(format!(
                "{file} is of another search: of {}, or with other values, bounds, conditions, seed or effort",
                stored.problem
            ))
            .place("--resume")
            .remedy("ask for the same search, or name another file"));
        }
        let stand = stored.stand();
        stand.filter(|stand| self.is_sound(stand)).ok_or_else(|| {
            Failure::request(format!("{file} is damaged")).place("--resume").remedy("remove it")
        })
    }

    /// Whether all designs have as many numbers as are sought.
    fn is_sound(&self, stand: &Stand) -> bool {
        let has_all = |numbers: usize, designs: usize| numbers == designs * self.length.1;
        stand.found.iter().all(|one| one.design.len() == self.length.0)
            && stand
                .populations
                .iter()
                .flatten()
                .all(|one| has_all(one.designs.len(), one.scores.len()))
    }

    /// Writes it down, if that is some time ago.
    ///
    /// # Errors
    /// The system refuses.
    pub fn keep(&mut self, stand: &Stand) -> Result<(), Failure> {
        match self.written.elapsed() >= BETWEEN {
            true => self.write(stand),
            false => Ok(()),
        }
    }

    /// Writes it down.
    ///
    /// # Errors
    /// The system refuses.
    pub fn write(&mut self, stand: &Stand) -> Result<(), Failure> {
        self.written = Instant::now();
        let Some(file) = &self.file else { return Ok(()) };
        let text = serde_json::to_string(&Stored::of(stand, self));
        let text = text.map_err(|error| Failure::numerical(error.to_string()))?;
        file.write(text.as_bytes())
    }
}

/// All that a search follows from.
fn premises(options: &SynthArguments, constants: &Constants, settings: &Settings) -> String {
    let (mechanism, shape) = (constants.mechanism, constants.scene.shape);
    let effort = (options.seed, options.searches, options.population, options.evaluations);
    let scene = (shape.name, shape.effects, shape.choices, shape.synthesis);
    let values = bits(&constants.values);
    format!("{effort:?} {scene:?} {values:?} {settings:?} {} {:?}", mechanism.text, mechanism.parts)
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

fn numbers(bits: &[u64]) -> Vec<f64> {
    bits.iter().map(|bits| f64::from_bits(*bits)).collect()
}

fn of_score(score: &Score) -> [u64; 2] {
    [score.missed.to_bits(), score.value.to_bits()]
}

fn score([missed, value]: [u64; 2]) -> Score {
    Score { missed: f64::from_bits(missed), value: f64::from_bits(value) }
}

impl Stored {
    fn of(stand: &Stand, search: &Search) -> Self {
        let found = stand.found.iter().map(|one| Found {
            design: bits(&one.design),
            score: of_score(&one.score),
            evaluations: one.evaluations,
            is_gathered: one.is_gathered,
        });
        Self {
            format: FORMAT.to_owned(),
            problem: search.problem.clone(),
            follows_from: search.follows_from.clone(),
            over: stand.over,
            judged: stand.judged,
            found: found.collect(),
            populations: stand
                .populations
                .iter()
                .map(|one| one.as_ref().map(Designs::of))
                .collect(),
        }
    }

    /// Where the search stands; none if something is missing.
    fn stand(self) -> Option<Stand> {
        let found = self.found.into_iter().map(|one| Candidate {
            design: numbers(&one.design),
            score: score(one.score),
            evaluations: one.evaluations,
            is_gathered: one.is_gathered,
        });
        let mut populations = Vec::with_capacity(self.populations.len());
        for one in self.populations {
            populations.push(match one {
                Some(one) => Some(one.population()?),
                None => None,
            });
        }
        Some(Stand { found: found.collect(), over: self.over, judged: self.judged, populations })
    }
}

impl Designs {
    fn of(population: &Population) -> Self {
        Self {
            designs: bits(&population.designs),
            scores: population.scores.iter().map(of_score).collect(),
            archive: bits(&population.archive),
            memory: population.memory.iter().map(|pair| pair.map(f64::to_bits)).collect(),
            next: population.next,
            generation: population.generation,
            evaluations: population.evaluations,
        }
    }

    fn population(self) -> Option<Population> {
        let memory: Vec<[f64; 2]> =
            self.memory.iter().map(|pair| pair.map(f64::from_bits)).collect();
        Some(Population {
            designs: numbers(&self.designs),
            scores: self.scores.into_iter().map(score).collect(),
            archive: numbers(&self.archive),
            next: self.next,
            generation: self.generation,
            evaluations: self.evaluations,
            memory: memory.try_into().ok()?,
        })
    }
}
