impl<S: ::assur::scalar::Scalar> ::assur::problem::Events<S> for FallEquations<S> {
    fn guards(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        time: S,
        state: &[S],
        values: &mut [S],
        rates: &mut [S],
    ) {
        ::assur::exact!(state, 2);
        match phase.mode {
            0 => {
                S::outline(
                    #[inline(always)]
                    || {
                        ::assur::exact!(mut values, 1);
                        ::assur::exact!(mut rates, 1);
                        let h = state[0];
                        let dot_h = state[1];
                        *values = [h];
                        *rates = [dot_h];
                    },
                )
            }
            1 => {
                S::outline(
                    #[inline(always)]
                    || {
                        ::assur::exact!(mut values, 1);
                        ::assur::exact!(mut rates, 1);
                        let h = state[0];
                        let dot_h = state[1];
                        *values = [h];
                        *rates = [dot_h];
                    },
                )
            }
            _ => {}
        }
    }
    fn jump(
        &self,
        phase: ::assur::problem::Phase<'_, S>,
        event: usize,
        time: S,
        state: &[S],
        after: &mut [S],
    ) {
        ::assur::exact!(state, 2);
        ::assur::exact!(mut after, 2);
        match (phase.mode, event) {
            (0, 0) => {
                S::outline(
                    #[inline(always)]
                    || {
                        let h = state[0];
                        let dot_h = state[1];
                        *after = [h, dot_h];
                    },
                )
            }
            (1, 0) => {
                S::outline(
                    #[inline(always)]
                    || {
                        let h = state[0];
                        let dot_h = state[1];
                        *after = [h, dot_h];
                    },
                )
            }
            _ => after.copy_from_slice(state),
        }
    }
}
/// The first scene of the mechanism, `Fall`.
pub type Ball = Fall;
