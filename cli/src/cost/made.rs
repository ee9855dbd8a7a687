//! What the tolerances of dimensions make of a motion: accuracy beyond that is of no use.

use assur::answer::{Estimate, Motion, Question, Settings};
use assur::shape::Subject;

use crate::motion::case::Case;

/// Samples of the task, of which [`Estimate::largest`] looks at each third.
const SAMPLES: usize = 720;

/// How what is looked at spreads over mechanisms as they are made, SI units.
pub struct Spread {
    /// What has a tolerance.
    pub names: Vec<&'static str>,
    /// Standard deviation of each subject, the largest over the task; not a number where it is not known.
    pub subjects: Vec<f64>,
    /// That of each measure.
    pub measures: Vec<f64>,
}

impl Spread {
    /// The root of the sum of squares of what one standard deviation of each dimension does. None where nothing has a tolerance,
    /// or where there is no motion.
    pub fn of(case: &Case, subjects: &[Subject]) -> Option<Self> {
        let constants = &case.constants;
        let made: Vec<usize> = { constants.scene.constants.iter().enumerate() }
            .filter_map(|(index, one)| (one.tolerance > 0.0).then_some(index))
            .collect();
        if made.is_empty() {
            return None;
        }
        let solve = |case: &Case| Question::of(case.model()).solve(&Settings::default()).ok();
        let base = solve(case)?;
        let (against, (from, to)) = (Estimate::against(&base), base.task().limits());
        let times: Vec<f64> = (0..=SAMPLES)
            .map(|sample| from + (to - from) * sample as f64 / SAMPLES as f64)
            .collect();
        let differs = |other: &Motion| {
            let moving = against.largest(other, subjects, &times);
            (moving, against.measures(other, &other.measures()))
        };
        let unknown = || (vec![f64::NAN; subjects.len()], vec![f64::NAN; base.measures().len()]);
        let each = made.iter().map(|&index| {
            let one = &constants.scene.constants[index];
            let mut values = constants.values.clone();
            let distribution = one.distribution.about(one.tolerance, values[index]);
            values[index] += one.tolerance * distribution.deviation();
            let other = Case::new(constants.with_values(&values)).ok();
            let other = other.and_then(|other| solve(&other));
            other.as_ref().map_or_else(unknown, differs)
        });
        let each: Vec<_> = each.collect();
        let root = |of: &dyn Fn(usize) -> Vec<f64>| {
            let mut sums = vec![0.0; of(0).len()];
            for index in 0..each.len() {
                for (sum, one) in sums.iter_mut().zip(of(index)) {
                    *sum += one * one;
                }
            }
            sums.into_iter().map(f64::sqrt).collect()
        };
        Some(Self {
            names: made
                .iter()
                .map(|&index| constants.scene.constants[index].quantity.name)
                .collect(),
            subjects: root(&|index| each[index].0.clone()),
            measures: root(&|index| each[index].1.clone()),
        })
    }
}
