//! Where a motion begins that may be begun in several places.
//!
//! A motion that repeats after `n` periods may be begun in each of them, and one that nothing drives anywhere. So that
//! two solutions of one problem can be compared at time 0, it begins where the first state is largest; the next state
//! decides between places where that is the same, and at last the mode.

/// Which of some places, each a mode and a state, the motion begins in. Values that differ by less than `alike` of the
/// sizes are the same.
pub(super) fn first(places: &[(usize, Vec<f64>)], sizes: &[f64], alike: f64) -> usize {
    let mut left: Vec<usize> = (0..places.len()).collect();
    for (state, size) in sizes.iter().enumerate() {
        let value = |place: &usize| places[*place].1[state];
        let largest = left.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
        left.retain(|place| value(place) >= largest - alike * size);
    }
    let lowest = left.into_iter().min_by_key(|place| places[*place].0);
    lowest.unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::first;

    #[track_caller]
    fn check(states: &[[f64; 2]], expected: usize) {
        let places: Vec<_> = states.iter().map(|state| (0, state.to_vec())).collect();
        assert_eq!(first(&places, &[1.0, 10.0], 1e-6), expected);
    }

    #[test]
    fn it_is_where_the_first_state_is_largest() {
        check(&[[0.1, 9.0], [0.3, 1.0], [0.2, 5.0]], 1);
    }

    #[test]
    fn rounding_does_not_decide_between_places_alike() {
        check(&[[0.3 + 1e-9, 1.0], [0.3, 2.0], [0.2, 5.0]], 1);
        check(&[[0.3, 1.0], [0.3 + 1e-9, 1.0 + 1e-7]], 0);
    }
}
