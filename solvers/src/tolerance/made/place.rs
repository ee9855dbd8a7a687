//! One place of a made linkage: closed with other dimensions, in the mode of the nominal one and near it.
//!
//! A group in closed form keeps its mode by itself. A group that is iterated starts where its derivatives by the sources
//! predict it. Newton's corrections must then shrink to a quarter at least from one to the next, the first against the
//! predicted move: the answer is then the one that belongs to the start (P. Deuflhard: *Newton methods for nonlinear
//! problems*, 2004, section 5.1), and the determinant of the Jacobian has kept its sign. What fails this test is led
//! there from the nominal linkage in smaller steps ([`super::lead`]).

use super::nominal::Nominal;
use super::small;
use super::turn::{near, unwrap};
use super::varied::Varied;
use crate::closure::{Closure, GroupKind, Linkage, Variable};
use crate::problem::Storage;
use crate::scalar::Scalar;
use crate::tolerance::made::numbers;
use crate::tolerance::source::Source;

/// Largest ratio of successive corrections.
pub(super) const CONTRACTION: f64 = 0.25;
/// Error that is left, as a part of the predicted move: far below what any number of samples resolves.
const ACCURACY: f64 = 1e-8;
/// Move that counts as none, in radians.
pub(super) const NOTHING: f64 = 1e-11;
/// Largest predicted move, in radians: a larger one may lead to the same mode some turns away.
const LONGEST: f64 = 0.5;
/// Largest number of corrections.
const ITERATIONS: usize = 6;

/// Position of a linkage.
type Position<L, S> = <<L as Linkage>::Closure<S> as Closure<S>>::Position;
/// What depends on the independent variables of a linkage alone.
type Instant<L, S> = <<L as Linkage>::Closure<S> as Closure<S>>::Instant;

/// The nominal linkage at one place, ready for samples on a type of number.
pub(super) struct Station<L: Linkage, S: Scalar> {
    independents: Vec<S>,
    motion: Vec<S>,
    /// The positions of the drivers that err.
    drivers: Vec<Varied<S>>,
    position: Position<L, S>,
    /// Of each group; there are no more groups than unknowns, so that a position holds them.
    modes: Position<L, S>,
    /// Determinants of the Jacobians count by their sign alone, that of the sine.
    signs: Position<L, S>,
    /// Reciprocals of the units of the dependent coordinates.
    scales: Position<L, S>,
    /// Derivatives of the dependent coordinates by the sources; empty if no group is iterated.
    tangents: Vec<S>,
    /// The output that is looked at.
    pub nominal: S,
}

impl<L: Linkage, S: Scalar> Station<L, S> {
    /// The nominal linkage with its position; `zeros` is one with nothing in it.
    pub fn new(
        nominal: &Nominal,
        zeros: &Position<L, S>,
        (variables, sources): (&[Variable], &[Source]),
        output: usize,
    ) -> Self {
        let all = |list: &[f64]| {
            let mut all = zeros.clone();
            all.as_mut()[..list.len()].copy_from_slice(&numbers::<S>(list));
            all
        };
        let scales: Vec<f64> = nominal.units.iter().map(|unit| 1.0 / unit).collect();
        let independents = numbers(&nominal.independents);
        Self {
            drivers: Varied::drivers(variables, sources, &independents),
            independents,
            motion: numbers(&nominal.motion),
            position: all(&nominal.position),
            modes: all(&nominal.modes),
            signs: all(&nominal.sines),
            scales: all(&scales),
            tangents: numbers(&nominal.tangents),
            nominal: S::from_f64(nominal.outputs[output]),
        }
    }

    /// Closes a sample, writes its outputs, and says whether it has certainly kept its modes.
    #[inline(always)]
    pub fn close(
        &self,
        closure: &L::Closure<S>,
        errors: &[S],
        independents: &mut [S],
        outputs: &mut [S],
    ) -> S::Mask {
        independents.copy_from_slice(&self.independents[..closure.shape().drivers.len()]);
        for driver in &self.drivers {
            independents[driver.index] = driver.made(errors);
        }
        let instant = match self.motion.is_empty() {
            true => closure.instant(independents),
            false => closure.moving(independents, &self.motion),
        };
        if !closure.shape().loops().is_iterated() {
            return self.close_at_once(closure, &instant, outputs);
        }
        let mut position = self.position.clone();
        let is_closed = self.close_all(closure, &instant, errors, &mut position);
        if S::any(is_closed) {
            S::outline(
                #[inline(always)]
                || closure.outputs(&instant, &position, outputs),
            );
        }
        is_closed
    }

    /// The same where all groups keep their modes by themselves: in one piece, so that the compiler leaves out what no
    /// output needs.
    #[inline(always)]
    fn close_at_once(
        &self,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        outputs: &mut [S],
    ) -> S::Mask {
        let entry = closure.shape().loops();
        let groups = entry.groups.len();
        let (mut position, mut sines) = (closure.zeros(), closure.zeros());
        let (modes, sines) = (&self.modes.as_ref()[..groups], &mut sines.as_mut()[..groups]);
        closure.close_all(instant, modes, &mut position, sines, false);
        let mut closed = S::equal(S::ZERO, S::ZERO);
        for (index, group) in entry.groups.iter().enumerate() {
            closed = S::and(closed, S::equal(sines[index], sines[index]));
            if group.kind.has_modes() {
                near(entry, index, position.as_mut(), self.position.as_ref());
            }
        }
        closure.outputs(instant, &position, outputs);
        closed
    }

    /// Closes all groups and says whether they have certainly kept their modes.
    #[inline(always)]
    fn close_all(
        &self,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        errors: &[S],
        position: &mut Position<L, S>,
    ) -> S::Mask {
        let groups = closure.shape().loops().groups.len();
        let mut closed = S::equal(S::ZERO, S::ZERO);
        for index in 0..groups {
            closed = S::and(closed, self.close_one(index, closure, instant, errors, position));
            if !S::any(closed) {
                break;
            }
        }
        closed
    }

    #[inline(always)]
    fn close_one(
        &self,
        index: usize,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        errors: &[S],
        position: &mut Position<L, S>,
    ) -> S::Mask {
        let entry = closure.shape().loops();
        let kind = entry.groups[index].kind;
        if let GroupKind::General = kind {
            return self.iterate(index, closure, instant, errors, position);
        }
        let mode = self.modes.as_ref()[index];
        let sine = S::outline(
            #[inline(always)]
            || closure.close(index, instant, mode, position),
        );
        if kind.has_modes() {
            unwrap(entry, index, position.as_mut(), self.position.as_ref());
        }
        S::equal(sine, sine)
    }

    /// Closes a group by Newton's method from where it is predicted. Samples side by side go together until the last has
    /// come to its end; those that have are left as they are.
    #[inline(always)]
    fn iterate(
        &self,
        index: usize,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        errors: &[S],
        position: &mut Position<L, S>,
    ) -> S::Mask {
        let entry = closure.shape().loops();
        let unknowns = entry.groups[index].unknowns;
        let (n, largest) = (unknowns.len(), entry.largest());
        let mut before = S::ZERO;
        let scales = self.scales.as_ref();
        for &j in unknowns {
            let slopes = &self.tangents[j * errors.len()..][..errors.len()];
            let moved = slopes
                .iter()
                .zip(errors)
                .fold(S::ZERO, |sum, (slope, error)| slope.mul_add(*error, sum));
            position.as_mut()[j] = self.position.as_ref()[j] + moved;
            before = larger(before, (moved * scales[j]).abs());
        }
        let (nothing, contraction) = (S::from_f64(NOTHING), S::from_f64(CONTRACTION));
        let enough = S::from_f64(ACCURACY) * before + nothing;
        let mut going = S::less_equal(before, S::from_f64(LONGEST));
        let mut closed = S::less(S::ZERO, S::ZERO);
        let mut residual = <L::Closure<S> as Closure<S>>::Row::zeros(largest);
        let mut jacobian = <L::Closure<S> as Closure<S>>::Matrix::zeros(largest.pow(2));
        let trial = |position: &mut _, residual: &mut _, jacobian: &mut _| {
            S::outline(
                #[inline(always)]
                || closure.trial(index, instant, position, residual, jacobian),
            );
        };
        for _ in 0..ITERATIONS {
            if !S::any(going) {
                break;
            }
            trial(position, &mut residual, &mut jacobian);
            let determinant = small::solve(n, jacobian.as_mut(), residual.as_mut());
            let mut length = S::ZERO;
            for (k, &j) in unknowns.iter().enumerate() {
                let (step, here) = (residual.as_ref()[k], position.as_ref()[j]);
                position.as_mut()[j] = S::select(going, here - step, here);
                length = larger(length, (step * scales[j]).abs());
            }
            let certain = S::and(
                S::less_equal(length, contraction.mul_add(before, nothing)),
                S::less(S::ZERO, determinant * self.signs.as_ref()[index]),
            );
            going = S::and(going, certain);
            // The next correction would be the square of this one over its own square root before.
            let left = length * length * length;
            let done = S::or(
                S::less_equal(left, enough * (before * before)),
                S::less_equal(length, nothing),
            );
            closed = S::or(closed, S::and(going, done));
            going = S::and(going, S::not(done));
            before = length;
        }
        if S::any(closed) {
            // Completes what is kept beside the unknowns.
            trial(position, &mut residual, &mut jacobian);
        }
        closed
    }
}

#[inline(always)]
fn larger<S: Scalar>(a: S, b: S) -> S {
    S::select(S::less(a, b), b, a)
}
