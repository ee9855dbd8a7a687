//! Rates of the outputs by an independent variable, with the loops closed.

use super::assembly::Assembly;
use super::newton::{Newton, Position};
use super::problem::{Closure, Linkage};
use crate::problem::Storage;
use crate::scalar::{Dual, Scalar};

/// The loops on dual numbers, and the memory for them.
pub(super) struct Rates<L: Linkage> {
    closure: L::Closure<Dual>,
    columns: Vec<Position<L, f64>>,
    position: Position<L, Dual>,
    row: <L::Closure<Dual> as Closure<Dual>>::Row,
    square: <L::Closure<Dual> as Closure<Dual>>::Matrix,
    values: Vec<Dual>,
}

impl<L: Linkage> Rates<L> {
    /// For a linkage with its dimensions.
    pub fn new(linkage: &L) -> Self {
        let values = linkage.values();
        let constants: Vec<Dual> = values.iter().map(|value| Dual::constant(*value)).collect();
        let closure = L::prepare(&constants);
        let size = Newton::<L, Dual>::size();
        let column = L::prepare::<f64>(&values).zeros();
        Self {
            columns: vec![column; L::INDEPENDENTS],
            position: closure.zeros(),
            row: Storage::zeros(size),
            square: Storage::zeros(size * size),
            values: vec![Dual::ZERO; L::OUTPUTS],
            closure,
        }
    }

    /// Writes the rates at the position of an assembly.
    pub fn of(&mut self, assembly: &Assembly<L, f64>, variable: usize, rates: &mut [f64]) {
        assembly
            .closure
            .coefficients(&assembly.instant, &assembly.position, &mut self.columns);
        let mut place: Vec<Dual> = assembly
            .independents
            .iter()
            .map(|x| Dual::constant(*x))
            .collect();
        place[variable].slope = 1.0;
        let instant = self.closure.instant(&place);
        let slopes = self.columns[variable].as_ref();
        for (j, slope) in slopes[..L::DEPENDENTS].iter().enumerate() {
            let value = assembly.position.as_ref()[j];
            self.position.as_mut()[j] = Dual {
                value,
                slope: *slope,
            };
        }
        // What the position holds beside the coordinates follows from them.
        for group in 0..L::GROUPS.len() {
            self.closure.trial(
                group,
                &instant,
                &mut self.position,
                &mut self.row,
                &mut self.square,
            );
        }
        self.closure
            .outputs(&instant, &self.position, &mut self.values);
        for (rate, value) in rates.iter_mut().zip(&self.values) {
            *rate = value.slope;
        }
    }
}
