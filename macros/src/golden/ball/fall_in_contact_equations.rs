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
                let ::core::option::Option::Some(values) = values.first_chunk_mut::<1>()
                else { return };
                let h = state[0];
                let force = self.M
                    * S::mul_add(self.v4_, S::mul_add(-self.k, h, self.v7_), self.g);
                values[0] = force;
            },
        )
    }
}
