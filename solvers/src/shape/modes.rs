//! The modes of a motion and their events.

use super::{Augmented, List, Text};

/// A mode as data.
#[derive(Clone, Copy, Debug)]
pub struct ModeEntry {
    /// Name of the mode; empty where a motion has events and no modes.
    pub name: Text,
    /// What it is.
    pub summary: Text,
    /// What ends it, or makes it jump.
    pub events: List<EventEntry>,
    /// Speeds that are zero in it, by their places in the state vector.
    pub held: List<usize>,
    /// Number of kinks: what passes zero where a guard that is not smooth goes over to another branch.
    pub kinks: usize,
    /// Number of angles of which its guards have the sine or cosine.
    pub turns: usize,
    /// The closures that hold the coordinates in it and are not solved for.
    pub augmented: Option<Augmented>,
}

impl ModeEntry {
    /// A mode with its events.
    #[doc(hidden)]
    pub const fn new(name: Text, summary: Text, events: List<EventEntry>) -> Self {
        Self { name, summary, events, held: &[], kinks: 0, turns: 0, augmented: None }
    }

    /// With speeds that are zero.
    #[doc(hidden)]
    pub const fn holds(mut self, held: List<usize>) -> Self {
        self.held = held;
        self
    }

    /// With kinks and angles of its guards.
    #[doc(hidden)]
    pub const fn bends(mut self, kinks: usize, turns: usize) -> Self {
        (self.kinks, self.turns) = (kinks, turns);
        self
    }

    /// With closures that hold the coordinates.
    #[doc(hidden)]
    pub const fn augmented(mut self, augmented: Augmented) -> Self {
        self.augmented = Some(augmented);
        self
    }

    /// The number of its guards, kinks among them.
    pub fn guards(&self) -> usize {
        self.events.len() + self.kinks
    }

    /// The number of values that [`Events::guards`](crate::problem::Events::guards) writes: guards, and angles behind them.
    pub fn written(&self) -> usize {
        self.guards() + self.turns
    }
}

/// How a guard passes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From below.
    Rises,
    /// From above.
    Falls,
    /// Either way.
    Crosses,
}

impl Direction {
    /// Whether a guard that gets this sign passes zero in this direction.
    #[inline]
    pub fn allows(self, rising: bool) -> bool {
        match self {
            Self::Rises => rising,
            Self::Falls => !rising,
            Self::Crosses => true,
        }
    }
}

/// An event of a mode.
#[derive(Clone, Copy, Debug)]
pub struct EventEntry {
    /// The statement.
    pub text: Text,
    /// In which direction the guard passes zero.
    pub direction: Direction,
    /// Unit of the guard; empty for a pure number.
    pub unit: Text,
    /// SI value of one such unit.
    pub factor: f64,
    /// The mode that follows, by index.
    pub target: usize,
    /// The switching surface that this is, by index: where a branch of the equations goes over to its other side. None
    /// for an event.
    pub surface: Option<usize>,
    /// Whether it asks for more than its guard, `if` in the statement.
    pub conditional: bool,
    /// Whether the state is another one after it.
    pub sets: bool,
    /// Line in the equation file, from 1: events of several modes on one line are one statement.
    pub line: u32,
}

impl EventEntry {
    /// An event with its statement, what its guard is measured in, and the mode that follows.
    #[doc(hidden)]
    pub const fn new(
        line: u32,
        text: Text,
        direction: Direction,
        unit: Text,
        factor: f64,
        target: usize,
    ) -> Self {
        Self {
            text,
            direction,
            unit,
            factor,
            target,
            surface: None,
            conditional: false,
            sets: false,
            line,
        }
    }

    /// Which asks for more than its guard.
    #[doc(hidden)]
    pub const fn conditional(mut self) -> Self {
        self.conditional = true;
        self
    }

    /// Which sets states.
    #[doc(hidden)]
    pub const fn sets(mut self) -> Self {
        self.sets = true;
        self
    }

    /// A switching surface.
    #[doc(hidden)]
    pub const fn surface(mut self, surface: usize) -> Self {
        self.surface = Some(surface);
        self
    }
}
