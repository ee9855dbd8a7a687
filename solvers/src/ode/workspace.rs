//! The memory of an integration, and how it begins.

use super::combine::combine;
use super::error::OdeError;
use super::norm::{first_bad, scaled_size};
use super::options::Options;
use super::step::Room;
use super::system::System;
use super::tableau::{Explicit, Tableau};

/// Roundings of the time that a first step has at least.
pub(crate) const SHORTEST: f64 = 1e3;

/// The memory of an integration. Nothing but it is allocated.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// The method.
    pub(super) method: Explicit,
    /// The memory of a step.
    pub(super) room: Room,
}

impl Workspace {
    /// Room for the states of a system.
    pub fn new<Y: System + ?Sized>(method: Explicit, system: &Y) -> Self {
        Self { method, room: Room::new(method.tableau(), system.length()) }
    }

    /// The state where the last integration ended.
    pub fn state(&self) -> &[f64] {
        &self.room.state
    }

    /// The memory of a step.
    #[cfg(test)]
    pub(crate) fn room_mut(&mut self) -> &mut Room {
        &mut self.room
    }

    /// The coefficients of the method.
    #[inline]
    pub(super) fn tableau(&self) -> &'static Tableau {
        self.method.tableau()
    }

    /// One of the slopes.
    #[inline]
    pub(super) fn slope(&self, number: usize) -> &[f64] {
        let length = self.room.state.len();
        &self.room.slopes[number * length..][..length]
    }

    /// The slope at the start, and the length of a first step unless one is given (Hairer, Nørsett, Wanner, II.4,
    /// "Starting step size").
    pub(super) fn begin<Y: System + ?Sized>(
        &mut self,
        system: &Y,
        (from, to): (f64, f64),
        options: &Options,
    ) -> Result<f64, OdeError> {
        let limit = (to - from).abs().min(options.max_step.unwrap_or(f64::INFINITY));
        let direction = (to - from).signum();
        let (order, length) = (self.tableau().order, self.room.state.len());
        let Room { state, stage, error, slopes, .. } = &mut self.room;
        let (first, second) = slopes.split_at_mut(length);
        system.rates(from, state, first);
        if let Some(component) = first_bad(first, system.part()) {
            return Err(OdeError::NotFinite { time: from, component });
        }
        if let Some(step) = options.first_step.or(options.fixed_step) {
            return Ok(direction * step.min(limit));
        }
        let here = |values: &[f64]| scaled_size(system, options, (state, state), values, None);
        let (size, rate) = (here(state), here(first));
        let probe: f64 = if size < 1e-5 || rate < 1e-5 { 1e-6 } else { 0.01 * size / rate };
        // A state that is next to nothing asks for a step that the time does not feel.
        let probe = probe.max(SHORTEST * f64::EPSILON * from.abs().max(to.abs()));
        let probe = direction * limit.min(probe);
        combine(stage, Some(state), probe, &[(0, 1.0)], first);
        system.rates(from + probe, stage, &mut second[..length]);
        combine(error, None, 1.0 / probe, &[(0, -1.0), (1, 1.0)], slopes);
        let change = scaled_size(system, options, (state, state), error, None);
        let steepest = rate.max(change);
        let step = if steepest <= 1e-15 {
            (1e-3 * probe.abs()).max(1e-6)
        } else {
            (0.01 / steepest).powf(1.0 / order as f64)
        };
        let step = step.min(100.0 * probe.abs()).min(limit);
        Ok(direction * if step.is_finite() { step } else { limit.min(1e-6) })
    }

    /// The error of the attempt in tolerances.
    #[inline]
    pub(super) fn estimate<Y: System + ?Sized>(&self, system: &Y, options: &Options) -> f64 {
        let room = &self.room;
        let second = match self.tableau().second_error {
            [] => None,
            _ => Some(&room.second[..]),
        };
        scaled_size(system, options, (&room.state, &room.trial), &room.error, second)
    }

    /// Keeps the state of the last inner stage, which the stages of the dense output would overwrite.
    #[inline]
    pub(super) fn keep_last_stage(&mut self) {
        std::mem::swap(&mut self.room.stage, &mut self.room.second);
    }

    /// `|λ|` of the fastest change that the equations show in a step that is finished: the rates of its end and of the last
    /// inner stage, which lies at its end too, over what these two states differ by (Hairer, Wanner II, section IV.2,
    /// (2.25)). Needs [`Workspace::keep_last_stage`].
    pub(super) fn fastest_rate<Y: System + ?Sized>(
        &mut self,
        system: &Y,
        options: &Options,
    ) -> f64 {
        let (stages, length) = (self.tableau().stages, self.room.state.len());
        let Room { state, trial, error, second, slopes, .. } = &mut self.room;
        for index in 0..length {
            error[index] = slopes[stages * length + index] - slopes[(stages - 1) * length + index];
            second[index] = trial[index] - second[index];
        }
        let change = scaled_size(system, options, (state, trial), second, None);
        match change > 0.0 {
            true => scaled_size(system, options, (state, trial), error, None) / change,
            false => 0.0,
        }
    }
}

/// Nanoseconds of one evaluation of the rates in a step from time 0 on, measured over about so many.
pub(crate) fn time_evaluation<Y: System + ?Sized>(system: &Y, start: &[f64], calls: usize) -> f64 {
    let mut workspace = Workspace::new(Explicit::Dop853, system);
    let evaluations = workspace.tableau().tried();
    let steps = calls.div_ceil(evaluations).max(1);
    let room = &mut workspace.room;
    room.step = 1e-5;
    room.state.copy_from_slice(start);
    let clock = std::time::Instant::now();
    for step in 0..steps {
        room.time = std::hint::black_box(step as f64 * 1e-5);
        system.attempt(Explicit::Dop853, room);
        std::hint::black_box(&room.trial);
    }
    clock.elapsed().as_secs_f64() * 1e9 / (steps * evaluations) as f64
}
