//! Room for some numbers, on the stack as long as there are few.

use assur_solvers::scalar::Scalar;

/// Does something with room for so many numbers.
#[inline(always)]
pub fn room<S: Scalar, R>(count: usize, mut work: impl FnMut(&mut [S]) -> R) -> R {
    match count {
        0..=16 => work(&mut [S::ZERO; 16][..count]),
        17..=64 => work(&mut [S::ZERO; 64][..count]),
        65..=1024 => work(&mut [S::ZERO; 1024][..count]),
        _ => work(&mut vec![S::ZERO; count]),
    }
}
