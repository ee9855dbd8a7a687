/// In the mode `contact`.
#[derive(Clone, Copy, Debug)]
struct FallInContactEquations<S: ::assur::scalar::Scalar> {
    M: S,
    /// `1/M`
    v4_: S,
    g: S,
    /// `-M*g`
    v7_: S,
    k: S,
    /// Jacobian, rate of `dot(h)` by `h`: `-k*v4_`
    slope_1_0_: S,
}
