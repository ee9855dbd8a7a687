/// Equations of [`Fall`], prepared for a scalar type.
#[derive(Clone, Copy, Debug)]
pub struct FallEquations<S: ::assur::scalar::Scalar> {
    in_flight: FallInFlightEquations<S>,
    in_contact: FallInContactEquations<S>,
}
impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S> for FallEquations<S> {
    #[inline(always)]
    fn states(&self) -> usize {
        2
    }
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
        match phase.mode {
            0 => {
                let own_ = &self.in_flight;
                let dot_h = state[1];
                *rates = [dot_h, own_.rate_1_];
            }
            1 => {
                let own_ = &self.in_contact;
                let h = state[0];
                let dot_h = state[1];
                *rates = [dot_h, own_.v4_ * S::mul_add(-own_.k, h, own_.v7_)];
            }
            _ => {}
        }
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
        match phase.mode {
            0 => {
                let own_ = &self.in_flight;
                let dot_h = state[1];
                *rates = [dot_h, own_.rate_1_];
                for (column_, product_) in columns.iter().zip(&mut *products) {
                    product_[0] = column_[1];
                    product_[1] = S::ZERO;
                }
            }
            1 => {
                let own_ = &self.in_contact;
                let h = state[0];
                let dot_h = state[1];
                *rates = [dot_h, own_.v4_ * S::mul_add(-own_.k, h, own_.v7_)];
                for (column_, product_) in columns.iter().zip(&mut *products) {
                    product_[0] = column_[1];
                    product_[1] = own_.slope_1_0_ * column_[0];
                }
            }
            _ => {}
        }
    }
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
        match phase.mode {
            0 => {
                columns[0] = [S::ZERO, S::ZERO];
                columns[1] = [S::ONE, S::ZERO];
            }
            1 => {
                let own_ = &self.in_contact;
                columns[0] = [S::ZERO, own_.slope_1_0_];
                columns[1] = [S::ONE, S::ZERO];
            }
            _ => {}
        }
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
        match phase.mode {
            0 => {
                let own_ = &self.in_flight;
                S::outline(
                    #[inline(always)]
                    || {
                        let (rows_, _) = rows.as_chunks_mut::<2>();
                        for k_ in 0..rows_
                            .len()
                            .saturating_sub(1)
                            .min(::assur::series::TERMS)
                        {
                            let state = rows_[k_];
                            let one_: S = ::assur::series::one(k_);
                            let dot_h = state[1];
                            let step_ = length * ::assur::series::inverse(k_ + 1);
                            let rates_ = [dot_h, one_ * own_.rate_1_];
                            for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                                *next_ = step_ * rate_;
                            }
                        }
                        true
                    },
                )
            }
            1 => {
                let own_ = &self.in_contact;
                S::outline(
                    #[inline(always)]
                    || {
                        let (rows_, _) = rows.as_chunks_mut::<2>();
                        for k_ in 0..rows_
                            .len()
                            .saturating_sub(1)
                            .min(::assur::series::TERMS)
                        {
                            let state = rows_[k_];
                            let one_: S = ::assur::series::one(k_);
                            let dot_h = state[1];
                            let h = state[0];
                            let v13_ = one_ * own_.v7_ - own_.k * h;
                            let rate_1_ = own_.v4_ * v13_;
                            let step_ = length * ::assur::series::inverse(k_ + 1);
                            let rates_ = [dot_h, rate_1_];
                            for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                                *next_ = step_ * rate_;
                            }
                        }
                        true
                    },
                )
            }
            _ => false,
        }
    }
}
