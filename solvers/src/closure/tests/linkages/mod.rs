//! Linkages written by hand, as the compiler would emit them.

mod four_bar;
mod heald;
mod six_bar;
mod slider_crank;

pub use four_bar::{FourBar, Iterated};
pub use heald::Heald;
pub use six_bar::SixBar;
pub use slider_crank::SliderCrank;

use crate::scalar::Scalar;

/// What the tests do not ask of a linkage.
macro_rules! unasked {
    ($scalar:ident) => {
        fn influence(&self, _: &Self::Instant, _: &Self::Position, _: &mut [$scalar]) {}
        fn second_influence(&self, _: &Self::Instant, _: &Self::Position, _: &mut [$scalar]) {}
        fn points(&self, _: &Self::Instant, _: &Self::Position, _: &mut [$scalar]) {}
    };
}

/// The constants of a linkage that is a struct of one array.
macro_rules! constants {
    () => {
        fn shape(&self) -> &'static Shape {
            const { &SHAPE }
        }
        fn values(&self) -> Vec<f64> {
            self.values.to_vec()
        }
        fn with_values(&self, values: &[f64]) -> Self {
            let mut linkage = Self::default();
            linkage.values.copy_from_slice(values);
            linkage
        }
        fn check(&self) -> Result<(), Refused> {
            Ok(())
        }
    };
}
pub(crate) use {constants, unasked};

/// Two links joined by a pivot, `l2 dir(a) - l3 dir(b) = d`.
#[derive(Clone, Copy)]
pub struct Dyad<S> {
    pub l2: S,
    pub l3: S,
}

/// Cosines and sines of both angles.
pub type Directions<S> = [S; 4];

impl<S: Scalar> Dyad<S> {
    /// The sine of the angle between the links and their directions.
    #[inline(always)]
    pub fn close(&self, [x, y]: [S; 2], mode: S) -> (S, Directions<S>) {
        let (l2, l3) = (self.l2, self.l3);
        let square = x * x + y * y;
        let r = square.sqrt();
        let area = (l2 + l3 - r) * (l2 + l3 + r) * (r - (l2 - l3)) * (r + (l2 - l3));
        let half = S::from_f64(0.5);
        let root = mode * area.sqrt() * half;
        let p = half * (square + (l2 - l3) * (l2 + l3));
        // l2 dir(a) and l3 dir(b), times r²
        let a = [p * x + root * y, p * y - root * x];
        let b = [a[0] - square * x, a[1] - square * y];
        let (scale_a, scale_b) = (S::ONE / (square * l2), S::ONE / (square * l3));
        let directions = [a[0] * scale_a, a[1] * scale_a, b[0] * scale_b, b[1] * scale_b];
        (root / (l2 * l3), directions)
    }

    pub fn margin(&self, [x, y]: [S; 2]) -> S {
        let r = (x * x + y * y).sqrt();
        (self.l2 + self.l3 - r).min(r - (self.l2 - self.l3).abs())
    }

    /// Residuals and Jacobian.
    pub fn trial(&self, [ca, sa, cb, sb]: Directions<S>, [x, y]: [S; 2]) -> ([S; 2], [S; 4]) {
        let (l2, l3) = (self.l2, self.l3);
        ([l2 * ca - l3 * cb - x, l2 * sa - l3 * sb - y], [-l2 * sa, l3 * sb, l2 * ca, -l3 * cb])
    }

    /// Rates of both angles for a rate of `d`.
    pub fn rates(&self, [ca, sa, cb, sb]: Directions<S>, [x, y]: [S; 2]) -> [S; 2] {
        let sine = sa * cb - ca * sb;
        [-(x * cb + y * sb) / (self.l2 * sine), -(x * ca + y * sa) / (self.l3 * sine)]
    }
}

/// Sines and cosines of two angles as directions.
pub fn directions<S: Scalar>(a: S, b: S) -> Directions<S> {
    let (sines, cosines) = S::sin_cos_all([a, b]);
    [cosines[0], sines[0], cosines[1], sines[1]]
}
