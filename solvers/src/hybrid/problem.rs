//! What the solvers ask of a motion with modes.

use crate::problem::{Equations, Scene};
use crate::scalar::Scalar;

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
    #[inline(always)]
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
    pub text: &'static str,
    /// In which direction the guard passes zero.
    pub direction: Direction,
    /// Unit of the guard; empty for a pure number.
    pub unit: &'static str,
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

/// Equations of a motion that is in one of several modes. All modes have the same state vector; what a mode does not
/// have stands still in it.
pub trait Modes<S: Scalar>: Equations<S> {
    /// The mode.
    fn mode(&self) -> usize;

    /// Goes into a mode.
    fn enter(&mut self, mode: usize);

    /// Puts the equations of this mode on a side of a switching surface, 1 or −1; 0 leaves it to their values.
    fn side(&mut self, surface: usize, side: S);

    /// Writes the guards of the events of this mode, behind them its kinks ([`Hybrid::KINKS`]) and its angles
    /// ([`Hybrid::TURNS`]), and the time derivatives of all.
    fn guards(
        &self,
        instant: &Self::Instant,
        state: &Self::State,
        values: &mut [S],
        rates: &mut [S],
    );

    /// The same at a time.
    fn look(&self, time: S, state: &Self::State, values: &mut [S], rates: &mut [S]) {
        self.guards(&self.instant(time), state, values, rates);
    }

    /// Whether what else an event of this mode asks for holds; asked of those that are [`EventEntry::conditional`].
    fn permits(&self, event: usize, instant: &Self::Instant, state: &Self::State) -> bool;

    /// Writes the state after an event of this mode; asked of those in whose entry [`EventEntry::sets`] holds.
    fn jump(
        &self,
        event: usize,
        instant: &Self::Instant,
        state: &Self::State,
        after: &mut Self::State,
    );
}

/// Equations whose variations pass through their events.
pub trait Sensitive<S: Scalar>: Modes<S> {
    /// Writes the derivatives of the guard of an event of this mode by the state.
    fn guard_slopes(
        &self,
        event: usize,
        instant: &Self::Instant,
        state: &Self::State,
        slopes: &mut Self::State,
    );

    /// Writes the derivatives of the state after an event of this mode by the state before it, column by column, and its
    /// total time derivative along the motion in this mode. False, and nothing is written, where the event sets nothing.
    fn jump_slopes(
        &self,
        event: usize,
        instant: &Self::Instant,
        state: &Self::State,
        columns: &mut [Self::State],
        rate: &mut Self::State,
    ) -> bool;
}

/// A scene whose motion has modes, or events.
pub trait Hybrid: Scene {
    /// The equations, prepared for a scalar type.
    type Modal<S: Scalar>: Modes<S> + Clone + Send + Sync;

    /// The events of each mode.
    const EVENTS: &'static [&'static [EventEntry]];
    /// Names of the modes; empty where there are events and no modes.
    const MODE_NAMES: &'static [&'static str];
    /// The mode in which the motion begins.
    const FIRST: usize;
    /// For each mode the speeds that are zero in it, by their places in the state vector.
    const HELD: &'static [&'static [usize]];
    /// The number of kinks of each mode: what passes zero where a guard that is not smooth goes over to another branch.
    /// Empty where there are none.
    const KINKS: &'static [usize] = &[];
    /// The number of angles of each mode of which its guards have the sine or cosine, in radians. Empty where there are
    /// none.
    const TURNS: &'static [usize] = &[];

    /// Computes what depends on the parameters alone.
    fn modal<S: Scalar>(&self) -> Self::Modal<S>;
}

/// The equations of a scene in each of its modes.
pub(crate) fn in_each_mode<C: Hybrid>(scene: &C) -> Vec<C::Modal<f64>> {
    let modes = (0..C::EVENTS.len()).map(|mode| {
        let mut equations = scene.modal::<f64>();
        equations.enter(mode);
        equations
    });
    modes.collect()
}

/// How many values the guards of a mode write: its events, its kinks, its angles.
pub(crate) fn written<C: Hybrid>(mode: usize) -> usize {
    let of = |counts: &[usize]| counts.get(mode).copied().unwrap_or(0);
    C::EVENTS[mode].len() + of(C::KINKS) + of(C::TURNS)
}
