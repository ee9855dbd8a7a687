//! Searching: with a bar, from a file and into it, for as long as is asked.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use assur::answer::Settings;
use assur::study::{Candidate, Design, Stand, seek};
use assur::synthesis::Effort;

use super::SynthArguments;
use super::resume::Search;
use crate::ask::constants::Constants;
use crate::ask::values::{TIME, quantity};
use crate::error::Failure;
use crate::show::number;
use crate::show::output::Stoppable;
use crate::show::progress::Progress;

/// Digits of the best value beside the bar.
const DIGITS: usize = 5;

/// The distinct designs that the searches find, the best first, and how many were judged.
pub fn run(
    options: &SynthArguments,
    constants: &Constants,
    (design, settings): (&Design<'_>, &Settings),
    stoppable: &Stoppable,
) -> Result<(Vec<Candidate>, u64), Failure> {
    let effort = Effort {
        evaluations: options.evaluations,
        seed: options.seed,
        population: options.population.map(|size| size as usize),
        threads: options.threads as usize,
    };
    let more = options.more.as_deref().map(|text| duration("--more", text)).transpose()?;
    let end = more.map(|more| Instant::now() + more);
    let mut searched = Search::begin(options, constants, settings)?;
    let mut stand = std::mem::take(&mut searched.stand);
    let scene = constants.scene;
    let what = format!("{}, scene {}: designs", constants.mechanism.name, scene.name);
    let bar = Progress::start(what.clone(), options.evaluations);
    let objective = &scene.measures[design.synthesis().objective];
    let (mut heard, mut refused) = (0, None);
    let mut progress = |stand: &Stand| {
        bar.advance_by(stand.evaluations().saturating_sub(heard));
        heard = heard.max(stand.evaluations());
        if let Some(best) = stand.best().filter(|score| score.is_kept()) {
            let value = number::significant(best.value / objective.factor, DIGITS);
            bar.say(format!("{what}, best {value} {}", objective.unit));
        }
        refused = searched.keep(stand).err();
        // What is asked for is done; more is sought while there is time.
        let is_over = stand.over >= options.searches && end.is_none_or(|end| Instant::now() >= end);
        match stoppable.is_stopped() || refused.is_some() || is_over {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    };
    let found = seek(design, &effort, options.searches, &mut stand, &mut progress);
    let found = found.map_err(|error| Failure::request(error.to_string()))?;
    if let Some(failure) = refused {
        return Err(failure);
    }
    searched.write(&stand)?;
    Ok((found, stand.evaluations()))
}

/// A duration that an option gives.
fn duration(option: &str, text: &str) -> Result<Duration, Failure> {
    let placed = |failure: Failure| {
        failure.place(option.to_owned()).remedy(format!("for example: {option} 60s"))
    };
    let seconds = quantity(text, &TIME).map_err(placed)?;
    let duration = Duration::try_from_secs_f64(seconds).ok().filter(|one| !one.is_zero());
    duration.ok_or_else(|| placed(Failure::request(format!("{text} is no duration"))))
}
