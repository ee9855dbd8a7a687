//! The picture of a mechanism: drawn where it has points, else the curves of a scene.

use assur::problem::Span;
use assur::registry::{Mechanism, SceneEntry};

use super::found::Found;
use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::{draw, linkage, motion};

/// What is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Drawing,
    Curves,
}

/// A picture of a mechanism.
pub struct Picture {
    mechanism: &'static Mechanism,
    /// The scene that is shown.
    pub scene: &'static SceneEntry,
    kind: Kind,
}

impl Picture {
    /// The picture of a mechanism: of its first scene that moves, or else of one that rests and has points. None of what
    /// only evaluates positions.
    ///
    /// # Errors
    /// When the mechanism refuses its own values.
    pub fn of(mechanism: &'static Mechanism) -> Result<Option<Self>, Failure> {
        let mut resting = None;
        for scene in mechanism.scenes {
            let kind = if scene.points.is_empty() { Kind::Curves } else { Kind::Drawing };
            let picture = Self { mechanism, scene, kind };
            match activity(mechanism, scene)? {
                Activity::Moves => return Ok(Some(picture)),
                Activity::Rests if kind == Kind::Drawing && resting.is_none() => {
                    resting = Some(picture)
                }
                Activity::Rests | Activity::Open => {}
            }
        }
        Ok(resting)
    }

    /// The scene that has to be run for it.
    pub fn curves(&self) -> Option<&'static SceneEntry> {
        (self.kind == Kind::Curves).then_some(self.scene)
    }

    /// Draws it, curves from what was found.
    ///
    /// # Errors
    /// When there is nothing to draw.
    pub fn draw(&self, found: &Found) -> Result<String, Failure> {
        let place = || format!("{}, scene {}", self.mechanism.name, self.scene.name);
        match self.kind {
            Kind::Drawing => {
                let picture = draw::still(Constants::declared(self.mechanism, self.scene));
                picture.map_err(|failure| failure.place(place()))
            }
            Kind::Curves => found
                .figure(self.scene)
                .ok_or_else(|| Failure::numerical("there is nothing to draw").place(place())),
        }
    }

    /// The command that shows it.
    pub fn command(&self) -> String {
        let verb = match self.kind {
            Kind::Drawing => "draw",
            Kind::Curves => "run",
        };
        format!("assur {verb} {} --scene {}", self.mechanism.name, self.scene.name)
    }
}

/// Whether there is anything to see of a scene.
enum Activity {
    Moves,
    Rests,
    /// It evaluates positions where they are asked for.
    Open,
}

fn activity(
    mechanism: &'static Mechanism,
    scene: &'static SceneEntry,
) -> Result<Activity, Failure> {
    let constants = Constants::declared(mechanism, scene);
    if scene.linkage.is_some() {
        let is_open = linkage::case::Case::new(constants)?.axes().is_empty();
        return Ok(if is_open { Activity::Open } else { Activity::Moves });
    }
    Ok(match motion::case::Case::new(constants)?.moved.task {
        Span::Open => Activity::Open,
        Span::Rest => Activity::Rests,
        Span::Autonomous | Span::Periodic(_) | Span::Run(..) => Activity::Moves,
    })
}
