//! The careful way to a made linkage: its errors grow from nothing, in steps short enough that no mode can be left.

use super::nominal::Nominal;
use super::place::{CONTRACTION, NOTHING, Position, largest, unwrap};
use super::small;
use super::source::Source;
use crate::closure::{Closure, GroupKind, Linkage, Variable};
use crate::problem::Storage;

/// Shortest step, as a part of the errors. A linkage that comes nearer to its dead point than this is not told from one
/// beyond it.
const SHORTEST: f64 = 1.0 / (1 << 24) as f64;
/// Largest number of steps.
const STEPS: usize = 400;
/// Largest first correction in a step, in radians or turns of the longest link: what lies farther may be another mode, or
/// the same one some turns away.
const LONGEST: f64 = 0.25;
/// Largest number of corrections in a step.
const ITERATIONS: usize = 20;

/// One linkage in the making.
pub(super) struct Lead<'a, L: Linkage> {
    pub nominal: &'a Nominal,
    pub sources: &'a [Source],
    pub output: usize,
    pub linkage: std::marker::PhantomData<L>,
}

impl<L: Linkage> Lead<'_, L> {
    /// The error of the output for the errors of the sources; none if the mode ends on the way there.
    pub fn error(&self, errors: &[f64]) -> Option<f64> {
        let mut position: Vec<f64> = self.nominal.position.clone();
        let (mut at, mut step, mut output) = (0.0, 0.5, None);
        for _ in 0..STEPS {
            let to = f64::min(1.0, at + step);
            match self.close(errors, to, &position) {
                Some((reached, value)) => {
                    (position, at, output) = (reached, to, Some(value));
                    step *= 2.0;
                }
                None => step *= 0.5,
            }
            if at >= 1.0 {
                return output.map(|value| value - self.nominal.outputs[self.output]);
            }
            if step < SHORTEST {
                return None;
            }
        }
        None
    }

    /// Closes all groups with a part of the errors, near a position. Gives the position and the output.
    fn close(&self, errors: &[f64], part: f64, near: &[f64]) -> Option<(Vec<f64>, f64)> {
        let mut values = self.nominal.values.clone();
        let mut independents = self.nominal.independents.clone();
        for (source, error) in self.sources.iter().zip(errors) {
            match L::VARIABLES[source.variable] {
                Variable::Constant(index) => values[index] += part * error,
                Variable::Driver(index) => independents[index] += part * error,
            }
        }
        let closure = L::prepare::<f64>(&values);
        let instant = match self.nominal.motion.is_empty() {
            true => closure.instant(&independents),
            false => closure.moving(&independents, &self.nominal.motion),
        };
        let mut position = closure.zeros();
        position.as_mut().copy_from_slice(near);
        for (index, group) in L::GROUPS.iter().enumerate() {
            if group.kind == GroupKind::General {
                self.iterate(&closure, index, &instant, &mut position)?;
                continue;
            }
            let sine = closure.close(index, &instant, self.nominal.modes[index], &mut position);
            if group.kind.has_modes() {
                unwrap::<L, f64>(index, &mut position, near);
            }
            if sine.is_nan() {
                return None;
            }
        }
        let mut outputs = vec![0.0; L::OUTPUTS];
        closure.outputs(&instant, &position, &mut outputs);
        let value = outputs[self.output];
        value
            .is_finite()
            .then(|| (position.as_ref().to_vec(), value))
    }

    /// Newton's method, believed only while each correction is a quarter of the one before or less.
    fn iterate(
        &self,
        closure: &L::Closure<f64>,
        index: usize,
        instant: &<L::Closure<f64> as Closure<f64>>::Instant,
        position: &mut Position<L, f64>,
    ) -> Option<()> {
        let unknowns = L::GROUPS[index].unknowns;
        let mut residual = <L::Closure<f64> as Closure<f64>>::Row::zeros(largest::<L>());
        let mut jacobian = <L::Closure<f64> as Closure<f64>>::Matrix::zeros(largest::<L>().pow(2));
        let mut before = LONGEST / CONTRACTION;
        for _ in 0..ITERATIONS {
            closure.trial(index, instant, position, &mut residual, &mut jacobian);
            let determinant = small::solve(unknowns.len(), jacobian.as_mut(), residual.as_mut());
            let mut length: f64 = 0.0;
            for (step, &j) in residual.as_ref().iter().zip(unknowns) {
                position.as_mut()[j] -= step;
                length = length.max((step / self.nominal.units[j]).abs());
            }
            let keeps = determinant * self.nominal.sines[index] > 0.0;
            if !(keeps && length <= CONTRACTION * before + NOTHING) {
                return None;
            }
            if length <= NOTHING {
                // What is left of this correction is its square over the sine: one more comes down to rounding.
                closure.trial(index, instant, position, &mut residual, &mut jacobian);
                small::solve(unknowns.len(), jacobian.as_mut(), residual.as_mut());
                for (step, &j) in residual.as_ref().iter().zip(unknowns) {
                    position.as_mut()[j] -= step;
                }
                closure.trial(index, instant, position, &mut residual, &mut jacobian);
                return Some(());
            }
            before = length;
        }
        None
    }
}
