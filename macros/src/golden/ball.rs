/// A ball that falls onto a soft floor and comes back.
///
/// Source: any textbook.
///
/// Printed from `ball.eqn` by Assur.
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
mod ball_ {
    /// A ball that falls onto a soft floor and comes back.
    ///
    /// Scene `fall`.
    ///
    /// ```text
    /// motion M*ddot(h) = -M*g   [N]  ball.eqn:11
    /// ```
    ///
    /// Parameters:
    ///
    /// | name | value |  |  |
    /// |---|---|---|---|
    /// | `M` | `1 kg` |  |  |
    /// | `g` | `9.81 m/s^2` |  |  |
    /// | `k` | `10000 N/m` |  | Stiffness of the floor. |
    ///
    /// State:
    ///
    /// | name | unit |  |
    /// |---|---|---|
    /// | `h` | `m` |  |
    /// | `dot(h)` | `m/s` |  |
    ///
    /// Outputs:
    ///
    /// | name | unit |  |
    /// |---|---|---|
    /// | `force` | `N` |  |
    ///
    /// Operations: 1 once per parameter set, 0 per instant, 0 per evaluation, 0 per Jacobian.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Fall {
        /// Parameter: `1 kg`.
        pub M: f64,
        /// Parameter: `9.81 m/s^2`.
        pub g: f64,
        /// Stiffness of the floor: `10000 N/m`.
        pub k: f64,
    }
    impl ::core::default::Default for Fall {
        fn default() -> Self {
            Self::from_values(&shapes_::Fall.defaults())
        }
    }
    impl Fall {
        /// Sets all values, SI units, in the order of the fields.
        pub fn from_values(values: &[f64; 3]) -> Self {
            Self {
                M: values[0],
                g: values[1],
                k: values[2],
            }
        }
        /// All values, SI units, in the order of the fields.
        pub fn values(&self) -> [f64; 3] {
            [self.M, self.g, self.k]
        }
        /// The period, or the first and the last time.
        fn span_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
            [S::ZERO, S::from_f64(2.0)]
        }
        /// The declared start values of the state.
        fn start_<S: ::assur::scalar::Scalar>(&self) -> [S; 2] {
            [S::ONE, S::ZERO]
        }
    }
    impl ::assur::problem::Scene for Fall {
        type Equations<S: ::assur::scalar::Scalar> = FallEquations<S>;
        fn shape() -> &'static ::assur::shape::Shape {
            &shapes_::Fall
        }
        #[inline(always)]
        fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
            FallEquations {
                mode_: 0,
                in_flight: self.prepare_in_flight_(),
                in_contact: self.prepare_in_contact_(),
            }
        }
        fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
            ::assur::registry::check_values(shapes_::Fall.constants, &self.values())?;
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
    impl Fall {
        #[inline(always)]
        fn prepare_in_flight_<S: ::assur::scalar::Scalar>(
            &self,
        ) -> FallInFlightEquations<S> {
            S::outline(
                #[inline(always)]
                || {
                    let g = <S as ::assur::scalar::Scalar>::from_f64(self.g);
                    FallInFlightEquations {
                        rate_1_: -g,
                    }
                },
            )
        }
        #[inline(always)]
        fn prepare_in_contact_<S: ::assur::scalar::Scalar>(
            &self,
        ) -> FallInContactEquations<S> {
            S::outline(
                #[inline(always)]
                || {
                    let M = <S as ::assur::scalar::Scalar>::from_f64(self.M);
                    let v4_ = S::ONE / M;
                    let g = <S as ::assur::scalar::Scalar>::from_f64(self.g);
                    let k = <S as ::assur::scalar::Scalar>::from_f64(self.k);
                    FallInContactEquations {
                        M,
                        v4_,
                        g,
                        v7_: -(M * g),
                        k,
                        slope_1_0_: -(k * v4_),
                    }
                },
            )
        }
    }
    impl ::assur::hybrid::Hybrid for Fall {
        type Modal<S: ::assur::scalar::Scalar> = FallEquations<S>;
        fn modal<S: ::assur::scalar::Scalar>(&self) -> Self::Modal<S> {
            <Self as ::assur::problem::Scene>::prepare(self)
        }
    }
    /// Equations of [`Fall`], prepared for a scalar type.
    #[derive(Clone, Copy, Debug)]
    pub struct FallInFlightEquations<S: ::assur::scalar::Scalar> {
        /// `-g`
        rate_1_: S,
    }
    impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S>
    for FallInFlightEquations<S> {
        type State = [S; 2];
        type Instant = FallInFlightInstant<S>;
        #[inline(always)]
        fn states(&self) -> usize {
            2
        }
        /// 0 operations.
        #[inline(always)]
        fn instant(&self, time: S) -> Self::Instant {
            S::outline(
                #[inline(always)]
                || {
                    FallInFlightInstant {
                        scalar_: ::core::marker::PhantomData,
                    }
                },
            )
        }
        #[inline(always)]
        fn instants<const K_: usize>(&self, times: [S; K_]) -> [Self::Instant; K_] {
            S::outline(
                #[inline(always)]
                || {
                    [FallInFlightInstant {
                        scalar_: ::core::marker::PhantomData,
                    }; K_]
                },
            )
        }
        /// 0 operations.
        #[inline(always)]
        fn derivative(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            rate: &mut Self::State,
        ) {
            S::outline(
                #[inline(always)]
                || {
                    let dot_h = state[1];
                    *rate = [dot_h, self.rate_1_];
                },
            )
        }
        #[inline(never)]
        fn series(&self, time: S, length: S, rows: &mut [S]) -> bool {
            if !S::SINGLE {
                return false;
            }
            let (rows_, _) = rows.as_chunks_mut::<2>();
            for k_ in 0..rows_.len().saturating_sub(1).min(::assur::series::TERMS) {
                let state = rows_[k_];
                let one_: S = ::assur::series::one(k_);
                let dot_h = state[1];
                let step_ = length * ::assur::series::inverse(k_ + 1);
                let rates_ = [dot_h, one_ * self.rate_1_];
                for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                    *next_ = step_ * rate_;
                }
            }
            true
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
            S::outline(
                #[inline(always)]
                || {
                    let dot_h = state[1];
                    *rate = [dot_h, self.rate_1_];
                    for (column_, product_) in columns.iter().zip(products.iter_mut()) {
                        product_[0] = column_[1];
                        product_[1] = S::ZERO;
                    }
                },
            )
        }
        /// 0 operations.
        #[inline(always)]
        fn jacobian(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            columns: &mut [Self::State],
        ) {
            S::outline(
                #[inline(always)]
                || {
                    ::core::debug_assert!(columns.len() >= 2);
                    let ::core::option::Option::Some(columns) = columns
                        .first_chunk_mut::<2>() else { return };
                    columns[0] = [S::ZERO, S::ZERO];
                    columns[1] = [S::ONE, S::ZERO];
                },
            )
        }
        /// 0 operations.
        #[inline(always)]
        fn outputs(&self, time: S, state: &Self::State, values: &mut [S]) {
            S::outline(
                #[inline(always)]
                || {
                    ::core::debug_assert!(values.len() >= 1);
                    let ::core::option::Option::Some(values) = values
                        .first_chunk_mut::<1>() else { return };
                    values[0] = S::ZERO;
                },
            )
        }
    }
    /// What the equations of [`Fall`] need of one time.
    #[derive(Clone, Copy, Debug)]
    pub struct FallInFlightInstant<S: ::assur::scalar::Scalar> {
        scalar_: ::core::marker::PhantomData<S>,
    }
    impl<S: ::assur::scalar::Scalar> ::assur::hybrid::InMode<S>
    for FallInFlightEquations<S> {
        #[inline(always)]
        fn guards(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            values: &mut [S],
            rates: &mut [S],
        ) {
            S::outline(
                #[inline(always)]
                || {
                    ::core::debug_assert!(values.len() >= 1);
                    let ::core::option::Option::Some(values) = values
                        .first_chunk_mut::<1>() else { return };
                    ::core::debug_assert!(rates.len() >= 1);
                    let ::core::option::Option::Some(rates) = rates
                        .first_chunk_mut::<1>() else { return };
                    let h = state[0];
                    let dot_h = state[1];
                    values[0] = h;
                    rates[0] = dot_h;
                },
            )
        }
        #[inline(always)]
        fn jump(
            &self,
            event: usize,
            instant: &Self::Instant,
            state: &Self::State,
            after: &mut Self::State,
        ) {
            S::outline(
                #[inline(always)]
                || {
                    match event {
                        0 => {
                            let h = state[0];
                            let dot_h = state[1];
                            *after = [h, dot_h];
                        }
                        _ => *after = *state,
                    }
                },
            )
        }
    }
    /// Equations of [`Fall`], prepared for a scalar type.
    #[derive(Clone, Copy, Debug)]
    pub struct FallInContactEquations<S: ::assur::scalar::Scalar> {
        M: S,
        /// `1/M`
        v4_: S,
        g: S,
        /// `-M*g`
        v7_: S,
        k: S,
        /// Jacobian, rate of `dot(h)` by `h`: `-k*v4_`
        slope_1_0_: S,
    }
    impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S>
    for FallInContactEquations<S> {
        type State = [S; 2];
        type Instant = FallInContactInstant<S>;
        #[inline(always)]
        fn states(&self) -> usize {
            2
        }
        /// 0 operations.
        #[inline(always)]
        fn instant(&self, time: S) -> Self::Instant {
            S::outline(
                #[inline(always)]
                || {
                    FallInContactInstant {
                        scalar_: ::core::marker::PhantomData,
                    }
                },
            )
        }
        #[inline(always)]
        fn instants<const K_: usize>(&self, times: [S; K_]) -> [Self::Instant; K_] {
            S::outline(
                #[inline(always)]
                || {
                    [FallInContactInstant {
                        scalar_: ::core::marker::PhantomData,
                    }; K_]
                },
            )
        }
        /// 3 operations.
        #[inline(always)]
        fn derivative(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            rate: &mut Self::State,
        ) {
            S::outline(
                #[inline(always)]
                || {
                    let h = state[0];
                    let dot_h = state[1];
                    *rate = [dot_h, self.v4_ * S::mul_add(-self.k, h, self.v7_)];
                },
            )
        }
        #[inline(never)]
        fn series(&self, time: S, length: S, rows: &mut [S]) -> bool {
            if !S::SINGLE {
                return false;
            }
            let (rows_, _) = rows.as_chunks_mut::<2>();
            for k_ in 0..rows_.len().saturating_sub(1).min(::assur::series::TERMS) {
                let state = rows_[k_];
                let one_: S = ::assur::series::one(k_);
                let dot_h = state[1];
                let h = state[0];
                let v13_ = one_ * self.v7_ - self.k * h;
                let rate_1_ = self.v4_ * v13_;
                let step_ = length * ::assur::series::inverse(k_ + 1);
                let rates_ = [dot_h, rate_1_];
                for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                    *next_ = step_ * rate_;
                }
            }
            true
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
            S::outline(
                #[inline(always)]
                || {
                    let h = state[0];
                    let dot_h = state[1];
                    *rate = [dot_h, self.v4_ * S::mul_add(-self.k, h, self.v7_)];
                    for (column_, product_) in columns.iter().zip(products.iter_mut()) {
                        product_[0] = column_[1];
                        product_[1] = self.slope_1_0_ * column_[0];
                    }
                },
            )
        }
        /// 0 operations.
        #[inline(always)]
        fn jacobian(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            columns: &mut [Self::State],
        ) {
            S::outline(
                #[inline(always)]
                || {
                    ::core::debug_assert!(columns.len() >= 2);
                    let ::core::option::Option::Some(columns) = columns
                        .first_chunk_mut::<2>() else { return };
                    columns[0] = [S::ZERO, self.slope_1_0_];
                    columns[1] = [S::ONE, S::ZERO];
                },
            )
        }
        /// 5 operations.
        #[inline(always)]
        fn outputs(&self, time: S, state: &Self::State, values: &mut [S]) {
            S::outline(
                #[inline(always)]
                || {
                    ::core::debug_assert!(values.len() >= 1);
                    let ::core::option::Option::Some(values) = values
                        .first_chunk_mut::<1>() else { return };
                    let h = state[0];
                    let force = self.M
                        * S::mul_add(self.v4_, S::mul_add(-self.k, h, self.v7_), self.g);
                    values[0] = force;
                },
            )
        }
    }
    /// What the equations of [`Fall`] need of one time.
    #[derive(Clone, Copy, Debug)]
    pub struct FallInContactInstant<S: ::assur::scalar::Scalar> {
        scalar_: ::core::marker::PhantomData<S>,
    }
    impl<S: ::assur::scalar::Scalar> ::assur::hybrid::InMode<S>
    for FallInContactEquations<S> {
        #[inline(always)]
        fn guards(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            values: &mut [S],
            rates: &mut [S],
        ) {
            S::outline(
                #[inline(always)]
                || {
                    ::core::debug_assert!(values.len() >= 1);
                    let ::core::option::Option::Some(values) = values
                        .first_chunk_mut::<1>() else { return };
                    ::core::debug_assert!(rates.len() >= 1);
                    let ::core::option::Option::Some(rates) = rates
                        .first_chunk_mut::<1>() else { return };
                    let h = state[0];
                    let dot_h = state[1];
                    values[0] = h;
                    rates[0] = dot_h;
                },
            )
        }
        #[inline(always)]
        fn jump(
            &self,
            event: usize,
            instant: &Self::Instant,
            state: &Self::State,
            after: &mut Self::State,
        ) {
            S::outline(
                #[inline(always)]
                || {
                    match event {
                        0 => {
                            let h = state[0];
                            let dot_h = state[1];
                            *after = [h, dot_h];
                        }
                        _ => *after = *state,
                    }
                },
            )
        }
    }
    ::assur::composite! {
        #[doc =
        " Equations of [`Fall`], prepared for a scalar type: those of the mode that it is in."]
        FallEquations, #[doc = " What the equations of [`Fall`] need of one time."]
        FallInstant, states 2, first InFlight in_flight, #[doc =
        " In the mode `flight`."] 0 InFlight(FallInFlightInstant) in_flight :
        FallInFlightEquations, #[doc = " In the mode `contact`."] 1
        InContact(FallInContactInstant) in_contact : FallInContactEquations,
    }
    /// The first scene of the mechanism, `Fall`.
    pub type Ball = Fall;
    mod shapes_ {
        use ::assur::shape::tables::*;
        const unit_0_: Unit = Unit::new("kg", 1.0, [0, 1, 0, 0, 0, 0, 0]);
        const unit_1_: Unit = Unit::new("m/s^2", 1.0, [1, 0, -2, 0, 0, 0, 0]);
        const unit_2_: Unit = Unit::new("N/m", 1.0, [0, 1, -2, 0, 0, 0, 0]);
        const unit_3_: Unit = Unit::new("N", 1.0, [1, 1, -2, 0, 0, 0, 0]);
        const unit_4_: Unit = Unit::new("m", 1.0, [1, 0, 0, 0, 0, 0, 0]);
        const unit_5_: Unit = Unit::new("m/s", 1.0, [1, 0, -1, 0, 0, 0, 0]);
        const constants_: [Constant; 3] = [
            Constant::parameter(
                Quantity::new("M", "", unit_0_),
                f64::NEG_INFINITY,
                f64::INFINITY,
            ),
            Constant::parameter(
                Quantity::new("g", "", unit_1_),
                f64::NEG_INFINITY,
                f64::INFINITY,
            ),
            Constant::parameter(
                Quantity::new("k", "Stiffness of the floor.", unit_2_),
                f64::NEG_INFINITY,
                f64::INFINITY,
            ),
        ];
        static list_0_: &[Quantity] = &[Quantity::new("force", "", unit_3_)];
        static list_1_: &[Quantity] = &[
            Quantity::new("h", "", unit_4_),
            Quantity::new("dot(h)", "", unit_5_),
        ];
        pub static Fall: Shape = Shape::named("fall")
            .constants(&Constant::some(&constants_, [0, 1, 2], [1.0, 9.81, 10000.0]))
            .states(list_1_, &[0.001, 0.001])
            .outputs(list_0_)
            .equations(&[EquationText::new(11, "motion M*ddot(h) = -M*g", "N")])
            .operations(Operations::of([1, 0, 0, 0, 0]))
            .modes(
                &[
                    ModeEntry::new(
                        "flight",
                        "above the floor",
                        &[
                            EventEntry::new(
                                    12,
                                    "when h falls -> contact",
                                    Direction::Falls,
                                    "m",
                                    1.0,
                                    1,
                                )
                                .sets(),
                        ],
                    ),
                    ModeEntry::new(
                        "contact",
                        "on the floor",
                        &[
                            EventEntry::new(
                                    16,
                                    "when h rises -> flight",
                                    Direction::Rises,
                                    "m",
                                    1.0,
                                    0,
                                )
                                .sets(),
                        ],
                    ),
                ],
                0,
            );
    }
    /// The mechanism `Ball` as data.
    pub static MECHANISM: ::assur::registry::Mechanism = ::assur::registry::Mechanism {
        name: "ball",
        title: "Ball",
        summary: "A ball that falls onto a soft floor and comes back.",
        source: "any textbook",
        file: "",
        text: "",
        parts: &[],
        effects: &[],
        choices: &[],
        presets: &[],
        scenes: &[
            ::assur::registry::SceneEntry {
                shape: &shapes_::Fall,
                bind: ::assur::registry::Bind::Motion(|values| {
                    ::assur::registry::bind_hybrid(
                        ::assur::registry::with(values, Fall::from_values)?,
                    )
                }),
            },
        ],
    };
    #[cfg(test)]
    #[allow(unnameable_test_items)]
    mod tests_ {
        mod fall {
            #[test]
            fn jacobian_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::jacobian::<super::super::Fall>()
            }
            /// The same mechanism stated in mm, g, ms gives the same motion.
            #[test]
            fn scaling_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::scaling(
                    &super::super::MECHANISM,
                    "fall",
                    super::super::Fall::from_values,
                )
            }
        }
    }
}
#[allow(unused_imports)]
pub use ball_::{Fall, FallEquations, FallInstant, Ball, MECHANISM};
