//! Loops behind a pointer, in layers by what is asked of them: what is compiled once for all linkages closes these.

use super::problem::Closure;
use crate::problem::Storage;
use crate::scalar::Scalar;
use crate::shape::Shape;

/// Loops whose residuals are looked at. Slices have the lengths that [`Closure`] states.
pub trait Trials<S: Scalar>: Send + Sync {
    /// What the linkage is made of.
    fn shape(&self) -> &'static Shape;

    /// Lengths of a position and of what depends on the independent variables alone.
    fn lengths(&self) -> (usize, usize);

    /// See [`Closure::instant`] and [`Closure::moving`]; no motion where it is not known.
    fn instant(&self, independents: &[S], motion: &[S], instant: &mut [S]);

    /// The same as a row of its own: what depends on the independent variables alone, and on how they move where that is known.
    fn instant_row(&self, independents: &[S], motion: &[S]) -> Vec<S>;

    /// See [`Closure::trial`].
    fn trial(
        &self,
        group: usize,
        instant: &[S],
        position: &mut [S],
        residual: &mut [S],
        jacobian: &mut [S],
    );
}

/// Loops of which is asked besides what a closed position says.
pub trait Answers<S: Scalar>: Trials<S> {
    /// See [`Closure::outputs`].
    fn outputs(&self, instant: &[S], position: &[S], values: &mut [S]);

    /// See [`Closure::influence`].
    fn influence(&self, instant: &[S], position: &[S], values: &mut [S]);

    /// See [`Closure::measured`].
    fn measured(&self, instant: &[S], position: &[S], values: &mut [S]);

    /// See [`Closure::measures`].
    fn measures(&self, found: &[S], values: &mut [S]);
}

/// Loops that are closed.
pub trait Loops<S: Scalar>: Answers<S> {
    /// See [`Closure::close`].
    fn close(&self, group: usize, instant: &[S], mode: S, position: &mut [S]) -> S;

    /// See [`Closure::margin`].
    fn margin(&self, group: usize, instant: &[S], position: &[S]) -> S;

    /// See [`Closure::residual`].
    fn residual(&self, instant: &[S], position: &[S], residual: &mut [S]);

    /// See [`Closure::coefficients`]; the columns of the drivers, one behind the other, each of all dependent coordinates.
    fn coefficients(&self, instant: &[S], position: &[S], columns: &mut [S]);

    /// See [`Closure::second_influence`].
    fn second_influence(&self, instant: &[S], position: &[S], values: &mut [S]);

    /// See [`Closure::points`].
    fn points(&self, instant: &[S], position: &[S], values: &mut [S]);
}

/// Residuals and Jacobian of a group.
pub struct Square<S> {
    /// The residuals.
    pub residual: Vec<S>,
    /// Their derivatives, row by row.
    pub jacobian: Vec<S>,
}

impl<S: Scalar> Square<S> {
    /// Room for the largest group of a linkage.
    pub fn of(shape: &Shape) -> Self {
        let size = shape.loops().largest();
        Self { residual: vec![S::ZERO; size], jacobian: vec![S::ZERO; size * size] }
    }

    /// Looks at a group, see [`Closure::trial`].
    pub fn look<T: Trials<S> + ?Sized>(
        &mut self,
        loops: &T,
        group: usize,
        instant: &[S],
        position: &mut [S],
    ) {
        let (residual, jacobian) = (&mut self.residual, &mut self.jacobian);
        loops.trial(group, instant, position, residual, jacobian);
    }
}

/// The loops of one linkage, each method a function of its own, compiled for the instructions of the numbers.
pub struct Apart<C>(pub C);

/// A row of a caller in the storage of the loops.
#[inline(always)]
fn stored<S: Scalar, T: Storage<S>>(row: &[S]) -> T {
    let mut stored = T::zeros(row.len());
    stored.as_mut().copy_from_slice(row);
    stored
}

impl<C> Apart<C> {
    fn made<S: Scalar>(&self, independents: &[S], motion: &[S]) -> C::Instant
    where
        C: Closure<S>,
    {
        S::outline(
            #[inline(always)]
            || match motion.is_empty() {
                true => self.0.instant(independents),
                false => self.0.moving(independents, motion),
            },
        )
    }
}

impl<S: Scalar, C: Closure<S>> Trials<S> for Apart<C> {
    fn shape(&self) -> &'static Shape {
        self.0.shape()
    }

    fn lengths(&self) -> (usize, usize) {
        let unknown = vec![S::from_f64(f64::NAN); self.0.shape().drivers.len()];
        (self.0.zeros().as_ref().len(), self.made(&unknown, &[]).as_ref().len())
    }

    fn instant(&self, independents: &[S], motion: &[S], instant: &mut [S]) {
        instant.copy_from_slice(self.made(independents, motion).as_ref());
    }

    fn instant_row(&self, independents: &[S], motion: &[S]) -> Vec<S> {
        self.made(independents, motion).as_ref().to_vec()
    }

    fn trial(
        &self,
        group: usize,
        instant: &[S],
        position: &mut [S],
        residual: &mut [S],
        jacobian: &mut [S],
    ) {
        let instant: C::Instant = stored(instant);
        let mut own: C::Position = stored(position);
        let (mut row, mut square): (C::Row, C::Matrix) = (stored(residual), stored(jacobian));
        S::outline(
            #[inline(always)]
            || self.0.trial(group, &instant, &mut own, &mut row, &mut square),
        );
        position.copy_from_slice(own.as_ref());
        residual.copy_from_slice(row.as_ref());
        jacobian.copy_from_slice(square.as_ref());
    }
}

/// Implements methods that write values at a closed position.
macro_rules! written {
    ($($method:ident)*) => {$(
        fn $method(&self, instant: &[S], position: &[S], values: &mut [S]) {
            let (instant, position): (C::Instant, C::Position) = (stored(instant), stored(position));
            S::outline(
                #[inline(always)]
                || self.0.$method(&instant, &position, values),
            );
        }
    )*};
}

impl<S: Scalar, C: Closure<S>> Answers<S> for Apart<C> {
    written!(outputs influence measured);

    fn measures(&self, found: &[S], values: &mut [S]) {
        S::outline(
            #[inline(always)]
            || self.0.measures(found, values),
        );
    }
}

impl<S: Scalar, C: Closure<S>> Loops<S> for Apart<C> {
    written!(residual second_influence points);

    fn close(&self, group: usize, instant: &[S], mode: S, position: &mut [S]) -> S {
        let instant: C::Instant = stored(instant);
        let mut own: C::Position = stored(position);
        let sine = S::outline(
            #[inline(always)]
            || self.0.close(group, &instant, mode, &mut own),
        );
        position.copy_from_slice(own.as_ref());
        sine
    }

    fn margin(&self, group: usize, instant: &[S], position: &[S]) -> S {
        let (instant, position): (C::Instant, C::Position) = (stored(instant), stored(position));
        S::outline(
            #[inline(always)]
            || self.0.margin(group, &instant, &position),
        )
    }

    fn coefficients(&self, instant: &[S], position: &[S], columns: &mut [S]) {
        let (instant, position): (C::Instant, C::Position) = (stored(instant), stored(position));
        let shape = self.0.shape();
        let mut own = vec![self.0.zeros(); shape.drivers.len()];
        S::outline(
            #[inline(always)]
            || self.0.coefficients(&instant, &position, &mut own),
        );
        let dependents = shape.loops().dependents.len();
        for (column, own) in columns.chunks_exact_mut(dependents.max(1)).zip(own) {
            column.copy_from_slice(&own.as_ref()[..dependents]);
        }
    }
}
