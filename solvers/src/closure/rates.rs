//! Outputs and dependent coordinates with their rates by whatever moves the linkage, the loops closed.

use super::assembly::Assembly;
use super::newton::{Newton, Position};
use super::problem::{Closure, Linkage};
use crate::problem::Storage;
use crate::scalar::{Dual, Scalar};

/// Makes NaN of the outputs that have no value where modes of a group meet.
fn strike<L: Linkage>(assembly: &mut Assembly<L, f64>, place: &[Dual], outputs: &mut [Dual]) {
    let place: Vec<f64> = place.iter().map(|x| x.value).collect();
    let (independents, motion) = place.split_at(L::INDEPENDENTS);
    let instant = match motion.is_empty() {
        true => assembly.closure.instant(independents),
        false => assembly.closure.moving(independents, motion),
    };
    let mut values: Vec<f64> = outputs.iter().map(|one| one.value).collect();
    assembly.strike_undetermined(&instant, &mut values);
    for (output, value) in outputs.iter_mut().zip(values) {
        output.value = value;
    }
}

/// The loops on dual numbers, and the memory for them.
pub(super) struct Rates<L: Linkage> {
    closure: L::Closure<Dual>,
    columns: Vec<Position<L, f64>>,
    position: Position<L, Dual>,
    row: <L::Closure<Dual> as Closure<Dual>>::Row,
    square: <L::Closure<Dual> as Closure<Dual>>::Matrix,
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
            closure,
        }
    }

    /// The outputs and behind them the dependent coordinates where an assembly stands, with their rates; its independent
    /// variables, and behind them how they move where that is known, are given with theirs.
    pub fn of(&mut self, assembly: &mut Assembly<L, f64>, place: &[Dual]) -> Vec<Dual> {
        assembly
            .closure
            .coefficients(&assembly.instant, &assembly.position, &mut self.columns);
        let (independents, motion) = place.split_at(L::INDEPENDENTS);
        let instant = match motion.is_empty() {
            true => self.closure.instant(independents),
            false => self.closure.moving(independents, motion),
        };
        for j in 0..L::DEPENDENTS {
            let by = |(column, x): (&Position<L, f64>, &Dual)| match x.slope {
                0.0 => 0.0,
                slope => column.as_ref()[j] * slope,
            };
            self.position.as_mut()[j] = Dual {
                value: assembly.position.as_ref()[j],
                slope: self.columns.iter().zip(independents).map(by).sum(),
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
        let mut values = vec![Dual::ZERO; L::OUTPUTS];
        self.closure.outputs(&instant, &self.position, &mut values);
        if assembly.is_singular() {
            strike(assembly, place, &mut values);
        }
        values.extend_from_slice(&self.position.as_ref()[..L::DEPENDENTS]);
        if assembly.is_singular() {
            values.iter_mut().for_each(|value| value.slope = f64::NAN);
        }
        values
    }
}
