//! Masses that are bound by closures, some of which may depend on others.
//!
//! The system is `[A Jᵀ; J 0] (w, μ) = (b, c)`. The closures `J w = c` are factored with complete pivoting, which finds how
//! many of them are independent and which unknowns they determine best: `w = w₀ + Z a`, `J Z = 0`. What is left are the
//! equations of the free motion, `Zᵀ A Z a = Zᵀ (b - A w₀)`, and the forces `Jᵀ μ = b - A w`. A closure that follows from
//! others is left out, and its force is zero.
//!
//! Where closures become dependent for an instant, `uᵀ J = 0`, they say nothing over nothing of the accelerations in that
//! direction. What they say is then their next time derivative, `uᵀ (K w - d) = 0`, `K = 3 J'`: the motion goes on along
//! the branch on which it is.
//!
//! This is the null space method by LU factors: M. Benzi, G. H. Golub, J. Liesen: *Numerical solution of saddle point
//! problems*, Acta Numerica 14 (2005), section 6.

mod parts;

use super::Factored;
use crate::scalar::Scalar;
pub use parts::Parts;

/// Below this a pivot of closures is none, their rows being of size one: they follow from the others, for an instant at
/// least. A smaller limit would divide rounding by next to nothing, a larger one take what holds for an instant for longer.
const NOTHING: f64 = 1e-4;

/// The matrix of a bound system, factored: of so many unknowns, bound by closures of which at most a number is independent.
#[derive(Clone, Copy, Debug)]
pub struct Bound<S, const N: usize, const UNKNOWNS: usize, const RANK: usize> {
    parts: Parts,
    factors: [[S; UNKNOWNS]; N],
    reduced: [[S; N]; UNKNOWNS],
    rows: [usize; N],
    columns: [usize; N],
}

/// Factors a bound system of so many unknowns: masses, closures, and behind these what they say next, which `write` puts into
/// rows of zeros; of the masses it writes the lower triangle. At most `RANK` closures are independent.
///
/// Unknowns that nothing determines, such as those without mass, give infinite or NaN solutions, never a panic.
#[inline(always)]
pub fn factor_bound<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize>(
    write: impl FnOnce(&mut [[S; UNKNOWNS]; N]),
) -> Bound<S, N, UNKNOWNS, RANK> {
    let (unknowns, rank) = (UNKNOWNS, RANK);
    let mut bound = Bound {
        parts: Parts { unknowns, closures: (N - unknowns) / 2, rank, lasting: Some(0) },
        factors: [[S::ZERO; UNKNOWNS]; N],
        reduced: [[S::ZERO; N]; UNKNOWNS],
        rows: [0; N],
        columns: [0; N],
    };
    write(&mut bound.factors);
    for row in 0..unknowns {
        for column in 0..row {
            bound.factors[column][row] = bound.factors[row][column];
        }
    }
    let (factors, reduced) = (bound.factors.as_flattened_mut(), bound.reduced.as_flattened_mut());
    bound.parts.factor(factors, reduced, (&mut bound.rows, &mut bound.columns), NOTHING);
    bound
}

impl<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize> Factored<S, N>
    for Bound<S, N, UNKNOWNS, RANK>
{
    #[inline(always)]
    fn of(matrix: [[S; N]; N]) -> Self {
        factor_bound(|own| {
            for (own, row) in own.iter_mut().zip(&matrix) {
                own.copy_from_slice(&row[..UNKNOWNS]);
            }
        })
    }

    #[inline(always)]
    fn solution(&self, right: [S; N]) -> [S; N] {
        self.solve(right)
    }
}

impl<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize>
    Bound<S, N, UNKNOWNS, RANK>
{
    /// Solves for `w` and `μ`, one behind the other, and forces of what closures say next.
    #[inline(always)]
    pub fn solve(&self, right: [S; N]) -> [S; N] {
        let (mut solution, mut room) = (right, [S::ZERO; N]);
        let (factors, reduced) = (self.factors.as_flattened(), self.reduced.as_flattened());
        let order = (&self.rows[..], &self.columns[..]);
        self.parts.solve(factors, reduced, order, (&mut solution, &mut room));
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Masses of three points on a line, one of them none, with closures of which the last is the sum of the others.
    fn chain<const RANK: usize>() -> Bound<f64, 9, 3, RANK> {
        factor_bound::<f64, 9, 3, RANK>(|matrix| {
            [matrix[0][0], matrix[1][0], matrix[2][2]] = [2.0, 0.5, 3.0];
            matrix[3] = [1.0, -2.0, 0.0];
            matrix[4] = [0.0, 1.0, 1.0];
            matrix[5] = [1.0, -1.0, 1.0];
        })
    }

    #[test]
    fn dependent_closures_are_left_out() {
        let bound = chain::<3>();
        assert_eq!(bound.parts.rank, 2);
        // w = (2 s + 1, s, 2 - s): along (2, 1, -1) the mass is 8 + 2 + 3.
        let found = bound.solve([1.0, 2.0, 3.0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0]);
        let [x, y, z] = [found[0], found[1], found[2]];
        assert!((x - 2.0 * y - 1.0).abs() < 1e-15 && (y + z - 2.0).abs() < 1e-15);
        let rest = [1.0 - 2.0 * x - 0.5 * y, 2.0 - 0.5 * x, 3.0 - 3.0 * z];
        assert!((2.0 * rest[0] + rest[1] - rest[2]).abs() < 1e-14, "{rest:?}");
        let forces = &found[3..];
        let on = [
            forces[0] + forces[2],
            -2.0 * forces[0] + forces[1] - forces[2],
            forces[1] + forces[2],
        ];
        for (on, rest) in on.iter().zip(rest) {
            assert!((on - rest).abs() < 1e-14, "{on} {rest}");
        }
    }

    #[test]
    fn fewer_closures_can_be_asked_for() {
        assert_eq!(chain::<1>().parts.rank, 1);
    }

    #[test]
    fn a_freedom_without_mass_has_no_solution() {
        let bound = factor_bound::<f64, 4, 2, 1>(|matrix| {
            (matrix[0][0], matrix[2][0]) = (1.0, 1.0);
        });
        assert!(!bound.solve([1.0, 1.0, 0.0, 0.0])[1].is_finite());
    }

    /// Two unknowns of unit mass on the crossing lines `y (y - 2 x) = 0`, bound besides by `x + z = 0`: near the crossing, on
    /// the line `y = 0`, the acceleration across it is zero whatever the forces.
    #[test]
    fn what_closures_say_next_counts_where_they_say_nothing() {
        for distance in [1e-2, 1e-6, 0.0] {
            let (x, speed) = (distance, 3.0);
            let bound = factor_bound::<f64, 7, 3, 2>(|matrix| {
                (matrix[0][0], matrix[1][1], matrix[2][2]) = (1.0, 1.0, 1.0);
                matrix[3] = [0.0, -2.0 * x, 0.0];
                matrix[4] = [1.0, 0.0, 1.0];
                matrix[5] = [0.0, -6.0 * speed, 0.0];
            });
            let found = bound.solve([1.0, 5.0, 3.0, 0.0, 0.5, 0.0, 0.0]);
            assert!(found[1].abs() < 1e-15, "{found:?}");
            assert!((found[0] + found[2] - 0.5).abs() < 1e-15);
            assert!((found[0] - 1.0 - (found[2] - 3.0)).abs() < 1e-15, "{found:?}");
        }
    }
}
