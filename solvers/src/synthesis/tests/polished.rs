//! Polishing, on problems whose best is known.

use super::super::*;

/// A function that gives values, conditions and rows of slopes.
struct Problem<F> {
    sought: Vec<Sought>,
    look: F,
}

impl<F: FnMut(&[f64]) -> (Vec<f64>, Vec<f64>, Vec<f64>)> Local for Problem<F> {
    fn sought(&self) -> &[Sought] {
        &self.sought
    }

    fn look(&mut self, design: &[f64]) -> Option<Look> {
        let (values, conditions, slopes) = (self.look)(design);
        Some(Look { values, conditions, slopes })
    }
}

/// A polished design with what holds it.
fn certified(
    sought: Vec<Sought>,
    aim: Aim,
    from: &[f64],
    look: impl FnMut(&[f64]) -> (Vec<f64>, Vec<f64>, Vec<f64>),
) -> (Polished, Certificate) {
    let mut problem = Problem { sought, look };
    let found = polish(&mut problem, aim, from, 300).expect("it can be judged");
    assert_eq!(found.end, End::Settled, "{found:?}");
    let certificate = certify(&mut problem, aim, &found).expect("it can be judged");
    (found, certificate)
}

/// Of all polynomials `x^5 + …` Chebyshev's deviates least from zero, by 1/16, at six points with alternating signs.
#[test]
fn the_polynomial_that_deviates_least() {
    let points: Vec<f64> =
        (0..=400).map(|k| (k as f64 / 400.0 * std::f64::consts::PI).cos()).collect();
    let look = |c: &[f64]| {
        let (mut values, mut slopes) = (Vec::new(), Vec::new());
        for (sign, x) in
            [1.0, -1.0].into_iter().flat_map(|sign| points.iter().map(move |x| (sign, x)))
        {
            let powers = [1.0, *x, x.powi(2), x.powi(3), x.powi(4)];
            values.push(sign * (x.powi(5) + powers.iter().zip(c).map(|(p, c)| p * c).sum::<f64>()));
            slopes.extend(powers.map(|power| sign * power));
        }
        (values, Vec::new(), slopes)
    };
    let (found, held) =
        certified(vec![Sought::between(-3.0, 3.0); 5], Aim::LARGEST, &[0.1; 5], look);
    // Six places hold five numbers in all directions.
    assert_eq!((held.values.len(), held.free, held.curvature), (6, 0, None));
    assert!((16.0 * found.value - 1.0).abs() < 1e-9, "{found:?}");
    for (found, expected) in found.design.iter().zip([0.0, 5.0 / 16.0, 0.0, -1.25, 0.0]) {
        assert!((found - expected).abs() < 1e-7, "{found} {expected}");
    }
    let held: Vec<_> = found.multipliers.iter().filter(|one| **one > 1e-6).collect();
    assert_eq!(held.len(), 6);
    assert!((held.into_iter().sum::<f64>() - 1.0).abs() < 1e-6);
    assert!(found.slope < 1e-7);
}

/// CB2 of Charalambous and Bandler (1976): three functions of two numbers, of which two meet in a valley that bends.
#[test]
fn where_fewer_values_meet_than_there_are_numbers_and_one() {
    let look = |x: &[f64]| {
        let power = 2.0 * (x[1] - x[0]).exp();
        let values =
            vec![x[0].powi(2) + x[1].powi(4), (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2), power];
        let slopes = vec![
            2.0 * x[0],
            4.0 * x[1].powi(3),
            2.0 * (x[0] - 2.0),
            2.0 * (x[1] - 2.0),
            -power,
            power,
        ];
        (values, Vec::new(), slopes)
    };
    let (found, held) =
        certified(vec![Sought::between(-10.0, 10.0); 2], Aim::LARGEST, &[2.0, 2.0], look);
    assert_eq!((held.values.len(), held.free), (2, 1));
    assert!(held.curvature.is_some_and(|curvature| curvature > 1.0), "{held:?}");
    assert!((found.value - 1.952_224_493_8).abs() < 1e-9, "{found:?}");
    assert!((found.design[0] - 1.139_037_7).abs() < 1e-5, "{found:?}");
}

/// Rosen and Suzuki (1965): the best lies at (0, 1, 2, -1), with multipliers 1, 0, 2.
#[test]
fn conditions_hold_with_their_multipliers() {
    let look = |x: &[f64]| {
        let value = x[0].powi(2) + x[1].powi(2) + 2.0 * x[2].powi(2) + x[3].powi(2)
            - 5.0 * x[0]
            - 5.0 * x[1]
            - 21.0 * x[2]
            + 7.0 * x[3];
        let conditions = vec![
            8.0 - x.iter().map(|x| x * x).sum::<f64>() - x[0] + x[1] - x[2] + x[3],
            10.0 - x[0].powi(2) - 2.0 * x[1].powi(2) - x[2].powi(2) - 2.0 * x[3].powi(2)
                + x[0]
                + x[3],
            5.0 - 2.0 * x[0].powi(2) - x[1].powi(2) - x[2].powi(2) - 2.0 * x[0] + x[1] + x[3],
        ];
        let slopes = [
            [2.0 * x[0] - 5.0, 2.0 * x[1] - 5.0, 4.0 * x[2] - 21.0, 2.0 * x[3] + 7.0],
            [-2.0 * x[0] - 1.0, -2.0 * x[1] + 1.0, -2.0 * x[2] - 1.0, -2.0 * x[3] + 1.0],
            [-2.0 * x[0] + 1.0, -4.0 * x[1], -2.0 * x[2], -4.0 * x[3] + 1.0],
            [-4.0 * x[0] - 2.0, -2.0 * x[1] + 1.0, -2.0 * x[2], 1.0],
        ];
        (vec![value], conditions, slopes.concat())
    };
    for from in [[0.0; 4], [3.0, -2.0, 4.0, 1.0]] {
        let (found, held) =
            certified(vec![Sought::between(-10.0, 10.0); 4], Aim::LARGEST, &from, look);
        let conditions: Vec<usize> = held.conditions.iter().map(|one| one.0).collect();
        assert_eq!((conditions, held.free), (vec![0, 2], 2));
        assert!(held.curvature.is_some_and(|curvature| curvature > 1.0), "{held:?}");
        assert!((found.value + 44.0).abs() < 1e-8 && found.missed < 1e-9, "{found:?}");
        for (found, expected) in found.design.iter().zip([0.0, 1.0, 2.0, -1.0]) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
        for (found, expected) in found.multipliers.iter().zip([1.0, 1.0, 0.0, 2.0]) {
            assert!((found - expected).abs() < 1e-3, "{found} {expected}");
        }
    }
}

/// Rosenbrock's valley, once by its two squares and once as the number that they add up to: that one learns slowly how the valley
/// bends, and where it ends nothing is left that slopes could tell.
#[test]
fn squares_tell_more_than_their_sum() {
    let sought = || vec![Sought::between(-2.0, 2.0); 2];
    let parts =
        |x: &[f64]| ([10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]], [-20.0 * x[0], 10.0, -1.0, 0.0]);
    let from = [-1.2, 1.0];
    let (found, held) = certified(sought(), Aim { squares: 2 }, &from, |x| {
        let (values, slopes) = parts(x);
        (values.to_vec(), Vec::new(), slopes.to_vec())
    });
    assert!(found.design.iter().all(|one| (one - 1.0).abs() < 1e-12), "{found:?}");
    assert!(held.free == 2 && held.curvature.is_some_and(|one| one > 0.0), "{held:?}");
    let whole = |x: &[f64]| {
        let ([a, b], slopes) = parts(x);
        let value = 0.5 * (a * a + b * b);
        (vec![value], Vec::new(), vec![a * slopes[0] + b * slopes[2], a * slopes[1]])
    };
    let mut problem = Problem { sought: sought(), look: whole };
    let whole = polish(&mut problem, Aim::LARGEST, &from, 300).expect("it can be judged");
    assert!(found.looks * 2 < whole.looks, "{} {}", found.looks, whole.looks);
}

/// `|x - 1| + (x - 3)²/2` is least at 2.
#[test]
fn the_largest_of_some_and_squares_of_others() {
    let look = |x: &[f64]| {
        let x = x[0];
        (vec![x - 1.0, 1.0 - x, x - 3.0], Vec::new(), vec![1.0, -1.0, 1.0])
    };
    let (found, _) = certified(vec![Sought::between(0.0, 10.0)], Aim { squares: 1 }, &[9.0], look);
    assert!((found.design[0] - 2.0).abs() < 1e-6, "{found:?}");
    assert!((found.value - 1.5).abs() < 1e-12, "{found:?}");
    // Of fewer values all count by their squares: 3 (x - 5/3)²/2 and more.
    let (found, _) = certified(vec![Sought::between(0.0, 10.0)], Aim { squares: 9 }, &[9.0], look);
    assert!((found.design[0] - 5.0 / 3.0).abs() < 1e-6, "{found:?}");
}

/// The kinetics of Kowalik and Osborne (1968), least squares whose rest is not zero.
#[test]
fn least_squares() {
    const Y: [f64; 11] =
        [0.1957, 0.1947, 0.1735, 0.16, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246];
    const U: [f64; 11] = [4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625];
    let look = |x: &[f64]| {
        let (mut values, mut slopes) = (Vec::new(), Vec::new());
        for (y, u) in Y.iter().zip(U) {
            let (top, base) = (u * u + u * x[1], u * u + u * x[2] + x[3]);
            values.push(x[0] * top / base - y);
            let factor = -x[0] * top / (base * base);
            slopes.extend([top / base, x[0] * u / base, factor * u, factor]);
        }
        (values, Vec::new(), slopes)
    };
    let from = [0.25, 0.39, 0.415, 0.39];
    let (found, held) =
        certified(vec![Sought::between(-1.0, 1.0); 4], Aim { squares: Y.len() }, &from, look);
    assert_eq!((held.values.len(), held.free), (0, 4));
    assert!(held.curvature.is_some_and(|curvature| curvature > 0.0), "{held:?}");
    assert!((2.0 * found.value / 3.075_056_038_492e-4 - 1.0).abs() < 1e-9, "{found:?}");
}

/// Bounds hold a design, and say what lies beyond them.
#[test]
fn at_a_bound() {
    let look = |x: &[f64]| {
        (
            vec![(x[0] - 2.0).powi(2) + x[1].powi(2)],
            Vec::new(),
            vec![2.0 * (x[0] - 2.0), 2.0 * x[1]],
        )
    };
    let sought = vec![Sought::between(-1.0, 1.0), Sought::between(-1.0, 1.0)];
    let (found, held) = certified(sought, Aim::LARGEST, &[-0.5, 0.7], look);
    // Along the bound `y²` curves, over a range of 2.
    assert_eq!((held.bounds.len(), held.bounds[0].0, held.free), (1, 0, 1));
    assert!((held.curvature.expect("one direction is free") - 8.0).abs() < 1e-3);
    assert!((found.design[0] - 1.0).abs() < 1e-12 && found.design[1].abs() < 1e-6, "{found:?}");
    assert!((found.bounds[0] - 4.0).abs() < 1e-3 && found.bounds[1].abs() < 1e-3, "{found:?}");
}

/// Nothing is gained to first order where a saddle is level, but it is no best design.
#[test]
fn a_saddle_is_told() {
    let look =
        |x: &[f64]| (vec![x[0].powi(2) - x[1].powi(2)], Vec::new(), vec![2.0 * x[0], -2.0 * x[1]]);
    let sought = vec![Sought::between(-1.0, 1.0), Sought::between(-1.0, 1.0)];
    let (found, held) = certified(sought, Aim::LARGEST, &[0.5, 0.0], look);
    assert!(found.design.iter().all(|one| one.abs() < 1e-6), "{found:?}");
    assert!((held.curvature.expect("both directions are free") + 8.0).abs() < 1e-3, "{held:?}");
    assert!(held.direction[0].abs() < 1e-6 && (held.direction[1].abs() - 1.0).abs() < 1e-6);
}

/// Slopes that are not those of the values are no reason to go on for ever, nor to say that this is the best.
#[test]
fn wrong_slopes_are_told() {
    let look = |x: &[f64]| (vec![x[0].powi(2)], Vec::new(), vec![-2.0 * x[0]]);
    let sought = vec![Sought::between(-1.0, 1.0)];
    let found = polish(&mut Problem { sought, look }, Aim::LARGEST, &[0.5], 300).expect("judged");
    assert_eq!(found.end, End::Stuck, "{found:?}");
}

#[test]
fn what_cannot_be_judged_is_refused() {
    let look = |_: &[f64]| (vec![f64::NAN], Vec::new(), vec![1.0]);
    let sought = vec![Sought::between(-1.0, 1.0)];
    let mut problem = Problem { sought, look };
    let found = polish(&mut problem, Aim::LARGEST, &[0.5], 300);
    assert_eq!(found.unwrap_err(), SynthesisError::NotJudged);
    let found = polish(&mut problem, Aim::LARGEST, &[0.5, 0.5], 300);
    assert_eq!(found.unwrap_err(), SynthesisError::OtherProblem { found: 2, expected: 1 });
    // A row of slopes is missing.
    let look = |_: &[f64]| (vec![1.0, 2.0], Vec::new(), vec![1.0]);
    let mut problem = Problem { sought: vec![Sought::between(-1.0, 1.0)], look };
    let found = polish(&mut problem, Aim::LARGEST, &[0.5], 300);
    assert_eq!(found.unwrap_err(), SynthesisError::NotJudged);
}

/// The seventh-degree cam law of the least peak acceleration, between wide bounds: three extremes, two of which are alike, hold
/// two numbers in one direction, and along the other one the valley is flat beside how steep its sides are.
#[test]
fn a_flat_valley_between_wide_bounds_is_followed_to_its_end() {
    let look = |c: &[f64]| {
        let second = -(1.0 + 4.0 * c[0] + 6.0 * c[1]) / 2.0;
        let (third, fourth) = (60.0 * c[0], 210.0 * c[1]);
        // Where 6 c2 + 60 c3 x² + 210 c4 x⁴ is zero.
        let root = (third * third - 4.0 * fourth * 6.0 * second).max(0.0).sqrt();
        let squares = [-1.0, 1.0].map(|sign| (-third + sign * root) / (2.0 * fourth));
        let places = squares.map(|square| square.clamp(0.0, 1.0).sqrt());
        let (mut values, mut slopes) = (Vec::new(), Vec::new());
        for (x, sign) in [places[0], places[1], 1.0, -places[0], -places[1], -1.0]
            .into_iter()
            .flat_map(|x| [(x, 1.0), (x, -1.0)])
        {
            let (cube, fifth) = (x.powi(3), x.powi(5));
            values.push(sign * 2.0 * (6.0 * second * x + 20.0 * c[0] * cube + 42.0 * c[1] * fifth));
            slopes.push(sign * 2.0 * (-12.0 * x + 20.0 * cube));
            slopes.push(sign * 2.0 * (-18.0 * x + 42.0 * fifth));
        }
        (values, Vec::new(), slopes)
    };
    for from in [[0.336_155_582_7, -0.078_341_529_26], [0.4, -0.1], [3.0, -1.0]] {
        let (found, held) =
            certified(vec![Sought::between(-200.0, 200.0); 2], Aim::LARGEST, &from, look);
        // By a simplex method, each extreme from the roots of the polynomial.
        assert!((found.value - 4.381_904_404_688_14).abs() < 1e-11, "{found:?}");
        assert_eq!(held.free, 1, "{held:?}");
        assert!(held.curvature.is_some_and(|one| one > 0.0), "{held:?}");
    }
}
