/// Loops of [`Turn`], prepared for a scalar type.
#[derive(Clone, Copy, Debug)]
pub struct TurnEquations<S: ::assur::scalar::Scalar> {
    b: S,
    /// `1/b`
    v7_: S,
    a: S,
    c: S,
    /// `abs(b) + abs(c)`
    v12_: S,
    /// `0.5*(v12_*(abs(b) - abs(c)))`
    v15_: S,
    /// `-d`
    v17_: S,
    /// `a^2`
    v18_: S,
    /// `v12_^2`
    v19_: S,
    /// `-(abs(b) - abs(c))^2`
    v21_: S,
    /// `(-0.5)*a`
    v22_: S,
    /// `1/c`
    v23_: S,
    /// `0.5/(abs(b)*abs(c))`
    v25_: S,
    /// `-abs(abs(b) - abs(c))`
    v27_: S,
    /// `a*c`
    v28_: S,
    /// `v7_*v23_`
    v29_: S,
    /// `b*a`
    v30_: S,
    /// `b*c`
    v31_: S,
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
    /// - `instant[2]`: `v17_ + a*cos(phi)`
    /// - `instant[3]`: `a*sin(phi)`
    /// - `instant[4]`: `-a*sin(phi)*(v15_*(1/(v18_*sin(phi)^2 + (v17_ + a*cos(phi))^2)) + 0.5)`
    /// - `instant[6]`: `-(v17_ + a*cos(phi))*(v15_*(1/(v18_*sin(phi)^2 + (v17_ + a*cos(phi))^2)) + 0.5)`
    /// - `instant[8]`: `a*sin(phi)*(0.5 - v15_*(1/(v18_*sin(phi)^2 + (v17_ + a*cos(phi))^2)))`
    /// - `instant[9]`: `(v17_ + a*cos(phi))*(0.5 - v15_*(1/(v18_*sin(phi)^2 + (v17_ + a*cos(phi))^2)))`
    #[inline(always)]
    fn instant(&self, independents: &[S]) -> Self::Instant {
        let phi = independents[0];
        let (sin_phi_, cos_phi_) = S::sin_cos(phi);
        let v36_ = S::mul_add(self.a, cos_phi_, self.v17_);
        let v39_ = S::mul_add(self.v18_, sin_phi_ * sin_phi_, v36_ * v36_);
        let v40_ = S::ONE / v39_;
        let v41_ = S::mul_add(self.v15_, v40_, S::from_f64(0.5));
        let v42_ = self.a * sin_phi_;
        let v48_ = S::sqrt((self.v19_ - v39_) * (self.v21_ + v39_));
        let v57_ = S::mul_add(-self.v15_, v40_, S::from_f64(0.5));
        let v61_ = S::sqrt(v39_);
        [
            sin_phi_,
            cos_phi_,
            v36_,
            v42_,
            -(v42_ * v41_),
            S::from_f64(0.5) * (v40_ * v48_ * v36_),
            -(v36_ * v41_),
            self.v22_ * (sin_phi_ * v40_ * v48_),
            v42_ * v57_,
            v36_ * v57_,
            self.v25_ * v48_,
            S::min(self.v12_ - v61_, self.v27_ + v61_),
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
                let v72_ = instant[5] * mode;
                let v75_ = instant[7] * mode;
                position[2] = self.v7_ * (instant[6] + v75_);
                position[3] = self.v7_ * (instant[4] + v72_);
                position[4] = self.v23_ * (instant[9] + v75_);
                position[5] = self.v23_ * (instant[8] + v72_);
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
            let v72_ = instant[5] * mode;
            let v75_ = instant[7] * mode;
            position[2] = self.v7_ * (instant[6] + v75_);
            position[3] = self.v7_ * (instant[4] + v72_);
            position[4] = self.v23_ * (instant[9] + v75_);
            position[5] = self.v23_ * (instant[8] + v72_);
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
                let v86_ = self.b * position[2];
                let v88_ = self.c * position[4];
                let v93_ = self.c * position[5];
                residual[0] = instant[2] + v86_ - v88_;
                residual[1] = S::mul_add(self.b, position[3], instant[3]) - v93_;
                jacobian[0] = -(self.b * position[3]);
                jacobian[1] = v93_;
                jacobian[2] = v86_;
                jacobian[3] = -v88_;
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
        let v101_ = self.v29_
            / S::mul_add(-position[2], position[5], position[3] * position[4]);
        columns[0][0] = self.v28_
            * (v101_ * S::mul_add(-instant[0], position[4], instant[1] * position[5]));
        columns[0][1] = self.v30_ * v101_
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
        let v110_ = self.b
            * (self.v29_
                / S::mul_add(-position[2], position[5], position[3] * position[4]));
        let v111_ = v110_ * position[3];
        let v112_ = v110_ * position[2];
        values[0] = S::mul_add(instant[1], v112_, instant[0] * v111_);
        values[1] = S::mul_add(position[2], v112_, position[3] * v111_);
        values[2] = -S::mul_add(position[4], v112_, position[5] * v111_);
        values[3] = -v112_;
        values[4] = self.a * S::mul_add(-instant[0], v112_, instant[1] * v111_);
    }
    #[inline(always)]
    fn second_influence(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    ) {
        ::assur::exact!(mut values, 15);
        let v65_ = -instant[0];
        let v86_ = self.b * position[2];
        let v96_ = self.b * position[3];
        let v101_ = self.v29_
            / S::mul_add(-position[2], position[5], position[3] * position[4]);
        let v105_ = self.v28_
            * (v101_ * S::mul_add(-instant[0], position[4], instant[1] * position[5]));
        let v107_ = S::mul_add(-instant[0], position[2], instant[1] * position[3]);
        let v108_ = self.v30_ * v101_;
        let v109_ = v108_ * v107_;
        let v110_ = self.b * v101_;
        let v126_ = self.c * v101_;
        let v127_ = v126_
            * S::mul_add(instant[0], position[5], instant[1] * position[4]);
        let v129_ = S::mul_add(instant[0], position[3], instant[1] * position[2]);
        let v131_ = S::mul_add(-v110_, v129_, v127_);
        let v133_ = self.v31_ * position[3] * position[5];
        let v135_ = self.v31_ * position[2] * position[4];
        let v137_ = S::mul_add(v135_, v131_, v133_ * v131_);
        let v148_ = S::mul_add(position[3], position[5], position[2] * position[4]);
        let v149_ = v101_ * v148_;
        let v150_ = self.c * v149_;
        let v151_ = v150_ - v110_;
        let v152_ = position[5] * v151_;
        let v154_ = position[4] * v151_;
        let v157_ = S::mul_add(
            position[2],
            S::mul_add(self.v31_, v154_, -(self.c * position[5])),
            position[3] * S::mul_add(self.v31_, v152_, self.c * position[4]),
        );
        let v158_ = S::mul_add(-v110_, v157_, S::ONE);
        let v160_ = v96_ * position[4];
        let v161_ = v86_ * position[5];
        let v164_ = v110_ * v148_;
        let v175_ = S::mul_add(self.b, v149_, -v126_);
        let v185_ = S::mul_add(
            position[2],
            S::mul_add(-self.b, position[5], self.v31_ * position[4] * v175_),
            position[3]
                * S::mul_add(self.v31_ * position[5], v175_, self.b * position[4]),
        );
        let v188_ = v101_ * position[2];
        let v198_ = v126_ * position[4];
        let v199_ = S::mul_add(v110_, position[2], -v198_);
        let v201_ = S::mul_add(v135_, v199_, v133_ * v199_);
        let v217_ = S::mul_add(
            -v109_,
            v157_,
            S::mul_add(
                self.a,
                position[2] * S::mul_add(self.b * instant[1], v150_, v65_),
                self.a
                    * (position[3] * S::mul_add(self.b * instant[0], v150_, instant[1])),
            ),
        );
        let v219_ = v101_ * v107_;
        let v228_ = v105_ - S::ONE;
        let v233_ = v109_ - v105_;
        let v236_ = S::mul_add(
            v109_,
            S::mul_add(v135_, v233_, v133_ * v233_),
            S::mul_add(
                self.v30_ * instant[1],
                position[2] * v228_,
                self.v30_ * instant[0] * (position[3] * v228_),
            ),
        );
        values[0] = v110_ * -S::mul_add(v101_ * v137_, v129_, v107_ * v127_);
        values[1] = -(self.b * (v137_ * (v101_ * v101_)));
        values[2] = v101_ * v158_;
        values[3] = v101_
            * S::mul_add(v164_, v137_, S::mul_add(-v161_, v131_, v160_ * v131_));
        values[4] = v101_
            * S::mul_add(
                v164_,
                v157_,
                S::mul_add(
                    position[2],
                    -S::mul_add(self.b, v152_, position[4]),
                    position[3] * S::mul_add(self.b, v154_, -position[5]),
                ),
            );
        values[5] = v101_
            * S::mul_add(v164_, v185_, S::mul_add(-v161_, v175_, v160_ * v175_));
        values[6] = v110_ * S::mul_add(v188_, v137_, position[3] * v127_);
        values[7] = v101_ * S::mul_add(-position[2], v158_, v96_ * v150_);
        values[8] = v110_ * S::mul_add(-position[3], v126_, v188_ * v185_);
        values[9] = v110_ * S::mul_add(-position[3], v198_, v188_ * v201_);
        values[10] = v101_
            * S::mul_add(
                -v109_,
                v137_,
                S::mul_add(
                    v86_,
                    S::mul_add(self.a * instant[1], v127_, v65_),
                    v96_ * S::mul_add(instant[3], v127_, instant[1]),
                ),
            );
        values[11] = v101_ * v217_;
        values[12] = v108_ * -S::mul_add(v219_, v185_, v129_ * v126_);
        values[13] = v108_ * -S::mul_add(v219_, v201_, v129_ * v198_);
        values[14] = v101_ * v236_;
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
