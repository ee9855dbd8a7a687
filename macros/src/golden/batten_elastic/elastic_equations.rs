/// Equations of [`Elastic`], prepared for a scalar type.
#[derive(Clone, Copy, Debug)]
pub struct ElasticEquations<S: ::assur::scalar::Scalar> {
    J2: S,
    R: S,
    m2: S,
    /// `R^2*m2`
    v12_: S,
    n: S,
    /// `R*(1/l)`
    v16_: S,
    c: S,
    d33: S,
    d44: S,
    d34: S,
    /// `1/(d33*d44 - d34^2)`
    v23_: S,
    lambda: S,
    /// `v23_*lambda`
    v25_: S,
    /// `1 + lambda`
    v26_: S,
    /// `R*v26_`
    v27_: S,
    /// `R*lambda`
    v28_: S,
    /// `n^2`
    v29_: S,
    /// `R^2*v29_*(1/l)`
    v31_: S,
    /// `R*v29_`
    v32_: S,
    /// `4*v16_`
    v33_: S,
    /// `R^2*(1/l)*n`
    v35_: S,
    /// `R*n`
    v36_: S,
    /// `v23_*d33`
    v37_: S,
    /// `v23_*d34`
    v38_: S,
    m3: S,
    /// `1/m3`
    v40_: S,
    m4: S,
    /// `1/m4`
    v42_: S,
    /// `-c`
    v43_: S,
    /// `v23_*R^2*(lambda*(-(lambda*d44 + v26_*d34)) - v26_*(lambda*d34 + v26_*d33))`
    v52_: S,
    /// `R^2*v29_*m2`
    v53_: S,
    /// `R*v23_*(-(lambda*d44 + v26_*d34))`
    v55_: S,
    /// `R*v23_*(lambda*d34 + v26_*d33)`
    v56_: S,
    /// `(-2)*(R*m2)`
    v58_: S,
    /// `R*v23_*v40_*(-(lambda*d44 + v26_*d34))`
    v60_: S,
    /// Jacobian, rate of `dot(w3)` by `w3`: `-v23_*v40_*d44`
    slope_4_1_: S,
    /// Jacobian, rate of `dot(w3)` by `w4`: `v38_*v40_`
    slope_4_2_: S,
    /// `R*v23_*v42_*(lambda*d34 + v26_*d33)`
    v66_: S,
    /// Jacobian, rate of `dot(w4)` by `w3`: `v38_*v42_`
    slope_5_1_: S,
    /// Jacobian, rate of `dot(w4)` by `w4`: `-v23_*v42_*d33`
    slope_5_2_: S,
    /// `0.5*n`
    v71_: S,
    /// `0.5*v16_`
    v72_: S,
    m1: S,
    /// `v26_*m3`
    v74_: S,
    /// `lambda*m4`
    v75_: S,
    /// `lambda*m3`
    v76_: S,
    /// `v26_*m4`
    v77_: S,
    /// `R^2*(1/(l^2))`
    v80_: S,
    /// `0.5*(R^2*v29_*m1)`
    v82_: S,
    /// `0.5*J2`
    v83_: S,
    /// `0.5*m3`
    v84_: S,
    /// `0.5*m4`
    v85_: S,
    /// `0.5*m2`
    v86_: S,
    /// `0.5*c`
    v87_: S,
    /// `0.5*v23_`
    v88_: S,
    /// `2*d34`
    v89_: S,
}
impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S> for ElasticEquations<S> {
    #[inline(always)]
    fn states(&self) -> usize {
        6
    }
    #[inline(always)]
    fn instant(&self) -> usize {
        11
    }
    /// - `instant[0]`: `sin(n*time)`
    /// - `instant[1]`: `cos(n*time)`
    /// - `instant[2]`: `1/(v12_*(sin(n*time)^2*(1 - v16_*cos(n*time))^2) + J2)`
    /// - `instant[3]`: `R*((1 - v16_*cos(n*time))*sin(n*time))`
    /// - `instant[4]`: `v27_*((1 - v16_*cos(n*time))*sin(n*time))`
    /// - `instant[5]`: `v28_*((1 - v16_*cos(n*time))*sin(n*time))`
    /// - `instant[6]`: `v32_*((1 - v16_*cos(n*time))*cos(n*time)) + v31_*sin(n*time)^2`
    /// - `instant[7]`: `v32_*(sin(n*time)*(v33_*cos(n*time) + (-1)))`
    /// - `instant[8]`: `2*(v36_*((1 - v16_*cos(n*time))*cos(n*time)) + v35_*sin(n*time)^2)`
    /// - `instant[9]`: `-m3*(v32_*((1 - v16_*cos(n*time))*cos(n*time)) + v31_*sin(n*time)^2)`
    /// - `instant[10]`: `-m4*(v32_*((1 - v16_*cos(n*time))*cos(n*time)) + v31_*sin(n*time)^2)`
    #[inline(always)]
    fn instants(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        times: &[S],
        rows: &mut [S],
    ) {
        let (rows, _) = rows.as_chunks_mut::<11>();
        for (times, rows) in times.chunks(4).zip(rows.chunks_mut(4)) {
            let mut angle_theta_ = [S::ZERO; 4];
            for k_ in 0..4 {
                let time = times[k_.min(times.len() - 1)];
                angle_theta_[k_] = self.n * time;
            }
            let (sin_theta_, cos_theta_) = S::sin_cos_all(angle_theta_);
            for (k_, row_) in rows.iter_mut().enumerate() {
                let time = times[k_];
                let v97_ = sin_theta_[k_] * sin_theta_[k_];
                let v99_ = S::mul_add(-self.v16_, cos_theta_[k_], S::ONE);
                let v104_ = v99_ * sin_theta_[k_];
                let v108_ = v99_ * cos_theta_[k_];
                let ddot_x1 = S::mul_add(self.v32_, v108_, self.v31_ * v97_);
                row_[..11]
                    .copy_from_slice(
                        &[
                            sin_theta_[k_],
                            cos_theta_[k_],
                            S::ONE
                                / S::mul_add(self.v12_, v97_ * (v99_ * v99_), self.J2),
                            self.R * v104_,
                            self.v27_ * v104_,
                            self.v28_ * v104_,
                            ddot_x1,
                            self.v32_
                                * (sin_theta_[k_]
                                    * S::mul_add(self.v33_, cos_theta_[k_], -S::ONE)),
                            S::from_f64(2.0)
                                * S::mul_add(self.v36_, v108_, self.v35_ * v97_),
                            -(self.m3 * ddot_x1),
                            -(self.m4 * ddot_x1),
                        ],
                    );
            }
        }
    }
    /// 28 operations.
    #[inline(always)]
    fn rates(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
    ) {
        ::assur::exact!(state, 6);
        ::assur::exact!(mut rates, 6);
        let phi2 = state[0];
        let w3 = state[1];
        let w4 = state[2];
        let dot_phi2 = state[3];
        let dot_w3 = state[4];
        let dot_w4 = state[5];
        let u4 = S::mul_add(instant[4], phi2, w4);
        let u3 = S::mul_add(-instant[5], phi2, w3);
        let v161_ = S::mul_add(-self.d34, u4, self.d44 * u3);
        let v165_ = S::mul_add(-self.v38_, u3, self.v37_ * u4);
        *rates = [
            dot_phi2,
            dot_w3,
            dot_w4,
            instant[2]
                * S::mul_add(
                    -self.c,
                    phi2,
                    instant[3]
                        * S::mul_add(
                            -self.v26_,
                            v165_,
                            S::mul_add(
                                self.v25_,
                                v161_,
                                self.m2
                                    * S::mul_add(
                                        -instant[8],
                                        dot_phi2,
                                        S::mul_add(-instant[7], phi2, instant[6]),
                                    ),
                            ),
                        ),
                ),
            self.v40_ * S::mul_add(-self.v23_, v161_, instant[9]),
            self.v42_ * (instant[10] - v165_),
        ];
    }
    #[inline(always)]
    fn variation(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        ::assur::exact!(state, 6);
        ::assur::exact!(mut rates, 6);
        let (columns, products) = (
            columns.as_chunks::<6>().0,
            products.as_chunks_mut::<6>().0,
        );
        let phi2 = state[0];
        let w3 = state[1];
        let w4 = state[2];
        let dot_phi2 = state[3];
        let dot_w3 = state[4];
        let dot_w4 = state[5];
        let v97_ = instant[0] * instant[0];
        let v99_ = S::mul_add(-self.v16_, instant[1], S::ONE);
        let v104_ = v99_ * instant[0];
        let slope_3_0_ = instant[2]
            * S::mul_add(
                v99_ * v97_,
                S::mul_add(
                    -self.v53_,
                    S::mul_add(self.v33_, instant[1], -S::ONE),
                    self.v52_ * v99_,
                ),
                self.v43_,
            );
        let v126_ = v104_ * instant[2];
        let slope_3_1_ = -(self.v55_ * v126_);
        let slope_3_2_ = -(self.v56_ * v126_);
        let slope_3_3_ = self.v58_
            * (v126_ * S::mul_add(self.v36_, v99_ * instant[1], self.v35_ * v97_));
        let slope_4_0_ = -(self.v60_ * v104_);
        let slope_5_0_ = -(self.v66_ * v104_);
        let u4 = S::mul_add(instant[4], phi2, w4);
        let u3 = S::mul_add(-instant[5], phi2, w3);
        let v161_ = S::mul_add(-self.d34, u4, self.d44 * u3);
        let v165_ = S::mul_add(-self.v38_, u3, self.v37_ * u4);
        *rates = [
            dot_phi2,
            dot_w3,
            dot_w4,
            instant[2]
                * S::mul_add(
                    -self.c,
                    phi2,
                    instant[3]
                        * S::mul_add(
                            -self.v26_,
                            v165_,
                            S::mul_add(
                                self.v25_,
                                v161_,
                                self.m2
                                    * S::mul_add(
                                        -instant[8],
                                        dot_phi2,
                                        S::mul_add(-instant[7], phi2, instant[6]),
                                    ),
                            ),
                        ),
                ),
            self.v40_ * S::mul_add(-self.v23_, v161_, instant[9]),
            self.v42_ * (instant[10] - v165_),
        ];
        for (column_, product_) in columns.iter().zip(&mut *products) {
            product_[0] = column_[3];
            product_[1] = column_[4];
            product_[2] = column_[5];
            product_[3] = S::mul_add(
                slope_3_3_,
                column_[3],
                S::mul_add(
                    slope_3_2_,
                    column_[2],
                    S::mul_add(slope_3_1_, column_[1], slope_3_0_ * column_[0]),
                ),
            );
            product_[4] = S::mul_add(
                self.slope_4_2_,
                column_[2],
                S::mul_add(self.slope_4_1_, column_[1], slope_4_0_ * column_[0]),
            );
            product_[5] = S::mul_add(
                self.slope_5_2_,
                column_[2],
                S::mul_add(self.slope_5_1_, column_[1], slope_5_0_ * column_[0]),
            );
        }
    }
    /// 28 operations.
    #[inline(always)]
    fn jacobian(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        instant: &[S],
        state: &[S],
        columns: &mut [S],
    ) {
        ::assur::exact!(state, 6);
        ::assur::exact!(mut columns, 6 by 6);
        let v97_ = instant[0] * instant[0];
        let v99_ = S::mul_add(-self.v16_, instant[1], S::ONE);
        let v104_ = v99_ * instant[0];
        let v126_ = v104_ * instant[2];
        columns[0] = [
            S::ZERO,
            S::ZERO,
            S::ZERO,
            instant[2]
                * S::mul_add(
                    v99_ * v97_,
                    S::mul_add(
                        -self.v53_,
                        S::mul_add(self.v33_, instant[1], -S::ONE),
                        self.v52_ * v99_,
                    ),
                    self.v43_,
                ),
            -(self.v60_ * v104_),
            -(self.v66_ * v104_),
        ];
        columns[1] = [
            S::ZERO,
            S::ZERO,
            S::ZERO,
            -(self.v55_ * v126_),
            self.slope_4_1_,
            self.slope_5_1_,
        ];
        columns[2] = [
            S::ZERO,
            S::ZERO,
            S::ZERO,
            -(self.v56_ * v126_),
            self.slope_4_2_,
            self.slope_5_2_,
        ];
        columns[3] = [
            S::ONE,
            S::ZERO,
            S::ZERO,
            self.v58_
                * (v126_ * S::mul_add(self.v36_, v99_ * instant[1], self.v35_ * v97_)),
            S::ZERO,
            S::ZERO,
        ];
        columns[4] = [S::ZERO, S::ONE, S::ZERO, S::ZERO, S::ZERO, S::ZERO];
        columns[5] = [S::ZERO, S::ZERO, S::ONE, S::ZERO, S::ZERO, S::ZERO];
    }
    #[inline(never)]
    fn series(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        time: S,
        length: S,
        rows: &mut [S],
    ) -> bool {
        if !S::SINGLE {
            return false;
        }
        let (rows_, _) = rows.as_chunks_mut::<6>();
        let mut memory_0_ = ::assur::series::Turn::default();
        let mut memory_1_ = ::assur::series::Product::default();
        let mut memory_2_ = ::assur::series::Product::default();
        let mut memory_3_ = ::assur::series::Product::default();
        let mut memory_4_ = ::assur::series::Quotient::default();
        let mut memory_5_ = ::assur::series::Product::default();
        let mut memory_6_ = ::assur::series::Product::default();
        let mut memory_7_ = ::assur::series::Product::default();
        let mut memory_8_ = ::assur::series::Product::default();
        let mut memory_9_ = ::assur::series::Product::default();
        let mut memory_10_ = ::assur::series::Product::default();
        let mut memory_11_ = ::assur::series::Product::default();
        let mut memory_12_ = ::assur::series::Product::default();
        let mut memory_13_ = ::assur::series::Product::default();
        for k_ in 0..rows_.len().saturating_sub(1).min(::assur::series::TERMS) {
            let state = rows_[k_];
            let one_: S = ::assur::series::one(k_);
            let time_ = ::assur::series::time(k_, time, length);
            let theta = self.n * time_;
            let (sin_theta_, cos_theta_) = memory_0_.next(k_, theta);
            let v97_ = memory_1_.next(k_, sin_theta_, sin_theta_);
            let v99_ = one_ - self.v16_ * cos_theta_;
            let v100_ = memory_2_.next(k_, v99_, v99_);
            let v102_ = self.v12_
                * ::assur::series::unless_zero(
                    self.v12_,
                    || memory_3_.next(k_, v97_, v100_),
                ) + one_ * self.J2;
            let v103_ = memory_4_.next(k_, one_, v102_);
            let v104_ = memory_5_.next(k_, v99_, sin_theta_);
            let v105_ = self.R * v104_;
            let v106_ = self.v27_ * v104_;
            let v107_ = self.v28_ * v104_;
            let v108_ = memory_6_.next(k_, v99_, cos_theta_);
            let v109_ = self.v31_ * v97_;
            let ddot_x1 = self.v32_ * v108_ + v109_;
            let v111_ = self.v33_ * cos_theta_ + one_ * -S::ONE;
            let v113_ = self.v32_
                * ::assur::series::unless_zero(
                    self.v32_,
                    || memory_7_.next(k_, sin_theta_, v111_),
                );
            let v114_ = self.v35_ * v97_;
            let v115_ = self.v36_ * v108_ + v114_;
            let v116_ = S::from_f64(2.0) * v115_;
            let v117_ = self.m3 * ddot_x1;
            let v118_ = -v117_;
            let v119_ = self.m4 * ddot_x1;
            let v120_ = -v119_;
            let dot_phi2 = state[3];
            let dot_w3 = state[4];
            let dot_w4 = state[5];
            let phi2 = state[0];
            let w4 = state[2];
            let u4 = memory_8_.next(k_, v106_, phi2) + w4;
            let w3 = state[1];
            let u3 = w3 - memory_9_.next(k_, v107_, phi2);
            let v160_ = self.d44 * u3;
            let v161_ = v160_ - self.d34 * u4;
            let v162_ = ddot_x1 - memory_10_.next(k_, v113_, phi2);
            let v163_ = v162_ - memory_11_.next(k_, v116_, dot_phi2);
            let v164_ = self.v37_ * u4;
            let v165_ = v164_ - self.v38_ * u3;
            let v166_ = self.m2 * v163_;
            let v167_ = self.v25_ * v161_ + v166_;
            let v168_ = v167_ - self.v26_ * v165_;
            let v169_ = memory_12_.next(k_, v105_, v168_);
            let v170_ = v169_ - self.c * phi2;
            let ddot_phi2 = memory_13_.next(k_, v103_, v170_);
            let v172_ = v118_ - self.v23_ * v161_;
            let rate_4_ = self.v40_ * v172_;
            let v174_ = v120_ - v165_;
            let rate_5_ = self.v42_ * v174_;
            let step_ = length * ::assur::series::inverse(k_ + 1);
            let rates_ = [dot_phi2, dot_w3, dot_w4, ddot_phi2, rate_4_, rate_5_];
            for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                *next_ = step_ * rate_;
            }
        }
        true
    }
}
