impl<S: ::assur::scalar::Scalar> ::assur::problem::Reports<S> for ElasticEquations<S> {
    /// 116 operations.
    fn outputs(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        time: S,
        state: &[S],
        values: &mut [S],
    ) {
        ::assur::exact!(state, 6);
        S::outline(
            #[inline(always)]
            || {
                ::assur::exact!(mut values, 22);
                let phi2 = state[0];
                let w3 = state[1];
                let w4 = state[2];
                let dot_phi2 = state[3];
                let dot_w3 = state[4];
                let dot_w4 = state[5];
                let theta = self.n * time;
                let shaft = self.c * phi2;
                let x_difference = w3 - w4;
                let v_difference = dot_w3 - dot_w4;
                let ([sin_theta_, sin_v134_], [cos_theta_, _]) = S::sin_cos_all([
                    theta,
                    self.v71_ * time,
                ]);
                let v94_ = sin_theta_ * sin_theta_;
                let v96_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v100_ = S::ONE
                    / S::mul_add(self.v12_, v94_ * (v96_ * v96_), self.J2);
                let v101_ = v96_ * sin_theta_;
                let v102_ = self.R * v101_;
                let v105_ = v96_ * cos_theta_;
                let ddot_x1 = S::mul_add(self.v32_, v105_, self.v31_ * v94_);
                let v108_ = S::mul_add(self.v33_, cos_theta_, -S::ONE);
                let v112_ = S::mul_add(self.v36_, v105_, self.v35_ * v94_);
                let v113_ = S::from_f64(2.0) * v112_;
                let x1 = self.R
                    * S::mul_add(
                        -self.v72_,
                        v94_,
                        S::from_f64(2.0) * (sin_v134_ * sin_v134_),
                    );
                let dot_x1 = self.v36_ * v101_;
                let u4 = S::mul_add(self.v27_ * v101_, phi2, w4);
                let u3 = S::mul_add(-(self.v28_ * v101_), phi2, w3);
                let v155_ = S::mul_add(-self.d34, u4, self.d44 * u3);
                let v157_ = S::mul_add(
                    -v113_,
                    dot_phi2,
                    S::mul_add(-(self.v32_ * (sin_theta_ * v108_)), phi2, ddot_x1),
                );
                let v159_ = S::mul_add(-self.v38_, u3, self.v37_ * u4);
                let x2 = S::mul_add(-v102_, phi2, x1);
                let x3 = x1 + w3;
                let x4 = x1 + w4;
                let v185_ = v96_ * v100_
                    * S::mul_add(
                        v102_,
                        S::mul_add(
                            -self.m2,
                            v157_,
                            self.v23_
                                * S::mul_add(
                                    -self.lambda,
                                    v155_,
                                    self.v26_ * S::mul_add(-self.d34, u3, self.d33 * u4),
                                ),
                        ),
                        shaft,
                    );
                let ddot_x2 = S::mul_add(
                    self.R * sin_theta_,
                    S::mul_add(-(self.v29_ * v108_), phi2, v185_),
                    S::mul_add(-v113_, dot_phi2, ddot_x1),
                );
                let ddot_x3 = S::mul_add(
                    self.v40_,
                    S::mul_add(-self.v23_, v155_, -(self.m3 * ddot_x1)),
                    ddot_x1,
                );
                let ddot_x4 = S::mul_add(
                    self.v42_,
                    -(self.m4 * ddot_x1) - v159_,
                    ddot_x1,
                );
                let F1 = S::mul_add(
                    self.v74_,
                    ddot_x3,
                    S::mul_add(-self.v75_, ddot_x4, self.m1 * ddot_x1),
                );
                let F2 = S::mul_add(
                    self.m2,
                    ddot_x2,
                    S::mul_add(-self.v76_, ddot_x3, self.v77_ * ddot_x4),
                );
                let drive_torque = S::mul_add(v102_, F1, shaft);
                let F_difference = F1 - F2;
                values[0] = x1;
                values[1] = x2;
                values[2] = x3;
                values[3] = x4;
                values[4] = dot_x1;
                values[5] = S::mul_add(
                    -v112_,
                    phi2,
                    S::mul_add(-v102_, dot_phi2, dot_x1),
                );
                values[6] = dot_x1 + dot_w3;
                values[7] = dot_x1 + dot_w4;
                values[8] = ddot_x1;
                values[9] = ddot_x2;
                values[10] = ddot_x3;
                values[11] = ddot_x4;
                values[12] = phi2;
                values[13] = dot_phi2;
                values[14] = v100_
                    * S::mul_add(
                        -self.c,
                        phi2,
                        v102_
                            * S::mul_add(
                                -self.v26_,
                                v159_,
                                S::mul_add(self.v25_, v155_, self.m2 * v157_),
                            ),
                    );
                values[15] = F1;
                values[16] = F2;
                values[17] = drive_torque;
                values[18] = shaft;
                values[19] = x_difference;
                values[20] = v_difference;
                values[21] = F_difference;
            },
        )
    }
    fn drivers(&self, time: S, values: &mut [S]) {
        S::outline(
            #[inline(always)]
            || {
                ::assur::exact!(mut values, 1);
                values[0] = self.n * time;
            },
        )
    }
    fn energy(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        time: S,
        state: &[S],
    ) -> ::core::option::Option<(S, S)> {
        S::outline(
            #[inline(always)]
            || {
                ::assur::exact!(state, 6, ::core::option::Option::None);
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
                ::core::option::Option::Some((
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
                ))
            },
        )
    }
    fn mass(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        time: S,
        state: &[S],
        rows: &mut [S],
    ) -> bool {
        S::outline(
            #[inline(always)]
            || {
                ::assur::exact!(state, 6, false);
                ::assur::exact!(mut rows, 9, false);
                let theta = self.n * time;
                let (sin_theta_, cos_theta_) = S::sin_cos(theta);
                let v96_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v99_ = S::mul_add(
                    self.v12_,
                    sin_theta_ * sin_theta_ * (v96_ * v96_),
                    self.J2,
                );
                *rows = [
                    v99_,
                    S::ZERO,
                    S::ZERO,
                    S::ZERO,
                    self.m3,
                    S::ZERO,
                    S::ZERO,
                    S::ZERO,
                    self.m4,
                ];
                true
            },
        )
    }
}
/// The first scene of the mechanism, `Elastic`.
pub type Batten = Elastic;
