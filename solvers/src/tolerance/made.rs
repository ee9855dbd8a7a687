//! Made linkages: closed with other dimensions, in the mode of the nominal one and near it.
//!
//! A group in closed form keeps its mode by itself. A group that is iterated starts where its derivatives by the sources
//! predict it. Newton's corrections must then shrink to a quarter at least from one to the next, the first against the
//! predicted move: the answer is then the one that belongs to the start (P. Deuflhard: *Newton methods for nonlinear
//! problems*, 2004, section 5.1), and the determinant of the Jacobian has kept its sign. What fails this test is led
//! there from the nominal linkage in smaller steps ([`super::lead`]).

use super::nominal::Nominal;
use super::small;
use super::source::Source;
use crate::closure::{Closure, GroupKind, Linkage, Variable};
use crate::problem::Storage;
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// Largest ratio of successive corrections.
pub(super) const CONTRACTION: f64 = 0.25;
/// Error that is left, as a part of the predicted move: far below what any number of samples resolves.
const ACCURACY: f64 = 1e-8;
/// Move that counts as none, in radians.
pub(super) const NOTHING: f64 = 1e-11;
/// Largest number of corrections.
const ITERATIONS: usize = 6;

/// Position of a linkage.
pub(super) type Position<L, S> = <<L as Linkage>::Closure<S> as Closure<S>>::Position;
/// What depends on the independent variables of a linkage alone.
pub(super) type Instant<L, S> = <<L as Linkage>::Closure<S> as Closure<S>>::Instant;

/// The nominal linkage at one place, ready for numbers of a type.
pub(super) struct Place<L: Linkage, S: Scalar> {
    independents: Vec<S>,
    motion: Vec<S>,
    position: Position<L, S>,
    modes: Vec<S>,
    /// Determinants of the Jacobians count by their sign alone, that of the sine.
    signs: Vec<S>,
    /// Reciprocals of the units of the dependent coordinates.
    scales: Vec<S>,
    tangents: Vec<S>,
    /// The output that is looked at.
    nominal: S,
}

/// Makes linkages; keeps the memory for it.
pub(super) struct Maker<L: Linkage, S: Scalar> {
    nominal: Vec<S>,
    values: Vec<S>,
    variables: Vec<Variable>,
    output: usize,
    outputs: Vec<S>,
    independents: Vec<S>,
    pub places: Vec<Place<L, S>>,
}

impl<L: Linkage, S: Scalar> Maker<L, S> {
    pub fn new(nominals: &[Nominal], sources: &[Source], output: usize) -> Self {
        let number =
            |list: &[f64]| -> Vec<S> { list.iter().map(|one| S::from_f64(*one)).collect() };
        let values = nominals.first().map_or(&[][..], |one| &one.values);
        let closure = L::prepare::<S>(&number(values));
        let place = |one: &Nominal| {
            let mut position = closure.zeros();
            position.as_mut().copy_from_slice(&number(&one.position));
            let scales: Vec<f64> = one.units.iter().map(|unit| 1.0 / unit).collect();
            Place {
                independents: number(&one.independents),
                motion: number(&one.motion),
                position,
                modes: number(&one.modes),
                signs: number(&one.sines),
                scales: number(&scales),
                tangents: number(&one.tangents),
                nominal: S::from_f64(one.outputs[output]),
            }
        };
        Self {
            nominal: number(values),
            values: number(values),
            variables: sources
                .iter()
                .map(|source| L::VARIABLES[source.variable])
                .collect(),
            output,
            outputs: vec![S::ZERO; L::OUTPUTS],
            independents: vec![S::ZERO; L::INDEPENDENTS],
            places: nominals.iter().map(place).collect(),
        }
    }

    /// Computes what depends on the dimensions alone, for the errors of the sources.
    #[inline(always)]
    pub fn prepare(&mut self, errors: &[S]) -> L::Closure<S> {
        self.values.copy_from_slice(&self.nominal);
        for (variable, error) in self.variables.iter().zip(errors) {
            if let Variable::Constant(index) = *variable {
                self.values[index] = self.values[index] + *error;
            }
        }
        L::prepare(&self.values)
    }

    /// Closes the made linkage at a place and gives the error of its output; no number if the mode is not certain, or
    /// does not exist.
    #[inline(always)]
    pub fn error(&mut self, closure: &L::Closure<S>, place: usize, errors: &[S]) -> S {
        let place = &self.places[place];
        self.independents.copy_from_slice(&place.independents);
        for (variable, error) in self.variables.iter().zip(errors) {
            if let Variable::Driver(index) = *variable {
                self.independents[index] = self.independents[index] + *error;
            }
        }
        let instant = match place.motion.is_empty() {
            true => closure.instant(&self.independents),
            false => closure.moving(&self.independents, &place.motion),
        };
        let mut position = place.position.clone();
        if !place.close(closure, &instant, errors, &mut position) {
            return S::from_f64(f64::NAN);
        }
        closure.outputs(&instant, &position, &mut self.outputs);
        self.outputs[self.output] - place.nominal
    }
}

impl<L: Linkage, S: Scalar> Place<L, S> {
    /// Closes all groups and says whether they have certainly kept their modes.
    #[inline(always)]
    fn close(
        &self,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        errors: &[S],
        position: &mut Position<L, S>,
    ) -> bool {
        /// Written out for the first groups, so that what is known of each is known to the compiler.
        macro_rules! written_out {
            ($($index:literal)*) => {{
                $(if L::GROUPS.len() > $index
                    && !self.close_one($index, closure, instant, errors, position) {
                    return false;
                })*
            }};
        }
        written_out!(0 1 2 3 4 5);
        for index in 6..L::GROUPS.len() {
            if !self.close_one(index, closure, instant, errors, position) {
                return false;
            }
        }
        true
    }

    #[inline(always)]
    fn close_one(
        &self,
        index: usize,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        errors: &[S],
        position: &mut Position<L, S>,
    ) -> bool {
        if let GroupKind::General = L::GROUPS[index].kind {
            return self.iterate(index, closure, instant, errors, position);
        }
        let sine = closure.close(index, instant, self.modes[index], position);
        if L::GROUPS[index].kind.has_modes() {
            unwrap::<L, S>(index, position, self.position.as_ref());
        }
        S::holds(S::equal(sine, sine))
    }

    /// Closes a group by Newton's method from where it is predicted.
    #[inline(always)]
    fn iterate(
        &self,
        index: usize,
        closure: &L::Closure<S>,
        instant: &Instant<L, S>,
        errors: &[S],
        position: &mut Position<L, S>,
    ) -> bool {
        let unknowns = L::GROUPS[index].unknowns;
        let n = unknowns.len();
        let mut before = S::ZERO;
        for &j in unknowns {
            let mut moved = S::ZERO;
            for (k, error) in errors.iter().enumerate() {
                moved = self.tangents[j * errors.len() + k].mul_add(*error, moved);
            }
            position.as_mut()[j] = self.position.as_ref()[j] + moved;
            before = larger(before, (moved * self.scales[j]).abs());
        }
        let (nothing, contraction) = (S::from_f64(NOTHING), S::from_f64(CONTRACTION));
        let enough = S::from_f64(ACCURACY) * before + nothing;
        let mut residual = <L::Closure<S> as Closure<S>>::Row::zeros(largest::<L>());
        let mut jacobian = <L::Closure<S> as Closure<S>>::Matrix::zeros(largest::<L>().pow(2));
        for _ in 0..ITERATIONS {
            closure.trial(index, instant, position, &mut residual, &mut jacobian);
            let determinant = small::solve(n, jacobian.as_mut(), residual.as_mut());
            let mut length = S::ZERO;
            for (k, &j) in unknowns.iter().enumerate() {
                let step = residual.as_ref()[k];
                position.as_mut()[j] = position.as_ref()[j] - step;
                length = larger(length, (step * self.scales[j]).abs());
            }
            let certain = S::and(
                S::less_equal(length, contraction.mul_add(before, nothing)),
                S::less(S::ZERO, determinant * self.signs[index]),
            );
            if !S::holds(certain) {
                return false;
            }
            // The next correction would be the square of this one over its own square root before.
            let left = length * length * length;
            if S::holds(S::less_equal(left, enough * (before * before)))
                || S::holds(S::less_equal(length, nothing))
            {
                // Completes what is kept beside the unknowns.
                closure.trial(index, instant, position, &mut residual, &mut jacobian);
                return true;
            }
            before = length;
        }
        false
    }
}

/// Puts the angles of a group within half a turn of others.
#[inline(always)]
pub(super) fn unwrap<L: Linkage, S: Scalar>(
    group: usize,
    position: &mut Position<L, S>,
    near: &[S],
) {
    let (turn, half) = (S::from_f64(TAU), S::from_f64(0.5));
    for &j in L::GROUPS[group].unknowns {
        if L::ANGLES[j] {
            let angle = position.as_ref()[j];
            let turns = ((near[j] - angle) / turn + half).floor();
            position.as_mut()[j] = turns.mul_add(turn, angle);
        }
    }
}

/// Size of the largest group.
#[inline(always)]
pub(super) fn largest<L: Linkage>() -> usize {
    let mut most = 0;
    for group in L::GROUPS {
        most = most.max(group.unknowns.len());
    }
    most
}

#[inline(always)]
fn larger<S: Scalar>(a: S, b: S) -> S {
    S::select(S::less(a, b), b, a)
}
