//! Which method integrates, and how accurately.

/// Name of an integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// The method of Dormand and Prince, and a stiff one where the motion turns out to be stiff.
    Auto,
}

impl Method {
    /// The method among the explicit ones of Runge and Kutta; none if it is another.
    pub fn explicit(self) -> Option<crate::ode::Explicit> {
        match self {
            Self::Tsit5 => Some(crate::ode::Explicit::Tsit5),
            Self::Dop853 => Some(crate::ode::Explicit::Dop853),
            _ => None,
        }
    }

    /// The method among those that solve stiff motions; none if it is explicit.
    pub fn stiff(self) -> Option<crate::stiff::Method> {
        match self {
            Self::Tsit5 | Self::Dop853 | Self::Taylor => None,
            Self::Radau => Some(crate::stiff::Method::Radau),
            Self::Rosenbrock => Some(crate::stiff::Method::Rosenbrock),
            Self::Auto => Some(crate::stiff::Method::Automatic),
        }
    }
}

/// Which method integrates, how accurately, and what it may take.
///
/// The error of a step is to be smaller than `rtol` times the state, plus an absolute tolerance that keeps a state near
/// zero from being followed to all digits. `Settings { rtol: 1e-8, ..Settings::default() }` takes the rest as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The method.
    pub method: Method,
    /// Relative tolerance of a step.
    pub rtol: f64,
    /// Absolute tolerances of the states in SI units, in their order; `rtol` times the scale of the state where none is
    /// given or the list has ended.
    pub atol: Vec<Option<f64>>,
    /// Most steps of an integration, rejected ones included; ten million unless given.
    pub max_steps: Option<usize>,
    /// Length of the first step of an integration, in seconds; found from the rates unless given.
    pub first_step: Option<f64>,
}

impl Settings {
    /// A method and its relative tolerance, the rest as by default.
    pub const fn new(method: Method, rtol: f64) -> Self {
        Self {
            method,
            rtol,
            atol: Vec::new(),
            max_steps: None,
            first_step: None,
        }
    }

    /// The same with another relative tolerance; absolute tolerances that are given change by the same factor.
    pub fn at(&self, rtol: f64) -> Self {
        let factor = rtol / self.rtol;
        let atol = self.atol.iter().map(|atol| atol.map(|atol| atol * factor));
        Self {
            rtol,
            atol: atol.collect(),
            ..*self
        }
    }
}

impl Default for Settings {
    /// The explicit method of order 8 at the tolerance of `assur run`, 1e-10.
    fn default() -> Self {
        Self::new(Method::Dop853, 1e-10)
    }
}
