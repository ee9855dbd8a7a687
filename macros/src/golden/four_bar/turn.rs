/// A crank-rocker.
///
/// Scene `turn`.
///
/// ```text
/// closure frame: a*dir(phi) + b*dir(theta) = [d, 0 m] + c*dir(psi)   [m]  four_bar.eqn:10
/// ```
///
/// Parameters:
///
/// | name | value |  |  |
/// |---|---|---|---|
/// | `a` | `20 mm ± 0.02 mm` |  | Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0. |
/// | `b` | `70 mm` |  | Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0. |
/// | `c` | `50 mm` |  | Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0. |
/// | `d` | `60 mm` |  | Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0. |
///
/// Drivers:
///
/// | name | unit |  |
/// |---|---|---|
/// | `phi` | `deg` |  |
///
/// Outputs:
///
/// | name | unit |  |
/// |---|---|---|
/// | `psi` | `deg` |  |
///
/// Operations: 22 once per parameter set, 35 per instant, 13 per position, 22 for all influence coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0: `20 mm ± 0.02 mm`; stored in SI units, `mm` is 0.001.
    pub a: f64,
    /// Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0: `70 mm`; stored in SI units, `mm` is 0.001.
    pub b: f64,
    /// Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0: `50 mm`; stored in SI units, `mm` is 0.001.
    pub c: f64,
    /// Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0: `60 mm`; stored in SI units, `mm` is 0.001.
    pub d: f64,
}
impl ::core::default::Default for Turn {
    fn default() -> Self {
        Self::from_values(&shapes_::Turn.defaults())
    }
}
impl Turn {
    /// `theta`
    pub const THETA: ::assur::shape::Subject = ::assur::shape::Subject::State(0);
    /// `psi`
    pub const PSI: ::assur::shape::Subject = ::assur::shape::Subject::State(1);
    /// What the scene is made of.
    pub const fn shape() -> &'static ::assur::shape::Shape {
        &shapes_::Turn
    }
    /// Sets all values, SI units, in the order of the fields.
    pub fn from_values(values: &[f64; 4]) -> Self {
        Self {
            a: values[0],
            b: values[1],
            c: values[2],
            d: values[3],
        }
    }
    /// All values, SI units, in the order of the fields.
    pub fn values(&self) -> [f64; 4] {
        [self.a, self.b, self.c, self.d]
    }
    /// The declared start values.
    fn start_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
        [S::from_f64(0.3490658503988659), S::from_f64(1.3962634015954636)]
    }
}
impl ::assur::closure::Linkage for Turn {
    type Closure<S: ::assur::scalar::Scalar> = TurnEquations<S>;
    const PACKED: bool = !cfg!(debug_assertions);
    const IS_SOUGHT: bool = false;
    #[inline(always)]
    fn shape(&self) -> &'static ::assur::shape::Shape {
        &shapes_::Turn
    }
    fn values(&self) -> ::std::vec::Vec<f64> {
        Self::values(self).to_vec()
    }
    fn with_values(&self, values: &[f64]) -> Self {
        let mut all = [0.0; 4];
        all.copy_from_slice(values);
        Self::from_values(&all)
    }
    #[inline(always)]
    fn prepare<S: ::assur::scalar::Scalar>(&self, values: &[S]) -> Self::Closure<S> {
        let b = values[1];
        let v7_ = S::ONE / b;
        let a = values[0];
        let v9_ = S::abs(b);
        let c = values[2];
        let v11_ = S::abs(c);
        let v12_ = v9_ + v11_;
        let v13_ = v9_ - v11_;
        let d = values[3];
        let v23_ = S::ONE / c;
        TurnEquations {
            b,
            v7_,
            a,
            c,
            v12_,
            v15_: S::from_f64(0.5) * (v12_ * v13_),
            v17_: -d,
            v18_: a * a,
            v19_: v12_ * v12_,
            v21_: -(v13_ * v13_),
            v22_: -S::from_f64(0.5) * a,
            v23_,
            v25_: S::from_f64(0.5) / (v9_ * v11_),
            v27_: -S::abs(v13_),
            v28_: a * c,
            v29_: v7_ * v23_,
            v30_: b * a,
            v31_: b * c,
        }
    }
    fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
        ::assur::registry::check_values(shapes_::Turn.constants, &self.values())?;
        ::core::result::Result::Ok(())
    }
    fn span(&self) -> ::assur::problem::Span {
        ::assur::problem::Span::Open
    }
    fn drive(&self, time: f64) -> ::core::option::Option<::std::vec::Vec<f64>> {
        ::core::option::Option::None
    }
    fn ranges(&self) -> ::std::vec::Vec<::assur::closure::Range> {
        ::std::vec![
            ::assur::closure::Range { from : 0.0, to : 6.283185307179586, start :
            1.0471975511965976, period : 6.283185307179586 }
        ]
    }
    fn start(&self) -> ::std::vec::Vec<f64> {
        self.start_::<f64>().to_vec()
    }
}
