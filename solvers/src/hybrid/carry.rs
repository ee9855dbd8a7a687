//! The method that carries a motion from one event to the next.

use super::erased::{Called, Erased};
use super::problem::Modes;
use super::watch::Watch;
use crate::ode::{self, Observer, OdeError, Options, Statistics, Step};
use crate::problem::{Equations, Storage};
use crate::registry::Settings;
use crate::stiff::{self, Emitted, Switch};

/// A method with its memory.
pub(super) trait Carry<E: Modes<f64>>: Sized {
    /// Room for the states of some equations.
    fn new(equations: &E, settings: &Settings) -> Self;

    /// Integrates the equations that are watched until the end, or until the watch has enough.
    fn carry(
        &mut self,
        times: (f64, f64),
        start: &E::State,
        options: &Options,
        watch: &mut Watch<'_, E>,
    ) -> Result<Statistics, OdeError>;

    /// Where an automatic choice changed the method in the last integration.
    fn switches(&self) -> &[Switch] {
        &[]
    }
}

/// An explicit method.
pub(super) struct Explicit<V, M: ode::Method>(ode::Workspace<V, M>);

impl<'a, V: Storage<f64>, M: ode::Method> Carry<Erased<'a, V>> for Explicit<V, M> {
    #[inline(always)]
    fn new(equations: &Erased<'a, V>, _settings: &Settings) -> Self {
        Self(ode::Workspace::new::<f64, _>(&Called(equations)))
    }

    #[inline(always)]
    fn carry(
        &mut self,
        times: (f64, f64),
        start: &V,
        options: &Options,
        watch: &mut Watch<'_, Erased<'a, V>>,
    ) -> Result<Statistics, OdeError> {
        let system = Called(watch.equations);
        ode::integrate(&system, times, start, options, &mut self.0, watch)
    }
}

impl<'a, V: Storage<f64>> Carry<Erased<'a, V>> for ode::Taylor<V> {
    fn new(equations: &Erased<'a, V>, settings: &Settings) -> Self {
        Self::new(equations.states(), settings.rtol)
    }

    #[inline(always)]
    fn carry(
        &mut self,
        times: (f64, f64),
        start: &V,
        options: &Options,
        watch: &mut Watch<'_, Erased<'a, V>>,
    ) -> Result<Statistics, OdeError> {
        self.integrate(watch.equations, times, start, options, watch)
    }
}

/// A stiff method, or the automatic choice. It keeps its memory from event to event, and what it has found out about
/// the stiffness with it.
pub(super) struct Stiff(stiff::Workspace);

impl<E: Modes<f64>> Carry<E> for Stiff {
    fn new(equations: &E, settings: &Settings) -> Self {
        let method = settings.method.stiff().unwrap_or(stiff::Method::Automatic);
        Self(stiff::Workspace::new(method, &mut Emitted::new(equations)))
    }

    fn carry(
        &mut self,
        times: (f64, f64),
        start: &E::State,
        options: &Options,
        watch: &mut Watch<'_, E>,
    ) -> Result<Statistics, OdeError> {
        let rates = &mut Emitted::new(watch.equations);
        let mut observer = Typed::new(watch);
        stiff::integrate(
            rates,
            times,
            start.as_ref(),
            options,
            &mut self.0,
            &mut observer,
        )
    }

    fn switches(&self) -> &[Switch] {
        self.0.switches()
    }
}

/// An observer that hands the steps on in the states of the equations.
struct Typed<'a, 'b, E: Modes<f64>> {
    watch: &'a mut Watch<'b, E>,
    before: E::State,
    after: E::State,
    polynomial: Vec<E::State>,
}

impl<'a, 'b, E: Modes<f64>> Typed<'a, 'b, E> {
    fn new(watch: &'a mut Watch<'b, E>) -> Self {
        let (before, after) = (watch.state.clone(), watch.state.clone());
        Self {
            watch,
            before,
            after,
            polynomial: Vec::new(),
        }
    }
}

impl<E: Modes<f64>> Observer<Vec<f64>> for Typed<'_, '_, E> {
    fn wants_dense(&mut self, _from: f64, _to: f64) -> bool {
        true
    }

    fn step(&mut self, step: &Step<'_, Vec<f64>>) {
        self.before.as_mut().copy_from_slice(step.before);
        self.after.as_mut().copy_from_slice(step.after);
        self.polynomial
            .resize(step.polynomial.len(), self.before.clone());
        for (target, row) in self.polynomial.iter_mut().zip(step.polynomial) {
            target.as_mut().copy_from_slice(row);
        }
        self.watch.step(&Step {
            from: step.from,
            to: step.to,
            before: &self.before,
            after: &self.after,
            polynomial: &self.polynomial,
            basis: step.basis,
        });
    }

    fn has_enough(&self) -> bool {
        self.watch.has_enough()
    }
}
