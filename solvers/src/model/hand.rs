//! Models that tests write by hand.

use super::Model;
use crate::problem::{Equations, Phase, Reports, Span};
use crate::scalar::Scalar;
use crate::shape::{List, Quantity, Shape, Unit};

/// Writes the products of a Jacobian, column by column, with columns.
pub(crate) fn multiply<S: Scalar>(jacobian: &[S], columns: &[S], products: &mut [S]) {
    let states = jacobian.len().isqrt();
    for (place, product) in products.iter_mut().enumerate() {
        let (row, column) = (place % states, place / states);
        let terms = (0..states).map(|j| jacobian[j * states + row] * columns[column * states + j]);
        *product = terms.fold(S::ZERO, |sum, term| sum + term);
    }
}

/// A model of a few functions: of the time and the state the rates and the rows of their Jacobian, and as
/// [`Equations::series`] the Taylor series. It starts at zero unless told otherwise; all states have the scale 1.
#[derive(Clone, Copy)]
pub(crate) struct Hand<
    const N: usize,
    R = fn(f64, [f64; N]) -> [f64; N],
    J = fn(f64, [f64; N]) -> [[f64; N]; N],
    T = fn(f64, f64, &mut [f64]) -> bool,
> {
    rates: R,
    rows: J,
    series: T,
    start: [f64; N],
}

impl<const N: usize, R, J> Hand<N, R, J>
where
    R: Fn(f64, [f64; N]) -> [f64; N] + Copy,
    J: Fn(f64, [f64; N]) -> [[f64; N]; N] + Copy,
{
    /// Rates and the rows of their Jacobian, without a Taylor series.
    pub const fn new(rates: R, rows: J) -> Self {
        Self { rates, rows, series: |_, _, _| false, start: [0.0; N] }
    }

    /// With this start.
    pub fn starting(self, start: [f64; N]) -> Self {
        Self { start, ..self }
    }

    /// With a Taylor series.
    pub fn expanded<T: Fn(f64, f64, &mut [f64]) -> bool>(self, series: T) -> Hand<N, R, J, T> {
        Hand { rates: self.rates, rows: self.rows, series, start: self.start }
    }
}

impl<const N: usize, R: Fn(f64, [f64; N]) -> [f64; N] + Copy> Hand<N, R> {
    /// Rates alone: what asks for their Jacobian gets NaN.
    pub const fn without_jacobian(rates: R) -> Self {
        Self::new(rates, |_, _| [[f64::NAN; N]; N])
    }
}

/// A state of a hand-written model.
fn fixed<const N: usize>(state: &[f64]) -> [f64; N] {
    std::array::from_fn(|index| state[index])
}

impl<const N: usize, R, J, T> Equations<f64> for Hand<N, R, J, T>
where
    R: Fn(f64, [f64; N]) -> [f64; N] + Send + Sync,
    J: Fn(f64, [f64; N]) -> [[f64; N]; N] + Send + Sync,
    T: Fn(f64, f64, &mut [f64]) -> bool + Send + Sync,
{
    fn states(&self) -> usize {
        N
    }

    fn instant(&self) -> usize {
        1
    }

    fn instants(&self, _phase: Phase<'_, f64>, times: &[f64], rows: &mut [f64]) {
        rows.copy_from_slice(times);
    }

    fn rates(&self, _phase: Phase<'_, f64>, instant: &[f64], state: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&(self.rates)(instant[0], fixed(state)));
    }

    fn variation(
        &self,
        phase: Phase<'_, f64>,
        instant: &[f64],
        state: &[f64],
        rates: &mut [f64],
        columns: &[f64],
        products: &mut [f64],
    ) {
        let mut slopes = [[0.0; N]; N];
        self.rates(phase, instant, state, rates);
        self.jacobian(phase, instant, state, slopes.as_flattened_mut());
        multiply(slopes.as_flattened(), columns, products);
    }

    fn jacobian(&self, _: Phase<'_, f64>, instant: &[f64], state: &[f64], columns: &mut [f64]) {
        let rows = (self.rows)(instant[0], fixed(state));
        for (place, slope) in columns.iter_mut().enumerate() {
            *slope = rows[place % N][place / N];
        }
    }

    fn series(&self, _phase: Phase<'_, f64>, time: f64, length: f64, rows: &mut [f64]) -> bool {
        (self.series)(time, length, rows)
    }
}

impl<const N: usize, R, J, T> Reports<f64> for Hand<N, R, J, T> where Self: Send + Sync {}

impl<const N: usize, R, J, T> Hand<N, R, J, T> {
    const STATES: List<Quantity> = &[Quantity::new("y", "", Unit::NONE); N];
    const SCALES: List<f64> = &[1.0; N];
}

impl<const N: usize, R, J, T> Model for Hand<N, R, J, T>
where
    Self: Equations<f64> + Reports<f64>,
{
    fn shape(&self) -> &Shape {
        const { &Shape::named("hand").states(Self::STATES, Self::SCALES) }
    }

    fn equations(&self) -> &dyn Equations<f64> {
        self
    }

    fn reports(&self) -> &dyn Reports<f64> {
        self
    }

    fn span(&self) -> Span {
        Span::Open
    }

    fn start(&self) -> Vec<f64> {
        self.start.to_vec()
    }
}
