//! Why an integration ended early.

use std::fmt;

/// Why an integration ended early.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OdeError {
    /// A rate or a state is not a finite number, however short the step.
    NotFinite {
        /// Time that was reached, in seconds.
        time: f64,
        /// Index of the state concerned.
        component: usize,
    },
    /// A stiff method needs a derivative of the rates that is not a finite number.
    NotDifferentiable {
        /// Time that was reached, in seconds.
        time: f64,
        /// Index of the state whose rate it is.
        component: usize,
        /// Index of the state by which it is differentiated.
        by: usize,
    },
    /// The tolerance asks for steps that the time can no longer tell apart.
    StepTooSmall {
        /// Time that was reached, in seconds.
        time: f64,
        /// Step that was asked for, in seconds.
        step: f64,
        /// Index of the state with the largest error.
        component: usize,
    },
    /// The permitted number of steps is used up.
    TooManySteps {
        /// Time that was reached, in seconds.
        time: f64,
        /// Steps that were tried.
        steps: usize,
    },
    /// An explicit method is held at steps that its stability permits, and would take more of them than are permitted.
    Stiff {
        /// Time that was reached, in seconds.
        time: f64,
        /// Length of the steps, in seconds.
        step: f64,
        /// `|λ|`, the fastest rate of change that the equations show, per second.
        rate: f64,
        /// Steps that it would take to the end.
        steps: f64,
    },
    /// A closure that holds coordinates does not stay closed.
    Open {
        /// Time that was reached, in seconds.
        time: f64,
        /// Index of the closure.
        closure: usize,
        /// By how much it is open, in SI units.
        by: f64,
    },
    /// An option or argument has a value that makes no sense.
    BadOption {
        /// The option.
        name: &'static str,
        /// What was found and what was expected.
        reason: String,
    },
}

impl OdeError {
    /// The time that was reached; none where nothing was begun.
    pub fn time(&self) -> Option<f64> {
        match self {
            Self::NotFinite { time, .. }
            | Self::NotDifferentiable { time, .. }
            | Self::StepTooSmall { time, .. }
            | Self::TooManySteps { time, .. }
            | Self::Open { time, .. }
            | Self::Stiff { time, .. } => Some(*time),
            Self::BadOption { .. } => None,
        }
    }
}

impl fmt::Display for OdeError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { time, component } => write!(
                formatter,
                "the rate of state {component} is not a finite number after t = {time} s; \
                 check whether a square root, a division or a logarithm leaves its range there"
            ),
            Self::NotDifferentiable { time, component, by } => write!(
                formatter,
                "the derivative of the rate of state {component} with respect to state {by} is not a finite number at \
                 t = {time} s, and a stiff method needs it; an explicit method does not"
            ),
            Self::StepTooSmall { time, step, component } => write!(
                formatter,
                "at t = {time} s the error of state {component} asks for a step of {step:e} s, too short to advance \
                 the time; the motion may have a singularity there, otherwise try a larger rtol"
            ),
            Self::TooManySteps { time, steps } => write!(
                formatter,
                "{steps} steps were used up at t = {time} s; the equations may be stiff, for which there are the methods radau, \
                 rosenbrock and auto; otherwise permit more steps, take a larger rtol or a shorter time"
            ),
            Self::Stiff { time, step, rate, steps } => write!(
                formatter,
                "the equations are stiff: at t = {time} s they know changes as fast as {rate:.1e}/s, which hold the steps of \
                 an explicit method at {step:.1e} s, and {steps:.0e} steps would be left; take the method radau, rosenbrock \
                 or auto"
            ),
            Self::Open { time, closure, by } => write!(
                formatter,
                "at t = {time} s closure {closure} is open by {by:.3e} (SI units) and cannot be closed: the mechanism locks \
                 there, or closures that have to agree contradict each other"
            ),
            Self::BadOption { name, reason } => write!(formatter, "{name}: {reason}"),
        }
    }
}

impl std::error::Error for OdeError {}
