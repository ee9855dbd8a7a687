//! The choice between an explicit and a stiff method while the motion goes on.
//!
//! The motion begins with the explicit method of order 8. Each of its steps measures `h|λ|`, the step in terms of the
//! fastest change that the equations know, from the last two stages, which both lie at its end (Hairer, Wanner II,
//! section IV.2, (2.25) and program DOP853). Where only accuracy counts it stays below 3; where stability keeps the steps
//! short it hovers at the border of stability, about 6 in every direction of the left half plane. When that persists and
//! the Jacobian agrees, Radau takes over. It hands back once its own steps have long been such that the explicit method
//! could take them, by the spectral radius of the Jacobian.

use super::here::Here;
use super::radau::Radau;
use super::rates::{Erased, Rates};
use super::spectrum::Calm;
use super::stepper::drive;
use crate::ode::{self, Dop853, Observer, OdeError, Options, Statistics, Step};
use std::cell::RefCell;

/// `h|λ|` of a step that stability holds back.
const STIFF: f64 = 5.0;
/// So many such steps, not interrupted by [`CALM`] others, are stiffness (program DOP853).
const STEPS: usize = 15;
const CALM: usize = 6;

/// Where the method changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// When, in seconds.
    pub time: f64,
    /// Whether it was to the stiff method; otherwise it was back to the explicit one.
    pub stiff: bool,
}

/// The memory of both methods.
pub(super) struct Automatic {
    explicit: ode::Workspace<Vec<f64>, Dop853>,
    radau: Radau,
    calm: Calm,
    /// Which one it is now. Kept from one integration to the next: events do not change how stiff a mechanism is.
    is_stiff: bool,
    /// The changes of the last integration.
    pub switches: Vec<Switch>,
}

impl Automatic {
    /// Coefficients of the continuous solution: those of the explicit method, of which a Radau step leaves the last zero.
    pub const DEGREE: usize = 7;

    /// Room for the states of a system.
    pub fn new(rates: &mut dyn Rates) -> Self {
        let states = rates.states();
        Self {
            explicit: ode::Workspace::new(&Erased(RefCell::new(rates))),
            radau: Radau::new(states),
            calm: Calm::new(states),
            is_stiff: false,
            switches: Vec::new(),
        }
    }

    /// Integrates from [`Here::state`]. What it took is in [`Here::statistics`], failed or not.
    pub fn integrate(
        &mut self,
        rates: &mut dyn Rates,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        observe: &mut dyn Observer<Vec<f64>>,
    ) -> Result<(), OdeError> {
        self.switches.clear();
        let mut total = Statistics::default();
        let mut options = options.clone();
        let allowed = options.max_steps;
        here.time = times.0;
        let done = loop {
            let mut gauge = Gauge::new(observe, here.time);
            let stretch = (here.time, times.1);
            let done = match self.is_stiff {
                true => self.stiffly(rates, here, stretch, &options, &mut gauge),
                false => self.explicitly(rates, here, stretch, &options, &mut gauge),
            };
            let (time, step, has_enough) = (gauge.time, gauge.step, gauge.inner.has_enough());
            let suspects = gauge.suspects();
            total.add(&here.statistics);
            here.time = time;
            if done.is_err() || has_enough || time == times.1 {
                break done;
            }
            options.max_steps = allowed.saturating_sub(total.steps + total.rejected);
            options.first_step = Some(step.abs());
            // Where the explicit method suspects stiffness, the Jacobian decides.
            if suspects {
                if let Err(error) = here.differentiate(rates) {
                    break Err(error);
                }
                total.jacobians += 1;
                let radius = self.calm.spectral_radius(&here.jacobian, here.state.len());
                if step.abs() * radius < STIFF {
                    continue;
                }
            }
            self.is_stiff = !self.is_stiff;
            let stiff = self.is_stiff;
            self.switches.push(Switch { time, stiff });
        };
        here.statistics = total;
        done
    }

    /// Goes on with the explicit method.
    fn explicitly(
        &mut self,
        rates: &mut dyn Rates,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        gauge: &mut Gauge<'_>,
    ) -> Result<(), OdeError> {
        gauge.is_explicit = true;
        let system = Erased(RefCell::new(rates));
        here.statistics = Statistics::default();
        let done = ode::integrate(
            &system,
            times,
            &here.state,
            options,
            &mut self.explicit,
            gauge,
        );
        here.state.copy_from_slice(self.explicit.state());
        here.statistics = done?;
        Ok(())
    }

    /// Goes on with the stiff one.
    fn stiffly(
        &mut self,
        rates: &mut dyn Rates,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        gauge: &mut Gauge<'_>,
    ) -> Result<(), OdeError> {
        // The rows of higher degree stay zero.
        here.polynomial.iter_mut().for_each(|row| row.fill(0.0));
        self.calm.restart();
        let calm = Some(&mut self.calm);
        drive(&mut self.radau, rates, here, times, options, gauge, calm)
    }
}

/// An observer that measures the stiffness on the way.
struct Gauge<'a> {
    inner: &'a mut dyn Observer<Vec<f64>>,
    is_explicit: bool,
    /// End and length of the last step.
    time: f64,
    step: f64,
    /// Steps that stability holds back, and others since the last of them.
    stiff: usize,
    calm: usize,
}

impl<'a> Gauge<'a> {
    fn new(inner: &'a mut dyn Observer<Vec<f64>>, time: f64) -> Self {
        Self {
            inner,
            is_explicit: false,
            time,
            step: 0.0,
            stiff: 0,
            calm: 0,
        }
    }

    /// Whether the motion looks stiff.
    fn suspects(&self) -> bool {
        self.stiff >= STEPS
    }
}

impl Observer<Vec<f64>> for Gauge<'_> {
    fn wants_dense(&mut self, from: f64, to: f64) -> bool {
        self.inner.wants_dense(from, to)
    }

    fn wants_stiffness(&self) -> bool {
        self.is_explicit
    }

    fn stiffness(&mut self, product: f64) {
        if product > STIFF {
            (self.stiff, self.calm) = (self.stiff + 1, 0);
            return;
        }
        self.calm += 1;
        if self.calm >= CALM {
            self.stiff = 0;
        }
    }

    fn step(&mut self, step: &Step<'_, Vec<f64>>) {
        (self.time, self.step) = (step.to, step.to - step.from);
        self.inner.step(step);
    }

    fn has_enough(&self) -> bool {
        self.suspects() || self.inner.has_enough()
    }
}
