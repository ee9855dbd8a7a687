//! Modes of a motion and the events between them.

use super::EquationInfo;
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
        Self {
            label: None,
            text: format!("{guard} passes zero"),
            direction: Direction::Crosses,
            unit: String::new(),
            factor: 1.0,
            target: mode,
            surface: Some(index),
            span,
            is_idle: false,
        }
    }
}
