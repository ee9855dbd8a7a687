//! Modes of a motion and the events between them.

use super::{AugmentedInfo, EquationInfo, SceneModel};
use crate::program::Program;
use crate::syntax::tree::Direction;
use crate::token::Span;

/// A mode of a motion.
#[derive(Clone, Debug)]
pub struct ModeModel {
    /// Its name; empty where a motion has events and no modes.
    pub name: String,
    /// What it is.
    pub summary: String,
    /// The equations that hold in it.
    pub equations: Vec<EquationInfo>,
    /// What ends it, or makes it jump; in the order of the program's `events`.
    pub events: Vec<EventInfo>,
    /// Speeds that are zero in it, by their places in the state vector: those of coordinates that it holds or lacks.
    pub held: Vec<usize>,
    /// The closures that hold the coordinates in it and are not solved for.
    pub augmented: Option<AugmentedInfo>,
    /// The operations.
    pub program: Program,
}

/// What the tables say of an event.
#[derive(Clone, Debug)]
pub struct EventInfo {
    /// What measures call it.
    pub label: Option<String>,
    /// The statement as text.
    pub text: String,
    /// In which direction the guard passes zero.
    pub direction: Direction,
    /// Unit of the guard.
    pub unit: String,
    /// SI value of one such unit.
    pub factor: f64,
    /// The mode that follows, by index.
    pub target: usize,
    /// The switching surface that this is, by index; none for an event of the file.
    pub surface: Option<usize>,
    /// Where it stands in the file.
    pub span: Span,
    /// Whether it is never carried out, whatever the motion.
    pub is_idle: bool,
}

impl EventInfo {
    /// Where a branch goes over to its other side.
    pub fn surface(index: usize, guard: &str, mode: usize, span: Span) -> Self {
        let text = format!("{guard} passes zero");
        Self { surface: Some(index), ..Self::implied(text, Direction::Crosses, mode, span) }
    }

    /// An event that no statement of the file says.
    pub fn implied(text: String, direction: Direction, mode: usize, span: Span) -> Self {
        Self {
            label: None,
            text,
            direction,
            unit: String::new(),
            factor: 1.0,
            target: mode,
            surface: None,
            span,
            is_idle: false,
        }
    }
}

impl SceneModel {
    /// Its modes as scenes of their own; none where there are none.
    pub fn split(&self) -> Vec<SceneModel> {
        let mode = |(index, mode): (usize, &ModeModel)| {
            let mut program = mode.program.clone();
            // What is made of a whole run, or of the time alone, is no matter of modes: the first one computes it.
            if index != self.first {
                program.results.measures.clear();
                program.results.drivers.clear();
            }
            let equations = mode.equations.clone();
            let augmented = mode.augmented.clone();
            SceneModel { program, equations, augmented, modes: Vec::new(), ..self.clone() }
        };
        self.modes.iter().enumerate().map(mode).collect()
    }
}
