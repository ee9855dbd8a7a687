//! The motions that the library finds for a scene, and what is said where there is none.

use assur::answer::{Error, Motion, Question, Settings};
use assur::measure::Missing;
use assur::model::Model;
use assur::problem::Span;
use assur::registry::SceneEntry;

use super::case::Case;
use super::unfollowed;
use crate::error::{Failure, Told};

impl Case {
    /// Finds the motion.
    ///
    /// # Errors
    /// When the solver does not succeed, with the facts that it gives.
    pub fn solve(&self, settings: &Settings) -> Result<Motion, Failure> {
        let motion = Question::of(self.model()).attempt(settings);
        motion.map_err(|error| self.unanswered(&error))
    }

    /// Why there is no motion, in words.
    pub fn tell(&self, error: &Error) -> Told {
        told(self.scene, self.run(), error)
    }

    /// Why there is no motion.
    pub fn unanswered(&self, error: &Error) -> Failure {
        let told = self.tell(error);
        let what = match error {
            Error::NoCycle(_) => "no motion that repeats was found",
            Error::NotAtRest(_) => "no position of rest was found",
            Error::NotSteady(_) => "no steady state was found",
            _ => "the motion could not be followed to its end",
        };
        told.failure(what).lost(error.is_lost())
    }

    /// Seconds that following the motion over one cycle takes, or over the run.
    ///
    /// # Errors
    /// When the integration does not succeed.
    pub fn time_cycle(&self, motion: &Motion) -> Result<f64, Failure> {
        let (from, to) = self.moved.task.limits();
        let (mode, start) = motion.place(from);
        let clock = std::time::Instant::now();
        self.run()
            .follow_in(mode, (from, to), &start, &motion.settings)
            .map_err(|error| self.unanswered(&Error::Stopped(error)))?;
        Ok(clock.elapsed().as_secs_f64())
    }

    /// Name of a mode.
    pub fn mode(&self, mode: usize) -> &'static str {
        self.scene.modes.get(mode).map_or("", |mode| mode.name)
    }
}

/// Why there is no motion, with the names of its modes and events.
fn told(scene: &SceneEntry, run: &dyn Model, error: &Error) -> Told {
    match error {
        Error::Stopped(error) => unfollowed::tell(scene, run, error),
        Error::NoCycle(error) => unfollowed::tell_cycle(scene, run, error),
        Error::NotSteady(error) => unfollowed::tell_periodic(scene, run, error),
        Error::NotAtRest(error) => unfollowed::tell_rest(scene, run, error),
        other => Told::new(other.to_string(), "check what is asked for"),
    }
}

/// The measures of one of many runs over its task; if there is none, why, in words.
///
/// # Errors
/// When the solver does not succeed, or the scene has no task.
pub fn measures(
    scene: &SceneEntry,
    run: Box<dyn Model>,
    settings: &Settings,
) -> Result<Vec<Result<f64, Missing>>, String> {
    let question = Question::of(run.into());
    let motion = question.solve(settings);
    let motion = motion.map_err(|error| told(scene, question.model(), &error).reason)?;
    match motion.task() {
        Span::Open => Err("the scene has no task".to_owned()),
        _ => Ok(motion.measures()),
    }
}
