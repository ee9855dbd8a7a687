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
/// Source: 000_6d57365b3b3b9ea6.txt, first article, eqs (1)-(8).
///
/// Printed from `batten.eqn` by Assur.
#[allow(
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    rustdoc::all,
    non_snake_case,
    non_camel_case_types,
    non_upper_case_globals,
    unused_qualifications,
    unused_parens,
    unused_variables,
    dead_code
)]
mod batten_ {
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
    /// kinetic m1*dot(x1)^2/2 + m2*dot(x2)^2/2 + m3*dot(x3)^2/2 + m4*dot(x4)^2/2   [N m]  batten.eqn:61
    /// kinetic J2*(n - dot(phi2))^2/2                                              [N m]  batten.eqn:70
    /// potential c*phi2^2/2                                                        [N m]  batten.eqn:71
    /// potential stiffness(u3, u4)/2                                               [N m]  batten.eqn:106
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
    /// | `drive_torque` | `N m` | Torque at the drive end that keeps the speed. |
    /// | `shaft_torque` | `N m` | Torque in the shaft between its cranks. |
    /// | `x_difference` | `m` | Ends of the bar, drive side ahead of brake side. |
    /// | `v_difference` | `m/s` |  |
    /// | `F_difference` | `N` |  |
    ///
    /// Operations: 69 once per parameter set, 31 per instant, 29 per evaluation, 28 per Jacobian.
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
            Self {
                R: 0.075,
                l: 0.271,
                n: 26.17993877991494,
                m1: 28.5,
                m2: 28.5,
                m3: 2.02,
                m4: 2.02,
                lambda: 0.385,
                c: 20980.0,
                J2: 0.1004,
                d33: 3.8e-6,
                d44: 3.8e-6,
                d34: 1.22e-6,
            }
        }
    }
    impl Elastic {
        /// Names, units, defaults and ranges of the fields, in their order.
        pub const CONSTANTS: &'static [::assur::registry::Constant] = &[
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "R",
                    summary: "Crank.",
                    unit: "mm",
                    factor: 0.001,
                    dimension: [(1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: true,
                default: 0.075,
                tolerance: 0.0,
                range: (0.001, 1.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "l",
                    summary: "Connecting rod.",
                    unit: "mm",
                    factor: 0.001,
                    dimension: [(1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: true,
                default: 0.271,
                tolerance: 0.0,
                range: (0.001, 10.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "n",
                    summary: "Speed of the crankshaft.",
                    unit: "rpm",
                    factor: 0.10471975511965977,
                    dimension: [(0, 1), (0, 1), (-1, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 26.17993877991494,
                tolerance: 0.0,
                range: (0.10471975511965977, 209.43951023931953),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "m1",
                    summary: "Sword pin with rod and frame, drive side.",
                    unit: "kg",
                    factor: 1.0,
                    dimension: [(0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 28.5,
                tolerance: 0.0,
                range: (1e-6, 100000.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "m2",
                    summary: "Sword pin with rod and frame, brake side.",
                    unit: "kg",
                    factor: 1.0,
                    dimension: [(0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 28.5,
                tolerance: 0.0,
                range: (1e-6, 100000.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "m3",
                    summary: "End of the bar, drive side.",
                    unit: "kg",
                    factor: 1.0,
                    dimension: [(0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 2.02,
                tolerance: 0.0,
                range: (1e-6, 100000.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "m4",
                    summary: "End of the bar, brake side.",
                    unit: "kg",
                    factor: 1.0,
                    dimension: [(0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 2.02,
                tolerance: 0.0,
                range: (1e-6, 100000.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "lambda",
                    summary: "Cantilever of the bar over its span, L1/L.",
                    unit: "",
                    factor: 1.0,
                    dimension: [(0, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 0.385,
                tolerance: 0.0,
                range: (0.0, 10.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "c",
                    summary: "Torsional stiffness of the shaft between its cranks.",
                    unit: "N m/rad",
                    factor: 1.0,
                    dimension: [(2, 1), (1, 1), (-2, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 20980.0,
                tolerance: 0.0,
                range: (1.0, 1000000000000.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "J2",
                    summary: "Disc at the brake end.",
                    unit: "kg m^2",
                    factor: 1.0,
                    dimension: [(2, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 0.1004,
                tolerance: 0.0,
                range: (1e-9, 1000000.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "d33",
                    summary: "Displacement of the drive-side end of the bar by unit force there.",
                    unit: "m/N",
                    factor: 1.0,
                    dimension: [(0, 1), (-1, 1), (2, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 3.8e-6,
                tolerance: 0.0,
                range: (1e-15, 1.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "d44",
                    summary: "Displacement of the brake-side end of the bar by unit force there.",
                    unit: "m/N",
                    factor: 1.0,
                    dimension: [(0, 1), (-1, 1), (2, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 3.8e-6,
                tolerance: 0.0,
                range: (1e-15, 1.0),
            },
            ::assur::registry::Constant {
                quantity: ::assur::registry::Quantity {
                    name: "d34",
                    summary: "Displacement of one end of the bar by unit force at the other.",
                    unit: "m/N",
                    factor: 1.0,
                    dimension: [(0, 1), (-1, 1), (2, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
                },
                is_dimension: false,
                default: 1.22e-6,
                tolerance: 0.0,
                range: (-1.0, 1.0),
            },
        ];
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
            let R = S::from_f64(self.R);
            let l = S::from_f64(self.l);
            let d33 = S::from_f64(self.d33);
            let d44 = S::from_f64(self.d44);
            let d34 = S::from_f64(self.d34);
            [S::less(R, l), S::less(d34 * d34, d33 * d44)]
        }
        /// The period, or the first and the last time.
        fn span_<S: ::assur::scalar::Scalar>(&self) -> [S; 1] {
            let n = S::from_f64(self.n);
            [S::from_f64(6.283185307179586) / n]
        }
        /// The declared start values of the state.
        fn start_<S: ::assur::scalar::Scalar>(&self) -> [S; 6] {
            [S::ZERO, S::ZERO, S::ZERO, S::ZERO, S::ZERO, S::ZERO]
        }
    }
    impl ::assur::problem::Scene for Elastic {
        type Equations<S: ::assur::scalar::Scalar> = ElasticEquations<S>;
        const LINEAR: bool = true;
        const LARGE: bool = false;
        const STATES: usize = 6;
        const OUTPUTS: usize = 22;
        const DRIVERS: usize = 1;
        const SCALES: &'static [f64] = &[0.001, 0.001, 0.001, 0.001, 0.001, 0.001];
        const STATE_NAMES: &'static [&'static str] = &[
            "phi2",
            "w3",
            "w4",
            "dot(phi2)",
            "dot(w3)",
            "dot(w4)",
        ];
        const OUTPUT_NAMES: &'static [&'static str] = &[
            "x1",
            "x2",
            "x3",
            "x4",
            "dot(x1)",
            "dot(x2)",
            "dot(x3)",
            "dot(x4)",
            "ddot(x1)",
            "ddot(x2)",
            "ddot(x3)",
            "ddot(x4)",
            "phi2",
            "dot(phi2)",
            "ddot(phi2)",
            "F1",
            "F2",
            "drive_torque",
            "shaft_torque",
            "x_difference",
            "v_difference",
            "F_difference",
        ];
        #[inline(always)]
        fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
            let J2 = S::from_f64(self.J2);
            let m2 = S::from_f64(self.m2);
            let R = S::from_f64(self.R);
            let v11_ = R * R;
            let v12_ = m2 * v11_;
            let n = S::from_f64(self.n);
            let l = S::from_f64(self.l);
            let v15_ = S::ONE / l;
            let v16_ = R * v15_;
            let c = S::from_f64(self.c);
            let d33 = S::from_f64(self.d33);
            let d44 = S::from_f64(self.d44);
            let d34 = S::from_f64(self.d34);
            let v23_ = S::ONE / S::mul_add(d33, d44, -(d34 * d34));
            let lambda = S::from_f64(self.lambda);
            let v26_ = S::ONE + lambda;
            let v29_ = v23_ * d34;
            let v30_ = v23_ * d33;
            let v31_ = n * n;
            let v32_ = v11_ * v31_;
            let m3 = S::from_f64(self.m3);
            let v40_ = S::ONE / m3;
            let m4 = S::from_f64(self.m4);
            let v42_ = S::ONE / m4;
            let v46_ = -S::mul_add(lambda, d44, v26_ * d34);
            let v48_ = S::mul_add(lambda, d34, v26_ * d33);
            let v54_ = R * v23_;
            let m1 = S::from_f64(self.m1);
            ElasticEquations {
                J2,
                m2,
                R,
                v12_,
                n,
                v16_,
                c,
                d33,
                d44,
                d34,
                v23_,
                lambda,
                v25_: v23_ * lambda,
                v26_,
                v27_: R * v26_,
                v28_: R * lambda,
                v29_,
                v30_,
                v31_,
                v33_: v32_ * v15_,
                v34_: R * v31_,
                v35_: S::from_f64(4.0) * v16_,
                v37_: v11_ * n * v15_,
                v38_: R * n,
                m3,
                v40_,
                m4,
                v42_,
                v43_: -c,
                v52_: v23_ * v11_ * S::mul_add(-v26_, v48_, lambda * v46_),
                v53_: v12_ * v31_,
                v55_: v54_ * v46_,
                v56_: v54_ * v48_,
                v58_: -S::from_f64(2.0) * (R * m2),
                v60_: v54_ * v40_ * v46_,
                slope_4_1_: -(v23_ * v40_ * d44),
                slope_4_2_: v29_ * v40_,
                v66_: v54_ * v42_ * v48_,
                slope_5_1_: v29_ * v42_,
                slope_5_2_: -(v30_ * v42_),
                v70_: S::from_f64(0.5) * n,
                v71_: S::from_f64(0.5) * v16_,
                m1,
                v73_: lambda * m4,
                v74_: v26_ * m3,
                v75_: v26_ * m4,
                v76_: lambda * m3,
                v78_: S::from_f64(0.5) * (v32_ * m1),
                v79_: S::from_f64(0.5) * J2,
                v80_: S::from_f64(0.5) * m3,
                v81_: S::from_f64(0.5) * m4,
                v82_: S::from_f64(0.5) * m2,
                v83_: S::from_f64(0.5) * c,
                v84_: S::from_f64(0.5) * v23_,
                v85_: S::from_f64(2.0) * d34,
            }
        }
        fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
            ::assur::registry::check_values(Self::CONSTANTS, &self.values())?;
            let [require_0_, require_1_] = self.requirements_::<f64>();
            if !<f64 as ::assur::scalar::Scalar>::holds(require_0_) {
                return ::core::result::Result::Err(::assur::problem::Refused {
                    name: ::std::string::String::from(
                        "the connecting rod has to be longer than the crank",
                    ),
                    reason: ::std::format!(
                        "found R = {} mm, l = {} mm; expected R < l", self.R / 0.001,
                        self.l / 0.001
                    ),
                });
            }
            if !<f64 as ::assur::scalar::Scalar>::holds(require_1_) {
                return ::core::result::Result::Err(::assur::problem::Refused {
                    name: ::std::string::String::from(
                        "the flexibilities of the bar have to be positive definite",
                    ),
                    reason: ::std::format!(
                        "found d33 = {} m/N, d44 = {} m/N, d34 = {} m/N; expected d33*d44 > d34^2",
                        self.d33, self.d44, self.d34
                    ),
                });
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
    /// Equations of [`Elastic`], prepared for a scalar type.
    #[derive(Clone, Copy, Debug)]
    pub struct ElasticEquations<S: ::assur::scalar::Scalar> {
        J2: S,
        m2: S,
        R: S,
        /// `m2*R^2`
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
        /// `v23_*d34`
        v29_: S,
        /// `v23_*d33`
        v30_: S,
        /// `n^2`
        v31_: S,
        /// `R^2*v31_*(1/l)`
        v33_: S,
        /// `R*v31_`
        v34_: S,
        /// `4*v16_`
        v35_: S,
        /// `R^2*n*(1/l)`
        v37_: S,
        /// `R*n`
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
        /// `v12_*v31_`
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
        /// Jacobian, rate of `dot(w3)` by `w4`: `v29_*v40_`
        slope_4_2_: S,
        /// `R*v23_*v42_*(lambda*d34 + v26_*d33)`
        v66_: S,
        /// Jacobian, rate of `dot(w4)` by `w3`: `v29_*v42_`
        slope_5_1_: S,
        /// Jacobian, rate of `dot(w4)` by `w4`: `-v30_*v42_`
        slope_5_2_: S,
        /// `0.5*n`
        v70_: S,
        /// `0.5*v16_`
        v71_: S,
        m1: S,
        /// `lambda*m4`
        v73_: S,
        /// `v26_*m3`
        v74_: S,
        /// `v26_*m4`
        v75_: S,
        /// `lambda*m3`
        v76_: S,
        /// `0.5*(R^2*v31_*m1)`
        v78_: S,
        /// `0.5*J2`
        v79_: S,
        /// `0.5*m3`
        v80_: S,
        /// `0.5*m4`
        v81_: S,
        /// `0.5*m2`
        v82_: S,
        /// `0.5*c`
        v83_: S,
        /// `0.5*v23_`
        v84_: S,
        /// `2*d34`
        v85_: S,
    }
    impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S>
    for ElasticEquations<S> {
        type State = [S; 6];
        type Instant = ElasticInstant<S>;
        #[inline(always)]
        fn states(&self) -> usize {
            6
        }
        /// 31 operations.
        #[inline(always)]
        fn instant(&self, time: S) -> Self::Instant {
            let theta = self.n * time;
            let (sin_theta_, cos_theta_) = S::sin_cos(theta);
            let v93_ = sin_theta_ * sin_theta_;
            let v95_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
            let v100_ = v95_ * sin_theta_;
            let v104_ = v95_ * cos_theta_;
            let ddot_x1 = S::mul_add(self.v34_, v104_, self.v33_ * v93_);
            ElasticInstant {
                sin_theta_,
                cos_theta_,
                v99_: S::ONE / S::mul_add(self.v12_, v93_ * (v95_ * v95_), self.J2),
                v101_: self.R * v100_,
                v102_: self.v27_ * v100_,
                v103_: self.v28_ * v100_,
                ddot_x1,
                v109_: self.v34_
                    * (sin_theta_ * S::mul_add(self.v35_, cos_theta_, -S::ONE)),
                v112_: S::from_f64(2.0) * S::mul_add(self.v38_, v104_, self.v37_ * v93_),
                v114_: -(self.m3 * ddot_x1),
                v116_: -(self.m4 * ddot_x1),
            }
        }
        #[inline(always)]
        fn instants<const K_: usize>(&self, times: [S; K_]) -> [Self::Instant; K_] {
            let mut angle_theta_ = [S::ZERO; K_];
            for k_ in 0..K_ {
                let time = times[k_];
                angle_theta_[k_] = self.n * time;
            }
            let (sin_theta_, cos_theta_) = S::sin_cos_all::<K_>(angle_theta_);
            let mut instants = [ElasticInstant {
                sin_theta_: S::ZERO,
                cos_theta_: S::ZERO,
                v99_: S::ZERO,
                v101_: S::ZERO,
                v102_: S::ZERO,
                v103_: S::ZERO,
                ddot_x1: S::ZERO,
                v109_: S::ZERO,
                v112_: S::ZERO,
                v114_: S::ZERO,
                v116_: S::ZERO,
            }; K_];
            for k_ in 0..K_ {
                let time = times[k_];
                let v93_ = sin_theta_[k_] * sin_theta_[k_];
                let v95_ = S::mul_add(-self.v16_, cos_theta_[k_], S::ONE);
                let v100_ = v95_ * sin_theta_[k_];
                let v104_ = v95_ * cos_theta_[k_];
                let ddot_x1 = S::mul_add(self.v34_, v104_, self.v33_ * v93_);
                instants[k_] = ElasticInstant {
                    sin_theta_: sin_theta_[k_],
                    cos_theta_: cos_theta_[k_],
                    v99_: S::ONE / S::mul_add(self.v12_, v93_ * (v95_ * v95_), self.J2),
                    v101_: self.R * v100_,
                    v102_: self.v27_ * v100_,
                    v103_: self.v28_ * v100_,
                    ddot_x1,
                    v109_: self.v34_
                        * (sin_theta_[k_]
                            * S::mul_add(self.v35_, cos_theta_[k_], -S::ONE)),
                    v112_: S::from_f64(2.0)
                        * S::mul_add(self.v38_, v104_, self.v37_ * v93_),
                    v114_: -(self.m3 * ddot_x1),
                    v116_: -(self.m4 * ddot_x1),
                };
            }
            instants
        }
        /// 29 operations.
        #[inline(always)]
        fn derivative(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            rate: &mut Self::State,
        ) {
            let phi2 = state[0];
            let w3 = state[1];
            let w4 = state[2];
            let dot_phi2 = state[3];
            let dot_w3 = state[4];
            let dot_w4 = state[5];
            let u4 = S::mul_add(instant.v102_, phi2, w4);
            let u3 = S::mul_add(-instant.v103_, phi2, w3);
            let v154_ = S::mul_add(-self.d34, u4, self.d44 * u3);
            let v155_ = self.v29_ * u3;
            let v156_ = self.v30_ * u4;
            let ddot_phi2 = instant.v99_
                * S::mul_add(
                    -self.c,
                    phi2,
                    instant.v101_
                        * S::mul_add(
                            self.m2,
                            S::mul_add(
                                -instant.v112_,
                                dot_phi2,
                                S::mul_add(-instant.v109_, phi2, instant.ddot_x1),
                            ),
                            S::mul_add(self.v26_, v155_ - v156_, self.v25_ * v154_),
                        ),
                );
            *rate = [
                dot_phi2,
                dot_w3,
                dot_w4,
                ddot_phi2,
                self.v40_ * S::mul_add(-self.v23_, v154_, instant.v114_),
                self.v42_ * (instant.v116_ + v155_ - v156_),
            ];
        }
        #[inline(always)]
        fn variation(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            rate: &mut Self::State,
            columns: &[Self::State],
            products: &mut [Self::State],
        ) {
            let phi2 = state[0];
            let w3 = state[1];
            let w4 = state[2];
            let dot_phi2 = state[3];
            let dot_w3 = state[4];
            let dot_w4 = state[5];
            let v93_ = instant.sin_theta_ * instant.sin_theta_;
            let v95_ = S::mul_add(-self.v16_, instant.cos_theta_, S::ONE);
            let v100_ = v95_ * instant.sin_theta_;
            let slope_3_0_ = instant.v99_
                * S::mul_add(
                    v95_ * v93_,
                    S::mul_add(
                        -self.v53_,
                        S::mul_add(self.v35_, instant.cos_theta_, -S::ONE),
                        self.v52_ * v95_,
                    ),
                    self.v43_,
                );
            let v122_ = v100_ * instant.v99_;
            let slope_3_1_ = -(self.v55_ * v122_);
            let slope_3_2_ = -(self.v56_ * v122_);
            let slope_3_3_ = self.v58_
                * (v122_
                    * S::mul_add(
                        self.v38_,
                        v95_ * instant.cos_theta_,
                        self.v37_ * v93_,
                    ));
            let slope_4_0_ = -(self.v60_ * v100_);
            let slope_5_0_ = -(self.v66_ * v100_);
            let u4 = S::mul_add(instant.v102_, phi2, w4);
            let u3 = S::mul_add(-instant.v103_, phi2, w3);
            let v154_ = S::mul_add(-self.d34, u4, self.d44 * u3);
            let v155_ = self.v29_ * u3;
            let v156_ = self.v30_ * u4;
            let ddot_phi2 = instant.v99_
                * S::mul_add(
                    -self.c,
                    phi2,
                    instant.v101_
                        * S::mul_add(
                            self.m2,
                            S::mul_add(
                                -instant.v112_,
                                dot_phi2,
                                S::mul_add(-instant.v109_, phi2, instant.ddot_x1),
                            ),
                            S::mul_add(self.v26_, v155_ - v156_, self.v25_ * v154_),
                        ),
                );
            *rate = [
                dot_phi2,
                dot_w3,
                dot_w4,
                ddot_phi2,
                self.v40_ * S::mul_add(-self.v23_, v154_, instant.v114_),
                self.v42_ * (instant.v116_ + v155_ - v156_),
            ];
            for (column_, product_) in columns.iter().zip(products) {
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
            instant: &Self::Instant,
            state: &Self::State,
            columns: &mut [Self::State],
        ) {
            ::core::debug_assert!(columns.len() >= 6);
            let ::core::option::Option::Some(columns) = columns.first_chunk_mut::<6>()
            else { return };
            let v93_ = instant.sin_theta_ * instant.sin_theta_;
            let v95_ = S::mul_add(-self.v16_, instant.cos_theta_, S::ONE);
            let v100_ = v95_ * instant.sin_theta_;
            let v122_ = v100_ * instant.v99_;
            columns[0] = [
                S::ZERO,
                S::ZERO,
                S::ZERO,
                instant.v99_
                    * S::mul_add(
                        v95_ * v93_,
                        S::mul_add(
                            -self.v53_,
                            S::mul_add(self.v35_, instant.cos_theta_, -S::ONE),
                            self.v52_ * v95_,
                        ),
                        self.v43_,
                    ),
                -(self.v60_ * v100_),
                -(self.v66_ * v100_),
            ];
            columns[1] = [
                S::ZERO,
                S::ZERO,
                S::ZERO,
                -(self.v55_ * v122_),
                self.slope_4_1_,
                self.slope_5_1_,
            ];
            columns[2] = [
                S::ZERO,
                S::ZERO,
                S::ZERO,
                -(self.v56_ * v122_),
                self.slope_4_2_,
                self.slope_5_2_,
            ];
            columns[3] = [
                S::ONE,
                S::ZERO,
                S::ZERO,
                self.v58_
                    * (v122_
                        * S::mul_add(
                            self.v38_,
                            v95_ * instant.cos_theta_,
                            self.v37_ * v93_,
                        )),
                S::ZERO,
                S::ZERO,
            ];
            columns[4] = [S::ZERO, S::ONE, S::ZERO, S::ZERO, S::ZERO, S::ZERO];
            columns[5] = [S::ZERO, S::ZERO, S::ONE, S::ZERO, S::ZERO, S::ZERO];
        }
        /// 117 operations.
        #[inline(always)]
        fn outputs(&self, time: S, state: &Self::State, values: &mut [S]) {
            ::core::debug_assert!(values.len() >= 22);
            let ::core::option::Option::Some(values) = values.first_chunk_mut::<22>()
            else { return };
            let phi2 = state[0];
            let w3 = state[1];
            let w4 = state[2];
            let dot_phi2 = state[3];
            let dot_w3 = state[4];
            let dot_w4 = state[5];
            let theta = self.n * time;
            let shaft = self.c * phi2;
            let v_difference = dot_w3 - dot_w4;
            let ([sin_theta_, sin_v133_], [cos_theta_, _]) = S::sin_cos_all([
                theta,
                self.v70_ * time,
            ]);
            let v93_ = sin_theta_ * sin_theta_;
            let v95_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
            let v99_ = S::ONE / S::mul_add(self.v12_, v93_ * (v95_ * v95_), self.J2);
            let v100_ = v95_ * sin_theta_;
            let v101_ = self.R * v100_;
            let v104_ = v95_ * cos_theta_;
            let ddot_x1 = S::mul_add(self.v34_, v104_, self.v33_ * v93_);
            let v107_ = S::mul_add(self.v35_, cos_theta_, -S::ONE);
            let v111_ = S::mul_add(self.v38_, v104_, self.v37_ * v93_);
            let v112_ = S::from_f64(2.0) * v111_;
            let x1 = self.R
                * S::mul_add(
                    -self.v71_,
                    v93_,
                    S::from_f64(2.0) * (sin_v133_ * sin_v133_),
                );
            let dot_x1 = self.v38_ * v100_;
            let u4 = S::mul_add(self.v27_ * v100_, phi2, w4);
            let u3 = S::mul_add(-(self.v28_ * v100_), phi2, w3);
            let v154_ = S::mul_add(-self.d34, u4, self.d44 * u3);
            let v155_ = self.v29_ * u3;
            let v156_ = self.v30_ * u4;
            let v159_ = S::mul_add(
                -v112_,
                dot_phi2,
                S::mul_add(-(self.v34_ * (sin_theta_ * v107_)), phi2, ddot_x1),
            );
            let x2 = S::mul_add(-v101_, phi2, x1);
            let x3 = x1 + w3;
            let x4 = x1 + w4;
            let v186_ = v95_ * v99_
                * S::mul_add(
                    v101_,
                    S::mul_add(
                        -self.m2,
                        v159_,
                        self.v23_
                            * S::mul_add(
                                -self.lambda,
                                v154_,
                                self.v26_ * S::mul_add(-self.d34, u3, self.d33 * u4),
                            ),
                    ),
                    shaft,
                );
            let ddot_x2 = S::mul_add(
                -v112_,
                dot_phi2,
                S::mul_add(
                    self.R * sin_theta_,
                    S::mul_add(-(self.v31_ * v107_), phi2, v186_),
                    ddot_x1,
                ),
            );
            let ddot_x3 = ddot_x1
                + self.v40_ * S::mul_add(-self.v23_, v154_, -(self.m3 * ddot_x1));
            let ddot_x4 = ddot_x1 + self.v42_ * (v155_ - (self.m4 * ddot_x1) - v156_);
            let F1 = S::mul_add(
                -self.v73_,
                ddot_x4,
                S::mul_add(self.v74_, ddot_x3, self.m1 * ddot_x1),
            );
            let F2 = S::mul_add(
                -self.v76_,
                ddot_x3,
                S::mul_add(self.m2, ddot_x2, self.v75_ * ddot_x4),
            );
            let drive_torque = S::mul_add(v101_, F1, shaft);
            let x_difference = x3 - x4;
            let F_difference = F1 - F2;
            values[0] = x1;
            values[1] = x2;
            values[2] = x3;
            values[3] = x4;
            values[4] = dot_x1;
            values[5] = S::mul_add(-v111_, phi2, S::mul_add(-v101_, dot_phi2, dot_x1));
            values[6] = dot_x1 + dot_w3;
            values[7] = dot_x1 + dot_w4;
            values[8] = ddot_x1;
            values[9] = ddot_x2;
            values[10] = ddot_x3;
            values[11] = ddot_x4;
            values[12] = phi2;
            values[13] = dot_phi2;
            values[14] = v99_
                * S::mul_add(
                    -self.c,
                    phi2,
                    v101_
                        * S::mul_add(
                            self.m2,
                            v159_,
                            S::mul_add(self.v26_, v155_ - v156_, self.v25_ * v154_),
                        ),
                );
            values[15] = F1;
            values[16] = F2;
            values[17] = drive_torque;
            values[18] = shaft;
            values[19] = x_difference;
            values[20] = v_difference;
            values[21] = F_difference;
        }
        #[inline(always)]
        fn drivers(&self, time: S, values: &mut [S]) {
            ::core::debug_assert!(values.len() >= 1);
            let ::core::option::Option::Some(values) = values.first_chunk_mut::<1>()
            else { return };
            values[0] = self.n * time;
        }
    }
    /// What the equations of [`Elastic`] need of one time.
    #[derive(Clone, Copy, Debug)]
    pub struct ElasticInstant<S: ::assur::scalar::Scalar> {
        /// `sin(n*time)`
        sin_theta_: S,
        /// `cos(n*time)`
        cos_theta_: S,
        /// `1/(m2*R^2*(sin_theta_^2*(1 - R*(1/l)*cos_theta_)^2) + J2)`
        v99_: S,
        /// `R*((1 - R*(1/l)*cos_theta_)*sin_theta_)`
        v101_: S,
        /// `R*(1 + lambda)*((1 - R*(1/l)*cos_theta_)*sin_theta_)`
        v102_: S,
        /// `R*lambda*((1 - R*(1/l)*cos_theta_)*sin_theta_)`
        v103_: S,
        /// `R*n^2*((1 - R*(1/l)*cos_theta_)*cos_theta_) + R^2*n^2*(1/l)*sin_theta_^2`
        ddot_x1: S,
        /// `R*n^2*(sin_theta_*(4*(R*(1/l))*cos_theta_ + (-1)))`
        v109_: S,
        /// `2*(R*n*((1 - R*(1/l)*cos_theta_)*cos_theta_) + R^2*n*(1/l)*sin_theta_^2)`
        v112_: S,
        /// `-m3*ddot_x1`
        v114_: S,
        /// `-m4*ddot_x1`
        v116_: S,
    }
    impl<S: ::assur::scalar::Scalar> ElasticEquations<S> {
        /// The symmetric mass matrix, in the order of the coordinates.
        #[inline]
        pub fn mass_matrix(&self, time: S, state: &[S; 6]) -> [[S; 3]; 3] {
            let theta = self.n * time;
            let (sin_theta_, cos_theta_) = S::sin_cos(theta);
            let v95_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
            let v98_ = S::mul_add(
                self.v12_,
                sin_theta_ * sin_theta_ * (v95_ * v95_),
                self.J2,
            );
            [
                [v98_, S::ZERO, S::ZERO],
                [S::ZERO, self.m3, S::ZERO],
                [S::ZERO, S::ZERO, self.m4],
            ]
        }
        /// Kinetic and potential energy, in joules.
        #[inline]
        pub fn energy(&self, time: S, state: &[S; 6]) -> (S, S) {
            let phi2 = state[0];
            let w3 = state[1];
            let w4 = state[2];
            let dot_phi2 = state[3];
            let dot_w3 = state[4];
            let dot_w4 = state[5];
            let theta = self.n * time;
            let v201_ = self.n - dot_phi2;
            let (sin_theta_, cos_theta_) = S::sin_cos(theta);
            let v93_ = sin_theta_ * sin_theta_;
            let v95_ = S::mul_add(-self.v16_, cos_theta_, S::ONE);
            let v100_ = v95_ * sin_theta_;
            let dot_x1 = self.v38_ * v100_;
            let u4 = S::mul_add(self.v27_ * v100_, phi2, w4);
            let u3 = S::mul_add(-(self.v28_ * v100_), phi2, w3);
            let dot_x2 = S::mul_add(
                -S::mul_add(self.v38_, v95_ * cos_theta_, self.v37_ * v93_),
                phi2,
                S::mul_add(-(self.R * v100_), dot_phi2, dot_x1),
            );
            let dot_x3 = dot_x1 + dot_w3;
            let dot_x4 = dot_x1 + dot_w4;
            let v208_ = S::mul_add(
                self.v81_,
                dot_x4 * dot_x4,
                S::mul_add(
                    self.v80_,
                    dot_x3 * dot_x3,
                    S::mul_add(
                        self.v79_,
                        v201_ * v201_,
                        self.v78_ * (v93_ * (v95_ * v95_)),
                    ),
                ),
            );
            (
                S::mul_add(self.v82_, dot_x2 * dot_x2, v208_),
                S::mul_add(
                    self.v84_,
                    S::mul_add(
                        u3,
                        S::mul_add(-self.v85_, u4, self.d44 * u3),
                        self.d33 * (u4 * u4),
                    ),
                    self.v83_ * (phi2 * phi2),
                ),
            )
        }
    }
    /// The first scene of the mechanism, `Elastic`.
    pub type Batten = Elastic;
    /// The mechanism `Batten` as data.
    pub static MECHANISM: ::assur::registry::Mechanism = ::assur::registry::Mechanism {
        name: "batten",
        title: "Batten",
        summary: "Batten of an automatic shuttle loom: a crank at each end of one shaft swings the batten, whose two swords carry\nan elastic bar.\n\nSix masses, three degrees of freedom. All displacements are measured forward, towards the cloth, from the rear\ndead centre, where `theta = 0`. The arc of the sword pins is replaced by its chord.\n\nThe coordinates of the bar are its deflections `w3`, `w4` from the rigid motion: the elastic forces are\ndifferences some 200 times smaller than their terms when they are written in `x3` and `x4`.\n\nThe masses and stiffnesses are a reconstruction: the paper fixes their ratios alone.",
        source: "000_6d57365b3b3b9ea6.txt, first article, eqs (1)-(8)",
        file: "",
        text: "",
        effects: &[
            ::assur::registry::Named {
                name: "torsion",
                summary: "the crankshaft twists between its cranks",
            },
            ::assur::registry::Named {
                name: "bending",
                summary: "the bar bends",
            },
            ::assur::registry::Named {
                name: "coupling",
                summary: "a force on one end of the bar moves its other end too",
            },
            ::assur::registry::Named {
                name: "damping",
                summary: "shaft and bar lose energy in their material",
            },
        ],
        choices: &[
            ::assur::registry::Choice {
                name: "crank",
                summary: "how exactly the crank and rod are described",
                alternatives: &["two_term", "exact", "harmonic"],
            },
            ::assur::registry::Choice {
                name: "linearisation",
                summary: "how the lag enters the travel of the brake-side pin",
                alternatives: &["K1", "K2", "K3"],
            },
        ],
        presets: &[],
        scenes: &[
            ::assur::registry::SceneEntry {
                name: "elastic",
                summary: "The paper's model: shaft and bar are elastic, nothing is lost.",
                effects: &["bending", "coupling", "torsion"],
                choices: &[("crank", "two_term"), ("linearisation", "K1")],
                preset: "",
                constants: Elastic::CONSTANTS,
                drivers: &[
                    ::assur::registry::Quantity {
                        name: "theta",
                        summary: "Angle of the drive-end crank from the rear dead centre.",
                        unit: "rad",
                        factor: 1.0,
                        dimension: [
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                ],
                states: &[
                    ::assur::registry::Quantity {
                        name: "phi2",
                        summary: "Lag of the brake-end crank behind the drive-end one.",
                        unit: "rad",
                        factor: 1.0,
                        dimension: [
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "w3",
                        summary: "Displacement of the drive-side end of the bar from the rigid motion.",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "w4",
                        summary: "Displacement of the brake-side end of the bar from the rigid motion.",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(phi2)",
                        summary: "",
                        unit: "rad/s",
                        factor: 1.0,
                        dimension: [
                            (0, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(w3)",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(w4)",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                ],
                outputs: &[
                    ::assur::registry::Quantity {
                        name: "x1",
                        summary: "",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "x2",
                        summary: "",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "x3",
                        summary: "",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "x4",
                        summary: "",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(x1)",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(x2)",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(x3)",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(x4)",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "ddot(x1)",
                        summary: "",
                        unit: "m/s^2",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "ddot(x2)",
                        summary: "",
                        unit: "m/s^2",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "ddot(x3)",
                        summary: "",
                        unit: "m/s^2",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "ddot(x4)",
                        summary: "",
                        unit: "m/s^2",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "phi2",
                        summary: "",
                        unit: "rad",
                        factor: 1.0,
                        dimension: [
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "dot(phi2)",
                        summary: "",
                        unit: "rad/s",
                        factor: 1.0,
                        dimension: [
                            (0, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "ddot(phi2)",
                        summary: "",
                        unit: "rad/s^2",
                        factor: 1.0,
                        dimension: [
                            (0, 1),
                            (0, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "F1",
                        summary: "",
                        unit: "N",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (1, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "F2",
                        summary: "",
                        unit: "N",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (1, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "drive_torque",
                        summary: "Torque at the drive end that keeps the speed.",
                        unit: "N m",
                        factor: 1.0,
                        dimension: [
                            (2, 1),
                            (1, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "shaft_torque",
                        summary: "Torque in the shaft between its cranks.",
                        unit: "N m",
                        factor: 1.0,
                        dimension: [
                            (2, 1),
                            (1, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "x_difference",
                        summary: "Ends of the bar, drive side ahead of brake side.",
                        unit: "m",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "v_difference",
                        summary: "",
                        unit: "m/s",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (0, 1),
                            (-1, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                    ::assur::registry::Quantity {
                        name: "F_difference",
                        summary: "",
                        unit: "N",
                        factor: 1.0,
                        dimension: [
                            (1, 1),
                            (1, 1),
                            (-2, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                            (0, 1),
                        ],
                    },
                ],
                equations: &[
                    ::assur::registry::EquationText {
                        text: "kinetic m1*dot(x1)^2/2 + m2*dot(x2)^2/2 + m3*dot(x3)^2/2 + m4*dot(x4)^2/2",
                        unit: "N m",
                        line: 61,
                    },
                    ::assur::registry::EquationText {
                        text: "kinetic J2*(n - dot(phi2))^2/2",
                        unit: "N m",
                        line: 70,
                    },
                    ::assur::registry::EquationText {
                        text: "potential c*phi2^2/2",
                        unit: "N m",
                        line: 71,
                    },
                    ::assur::registry::EquationText {
                        text: "potential stiffness(u3, u4)/2",
                        unit: "N m",
                        line: 106,
                    },
                ],
                operations: ::assur::registry::Operations {
                    prepare: 69,
                    instant: 31,
                    derivative: 29,
                    jacobian: 28,
                    outputs: 117,
                },
                marks: &[
                    ::assur::registry::Mark {
                        text: "rear dead centre",
                        at: ::assur::registry::At::Driver(0, 0.0),
                    },
                    ::assur::registry::Mark {
                        text: "locks",
                        at: ::assur::registry::At::Driver(0, 1.9198),
                    },
                    ::assur::registry::Mark {
                        text: "front dead centre",
                        at: ::assur::registry::At::Driver(0, 3.141592653589793),
                    },
                ],
                expectations: &[
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 0.0),
                        quantity: (true, 13),
                        value: 0.078796,
                        tolerance: 0.0016,
                        preset: "",
                        remark: "eq (8), printed 0.076796",
                        line: 191,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 0.0),
                        quantity: (true, 2),
                        value: -0.00037819,
                        tolerance: 5e-6,
                        preset: "",
                        remark: "eq (8)",
                        line: 192,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 0.0),
                        quantity: (true, 3),
                        value: -0.00037682,
                        tolerance: 5e-6,
                        preset: "",
                        remark: "eq (8)",
                        line: 193,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 1.9198),
                        quantity: (true, 12),
                        value: -0.000758,
                        tolerance: 1e-5,
                        preset: "",
                        remark: "start of the blow into the locks",
                        line: 194,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 1.9198),
                        quantity: (true, 13),
                        value: -0.210545,
                        tolerance: 0.004,
                        preset: "",
                        remark: "start of the blow into the locks",
                        line: 195,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 1.9198),
                        quantity: (true, 2),
                        value: 0.09156517,
                        tolerance: 0.0001,
                        preset: "",
                        remark: "start of the blow into the locks",
                        line: 196,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 1.9198),
                        quantity: (true, 6),
                        value: 2.0326885,
                        tolerance: 0.003,
                        preset: "",
                        remark: "printed 2.0826885, which X'ω = 2.02 excludes",
                        line: 197,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 1.9198),
                        quantity: (true, 3),
                        value: 0.09166565,
                        tolerance: 0.0001,
                        preset: "",
                        remark: "start of the blow into the locks",
                        line: 198,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Driver(0, 1.9198),
                        quantity: (true, 7),
                        value: 2.0608894,
                        tolerance: 0.003,
                        preset: "",
                        remark: "start of the blow into the locks",
                        line: 199,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Amplitude,
                        quantity: (true, 12),
                        value: 0.0037,
                        tolerance: 0.0001,
                        preset: "",
                        remark: "figure 2",
                        line: 200,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Amplitude,
                        quantity: (true, 13),
                        value: 0.24,
                        tolerance: 0.005,
                        preset: "",
                        remark: "figure 2",
                        line: 201,
                    },
                    ::assur::registry::Expectation {
                        at: ::assur::registry::At::Amplitude,
                        quantity: (true, 14),
                        value: 15.4,
                        tolerance: 0.3,
                        preset: "",
                        remark: "text; the scan shows 154",
                        line: 202,
                    },
                ],
                bind: bind_Elastic_,
            },
        ],
    };
    fn bind_Elastic_(
        values: &[f64],
    ) -> ::core::result::Result<
        ::std::boxed::Box<dyn ::assur::registry::Run>,
        ::assur::problem::Refused,
    > {
        let ::core::result::Result::Ok(values) = values.try_into() else {
            return ::core::result::Result::Err(::assur::problem::Refused {
                name: ::std::string::String::from("number of values"),
                reason: ::std::format!("found {}, expected 13", values.len()),
            });
        };
        ::assur::registry::bind(Elastic::from_values(values))
    }
    #[cfg(test)]
    #[allow(unnameable_test_items)]
    mod tests_ {
        mod elastic {
            #[test]
            fn jacobian_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::jacobian::<super::super::Elastic>()
            }
            /// `dot(phi2) at theta = 0 rad`, batten.eqn:191
            #[test]
            fn dot_phi2_at_theta_0_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 0)
            }
            /// `x3 at theta = 0 rad`, batten.eqn:192
            #[test]
            fn x3_at_theta_0_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 1)
            }
            /// `x4 at theta = 0 rad`, batten.eqn:193
            #[test]
            fn x4_at_theta_0_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 2)
            }
            /// `phi2 at theta = 1.9198 rad`, batten.eqn:194
            #[test]
            fn phi2_at_theta_1_9198_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 3)
            }
            /// `dot(phi2) at theta = 1.9198 rad`, batten.eqn:195
            #[test]
            fn dot_phi2_at_theta_1_9198_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 4)
            }
            /// `x3 at theta = 1.9198 rad`, batten.eqn:196
            #[test]
            fn x3_at_theta_1_9198_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 5)
            }
            /// `dot(x3) at theta = 1.9198 rad`, batten.eqn:197
            #[test]
            fn dot_x3_at_theta_1_9198_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 6)
            }
            /// `x4 at theta = 1.9198 rad`, batten.eqn:198
            #[test]
            fn x4_at_theta_1_9198_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 7)
            }
            /// `dot(x4) at theta = 1.9198 rad`, batten.eqn:199
            #[test]
            fn dot_x4_at_theta_1_9198_rad() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 8)
            }
            /// `phi2, amplitude`, batten.eqn:200
            #[test]
            fn phi2_amplitude() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 9)
            }
            /// `dot(phi2), amplitude`, batten.eqn:201
            #[test]
            fn dot_phi2_amplitude() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 10)
            }
            /// `ddot(phi2), amplitude`, batten.eqn:202
            #[test]
            fn ddot_phi2_amplitude() -> ::core::result::Result<
                (),
                ::assur::check::Failed,
            > {
                ::assur::check::fact(&super::super::MECHANISM, "elastic", 11)
            }
        }
    }
}
#[allow(unused_imports)]
pub use batten_::{Elastic, ElasticEquations, ElasticInstant, Batten, MECHANISM};
