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
    lambda: S,
    d44: S,
    d33: S,
    /// `1/(d44*d33 - d34^2)*d34`
    v25_: S,
    /// `1 + lambda`
    v26_: S,
    /// `R*v26_`
    v27_: S,
    /// `1/(d44*d33 - d34^2)*d44`
    v28_: S,
    /// `R*lambda`
    v29_: S,
    /// `1/(d44*d33 - d34^2)*d33`
    v30_: S,
    /// `R^2*(1/l)*n^2`
    v33_: S,
    /// `R*n^2`
    v34_: S,
    /// `4*v16_`
    v35_: S,
    /// `R^2*(1/l)*n`
    v36_: S,
    /// `R*n`
    v37_: S,
    m3: S,
    /// `1/m3`
    v39_: S,
    m4: S,
    /// `1/m4`
    v41_: S,
    /// `-c`
    v42_: S,
    /// `1/(d44*d33 - d34^2)*R^2*(lambda*(-(lambda*d44 + d34*v26_)) - v26_*(d34*lambda + v26_*d33))`
    v51_: S,
    /// `R^2*n^2*m2`
    v53_: S,
    /// `R*(1/(d44*d33 - d34^2))*(-(lambda*d44 + d34*v26_))`
    v55_: S,
    /// `R*(1/(d44*d33 - d34^2))*(d34*lambda + v26_*d33)`
    v56_: S,
    /// `(-2)*(R*m2)`
    v58_: S,
    /// `R*(1/(d44*d33 - d34^2))*v39_*(-(lambda*d44 + d34*v26_))`
    v60_: S,
    /// Jacobian, rate of `dot(w3)` by `w3`: `-1/(d44*d33 - d34^2)*v39_*d44`
    slope_4_1_: S,
    /// Jacobian, rate of `dot(w3)` by `w4`: `v25_*v39_`
    slope_4_2_: S,
    /// `R*(1/(d44*d33 - d34^2))*v41_*(d34*lambda + v26_*d33)`
    v66_: S,
    /// Jacobian, rate of `dot(w4)` by `w3`: `v25_*v41_`
    slope_5_1_: S,
    /// Jacobian, rate of `dot(w4)` by `w4`: `-1/(d44*d33 - d34^2)*v41_*d33`
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
    /// `v26_*m4`
    v76_: S,
    /// `lambda*m3`
    v77_: S,
    /// `R^2*(1/(l^2))`
    v80_: S,
    /// `0.5*(R^2*n^2*m1)`
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
    /// `0.5*(1/(d44*d33 - d34^2))`
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
    /// - `instant[5]`: `v29_*((1 - v16_*cos(n*time))*sin(n*time))`
    /// - `instant[6]`: `v34_*((1 - v16_*cos(n*time))*cos(n*time)) + v33_*sin(n*time)^2`
    /// - `instant[7]`: `v34_*(sin(n*time)*(v35_*cos(n*time) + (-1)))`
    /// - `instant[8]`: `2*(v37_*((1 - v16_*cos(n*time))*cos(n*time)) + v36_*sin(n*time)^2)`
    /// - `instant[9]`: `-m3*(v34_*((1 - v16_*cos(n*time))*cos(n*time)) + v33_*sin(n*time)^2)`
    /// - `instant[10]`: `-m4*(v34_*((1 - v16_*cos(n*time))*cos(n*time)) + v33_*sin(n*time)^2)`
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
                let ddot_x1 = S::mul_add(self.v34_, v108_, self.v33_ * v97_);
                row_[..11]
                    .copy_from_slice(
                        &[
                            sin_theta_[k_],
                            cos_theta_[k_],
                            S::ONE
                                / S::mul_add(self.v12_, v97_ * (v99_ * v99_), self.J2),
                            self.R * v104_,
                            self.v27_ * v104_,
                            self.v29_ * v104_,
                            ddot_x1,
                            self.v34_
                                * (sin_theta_[k_]
                                    * S::mul_add(self.v35_, cos_theta_[k_], -S::ONE)),
                            S::from_f64(2.0)
                                * S::mul_add(self.v37_, v108_, self.v36_ * v97_),
                            -(self.m3 * ddot_x1),
                            -(self.m4 * ddot_x1),
                        ],
                    );
            }
        }
    }
    /// 27 operations.
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
        let v159_ = S::mul_add(-self.v25_, u4, self.v28_ * u3);
        let v161_ = S::mul_add(-self.v25_, u3, self.v30_ * u4);
        let ddot_phi2 = instant[2]
            * S::mul_add(
                -self.c,
                phi2,
                instant[3]
                    * S::mul_add(
                        -self.v26_,
                        v161_,
                        S::mul_add(
                            self.lambda,
                            v159_,
                            self.m2
                                * (instant[6]
                                    - S::mul_add(instant[8], dot_phi2, instant[7] * phi2)),
                        ),
                    ),
            );
        *rates = [
            dot_phi2,
            dot_w3,
            dot_w4,
            ddot_phi2,
            self.v39_ * (instant[9] - v159_),
            self.v41_ * (instant[10] - v161_),
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
                    S::mul_add(self.v35_, instant[1], -S::ONE),
                    self.v51_ * v99_,
                ),
                self.v42_,
            );
        let v126_ = v104_ * instant[2];
        let slope_3_1_ = -(self.v55_ * v126_);
        let slope_3_2_ = -(self.v56_ * v126_);
        let slope_3_3_ = self.v58_
            * (v126_ * S::mul_add(self.v37_, v99_ * instant[1], self.v36_ * v97_));
        let slope_4_0_ = -(self.v60_ * v104_);
        let slope_5_0_ = -(self.v66_ * v104_);
        let u4 = S::mul_add(instant[4], phi2, w4);
        let u3 = S::mul_add(-instant[5], phi2, w3);
        let v159_ = S::mul_add(-self.v25_, u4, self.v28_ * u3);
        let v161_ = S::mul_add(-self.v25_, u3, self.v30_ * u4);
        let ddot_phi2 = instant[2]
            * S::mul_add(
                -self.c,
                phi2,
                instant[3]
                    * S::mul_add(
                        -self.v26_,
                        v161_,
                        S::mul_add(
                            self.lambda,
                            v159_,
                            self.m2
                                * (instant[6]
                                    - S::mul_add(instant[8], dot_phi2, instant[7] * phi2)),
                        ),
                    ),
            );
        *rates = [
            dot_phi2,
            dot_w3,
            dot_w4,
            ddot_phi2,
            self.v39_ * (instant[9] - v159_),
            self.v41_ * (instant[10] - v161_),
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
                        S::mul_add(self.v35_, instant[1], -S::ONE),
                        self.v51_ * v99_,
                    ),
                    self.v42_,
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
                * (v126_ * S::mul_add(self.v37_, v99_ * instant[1], self.v36_ * v97_)),
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
            let v107_ = self.v29_ * v104_;
            let v108_ = memory_6_.next(k_, v99_, cos_theta_);
            let v109_ = self.v33_ * v97_;
            let ddot_x1 = self.v34_ * v108_ + v109_;
            let v111_ = self.v35_ * cos_theta_ + one_ * -S::ONE;
            let v113_ = self.v34_
                * ::assur::series::unless_zero(
                    self.v34_,
                    || memory_7_.next(k_, sin_theta_, v111_),
                );
            let v114_ = self.v36_ * v97_;
            let v115_ = self.v37_ * v108_ + v114_;
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
            let v158_ = self.v28_ * u3;
            let v159_ = v158_ - self.v25_ * u4;
            let v160_ = self.v30_ * u4;
            let v161_ = v160_ - self.v25_ * u3;
            let v162_ = memory_10_.next(k_, v113_, phi2);
            let v163_ = memory_11_.next(k_, v116_, dot_phi2) + v162_;
            let v164_ = ddot_x1 - v163_;
            let v165_ = self.m2 * v164_;
            let v166_ = self.lambda * v159_ + v165_;
            let v167_ = v166_ - self.v26_ * v161_;
            let v168_ = memory_12_.next(k_, v105_, v167_);
            let v169_ = v168_ - self.c * phi2;
            let ddot_phi2 = memory_13_.next(k_, v103_, v169_);
            let v171_ = v118_ - v159_;
            let rate_4_ = self.v39_ * v171_;
            let v173_ = v120_ - v161_;
            let rate_5_ = self.v41_ * v173_;
            let step_ = length * ::assur::series::inverse(k_ + 1);
            let rates_ = [dot_phi2, dot_w3, dot_w4, ddot_phi2, rate_4_, rate_5_];
            for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                *next_ = step_ * rate_;
            }
        }
        true
    }
}
