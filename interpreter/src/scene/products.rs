//! Products of a Jacobian, which is known entry by entry, with columns.

use std::collections::BTreeSet;

use assur_model::program::{OperationKind, Program};
use assur_solvers::scalar::Scalar;

/// How an entry goes into a row of a product.
struct Term {
    row: usize,
    column: usize,
    kind: Kind,
}

/// What an entry is: the first of its row or not, a number or not.
enum Kind {
    Nothing,
    First,
    FirstOne,
    FirstMinus,
    One,
    Minus,
    Other,
}

/// How the entries go into the products: in the order in which emitted code adds them up.
pub struct Terms(Vec<Term>);

impl Terms {
    /// Of the Jacobian of a program.
    pub fn of(program: &Program) -> Self {
        let mut begun = BTreeSet::new();
        let entries = program.results.jacobian.iter();
        let term = entries.map(|(row, column, value)| {
            let number = match program.kind(*value) {
                OperationKind::Number(number) => *number,
                _ => f64::NAN,
            };
            let is_first = number != 0.0 && begun.insert(*row);
            let kind = match (is_first, number) {
                (_, 0.0) => Kind::Nothing,
                (true, 1.0) => Kind::FirstOne,
                (true, -1.0) => Kind::FirstMinus,
                (true, _) => Kind::First,
                (false, 1.0) => Kind::One,
                (false, -1.0) => Kind::Minus,
                (false, _) => Kind::Other,
            };
            Term { row: *row as usize, column: *column as usize, kind }
        });
        Self(term.collect())
    }

    /// Writes the products with columns of a length.
    pub fn multiply<S: Scalar>(
        &self,
        entries: &[S],
        length: usize,
        columns: &[S],
        products: &mut [S],
    ) {
        products.fill(S::ZERO);
        S::outline(
            #[inline(always)]
            || {
                for (term, entry) in self.0.iter().zip(entries.iter().copied()) {
                    // Each choice has a loop of its own: it is made once for all columns.
                    let mut add = Products { term, length, columns, products: &mut *products };
                    match term.kind {
                        Kind::Nothing => {}
                        Kind::First => add.each(|_, other| entry * other),
                        Kind::FirstOne => add.each(|_, other| other),
                        Kind::FirstMinus => add.each(|_, other| -other),
                        Kind::One => add.each(|sum, other| sum + other),
                        Kind::Minus => add.each(|sum, other| sum - other),
                        Kind::Other => add.each(|sum, other| entry.mul_add(other, sum)),
                    }
                }
            },
        );
    }
}

/// What an entry changes of the products.
struct Products<'a, S> {
    term: &'a Term,
    length: usize,
    columns: &'a [S],
    products: &'a mut [S],
}

impl<S: Scalar> Products<'_, S> {
    /// The product with each column, from what it has been and from what of the column the entry is multiplied with.
    #[inline(always)]
    fn each(&mut self, new: impl Fn(S, S) -> S) {
        let (sums, others) =
            (&mut self.products[self.term.row..], &self.columns[self.term.column..]);
        let (length, mut at) = (self.length, 0);
        while let (Some(sum), Some(other)) = (sums.get_mut(at), others.get(at)) {
            *sum = new(*sum, *other);
            at += length;
        }
    }
}
