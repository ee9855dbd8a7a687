//! How accurately to integrate.

use super::error::OdeError;
use super::tableau::Explicit;
use crate::settings::{Method, Settings};

/// Error of a state that is permitted whatever the size of the state.
#[derive(Clone, Debug, PartialEq)]
pub enum AbsoluteTolerance {
    /// One tolerance for all states.
    Same(f64),
    /// One for each state.
    Each(Vec<f64>),
}

impl AbsoluteTolerance {
    /// The tolerance of one state.
    #[inline(always)]
    pub fn of(&self, state: usize) -> f64 {
        match self {
            Self::Same(value) => *value,
            Self::Each(values) => values[state],
        }
    }
}

/// How accurately to integrate.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Relative tolerance of a step, from 1e-14 to 0.1.
    pub rtol: f64,
    /// Absolute tolerance of a step.
    pub atol: AbsoluteTolerance,
    /// Length of the first step; found from the rates unless given.
    pub first_step: Option<f64>,
    /// Largest length of a step.
    pub max_step: Option<f64>,
    /// Largest number of steps, rejected ones included.
    pub max_steps: usize,
    /// Equal steps of about this length (shortened so that a whole number fits) without control of the error.
    pub fixed_step: Option<f64>,
}

impl Options {
    /// The usual options at a relative tolerance, with absolute tolerances `rtol * scales[i]`.
    pub fn scaled(rtol: f64, scales: &[f64]) -> Self {
        let atol = AbsoluteTolerance::Each(scales.iter().map(|scale| rtol * scale).collect());
        Self { rtol, atol, ..Self::default() }
    }

    /// The options that settings stand for where the states have these scales.
    pub fn of(settings: &Settings, scales: &[f64]) -> Self {
        let given = |state: usize| settings.atol.get(state).copied().flatten();
        // A state that there is none of keeps its tolerance, for the check to find.
        let atol = (0..scales.len().max(settings.atol.len())).map(|state| {
            let scale = scales.get(state).copied().unwrap_or(0.0);
            given(state).unwrap_or(settings.rtol * scale)
        });
        let usual = Self::default();
        Self {
            rtol: settings.rtol,
            atol: AbsoluteTolerance::Each(atol.collect()),
            first_step: settings.first_step,
            max_steps: settings.max_steps.unwrap_or(usual.max_steps),
            ..usual
        }
    }

    /// Checks the options, the times and the number of states.
    ///
    /// # Errors
    /// [`OdeError::BadOption`] with the first value that makes no sense.
    pub fn check(&self, times: (f64, f64), states: usize) -> Result<(), OdeError> {
        if !(1e-14..=0.1).contains(&self.rtol) {
            return bad("rtol", format!("{:e} is not between 1e-14 and 0.1", self.rtol));
        }
        let tolerances = match &self.atol {
            AbsoluteTolerance::Same(value) => std::slice::from_ref(value),
            AbsoluteTolerance::Each(values) if values.len() != states => {
                return bad(
                    "atol",
                    format!("{} values are given for {states} states", values.len()),
                );
            }
            AbsoluteTolerance::Each(values) => values,
        };
        if let Some(value) = tolerances.iter().find(|value| !(value.is_finite() && **value >= 0.0))
        {
            return bad("atol", format!("{value:e} is not a finite number from 0 up"));
        }
        let lengths = [
            ("first_step", self.first_step),
            ("max_step", self.max_step),
            ("fixed_step", self.fixed_step),
        ];
        for (name, length) in lengths {
            if let Some(length) = length
                && !(length.is_finite() && length > 0.0)
            {
                return bad(name, format!("{length:e} s is not a finite length above 0"));
            }
        }
        if !(times.0.is_finite() && times.1.is_finite() && (times.1 - times.0).is_finite()) {
            return bad(
                "times",
                format!("from {} s to {} s is not a finite stretch", times.0, times.1),
            );
        }
        Ok(())
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            rtol: 1e-8,
            atol: AbsoluteTolerance::Same(1e-8),
            first_step: None,
            max_step: None,
            max_steps: 5_000_000,
            fixed_step: None,
        }
    }
}

/// The error for an option.
pub(crate) fn bad<T>(name: &'static str, reason: String) -> Result<T, OdeError> {
    Err(OdeError::BadOption { name, reason })
}

/// The error for so many start values.
pub(crate) fn bad_start(values: usize, states: usize) -> OdeError {
    OdeError::BadOption {
        name: "start",
        reason: format!("{values} values are given for {states} states"),
    }
}

impl Method {
    /// The method among the explicit ones of Runge and Kutta; none if it is another.
    pub fn explicit(self) -> Option<Explicit> {
        match self {
            Self::Tsit5 => Some(Explicit::Tsit5),
            Self::Dop853 => Some(Explicit::Dop853),
            _ => None,
        }
    }
}
