//! Outputs and dependent coordinates with their rates by whatever moves the linkage, the loops closed.

use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::{Answers, Square};
use crate::closure::position::guide::Guide;
use crate::scalar::{Dual, Scalar};

/// Makes NaN of the outputs that have no value where modes of a group meet.
fn strike(guide: &mut Guide<'_, f64>, place: &[Dual], outputs: &mut [Dual]) {
    let place: Vec<f64> = place.iter().map(|x| x.value).collect();
    let (independents, motion) = place.split_at(guide.independents.len());
    let instant = guide.loops.instant_row(independents, motion);
    let mut values: Vec<f64> = outputs.iter().map(|one| one.value).collect();
    guide.strike_undetermined(&instant, &mut values);
    for (output, value) in outputs.iter_mut().zip(values) {
        output.value = value;
    }
}

/// The loops on dual numbers, and the memory for them.
pub(super) struct Rates {
    loops: Box<dyn Answers<Dual>>,
    columns: Vec<f64>,
    position: Vec<Dual>,
    square: Square<Dual>,
}

impl Rates {
    /// For a linkage with its dimensions.
    pub fn new(linkage: &dyn AnyLinkage) -> Self {
        let values = linkage.values();
        let constants: Vec<Dual> = values.iter().map(|value| Dual::constant(*value)).collect();
        let (loops, shape) = (linkage.differentiate(&constants), linkage.shape());
        Self {
            columns: vec![0.0; shape.drivers.len() * shape.loops().dependents.len()],
            position: vec![Dual::ZERO; loops.lengths().0],
            square: Square::of(shape),
            loops,
        }
    }

    /// The outputs and behind them the dependent coordinates where an assembly stands, with their rates; its independent
    /// variables, and behind them how they move where that is known, are given with theirs.
    pub fn of(&mut self, guide: &mut Guide<'_, f64>, place: &[Dual]) -> Vec<Dual> {
        let loops = guide.loops;
        loops.coefficients(guide.instant, guide.position, &mut self.columns);
        let (independents, motion) = place.split_at(guide.independents.len());
        let instant = self.loops.instant_row(independents, motion);
        let dependents = guide.entry.dependents.len();
        for j in 0..dependents {
            let by = |(driver, x): (usize, &Dual)| match x.slope {
                0.0 => 0.0,
                slope => self.columns[driver * dependents + j] * slope,
            };
            self.position[j] = Dual {
                value: guide.position[j],
                slope: independents.iter().enumerate().map(by).sum(),
            };
        }
        // What the position holds beside the coordinates follows from them.
        for group in 0..guide.entry.groups.len() {
            self.square.look(&*self.loops, group, &instant, &mut self.position);
        }
        let mut values = vec![Dual::ZERO; loops.shape().outputs.len()];
        self.loops.outputs(&instant, &self.position, &mut values);
        if guide.is_singular() {
            strike(guide, place, &mut values);
        }
        values.extend_from_slice(&self.position[..dependents]);
        if guide.is_singular() {
            values.iter_mut().for_each(|value| value.slope = f64::NAN);
        }
        values
    }
}
