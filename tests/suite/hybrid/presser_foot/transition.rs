//! The transition of the straight path that presses most at its least.

use super::*;

fn smallest(q: [f64; 3]) -> f64 {
    let foot = Straight::with(&[("q1", q[0]), ("q2", q[1]), ("q3", q[2])]);
    let cycle = foot.cycle().unwrap();
    assert_eq!(cycle.multiple, 1);
    Measured::of(&foot, &cycle.motion).smallest
}

fn best() -> [f64; 3] {
    let found = numbers(&REFERENCE["transition"]["q"]);
    [found[0], found[1], found[2]]
}

/// The second computation has it from a linear programme: without separation the force depends linearly on the shape.
#[test]
fn the_best_transition_is_that_of_the_linear_programme() {
    let case = &REFERENCE["transition"];
    let (before, after) = (smallest([0.0; 3]), smallest(best()));
    assert!((before - number(&case["before"])).abs() < 1e-9, "{before}");
    assert!((after - number(&case["smallest"])).abs() < 1e-8, "{after}");
    let ellipse = Elliptic::with(&[("rise", 5e-4)]);
    let ellipse = Measured::of(&ellipse, &ellipse.cycle().unwrap().motion).smallest;
    assert!(after > 1.9 * ellipse && ellipse > before, "{ellipse}");
}

/// In every direction the force is smaller, and falls off the faster the further away: a smallest force is concave.
#[test]
fn no_neighbour_presses_more() {
    let (best, most) = (best(), smallest(best()));
    for place in 0..27 {
        let direction = [place / 9, place / 3 % 3, place % 3].map(|k| f64::from(k) - 1.0);
        if direction == [0.0; 3] {
            continue;
        }
        let at = |size: f64| smallest(std::array::from_fn(|i| best[i] + size * direction[i]));
        let lost = [1e-3, 1e-2].map(|size| (most - at(size)) / size);
        assert!(lost[0] > 0.0 && lost[1] > lost[0] - 1e-6, "{direction:?} {lost:?}");
    }
}
