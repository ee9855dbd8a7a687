//! Equations of first order whose rest and vibrations are known.

use super::{Rest, RestError, of};
use crate::model::hand::Hand;

/// `y' = A (y - at)`, from zero.
fn linear<const N: usize>(matrix: [[f64; N]; N], at: [f64; N]) -> Result<Rest, RestError> {
    let rates = move |_: f64, y: [f64; N]| {
        matrix.map(|row| (0..N).map(|column| row[column] * (y[column] - at[column])).sum())
    };
    of(&Hand::new(rates, move |_, _| matrix), 0, &[0.0; N])
}

/// Whether `A v = λ v` for each vibration.
#[track_caller]
fn check_shapes<const N: usize>(matrix: [[f64; N]; N], rest: &Rest) {
    let size = matrix.as_flattened().iter().fold(0.0_f64, |most, one| most.max(one.abs()));
    for one in &rest.vibrations {
        for (row, own) in matrix.iter().zip(&one.shape) {
            let product = row.iter().zip(&one.shape).fold((0.0, 0.0), |sum, (entry, shape)| {
                (sum.0 + entry * shape.0, sum.1 + entry * shape.1)
            });
            let wanted =
                (one.rate * own.0 - one.angular * own.1, one.rate * own.1 + one.angular * own.0);
            let off = (product.0 - wanted.0).hypot(product.1 - wanted.1);
            assert!(off < 1e-7 * size, "{off:e} in {one:?}");
        }
    }
}

#[test]
fn vibrations_come_by_their_frequency_and_the_others_behind_them() {
    let matrix = [
        [-0.2, -3.0, 0.0, 0.0, 0.0],
        [3.0, -0.2, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.1, 2.0, 0.0],
        [0.0, 0.0, -2.0, 0.1, 0.0],
        [0.0, 0.0, 0.0, 0.0, -5.0],
    ];
    let rest = linear(matrix, [1.0, 2.0, 3.0, 4.0, 5.0]).expect("it rests");
    for (found, wanted) in rest.state.iter().zip([1.0, 2.0, 3.0, 4.0, 5.0]) {
        assert!((found - wanted).abs() < 1e-14, "{rest:?}");
    }
    let all: Vec<_> = rest.vibrations.iter().map(|one| (one.rate, one.angular)).collect();
    for (found, wanted) in all.iter().zip([(0.1, 2.0), (-0.2, 3.0), (-5.0, 0.0)]) {
        assert!((found.0 - wanted.0).hypot(found.1 - wanted.1) < 1e-13, "{all:?}");
    }
    let slowest = rest.vibration(1).expect("there are two");
    assert!((slowest.damping() + 0.1 / 0.1_f64.hypot(2.0)).abs() < 1e-14);
    assert_eq!(rest.growing(), Some(slowest));
    assert_eq!((rest.vibration(0), rest.vibration(3)), (None, None));
    check_shapes(matrix, &rest);
}

#[test]
fn whole_steps_of_newton_diverge_where_shortened_ones_come_to_rest() {
    let rates = |_: f64, y: [f64; 1]| [-y[0].atan()];
    let slopes = |_: f64, y: [f64; 1]| [[-1.0 / (1.0 + y[0] * y[0])]];
    let mut whole = [3.0];
    for _ in 0..6 {
        whole[0] -= rates(0.0, whole)[0] / slopes(0.0, whole)[0][0];
    }
    assert!(whole[0].abs() > 1e6, "{whole:?}");
    let rest = of(&Hand::new(rates, slopes), 0, &[3.0]).expect("it rests");
    assert!(rest.state[0].abs() < 1e-15 && rest.errors[0] < 1e-14, "{rest:?}");
    assert!((rest.vibrations[0].rate + 1.0).abs() < 1e-14);
}

#[test]
fn vibrations_of_one_frequency_have_shapes_of_their_own() {
    let matrix =
        [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [-4.0, 0.0, 0.0, 0.0], [0.0, -4.0, 0.0, 0.0]];
    let rest = linear(matrix, [0.5; 4]).expect("it rests");
    assert_eq!(rest.vibrations.len(), 2);
    check_shapes(matrix, &rest);
    let shapes = rest.vibrations.iter().map(|one| (one.shape[0], one.shape[1]));
    let [a, b] = <[_; 2]>::try_from(shapes.collect::<Vec<_>>()).expect("two");
    // a0 b1 - a1 b0
    let minor = (
        a.0.0 * b.1.0 - a.0.1 * b.1.1 - a.1.0 * b.0.0 + a.1.1 * b.0.1,
        a.0.0 * b.1.1 + a.0.1 * b.1.0 - a.1.0 * b.0.1 - a.1.1 * b.0.0,
    );
    assert!(minor.0.hypot(minor.1) > 0.1, "{rest:?}");
}

#[test]
fn random_equations_rest_where_they_do_and_their_shapes_are_theirs() {
    let mut seed = 7_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for _ in 0..200 {
        let matrix: [[f64; 6]; 6] = std::array::from_fn(|_| std::array::from_fn(|_| random()));
        let at: [f64; 6] = std::array::from_fn(|_| random());
        let rest = linear(matrix, at).expect("it rests");
        for ((found, wanted), error) in rest.state.iter().zip(at).zip(&rest.errors) {
            assert!((found - wanted).abs() <= *error + 1e-16, "{found} {wanted} {error:e}");
            assert!(*error < 1e-10, "{error:e}");
        }
        let count: usize =
            rest.vibrations.iter().map(|one| 1 + usize::from(one.angular > 0.0)).sum();
        assert_eq!(count, 6);
        check_shapes(matrix, &rest);
    }
}

#[test]
fn what_nothing_balances_is_named_and_what_nothing_holds_stays() {
    let falls = Hand::<1>::new(|_, _| [-9.81], |_, _| [[0.0]]);
    assert_eq!(of(&falls, 0, &[2.0]), Err(RestError::Unbalanced { name: "y", rate: -9.81 }));
    let pushed = linear([[-1.0, 1.0], [1.0, -1.0]], [0.0, 0.0]).expect("it rests");
    assert_eq!((pushed.free, pushed.state), (1, vec![0.0; 2]));
    let apart =
        Hand::<2>::new(|_, y| [y[1] - y[0] + 1.0, y[0] - y[1]], |_, _| [[-1.0, 1.0], [1.0, -1.0]]);
    assert!(matches!(of(&apart, 0, &[0.0; 2]), Err(RestError::Unbalanced { .. })));
}

#[test]
fn where_there_is_no_rest_what_is_left_is_told() {
    let never = Hand::<1>::new(|_, y| [1.0 + y[0] * y[0]], |_, y| [[2.0 * y[0]]]);
    let error = of(&never, 0, &[0.7]).expect_err("it never rests");
    assert!(
        matches!(error, RestError::Unsettled { name: "y", rate, .. } if rate >= 1.0),
        "{error}"
    );
    let nowhere = Hand::<1>::new(|_, y| [y[0].sqrt() - 1.0], |_, y| [[0.5 / y[0].sqrt()]]);
    assert!(matches!(of(&nowhere, 0, &[-1.0]), Err(RestError::Start { .. })));
    let rest = of(&nowhere, 0, &[9.0]).expect("it rests");
    assert!((rest.state[0] - 1.0).abs() < 1e-14, "{rest:?}");
}

#[test]
fn a_start_of_another_length_is_refused() {
    let error = of(&Hand::<1>::new(|_, y| y, |_, _| [[1.0]]), 0, &[0.0; 2]).expect_err("no");
    assert!(error.to_string().contains("a state has 1 components, not 2"), "{error}");
}
