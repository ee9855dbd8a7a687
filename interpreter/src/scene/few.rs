//! Numbers whose count the run knows, in place as long as they are few.

use assur_solvers::problem::Storage;
use assur_solvers::scalar::Scalar;

/// So many are kept in place.
const FEW: usize = 32;

/// Some numbers.
#[derive(Clone, Debug)]
pub enum Few<S> {
    /// In place, and how many of them.
    Placed([S; FEW], usize),
    /// More than find place.
    Many(Vec<S>),
}

impl<S: Scalar> Storage<S> for Few<S> {
    #[inline]
    fn zeros(length: usize) -> Self {
        match length <= FEW {
            true => Self::Placed([S::ZERO; FEW], length),
            false => Self::Many(vec![S::ZERO; length]),
        }
    }
}

impl<S> AsRef<[S]> for Few<S> {
    #[inline(always)]
    fn as_ref(&self) -> &[S] {
        match self {
            Self::Placed(all, length) => &all[..*length],
            Self::Many(all) => all,
        }
    }
}

impl<S> AsMut<[S]> for Few<S> {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [S] {
        match self {
            Self::Placed(all, length) => &mut all[..*length],
            Self::Many(all) => all,
        }
    }
}
