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
                let ::core::option::Option::Some(values) = values.first_chunk_mut::<1>()
                else { return };
                values[0] = S::ZERO;
            },
        )
    }
}
