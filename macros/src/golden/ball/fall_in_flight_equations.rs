/// In the mode `flight`.
#[derive(Clone, Copy, Debug)]
struct FallInFlightEquations<S: ::assur::scalar::Scalar> {
    /// `-g`
    rate_1_: S,
}
