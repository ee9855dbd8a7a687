//! The band along the way of the drivers, and where it is greatest between the places that are known.

use super::error::AllocationError;
use super::{Candidate, Rule};

/// Fewest places that are looked at, unless there is only one.
const PLACES: usize = 65;
/// Steps of the golden section: to 1e-8 of a step between places.
const STEPS: usize = 38;

/// The error per unit of each tolerance at some part of the way, from 0 to 1.
pub(super) type Influence<'a> = dyn FnMut(f64) -> Result<Vec<f64>, AllocationError> + 'a;

/// What an error is made of.
pub(super) struct Band<'a> {
    pub influence: &'a mut Influence<'a>,
    pub rule: Rule,
    /// Parts of the way that are looked at.
    parts: Vec<f64>,
    /// Influences there.
    known: Vec<Vec<f64>>,
}

impl<'a> Band<'a> {
    /// Looks along the way at this many places at least.
    pub fn new(
        influence: &'a mut Influence<'a>,
        rule: Rule,
        places: usize,
    ) -> Result<Self, AllocationError> {
        let count = match places {
            0 | 1 => 1,
            more => more.max(PLACES),
        };
        let parts: Vec<f64> = (0..count).map(|k| k as f64 / (count - 1).max(1) as f64).collect();
        let known = parts.iter().map(|part| influence(*part)).collect::<Result<_, _>>()?;
        Ok(Self { influence, rule, parts, known })
    }

    /// Largest influence of each tolerance over the places.
    pub fn largest(&self, tolerance: usize) -> f64 {
        let all = self.known.iter().map(|row| row[tolerance].abs());
        all.fold(0.0, f64::max)
    }

    /// The places at which the error is greater than beside them, refined, with the errors there.
    pub fn peaks(&mut self, tolerances: &[f64]) -> Result<Vec<Peak>, AllocationError> {
        let errors: Vec<f64> =
            self.known.iter().map(|row| self.rule.error(row, tolerances)).collect();
        let last = errors.len() - 1;
        let mut peaks = Vec::new();
        for (k, error) in errors.iter().enumerate() {
            let left = k == 0 || errors[k - 1] <= *error;
            let right = k == last || errors[k + 1] < *error;
            if left && right {
                let ends = (self.parts[k.saturating_sub(1)], self.parts[(k + 1).min(last)]);
                let mut best =
                    Peak { part: self.parts[k], influence: self.known[k].clone(), error: *error };
                self.climb(ends, tolerances, &mut best)?;
                peaks.push(best);
            }
        }
        Ok(peaks)
    }

    /// Golden section towards the greatest error.
    fn climb(
        &mut self,
        (mut low, mut high): (f64, f64),
        tolerances: &[f64],
        best: &mut Peak,
    ) -> Result<(), AllocationError> {
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let mut inner = [high - golden * (high - low), low + golden * (high - low)];
        let mut errors = [0.0; 2];
        for (part, error) in inner.iter().zip(&mut errors) {
            *error = self.look(*part, tolerances, best)?;
        }
        for _ in 0..STEPS {
            if high <= low {
                break;
            }
            if errors[0] > errors[1] {
                high = inner[1];
                (inner[1], errors[1]) = (inner[0], errors[0]);
                inner[0] = high - golden * (high - low);
                errors[0] = self.look(inner[0], tolerances, best)?;
            } else {
                low = inner[0];
                (inner[0], errors[0]) = (inner[1], errors[1]);
                inner[1] = low + golden * (high - low);
                errors[1] = self.look(inner[1], tolerances, best)?;
            }
        }
        Ok(())
    }

    /// The error at a part of the way; keeps it if it is the greatest so far.
    fn look(
        &mut self,
        part: f64,
        tolerances: &[f64],
        best: &mut Peak,
    ) -> Result<f64, AllocationError> {
        let influence = (self.influence)(part)?;
        let error = self.rule.error(&influence, tolerances);
        if error > best.error {
            *best = Peak { part, influence, error };
        }
        Ok(error)
    }
}

/// A place where the error is greatest.
#[derive(Clone, Debug)]
pub(super) struct Peak {
    pub part: f64,
    pub influence: Vec<f64>,
    pub error: f64,
}

impl Rule {
    /// The error by tolerances, from the error per unit of each.
    pub(super) fn error(self, influence: &[f64], tolerances: &[f64]) -> f64 {
        let parts = influence.iter().zip(tolerances).map(|(k, t)| (k * t).abs());
        match self {
            Rule::Worst => parts.sum(),
            Rule::RootSumSquare | Rule::Deviation => {
                parts.map(|part| part * part).sum::<f64>().sqrt()
            }
        }
    }

    /// The error per unit of a tolerance, from the influence of its variable.
    pub(super) fn weigh(self, influence: f64, candidate: &Candidate) -> f64 {
        match self {
            Rule::Worst | Rule::RootSumSquare => influence,
            Rule::Deviation => influence * candidate.distribution.deviation(),
        }
    }
}
