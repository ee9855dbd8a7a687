//! The parts of a bound system, where their entries stand, and how they are factored.
//!
//! Mechanisms are chains of links: most of their masses and closures are zero, and stay so while they are factored. Rows have
//! their place in full, and lists say where they have entries; nothing is moved, permutations say what comes first.

use crate::scalar::Scalar;

/// Part of the largest entry below which a pivot of what closures say next is none.
const LESS: f64 = 1e-3;
/// In place of the largest entry of a closure that determines an unknown already.
const DONE: f64 = -1.0;

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

/// Where the entries of the rows stand, and in which order unknowns are determined.
pub struct Order<I> {
    /// For each row the columns of its entries, of as much room as there are unknowns.
    pub lists: I,
    /// How many these are.
    pub lengths: I,
    /// Closures in the order of their pivots, then those that are left.
    pub rows: I,
    /// Unknowns in the order of their pivots, then those that are free.
    pub columns: I,
    /// For each unknown its place in that order.
    pub places: I,
}

impl<I: AsRef<[u16]>> Order<I> {
    /// The columns of a row's entries.
    #[inline]
    pub fn list(&self, row: usize) -> &[u16] {
        let n = self.columns.as_ref().len();
        &self.lists.as_ref()[row * n..][..usize::from(self.lengths.as_ref()[row])]
    }

    /// The entries of a row of a matrix, each with the place of its unknown.
    #[inline]
    pub fn entries<S: Copy>(&self, matrix: &[S], row: usize) -> impl Iterator<Item = (usize, S)> {
        let own = &matrix[row * self.columns.as_ref().len()..];
        let places = self.places.as_ref();
        self.list(row).iter().map(move |column| {
            let column = usize::from(*column);
            (usize::from(places[column]), own[column])
        })
    }
}

/// A bound system that is written and factored.
pub struct Writing<'a, S> {
    /// How it is divided.
    pub parts: &'a mut Parts,
    /// A row of entries for each unknown, its masses, for each closure, and for what that says next.
    pub matrix: &'a mut [S],
    /// A row for each unknown that is free: the masses of the free motion, and behind these its part of `Z`.
    pub reduced: &'a mut [S],
    /// Where entries stand.
    pub order: Order<&'a mut [u16]>,
    /// What is looked for.
    pub scan: Scan<'a>,
}

/// What is looked for while closures are eliminated.
pub struct Scan<'a> {
    /// For each closure its largest entry among unknowns that are left, and the column of that.
    pub largest: &'a mut [(f64, u16)],
    /// For each unknown a closure that has an entry there, from 1; none is 0.
    pub first: &'a mut [u16],
    /// For each entry of a closure the next closure that has one there.
    pub next: &'a mut [u16],
}

impl<S: Scalar> Writing<'_, S> {
    /// Forgets all entries.
    pub fn clear(&mut self) {
        self.matrix.fill(S::ZERO);
        self.order.lengths.fill(0);
        self.scan.first.fill(0);
    }

    /// Writes an entry that has not been written, of masses in both halves.
    #[inline]
    pub fn put(&mut self, row: usize, column: usize, value: S) {
        self.matrix[row * self.parts.unknowns + column] = value;
        self.list(row, column);
        if row < self.parts.unknowns && row != column {
            self.matrix[column * self.parts.unknowns + row] = value;
            self.list(column, row);
        }
    }

    /// Lists an entry.
    #[inline]
    fn list(&mut self, row: usize, column: usize) {
        let n = self.parts.unknowns;
        let length = &mut self.order.lengths[row];
        self.order.lists[row * n + usize::from(*length)] = column as u16;
        *length += 1;
        if (n..n + self.parts.closures).contains(&row) {
            self.link(row - n, column);
        }
    }

    /// Lets a closure be found by a column.
    #[inline]
    fn link(&mut self, closure: usize, column: usize) {
        let first = &mut self.scan.first[column];
        self.scan.next[closure * self.parts.unknowns + column] = *first;
        *first = (closure + 1) as u16;
    }

    /// Factors in place; pivots of closures below some size are none.
    pub fn factor(&mut self, nothing: f64) {
        let Order { columns, places, .. } = &mut self.order;
        columns.iter_mut().zip(0..).for_each(|(column, index)| *column = index);
        places.iter_mut().zip(0..).for_each(|(place, index)| *place = index);
        let most = self.parts.rank.min(self.parts.closures).min(self.parts.unknowns);
        self.parts.rank = 0;
        for closure in 0..self.parts.closures {
            self.measure(closure);
        }
        self.eliminate(most, nothing);
        if self.parts.lasting.is_some() {
            self.parts.lasting = Some(self.parts.rank);
            if self.parts.rank < most {
                let size = self.go_on();
                self.eliminate(most, LESS * size);
            }
        }
        self.span();
        self.reduce();
    }

    /// Eliminates closures up to a number of them, as long as pivots are more than nothing.
    fn eliminate(&mut self, most: usize, nothing: f64) {
        let n = self.parts.unknowns;
        while self.parts.rank < most {
            let (mut closure, mut size) = (0, 0.0);
            for (other, (own, _)) in self.scan.largest.iter().enumerate() {
                // What is no number is found here, and makes everything no number.
                if *own > size || own.is_nan() {
                    (closure, size) = (other, *own);
                }
            }
            if size <= nothing {
                break;
            }
            let column = usize::from(self.scan.largest[closure].1);
            self.determine(column, closure);
            let pivot = n + closure;
            let reciprocal = S::ONE / self.matrix[pivot * n + column];
            let mut next = usize::from(self.scan.first[column]);
            while next > 0 {
                let other = next - 1;
                if self.scan.largest[other].0 != DONE {
                    let entry = &mut self.matrix[(n + other) * n + column];
                    let multiple = *entry * reciprocal;
                    *entry = multiple;
                    self.subtract(n + other, (pivot, multiple), self.parts.rank);
                    self.measure(other);
                }
                next = usize::from(self.scan.next[other * n + column]);
            }
        }
        let left = self.scan.largest.iter().zip(0..).filter(|(own, _)| own.0 != DONE);
        for (row, (_, closure)) in self.order.rows[self.parts.rank..].iter_mut().zip(left) {
            *row = closure;
        }
    }

    /// Makes an unknown the one that a closure determines.
    fn determine(&mut self, column: usize, closure: usize) {
        let Order { rows, columns, places, .. } = &mut self.order;
        let at = self.parts.rank;
        let (from, other) = (usize::from(places[column]), usize::from(columns[at]));
        columns.swap(at, from);
        places.swap(column, other);
        rows[at] = closure as u16;
        self.scan.largest[closure].0 = DONE;
        self.parts.rank += 1;
    }

    /// Takes a multiple of another row off a row, in the columns of unknowns from a place of the order on.
    fn subtract(&mut self, row: usize, (other, multiple): (usize, S), from: usize) {
        let n = self.parts.unknowns;
        for index in 0..usize::from(self.order.lengths[other]) {
            let column = self.order.lists[other * n + index];
            let at = usize::from(column);
            if usize::from(self.order.places[at]) < from {
                continue;
            }
            if !self.order.list(row).contains(&column) {
                self.list(row, at);
            }
            let share = multiple * self.matrix[other * n + at];
            self.matrix[row * n + at] = self.matrix[row * n + at] - share;
        }
    }

    /// Remembers the largest entry of a closure among unknowns that are left.
    fn measure(&mut self, closure: usize) {
        let (n, rank) = (self.parts.unknowns, self.parts.rank);
        let row = n + closure;
        let mut largest = (0.0, 0);
        for column in self.order.list(row) {
            let at = usize::from(*column);
            let size = self.matrix[row * n + at].to_f64().abs();
            if usize::from(self.order.places[at]) >= rank && (size > largest.0 || size.is_nan()) {
                largest = (size, *column);
            }
        }
        self.scan.largest[closure] = largest;
    }

    /// Puts what closures say next in the place of those that are not independent now: the same combinations of it. The
    /// multiples by which these were made stand in its place then. Gives the largest entry that is left.
    fn go_on(&mut self) -> f64 {
        let (n, m, r) = (self.parts.unknowns, self.parts.closures, self.parts.rank);
        self.scan.first.fill(0);
        for i in 0..m {
            let closure = usize::from(self.order.rows[i]);
            let (own, next) = (n + closure, n + m + closure);
            for index in 0..usize::from(self.order.lengths[own]) {
                let column = usize::from(self.order.lists[own * n + index]);
                let j = usize::from(self.order.places[column]);
                if j < i.min(r) {
                    let multiple = self.matrix[own * n + column];
                    self.subtract(next, (self.pivot(j).1 + m, multiple), 0);
                }
            }
            if i < r {
                continue;
            }
            self.swap(own, next);
            for index in 0..usize::from(self.order.lengths[own]) {
                self.link(closure, usize::from(self.order.lists[own * n + index]));
            }
            for j in 0..r {
                let (column, pivot) = self.pivot(j);
                if self.order.list(own).contains(&(column as u16)) {
                    let multiple = self.matrix[own * n + column] / self.matrix[pivot * n + column];
                    self.matrix[own * n + column] = multiple;
                    self.subtract(own, (pivot, multiple), j + 1);
                }
            }
            self.measure(closure);
        }
        let left = self.scan.largest.iter().map(|own| own.0);
        left.fold(0.0, |most, own| if own.is_nan() { own } else { f64::max(most, own) })
    }

    /// Lets two rows change places.
    fn swap(&mut self, own: usize, next: usize) {
        let n = self.parts.unknowns;
        for at in 0..n {
            self.matrix.swap(own * n + at, next * n + at);
            self.order.lists.swap(own * n + at, next * n + at);
        }
        self.order.lengths.swap(own, next);
    }

    /// The unknown that is determined at a place of the order, and the row by which.
    fn pivot(&self, at: usize) -> (usize, usize) {
        let row = self.parts.unknowns + usize::from(self.order.rows[at]);
        (usize::from(self.order.columns[at]), row)
    }

    /// Writes `Z`: what a freedom moves of each determined unknown.
    fn span(&mut self) {
        let (n, r) = (self.parts.unknowns, self.parts.rank);
        for freedom in 0..n - r {
            let z = freedom * n + n - r;
            for i in (0..r).rev() {
                let (own, row) = self.pivot(i);
                let mut sum = S::ZERO;
                for column in self.order.list(row) {
                    let column = usize::from(*column);
                    let (place, entry) =
                        (usize::from(self.order.places[column]), self.matrix[row * n + column]);
                    if place == r + freedom {
                        sum = sum - entry;
                    } else if i < place && place < r {
                        sum = sum - entry * self.reduced[z + place];
                    }
                }
                self.reduced[z + i] = sum / self.matrix[row * n + own];
            }
        }
    }

    /// Writes the masses of the free motion, `Zᵀ A Z`, factored as `L D Lᵀ`.
    fn reduce(&mut self) {
        let (n, r) = (self.parts.unknowns, self.parts.rank);
        let free = n - r;
        for j in 0..free {
            for i in 0..=j {
                self.reduced[j * n + i] = self.along(j, r + i);
            }
            for place in 0..r {
                let force = self.along(j, place);
                for i in 0..=j {
                    let z = self.reduced[i * n + free + place];
                    self.reduced[j * n + i] = self.reduced[j * n + i] + z * force;
                }
            }
        }
        for j in 0..free {
            for i in 0..j {
                let mut entry = self.reduced[j * n + i];
                for inner in 0..i {
                    let product = self.reduced[j * n + inner] * self.reduced[inner * n + inner];
                    entry = entry - self.reduced[i * n + inner] * product;
                }
                self.reduced[j * n + i] = entry / self.reduced[i * n + i];
            }
            let mut pivot = self.reduced[j * n + j];
            for inner in 0..j {
                let entry = self.reduced[j * n + inner];
                pivot = pivot - entry * (entry * self.reduced[inner * n + inner]);
            }
            self.reduced[j * n + j] = pivot;
        }
    }

    /// The force of the masses of the unknown at a place of the order when a freedom moves by one.
    #[inline]
    fn along(&self, freedom: usize, place: usize) -> S {
        let (n, r) = (self.parts.unknowns, self.parts.rank);
        let row = usize::from(self.order.columns[place]);
        let mut sum = S::ZERO;
        for (place, mass) in self.order.entries(self.matrix, row) {
            if place == r + freedom {
                sum = sum + mass;
            } else if place < r {
                sum = sum + mass * self.reduced[freedom * n + n - r + place];
            }
        }
        sum
    }
}
