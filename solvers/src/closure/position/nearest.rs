//! Which of all assemblies is nearest to the start values.
//!
//! Closing one group after the other, each in the mode nearest to its start values, finds the nearest assembly of all
//! only where the start values are near to one: with other dimensions a mode may be nearest that leads nowhere, or far
//! from the start values of the groups behind. There all assemblies are listed and compared.

use super::guide::Guide;
use super::start::Contradiction;
use crate::closure::modes::{Search, modes_of};
use crate::scalar::Scalar;
use std::f64::consts::{PI, TAU};

/// Start values this near to a position mean it, in radians or the displacements that count as much.
const NEAR: f64 = 0.5;
/// Start values farther from the position than this contradict it.
const FAR: f64 = 1.0;
/// A start value as far from one assembly as from another, but for this part of the distance, picks neither.
const UNDECIDED: f64 = 1e-3;
/// Boxes that may be looked at to list the assemblies of a group that is iterated.
const BOXES: usize = 20_000;

impl<S: Scalar> Guide<'_, S> {
    /// Whether the position that has been tried is near to all start values.
    pub(super) fn is_near(&mut self, instant: &[S], near: &[f64]) -> bool {
        let position = self.trial.clone();
        let apart = self.apart(instant, position, near);
        apart.iter().all(|apart| apart.is_nan() || apart.abs() <= NEAR)
    }

    /// The start values that are contradicted by the position that has been tried.
    pub(super) fn contradicted(&mut self, instant: &[S], near: &[f64]) -> Vec<Contradiction> {
        let position = self.trial.clone();
        let apart = self.apart(instant, position, near);
        let far = |dependent: &usize| apart[*dependent].abs() > FAR;
        let one = |dependent: usize| Contradiction {
            dependent,
            declared: near[dependent],
            assembled: self.towards(dependent, self.trial[dependent].to_f64(), near),
        };
        (0..self.entry.dependents.len()).filter(far).map(one).collect()
    }

    /// Puts the linkage into the assembly that is nearest to the start values, if it is not there already. False if
    /// there is none, or more than one.
    pub(super) fn place_nearest(
        &mut self,
        at: &[f64],
        instant: &[S],
        near: &[f64],
        is_placed: bool,
    ) -> bool {
        let here = self.trial.clone();
        let search = Search { boxes: BOXES, ..Search::default() };
        let listed = modes_of(self.linkage, at, &search).map(|found| found.modes);
        let mut all: Vec<(f64, Vec<f64>)> = Vec::new();
        for mode in listed.unwrap_or_default() {
            let mut position = vec![S::ZERO; self.trial.len()];
            for (entry, value) in position.iter_mut().zip(&mode.coordinates) {
                *entry = S::from_f64(*value);
            }
            let apart = self.apart(instant, position, near);
            let known = apart.iter().filter(|apart| !apart.is_nan());
            let distance = known.map(|apart| apart * apart).sum::<f64>().sqrt();
            let coordinates = mode.coordinates.into_iter().enumerate();
            let coordinates = coordinates.map(|(j, value)| self.towards(j, value, near));
            all.push((distance, coordinates.collect()));
        }
        // Of equal distances the first one counts: its modes are +1 where no start value is known.
        let nearest = all.iter().reduce(|best, one| if one.0 < best.0 { one } else { best });
        let Some((distance, coordinates)) = nearest.cloned() else {
            return is_placed;
        };
        let differs = |other: &[f64]| {
            let pairs = other.iter().zip(&coordinates).zip(near);
            pairs.into_iter().any(|((a, b), near)| !near.is_nan() && (a - b).abs() > 1e-6)
        };
        let tie = (1.0 + UNDECIDED) * distance;
        if all.iter().any(|one| one.0 <= tie && differs(&one.1)) {
            return false;
        }
        let same = |(j, value): (usize, &f64)| {
            (value - self.towards(j, here[j].to_f64(), &coordinates)).abs() < 1e-6
        };
        if is_placed && coordinates.iter().enumerate().all(same) {
            return true;
        }
        let kept = self.groups.modes.to_vec();
        let is_nearer = self.place_all(at, instant, &coordinates).is_ok();
        if !is_nearer {
            // A search has found what the iteration does not settle at: the position that was tried first remains.
            self.groups.modes.copy_from_slice(&kept);
            return is_placed && self.place_all(at, instant, near).is_ok();
        }
        is_nearer
    }

    /// How far each dependent coordinate is from its start value, angles but for whole turns, in radians or the
    /// displacements that count as much; NaN where no start value is known.
    fn apart(&mut self, instant: &[S], mut position: Vec<S>, near: &[f64]) -> Vec<f64> {
        let mut apart = vec![f64::NAN; self.entry.dependents.len()];
        for (group, described) in self.entry.groups.iter().enumerate() {
            self.newton.sine(self.loops, group, instant, &mut position);
            for (&j, unit) in described.unknowns.iter().zip(self.newton.units()) {
                let change = position[j].to_f64() - near[j];
                apart[j] = match self.entry.angles[j] {
                    true => (change + PI).rem_euclid(TAU) - PI,
                    false => change / unit,
                };
            }
        }
        apart
    }

    /// A coordinate, of an angle the one within half a turn of its start value if that is known.
    fn towards(&self, j: usize, value: f64, near: &[f64]) -> f64 {
        match self.entry.angles[j] && near[j].is_finite() {
            true => value + TAU * ((near[j] - value) / TAU).round(),
            false => value,
        }
    }
}
