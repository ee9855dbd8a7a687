//! The solution of a bound system that is factored.

use super::parts::{Order, Parts};
use crate::scalar::Scalar;

/// A bound system that is factored.
pub struct Reading<'a, S> {
    /// How it is divided.
    pub parts: &'a Parts,
    /// What [`super::Writing`] has made of its matrix.
    pub matrix: &'a [S],
    /// The masses of the free motion, factored, and `Z`.
    pub reduced: &'a [S],
    /// Where entries stand.
    pub order: Order<&'a [u16]>,
}

impl<S: Scalar> Reading<'_, S> {
    /// Solves in place: a right-hand side for each row, and as much room.
    #[inline]
    pub fn solve(&self, right: &mut [S], room: &mut [S]) {
        let (n, m, r) = (self.parts.unknowns, self.parts.closures, self.parts.rank);
        let (w, forces) = room.split_at_mut(n);
        self.particular((right, forces), w);
        // What the masses leave of the forces, in the order of the unknowns.
        self.take((&w[..r], 0), right);
        self.free((right, w));
        // The determined unknowns follow; by how much stands in place of the forces for a while.
        forces.fill(S::ZERO);
        for (freedom, a) in w[r..].iter().enumerate() {
            let span = &self.reduced[freedom * n + n - r..][..r];
            for (force, z) in forces.iter_mut().zip(span) {
                *force = *force + *z * *a;
            }
        }
        self.take((&forces[..r], 0), right);
        self.take((&w[r..], r), right);
        for (w, more) in w[..r].iter_mut().zip(&*forces) {
            *w = *w + *more;
        }
        self.forces(right, forces);
        right.fill(S::ZERO);
        for (column, w) in self.order.columns.iter().zip(&*w) {
            right[usize::from(*column)] = *w;
        }
        let lasting = self.parts.lasting.unwrap_or(r);
        for (i, (row, force)) in self.order.rows[..r].iter().zip(&*forces).enumerate() {
            right[if i < lasting { n } else { n + m } + usize::from(*row)] = *force;
        }
    }

    /// The row of the closure at a place of the order, and its pivot.
    #[inline]
    fn pivot(&self, at: usize) -> (usize, S) {
        let n = self.parts.unknowns;
        let row = n + usize::from(self.order.rows[at]);
        (row, self.matrix[row * n + usize::from(self.order.columns[at])])
    }

    /// Writes `w₀`, in the order of the unknowns; `room` is for what closures say next.
    fn particular(&self, (right, room): (&[S], &mut [S]), w: &mut [S]) {
        let (n, m, r) = (self.parts.unknowns, self.parts.closures, self.parts.rank);
        let lasting = self.parts.lasting.unwrap_or(r).min(r);
        w.fill(S::ZERO);
        if lasting < r {
            // The right-hand sides of what closures say next, combined as these are.
            for i in 0..r {
                let row = usize::from(self.order.rows[i]);
                let multiples = if i < lasting { n } else { n + m } + row;
                let mut sum = right[n + m + row];
                for (column, other) in self.order.columns.iter().zip(&room[..i.min(lasting)]) {
                    sum = sum - self.matrix[multiples * n + usize::from(*column)] * *other;
                }
                room[i] = sum;
            }
        }
        for i in 0..r {
            let row = n + usize::from(self.order.rows[i]);
            let sum = if i < lasting { right[row] } else { room[i] };
            let earlier = self.order.entries(self.matrix, row).filter(|one| one.0 < i);
            w[i] = earlier.fold(sum, |sum, (place, multiple)| sum - multiple * w[place]);
        }
        for i in (0..r).rev() {
            let (row, pivot) = self.pivot(i);
            let later = self.order.entries(self.matrix, row).filter(|one| i < one.0 && one.0 < r);
            w[i] = later.fold(w[i], |sum, (place, entry)| sum - entry * w[place]) / pivot;
        }
    }

    /// Writes the free motion `a` behind the determined unknowns.
    fn free(&self, (forces, w): (&[S], &mut [S])) {
        let (n, r) = (self.parts.unknowns, self.parts.rank);
        let (free, reduced) = (n - r, self.reduced);
        let force = |place: usize| forces[usize::from(self.order.columns[place])];
        for j in 0..free {
            let mut sum = force(r + j);
            for i in 0..r {
                sum = sum + reduced[j * n + free + i] * force(i);
            }
            for i in 0..j {
                sum = sum - reduced[j * n + i] * w[r + i];
            }
            w[r + j] = sum;
        }
        for j in (0..free).rev() {
            let mut sum = w[r + j] / reduced[j * n + j];
            for i in j + 1..free {
                sum = sum - reduced[i * n + j] * w[r + i];
            }
            w[r + j] = sum;
        }
    }

    /// Writes `μ` of `Uᵀ Lᵀ μ = b - A w`, of the determined unknowns.
    fn forces(&self, left: &[S], forces: &mut [S]) {
        let r = self.parts.rank;
        for (force, column) in forces[..r].iter_mut().zip(self.order.columns) {
            *force = left[usize::from(*column)];
        }
        for i in 0..r {
            let (row, pivot) = self.pivot(i);
            let own = forces[i] / pivot;
            forces[i] = own;
            for (place, entry) in
                self.order.entries(self.matrix, row).filter(|one| i < one.0 && one.0 < r)
            {
                forces[place] = forces[place] - entry * own;
            }
        }
        for i in (0..r).rev() {
            let (row, own) = (self.pivot(i).0, forces[i]);
            for (place, multiple) in self.order.entries(self.matrix, row).filter(|one| one.0 < i) {
                forces[place] = forces[place] - multiple * own;
            }
        }
    }

    /// Takes the forces of the masses off those that are given, for some unknowns from a place of the order on.
    fn take(&self, (unknowns, from): (&[S], usize), forces: &mut [S]) {
        let places = from..from + unknowns.len();
        for (row, force) in forces[..self.parts.unknowns].iter_mut().enumerate() {
            let own = self.order.entries(self.matrix, row).filter(|one| places.contains(&one.0));
            *force = own.fold(*force, |sum, (place, mass)| sum - mass * unknowns[place - from]);
        }
    }
}
