//! The stages of a step of equations behind a pointer, which are asked for in one call: the equations go from stage to
//! stage, and what gives the state of each is called back.

use super::combine::combine;
use super::system::System;
use super::tableau::{Method, Row};
use super::workspace::Workspace;
use crate::problem::Stages;
use crate::scalar::Scalar;
use std::marker::PhantomData;

/// The times of a sweep. No method has more stages.
const MOST: usize = 16;

/// Does something with the number of a stage where that is a constant, so that the coefficients are too.
macro_rules! with_number {
    ($number:expr, $constant:ident => $body:expr) => {
        with_number!($number, $constant, $body, 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
    ($number:expr, $constant:ident, $body:expr, $($stage:literal)*) => {
        match $number {
            $($stage => {
                const $constant: usize = $stage;
                $body
            })*
            _ => {}
        }
    };
}

/// The stages from a first one on.
struct Sweep<'a, S, Y, M: Method, V> {
    first: usize,
    step: f64,
    state: &'a V,
    stage: &'a mut V,
    trial: &'a mut V,
    slopes: &'a mut M::Slopes<V>,
    types: PhantomData<(S, Y)>,
}

/// The row of a tableau for the state of a stage.
const fn row<M: Method>(number: usize) -> Row {
    if number < M::STAGES {
        M::ROWS[number - 1]
    } else if number == M::STAGES {
        M::WEIGHTS
    } else if number - M::STAGES <= M::EXTRA_ROWS.len() {
        M::EXTRA_ROWS[number - M::STAGES - 1]
    } else {
        &[]
    }
}

/// The state of a stage, `start + step · Σ aⱼ kⱼ`, component by component: packed sums would have to wait until the last
/// slope, of which the components have just been written one by one, has got to where they can be read together. That slope
/// is what everything waits for, and is added last.
#[inline(always)]
fn advance<S: Scalar, Y: System<S>>(
    target: &mut Y::State,
    start: &Y::State,
    step: f64,
    row: Row,
    slopes: &[Y::State],
) {
    let Some((&(last, factor), rest)) = row.split_last() else {
        return;
    };
    let (factor, step) = (S::from_f64(factor * step), S::from_f64(step));
    for index in 0..Y::part(start, 0).len() {
        let mut sum = S::ZERO;
        for &(number, coefficient) in rest {
            sum = Y::part(&slopes[number], 0)[index].mul_add(S::from_f64(coefficient), sum);
        }
        let known = sum.mul_add(step, Y::part(start, 0)[index]);
        Y::part_mut(target, 0)[index] = Y::part(&slopes[last], 0)[index].mul_add(factor, known);
    }
}

impl<S: Scalar, Y: System<S>, M: Method> Stages<S> for Sweep<'_, S, Y, M, Y::State> {
    fn next(&mut self, stage: usize) -> (&[S], &mut [S]) {
        let number = self.first + stage;
        let is_end = number == M::STAGES;
        with_number!(number, NUMBER => {
            if NUMBER == M::STAGES {
                // Without it in the error estimate the new state is known.
                if M::ERROR_USES_LAST {
                    advance::<S, Y>(self.trial, self.state, self.step, row::<M>(NUMBER), self.slopes.as_ref());
                }
            } else {
                advance::<S, Y>(self.stage, self.state, self.step, row::<M>(NUMBER), self.slopes.as_ref());
            }
        });
        let state = if is_end { &*self.trial } else { &*self.stage };
        (
            Y::part(state, 0),
            Y::part_mut(&mut self.slopes.as_mut()[number], 0),
        )
    }
}

impl<V: Clone, M: Method> Workspace<V, M> {
    /// The stages that the error estimate needs, and the new state; `again` where it was no number.
    #[inline(always)]
    pub(super) fn sweep_stages<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        (time, step): (f64, f64),
        again: bool,
    ) {
        let mut times = [time + step; MOST];
        for (target, node) in times.iter_mut().zip(M::NODES) {
            *target = node * step + time;
        }
        let count = M::NODES.len() + usize::from(M::ERROR_USES_LAST);
        self.sweep::<S, Y>(system, (1, step), &times[..count], again);
        self.end_apart::<S, Y>(step);
    }

    /// The slope at the end, unless it is known, and the stages of the dense output if asked for. Gives their number.
    #[inline(always)]
    pub(super) fn sweep_rest<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        time: f64,
        step: f64,
        dense: bool,
    ) -> usize {
        let known = usize::from(M::ERROR_USES_LAST);
        let mut times = [time + step; MOST];
        for (target, node) in times[1 - known..].iter_mut().zip(M::EXTRA_NODES) {
            *target = node * step + time;
        }
        let count = 1 - known + if dense { M::EXTRA_NODES.len() } else { 0 };
        let first = M::STAGES + known;
        self.sweep::<S, Y>(system, (first, step), &times[..count], false);
        // Zero, unless one is infinite or not a number.
        let mut sum = 0.0;
        for slope in &self.slopes.as_ref()[first..first + count] {
            for one in Y::part(slope, 0) {
                sum += 0.0 * one.to_f64();
            }
        }
        if sum != 0.0 {
            self.sweep::<S, Y>(system, (first, step), &times[..count], true);
        }
        if dense {
            self.interpolate_apart::<S, Y>(step);
        }
        count
    }

    #[inline(always)]
    fn sweep<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        (first, step): (usize, f64),
        times: &[f64],
        again: bool,
    ) {
        let mut all = [S::ZERO; MOST];
        for (target, time) in all.iter_mut().zip(times) {
            *target = S::from_f64(*time);
        }
        let mut stages = Sweep::<S, Y, M, V> {
            first,
            step,
            state: &self.state,
            stage: &mut self.stage,
            trial: &mut self.trial,
            slopes: &mut self.slopes,
            types: PhantomData,
        };
        match again {
            true => system.sweep_again(&all[..times.len()], &mut stages),
            false => system.sweep(&all[..times.len()], &mut stages),
        }
    }

    /// [`Workspace::interpolate`] as a function of its own, of which the compiler packs the sums.
    #[inline(never)]
    fn interpolate_apart<S: Scalar, Y: System<S, State = V>>(&mut self, step: f64) {
        self.interpolate::<S, Y>(step);
    }

    /// The new state and the errors likewise.
    #[inline(never)]
    fn end_apart<S: Scalar, Y: System<S, State = V>>(&mut self, step: f64) {
        let slopes = self.slopes.as_ref();
        if !M::ERROR_USES_LAST {
            combine::<S, Y>(&mut self.trial, Some(&self.state), step, M::WEIGHTS, slopes);
        }
        combine::<S, Y>(&mut self.error, None, step, M::ERROR, slopes);
        if !M::SECOND_ERROR.is_empty() {
            combine::<S, Y>(&mut self.second, None, step, M::SECOND_ERROR, slopes);
        }
    }
}
