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
                let ::core::option::Option::Some(values) = values.first_chunk_mut::<1>()
                else { return };
                ::core::debug_assert!(rates.len() >= 1);
                let ::core::option::Option::Some(rates) = rates.first_chunk_mut::<1>()
                else { return };
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
