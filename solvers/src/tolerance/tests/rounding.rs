//! How far numbers may be off by rounding.

use super::super::Random;
use super::super::made::nominal::Nominal;
use super::super::order::influence::influences_of;
use super::super::order::rounding::{HALF_PLACE, rounding_of};
use super::Heald;
use crate::closure::AnyLinkage;
use crate::closure::tests::linkages::FourBar;

/// Values that are off by many last places, to either side, move numbers by as many times what is told in the mean square.
fn check(linkage: &dyn AnyLinkage, degrees: f64) {
    const UNITS: f64 = 1e5;
    const TRIES: u32 = 400;
    let place = vec![degrees.to_radians()];
    let told = rounding_of(linkage, &place, true).expect("it gets there");
    let all = |linkage: &dyn AnyLinkage, place: &[f64]| -> Vec<f64> {
        let nominals = Nominal::along(linkage, &[place.to_vec()], &[]).expect("it gets there");
        let dependents = nominals[0].stand().position[..told.dependents.len()].to_vec();
        let influence = (0..told.outputs.len()).flat_map(|output| {
            let found = influences_of(linkage, output, &[place.to_vec()]).expect("it gets there");
            found.at(0).to_vec()
        });
        [dependents, nominals[0].outputs.clone(), influence.collect()].concat()
    };
    let base = all(linkage, &place);
    let own = told.dependents.len() + told.outputs.len();
    let told = [&told.dependents[..], &told.outputs, &told.influence].concat();
    let mut random = Random::new(7, 0);
    let mut off = |value: &f64| {
        let sign = (random.uniform() - 0.5).signum();
        value * (1.0 + sign * UNITS * HALF_PLACE)
    };
    let mut squares = vec![0.0; base.len()];
    for _ in 0..TRIES {
        let values: Vec<f64> = linkage.values().iter().map(&mut off).collect();
        let other = linkage.with_values(&values);
        let moved = all(&*other, &[off(&place[0])]);
        for ((sum, moved), base) in squares.iter_mut().zip(&moved).zip(&base) {
            *sum += ((moved - base) / UNITS).powi(2);
        }
    }
    for (index, ((sum, told), base)) in squares.iter().zip(&told).zip(&base).enumerate() {
        // The last place of positions and outputs themselves is told as well.
        let last = if index < own { HALF_PLACE * base } else { 0.0 };
        let told = (told.powi(2) - last.powi(2)).sqrt();
        if index >= own && told <= 1e-3 * HALF_PLACE * base.abs() {
            // The same for all values.
            continue;
        }
        let share = (sum / f64::from(TRIES)).sqrt() / told;
        assert!((0.85..1.15).contains(&share), "{degrees} deg, {index}: {share} of {told:e}");
    }
}

#[test]
fn values_off_in_their_last_places_move_numbers_by_what_is_told() {
    for degrees in [60.0, 90.0, 200.0, 220.1] {
        check(&Heald::default(), degrees);
    }
    let brink = FourBar::new([0.025, 0.065, 0.06, 0.0999], 1.0, [0.5, 1.5]);
    for degrees in [10.0, 120.0, 179.9] {
        check(&brink, degrees);
    }
}

/// Beside a dead point numbers are known far worse than to their last place.
#[test]
fn it_grows_beside_a_dead_point() {
    let brink = FourBar::new([0.025, 0.065, 0.06, 0.1], 1.0, [0.5, 1.5]);
    let at = |degrees: f64| {
        let place = [degrees.to_radians()];
        rounding_of(&brink, &place, false).expect("it gets there").dependents[0]
    };
    let (usual, beside) = (at(90.0), at(179.99));
    assert!(beside > 100.0 * usual, "{usual:e} {beside:e}");
}
