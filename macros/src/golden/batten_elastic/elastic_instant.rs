/// What the equations of [`Elastic`] need of one time.
#[derive(Clone, Copy, Debug)]
pub struct ElasticInstant<S: ::assur::scalar::Scalar> {
    /// `sin(n*time)`
    sin_theta_: S,
    /// `cos(n*time)`
    cos_theta_: S,
    /// `1/(R^2*m2*(sin_theta_^2*(1 - R*(1/l)*cos_theta_)^2) + J2)`
    v100_: S,
    /// `R*((1 - R*(1/l)*cos_theta_)*sin_theta_)`
    v102_: S,
    /// `R*(1 + lambda)*((1 - R*(1/l)*cos_theta_)*sin_theta_)`
    v103_: S,
    /// `R*lambda*((1 - R*(1/l)*cos_theta_)*sin_theta_)`
    v104_: S,
    /// `R*n^2*((1 - R*(1/l)*cos_theta_)*cos_theta_) + R^2*n^2*(1/l)*sin_theta_^2`
    ddot_x1: S,
    /// `R*n^2*(sin_theta_*(4*(R*(1/l))*cos_theta_ + (-1)))`
    v110_: S,
    /// `2*(R*n*((1 - R*(1/l)*cos_theta_)*cos_theta_) + R^2*(1/l)*n*sin_theta_^2)`
    v113_: S,
    /// `-m3*ddot_x1`
    v115_: S,
    /// `-m4*ddot_x1`
    v117_: S,
}
impl<S: ::assur::scalar::Scalar> ElasticEquations<S> {
    /// The symmetric mass matrix, in the order of the coordinates.
    #[inline(always)]
    pub fn mass_matrix(&self, time: S, state: &[S; 6]) -> [[S; 3]; 3] {
        S::outline(
            #[inline(always)]
            || {
                let theta = self.n * time;
                let (sin_theta_, cos_theta_) = S::sin_cos(theta);
                let v96_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v99_ = S::mul_add(
                    self.v12_,
                    sin_theta_ * sin_theta_ * (v96_ * v96_),
                    self.J2,
                );
                [
                    [v99_, S::ZERO, S::ZERO],
                    [S::ZERO, self.m3, S::ZERO],
                    [S::ZERO, S::ZERO, self.m4],
                ]
            },
        )
    }
    /// Kinetic and potential energy, in joules.
    #[inline(always)]
    pub fn energy(&self, time: S, state: &[S; 6]) -> (S, S) {
        S::outline(
            #[inline(always)]
            || {
                let phi2 = state[0];
                let w3 = state[1];
                let w4 = state[2];
                let dot_phi2 = state[3];
                let dot_w3 = state[4];
                let dot_w4 = state[5];
                let theta = self.n * time;
                let v200_ = self.n - dot_phi2;
                let (sin_theta_, cos_theta_) = S::sin_cos(theta);
                let v94_ = sin_theta_ * sin_theta_;
                let v96_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v101_ = v96_ * sin_theta_;
                let dot_x1 = self.v36_ * v101_;
                let u4 = S::mul_add(self.v27_ * v101_, phi2, w4);
                let u3 = S::mul_add(-(self.v28_ * v101_), phi2, w3);
                let dot_x2 = S::mul_add(
                    -S::mul_add(self.v36_, v96_ * cos_theta_, self.v35_ * v94_),
                    phi2,
                    S::mul_add(-(self.R * v101_), dot_phi2, dot_x1),
                );
                let dot_x3 = dot_x1 + dot_w3;
                let dot_x4 = dot_x1 + dot_w4;
                let v207_ = S::mul_add(
                    self.v82_,
                    dot_x4 * dot_x4,
                    S::mul_add(
                        self.v81_,
                        dot_x3 * dot_x3,
                        S::mul_add(
                            self.v80_,
                            v200_ * v200_,
                            self.v79_ * (v94_ * (v96_ * v96_)),
                        ),
                    ),
                );
                (
                    S::mul_add(self.v83_, dot_x2 * dot_x2, v207_),
                    S::mul_add(
                        self.v85_,
                        S::mul_add(
                            u3,
                            S::mul_add(-self.v86_, u4, self.d44 * u3),
                            self.d33 * (u4 * u4),
                        ),
                        self.v84_ * (phi2 * phi2),
                    ),
                )
            },
        )
    }
}
/// The first scene of the mechanism, `Elastic`.
pub type Batten = Elastic;
