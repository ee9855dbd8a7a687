//! The careful way to a made linkage: its errors grow from nothing, in steps short enough that no mode can be left.

use super::nominal::Nominal;
use super::place::{CONTRACTION, NOTHING};
use super::small;
use super::turn::unwrap;
use crate::closure::{AnyLinkage, GroupKind, Loops, Square, Variable};
use crate::shape::LinkageEntry;
use crate::tolerance::source::Study;

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
pub(in crate::tolerance) struct Lead<'a> {
    linkage: &'a dyn AnyLinkage,
    entry: &'static LinkageEntry,
    study: &'a Study,
    nominal: &'a Nominal,
}

impl<'a> Lead<'a> {
    /// From a nominal linkage.
    pub fn new(linkage: &'a dyn AnyLinkage, study: &'a Study, nominal: &'a Nominal) -> Self {
        Self { linkage, entry: linkage.shape().loops(), study, nominal }
    }

    /// The error of the output for the errors of the sources, in one step; none if the linkage does not close.
    pub fn at_once(&self, errors: &[f64]) -> Option<f64> {
        let (_, value) = self.close(errors, 1.0, &self.nominal.position)?;
        Some(value - self.nominal.outputs[self.study.output])
    }

    /// The error of the output for the errors of the sources; none if the mode ends on the way there.
    pub fn error(&self, errors: &[f64]) -> Option<f64> {
        let mut position: Vec<f64> = self.nominal.position.clone();
        let (mut at, mut step, mut output) = (0.0, 0.5, None);
        for _ in 0..STEPS {
            let to = f64::min(1.0, at + step);
            let closed = self.close(errors, to, &position);
            match closed.filter(|one| one.1.is_finite()) {
                Some((reached, value)) => {
                    (position, at, output) = (reached, to, Some(value));
                    step *= 2.0;
                }
                None => step *= 0.5,
            }
            if at >= 1.0 {
                return output.map(|value| value - self.nominal.outputs[self.study.output]);
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
        for (source, error) in self.study.sources.iter().zip(errors) {
            match self.entry.variables[source.variable] {
                Variable::Constant(index) => values[index] += part * error,
                Variable::Driver(index) => independents[index] += part * error,
            }
        }
        let loops = self.linkage.prepare(&values);
        let instant = loops.instant_row(&independents, &self.nominal.motion);
        let mut position = near.to_vec();
        for (index, group) in self.entry.groups.iter().enumerate() {
            if group.kind == GroupKind::General {
                self.iterate(&*loops, index, &instant, &mut position)?;
                continue;
            }
            let sine = loops.close(index, &instant, self.nominal.modes[index], &mut position);
            if group.kind.has_modes() {
                unwrap(self.entry, index, &mut position, near);
            }
            if sine.is_nan() {
                return None;
            }
        }
        let mut outputs = vec![0.0; self.nominal.outputs.len()];
        loops.outputs(&instant, &position, &mut outputs);
        Some((position, outputs[self.study.output]))
    }

    /// Newton's method, believed only while each correction is a quarter of the one before or less.
    fn iterate(
        &self,
        loops: &dyn Loops<f64>,
        index: usize,
        instant: &[f64],
        position: &mut [f64],
    ) -> Option<()> {
        let unknowns = self.entry.groups[index].unknowns;
        let mut square = Square::of(self.linkage.shape());
        let mut before = LONGEST / CONTRACTION;
        let mut step = |position: &mut [f64]| {
            square.look(loops, index, instant, position);
            let Square { residual, jacobian } = &mut square;
            let determinant = small::solve(unknowns.len(), jacobian, residual);
            for (step, &j) in residual.iter().zip(unknowns) {
                position[j] -= step;
            }
            let units = unknowns.iter().map(|&j| self.nominal.units[j]);
            let lengths = residual.iter().zip(units).map(|(step, unit)| (step / unit).abs());
            (determinant, lengths.fold(0.0, f64::max))
        };
        for _ in 0..ITERATIONS {
            let (determinant, length) = step(position);
            let keeps = determinant * self.nominal.sines[index] > 0.0;
            if !(keeps && length <= CONTRACTION * before + NOTHING) {
                return None;
            }
            if length <= NOTHING {
                // What is left of this correction is its square over the sine: one more comes down to rounding.
                step(position);
                square.look(loops, index, instant, position);
                return Some(());
            }
            before = length;
        }
        None
    }
}
