//! Newton's method for one group: damped, with scaled rows and columns, to rounding.
//!
//! A step is shortened until the equilibrated residual falls (J. Nocedal, S. Wright: *Numerical Optimization*, 2006,
//! section 11.2). Where no part of it does, the Jacobian is near singular, and a Levenberg–Marquardt step takes over: it
//! leads to a position of least residual, which is either a solution or shows the gap that cannot be closed.

use super::scaled::Scaled;
use crate::closure::linkage::loops::{Square, Trials};
use crate::scalar::Scalar;
use crate::shape::{Group, LinkageEntry, Shape};

/// Largest number of iterations.
const ITERATIONS: usize = 100;
/// Largest turn in one iteration, in radians.
const LARGEST_TURN: f64 = 0.8;
/// Smallest part of a Newton step that is tried.
const SMALLEST_PART: f64 = 1.0 / 256.0;
/// Smallest relative decrease of the residual that counts as progress.
const PROGRESS: f64 = 1e-9;

/// What closing a group took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closed {
    /// Iterations.
    pub iterations: usize,
    /// Determinant of the Jacobian over the product of the lengths of its columns.
    pub sine: f64,
    /// Largest residual, in the unit of its equation.
    pub residual: f64,
}

/// Why the iteration stopped without closing a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// At a least residual that is not zero.
    Stalled,
    /// After the permitted number of iterations.
    Exhausted,
    /// A value is not finite.
    NotFinite,
}

/// The iteration did not close the group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Failure {
    /// Why it stopped.
    pub stop: Stop,
    /// What it had reached.
    pub reached: Closed,
}

/// The memory of the iteration, for groups of up to a size.
pub struct Newton<S: Scalar> {
    entry: &'static LinkageEntry,
    square: Square<S>,
    /// The system at the last trial.
    scaled: Scaled,
    /// Where the step begins.
    base: Vec<f64>,
}

impl<S: Scalar> Newton<S> {
    /// Room for the largest group of the linkage.
    pub fn new(shape: &'static Shape) -> Self {
        let entry = shape.loops();
        Self {
            entry,
            square: Square::of(shape),
            scaled: Scaled::new(entry.largest()),
            base: vec![0.0; entry.largest()],
        }
    }

    /// Closes a group of any kind, starting from the unknowns in `position`, which it completes.
    ///
    /// The answer is *a* solution: whether it belongs to the wanted mode is for the caller to judge.
    ///
    /// # Errors
    /// [`Failure`], with the least residual that was reached; the position is then the one that has it.
    pub fn close(
        &mut self,
        loops: &dyn Trials<S>,
        group: usize,
        instant: &[S],
        position: &mut [S],
    ) -> Result<Closed, Failure> {
        self.search(loops, group, instant, position).run()
    }

    /// Sine of the transmission angle of a closed group, from its Jacobian. Completes the position.
    pub fn sine(
        &mut self,
        loops: &dyn Trials<S>,
        group: usize,
        instant: &[S],
        position: &mut [S],
    ) -> f64 {
        let mut search = self.search(loops, group, instant, position);
        search.evaluate();
        search.newton.scaled.sine()
    }

    fn search<'a>(
        &'a mut self,
        loops: &'a dyn Trials<S>,
        group: usize,
        instant: &'a [S],
        position: &'a mut [S],
    ) -> Search<'a, S> {
        Search {
            loops,
            index: group,
            group: &self.entry.groups[group],
            instant,
            position,
            newton: self,
        }
    }

    /// Lengths of the columns of the Jacobian that was looked at last: how far the equations move per unit of each
    /// unknown.
    pub fn columns(&self) -> &[f64] {
        self.scaled.columns()
    }

    /// Units of the unknowns of the group that was looked at last: a radian, or the displacement that moves the equations
    /// as far as a radian of the longest link does.
    pub fn units(&self) -> &[f64] {
        self.scaled.units()
    }
}

/// One solution in progress.
struct Search<'a, S: Scalar> {
    loops: &'a dyn Trials<S>,
    index: usize,
    group: &'static Group,
    instant: &'a [S],
    position: &'a mut [S],
    newton: &'a mut Newton<S>,
}

impl<S: Scalar> Search<'_, S> {
    fn run(&mut self) -> Result<Closed, Failure> {
        self.evaluate();
        for iteration in 0..ITERATIONS {
            if !self.newton.scaled.is_finite() {
                return Err(self.failure(Stop::NotFinite, iteration));
            }
            self.remember();
            if let Some(length) = self.newton.scaled.newton_step() {
                // A step of this length leaves an error of its square over the sine.
                let sine = self.newton.scaled.sine().abs();
                if length * length <= 0.1 * f64::EPSILON * sine {
                    self.advance(1.0);
                    return Ok(self.closed(iteration + 1));
                }
                if self.descend(length) {
                    continue;
                }
            }
            if self.newton.scaled.is_closed() {
                return Ok(self.closed(iteration + 1));
            }
            if !self.least_squares() {
                return Err(self.failure(Stop::Stalled, iteration + 1));
            }
        }
        Err(self.failure(Stop::Exhausted, ITERATIONS))
    }

    /// Tries parts of the step until the residual falls; otherwise stays.
    fn descend(&mut self, length: f64) -> bool {
        let before = self.newton.scaled.merit();
        let mut part = f64::min(1.0, LARGEST_TURN / length);
        let smallest = SMALLEST_PART * part;
        while part >= smallest {
            self.advance(part);
            if self.newton.scaled.merit() <= (1.0 - 0.2 * part) * before {
                return true;
            }
            part *= 0.5;
        }
        self.advance(0.0);
        false
    }

    /// Takes a Levenberg–Marquardt step that lowers the residual; otherwise stays.
    fn least_squares(&mut self) -> bool {
        let before = self.newton.scaled.merit();
        for power in -8..8 {
            let Some(length) = self.newton.scaled.damped_step(10f64.powi(power)) else {
                continue;
            };
            self.advance(f64::min(1.0, LARGEST_TURN / length));
            let after = self.newton.scaled.merit();
            if after < (1.0 - PROGRESS) * before || self.newton.scaled.is_closed() {
                return true;
            }
            // The step is found from the Jacobian where the search stands.
            self.advance(0.0);
        }
        false
    }

    /// Keeps the unknowns, from which steps are taken.
    fn remember(&mut self) {
        for (base, &j) in self.newton.base.iter_mut().zip(self.group.unknowns) {
            *base = self.position[j].to_f64();
        }
    }

    /// Goes a part of the step from the kept unknowns and looks at the equations there.
    fn advance(&mut self, part: f64) {
        for (k, &j) in self.group.unknowns.iter().enumerate() {
            let value = self.newton.base[k] + part * self.newton.scaled.step()[k];
            self.position[j] = S::from_f64(value);
        }
        self.evaluate();
    }

    /// Looks at the equations where the search stands.
    fn evaluate(&mut self) {
        let newton = &mut *self.newton;
        newton.square.look(self.loops, self.index, self.instant, self.position);
        let angles = newton.entry.angles;
        let unknowns = self.group.unknowns.iter();
        newton.scaled.set(
            newton.square.residual.iter().map(|value| value.to_f64()),
            newton.square.jacobian.iter().map(|value| value.to_f64()),
            unknowns.map(|&j| (angles[j], self.position[j].to_f64())),
        );
    }

    fn closed(&mut self, iterations: usize) -> Closed {
        Closed {
            iterations,
            sine: self.newton.scaled.sine(),
            residual: self.newton.scaled.largest_residual(),
        }
    }

    fn failure(&mut self, stop: Stop, iterations: usize) -> Failure {
        Failure { stop, reached: self.closed(iterations) }
    }
}
