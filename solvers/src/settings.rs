//! Which method integrates, and how accurately.

use crate::shape::{Shape, find};
use std::fmt;
use std::str::FromStr;

/// An integration method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Explicit Runge–Kutta pair of order 5(4), Tsitouras.
    Tsit5,
    /// Explicit Runge–Kutta method of order 8 with errors of order 5 and 3, Dormand and Prince.
    Dop853,
    /// Taylor series of the motion, of an order that follows from the tolerance.
    Taylor,
    /// Implicit Runge–Kutta method of order 5 for stiff motions, Radau IIA.
    Radau,
    /// Rosenbrock method of order 5 for stiff motions, Rodas5P.
    Rosenbrock,
    /// The method of Dormand and Prince, the Taylor series where that takes less time, and Radau where the motion turns out to be
    /// stiff.
    #[default]
    Auto,
}

impl Method {
    /// All methods, the default one first.
    pub const ALL: [Self; 6] =
        [Self::Auto, Self::Dop853, Self::Tsit5, Self::Taylor, Self::Radau, Self::Rosenbrock];

    /// Its name, as the command takes it and [`Method::from_str`] reads it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tsit5 => "tsit5",
            Self::Dop853 => "dop853",
            Self::Taylor => "taylor",
            Self::Radau => "radau",
            Self::Rosenbrock => "rosenbrock",
            Self::Auto => "auto",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.name())
    }
}

/// There is no method of this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod(pub String);

impl fmt::Display for UnknownMethod {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = Method::ALL.map(Method::name).join(", ");
        write!(formatter, "there is no method `{}`; there are: {known}", self.0)
    }
}

impl std::error::Error for UnknownMethod {}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(name: &str) -> Result<Self, UnknownMethod> {
        let mut all = Self::ALL.into_iter();
        all.find(|method| method.name() == name).ok_or_else(|| UnknownMethod(name.to_owned()))
    }
}

/// Relative tolerance unless one is given: that of `assur run`.
const RTOL: f64 = 1e-10;

/// Which method integrates, how accurately, and what it may take.
///
/// The error of a step is to be smaller than `rtol` times the state, plus an absolute tolerance that keeps a state near
/// zero from being followed to all digits. `Settings::new(Method::Taylor).rtol(1e-12)` takes the rest as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The method.
    pub method: Method,
    /// Relative tolerance of a step.
    pub rtol: f64,
    /// Absolute tolerances of the states in SI units, in their order; `rtol` times the scale of the state where none is
    /// given or the list has ended.
    pub atol: Vec<Option<f64>>,
    /// Most steps of an integration, rejected ones included; five million unless given.
    pub max_steps: Option<usize>,
    /// Length of the first step of an integration, in seconds; found from the rates unless given.
    pub first_step: Option<f64>,
}

impl Settings {
    /// A method, the rest as by default.
    pub const fn new(method: Method) -> Self {
        Self { method, rtol: RTOL, atol: Vec::new(), max_steps: None, first_step: None }
    }

    /// With this relative tolerance.
    #[must_use]
    pub const fn rtol(mut self, rtol: f64) -> Self {
        self.rtol = rtol;
        self
    }

    /// These settings for a scene whose states stand in another order, or are more.
    pub(crate) fn of_states(&self, from: &Shape, to: &Shape) -> Self {
        let mut atol = vec![None; if self.atol.is_empty() { 0 } else { to.states.len() }];
        for (state, value) in from.states.iter().zip(&self.atol) {
            if let (Some(place), false) = (find(to.states, state.name), atol.is_empty()) {
                atol[place] = *value;
            }
        }
        Self { atol, ..self.clone() }
    }

    /// These settings with another relative tolerance; absolute tolerances that are given change by the same factor.
    pub fn at(&self, rtol: f64) -> Self {
        let factor = rtol / self.rtol;
        let atol = self.atol.iter().map(|atol| atol.map(|atol| atol * factor));
        Self { rtol, atol: atol.collect(), ..*self }
    }
}

impl Default for Settings {
    /// The automatic choice at the tolerance of `assur run`, 1e-10.
    fn default() -> Self {
        Self::new(Method::Auto)
    }
}

impl fmt::Display for Settings {
    /// `taylor with rtol 1e-12`
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} with rtol {:e}", self.method, self.rtol)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_method_is_read_as_it_is_written() {
        for method in Method::ALL {
            assert_eq!(method.to_string().parse(), Ok(method));
        }
        let unknown = "tsit".parse::<Method>().unwrap_err().to_string();
        assert!(unknown.starts_with("there is no method `tsit`; there are: auto, dop853, tsit5"));
        assert_eq!(Method::default(), Settings::default().method);
        let fine = Settings::new(Method::Taylor).rtol(1e-12);
        assert_eq!(fine.to_string(), "taylor with rtol 1e-12");
    }
}
