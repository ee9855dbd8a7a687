//! Errors of the output with the loops closed again.

use super::lead::Lead;
use super::made::Maker;
use super::nominal::{Nominal, is_iterated};
use super::source::Study;
use crate::closure::Linkage;
use std::marker::PhantomData;

/// Closes made linkages at every place of a study.
pub(super) struct Exact<'a, L: Linkage> {
    study: &'a Study,
    nominals: &'a [Nominal],
    maker: Maker<L, f64, 1>,
    lanes: Vec<[f64; 1]>,
}

impl<'a, L: Linkage> Exact<'a, L> {
    pub fn new(study: &'a Study, nominals: &'a [Nominal]) -> Self {
        Self {
            study,
            nominals,
            maker: Maker::new(nominals, &study.sources, study.output),
            lanes: vec![[0.0]; study.sources.len()],
        }
    }

    /// The errors of the output at all places for errors of the sources; no number where the linkage does not assemble in
    /// its mode.
    pub fn errors(&mut self, errors: &[f64], found: &mut [f64]) {
        for (lane, error) in self.lanes.iter_mut().zip(errors) {
            *lane = [*error];
        }
        self.maker.make(&self.lanes);
        let closure = self.maker.prepare(0);
        for (place, slot) in found.iter_mut().enumerate() {
            *slot = match is_iterated::<L>() {
                // Closed to rounding, where samples need no more than their scatter resolves.
                true => self.lead(place, errors),
                false => self.maker.error(&closure, place, 0),
            };
        }
    }

    fn lead(&self, place: usize, errors: &[f64]) -> f64 {
        let lead = Lead::<L> {
            nominal: &self.nominals[place],
            sources: &self.study.sources,
            output: self.study.output,
            linkage: PhantomData,
        };
        lead.error(errors).unwrap_or(f64::NAN)
    }
}
