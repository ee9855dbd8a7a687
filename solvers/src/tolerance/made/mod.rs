//! Made linkages: prepared with other dimensions and closed near the nominal one; on packs of numbers, several samples at a time.

pub(super) mod exact;
pub(super) mod lead;
pub(super) mod nominal;
pub(super) mod place;
pub(crate) mod small;
mod turn;
pub(super) mod varied;

use super::source::Source;
use crate::closure::{Closure, Linkage};
use crate::scalar::Scalar;
use nominal::Nominal;
use place::Station;
use varied::Varied;

/// Makes linkages; keeps the memory for it.
pub(super) struct Maker<L: Linkage, S: Scalar> {
    linkage: L,
    values: Vec<S>,
    /// The constants that err.
    constants: Vec<Varied<S>>,
    output: usize,
    outputs: Vec<S>,
    independents: Vec<S>,
    places: Vec<Station<L, S>>,
}

impl<L: Linkage, S: Scalar> Maker<L, S> {
    pub fn new(linkage: &L, nominals: &[Nominal], sources: &[Source], output: usize) -> Self {
        let values = nominals.first().map_or(&[][..], |one| &one.values);
        let (values, shape) = (numbers::<S>(values), linkage.shape());
        let zeros = S::outline(
            #[inline(always)]
            || linkage.prepare(&values).zeros(),
        );
        let variables = shape.loops().variables;
        let place = |one: &Nominal| Station::new(one, &zeros, (variables, sources), output);
        Self {
            linkage: linkage.clone(),
            constants: Varied::constants(variables, sources, &values),
            values,
            output,
            outputs: vec![S::ZERO; shape.outputs.len()],
            independents: vec![S::ZERO; shape.drivers.len()],
            places: nominals.iter().map(place).collect(),
        }
    }

    /// What depends on the nominal dimensions alone.
    pub fn nominal(&self) -> L::Closure<S> {
        S::outline(
            #[inline(always)]
            || self.linkage.prepare(&self.values),
        )
    }

    /// Computes what depends on the dimensions alone, from the errors of the sources.
    #[inline(always)]
    pub fn prepare(&mut self, closure: &mut L::Closure<S>, errors: &[S]) {
        for constant in &self.constants {
            self.values[constant.index] = constant.made(errors);
        }
        // Of a length that is known, what reads them is not checked again.
        let values = &self.values[..self.linkage.shape().constants.len()];
        S::outline(
            #[inline(always)]
            || self.linkage.renew(closure, values),
        );
    }

    /// Closes the made linkage at a place and gives the error of its output; no number if the mode is not certain, or
    /// does not exist.
    #[inline(always)]
    pub fn error(&mut self, closure: &L::Closure<S>, place: usize, errors: &[S]) -> S {
        let (place, shape) = (&self.places[place], closure.shape());
        let independents = &mut self.independents[..shape.drivers.len()];
        let outputs = &mut self.outputs[..shape.outputs.len()];
        let closed = place.close(closure, errors, independents, outputs);
        S::select(closed, outputs[self.output] - place.nominal, S::from_f64(f64::NAN))
    }
}

pub(super) fn numbers<S: Scalar>(list: &[f64]) -> Vec<S> {
    list.iter().map(|one| S::from_f64(*one)).collect()
}
