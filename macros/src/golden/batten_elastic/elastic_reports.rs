impl<S: ::assur::scalar::Scalar> ::assur::problem::Reports<S> for ElasticEquations<S> {
    /// 112 operations.
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
                ::assur::exact!(mut values, 24);
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
                let ([sin_theta_, sin_v137_, sin_v193_], [cos_theta_, _, _]) = S::sin_cos_all([
                    theta,
                    self.v71_ * time,
                    theta - phi2,
                ]);
                let v97_ = sin_theta_ * sin_theta_;
                let v99_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v103_ = S::ONE
                    / S::mul_add(self.v12_, v97_ * (v99_ * v99_), self.J2);
                let v104_ = v99_ * sin_theta_;
                let v105_ = self.R * v104_;
                let v108_ = v99_ * cos_theta_;
                let ddot_x1 = S::mul_add(self.v34_, v108_, self.v33_ * v97_);
                let v115_ = S::mul_add(self.v37_, v108_, self.v36_ * v97_);
                let x1 = self.R
                    * S::mul_add(
                        -self.v72_,
                        v97_,
                        S::from_f64(2.0) * (sin_v137_ * sin_v137_),
                    );
                let dot_x1 = self.v37_ * v104_;
                let u4 = S::mul_add(self.v27_ * v104_, phi2, w4);
                let u3 = S::mul_add(-(self.v29_ * v104_), phi2, w3);
                let v159_ = S::mul_add(-self.v25_, u4, self.v28_ * u3);
                let v161_ = S::mul_add(-self.v25_, u3, self.v30_ * u4);
                let v164_ = ddot_x1
                    - S::mul_add(
                        S::from_f64(2.0) * v115_,
                        dot_phi2,
                        self.v34_
                            * (sin_theta_ * S::mul_add(self.v35_, cos_theta_, -S::ONE))
                            * phi2,
                    );
                let v167_ = S::mul_add(
                    -self.v26_,
                    v161_,
                    S::mul_add(self.lambda, v159_, self.m2 * v164_),
                );
                let x2 = S::mul_add(-v105_, phi2, x1);
                let x3 = x1 + w3;
                let x4 = x1 + w4;
                let ddot_x2 = S::mul_add(
                    self.R * (v104_ * v103_),
                    S::mul_add(-v105_, v167_, shaft),
                    v164_,
                );
                let ddot_x3 = S::mul_add(
                    self.v39_,
                    -(self.m3 * ddot_x1) - v159_,
                    ddot_x1,
                );
                let ddot_x4 = S::mul_add(
                    self.v41_,
                    -(self.m4 * ddot_x1) - v161_,
                    ddot_x1,
                );
                let F1 = S::mul_add(
                    -self.v75_,
                    ddot_x4,
                    S::mul_add(self.v74_, ddot_x3, self.m1 * ddot_x1),
                );
                let F2 = S::mul_add(
                    self.m2,
                    ddot_x2,
                    S::mul_add(-self.v77_, ddot_x3, self.v76_ * ddot_x4),
                );
                let rod1 = S::ONE / S::sqrt(S::mul_add(-self.v80_, v97_, S::ONE)) * F1;
                let rod2 = F2
                    / S::sqrt(S::mul_add(-self.v80_, sin_v193_ * sin_v193_, S::ONE));
                let drive_torque = S::mul_add(v105_, F1, shaft);
                let F_difference = F1 - F2;
                values[0] = x1;
                values[1] = x2;
                values[2] = x3;
                values[3] = x4;
                values[4] = dot_x1;
                values[5] = S::mul_add(
                    -v115_,
                    phi2,
                    S::mul_add(-v105_, dot_phi2, dot_x1),
                );
                values[6] = dot_x1 + dot_w3;
                values[7] = dot_x1 + dot_w4;
                values[8] = ddot_x1;
                values[9] = ddot_x2;
                values[10] = ddot_x3;
                values[11] = ddot_x4;
                values[12] = phi2;
                values[13] = dot_phi2;
                values[14] = v103_ * S::mul_add(-self.c, phi2, v105_ * v167_);
                values[15] = F1;
                values[16] = F2;
                values[17] = rod1;
                values[18] = rod2;
                values[19] = drive_torque;
                values[20] = shaft;
                values[21] = x_difference;
                values[22] = v_difference;
                values[23] = F_difference;
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
                let v203_ = self.n - dot_phi2;
                let (sin_theta_, cos_theta_) = S::sin_cos(theta);
                let v97_ = sin_theta_ * sin_theta_;
                let v99_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v104_ = v99_ * sin_theta_;
                let dot_x1 = self.v37_ * v104_;
                let u4 = S::mul_add(self.v27_ * v104_, phi2, w4);
                let u3 = S::mul_add(-(self.v29_ * v104_), phi2, w3);
                let dot_x2 = S::mul_add(
                    -S::mul_add(self.v37_, v99_ * cos_theta_, self.v36_ * v97_),
                    phi2,
                    S::mul_add(-(self.R * v104_), dot_phi2, dot_x1),
                );
                let dot_x3 = dot_x1 + dot_w3;
                let dot_x4 = dot_x1 + dot_w4;
                let v210_ = S::mul_add(
                    self.v85_,
                    dot_x4 * dot_x4,
                    S::mul_add(
                        self.v84_,
                        dot_x3 * dot_x3,
                        S::mul_add(
                            self.v83_,
                            v203_ * v203_,
                            self.v82_ * (v97_ * (v99_ * v99_)),
                        ),
                    ),
                );
                ::core::option::Option::Some((
                    S::mul_add(self.v86_, dot_x2 * dot_x2, v210_),
                    S::mul_add(
                        self.v88_,
                        S::mul_add(
                            u3,
                            S::mul_add(-self.v89_, u4, self.d44 * u3),
                            self.d33 * (u4 * u4),
                        ),
                        self.v87_ * (phi2 * phi2),
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
                let v99_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v102_ = S::mul_add(
                    self.v12_,
                    sin_theta_ * sin_theta_ * (v99_ * v99_),
                    self.J2,
                );
                *rows = [
                    v102_,
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
    fn measured(
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
                ::assur::exact!(mut values, 7);
                let phi2 = state[0];
                let w3 = state[1];
                let w4 = state[2];
                let dot_phi2 = state[3];
                let theta = self.n * time;
                let shaft = self.c * phi2;
                let ([sin_theta_, sin_v193_], [cos_theta_, _]) = S::sin_cos_all([
                    theta,
                    theta - phi2,
                ]);
                let v97_ = sin_theta_ * sin_theta_;
                let v99_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
                let v104_ = v99_ * sin_theta_;
                let v105_ = self.R * v104_;
                let v108_ = v99_ * cos_theta_;
                let ddot_x1 = S::mul_add(self.v34_, v108_, self.v33_ * v97_);
                let u4 = S::mul_add(self.v27_ * v104_, phi2, w4);
                let u3 = S::mul_add(-(self.v29_ * v104_), phi2, w3);
                let v159_ = S::mul_add(-self.v25_, u4, self.v28_ * u3);
                let v161_ = S::mul_add(-self.v25_, u3, self.v30_ * u4);
                let v164_ = ddot_x1
                    - S::mul_add(
                        S::from_f64(2.0)
                            * S::mul_add(self.v37_, v108_, self.v36_ * v97_),
                        dot_phi2,
                        self.v34_
                            * (sin_theta_ * S::mul_add(self.v35_, cos_theta_, -S::ONE))
                            * phi2,
                    );
                let ddot_x2 = S::mul_add(
                    self.R
                        * (v104_
                            * (S::ONE
                                / S::mul_add(self.v12_, v97_ * (v99_ * v99_), self.J2))),
                    S::mul_add(
                        -v105_,
                        S::mul_add(
                            -self.v26_,
                            v161_,
                            S::mul_add(self.lambda, v159_, self.m2 * v164_),
                        ),
                        shaft,
                    ),
                    v164_,
                );
                let ddot_x3 = S::mul_add(
                    self.v39_,
                    -(self.m3 * ddot_x1) - v159_,
                    ddot_x1,
                );
                let ddot_x4 = S::mul_add(
                    self.v41_,
                    -(self.m4 * ddot_x1) - v161_,
                    ddot_x1,
                );
                let F1 = S::mul_add(
                    -self.v75_,
                    ddot_x4,
                    S::mul_add(self.v74_, ddot_x3, self.m1 * ddot_x1),
                );
                let F2 = S::mul_add(
                    self.m2,
                    ddot_x2,
                    S::mul_add(-self.v77_, ddot_x3, self.v76_ * ddot_x4),
                );
                let rod1 = S::ONE / S::sqrt(S::mul_add(-self.v80_, v97_, S::ONE)) * F1;
                let rod2 = F2
                    / S::sqrt(S::mul_add(-self.v80_, sin_v193_ * sin_v193_, S::ONE));
                let drive_torque = S::mul_add(v105_, F1, shaft);
                let F_difference = F1 - F2;
                values[0] = S::abs(rod1);
                values[1] = S::abs(rod2);
                values[2] = S::abs(F_difference);
                values[3] = S::abs(drive_torque);
                values[4] = drive_torque;
                values[5] = S::abs(phi2);
                values[6] = S::abs(shaft);
            },
        )
    }
    fn measures(&self, found: &[S], values: &mut [S]) {
        S::outline(
            #[inline(always)]
            || {
                ::assur::exact!(mut values, 9);
                let found_0_ = found[0];
                let found_1_ = found[1];
                let found_2_ = found[2];
                let found_3_ = found[3];
                let found_4_ = found[4];
                let mean_power = self.n * found_4_;
                let found_5_ = found[5];
                let found_6_ = found[6];
                let found_7_ = found[7];
                let found_8_ = found[8];
                values[0] = found_0_;
                values[1] = found_1_;
                values[2] = found_2_;
                values[3] = found_3_;
                values[4] = mean_power;
                values[5] = found_5_;
                values[6] = found_6_;
                values[7] = found_7_;
                values[8] = found_8_;
            },
        )
    }
}
/// The first scene of the mechanism, `Elastic`.
pub type Batten = Elastic;
