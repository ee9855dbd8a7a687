//! Bound systems whose size is known at run time.

use super::{NOTHING, Order, Parts, Reading, Scan, Writing};
use crate::scalar::Scalar;

/// What [`Bound`](super::Bound) is, of a size that is known at run time; with the room for factoring it again.
#[derive(Clone, Debug)]
pub struct BoundRows<S> {
    parts: Parts,
    rank: usize,
    matrix: Vec<S>,
    reduced: Vec<S>,
    lists: Vec<u16>,
    lengths: Vec<u16>,
    rows: Vec<u16>,
    columns: Vec<u16>,
    places: Vec<u16>,
    largest: Vec<(f64, u16)>,
    first: Vec<u16>,
    next: Vec<u16>,
}

impl<S: Scalar> BoundRows<S> {
    /// Room for a system of so many rows and unknowns, of whose closures so many are independent at most.
    pub fn new(rows: usize, unknowns: usize, rank: usize) -> Self {
        let closures = (rows - unknowns) / 2;
        Self {
            parts: Parts { unknowns, closures, rank, lasting: Some(0) },
            rank,
            matrix: vec![S::ZERO; rows * unknowns],
            reduced: vec![S::ZERO; unknowns * unknowns],
            lists: vec![0; rows * unknowns],
            lengths: vec![0; rows],
            rows: vec![0; rows],
            columns: vec![0; unknowns],
            places: vec![0; unknowns],
            largest: vec![(0.0, 0); closures],
            first: vec![0; unknowns],
            next: vec![0; rows * unknowns],
        }
    }

    /// See [`factor_bound`](super::factor_bound).
    pub fn factor(&mut self, write: impl FnOnce(&mut Writing<'_, S>)) {
        (self.parts.rank, self.parts.lasting) = (self.rank, Some(0));
        self.reduced.fill(S::ZERO);
        let mut writing = Writing {
            parts: &mut self.parts,
            matrix: &mut self.matrix,
            reduced: &mut self.reduced,
            order: Order {
                lists: &mut self.lists[..],
                lengths: &mut self.lengths[..],
                rows: &mut self.rows[..],
                columns: &mut self.columns[..],
                places: &mut self.places[..],
            },
            scan: Scan { largest: &mut self.largest, first: &mut self.first, next: &mut self.next },
        };
        writing.clear();
        write(&mut writing);
        writing.factor(NOTHING);
    }

    /// Solves in place: a right-hand side for each row, and as much room.
    pub fn solve(&self, right: &mut [S], room: &mut [S]) {
        let order = Order {
            lists: &self.lists[..],
            lengths: &self.lengths[..],
            rows: &self.rows[..],
            columns: &self.columns[..],
            places: &self.places[..],
        };
        let Self { parts, matrix, reduced, .. } = self;
        Reading { parts, matrix, reduced, order }.solve(right, room);
    }
}
