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

use super::Factored;
use crate::scalar::Scalar;

/// Below this a pivot of closures is none, their rows being of size one: they follow from the others, for an instant at
/// least. A smaller limit would divide rounding by next to nothing, a larger one take what holds for an instant for longer.
const NOTHING: f64 = 1e-4;
/// The same of what holds then, over the largest entry.
const LESS: f64 = 1e-3;

/// The matrix of a bound system, factored: of so many unknowns, bound by closures of which at most a number is independent.
#[derive(Clone, Copy, Debug)]
pub struct Bound<S, const N: usize, const UNKNOWNS: usize, const RANK: usize> {
    parts: Parts,
    factors: [[S; N]; N],
    reduced: [[S; N]; N],
    rows: [usize; N],
    columns: [usize; N],
}

/// How a bound system is divided.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    /// Number of unknowns `w`.
    pub unknowns: usize,
    /// Number of closures.
    pub closures: usize,
    /// Most closures that are independent; found to be fewer when it is factored.
    pub rank: usize,
    /// How many of these are closures themselves; the others are what closures say next, which stands behind them if this is
    /// not none.
    pub lasting: Option<usize>,
}

/// Factors a bound system of so many unknowns: masses, closures, and behind these what they say next, of which the lower
/// triangle is read. At most `RANK` closures are independent.
///
/// Unknowns that nothing determines, such as those without mass, give infinite or NaN solutions, never a panic.
#[inline(always)]
pub fn factor_bound<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize>(
    matrix: [[S; N]; N],
) -> Bound<S, N, UNKNOWNS, RANK> {
    let (unknowns, rank) = (UNKNOWNS, RANK);
    let mut factors = matrix;
    for row in 0..N {
        for column in 0..row {
            factors[column][row] = matrix[row][column];
        }
    }
    let mut bound = Bound {
        parts: Parts { unknowns, closures: (N - unknowns) / 2, rank, lasting: Some(0) },
        factors,
        reduced: [[S::ZERO; N]; N],
        rows: [0; N],
        columns: [0; N],
    };
    let (factors, reduced) = (bound.factors.as_flattened_mut(), bound.reduced.as_flattened_mut());
    bound.parts.factor(factors, reduced, (&mut bound.rows, &mut bound.columns), NOTHING);
    bound
}

impl<S: Scalar, const N: usize, const UNKNOWNS: usize, const RANK: usize> Factored<S, N>
    for Bound<S, N, UNKNOWNS, RANK>
{
    #[inline(always)]
    fn of(matrix: [[S; N]; N]) -> Self {
        factor_bound(matrix)
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

impl Parts {
    /// Rows and columns of the whole.
    fn size(&self) -> usize {
        self.unknowns + self.closures * if self.lasting.is_some() { 2 } else { 1 }
    }

    /// Factors in place. `matrix` has all its entries, row by row; what stands beside the masses is overwritten. `reduced`
    /// is as large.
    #[inline]
    pub fn factor<S: Scalar>(
        &mut self,
        matrix: &mut [S],
        reduced: &mut [S],
        (rows, columns): (&mut [usize], &mut [usize]),
        nothing: f64,
    ) {
        rows.iter_mut().enumerate().for_each(|(index, row)| *row = index);
        columns.iter_mut().enumerate().for_each(|(index, column)| *column = index);
        let most = self.rank.min(self.closures).min(self.unknowns);
        self.rank = 0;
        self.eliminate(matrix, (rows, columns), most, nothing);
        if self.lasting.is_some() {
            self.lasting = Some(self.rank);
            if self.rank < most {
                let size = self.go_on(matrix);
                self.eliminate(matrix, (rows, columns), most, LESS * size);
            }
        }
        self.span(matrix);
        self.reduce(matrix, reduced, columns);
    }

    /// Eliminates closures from those that are done on, up to a number of them, as long as pivots are more than nothing.
    fn eliminate<S: Scalar>(
        &mut self,
        matrix: &mut [S],
        (rows, columns): (&mut [usize], &mut [usize]),
        most: usize,
        nothing: f64,
    ) {
        let (n, m, k) = (self.unknowns, self.closures, self.size());
        while self.rank < most {
            let at = self.rank;
            let (mut best, mut size) = ((at, at), 0.0);
            for row in at..m {
                for column in at..n {
                    let entry = matrix[(n + row) * k + column].to_f64().abs();
                    // What is no number is found here, and makes everything no number.
                    if entry > size || entry.is_nan() {
                        (best, size) = ((row, column), entry);
                    }
                }
            }
            if size <= nothing {
                break;
            }
            let (row, column) = best;
            rows.swap(at, row);
            columns.swap(at, column);
            for other in n..k {
                matrix.swap(other * k + at, other * k + column);
            }
            // What closures say next goes with them.
            for block in (n..k).step_by(m).filter(|_| row != at) {
                let (above, below) = matrix.split_at_mut((block + row) * k);
                above[(block + at) * k..][..n].swap_with_slice(&mut below[..n]);
            }
            let (above, below) = matrix.split_at_mut((n + at + 1) * k);
            let pivot = &above[(n + at) * k..][..n];
            let reciprocal = S::ONE / pivot[at];
            for other in below[..(m - at - 1) * k].chunks_exact_mut(k) {
                if other[at].to_f64() == 0.0 {
                    continue;
                }
                let multiple = other[at] * reciprocal;
                other[at] = multiple;
                for (entry, pivot) in other[at + 1..n].iter_mut().zip(&pivot[at + 1..]) {
                    *entry = pivot.mul_add(-multiple, *entry);
                }
            }
            self.rank += 1;
        }
    }

    /// Puts what closures say next in the place of those that are not independent now: the same combinations of it. The
    /// multiples by which these were made stand in its place then. Gives the largest entry that is left.
    fn go_on<S: Scalar>(&self, matrix: &mut [S]) -> f64 {
        let (n, m, k, r) = (self.unknowns, self.closures, self.size(), self.rank);
        let mut largest = 0.0_f64;
        for i in 0..m {
            let (own, next) = ((n + i) * k, (n + m + i) * k);
            for j in 0..i.min(r) {
                let (multiple, other) = (matrix[own + j], (n + m + j) * k);
                for column in 0..n {
                    matrix[next + column] =
                        matrix[other + column].mul_add(-multiple, matrix[next + column]);
                }
            }
            if i < r {
                continue;
            }
            for column in 0..n {
                matrix.swap(own + column, next + column);
            }
            for j in 0..r {
                let pivot = (n + j) * k;
                let multiple = matrix[own + j] / matrix[pivot + j];
                matrix[own + j] = multiple;
                for column in j + 1..n {
                    matrix[own + column] =
                        matrix[pivot + column].mul_add(-multiple, matrix[own + column]);
                }
            }
            let left = matrix[own + r..own + n].iter();
            largest = left.fold(largest, |most, one| most.max(one.to_f64().abs()));
        }
        largest
    }

    /// Writes `Z`: entry `(i, j)` of what the freedom `j` moves of the determined unknown `i` stands in row `j`, behind the
    /// masses.
    fn span<S: Scalar>(&self, matrix: &mut [S]) {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        for freedom in 0..n - r {
            for i in (0..r).rev() {
                let upper = (n + i) * k;
                let mut sum = -matrix[upper + r + freedom];
                for j in i + 1..r {
                    sum = matrix[upper + j].mul_add(-matrix[freedom * k + n + j], sum);
                }
                matrix[freedom * k + n + i] = sum / matrix[upper + i];
            }
        }
    }

    /// Writes the masses of the free motion, `Zᵀ A Z`, factored as `L D Lᵀ`.
    fn reduce<S: Scalar>(&self, matrix: &[S], reduced: &mut [S], columns: &[usize]) {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        let free = n - r;
        for j in 0..free {
            // `A z` of a freedom, kept where the upper triangle would be.
            for i in 0..=j {
                let mut sum = S::ZERO;
                let along = |matrix: &[S], row: usize, freedom: usize| {
                    let of = columns[row] * k;
                    let mut sum = matrix[of + columns[r + freedom]];
                    for inner in 0..r {
                        sum = matrix[of + columns[inner]]
                            .mul_add(matrix[freedom * k + n + inner], sum);
                    }
                    sum
                };
                sum = sum + along(matrix, r + i, j);
                for row in 0..r {
                    sum = matrix[i * k + n + row].mul_add(along(matrix, row, j), sum);
                }
                reduced[j * k + i] = sum;
            }
        }
        for j in 0..free {
            for i in 0..j {
                let mut entry = reduced[j * k + i];
                for inner in 0..i {
                    let product = reduced[j * k + inner] * reduced[inner * k + inner];
                    entry = reduced[i * k + inner].mul_add(-product, entry);
                }
                reduced[j * k + i] = entry / reduced[i * k + i];
            }
            let mut pivot = reduced[j * k + j];
            for inner in 0..j {
                let entry = reduced[j * k + inner];
                pivot = (entry * reduced[inner * k + inner]).mul_add(-entry, pivot);
            }
            reduced[j * k + j] = pivot;
        }
    }

    /// Solves in place; `room` is as long as the right-hand side.
    #[inline]
    pub fn solve<S: Scalar>(
        &self,
        matrix: &[S],
        reduced: &[S],
        (rows, columns): (&[usize], &[usize]),
        (right, room): (&mut [S], &mut [S]),
    ) {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        let (w, forces) = room.split_at_mut(n);
        w.fill(S::ZERO);
        // `w₀`, in the order of the columns.
        let (m, lasting) = (self.closures, self.lasting.unwrap_or(r).min(r));
        for i in 0..if lasting < r { r } else { 0 } {
            // The right-hand sides of what closures say next, combined as these are.
            let multiples = if i < lasting { (n + i) * k } else { (n + m + i) * k };
            let mut sum = right[n + m + rows[i]];
            for j in 0..i.min(lasting) {
                sum = matrix[multiples + j].mul_add(-forces[j], sum);
            }
            forces[i] = sum;
        }
        for i in 0..r {
            let mut sum = if i < lasting { right[n + rows[i]] } else { forces[i] };
            for j in 0..i {
                sum = matrix[(n + i) * k + j].mul_add(-w[j], sum);
            }
            w[i] = sum;
        }
        for i in (0..r).rev() {
            let mut sum = w[i];
            for j in i + 1..r {
                sum = matrix[(n + i) * k + j].mul_add(-w[j], sum);
            }
            w[i] = sum / matrix[(n + i) * k + i];
        }
        // What the masses leave of the forces, in the order of the unknowns.
        self.take(matrix, columns, (&w[..r], 0), right);
        for freedom in 0..n - r {
            let mut sum = right[columns[r + freedom]];
            for i in 0..r {
                sum = matrix[freedom * k + n + i].mul_add(right[columns[i]], sum);
            }
            w[r + freedom] = sum;
        }
        let free = n - r;
        for j in 1..free {
            for i in 0..j {
                w[r + j] = reduced[j * k + i].mul_add(-w[r + i], w[r + j]);
            }
        }
        for j in 0..free {
            w[r + j] = w[r + j] / reduced[j * k + j];
        }
        for j in (0..free).rev() {
            for i in j + 1..free {
                w[r + j] = reduced[i * k + j].mul_add(-w[r + i], w[r + j]);
            }
        }
        // The determined unknowns follow; by how much stands in place of the forces for a while.
        forces.fill(S::ZERO);
        for freedom in 0..free {
            for (i, force) in forces[..r].iter_mut().enumerate() {
                *force = matrix[freedom * k + n + i].mul_add(w[r + freedom], *force);
            }
        }
        self.take(matrix, columns, (&forces[..r], 0), right);
        self.take(matrix, columns, (&w[r..], r), right);
        for (w, more) in w[..r].iter_mut().zip(&*forces) {
            *w = *w + *more;
        }
        // `Uᵀ Lᵀ μ = b - A w`, of the determined unknowns.
        for i in 0..r {
            let mut sum = right[columns[i]];
            for j in 0..i {
                sum = matrix[(n + j) * k + i].mul_add(-forces[j], sum);
            }
            forces[i] = sum / matrix[(n + i) * k + i];
        }
        for i in (0..r).rev() {
            for j in i + 1..r {
                forces[i] = matrix[(n + j) * k + i].mul_add(-forces[j], forces[i]);
            }
        }
        right.fill(S::ZERO);
        for (column, w) in columns[..n].iter().zip(&*w) {
            right[*column] = *w;
        }
        for (i, (row, force)) in rows[..r].iter().zip(&*forces).enumerate() {
            right[if i < lasting { n } else { n + m } + row] = *force;
        }
    }

    /// Takes the forces of the masses off those that are given, for some unknowns from one on in the order of the columns.
    fn take<S: Scalar>(
        &self,
        matrix: &[S],
        columns: &[usize],
        (unknowns, from): (&[S], usize),
        forces: &mut [S],
    ) {
        let (n, k) = (self.unknowns, self.size());
        for (column, unknown) in columns[from..].iter().zip(unknowns) {
            for (row, force) in forces[..n].iter_mut().enumerate() {
                *force = matrix[row * k + column].mul_add(-*unknown, *force);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Masses of three points on a line, one of them none, with closures of which the last is the sum of the others.
    fn chain<const RANK: usize>() -> Bound<f64, 9, 3, RANK> {
        let mut matrix = [[0.0; 9]; 9];
        [matrix[0][0], matrix[1][0], matrix[2][2]] = [2.0, 0.5, 3.0];
        matrix[3][..3].copy_from_slice(&[1.0, -2.0, 0.0]);
        matrix[4][..3].copy_from_slice(&[0.0, 1.0, 1.0]);
        matrix[5][..3].copy_from_slice(&[1.0, -1.0, 1.0]);
        factor_bound::<f64, 9, 3, RANK>(matrix)
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
        let mut matrix = [[0.0; 4]; 4];
        (matrix[0][0], matrix[2][0]) = (1.0, 1.0);
        let bound = factor_bound::<f64, 4, 2, 1>(matrix);
        assert!(!bound.solve([1.0, 1.0, 0.0, 0.0])[1].is_finite());
    }

    /// Two unknowns of unit mass on the crossing lines `y (y - 2 x) = 0`, bound besides by `x + z = 0`: near the crossing, on
    /// the line `y = 0`, the acceleration across it is zero whatever the forces.
    #[test]
    fn what_closures_say_next_counts_where_they_say_nothing() {
        for distance in [1e-2, 1e-6, 0.0] {
            let (x, speed) = (distance, 3.0);
            let mut matrix = [[0.0; 7]; 7];
            (matrix[0][0], matrix[1][1], matrix[2][2]) = (1.0, 1.0, 1.0);
            matrix[3][..3].copy_from_slice(&[0.0, -2.0 * x, 0.0]);
            matrix[4][..3].copy_from_slice(&[1.0, 0.0, 1.0]);
            matrix[5][..3].copy_from_slice(&[0.0, -6.0 * speed, 0.0]);
            let bound = factor_bound::<f64, 7, 3, 2>(matrix);
            let found = bound.solve([1.0, 5.0, 3.0, 0.0, 0.5, 0.0, 0.0]);
            assert!(found[1].abs() < 1e-15, "{found:?}");
            assert!((found[0] + found[2] - 0.5).abs() < 1e-15);
            assert!((found[0] - 1.0 - (found[2] - 3.0)).abs() < 1e-15, "{found:?}");
        }
    }
}
