//! The choice between an explicit and a stiff method while the motion goes on.
//!
//! The motion begins with the explicit method of order 8. Each of its steps measures `h|λ|`, the step in terms of the
//! fastest change that the equations know, from the last two stages, which both lie at its end (Hairer, Wanner II,
//! section IV.2, (2.25) and program DOP853). At the border of stability it is about 6; but beside a stiff part an explicit
//! method of high order loses its accuracy long before, and hovers anywhere from 0.4 (at `rtol = 1e-9`) up. A resolved
//! oscillation gives the same figures. So the measure only says where a stiff method might be worth trying. It is not where a
//! state itself goes to and fro within a few of those steps: what is fast is motion then, and no method takes longer ones. Else it
//! is found by trying: if after a few steps its steps are no longer than those of the explicit method were, the
//! explicit one goes on, and it takes twice as long until the next trial. Otherwise the stiff method stays, for as long as
//! its steps are longer, by the spectral radius of the Jacobian, than those of the explicit method would be.
//!
//! The stiff method is Radau for loose tolerances, and Rodas5P, whose error estimate and continuous solution are one
//! order higher, for tight ones.

mod gauge;

use super::here::Here;
use super::radau::Radau;
use super::rosenbrock::Rosenbrock;
use super::spectrum::Calm;
use super::stepper::drive;
use crate::model::Flow;
use crate::ode::{self, Explicit, Observer, OdeError, Options, Statistics, Switch};
use gauge::{Gauge, STIFF, Suspicion};

/// Steps up to which the stiff method is on trial.
const TRIAL: usize = 40;
/// A last step so many times longer than those of the explicit method ends the trial too.
const PROOF: f64 = 4.0;
/// Relative tolerance above which Radau is the stiff method, below Rodas5P.
const LOOSE: f64 = 1e-5;
/// The memory of the methods.
pub(super) struct Automatic {
    explicit: ode::Workspace,
    /// Those of the stiff methods, once there is something stiff.
    radau: Option<Radau>,
    rosenbrock: Option<Rosenbrock>,
    calm: Option<Calm>,
    suspicion: Suspicion,
    /// What goes on now. Kept from one integration to the next: events do not change how stiff a mechanism is.
    phase: Phase,
    /// The changes of the last integration.
    pub switches: Vec<Switch>,
}

/// Which method goes on.
#[derive(Clone, Copy, Debug)]
enum Phase {
    Explicit,
    /// The stiff one on trial, since a time and for so many steps; the explicit one had steps of a length.
    Trial {
        since: f64,
        steps: usize,
        step: f64,
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
            rosenbrock: None,
            calm: None,
            suspicion: Suspicion::new(flow.states()),
            phase: Phase::Explicit,
            switches: Vec::with_capacity(64),
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
        let done = loop {
            here.statistics = Statistics::default();
            let stretch = (here.time, times.1);
            let (done, time, step) = match self.phase {
                Phase::Explicit => self.explicitly(flow, here, stretch, &options, observe),
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
                    self.consider(flow, here);
                    total.add(&here.statistics);
                }
                // Where the stiff method fails, the explicit one has the last word.
                Phase::Trial { step, .. } => {
                    self.suspicion.was_wrong();
                    self.phase = Phase::Explicit;
                    options.first_step = Some(step);
                }
                Phase::Stiff => {
                    self.phase = Phase::Explicit;
                    let stiff = false;
                    self.switches.push(Switch { time, stiff });
                }
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
        let mut gauge = Gauge {
            inner: observe,
            suspicion: Some((&mut self.suspicion, options)),
            last: (times.0, 0.0),
        };
        let explicit = &mut self.explicit;
        let done = ode::integrate(flow, times, &here.state, options, explicit, &mut gauge);
        let (time, step) = gauge.last;
        here.state.copy_from_slice(self.explicit.state());
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
        let mut gauge = Gauge { inner: observe, suspicion: None, last: (times.0, 0.0) };
        // The rows of higher degree stay zero.
        here.polynomial.fill(0.0);
        let states = here.state.len();
        let calm = self.calm.get_or_insert_with(|| Calm::new(states));
        calm.restart();
        let calm = Some(calm);
        let done = match options.rtol > LOOSE {
            true => {
                let radau = self.radau.get_or_insert_with(|| Radau::new(states));
                drive(radau, flow, here, times, options, &mut gauge, calm)
            }
            false => {
                let rosenbrock = self.rosenbrock.get_or_insert_with(|| Rosenbrock::new(states));
                drive(rosenbrock, flow, here, times, options, &mut gauge, calm)
            }
        };
        let (time, step) = gauge.last;
        if let Phase::Trial { since, steps, step: explicit } = &mut self.phase {
            *steps += here.statistics.steps;
            if *steps > TRIAL || step.abs() > PROOF * *explicit {
                let (time, stiff) = (*since, true);
                self.switches.push(Switch { time, stiff });
                self.phase = Phase::Stiff;
                self.suspicion.restart();
            }
        }
        (done, time, step)
    }

    /// Tries the stiff method where the Jacobian agrees that it may be worth it.
    fn consider(&mut self, flow: &Flow<'_>, here: &mut Here) {
        let step = self.suspicion.step();
        let calm = self.calm.get_or_insert_with(|| Calm::new(here.state.len()));
        let product = calm.begin(flow, here, step);
        // One that does not exist says nothing.
        if !product.is_ok_and(|product| product >= STIFF) {
            self.suspicion.was_wrong();
            return;
        }
        self.suspicion.clear();
        let (since, steps) = (here.time, 0);
        self.phase = Phase::Trial { since, steps, step };
    }
}
