//! The choice between an explicit method, the Taylor series and a stiff method while the motion goes on.
//!
//! The motion begins with the explicit method of order 8, or with the series where that is cheap (`prospect`). Each step of the
//! former measures `h|λ|`, the step in terms of the fastest change that the equations know, from the last two stages, which both
//! lie at its end (Hairer, Wanner II, section IV.2, (2.25) and program DOP853). At the border of stability it is about 6; but beside a stiff part an explicit
//! method of high order loses its accuracy long before, and hovers anywhere from 0.4 (at `rtol = 1e-9`) up. A resolved
//! oscillation gives the same figures. So the measure only says where a stiff method might be worth trying. It is not where a
//! state itself goes to and fro within a few of those steps: what is fast is motion then, and no method takes longer ones. Else it
//! is found by trying: if after a few steps its steps are no longer than those of the explicit method were, the
//! explicit one goes on, and it takes twice as long until the next trial. Otherwise the stiff method stays, for as long as
//! its steps are longer, by the spectral radius of the Jacobian, than those of the explicit method would be.
//!
//! The stiff method is Radau. Rodas5P takes fewer steps of some motions, to an equal error up to 1.4 times as fast (regularised
//! friction), and far more where stiff springs hold masses: a pendulum on one takes it 7 times as long.

mod gauge;
mod prospect;

use super::here::Here;
use super::radau::Radau;
use super::spectrum::Calm;
use super::stepper::drive;
use crate::model::Flow;
use crate::ode::{self, Explicit, Observer, OdeError, Options, Statistics, Switch};
use crate::settings::Method;
use gauge::{Gauge, Look, STIFF, Suspicion};
use prospect::Prospect;

/// Steps up to which the stiff method is on trial.
const TRIAL: usize = 40;
/// A last step so many times longer than those of the method before it ends the trial too.
const PROOF: f64 = 4.0;

/// The memory of the methods.
pub(super) struct Automatic {
    explicit: ode::Workspace,
    /// That of the stiff method, once there is something stiff.
    radau: Option<Radau>,
    calm: Option<Calm>,
    suspicion: Suspicion,
    prospect: Prospect,
    /// What goes on now. Kept from one integration to the next: events do not change how stiff a mechanism is.
    phase: Phase,
    /// The changes of the last integration.
    pub switches: Vec<Switch>,
}

/// Which method goes on.
#[derive(Clone, Copy, Debug)]
enum Phase {
    Explicit,
    /// The Taylor series of the motion.
    Series,
    /// The stiff one on trial, since a time and for so many steps; the one before it had steps of a length.
    Trial {
        since: f64,
        steps: usize,
        step: f64,
        is_series: bool,
    },
    Stiff,
}

impl Automatic {
    /// Coefficients of the continuous solution: those of the explicit method, of which a stiff step leaves the last zero.
    pub const DEGREE: usize = 7;

    /// Room for the states of a system.
    pub fn new(flow: &Flow<'_>) -> Self {
        Self {
            explicit: ode::Workspace::new(Explicit::Dop853, flow),
            radau: None,
            calm: None,
            suspicion: Suspicion::new(flow.states()),
            prospect: Prospect::new(),
            phase: Phase::Explicit,
            switches: Vec::with_capacity(16),
        }
    }

    /// Integrates from [`Here::state`]. What it took is in [`Here::statistics`], failed or not.
    pub fn integrate(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        observe: &mut dyn Observer,
    ) -> Result<(), OdeError> {
        self.switches.clear();
        let mut total = Statistics::default();
        let mut options = options.clone();
        let allowed = options.max_steps;
        here.time = times.0;
        if self.prospect.begin(flow, &options) {
            self.go(times.0, Phase::Series, Method::Taylor);
        }
        let done = loop {
            here.statistics = Statistics::default();
            let stretch = (here.time, times.1);
            let (done, time, step) = match self.phase {
                Phase::Explicit => self.explicitly(flow, here, stretch, &options, observe),
                Phase::Series => self.by_series(flow, here, stretch, &options, observe),
                _ => self.stiffly(flow, here, stretch, &options, observe),
            };
            total.add(&here.statistics);
            here.time = time;
            if let Err(OdeError::TooManySteps { time, .. }) = done {
                let steps = allowed;
                break Err(OdeError::TooManySteps { time, steps });
            }
            let has_failed = done.is_err() && matches!(self.phase, Phase::Explicit);
            if has_failed || time == times.1 || observe.has_enough() {
                break done;
            }
            options.max_steps = allowed.saturating_sub(total.steps + total.rejected);
            options.first_step = (step != 0.0).then_some(step.abs());
            match self.phase {
                Phase::Explicit => {
                    here.statistics = Statistics::default();
                    self.consider(flow, here, &options);
                    total.add(&here.statistics);
                }
                Phase::Series if done.is_ok() && self.prospect.is_held() => {
                    here.statistics = Statistics::default();
                    let step = self.prospect.mean();
                    if !self.tries(flow, here, step, true) {
                        self.prospect.was_wrong();
                    }
                    total.add(&here.statistics);
                }
                // Where the series fails or is not worth it, the explicit method has the next word.
                Phase::Series => {
                    self.prospect.leave();
                    self.go(time, Phase::Explicit, Method::Dop853);
                    options.first_step = None;
                }
                // Where the stiff method fails, that before it has the last word.
                Phase::Trial { step, is_series, .. } => {
                    self.phase = match is_series {
                        true => {
                            self.prospect.was_wrong();
                            Phase::Series
                        }
                        false => {
                            self.suspicion.was_wrong();
                            Phase::Explicit
                        }
                    };
                    options.first_step = Some(step);
                }
                Phase::Stiff => self.go(time, Phase::Explicit, Method::Dop853),
            }
        };
        here.statistics = total;
        done
    }

    /// Goes on with the explicit method. Gives the time that was reached, and the last step.
    fn explicitly(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        observe: &mut dyn Observer,
    ) -> (Result<(), OdeError>, f64, f64) {
        let look = Look::Explicit(&mut self.suspicion, &mut self.prospect, options);
        let mut gauge = Gauge { inner: observe, look, last: (times.0, 0.0) };
        let explicit = &mut self.explicit;
        let done = ode::integrate(flow, times, &here.state, options, explicit, &mut gauge);
        let (time, step) = gauge.last;
        here.state.copy_from_slice(self.explicit.state());
        let done = done.map(|statistics| here.statistics = statistics);
        (done, time, step)
    }

    /// Goes on with the series.
    fn by_series(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        observe: &mut dyn Observer,
    ) -> (Result<(), OdeError>, f64, f64) {
        let Some(mut taylor) = self.prospect.taylor.take() else {
            return (Ok(()), times.0, 0.0);
        };
        let look = Look::Series(&mut self.prospect);
        let mut gauge = Gauge { inner: observe, look, last: (times.0, 0.0) };
        let done = taylor.integrate(flow, times, &here.state, options, &mut gauge);
        let (time, step) = gauge.last;
        here.state.copy_from_slice(taylor.state());
        self.prospect.taylor = Some(taylor);
        let done = done.map(|statistics| here.statistics = statistics);
        (done, time, step)
    }

    /// Goes on with the stiff one.
    fn stiffly(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        times: (f64, f64),
        options: &Options,
        observe: &mut dyn Observer,
    ) -> (Result<(), OdeError>, f64, f64) {
        let mut gauge = Gauge { inner: observe, look: Look::Nothing, last: (times.0, 0.0) };
        // The rows of higher degree stay zero.
        here.polynomial.fill(0.0);
        let states = here.state.len();
        let calm = self.calm.get_or_insert_with(|| Calm::new(states));
        calm.restart();
        let calm = Some(calm);
        let radau = self.radau.get_or_insert_with(|| Radau::new(states));
        let done = drive(radau, flow, here, times, options, &mut gauge, calm);
        let (time, step) = gauge.last;
        if let Phase::Trial { since, steps, step: before, .. } = &mut self.phase {
            *steps += here.statistics.steps;
            if *steps > TRIAL || step.abs() > PROOF * *before {
                let since = *since;
                self.suspicion.restart();
                self.go(since, Phase::Stiff, Method::Radau);
            }
        }
        (done, time, step)
    }

    /// Goes into a phase.
    fn go(&mut self, time: f64, phase: Phase, to: Method) {
        self.phase = phase;
        self.prospect.clear();
        self.switches.push(Switch { time, to });
    }

    /// Takes the series where it is worth it, and tries the stiff method where that may be.
    fn consider(&mut self, flow: &Flow<'_>, here: &mut Here, options: &Options) {
        if self.prospect.is_due() && self.prospect.is_worth_it(flow, here, options) {
            self.suspicion.clear();
            return self.go(here.time, Phase::Series, Method::Taylor);
        }
        if self.suspicion.is_enough() {
            let step = self.suspicion.step();
            match self.tries(flow, here, step, false) {
                true => self.suspicion.clear(),
                false => self.suspicion.was_wrong(),
            }
        }
    }

    /// Tries the stiff method where the Jacobian agrees that it may be worth it, after steps of a length by the other one.
    fn tries(&mut self, flow: &Flow<'_>, here: &mut Here, step: f64, is_series: bool) -> bool {
        let calm = self.calm.get_or_insert_with(|| Calm::new(here.state.len()));
        let product = calm.begin(flow, here, step);
        // One that does not exist says nothing.
        let is_tried = product.is_ok_and(|product| product >= STIFF);
        if is_tried {
            self.phase = Phase::Trial { since: here.time, steps: 0, step, is_series };
        }
        is_tried
    }
}
