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
    /// `a*c`
    v26_: S,
    /// `v5_*v21_`
    v27_: S,
    /// `b*a`
    v28_: S,
    /// `b*c`
    v29_: S,
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
        let v34_ = S::mul_add(self.a, cos_phi_, self.v15_);
        let v37_ = S::mul_add(self.v16_, sin_phi_ * sin_phi_, v34_ * v34_);
        let v38_ = S::ONE / v37_;
        let v39_ = S::mul_add(self.v13_, v38_, S::from_f64(0.5));
        let v40_ = self.a * sin_phi_;
        let v46_ = S::sqrt((self.v17_ - v37_) * (self.v19_ + v37_));
        let v55_ = S::mul_add(-self.v13_, v38_, S::from_f64(0.5));
        let v59_ = S::sqrt(v37_);
        [
            sin_phi_,
            cos_phi_,
            v34_,
            v40_,
            -(v40_ * v39_),
            S::from_f64(0.5) * (v38_ * v46_ * v34_),
            -(v34_ * v39_),
            self.v20_ * (sin_phi_ * v38_ * v46_),
            v40_ * v55_,
            v34_ * v55_,
            self.v23_ * v46_,
            S::min(self.v10_ - v59_, self.v25_ + v59_),
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
                let v70_ = instant[5] * mode;
                let v73_ = instant[7] * mode;
                position[2] = self.v5_ * (instant[6] + v73_);
                position[3] = self.v5_ * (instant[4] + v70_);
                position[4] = self.v21_ * (instant[9] + v73_);
                position[5] = self.v21_ * (instant[8] + v70_);
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
    fn close_all(
        &self,
        instant: &Self::Instant,
        modes: &[S],
        position: &mut Self::Position,
        sines: &mut [S],
        angles: bool,
    ) {
        ::assur::exact!(mut sines, 1);
        ::assur::exact!(modes, 1);
        {
            let mode = modes[0];
            let v70_ = instant[5] * mode;
            let v73_ = instant[7] * mode;
            position[2] = self.v5_ * (instant[6] + v73_);
            position[3] = self.v5_ * (instant[4] + v70_);
            position[4] = self.v21_ * (instant[9] + v73_);
            position[5] = self.v21_ * (instant[8] + v70_);
            sines[0] = instant[10] * mode;
        }
        if angles {
            let angles_ = S::atan2_all(
                [position[3], position[5]],
                [position[2], position[4]],
            );
            position[0] = angles_[0];
            position[1] = angles_[1];
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
                let v84_ = self.b * position[2];
                let v86_ = self.c * position[4];
                let v91_ = self.c * position[5];
                residual[0] = instant[2] + v84_ - v86_;
                residual[1] = S::mul_add(self.b, position[3], instant[3]) - v91_;
                jacobian[0] = -(self.b * position[3]);
                jacobian[1] = v91_;
                jacobian[2] = v84_;
                jacobian[3] = -v86_;
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
        let v99_ = self.v27_
            / S::mul_add(-position[2], position[5], position[3] * position[4]);
        columns[0][0] = self.v26_
            * (v99_ * S::mul_add(-instant[0], position[4], instant[1] * position[5]));
        columns[0][1] = self.v28_ * v99_
            * S::mul_add(-instant[0], position[2], instant[1] * position[3]);
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
        let v108_ = self.b
            * (self.v27_
                / S::mul_add(-position[2], position[5], position[3] * position[4]));
        let v109_ = v108_ * position[3];
        let v110_ = v108_ * position[2];
        values[0] = S::mul_add(instant[1], v110_, instant[0] * v109_);
        values[1] = S::mul_add(position[2], v110_, position[3] * v109_);
        values[2] = -S::mul_add(position[4], v110_, position[5] * v109_);
        values[3] = -v110_;
        values[4] = self.a * S::mul_add(-instant[0], v110_, instant[1] * v109_);
    }
    #[inline(always)]
    fn second_influence(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    ) {
        ::assur::exact!(mut values, 15);
        let v63_ = -instant[0];
        let v84_ = self.b * position[2];
        let v94_ = self.b * position[3];
        let v99_ = self.v27_
            / S::mul_add(-position[2], position[5], position[3] * position[4]);
        let v103_ = self.v26_
            * (v99_ * S::mul_add(-instant[0], position[4], instant[1] * position[5]));
        let v105_ = S::mul_add(-instant[0], position[2], instant[1] * position[3]);
        let v106_ = self.v28_ * v99_;
        let v107_ = v106_ * v105_;
        let v108_ = self.b * v99_;
        let v124_ = self.c * v99_;
        let v125_ = v124_
            * S::mul_add(instant[0], position[5], instant[1] * position[4]);
        let v127_ = S::mul_add(instant[0], position[3], instant[1] * position[2]);
        let v129_ = S::mul_add(-v108_, v127_, v125_);
        let v131_ = self.v29_ * position[3] * position[5];
        let v133_ = self.v29_ * position[2] * position[4];
        let v135_ = S::mul_add(v133_, v129_, v131_ * v129_);
        let v146_ = S::mul_add(position[3], position[5], position[2] * position[4]);
        let v147_ = v99_ * v146_;
        let v148_ = self.c * v147_;
        let v149_ = v148_ - v108_;
        let v150_ = position[5] * v149_;
        let v152_ = position[4] * v149_;
        let v155_ = S::mul_add(
            position[2],
            S::mul_add(self.v29_, v152_, -(self.c * position[5])),
            position[3] * S::mul_add(self.v29_, v150_, self.c * position[4]),
        );
        let v156_ = S::mul_add(-v108_, v155_, S::ONE);
        let v158_ = v94_ * position[4];
        let v159_ = v84_ * position[5];
        let v162_ = v108_ * v146_;
        let v173_ = S::mul_add(self.b, v147_, -v124_);
        let v183_ = S::mul_add(
            position[2],
            S::mul_add(-self.b, position[5], self.v29_ * position[4] * v173_),
            position[3]
                * S::mul_add(self.v29_ * position[5], v173_, self.b * position[4]),
        );
        let v186_ = v99_ * position[2];
        let v196_ = v124_ * position[4];
        let v197_ = S::mul_add(v108_, position[2], -v196_);
        let v199_ = S::mul_add(v133_, v197_, v131_ * v197_);
        let v215_ = S::mul_add(
            -v107_,
            v155_,
            S::mul_add(
                self.a,
                position[2] * S::mul_add(self.b * instant[1], v148_, v63_),
                self.a
                    * (position[3] * S::mul_add(self.b * instant[0], v148_, instant[1])),
            ),
        );
        let v217_ = v99_ * v105_;
        let v226_ = v103_ - S::ONE;
        let v231_ = v107_ - v103_;
        let v234_ = S::mul_add(
            v107_,
            S::mul_add(v133_, v231_, v131_ * v231_),
            S::mul_add(
                self.v28_ * instant[1],
                position[2] * v226_,
                self.v28_ * instant[0] * (position[3] * v226_),
            ),
        );
        values[0] = v108_ * -S::mul_add(v99_ * v135_, v127_, v105_ * v125_);
        values[1] = -(self.b * (v135_ * (v99_ * v99_)));
        values[2] = v99_ * v156_;
        values[3] = v99_
            * S::mul_add(v162_, v135_, S::mul_add(-v159_, v129_, v158_ * v129_));
        values[4] = v99_
            * S::mul_add(
                v162_,
                v155_,
                S::mul_add(
                    position[2],
                    -S::mul_add(self.b, v150_, position[4]),
                    position[3] * S::mul_add(self.b, v152_, -position[5]),
                ),
            );
        values[5] = v99_
            * S::mul_add(v162_, v183_, S::mul_add(-v159_, v173_, v158_ * v173_));
        values[6] = v108_ * S::mul_add(v186_, v135_, position[3] * v125_);
        values[7] = v99_ * S::mul_add(-position[2], v156_, v94_ * v148_);
        values[8] = v108_ * S::mul_add(-position[3], v124_, v186_ * v183_);
        values[9] = v108_ * S::mul_add(-position[3], v196_, v186_ * v199_);
        values[10] = v99_
            * S::mul_add(
                -v107_,
                v135_,
                S::mul_add(
                    v84_,
                    S::mul_add(self.a * instant[1], v125_, v63_),
                    v94_ * S::mul_add(instant[3], v125_, instant[1]),
                ),
            );
        values[11] = v99_ * v215_;
        values[12] = v106_ * -S::mul_add(v217_, v183_, v127_ * v124_);
        values[13] = v106_ * -S::mul_add(v217_, v199_, v127_ * v196_);
        values[14] = v99_ * v234_;
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
