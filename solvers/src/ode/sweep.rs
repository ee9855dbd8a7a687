//! The stages of a step of equations behind a pointer, which are asked for in one call: the equations go from stage to
//! stage, and what gives the state of each is called back.

use super::combine::combine;
use super::system::System;
use super::tableau::Method;
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
    /// How many there are.
    count: usize,
    types: PhantomData<(S, Y)>,
}

/// The row of a tableau for the state of a stage.
const fn row<M: Method>(number: usize) -> super::tableau::Row {
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

impl<S: Scalar, Y: System<S>, M: Method> Stages<S> for Sweep<'_, S, Y, M, Y::State> {
    fn next(&mut self, stage: usize) -> (&[S], &mut [S]) {
        let number = self.first + stage;
        let is_end = number == M::STAGES;
        with_number!(number, NUMBER => {
            if NUMBER == M::STAGES {
                // Without it in the error estimate the new state is known.
                if M::ERROR_USES_LAST {
                    combine::<S, Y>(self.trial, Some(self.state), self.step, row::<M>(NUMBER), self.slopes.as_ref());
                }
            } else {
                combine::<S, Y>(self.stage, Some(self.state), self.step, row::<M>(NUMBER), self.slopes.as_ref());
            }
        });
        let state = if is_end { &*self.trial } else { &*self.stage };
        (
            Y::part(state, 0),
            Y::part_mut(&mut self.slopes.as_mut()[number], 0),
        )
    }

    fn are_finite(&self) -> bool {
        let slopes = &self.slopes.as_ref()[self.first..self.first + self.count];
        // Zero, unless one is infinite or not a number.
        let mut sum = 0.0;
        for slope in slopes {
            for one in Y::part(slope, 0) {
                sum += 0.0 * one.to_f64();
            }
        }
        sum == 0.0
    }
}

impl<V: Clone, M: Method> Workspace<V, M> {
    /// The stages that the error estimate needs, and the new state.
    #[inline(always)]
    pub(super) fn sweep_stages<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        time: f64,
        step: f64,
    ) {
        let mut times = [time + step; MOST];
        for (target, node) in times.iter_mut().zip(M::NODES) {
            *target = node * step + time;
        }
        let count = M::NODES.len() + usize::from(M::ERROR_USES_LAST);
        self.sweep::<S, Y>(system, (1, step), &times[..count]);
        if !M::ERROR_USES_LAST {
            let slopes = self.slopes.as_ref();
            combine::<S, Y>(&mut self.trial, Some(&self.state), step, M::WEIGHTS, slopes);
        }
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
        self.sweep::<S, Y>(system, (M::STAGES + known, step), &times[..count]);
        count
    }

    #[inline(always)]
    fn sweep<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        (first, step): (usize, f64),
        times: &[f64],
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
            count: times.len(),
            types: PhantomData,
        };
        system.sweep(&all[..times.len()], &mut stages);
    }
}
