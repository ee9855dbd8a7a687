impl<S: ::assur::scalar::Scalar> ::assur::problem::Reports<S> for FallEquations<S> {
    fn outputs(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        time: S,
        state: &[S],
        values: &mut [S],
    ) {
        ::assur::exact!(state, 2);
        match phase.mode {
            0 => {
                S::outline(
                    #[inline(always)]
                    || {
                        ::assur::exact!(mut values, 1);
                        values[0] = S::ZERO;
                    },
                )
            }
            1 => {
                S::outline(
                    #[inline(always)]
                    || {
                        ::assur::exact!(mut values, 1);
                        let h = state[0];
                        let force = self.in_contact.M
                            * S::mul_add(
                                self.in_contact.v4_,
                                S::mul_add(-self.in_contact.k, h, self.in_contact.v7_),
                                self.in_contact.g,
                            );
                        values[0] = force;
                    },
                )
            }
            _ => {}
        }
    }
}
