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
mod rows;
mod solution;

use super::Factored;
use crate::scalar::Scalar;
pub use parts::{Order, Parts, Scan, Writing};
pub use rows::BoundRows;
pub use solution::Reading;

/// Below this a pivot of closures is none, their rows being of size one: they follow from the others, for an instant at
/// least. A smaller limit would divide rounding by next to nothing, a larger one take what holds for an instant for longer.
const NOTHING: f64 = 3e-4;

/// The matrix of a bound system, factored: of so many unknowns, bound by closures of which at most a number is independent.
#[derive(Clone, Copy, Debug)]
pub struct Bound<S, const N: usize, const UNKNOWNS: usize, const RANK: usize> {
    parts: Parts,
    matrix: [[S; UNKNOWNS]; N],
    reduced: [[S; UNKNOWNS]; UNKNOWNS],
    lists: [[u16; UNKNOWNS]; N],
    lengths: [u16; N],
    rows: [u16; N],
    columns: [u16; UNKNOWNS],
    places: [u16; UNKNOWNS],
}

/// Factors a bound system of so many unknowns: masses, closures, and behind these what they say next, whose entries `write`
/// puts; of the masses those of the lower triangle. At most `RANK` closures are independent.
///
/// Unknowns that nothing determines, such as those without mass, give infinite or NaN solutions, never a panic.
#[inline(always)]
pub fn factor_bound<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize>(
    write: impl FnOnce(&mut Writing<'_, S>),
) -> Bound<S, N, UNKNOWNS, RANK> {
    let (unknowns, rank) = (UNKNOWNS, RANK);
    let (mut largest, mut first) = ([(0.0, 0); N], [0; UNKNOWNS]);
    let mut next = [[0; UNKNOWNS]; N];
    let mut bound = Bound {
        parts: Parts { unknowns, closures: (N - unknowns) / 2, rank, lasting: Some(0) },
        matrix: [[S::ZERO; UNKNOWNS]; N],
        reduced: [[S::ZERO; UNKNOWNS]; UNKNOWNS],
        lists: [[0; UNKNOWNS]; N],
        lengths: [0; N],
        rows: [0; N],
        columns: [0; UNKNOWNS],
        places: [0; UNKNOWNS],
    };
    let mut writing = Writing {
        parts: &mut bound.parts,
        matrix: bound.matrix.as_flattened_mut(),
        reduced: bound.reduced.as_flattened_mut(),
        order: Order {
            lists: bound.lists.as_flattened_mut(),
            lengths: &mut bound.lengths,
            rows: &mut bound.rows,
            columns: &mut bound.columns,
            places: &mut bound.places,
        },
        scan: Scan {
            largest: &mut largest[..(N - unknowns) / 2],
            first: &mut first,
            next: next.as_flattened_mut(),
        },
    };
    write(&mut writing);
    writing.factor(NOTHING);
    bound
}

impl<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize> Factored<S, N>
    for Bound<S, N, UNKNOWNS, RANK>
{
    #[inline(always)]
    fn of(matrix: [[S; N]; N]) -> Self {
        factor_bound(|own| {
            for (row, entries) in matrix.iter().enumerate() {
                let entries =
                    entries[..UNKNOWNS.min(if row < UNKNOWNS { row + 1 } else { N })].iter();
                for (column, entry) in entries.enumerate().filter(|one| one.1.to_f64() != 0.0) {
                    own.put(row, column, *entry);
                }
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
        let order = Order {
            lists: self.lists.as_flattened(),
            lengths: &self.lengths[..],
            rows: &self.rows[..],
            columns: &self.columns[..],
            places: &self.places[..],
        };
        let (matrix, reduced) = (self.matrix.as_flattened(), self.reduced.as_flattened());
        Reading { parts: &self.parts, matrix, reduced, order }.solve(&mut solution, &mut room);
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn put<const ENTRIES: usize>(
        matrix: &mut Writing<'_, f64>,
        entries: [(usize, usize, f64); ENTRIES],
    ) {
        entries.into_iter().for_each(|(row, column, value)| matrix.put(row, column, value));
    }

    /// Masses of three points on a line, one of them none, with closures of which the last is the sum of the others.
    fn chain<const RANK: usize>() -> Bound<f64, 9, 3, RANK> {
        factor_bound::<f64, 9, 3, RANK>(|matrix| {
            put(matrix, [(0, 0, 2.0), (1, 0, 0.5), (2, 2, 3.0)]);
            put(matrix, [(3, 0, 1.0), (3, 1, -2.0), (4, 1, 1.0), (4, 2, 1.0)]);
            put(matrix, [(5, 0, 1.0), (5, 1, -1.0), (5, 2, 1.0)]);
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
            put(matrix, [(0, 0, 1.0), (2, 0, 1.0)]);
        });
        assert!(!bound.solve([1.0, 1.0, 0.0, 0.0])[1].is_finite());
    }

    /// Loops side by side with masses and entries at random, some zero by chance, some closures the sum of others.
    #[test]
    fn closures_at_random_are_solved() {
        const UNKNOWNS: usize = 9;
        const N: usize = 25;
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for round in 0..200 {
            let mut full = [[0.0; UNKNOWNS]; N];
            for unknown in 0..UNKNOWNS {
                full[unknown][unknown] = 1.0 + random();
                if unknown > 0 {
                    full[unknown][unknown - 1] = 0.5 * random();
                }
            }
            for closure in 0..7 {
                for entry in &mut full[UNKNOWNS + closure][closure..closure + 3] {
                    *entry = if random() > 0.3 { 0.0 } else { 2.0 * random() };
                }
            }
            let sum: [f64; UNKNOWNS] =
                std::array::from_fn(|column| full[UNKNOWNS][column] - full[UNKNOWNS + 2][column]);
            full[UNKNOWNS + 7] = sum;
            let bound = factor_bound::<f64, N, UNKNOWNS, 8>(|matrix| {
                for (row, entries) in full[..UNKNOWNS + 8].iter().enumerate() {
                    let below = entries.iter().enumerate().take(row + 1);
                    below
                        .filter(|one| *one.1 != 0.0)
                        .for_each(|(at, one)| matrix.put(row, at, *one));
                }
            });
            assert!(bound.parts.rank <= 7, "round {round}");
            // Right-hand sides that the closures allow.
            let some: [f64; UNKNOWNS] = std::array::from_fn(|_| random());
            let mut right = [0.0; N];
            for (row, right) in right.iter_mut().enumerate() {
                *right = match row < UNKNOWNS {
                    true => random(),
                    false if row < UNKNOWNS + 8 => {
                        (0..UNKNOWNS).map(|at| full[row][at] * some[at]).sum()
                    }
                    false => 0.0,
                };
            }
            let found = bound.solve(right);
            let (w, forces) = found.split_at(UNKNOWNS);
            for (row, right) in right.iter().enumerate().take(UNKNOWNS + 8) {
                let entry = |at: usize| full[row.max(at)][row.min(at)];
                let own: f64 = match row < UNKNOWNS {
                    true => {
                        let masses: f64 = (0..UNKNOWNS).map(|at| entry(at) * w[at]).sum();
                        let closures = full[UNKNOWNS..].iter().zip(forces);
                        masses + closures.map(|(slopes, force)| slopes[row] * force).sum::<f64>()
                    }
                    false => (0..UNKNOWNS).map(|at| full[row][at] * w[at]).sum(),
                };
                // Left out are pivots below 1e-4; the others enlarge rounding by no more than that.
                assert!((own - right).abs() < 1e-9, "round {round}, row {row}: {own} {right}");
            }
        }
    }

    /// Two unknowns of unit mass on the crossing lines `y (y - 2 x) = 0`, bound besides by `x + z = 0`: near the crossing, on
    /// the line `y = 0`, the acceleration across it is zero whatever the forces.
    #[test]
    fn what_closures_say_next_counts_where_they_say_nothing() {
        for distance in [1e-2, 1e-6, 0.0] {
            let (x, speed) = (distance, 3.0);
            let bound = factor_bound::<f64, 7, 3, 2>(|matrix| {
                put(matrix, [(0, 0, 1.0), (1, 1, 1.0), (2, 2, 1.0)]);
                put(matrix, [(3, 1, -2.0 * x), (4, 0, 1.0), (4, 2, 1.0), (5, 1, -6.0 * speed)]);
            });
            let found = bound.solve([1.0, 5.0, 3.0, 0.0, 0.5, 0.0, 0.0]);
            assert!(found[1].abs() < 1e-15, "{found:?}");
            assert!((found[0] + found[2] - 0.5).abs() < 1e-15);
            assert!((found[0] - 1.0 - (found[2] - 3.0)).abs() < 1e-15, "{found:?}");
        }
    }
}
