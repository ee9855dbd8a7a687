/// What the equations of [`Turn`] need of one time.
#[derive(Clone, Copy, Debug)]
pub struct TurnInstant<S: ::assur::scalar::Scalar> {
    /// `sin(phi)`
    sin_phi_: S,
    /// `cos(phi)`
    cos_phi_: S,
    /// `-d + a*cos_phi_`
    v40_: S,
    /// `a*sin_phi_`
    v46_: S,
    /// `-v46_*(0.5*((abs(b) + abs(c))*(abs(b) - abs(c)))*(1/(a^2*sin_phi_^2 + v40_^2)) + 0.5)`
    v48_: S,
    v55_: S,
    /// `-v40_*(0.5*((abs(b) + abs(c))*(abs(b) - abs(c)))*(1/(a^2*sin_phi_^2 + v40_^2)) + 0.5)`
    v57_: S,
    v60_: S,
    /// `v46_*(0.5 - 0.5*((abs(b) + abs(c))*(abs(b) - abs(c)))*(1/(a^2*sin_phi_^2 + v40_^2)))`
    v62_: S,
    /// `v40_*(0.5 - 0.5*((abs(b) + abs(c))*(abs(b) - abs(c)))*(1/(a^2*sin_phi_^2 + v40_^2)))`
    v63_: S,
    v64_: S,
    v68_: S,
}
/// The first scene of the mechanism, `Turn`.
pub type FourBar = Turn;
