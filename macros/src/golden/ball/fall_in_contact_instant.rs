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
::assur::composite! {
    #[doc =
    " Equations of [`Fall`], prepared for a scalar type: those of the mode that it is in."]
    FallEquations, #[doc = " What the equations of [`Fall`] need of one time."]
    FallInstant, states 2, first InFlight in_flight, #[doc = " In the mode `flight`."] 0
    InFlight(FallInFlightInstant) in_flight : FallInFlightEquations, #[doc =
    " In the mode `contact`."] 1 InContact(FallInContactInstant) in_contact :
    FallInContactEquations,
}
/// The first scene of the mechanism, `Fall`.
pub type Ball = Fall;
