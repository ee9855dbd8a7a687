/// Batten of an automatic shuttle loom: a crank at each end of one shaft swings the batten, whose two swords carry
/// an elastic bar.
///
/// Six masses, three degrees of freedom. All displacements are measured forward, towards the cloth, from the rear
/// dead centre, where `theta = 0`. The arc of the sword pins is replaced by its chord.
///
/// The coordinates of the bar are its deflections `w3`, `w4` from the rigid motion: the elastic forces are
/// differences some 200 times smaller than their terms when they are written in `x3` and `x4`.
///
/// The masses and stiffnesses are a reconstruction: the paper fixes their ratios alone.
///
/// Scene `elastic`: The paper's model: shaft and bar are elastic, nothing is lost.
///
/// * `bending`: the bar bends
/// * `coupling`: a force on one end of the bar moves its other end too
/// * `torsion`: the crankshaft twists between its cranks
/// * `crank.two_term`: how exactly the crank and rod are described
/// * `linearisation.K1`: how the lag enters the travel of the brake-side pin
///
/// ```text
/// kinetic m1*dot(x1)^2/2 + m2*dot(x2)^2/2 + m3*dot(x3)^2/2 + m4*dot(x4)^2/2   [N m]  batten.eqn:66
/// kinetic J2*(n - dot(phi2))^2/2                                              [N m]  batten.eqn:75
/// potential c*phi2^2/2                                                        [N m]  batten.eqn:76
/// potential stiffness(u3, u4)/2                                               [N m]  batten.eqn:111
/// ```
///
/// Parameters:
///
/// | name | value |  |  |
/// |---|---|---|---|
/// | `R` | `75 mm` | `in 1 mm .. 1000 mm` | Crank. |
/// | `l` | `271 mm` | `in 1 mm .. 10000 mm` | Connecting rod. |
/// | `n` | `250 rpm` | `in 1 rpm .. 2000 rpm` | Speed of the crankshaft. |
/// | `m1` | `28.5 kg` | `in 1e-6 kg .. 100000 kg` | Sword pin with rod and frame, drive side. |
/// | `m2` | `28.5 kg` | `in 1e-6 kg .. 100000 kg` | Sword pin with rod and frame, brake side. |
/// | `m3` | `2.02 kg` | `in 1e-6 kg .. 100000 kg` | End of the bar, drive side. |
/// | `m4` | `2.02 kg` | `in 1e-6 kg .. 100000 kg` | End of the bar, brake side. |
/// | `lambda` | `0.385` | `in 0 .. 10` | Cantilever of the bar over its span, L1/L. |
/// | `c` | `20980 N m/rad` | `in 1 N m/rad .. 1e12 N m/rad` | Torsional stiffness of the shaft between its cranks. |
/// | `J2` | `0.1004 kg m^2` | `in 1e-9 kg m^2 .. 1000000 kg m^2` | Disc at the brake end. |
/// | `d33` | `3.8e-6 m/N` | `in 1e-15 m/N .. 1 m/N` | Displacement of the drive-side end of the bar by unit force there. |
/// | `d44` | `3.8e-6 m/N` | `in 1e-15 m/N .. 1 m/N` | Displacement of the brake-side end of the bar by unit force there. |
/// | `d34` | `1.22e-6 m/N` | `in -1 m/N .. 1 m/N` | Displacement of one end of the bar by unit force at the other. |
///
/// Drivers:
///
/// | name | unit |  |
/// |---|---|---|
/// | `theta` | `rad` | Angle of the drive-end crank from the rear dead centre. |
///
/// State:
///
/// | name | unit |  |
/// |---|---|---|
/// | `phi2` | `rad` | Lag of the brake-end crank behind the drive-end one. |
/// | `w3` | `m` | Displacement of the drive-side end of the bar from the rigid motion. |
/// | `w4` | `m` | Displacement of the brake-side end of the bar from the rigid motion. |
/// | `dot(phi2)` | `rad/s` |  |
/// | `dot(w3)` | `m/s` |  |
/// | `dot(w4)` | `m/s` |  |
///
/// Outputs:
///
/// | name | unit |  |
/// |---|---|---|
/// | `x1` | `m` |  |
/// | `x2` | `m` |  |
/// | `x3` | `m` |  |
/// | `x4` | `m` |  |
/// | `dot(x1)` | `m/s` |  |
/// | `dot(x2)` | `m/s` |  |
/// | `dot(x3)` | `m/s` |  |
/// | `dot(x4)` | `m/s` |  |
/// | `ddot(x1)` | `m/s^2` |  |
/// | `ddot(x2)` | `m/s^2` |  |
/// | `ddot(x3)` | `m/s^2` |  |
/// | `ddot(x4)` | `m/s^2` |  |
/// | `phi2` | `rad` |  |
/// | `dot(phi2)` | `rad/s` |  |
/// | `ddot(phi2)` | `rad/s^2` |  |
/// | `F1` | `N` |  |
/// | `F2` | `N` |  |
/// | `rod1` | `N` |  |
/// | `rod2` | `N` |  |
/// | `drive_torque` | `N m` | Torque at the drive end that keeps the speed. |
/// | `shaft_torque` | `N m` | Torque in the shaft between its cranks. |
/// | `x_difference` | `m` | Ends of the bar, drive side ahead of brake side. |
/// | `v_difference` | `m/s` |  |
/// | `F_difference` | `N` |  |
///
/// Operations: 73 once per parameter set, 31 per instant, 27 per evaluation, 28 per Jacobian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Crank: `75 mm`, `in 1 mm .. 1000 mm`; stored in SI units, `mm` is 0.001.
    pub R: f64,
    /// Connecting rod: `271 mm`, `in 1 mm .. 10000 mm`; stored in SI units, `mm` is 0.001.
    pub l: f64,
    /// Speed of the crankshaft: `250 rpm`, `in 1 rpm .. 2000 rpm`; stored in SI units, `rpm` is 0.10471975512.
    pub n: f64,
    /// Sword pin with rod and frame, drive side: `28.5 kg`, `in 1e-6 kg .. 100000 kg`.
    pub m1: f64,
    /// Sword pin with rod and frame, brake side: `28.5 kg`, `in 1e-6 kg .. 100000 kg`.
    pub m2: f64,
    /// End of the bar, drive side: `2.02 kg`, `in 1e-6 kg .. 100000 kg`.
    pub m3: f64,
    /// End of the bar, brake side: `2.02 kg`, `in 1e-6 kg .. 100000 kg`.
    pub m4: f64,
    /// Cantilever of the bar over its span, L1/L: `0.385`, `in 0 .. 10`.
    pub lambda: f64,
    /// Torsional stiffness of the shaft between its cranks: `20980 N m/rad`, `in 1 N m/rad .. 1e12 N m/rad`.
    pub c: f64,
    /// Disc at the brake end: `0.1004 kg m^2`, `in 1e-9 kg m^2 .. 1000000 kg m^2`.
    pub J2: f64,
    /// Displacement of the drive-side end of the bar by unit force there: `3.8e-6 m/N`, `in 1e-15 m/N .. 1 m/N`.
    pub d33: f64,
    /// Displacement of the brake-side end of the bar by unit force there: `3.8e-6 m/N`, `in 1e-15 m/N .. 1 m/N`.
    pub d44: f64,
    /// Displacement of one end of the bar by unit force at the other: `1.22e-6 m/N`, `in -1 m/N .. 1 m/N`.
    pub d34: f64,
}
impl ::core::default::Default for Elastic {
    fn default() -> Self {
        Self::from_values(&shapes_::Elastic.defaults())
    }
}
impl Elastic {
    /// `phi2`
    pub const PHI2: ::assur::shape::Subject = ::assur::shape::Subject::State(0);
    /// `w3`
    pub const W3: ::assur::shape::Subject = ::assur::shape::Subject::State(1);
    /// `w4`
    pub const W4: ::assur::shape::Subject = ::assur::shape::Subject::State(2);
    /// `dot(phi2)`
    pub const DOT_PHI2: ::assur::shape::Subject = ::assur::shape::Subject::State(3);
    /// `dot(w3)`
    pub const DOT_W3: ::assur::shape::Subject = ::assur::shape::Subject::State(4);
    /// `dot(w4)`
    pub const DOT_W4: ::assur::shape::Subject = ::assur::shape::Subject::State(5);
    /// `x1`
    pub const X1: ::assur::shape::Subject = ::assur::shape::Subject::Output(0);
    /// `x2`
    pub const X2: ::assur::shape::Subject = ::assur::shape::Subject::Output(1);
    /// `x3`
    pub const X3: ::assur::shape::Subject = ::assur::shape::Subject::Output(2);
    /// `x4`
    pub const X4: ::assur::shape::Subject = ::assur::shape::Subject::Output(3);
    /// `dot(x1)`
    pub const DOT_X1: ::assur::shape::Subject = ::assur::shape::Subject::Output(4);
    /// `dot(x2)`
    pub const DOT_X2: ::assur::shape::Subject = ::assur::shape::Subject::Output(5);
    /// `dot(x3)`
    pub const DOT_X3: ::assur::shape::Subject = ::assur::shape::Subject::Output(6);
    /// `dot(x4)`
    pub const DOT_X4: ::assur::shape::Subject = ::assur::shape::Subject::Output(7);
    /// `ddot(x1)`
    pub const DDOT_X1: ::assur::shape::Subject = ::assur::shape::Subject::Output(8);
    /// `ddot(x2)`
    pub const DDOT_X2: ::assur::shape::Subject = ::assur::shape::Subject::Output(9);
    /// `ddot(x3)`
    pub const DDOT_X3: ::assur::shape::Subject = ::assur::shape::Subject::Output(10);
    /// `ddot(x4)`
    pub const DDOT_X4: ::assur::shape::Subject = ::assur::shape::Subject::Output(11);
    /// `ddot(phi2)`
    pub const DDOT_PHI2: ::assur::shape::Subject = ::assur::shape::Subject::Output(14);
    /// `F1`
    pub const F1: ::assur::shape::Subject = ::assur::shape::Subject::Output(15);
    /// `F2`
    pub const F2: ::assur::shape::Subject = ::assur::shape::Subject::Output(16);
    /// `rod1`
    pub const ROD1: ::assur::shape::Subject = ::assur::shape::Subject::Output(17);
    /// `rod2`
    pub const ROD2: ::assur::shape::Subject = ::assur::shape::Subject::Output(18);
    /// `drive_torque`
    pub const DRIVE_TORQUE: ::assur::shape::Subject = ::assur::shape::Subject::Output(
        19,
    );
    /// `shaft_torque`
    pub const SHAFT_TORQUE: ::assur::shape::Subject = ::assur::shape::Subject::Output(
        20,
    );
    /// `x_difference`
    pub const X_DIFFERENCE: ::assur::shape::Subject = ::assur::shape::Subject::Output(
        21,
    );
    /// `v_difference`
    pub const V_DIFFERENCE: ::assur::shape::Subject = ::assur::shape::Subject::Output(
        22,
    );
    /// `F_difference`
    pub const F_DIFFERENCE: ::assur::shape::Subject = ::assur::shape::Subject::Output(
        23,
    );
    /// `peak_rod1`
    pub const PEAK_ROD1: ::assur::shape::Subject = ::assur::shape::Subject::Measure(0);
    /// `peak_rod2`
    pub const PEAK_ROD2: ::assur::shape::Subject = ::assur::shape::Subject::Measure(1);
    /// `inequality`
    pub const INEQUALITY: ::assur::shape::Subject = ::assur::shape::Subject::Measure(2);
    /// `peak_drive`
    pub const PEAK_DRIVE: ::assur::shape::Subject = ::assur::shape::Subject::Measure(3);
    /// `mean_power`
    pub const MEAN_POWER: ::assur::shape::Subject = ::assur::shape::Subject::Measure(4);
    /// `nearest_resonance`
    pub const NEAREST_RESONANCE: ::assur::shape::Subject = ::assur::shape::Subject::Measure(
        5,
    );
    /// `largest_multiplier`
    pub const LARGEST_MULTIPLIER: ::assur::shape::Subject = ::assur::shape::Subject::Measure(
        6,
    );
    /// `largest_lag`
    pub const LARGEST_LAG: ::assur::shape::Subject = ::assur::shape::Subject::Measure(7);
    /// `peak_shaft`
    pub const PEAK_SHAFT: ::assur::shape::Subject = ::assur::shape::Subject::Measure(8);
    /// What the scene is made of.
    pub const fn shape() -> &'static ::assur::shape::Shape {
        &shapes_::Elastic
    }
    /// Sets all values, SI units, in the order of the fields.
    pub fn from_values(values: &[f64; 13]) -> Self {
        Self {
            R: values[0],
            l: values[1],
            n: values[2],
            m1: values[3],
            m2: values[4],
            m3: values[5],
            m4: values[6],
            lambda: values[7],
            c: values[8],
            J2: values[9],
            d33: values[10],
            d44: values[11],
            d34: values[12],
        }
    }
    /// All values, SI units, in the order of the fields.
    pub fn values(&self) -> [f64; 13] {
        [
            self.R,
            self.l,
            self.n,
            self.m1,
            self.m2,
            self.m3,
            self.m4,
            self.lambda,
            self.c,
            self.J2,
            self.d33,
            self.d44,
            self.d34,
        ]
    }
    /// The conditions on the values.
    fn requirements_<S: ::assur::scalar::Scalar>(&self) -> [S::Mask; 2] {
        let R = <S as ::assur::scalar::Scalar>::from_f64(self.R);
        let l = <S as ::assur::scalar::Scalar>::from_f64(self.l);
        let d44 = <S as ::assur::scalar::Scalar>::from_f64(self.d44);
        let d33 = <S as ::assur::scalar::Scalar>::from_f64(self.d33);
        let d34 = <S as ::assur::scalar::Scalar>::from_f64(self.d34);
        [S::less(R, l), S::less(d34 * d34, d44 * d33)]
    }
    /// The period, or the first and the last time.
    fn span_<S: ::assur::scalar::Scalar>(&self) -> [S; 1] {
        let n = <S as ::assur::scalar::Scalar>::from_f64(self.n);
        [S::from_f64(6.283185307179586) / n]
    }
    /// The declared start values.
    fn start_<S: ::assur::scalar::Scalar>(&self) -> [S; 6] {
        [S::ZERO, S::ZERO, S::ZERO, S::ZERO, S::ZERO, S::ZERO]
    }
}
impl ::assur::problem::Scene for Elastic {
    type Equations<S: ::assur::scalar::Scalar> = ElasticEquations<S>;
    type Unreduced = Elastic;
    const SMOOTH: bool = true;
    fn shape(&self) -> &'static ::assur::shape::Shape {
        &shapes_::Elastic
    }
    #[inline(always)]
    fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
        let J2 = <S as ::assur::scalar::Scalar>::from_f64(self.J2);
        let R = <S as ::assur::scalar::Scalar>::from_f64(self.R);
        let v10_ = R * R;
        let m2 = <S as ::assur::scalar::Scalar>::from_f64(self.m2);
        let n = <S as ::assur::scalar::Scalar>::from_f64(self.n);
        let l = <S as ::assur::scalar::Scalar>::from_f64(self.l);
        let v15_ = S::ONE / l;
        let v16_ = R * v15_;
        let c = <S as ::assur::scalar::Scalar>::from_f64(self.c);
        let lambda = <S as ::assur::scalar::Scalar>::from_f64(self.lambda);
        let d44 = <S as ::assur::scalar::Scalar>::from_f64(self.d44);
        let d33 = <S as ::assur::scalar::Scalar>::from_f64(self.d33);
        let d34 = <S as ::assur::scalar::Scalar>::from_f64(self.d34);
        let v24_ = S::ONE / S::mul_add(d44, d33, -(d34 * d34));
        let v25_ = v24_ * d34;
        let v26_ = S::ONE + lambda;
        let v31_ = n * n;
        let v32_ = v10_ * v15_;
        let m3 = <S as ::assur::scalar::Scalar>::from_f64(self.m3);
        let v39_ = S::ONE / m3;
        let m4 = <S as ::assur::scalar::Scalar>::from_f64(self.m4);
        let v41_ = S::ONE / m4;
        let v45_ = -S::mul_add(lambda, d44, d34 * v26_);
        let v47_ = S::mul_add(d34, lambda, v26_ * d33);
        let v52_ = v10_ * v31_;
        let v54_ = R * v24_;
        let m1 = <S as ::assur::scalar::Scalar>::from_f64(self.m1);
        ElasticEquations {
            J2,
            R,
            m2,
            v12_: v10_ * m2,
            n,
            v16_,
            c,
            lambda,
            d44,
            d33,
            v25_,
            v26_,
            v27_: R * v26_,
            v28_: v24_ * d44,
            v29_: R * lambda,
            v30_: v24_ * d33,
            v33_: v32_ * v31_,
            v34_: R * v31_,
            v35_: S::from_f64(4.0) * v16_,
            v36_: v32_ * n,
            v37_: R * n,
            m3,
            v39_,
            m4,
            v41_,
            v42_: -c,
            v51_: v24_ * v10_ * S::mul_add(-v26_, v47_, lambda * v45_),
            v53_: v52_ * m2,
            v55_: v54_ * v45_,
            v56_: v54_ * v47_,
            v58_: -S::from_f64(2.0) * (R * m2),
            v60_: v54_ * v39_ * v45_,
            slope_4_1_: -(v24_ * v39_ * d44),
            slope_4_2_: v25_ * v39_,
            v66_: v54_ * v41_ * v47_,
            slope_5_1_: v25_ * v41_,
            slope_5_2_: -(v24_ * v41_ * d33),
            v71_: S::from_f64(0.5) * n,
            v72_: S::from_f64(0.5) * v16_,
            m1,
            v74_: v26_ * m3,
            v75_: lambda * m4,
            v76_: v26_ * m4,
            v77_: lambda * m3,
            v80_: v10_ * (S::ONE / (l * l)),
            v82_: S::from_f64(0.5) * (v52_ * m1),
            v83_: S::from_f64(0.5) * J2,
            v84_: S::from_f64(0.5) * m3,
            v85_: S::from_f64(0.5) * m4,
            v86_: S::from_f64(0.5) * m2,
            v87_: S::from_f64(0.5) * c,
            v88_: S::from_f64(0.5) * v24_,
            v89_: S::from_f64(2.0) * d34,
        }
    }
    fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
        ::assur::registry::check_values(shapes_::Elastic.constants, &self.values())?;
        let [require_0_, require_1_] = self.requirements_::<f64>();
        if !<f64 as ::assur::scalar::Scalar>::holds(require_0_) {
            return ::core::result::Result::Err(
                ::assur::registry::unmet(
                    shapes_::Elastic.constants,
                    &self.values(),
                    &[0usize, 1usize],
                    ("the connecting rod has to be longer than the crank", "R < l"),
                ),
            );
        }
        if !<f64 as ::assur::scalar::Scalar>::holds(require_1_) {
            return ::core::result::Result::Err(
                ::assur::registry::unmet(
                    shapes_::Elastic.constants,
                    &self.values(),
                    &[10usize, 11usize, 12usize],
                    (
                        "the flexibilities of the bar have to be positive definite",
                        "d33*d44 > d34^2",
                    ),
                ),
            );
        }
        ::core::result::Result::Ok(())
    }
    fn span(&self) -> ::assur::problem::Span {
        let [period] = self.span_::<f64>();
        ::assur::problem::Span::Periodic(period)
    }
    fn start(&self) -> ::std::vec::Vec<f64> {
        self.start_::<f64>().to_vec()
    }
}
impl ::assur::problem::Smooth for Elastic {}
