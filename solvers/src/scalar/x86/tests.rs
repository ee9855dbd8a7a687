//! Packs against single numbers, bit for bit.

use super::*;
use crate::dispatch::{Task, dispatch_packs, is_fused};

/// Numbers of every size and sign, and what is none.
const NUMBERS: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.3,
    -2.5,
    7.25e-12,
    -3.0e7,
    1e-300,
    5e-324,
    f64::MAX,
    -f64::MIN_POSITIVE,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    123_456.7,
];

/// What a number type gives of three numbers: operations, comparisons, functions.
fn all<S: Pack>([a, b, c]: [S; 3]) -> Vec<S> {
    let truth = |mask| S::select(mask, S::ONE, S::ZERO);
    let ([sine, other], [cosine, _]) = S::sin_cos_all([a, b]);
    let both = S::and(S::less(a, b), S::not(S::less_equal(b, c)));
    vec![
        a + b,
        a - b,
        a * b,
        a / b,
        -a,
        a.mul_add(b, c),
        truth(S::less(a, b)),
        truth(S::less_equal(a, b)),
        truth(S::equal(a, b)),
        truth(S::or(both, S::equal(c, c))),
        S::select(S::less(a, b), b, c),
        sine,
        cosine,
        other,
        S::atan2(a, b),
        a.sqrt(),
        a.floor(),
        a.abs(),
        a.sign(),
        a.max(b),
        a.min(b),
        a.hypot(b),
        a.powf(b),
        a.tan(),
        a.exp(),
        a.ln(),
        a.erf(),
        a.normal_cdf(),
        S::root("x", |x| x - S::from_f64(0.25)) + c,
    ]
}

struct Same;

impl Task for Same {
    type Output = ();

    fn run<P: Pack>(self) {
        for first in 0..NUMBERS.len() {
            for second in 0..NUMBERS.len() {
                let lists = [1, 3, 5].map(|stride| {
                    let at = |lane: usize| first * stride + second + lane * stride;
                    std::array::from_fn::<f64, WIDTH, _>(|lane| NUMBERS[at(lane) % 16])
                });
                let packs = all(lists.map(|list| P::load(&list)));
                for lane in 0..P::WIDTH {
                    let single = all(lists.map(|list| Fused(list[lane])));
                    for (place, (pack, single)) in packs.iter().zip(single).enumerate() {
                        let mut found = [0.0; WIDTH];
                        pack.store(&mut found);
                        let same = found[lane].to_bits() == single.0.to_bits();
                        let none = found[lane].is_nan() && single.0.is_nan();
                        let numbers = lists.map(|list| list[lane]);
                        assert!(same || none, "{place} of {numbers:?}: {} {single:?}", found[lane]);
                    }
                }
            }
        }
    }
}

#[test]
fn each_lane_is_a_number_by_itself() {
    if is_fused() {
        dispatch_packs(Same);
    }
}

struct Anywhere;

impl Task for Anywhere {
    type Output = [bool; 3];

    fn run<P: Pack>(self) -> [bool; 3] {
        let place = P::load(&[9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 1.0]);
        let low = P::less(place, P::from_f64(5.0));
        [P::holds(low), P::any(low), P::any(P::and(low, P::not(low)))]
    }
}

#[test]
fn masks_are_asked_in_any_lane() {
    if is_fused() {
        assert_eq!(dispatch_packs(Anywhere), [false, true, false]);
    }
}
