/// Loops of [`Turn`], prepared for a scalar type.
#[derive(Clone, Copy, Debug)]
pub struct TurnEquations<S: ::assur::scalar::Scalar> {
    b: S,
    /// `1/b`
    v5_: S,
    a: S,
    c: S,
    /// `abs(b) + abs(c)`
    v10_: S,
    /// `0.5*(v10_*(abs(b) - abs(c)))`
    v13_: S,
    /// `-d`
    v15_: S,
    /// `a^2`
    v16_: S,
    /// `v10_^2`
    v17_: S,
    /// `-(abs(b) - abs(c))^2`
    v19_: S,
    /// `(-0.5)*a`
    v20_: S,
    /// `1/c`
    v21_: S,
    /// `0.5/(abs(b)*abs(c))`
    v23_: S,
    /// `-abs(abs(b) - abs(c))`
    v25_: S,
    /// `v5_*a`
    v26_: S,
    /// `v21_*a`
    v27_: S,
    /// `v21_*v5_`
    v28_: S,
    /// `1/(c^2)`
    v30_: S,
    /// `v5_*v30_`
    v31_: S,
    /// `-b`
    v32_: S,
    /// `-v21_`
    v33_: S,
    /// `-c`
    v34_: S,
    /// `v28_*a`
    v35_: S,
}
impl<S: ::assur::scalar::Scalar> ::assur::closure::Closure<S> for TurnEquations<S> {
    type Position = [S; 6];
    type Instant = [S; 12];
    type Row = [S; 2];
    type Matrix = [S; 4];
    #[inline(always)]
    fn shape(&self) -> &'static ::assur::shape::Shape {
        &shapes_::Turn
    }
    #[inline(always)]
    fn zeros(&self) -> Self::Position {
        [S::ZERO; 6]
    }
    /// - `instant[0]`: `sin(phi)`
    /// - `instant[1]`: `cos(phi)`
    /// - `instant[2]`: `v15_ + a*cos(phi)`
    /// - `instant[3]`: `a*sin(phi)`
    /// - `instant[4]`: `-a*sin(phi)*(v13_*(1/(v16_*sin(phi)^2 + (v15_ + a*cos(phi))^2)) + 0.5)`
    /// - `instant[6]`: `-(v15_ + a*cos(phi))*(v13_*(1/(v16_*sin(phi)^2 + (v15_ + a*cos(phi))^2)) + 0.5)`
    /// - `instant[8]`: `a*sin(phi)*(0.5 - v13_*(1/(v16_*sin(phi)^2 + (v15_ + a*cos(phi))^2)))`
    /// - `instant[9]`: `(v15_ + a*cos(phi))*(0.5 - v13_*(1/(v16_*sin(phi)^2 + (v15_ + a*cos(phi))^2)))`
    #[inline(always)]
    fn instant(&self, independents: &[S]) -> Self::Instant {
        let phi = independents[0];
        let (sin_phi_, cos_phi_) = S::sin_cos(phi);
        let v40_ = S::mul_add(self.a, cos_phi_, self.v15_);
        let v43_ = S::mul_add(self.v16_, sin_phi_ * sin_phi_, v40_ * v40_);
        let v44_ = S::ONE / v43_;
        let v45_ = S::mul_add(self.v13_, v44_, S::from_f64(0.5));
        let v46_ = self.a * sin_phi_;
        let v52_ = S::sqrt((self.v17_ - v43_) * (self.v19_ + v43_));
        let v61_ = S::mul_add(-self.v13_, v44_, S::from_f64(0.5));
        let v65_ = S::sqrt(v43_);
        [
            sin_phi_,
            cos_phi_,
            v40_,
            v46_,
            -(v46_ * v45_),
            S::from_f64(0.5) * (v44_ * v52_ * v40_),
            -(v40_ * v45_),
            self.v20_ * (sin_phi_ * v44_ * v52_),
            v46_ * v61_,
            v40_ * v61_,
            self.v23_ * v52_,
            S::min(self.v10_ - v65_, self.v25_ + v65_),
        ]
    }
    #[inline(always)]
    fn close(
        &self,
        group: usize,
        instant: &Self::Instant,
        mode: S,
        position: &mut Self::Position,
    ) -> S {
        match group {
            0 => {
                let v75_ = instant[5] * mode;
                let v78_ = instant[7] * mode;
                position[2] = self.v5_ * (instant[6] + v78_);
                position[3] = self.v5_ * (instant[4] + v75_);
                position[4] = self.v21_ * (instant[9] + v78_);
                position[5] = self.v21_ * (instant[8] + v75_);
                let angles_ = S::atan2_all(
                    [position[3], position[5]],
                    [position[2], position[4]],
                );
                position[0] = angles_[0];
                position[1] = angles_[1];
                instant[10] * mode
            }
            _ => S::from_f64(f64::NAN),
        }
    }
    #[inline(always)]
    fn margin(
        &self,
        group: usize,
        instant: &Self::Instant,
        position: &Self::Position,
    ) -> S {
        S::outline(
            #[inline(always)]
            || {
                match group {
                    0 => instant[11],
                    _ => S::from_f64(f64::NAN),
                }
            },
        )
    }
    #[inline(always)]
    fn trial(
        &self,
        group: usize,
        instant: &Self::Instant,
        position: &mut Self::Position,
        residual: &mut Self::Row,
        jacobian: &mut Self::Matrix,
    ) {
        match group {
            0 => {
                let (sines_, cosines_) = S::sin_cos_all([position[0], position[1]]);
                position[2] = cosines_[0];
                position[3] = sines_[0];
                position[4] = cosines_[1];
                position[5] = sines_[1];
                let v89_ = self.b * position[2];
                let v91_ = self.c * position[4];
                residual[0] = instant[2] + v89_ - v91_;
                residual[1] = S::mul_add(
                    -self.c,
                    position[5],
                    S::mul_add(self.b, position[3], instant[3]),
                );
                jacobian[0] = -(self.b * position[3]);
                jacobian[1] = self.c * position[5];
                jacobian[2] = v89_;
                jacobian[3] = -v91_;
            }
            _ => {}
        }
    }
    #[inline(always)]
    fn coefficients(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        columns: &mut [Self::Position],
    ) {
        ::assur::exact!(mut columns, 1);
        let v104_ = S::ONE
            / S::mul_add(-position[2], position[5], position[3] * position[4]);
        columns[0][0] = self.v26_
            * (v104_ * S::mul_add(instant[1], position[5], -(instant[0] * position[4])));
        columns[0][1] = self.v27_
            * (v104_ * S::mul_add(-instant[0], position[2], instant[1] * position[3]));
    }
    #[inline(always)]
    fn residual(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        residual: &mut [S],
    ) {
        ::assur::exact!(mut residual, 2);
        residual[0] = S::mul_add(
            -self.c,
            position[4],
            S::mul_add(self.b, position[2], instant[2]),
        );
        residual[1] = S::mul_add(
            -self.c,
            position[5],
            S::mul_add(self.b, position[3], instant[3]),
        );
    }
    #[inline(always)]
    fn outputs(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    ) {
        ::assur::exact!(mut values, 1);
        values[0] = position[1];
    }
    #[inline(always)]
    fn influence(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    ) {
        ::assur::exact!(mut values, 5);
        let v104_ = S::ONE
            / S::mul_add(-position[2], position[5], position[3] * position[4]);
        let v115_ = self.v21_ * v104_;
        values[0] = v115_
            * S::mul_add(instant[1], position[2], instant[0] * position[3]);
        values[1] = v115_;
        values[2] = v115_
            * -S::mul_add(position[2], position[4], position[3] * position[5]);
        values[3] = -(v115_ * position[2]);
        values[4] = self.v27_
            * (v104_ * S::mul_add(-instant[0], position[2], instant[1] * position[3]));
    }
    #[inline(always)]
    fn second_influence(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    ) {
        S::outline(
            #[inline(always)]
            || {
                ::assur::exact!(mut values, 15);
                let v69_ = self.v21_ * instant[0];
                let v70_ = self.v21_ * instant[1];
                let v103_ = S::mul_add(
                    -position[2],
                    position[5],
                    position[3] * position[4],
                );
                let v104_ = S::ONE / v103_;
                let v105_ = instant[0] * position[4];
                let v106_ = S::mul_add(instant[1], position[5], -v105_);
                let v110_ = S::mul_add(
                    -instant[0],
                    position[2],
                    instant[1] * position[3],
                );
                let v114_ = S::mul_add(
                    instant[1],
                    position[2],
                    instant[0] * position[3],
                );
                let v115_ = self.v21_ * v104_;
                let v117_ = position[3] * position[5];
                let v119_ = -S::mul_add(position[2], position[4], v117_);
                let v123_ = v103_ * v103_;
                let v124_ = S::ONE / v123_;
                let v126_ = S::mul_add(
                    instant[0],
                    position[5],
                    instant[1] * position[4],
                );
                let v128_ = S::mul_add(-self.b, v114_, self.c * v126_);
                let v129_ = position[2] * position[4];
                let v131_ = S::mul_add(v129_, v128_, v117_ * v128_);
                let v132_ = v104_ * v131_;
                let v135_ = -S::mul_add(v69_, v132_, instant[1] * v126_);
                let v136_ = self.v28_ * position[3];
                let v138_ = S::mul_add(-v70_, v132_, instant[0] * v126_);
                let v139_ = self.v28_ * position[2];
                let v144_ = S::ONE / (v123_ * v103_);
                let v148_ = S::mul_add(-self.c, v119_, self.v32_);
                let v152_ = S::mul_add(
                    v104_,
                    S::mul_add(v129_, v148_, v117_ * v148_),
                    self.c * v103_,
                );
                let v157_ = S::mul_add(-self.v21_, v114_, self.v5_ * v126_);
                let v158_ = self.v21_ * position[4];
                let v159_ = self.v31_ * v104_;
                let v164_ = self.v21_ * position[5];
                let v169_ = v124_
                    * S::mul_add(
                        position[2],
                        S::mul_add(-v164_, v157_, v159_ * position[4] * v131_),
                        position[3]
                            * S::mul_add(v159_ * position[5], v131_, v158_ * v157_),
                    );
                let v170_ = S::mul_add(-self.v5_, v119_, self.v33_);
                let v174_ = self.v31_ * position[4];
                let v180_ = S::mul_add(
                    v104_,
                    S::mul_add(
                        position[3],
                        S::mul_add(self.v31_, position[5] * v152_, v158_ * v170_),
                        position[2] * S::mul_add(-v164_, v170_, v174_ * v152_),
                    ),
                    self.v28_ * v119_,
                );
                let v183_ = v136_ * position[4] * v124_;
                let v185_ = S::mul_add(-self.b, v119_, self.v34_);
                let v189_ = S::mul_add(
                    v104_,
                    S::mul_add(v129_, v185_, v117_ * v185_),
                    self.b * v103_,
                );
                let v197_ = S::mul_add(
                    self.v30_,
                    position[3]
                        * S::mul_add(
                            -position[4],
                            v119_,
                            self.v5_ * (position[5] * v189_),
                        ),
                    position[2]
                        * S::mul_add(
                            v174_,
                            v189_,
                            v164_ * S::mul_add(self.v21_, v119_, self.v5_),
                        ),
                );
                let v201_ = self.v28_ * v124_;
                let v217_ = S::mul_add(
                    -self.c,
                    v117_ * position[4],
                    position[2]
                        * S::mul_add(
                            position[4],
                            S::mul_add(-self.c, position[4], self.b * position[2]),
                            self.b * v117_,
                        ),
                );
                let v221_ = self.v35_ * position[3];
                let v222_ = self.v35_ * position[2];
                let v236_ = S::mul_add(
                    v104_,
                    S::mul_add(
                        v221_,
                        -S::mul_add(v70_, v152_, instant[0] * v119_),
                        v222_ * S::mul_add(-instant[1], v119_, v69_ * v152_),
                    ),
                    self.v35_ * v110_,
                );
                let v243_ = v104_ * v217_;
                let v252_ = S::mul_add(-self.b, v110_, self.c * v106_);
                let v257_ = v104_
                    * S::mul_add(self.a, v129_ * v252_, self.a * (v117_ * v252_));
                let v265_ = S::mul_add(
                    -self.v27_,
                    v114_,
                    v104_
                        * S::mul_add(
                            v222_,
                            S::mul_add(v69_, v257_, self.a * instant[1] * v106_),
                            v221_ * S::mul_add(-v70_, v257_, instant[3] * v106_),
                        ),
                );
                values[0] = v124_ * S::mul_add(v136_, v135_, v139_ * v138_);
                values[1] = -(self.v31_ * (v131_ * v144_));
                values[2] = S::mul_add(-self.v31_, v152_ * v124_, self.v28_ * v104_);
                values[3] = v169_;
                values[4] = v104_ * v180_;
                values[5] = S::mul_add(v124_, v197_, -v183_);
                values[6] = v201_
                    * S::mul_add(v115_ * position[2], v131_, position[3] * v126_);
                values[7] = v104_
                    * S::mul_add(
                        -self.v28_,
                        v104_ * position[3] * v119_,
                        v139_ * S::mul_add(v115_, v152_, -S::ONE),
                    );
                values[8] = v201_
                    * S::mul_add(self.v21_, position[2] * v189_, -position[3]);
                values[9] = S::mul_add(self.v31_, position[2] * v217_ * v144_, -v183_);
                values[10] = v104_
                    * S::mul_add(
                        v104_,
                        S::mul_add(-v222_, v135_, v221_ * v138_),
                        self.v21_ * v110_,
                    );
                values[11] = v104_ * v236_;
                values[12] = v124_
                    * S::mul_add(
                        v222_,
                        S::mul_add(v69_, v189_, -instant[1]),
                        v221_ * S::mul_add(-v70_, v189_, -instant[0]),
                    );
                values[13] = v124_
                    * S::mul_add(
                        v221_,
                        -S::mul_add(v70_, v243_, v105_),
                        v222_ * S::mul_add(-instant[1], position[4], v69_ * v243_),
                    );
                values[14] = v104_ * v265_;
            },
        )
    }
    #[inline(always)]
    fn points(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    ) {}
}
/// The first scene of the mechanism, `Turn`.
pub type FourBar = Turn;
