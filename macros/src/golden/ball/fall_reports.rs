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
                let own_ = &self.in_contact;
                S::outline(
                    #[inline(always)]
                    || {
                        ::assur::exact!(mut values, 1);
                        let h = state[0];
                        let force = own_.M
                            * S::mul_add(
                                own_.v4_,
                                S::mul_add(-own_.k, h, own_.v7_),
                                own_.g,
                            );
                        values[0] = force;
                    },
                )
            }
            _ => {}
        }
    }
}
