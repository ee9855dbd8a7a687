//! Choice of the fastest scalar type on the machine at hand.
//!
//! A program is compiled for the oldest machine that it shall run on. Work that is worth it goes through [`dispatch`],
//! which asks the processor once and, where it has fused and packed instructions, runs a copy compiled for them.

#[cfg(target_arch = "x86_64")]
use crate::scalar::F64x8;
pub use crate::scalar::processor::is_fused;
use crate::scalar::{Fused, Pack};

/// Work that may run on any scalar type.
///
/// Mark [`Task::run`] and everything below it `#[inline(always)]`: only what is inlined into the copy for newer
/// processors uses their instructions. What is too long for that goes through
/// [`Scalar::outline`](crate::scalar::Scalar::outline), as all does that the
/// macros emit. Arithmetic inside `array::map` may escape; write a loop instead.
pub trait Task {
    /// What the work gives.
    type Output;

    /// Does the work; most is written for any [`Scalar`](crate::scalar::Scalar).
    fn run<S: Pack>(self) -> Self::Output;
}

/// Runs the task on numbers whose products and sums are fused where these are fast, on `f64` elsewhere.
#[inline]
pub fn dispatch<T: Task>(task: T) -> T::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if is_fused() {
            // SAFETY: the processor has the instructions that the function is compiled for.
            return unsafe { run_fused(task) };
        }
        task.run::<f64>()
    }
    #[cfg(target_arch = "aarch64")]
    {
        task.run::<Fused>()
    }
    #[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
    {
        task.run::<f64>()
    }
}

/// The copy of a task for processors with fused and 256-bit packed instructions.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
unsafe fn run_fused<T: Task>(task: T) -> T::Output {
    task.run::<Fused>()
}

/// Runs the task on packs of several numbers where the processor has instructions for them, on single ones elsewhere.
#[inline]
pub fn dispatch_packs<T: Task>(task: T) -> T::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if is_fused() {
            // SAFETY: the processor has the instructions that the function is compiled for.
            return unsafe { run_packed(task) };
        }
        task.run::<f64>()
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        dispatch(task)
    }
}

/// The copy of a task for packs.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
unsafe fn run_packed<T: Task>(task: T) -> T::Output {
    task.run::<F64x8>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number that differs between fused and plain types.
    struct Residue(f64);

    impl Task for Residue {
        type Output = (f64, &'static str);

        #[inline(always)]
        fn run<S: Pack>(self) -> Self::Output {
            let x = S::from_f64(self.0);
            (x.mul_add(x, -(x * x)).to_f64(), std::any::type_name::<S>())
        }
    }

    #[test]
    fn type_follows_the_processor() {
        let x = 1.0 + 2f64.powi(-30);
        let (residue, name) = dispatch(Residue(x));
        if is_fused() {
            assert_eq!(residue, 2f64.powi(-60));
            assert!(name.ends_with("Fused"));
        } else {
            assert_eq!(residue, 0.0);
            assert_eq!(name, "f64");
        }
    }

    /// Sines of four angles.
    struct Sines([f64; 4]);

    impl Task for Sines {
        type Output = [f64; 4];

        #[inline(always)]
        fn run<S: Pack>(self) -> Self::Output {
            S::sin_cos_all(self.0.map(S::from_f64)).0.map(S::to_f64)
        }
    }

    #[test]
    fn compiled_copies_give_the_same_bits() {
        let angles = [0.3, -40.0, 2.0e4, 1.0e9];
        let expected =
            if is_fused() { Sines(angles).run::<Fused>() } else { Sines(angles).run::<f64>() };
        assert_eq!(dispatch(Sines(angles)), expected);
    }
}
