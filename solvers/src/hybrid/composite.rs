//! The equations of a scene out of those of its modes.

/// The equations of a scene that is in one of several modes, and what they need of one time: each method goes on to the
/// equations of the mode. Emitted code states the modes; with `cyclic` before all else they know how their events depend
/// on the state.
#[doc(hidden)]
#[macro_export]
macro_rules! composite {
    (cyclic $($all:tt)*) => {
        $crate::composite! { $($all)* }
        $crate::composite! { @slopes $($all)* }
    };

    (
        $(#[$text:meta])*
        $name:ident,
        $(#[$other:meta])*
        $instant:ident,
        states $states:literal,
        first $begin:ident $first:ident,
        $($(#[$said:meta])* $number:literal $variant:ident($of:ident) $field:ident: $equations:ident,)*
    ) => {
        $(#[$text])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name<S: $crate::scalar::Scalar> {
            mode_: usize,
            $($field: $equations<S>,)*
        }

        $(#[$other])*
        #[derive(Clone, Copy, Debug)]
        pub enum $instant<S: $crate::scalar::Scalar> {
            $($(#[$said])* $variant($of<S>),)*
        }

        impl<S: $crate::scalar::Scalar> $crate::problem::Equations<S> for $name<S> {
            type State = [S; $states];
            type Instant = $instant<S>;

            #[inline(always)]
            fn states(&self) -> usize {
                $states
            }

            #[inline(always)]
            fn instant(&self, time: S) -> Self::Instant {
                match self.mode_ {
                    $($number => $instant::$variant(self.$field.instant(time)),)*
                    _ => $instant::$begin(self.$first.instant(time)),
                }
            }

            #[inline(always)]
            fn instants<const K: usize>(&self, times: [S; K]) -> [Self::Instant; K] {
                match self.mode_ {
                    $($number => {
                        let instants = self.$field.instants(times);
                        ::core::array::from_fn(|k| $instant::$variant(instants[k]))
                    })*
                    _ => self.$first.instants(times).map($instant::$begin),
                }
            }

            #[inline(always)]
            fn derivative(&self, instant: &Self::Instant, state: &Self::State, rate: &mut Self::State) {
                match instant {
                    $($instant::$variant(instant) => self.$field.derivative(instant, state, rate),)*
                }
            }

            #[inline(always)]
            fn sweep(&self, times: &[S], stages: &mut dyn $crate::problem::Stages<S>) -> bool {
                match self.mode_ {
                    $($number => self.$field.sweep(times, stages),)*
                    _ => false,
                }
            }

            #[inline(always)]
            fn series(&self, time: S, length: S, rows: &mut [S]) -> bool {
                match self.mode_ {
                    $($number => self.$field.series(time, length, rows),)*
                    _ => false,
                }
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
                match instant {
                    $($instant::$variant(instant) => {
                        self.$field.variation(instant, state, rate, columns, products)
                    })*
                }
            }

            #[inline(always)]
            fn jacobian(&self, instant: &Self::Instant, state: &Self::State, columns: &mut [Self::State]) {
                match instant {
                    $($instant::$variant(instant) => self.$field.jacobian(instant, state, columns),)*
                }
            }

            #[inline(always)]
            fn outputs(&self, time: S, state: &Self::State, values: &mut [S]) {
                match self.mode_ {
                    $($number => self.$field.outputs(time, state, values),)*
                    _ => {}
                }
            }

            #[inline(always)]
            fn drivers(&self, time: S, values: &mut [S]) {
                match self.mode_ {
                    $($number => self.$field.drivers(time, values),)*
                    _ => {}
                }
            }

            #[inline(always)]
            fn margins(&self, time: S, values: &mut [S]) {
                self.$first.margins(time, values);
            }

            #[inline(always)]
            fn measured(&self, time: S, state: &Self::State, values: &mut [S]) {
                match self.mode_ {
                    $($number => self.$field.measured(time, state, values),)*
                    _ => {}
                }
            }

            #[inline(always)]
            fn measures(&self, found: &[S], values: &mut [S]) {
                self.$first.measures(found, values);
            }
        }

        impl<S: $crate::scalar::Scalar> $crate::hybrid::Modes<S> for $name<S> {
            #[inline(always)]
            fn mode(&self) -> usize {
                self.mode_
            }

            #[inline(always)]
            fn enter(&mut self, mode: usize) {
                self.mode_ = mode;
            }

            #[inline(always)]
            fn side(&mut self, surface: usize, side: S) {
                match self.mode_ {
                    $($number => $crate::hybrid::InMode::side(&mut self.$field, surface, side),)*
                    _ => {}
                }
            }

            #[inline(always)]
            fn guards(&self, instant: &Self::Instant, state: &Self::State, values: &mut [S], rates: &mut [S]) {
                match instant {
                    $($instant::$variant(instant) => $crate::hybrid::InMode::guards(&self.$field, instant, state, values, rates),)*
                }
            }

            #[inline(always)]
            fn look(&self, time: S, state: &Self::State, values: &mut [S], rates: &mut [S]) {
                match self.mode_ {
                    $($number => {
                        let instant = $crate::problem::Equations::instant(&self.$field, time);
                        $crate::hybrid::InMode::guards(&self.$field, &instant, state, values, rates)
                    })*
                    _ => {}
                }
            }

            #[inline(always)]
            fn permits(&self, event: usize, instant: &Self::Instant, state: &Self::State) -> bool {
                match instant {
                    $($instant::$variant(instant) => $crate::hybrid::InMode::permits(&self.$field, event, instant, state),)*
                }
            }

            #[inline(always)]
            fn jump(&self, event: usize, instant: &Self::Instant, state: &Self::State, after: &mut Self::State) {
                match instant {
                    $($instant::$variant(instant) => $crate::hybrid::InMode::jump(&self.$field, event, instant, state, after),)*
                }
            }
        }
    };

    (
        @slopes
        $(#[$text:meta])*
        $name:ident,
        $(#[$other:meta])*
        $instant:ident,
        states $states:literal,
        first $begin:ident $first:ident,
        $($(#[$said:meta])* $number:literal $variant:ident($of:ident) $field:ident: $equations:ident,)*
    ) => {
        impl<S: $crate::scalar::Scalar> $crate::hybrid::Sensitive<S> for $name<S> {
            fn guard_slopes(&self, event: usize, instant: &Self::Instant, state: &Self::State, slopes: &mut Self::State) {
                match instant {
                    $($instant::$variant(instant) => $crate::hybrid::InMode::guard_slopes(&self.$field, event, instant, state, slopes),)*
                }
            }

            fn jump_slopes(
                &self,
                event: usize,
                instant: &Self::Instant,
                state: &Self::State,
                columns: &mut [Self::State],
                rate: &mut Self::State,
            ) -> bool {
                match instant {
                    $($instant::$variant(instant) => $crate::hybrid::InMode::jump_slopes(&self.$field, event, instant, state, columns, rate),)*
                }
            }
        }
    };
}
