//! The hand-written equations as a scene for Assur's steppers: what a stepper costs without the emitted code.

use assur::ode::Explicit;
use assur::problem::{Equations, Phase, Refused, Reports, Scene, Span};
use assur::scalar::Scalar;
use assur::shape::{Quantity, Shape, Unit};

use crate::hand::{Batten, Instant, WIDTH};
use crate::hand_loop::Run;
use crate::revolutions::{self, SCALE, START};

/// The scene; its values are those of `Batten`.
#[derive(Clone, Copy, Debug)]
pub struct HandBatten;

impl<S: Scalar> Equations<S> for Batten {
    #[inline(always)]
    fn states(&self) -> usize {
        6
    }

    #[inline(always)]
    fn instant(&self) -> usize {
        WIDTH
    }

    #[inline(always)]
    fn instants(&self, _phase: Phase<'_, S>, times: &[S], rows: &mut [S]) {
        let (rows, _) = rows.as_chunks_mut::<WIDTH>();
        for (times, rows) in times.chunks(4).zip(rows.chunks_mut(4)) {
            let mut four = [S::ZERO; 4];
            for (k, time) in four.iter_mut().enumerate() {
                *time = times[k.min(times.len() - 1)];
            }
            let instants = Batten::instants(self, four);
            for (row, at) in rows.iter_mut().zip(&instants) {
                *row = at.row();
            }
        }
    }

    #[inline(always)]
    fn rates(&self, _phase: Phase<'_, S>, instant: &[S], state: &[S], rates: &mut [S]) {
        let (Some(row), Some(y), Some(rate)) =
            (instant.first_chunk(), state.first_chunk(), rates.first_chunk_mut())
        else {
            return;
        };
        self.derivative(&Instant::of(row), y, rate);
    }

    fn variation(
        &self,
        phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        self.rates(phase, instant, state, rates);
        let mut slopes = [[S::ZERO; 6]; 6];
        Equations::jacobian(self, phase, instant, state, slopes.as_flattened_mut());
        for (column, product) in columns.chunks(6).zip(products.chunks_mut(6)) {
            for (row, product) in product.iter_mut().enumerate() {
                let terms = column.iter().zip(&slopes);
                *product = terms.fold(S::ZERO, |sum, (part, slope)| slope[row].mul_add(*part, sum));
            }
        }
    }

    fn jacobian(&self, _phase: Phase<'_, S>, instant: &[S], _state: &[S], columns: &mut [S]) {
        let mut slopes = [[S::ZERO; 6]; 6];
        if let Some(row) = instant.first_chunk() {
            Batten::jacobian(self, &Instant::of(row), &mut slopes);
        }
        columns.copy_from_slice(slopes.as_flattened());
    }
}

impl<S: Scalar> Reports<S> for Batten {}

impl Scene for HandBatten {
    type Equations<S: Scalar> = Batten;

    type Unreduced = Self;
    const SMOOTH: bool = true;

    fn shape(&self) -> &'static Shape {
        const STATES: &[Quantity] = &[Quantity::new("y", "", Unit::NONE); 6];
        const { &Shape::named("batten").states(STATES, &[SCALE; 6]) }
    }

    fn prepare<S: Scalar>(&self) -> Batten {
        Batten::default()
    }

    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }

    fn span(&self) -> Span {
        Span::Open
    }

    fn start(&self) -> Vec<f64> {
        START.to_vec()
    }
}

/// Ten revolutions of the hand-written equations with a stepper of Assur.
#[inline(never)]
pub fn run(method: Explicit, rtol: f64) -> Run {
    revolutions::stepped(&HandBatten, method, rtol)
}
