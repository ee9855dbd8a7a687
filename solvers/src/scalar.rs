//! Numbers that equations are evaluated on.

/// A number: `f64`, `f32`, fused `f64`, a pack of lanes, a dual number.
///
/// A comparison gives a mask and a branch becomes a selection, so that several lanes may take different sides.
pub trait Scalar:
    Copy
    + std::fmt::Debug
    + Send
    + Sync
    + 'static
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Div<Output = Self>
    + std::ops::Neg<Output = Self>
{
    /// Result of a comparison.
    type Mask: Copy + std::fmt::Debug;
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;
    /// The number, in all lanes.
    fn from_f64(value: f64) -> Self;
    /// The number (that of the first lane, or the value part).
    fn to_f64(self) -> f64;
    /// `self * factor + term`, rounded once where the type is fused.
    fn mul_add(self, factor: Self, term: Self) -> Self;
}
