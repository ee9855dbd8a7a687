/// A point mass on a massless rod.
///
/// Source: any textbook.
///
/// Printed from `pendulum.eqn` by Assur.
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
mod pendulum_ {
    /// A point mass on a massless rod.
    ///
    /// Scene `swing`: two swings or so.
    ///
    /// ```text
    /// kinetic m*(l*dot(phi))^2/2   [N m]  pendulum.eqn:11
    /// potential -m*g*l*cos(phi)    [N m]  pendulum.eqn:12
    /// ```
    ///
    /// Parameters:
    ///
    /// | name | value |  |  |
    /// |---|---|---|---|
    /// | `l` | `1 m` | `in 0.001 m .. 100 m` | Length of the rod. |
    /// | `m` | `2 kg` |  |  |
    /// | `g` | `9.81 m/s^2` |  |  |
    ///
    /// State:
    ///
    /// | name | unit |  |
    /// |---|---|---|
    /// | `phi` | `rad` |  |
    /// | `dot(phi)` | `rad/s` |  |
    ///
    /// Outputs:
    ///
    /// | name | unit |  |
    /// |---|---|---|
    /// | `pull` | `N` | Force in the rod. |
    ///
    /// Operations: 7 once per parameter set, 0 per instant, 3 per evaluation, 3 per Jacobian.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Swing {
        /// Length of the rod: `1 m`, `in 0.001 m .. 100 m`.
        pub l: f64,
        /// Parameter: `2 kg`.
        pub m: f64,
        /// Parameter: `9.81 m/s^2`.
        pub g: f64,
    }
    impl ::core::default::Default for Swing {
        fn default() -> Self {
            Self::from_values(&shapes_::Swing.defaults())
        }
    }
    impl Swing {
        /// `phi`
        pub const PHI: ::assur::shape::Subject = ::assur::shape::Subject::State(0);
        /// `dot(phi)`
        pub const DOT_PHI: ::assur::shape::Subject = ::assur::shape::Subject::State(1);
        /// `pull`
        pub const PULL: ::assur::shape::Subject = ::assur::shape::Subject::Output(0);
        /// What the scene is made of.
        pub const fn shape() -> &'static ::assur::shape::Shape {
            &shapes_::Swing
        }
        /// Sets all values, SI units, in the order of the fields.
        pub fn from_values(values: &[f64; 3]) -> Self {
            Self {
                l: values[0],
                m: values[1],
                g: values[2],
            }
        }
        /// All values, SI units, in the order of the fields.
        pub fn values(&self) -> [f64; 3] {
            [self.l, self.m, self.g]
        }
        /// The conditions on the values.
        fn requirements_<S: ::assur::scalar::Scalar>(&self) -> [S::Mask; 1] {
            let l = <S as ::assur::scalar::Scalar>::from_f64(self.l);
            [S::less(l, S::from_f64(50.0))]
        }
        /// The period, or the first and the last time.
        fn span_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
            [S::ZERO, S::from_f64(4.0)]
        }
        /// The declared start values.
        fn start_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
            [S::ONE, S::ZERO]
        }
    }
    impl ::assur::problem::Scene for Swing {
        type Equations<S: ::assur::scalar::Scalar> = SwingEquations<S>;
        type Unreduced = Swing;
        const SMOOTH: bool = true;
        fn shape(&self) -> &'static ::assur::shape::Shape {
            &shapes_::Swing
        }
        #[inline(always)]
        fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
            let g = <S as ::assur::scalar::Scalar>::from_f64(self.g);
            let l = <S as ::assur::scalar::Scalar>::from_f64(self.l);
            let m = <S as ::assur::scalar::Scalar>::from_f64(self.m);
            let v11_ = m * (l * l);
            SwingEquations {
                g,
                l,
                v8_: g * (S::ONE / l),
                m,
                v11_,
                v12_: S::from_f64(0.5) * v11_,
                v14_: g * m * l,
            }
        }
        fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
            ::assur::registry::check_values(shapes_::Swing.constants, &self.values())?;
            let [require_0_] = self.requirements_::<f64>();
            if !<f64 as ::assur::scalar::Scalar>::holds(require_0_) {
                return ::core::result::Result::Err(
                    ::assur::registry::unmet(
                        shapes_::Swing.constants,
                        &self.values(),
                        &[0usize],
                        ("the rod has to be short", "l < 50 m"),
                    ),
                );
            }
            ::core::result::Result::Ok(())
        }
        fn span(&self) -> ::assur::problem::Span {
            let [from, to] = self.span_::<f64>();
            ::assur::problem::Span::Run(from, to)
        }
        fn start(&self) -> ::std::vec::Vec<f64> {
            self.start_::<f64>().to_vec()
        }
    }
    impl ::assur::problem::Smooth for Swing {}
    /// Equations of [`Swing`], prepared for a scalar type.
    #[derive(Clone, Copy, Debug)]
    pub struct SwingEquations<S: ::assur::scalar::Scalar> {
        g: S,
        l: S,
        /// `g*(1/l)`
        v8_: S,
        m: S,
        /// `m*l^2`
        v11_: S,
        /// `0.5*v11_`
        v12_: S,
        /// `g*m*l`
        v14_: S,
    }
    impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S>
    for SwingEquations<S> {
        #[inline(always)]
        fn states(&self) -> usize {
            2
        }
        /// 3 operations.
        #[inline(always)]
        fn rates(
            &self,
            phase: ::assur::problem::Phase<'_, S>,
            instant: &[S],
            state: &[S],
            rates: &mut [S],
        ) {
            ::assur::exact!(state, 2);
            ::assur::exact!(mut rates, 2);
            let phi = state[0];
            let dot_phi = state[1];
            let (sin_phi_, _) = S::sin_cos(phi);
            *rates = [dot_phi, -(self.v8_ * sin_phi_)];
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
            ::assur::exact!(state, 2);
            ::assur::exact!(mut rates, 2);
            let (columns, products) = (
                columns.as_chunks::<2>().0,
                products.as_chunks_mut::<2>().0,
            );
            let phi = state[0];
            let dot_phi = state[1];
            let (sin_phi_, cos_phi_) = S::sin_cos(phi);
            let slope_1_0_ = -(self.v8_ * cos_phi_);
            *rates = [dot_phi, -(self.v8_ * sin_phi_)];
            for (column_, product_) in columns.iter().zip(&mut *products) {
                product_[0] = column_[1];
                product_[1] = slope_1_0_ * column_[0];
            }
        }
        /// 3 operations.
        #[inline(always)]
        fn jacobian(
            &self,
            phase: ::assur::problem::Phase<'_, S>,
            instant: &[S],
            state: &[S],
            columns: &mut [S],
        ) {
            ::assur::exact!(state, 2);
            ::assur::exact!(mut columns, 2 by 2);
            let phi = state[0];
            let (_, cos_phi_) = S::sin_cos(phi);
            columns[0] = [S::ZERO, -(self.v8_ * cos_phi_)];
            columns[1] = [S::ONE, S::ZERO];
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
            let (rows_, _) = rows.as_chunks_mut::<2>();
            let mut memory_0_ = ::assur::series::Sine::default();
            for k_ in 0..rows_.len().saturating_sub(1).min(::assur::series::TERMS) {
                let state = rows_[k_];
                let one_: S = ::assur::series::one(k_);
                let dot_phi = state[1];
                let phi = state[0];
                let (sin_phi_, _) = memory_0_.next(k_, phi);
                let v19_ = self.v8_ * sin_phi_;
                let rate_1_ = -v19_;
                let step_ = length * ::assur::series::inverse(k_ + 1);
                let rates_ = [dot_phi, rate_1_];
                for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                    *next_ = step_ * rate_;
                }
            }
            true
        }
    }
    impl<S: ::assur::scalar::Scalar> ::assur::problem::Reports<S> for SwingEquations<S> {
        /// 6 operations.
        fn outputs(
            &self,
            phase: ::assur::problem::Phase<'_, S>,
            time: S,
            state: &[S],
            values: &mut [S],
        ) {
            ::assur::exact!(state, 2);
            S::outline(
                #[inline(always)]
                || {
                    ::assur::exact!(mut values, 1);
                    let phi = state[0];
                    let dot_phi = state[1];
                    let (_, cos_phi_) = S::sin_cos(phi);
                    let pull = self.m
                        * S::mul_add(self.g, cos_phi_, self.l * (dot_phi * dot_phi));
                    values[0] = pull;
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
                    ::assur::exact!(state, 2, ::core::option::Option::None);
                    let phi = state[0];
                    let dot_phi = state[1];
                    let (_, cos_phi_) = S::sin_cos(phi);
                    ::core::option::Option::Some((
                        self.v12_ * (dot_phi * dot_phi),
                        -(self.v14_ * cos_phi_),
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
                    ::assur::exact!(state, 2, false);
                    ::assur::exact!(mut rows, 1, false);
                    *rows = [self.v11_];
                    true
                },
            )
        }
    }
    /// The first scene of the mechanism, `Swing`.
    pub type Pendulum = Swing;
    mod shapes_ {
        use ::assur::shape::tables::*;
        const unit_0_: Unit = Unit::new("m", 1.0, [1, 0, 0, 0, 0, 0, 0]);
        const unit_1_: Unit = Unit::new("kg", 1.0, [0, 1, 0, 0, 0, 0, 0]);
        const unit_2_: Unit = Unit::new("m/s^2", 1.0, [1, 0, -2, 0, 0, 0, 0]);
        const unit_3_: Unit = Unit::new("N", 1.0, [1, 1, -2, 0, 0, 0, 0]);
        const unit_4_: Unit = Unit::new("rad", 1.0, [0, 0, 0, 0, 0, 0, 0]);
        const unit_5_: Unit = Unit::new("rad/s", 1.0, [0, 0, -1, 0, 0, 0, 0]);
        const constants_: [Constant; 3] = [
            Constant::dimension(
                Quantity::new("l", "Length of the rod.", unit_0_),
                0.001,
                100.0,
            ),
            Constant::parameter(
                Quantity::new("m", "", unit_1_),
                f64::NEG_INFINITY,
                f64::INFINITY,
            ),
            Constant::parameter(
                Quantity::new("g", "", unit_2_),
                f64::NEG_INFINITY,
                f64::INFINITY,
            ),
        ];
        static list_0_: &[Quantity] = &[
            Quantity::new("pull", "Force in the rod.", unit_3_),
        ];
        static list_1_: &[Quantity] = &[
            Quantity::new("phi", "", unit_4_),
            Quantity::new("dot(phi)", "", unit_5_),
        ];
        pub static Swing: Shape = Shape::named("swing")
            .summary("two swings or so")
            .constants(&Constant::some(&constants_, [0, 1, 2], [1.0, 2.0, 9.81]))
            .states(list_1_, &[0.001, 0.001])
            .coordinates(1)
            .outputs(list_0_)
            .equations(
                &[
                    EquationText::new(11, "kinetic m*(l*dot(phi))^2/2", "N m"),
                    EquationText::new(12, "potential -m*g*l*cos(phi)", "N m"),
                ],
            )
            .operations(Operations::of([7, 0, 3, 3, 6, 0, 3, 1, 0]))
            .expectations(
                &[
                    Expectation::new(
                            19,
                            Subject::Output(0),
                            At::Maximum,
                            37.65854,
                            0.0001,
                        )
                        .remark("energy"),
                ],
            );
    }
    /// The mechanism `Pendulum` as data.
    pub static MECHANISM: ::assur::registry::Mechanism = ::assur::registry::Mechanism {
        name: "pendulum",
        title: "Pendulum",
        summary: "A point mass on a massless rod.",
        source: "any textbook",
        file: "",
        text: "",
        parts: &[],
        effects: &[],
        choices: &[],
        presets: &[],
        scenes: &[
            ::assur::registry::SceneEntry {
                shape: &shapes_::Swing,
                bind: ::assur::registry::Bind::Motion(
                    &|values| {
                        ::assur::registry::bind(
                            ::assur::registry::with(values, Swing::from_values)?,
                        )
                    },
                ),
                unreduced: ::core::option::Option::None,
            },
        ],
    };
    #[cfg(test)]
    #[allow(unnameable_test_items)]
    mod tests_ {
        mod swing {
            #[test]
            fn jacobian_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::jacobian(
                    &<super::super::Swing as ::core::default::Default>::default(),
                )
            }
            #[test]
            fn energy_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::energy(
                    &<super::super::Swing as ::core::default::Default>::default(),
                )
            }
            /// The same mechanism stated in mm, g, ms gives the same motion.
            #[test]
            fn scaling_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::scaling(
                    &super::super::MECHANISM,
                    "swing",
                    &|values| {
                        ::core::option::Option::Some(
                            super::super::Swing::from_values(values.try_into().ok()?),
                        )
                    },
                )
            }
            /// `pull, maximum`, pendulum.eqn:19
            #[test]
            fn pull_maximum() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::fact(&super::super::MECHANISM, "swing", 0)
            }
        }
    }
}
#[allow(unused_imports)]
pub use pendulum_::{Swing, SwingEquations, Pendulum, MECHANISM};
