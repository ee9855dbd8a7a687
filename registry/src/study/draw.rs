//! Values made at random.

use assur_solvers::shape::Constant;
use assur_solvers::tolerance::Random;

/// The values of made number `index`: those that have a tolerance are drawn from their distribution around the nominal
/// ones, SI units. The same seed and number give the same values.
pub fn drawn(constants: &[Constant], nominal: &[f64], seed: u64, index: usize) -> Vec<f64> {
    let toleranced = constants.iter().filter(|one| one.tolerance > 0.0).count();
    let mut random = Random::new(seed, (index * toleranced) as u64);
    let pairs = constants.iter().zip(nominal);
    pairs
        .map(|(constant, value)| match constant.tolerance > 0.0 {
            true => value + constant.tolerance * constant.distribution.quantile(random.uniform()),
            false => *value,
        })
        .collect()
}
