/// A ball that falls onto a soft floor and comes back.
///
/// Scene `fall`.
///
/// ```text
/// motion M*ddot(h) = -M*g   [N]  ball.eqn:11
/// ```
///
/// Parameters:
///
/// | name | value |  |  |
/// |---|---|---|---|
/// | `M` | `1 kg` |  |  |
/// | `g` | `9.81 m/s^2` |  |  |
/// | `k` | `10000 N/m` |  | Stiffness of the floor. |
///
/// State:
///
/// | name | unit |  |
/// |---|---|---|
/// | `h` | `m` |  |
/// | `dot(h)` | `m/s` |  |
///
/// Outputs:
///
/// | name | unit |  |
/// |---|---|---|
/// | `force` | `N` |  |
///
/// Operations: 1 once per parameter set, 0 per instant, 0 per evaluation, 0 per Jacobian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fall {
    /// Parameter: `1 kg`.
    pub M: f64,
    /// Parameter: `9.81 m/s^2`.
    pub g: f64,
    /// Stiffness of the floor: `10000 N/m`.
    pub k: f64,
}
impl ::core::default::Default for Fall {
    fn default() -> Self {
        Self::from_values(&shapes_::Fall.defaults())
    }
}
impl Fall {
    /// `h`
    pub const H: ::assur::shape::Subject = ::assur::shape::Subject::State(0);
    /// `dot(h)`
    pub const DOT_H: ::assur::shape::Subject = ::assur::shape::Subject::State(1);
    /// `force`
    pub const FORCE: ::assur::shape::Subject = ::assur::shape::Subject::Output(0);
    /// What the scene is made of.
    pub const fn shape() -> &'static ::assur::shape::Shape {
        &shapes_::Fall
    }
    /// Sets all values, SI units, in the order of the fields.
    pub fn from_values(values: &[f64; 3]) -> Self {
        Self {
            M: values[0],
            g: values[1],
            k: values[2],
        }
    }
    /// All values, SI units, in the order of the fields.
    pub fn values(&self) -> [f64; 3] {
        [self.M, self.g, self.k]
    }
    /// The period, or the first and the last time.
    fn span_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
        [S::ZERO, S::from_f64(2.0)]
    }
    /// The declared start values.
    fn start_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
        [S::ONE, S::ZERO]
    }
}
impl ::assur::problem::Scene for Fall {
    type Equations<S: ::assur::scalar::Scalar> = FallEquations<S>;
    type Unreduced = Fall;
    const SMOOTH: bool = false;
    fn shape(&self) -> &'static ::assur::shape::Shape {
        &shapes_::Fall
    }
    #[inline(always)]
    fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
        FallEquations {
            in_flight: {
                let g = <S as ::assur::scalar::Scalar>::from_f64(self.g);
                FallInFlightEquations {
                    rate_1_: -g,
                }
            },
            in_contact: {
                let M = <S as ::assur::scalar::Scalar>::from_f64(self.M);
                let v4_ = S::ONE / M;
                let g = <S as ::assur::scalar::Scalar>::from_f64(self.g);
                let k = <S as ::assur::scalar::Scalar>::from_f64(self.k);
                FallInContactEquations {
                    M,
                    v4_,
                    g,
                    v7_: -(M * g),
                    k,
                    slope_1_0_: -(k * v4_),
                }
            },
        }
    }
    fn events<S: ::assur::scalar::Scalar>(
        equations: &Self::Equations<S>,
    ) -> ::core::option::Option<&dyn ::assur::problem::Events<S>> {
        ::core::option::Option::Some(equations)
    }
    fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
        ::assur::registry::check_values(shapes_::Fall.constants, &self.values())?;
        ::core::result::Result::Ok(())
    }
    fn span(&self) -> ::assur::problem::Span {
        let [from, to] = self.span_::<f64>();
        ::assur::problem::Span::Run(from, to)
    }
    fn start(&self) -> ::std::vec::Vec<f64> {
        self.start_::<f64>().to_vec()
    }
}
