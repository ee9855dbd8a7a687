//! Angles of made linkages, counted from those of the nominal one over whole turns.

use crate::scalar::Scalar;
use crate::shape::LinkageEntry;
use std::f64::consts::TAU;

/// Largest tangent of which the angle is taken from its series.
const SMALL: f64 = 1.0 / 16.0;
/// Terms of `(atan t - t)/t^3` in powers of `t^2`, the last one first: the next one is below half a unit in the last place.
const SERIES: [f64; 6] = [1.0 / 13.0, -1.0 / 11.0, 1.0 / 9.0, -1.0 / 7.0, 1.0 / 5.0, -1.0 / 3.0];

/// Puts the angles of a group within half a turn of others, as [`unwrap`] does: where their cosines and sines are known, by
/// what they turn from there, which is little. The angles themselves are then not needed.
#[inline(always)]
pub(super) fn near<S: Scalar>(entry: &LinkageEntry, group: usize, position: &mut [S], near: &[S]) {
    for &j in entry.groups[group].unknowns {
        if !entry.angles[j] {
            continue;
        }
        position[j] = match entry.cosines.get(j).copied().flatten() {
            Some(at) => {
                let [made, drawn] = [&position[at..at + 2], &near[at..at + 2]];
                near[j] + turned([drawn[0], drawn[1]], [made[0], made[1]])
            }
            None => unwrapped(position[j], near[j]),
        };
    }
}

/// The angle by which a direction is turned against another; both have length one, cosine first.
#[inline(always)]
fn turned<S: Scalar>(from: [S; 2], to: [S; 2]) -> S {
    let along = from[0].mul_add(to[0], from[1] * to[1]);
    let across = from[0].mul_add(to[1], -(from[1] * to[0]));
    let tangent = across / along;
    let square = tangent * tangent;
    let mut sum = S::from_f64(SERIES[0]);
    for term in &SERIES[1..] {
        sum = sum.mul_add(square, S::from_f64(*term));
    }
    let turned = (tangent * square).mul_add(sum, tangent);
    // Of no direction neither holds.
    let far = S::or(S::less(S::from_f64(SMALL), tangent.abs()), S::less(along, S::ZERO));
    if S::any(far) {
        return S::select(far, S::atan2(across, along), turned);
    }
    turned
}

/// Puts the angles of a group within half a turn of others.
#[inline(always)]
pub(super) fn unwrap<S: Scalar>(
    entry: &LinkageEntry,
    group: usize,
    position: &mut [S],
    near: &[S],
) {
    for &j in entry.groups[group].unknowns {
        if entry.angles[j] {
            position[j] = unwrapped(position[j], near[j]);
        }
    }
}

/// An angle within half a turn of another.
#[inline(always)]
fn unwrapped<S: Scalar>(angle: S, near: S) -> S {
    let turns = (near - angle).mul_add(S::from_f64(1.0 / TAU), S::from_f64(0.5)).floor();
    turns.mul_add(S::from_f64(TAU), angle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn direction(angle: f64) -> [f64; 2] {
        [angle.cos(), angle.sin()]
    }

    #[test]
    fn small_and_large_turns_are_those_of_the_arc_tangent() {
        for from in [0.0, 1.0, -2.5, 3.1] {
            for by in [0.0, 1e-12, -1e-3, 0.0624, 0.0626, -0.7, 1.6, -2.9, 3.1] {
                let found = turned(direction(from), direction(from + by));
                assert!((found - by).abs() < 5e-16, "{from} {by}: {found}");
            }
        }
        // By half a turn it is one or the other way round.
        assert!((turned(direction(0.3), direction(0.3 + PI)).abs() - PI).abs() < 5e-16);
    }

    #[test]
    fn the_series_ends_where_it_rounds() {
        let tangent = SMALL.next_down();
        let found = turned([1.0, 0.0], [1.0, tangent]);
        assert!((found / tangent.atan() - 1.0).abs() < 3e-16, "{found}");
    }

    #[test]
    fn no_direction_turns_by_no_angle() {
        assert!(turned([1.0, 0.0], [f64::NAN, f64::NAN]).is_nan());
    }

    #[test]
    fn angles_are_counted_over_whole_turns() {
        for turns in [-3.0, 0.0, 2.0] {
            let near = turns * TAU + 3.0;
            for apart in [-3.0, -0.1, 0.0, 2.0] {
                let wrapped = (near + apart).sin().atan2((near + apart).cos());
                assert!((unwrapped(wrapped, near) - near - apart).abs() < 1e-14);
            }
        }
    }
}
