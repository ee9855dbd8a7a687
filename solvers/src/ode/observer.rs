//! What happens with the steps of an integration.

/// What the coefficients `F₁, F₂, …` of a continuous solution belong to, with `θ` from 0 to 1 over the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// `y₀ + θ(F₁ + (1-θ)(F₂ + θ(F₃ + (1-θ)(F₄ + …))))`
    Alternating,
    /// `y₀ + F₁ θ + F₂ θ² + …`
    Powers,
}

/// A step that was accepted.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// Time at its begin.
    pub from: f64,
    /// Time at its end.
    pub to: f64,
    /// State at its begin.
    pub before: &'a [f64],
    /// State at its end.
    pub after: &'a [f64],
    /// The coefficients `F₁, F₂, …` of the continuous solution, each as long as the state, one behind the other; empty unless
    /// asked for.
    pub polynomial: &'a [f64],
    /// What they belong to.
    pub basis: Basis,
}

/// Looks at the steps of an integration.
pub trait Observer {
    /// Whether the continuous solution of this step is wanted.
    #[inline]
    fn wants_dense(&mut self, _from: f64, _to: f64) -> bool {
        false
    }

    /// Looks at a step.
    fn step(&mut self, step: &Step<'_>);

    /// Whether [`Observer::stiffness`] is wanted.
    #[inline]
    fn wants_stiffness(&self) -> bool {
        false
    }

    /// Looks at the length of the next step to be looked at, and at `|λ|`, the fastest rate of change that the equations
    /// show in it.
    #[inline]
    fn stiffness(&mut self, _length: f64, _rate: f64) {}

    /// Whether the integration is to end after the step that was looked at last.
    #[inline]
    fn has_enough(&self) -> bool {
        false
    }
}

/// Nobody looks.
impl Observer for () {
    #[inline]
    fn step(&mut self, _step: &Step<'_>) {}
}
