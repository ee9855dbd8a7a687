//! Where a polishing stands, and what it has learnt on its way.

use super::bent::Bends;
use super::curve::Curve;
use super::local::{Aim, Look};
use super::programme::Step;

/// Roundings over the ranges to which values are known.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

/// Where a polishing stands.
pub(super) struct Stand {
    /// In units of the ranges.
    pub place: Vec<f64>,
    pub here: Look,
    pub region: f64,
    /// Of what conditions miss.
    pub weight: f64,
    pub curve: Curve,
    /// Whether what is learnt of the curvature of squares tells more than their slopes do, as it does where they stay large
    /// (J. E. Dennis, D. M. Gay, R. E. Welsch: *An adaptive nonlinear least-squares algorithm*, 1981).
    pub is_bent: bool,
    /// How the neighbourhood is bent, with the steps that were taken since that was looked at.
    pub bends: Option<(Bends, u64)>,
    /// Steps that were taken, and that failed after the last one that was.
    pub taken: u64,
    pub failed: u64,
    /// Whether it was seen that nothing is promised here.
    pub is_judged: bool,
    /// The last step that was proposed.
    pub last: Option<Step>,
}

impl Stand {
    pub fn new(place: Vec<f64>, here: Look, region: f64) -> Self {
        let count = place.len();
        Self {
            weight: here.steepness(count),
            curve: Curve::new(count),
            is_bent: false,
            place,
            here,
            region,
            bends: None,
            taken: 0,
            failed: 0,
            is_judged: false,
            last: None,
        }
    }

    /// The size of what is made small.
    pub fn size(&self, aim: Aim) -> f64 {
        let (first, squares) = aim.parts(&self.here.values);
        let largest = first.iter().fold(0.0, |most, one| f64::max(most, one.abs()));
        let squares: f64 = squares.iter().map(|value| value * value).sum();
        (largest + 0.5 * squares).max(1e-300)
    }

    /// What the squares come to where nothing but rounding is left of them.
    pub fn rounding(&self, aim: Aim) -> f64 {
        let count = self.place.len();
        let rows: Vec<&[f64]> = self.here.slopes.chunks_exact(count).collect();
        let (_, squares) = aim.parts(&rows[..self.here.values.len()]);
        let each = squares.iter().map(|row| {
            let steep: f64 = row.iter().map(|slope| slope.abs()).sum();
            0.5 * (ROUNDINGS * steep).powi(2)
        });
        each.sum()
    }

    /// Takes a step, and learns from what is there.
    pub fn go(&mut self, step: &Step, there: Look) {
        let count = self.place.len();
        let [old, new] = [&self.here, &there].map(|look| look.pull(&step.multipliers, count));
        let change: Vec<f64> = new.iter().zip(old).map(|(new, old)| new - old).collect();
        self.curve.learn(&step.way, &change);
        for (place, way) in self.place.iter_mut().zip(&step.way) {
            *place += way;
        }
        if let Some((bends, age)) = &mut self.bends {
            bends.learn(&step.way, &self.here, &there);
            *age += 1;
        }
        self.here = there;
        (self.taken, self.failed) = (self.taken + 1, 0);
        self.is_judged = false;
    }

    /// Whether nothing but squares is made small. Their slopes say most of how they are bent.
    pub fn is_squares(&self, aim: Aim) -> bool {
        aim.parts(&self.here.values).0.is_empty()
    }
}
