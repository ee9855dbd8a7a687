//! The parts of a bound system, and the algorithm on plain lists.

use crate::scalar::Scalar;

/// Part of the largest entry below which a pivot of what closures say next is none.
const LESS: f64 = 1e-3;

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

impl Parts {
    /// Rows and columns of the whole.
    pub fn size(&self) -> usize {
        self.unknowns + self.closures * if self.lasting.is_some() { 2 } else { 1 }
    }

    /// Factors in place. `matrix` has a row of unknowns for each unknown, its masses, and for each closure. `reduced` has a row
    /// of [`Self::size`] for each unknown: the masses of the free motion, and behind them `Z`.
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
        self.eliminate(matrix, reduced, (rows, columns), (most, nothing));
        if self.lasting.is_some() {
            self.lasting = Some(self.rank);
            if self.rank < most {
                let size = self.go_on(matrix);
                self.eliminate(matrix, reduced, (rows, columns), (most, LESS * size));
            }
        }
        self.span(matrix, reduced);
        self.reduce(matrix, reduced, columns);
    }

    /// Eliminates closures from those that are done on, up to a number of them, as long as pivots are more than nothing. The
    /// largest entry of each row is remembered in `room`: most rows are left as they are by most pivots.
    fn eliminate<S: Scalar>(
        &mut self,
        matrix: &mut [S],
        room: &mut [S],
        (rows, columns): (&mut [usize], &mut [usize]),
        (most, nothing): (usize, f64),
    ) {
        let (n, m, k) = (self.unknowns, self.closures, self.size());
        let (sizes, places) = room.split_at_mut(m);
        for row in self.rank..m {
            (sizes[row], places[row]) = largest(&matrix[(n + row) * n..][..n], self.rank);
        }
        while self.rank < most {
            let at = self.rank;
            let (mut row, mut size) = (at, 0.0);
            for (other, own) in sizes.iter().enumerate().skip(at) {
                let own = own.to_f64();
                // What is no number is found here, and makes everything no number.
                if own > size || own.is_nan() {
                    (row, size) = (other, own);
                }
            }
            let column = places[row].to_f64() as usize;
            if size <= nothing {
                break;
            }
            rows.swap(at, row);
            columns.swap(at, column);
            for other in (n..k).filter(|_| column != at) {
                matrix.swap(other * n + at, other * n + column);
            }
            (sizes[row], places[row]) = (sizes[at], places[at]);
            for place in &mut places[at + 1..m] {
                // A row that holds its largest entry here holds it there now.
                if place.to_f64() == at as f64 {
                    *place = S::from_f64(column as f64);
                }
            }
            // What closures say next goes with them.
            for block in (n..k).step_by(m).filter(|_| row != at) {
                let (above, below) = matrix.split_at_mut((block + row) * n);
                above[(block + at) * n..][..n].swap_with_slice(&mut below[..n]);
            }
            let (above, below) = matrix.split_at_mut((n + at + 1) * n);
            let pivot = &above[(n + at) * n..][..n];
            let reciprocal = S::ONE / pivot[at];
            for (index, other) in below[..(m - at - 1) * n].chunks_exact_mut(n).enumerate() {
                if other[at].to_f64() == 0.0 {
                    continue;
                }
                let multiple = other[at] * reciprocal;
                other[at] = multiple;
                for (entry, pivot) in other[at + 1..n].iter_mut().zip(&pivot[at + 1..]) {
                    *entry = added(*pivot, -multiple, *entry);
                }
                let row = at + 1 + index;
                (sizes[row], places[row]) = largest(&other[..n], at + 1);
            }
            self.rank += 1;
        }
    }

    /// Puts what closures say next in the place of those that are not independent now: the same combinations of it. The
    /// multiples by which these were made stand in its place then. Gives the largest entry that is left.
    fn go_on<S: Scalar>(&self, matrix: &mut [S]) -> f64 {
        let (n, m, r) = (self.unknowns, self.closures, self.rank);
        let mut largest = 0.0_f64;
        for i in 0..m {
            let (own, next) = ((n + i) * n, (n + m + i) * n);
            for j in 0..i.min(r) {
                let (multiple, other) = (matrix[own + j], (n + m + j) * n);
                for column in 0..n {
                    matrix[next + column] =
                        added(matrix[other + column], -multiple, matrix[next + column]);
                }
            }
            if i < r {
                continue;
            }
            for column in 0..n {
                matrix.swap(own + column, next + column);
            }
            for j in 0..r {
                let pivot = (n + j) * n;
                let multiple = matrix[own + j] / matrix[pivot + j];
                matrix[own + j] = multiple;
                for column in j + 1..n {
                    matrix[own + column] =
                        added(matrix[pivot + column], -multiple, matrix[own + column]);
                }
            }
            let left = matrix[own + r..own + n].iter();
            largest = left.fold(largest, |most, one| most.max(one.to_f64().abs()));
        }
        largest
    }

    /// Writes `Z`: what the freedom `j` moves of the determined unknown `i` stands in row `j`, behind the masses of the free
    /// motion.
    fn span<S: Scalar>(&self, matrix: &[S], reduced: &mut [S]) {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        for freedom in 0..n - r {
            for i in (0..r).rev() {
                let upper = (n + i) * n;
                let mut sum = -matrix[upper + r + freedom];
                for j in i + 1..r {
                    sum = added(matrix[upper + j], -reduced[freedom * k + n + j], sum);
                }
                reduced[freedom * k + n + i] = sum / matrix[upper + i];
            }
        }
    }

    /// Writes the masses of the free motion, `Zᵀ A Z`, factored as `L D Lᵀ`.
    fn reduce<S: Scalar>(&self, matrix: &[S], reduced: &mut [S], columns: &[usize]) {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        let free = n - r;
        for j in 0..free {
            for i in 0..=j {
                reduced[j * k + i] = self.along(matrix, reduced, columns, (j, r + i));
            }
            for row in 0..r {
                let force = self.along(matrix, reduced, columns, (j, row));
                for i in 0..=j {
                    let z = reduced[i * k + n + row];
                    reduced[j * k + i] = added(z, force, reduced[j * k + i]);
                }
            }
        }
        for j in 0..free {
            for i in 0..j {
                let mut entry = reduced[j * k + i];
                for inner in 0..i {
                    let product = reduced[j * k + inner] * reduced[inner * k + inner];
                    entry = added(reduced[i * k + inner], -product, entry);
                }
                reduced[j * k + i] = entry / reduced[i * k + i];
            }
            let mut pivot = reduced[j * k + j];
            for inner in 0..j {
                let entry = reduced[j * k + inner];
                pivot = added(entry * reduced[inner * k + inner], -entry, pivot);
            }
            reduced[j * k + j] = pivot;
        }
    }

    /// The force of an unknown's masses when a freedom moves by one.
    #[inline]
    fn along<S: Scalar>(
        &self,
        matrix: &[S],
        reduced: &[S],
        columns: &[usize],
        (freedom, row): (usize, usize),
    ) -> S {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        let masses = &matrix[columns[row] * n..];
        let own = masses[columns[r + freedom]];
        let span = columns[..r].iter().zip(&reduced[freedom * k + n..]);
        span.fold(own, |sum, (column, z)| added(masses[*column], *z, sum))
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
        let (n, m, r) = (self.unknowns, self.closures, self.rank);
        let (w, forces) = room.split_at_mut(n);
        self.particular(matrix, rows, (right, forces), w);
        // What the masses leave of the forces, in the order of the unknowns.
        self.take(matrix, columns, (&w[..r], 0), right);
        self.free(reduced, columns, (right, w));
        // The determined unknowns follow; by how much stands in place of the forces for a while.
        forces.fill(S::ZERO);
        for (freedom, a) in w[r..].iter().enumerate() {
            for (i, force) in forces[..r].iter_mut().enumerate() {
                *force = added(reduced[freedom * self.size() + n + i], *a, *force);
            }
        }
        self.take(matrix, columns, (&forces[..r], 0), right);
        self.take(matrix, columns, (&w[r..], r), right);
        for (w, more) in w[..r].iter_mut().zip(&*forces) {
            *w = *w + *more;
        }
        self.forces(matrix, columns, (right, forces));
        right.fill(S::ZERO);
        for (column, w) in columns[..n].iter().zip(&*w) {
            right[*column] = *w;
        }
        let lasting = self.lasting.unwrap_or(r);
        for (i, (row, force)) in rows[..r].iter().zip(&*forces).enumerate() {
            right[if i < lasting { n } else { n + m } + row] = *force;
        }
    }

    /// Writes `w₀`, in the order of the columns; `room` is for what closures say next.
    fn particular<S: Scalar>(
        &self,
        matrix: &[S],
        rows: &[usize],
        (right, room): (&[S], &mut [S]),
        w: &mut [S],
    ) {
        let (n, m, r) = (self.unknowns, self.closures, self.rank);
        let lasting = self.lasting.unwrap_or(r).min(r);
        w.fill(S::ZERO);
        if lasting < r {
            // The right-hand sides of what closures say next, combined as these are.
            for i in 0..r {
                let multiples = if i < lasting { (n + i) * n } else { (n + m + i) * n };
                let mut sum = right[n + m + rows[i]];
                for j in 0..i.min(lasting) {
                    sum = added(matrix[multiples + j], -room[j], sum);
                }
                room[i] = sum;
            }
        }
        for i in 0..r {
            let mut sum = if i < lasting { right[n + rows[i]] } else { room[i] };
            for j in 0..i {
                sum = added(matrix[(n + i) * n + j], -w[j], sum);
            }
            w[i] = sum;
        }
        for i in (0..r).rev() {
            let mut sum = w[i];
            for j in i + 1..r {
                sum = added(matrix[(n + i) * n + j], -w[j], sum);
            }
            w[i] = sum / matrix[(n + i) * n + i];
        }
    }

    /// Writes the free motion `a` behind the determined unknowns.
    fn free<S: Scalar>(&self, reduced: &[S], columns: &[usize], (forces, w): (&[S], &mut [S])) {
        let (n, k, r) = (self.unknowns, self.size(), self.rank);
        let free = n - r;
        for j in 0..free {
            let mut sum = forces[columns[r + j]];
            for i in 0..r {
                sum = added(reduced[j * k + n + i], forces[columns[i]], sum);
            }
            for i in 0..j {
                sum = added(reduced[j * k + i], -w[r + i], sum);
            }
            w[r + j] = sum;
        }
        for j in (0..free).rev() {
            let mut sum = w[r + j] / reduced[j * k + j];
            for i in j + 1..free {
                sum = added(reduced[i * k + j], -w[r + i], sum);
            }
            w[r + j] = sum;
        }
    }

    /// Writes `μ` of `Uᵀ Lᵀ μ = b - A w`, of the determined unknowns.
    fn forces<S: Scalar>(&self, matrix: &[S], columns: &[usize], (left, forces): (&[S], &mut [S])) {
        let (n, r) = (self.unknowns, self.rank);
        for i in 0..r {
            let mut sum = left[columns[i]];
            for j in 0..i {
                sum = added(matrix[(n + j) * n + i], -forces[j], sum);
            }
            forces[i] = sum / matrix[(n + i) * n + i];
        }
        for i in (0..r).rev() {
            for j in i + 1..r {
                forces[i] = added(matrix[(n + j) * n + i], -forces[j], forces[i]);
            }
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
        let n = self.unknowns;
        for (row, force) in forces[..n].iter_mut().enumerate() {
            let masses = &matrix[row * n..][..n];
            for (column, unknown) in columns[from..].iter().zip(unknowns) {
                *force = added(masses[*column], -*unknown, *force);
            }
        }
    }
}

/// `a·b + c`, rounded twice: where this is not compiled into code for a processor that fuses, fusing would call a function.
#[inline(always)]
fn added<S: Scalar>(a: S, b: S, c: S) -> S {
    a * b + c
}

/// The largest entry of a row from a column on, and where it stands.
#[inline]
fn largest<S: Scalar>(row: &[S], from: usize) -> (S, S) {
    let (mut size, mut place) = (0.0, from);
    for (column, entry) in row.iter().enumerate().skip(from) {
        let entry = entry.to_f64().abs();
        if entry > size || entry.is_nan() {
            (size, place) = (entry, column);
        }
    }
    (S::from_f64(size), S::from_f64(place as f64))
}
