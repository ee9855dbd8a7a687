//! Taylor series term by term: what emitted code computes the series of a motion with.
//!
//! A function of the time is `u(t + θ h) = u₀ + u₁ θ + u₂ θ² + …`. The terms of all quantities are found together, one
//! order after the other: those of the rates give the next ones of the state. What is linear is linear in the terms; each
//! product, quotient and function is an object that remembers the terms so far and gives the next one from the next terms
//! of its operands. Recurrences: A. Griewank, A. Walther: *Evaluating Derivatives*, 2nd edition, section 13.2; for most
//! functions they follow from `f(u)' = f'(u) u'`, that is `k f_k = Σ j u_j g_(k-j)` where `g = f'(u)`.

mod function;
mod solve;

pub use function::{
    Acos, Asin, Atan, Atan2, Cosh, Erf, Exp, ExpM1, Hypot, Ln, Ln1p, Log10, NormalCdf, Power, Sine,
    Sinh, Sqrt, Tan, Tanh, Turn,
};
pub use solve::{Matrix, MatrixRows};

use crate::scalar::Scalar;

/// Most terms of a series, the first one among them.
pub const TERMS: usize = 24;

/// `1/k`; 0 for 0.
const INVERSE: [f64; TERMS + 1] = {
    let mut inverse = [0.0; TERMS + 1];
    let mut k = 1;
    while k <= TERMS {
        inverse[k] = 1.0 / k as f64;
        k += 1;
    }
    inverse
};

/// `1/k`; 0 for 0.
#[inline(always)]
pub fn inverse<S: Scalar>(k: usize) -> S {
    S::from_f64(INVERSE[k])
}

/// A term of the series of 1.
#[inline(always)]
pub fn one<S: Scalar>(k: usize) -> S {
    match k {
        0 => S::ONE,
        _ => S::ZERO,
    }
}

/// A term of the series of the time, which goes on by a length.
#[inline(always)]
pub fn time<S: Scalar>(k: usize, time: S, length: S) -> S {
    match k {
        0 => time,
        1 => length,
        _ => S::ZERO,
    }
}

/// The terms of a series so far.
type Terms<S> = [S; TERMS];

/// No terms yet.
const fn none<S: Scalar>() -> Terms<S> {
    [S::ZERO; TERMS]
}

/// `Σ left_j right_(k-j)` for `j` from `first` to `last`.
#[inline(never)]
fn sum<S: Scalar>(left: &Terms<S>, right: &Terms<S>, (first, last): (usize, usize), k: usize) -> S {
    if first > last {
        return S::ZERO;
    }
    let (left, right) = (&left[first..=last], &right[k - last..=k - first]);
    let (pairs, rest) = left.as_chunks::<2>();
    let (other, others) = right.as_rchunks::<2>();
    // Two sums at a time: each would have to wait for itself.
    let mut sums = [S::ZERO; 2];
    for ([one, two], [b, a]) in pairs.iter().zip(others.iter().rev()) {
        sums = [a.mul_add(*one, sums[0]), b.mul_add(*two, sums[1])];
    }
    let total = sums[0] + sums[1];
    match (rest, other) {
        ([one], [a]) => a.mul_add(*one, total),
        _ => total,
    }
}

/// A quantity that a factor switches off where that is zero: its next term, or none.
#[inline(always)]
pub fn unless_zero<S: Scalar>(factor: S, next: impl FnOnce() -> S) -> S {
    match factor.to_f64() == 0.0 {
        true => S::ZERO,
        false => next(),
    }
}

/// The product of two quantities.
#[derive(Clone, Debug)]
pub struct Product<S> {
    left: Terms<S>,
    right: Terms<S>,
    /// The numbers of the last terms that are not zero.
    last: (usize, usize),
}

impl<S: Scalar> Default for Product<S> {
    fn default() -> Self {
        Self { left: none(), right: none(), last: (0, 0) }
    }
}

impl<S: Scalar> Product<S> {
    /// The next term.
    #[inline(never)]
    pub fn next(&mut self, k: usize, left: S, right: S) -> S {
        (self.left[k], self.right[k]) = (left, right);
        if left.to_f64() != 0.0 {
            self.last.0 = k;
        }
        if right.to_f64() != 0.0 {
            self.last.1 = k;
        }
        match self.last {
            (_, 0) => left * self.right[0],
            (0, _) => self.left[0] * right,
            (left, right) => sum(&self.left, &self.right, (k - right, left), k),
        }
    }
}

/// The quotient of two quantities.
#[derive(Clone, Debug)]
pub struct Quotient<S> {
    below: Terms<S>,
    value: Terms<S>,
}

impl<S: Scalar> Default for Quotient<S> {
    fn default() -> Self {
        Self { below: none(), value: none() }
    }
}

impl<S: Scalar> Quotient<S> {
    /// The next term.
    #[inline(never)]
    pub fn next(&mut self, k: usize, above: S, below: S) -> S {
        self.below[k] = below;
        let known = sum(&self.below, &self.value, (1, k), k);
        self.value[k] = (above - known) / self.below[0];
        self.value[k]
    }
}

#[cfg(test)]
mod tests;
