//! Groups that are iterated: predicted by the kinematic coefficients, closed by Newton's method, and believed only if
//! both agree.

use super::guide::Guide;
use crate::scalar::Scalar;

/// Largest distance between prediction and answer, as a part of the way.
const DISAGREEMENT: f64 = 0.2;
/// Distance that counts as none, in radians.
const NOTHING: f64 = 1e-9;

impl<S: Scalar> Guide<'_, S> {
    /// Closes a group of kind `General` near where it is predicted. Gives the sine of its transmission angle, NaN if the
    /// answer cannot be trusted, and twice the largest change of its unknowns in radians or lengths of its longest link.
    pub(in crate::closure) fn iterate(
        &mut self,
        group: usize,
        independents: &[S],
        instant: &[S],
    ) -> (S, S) {
        let unknowns = self.entry.groups[group].unknowns;
        for &j in unknowns {
            self.trial[j] = S::from_f64(self.predicted(j, independents));
        }
        let closed = self.newton.close(self.loops, group, instant, self.trial);
        let Ok(closed) = closed else {
            return (S::from_f64(f64::NAN), S::ZERO);
        };
        let (mut moved, mut missed) = (0.0, 0.0);
        for (k, &j) in unknowns.iter().enumerate() {
            let unit = self.newton.units()[k];
            let found = self.trial[j].to_f64();
            let last = self.position[j].to_f64();
            moved = f64::max(moved, (found - last).abs() / unit);
            missed = f64::max(missed, (found - self.predicted(j, independents)).abs() / unit);
        }
        let agrees = missed <= DISAGREEMENT * moved + NOTHING;
        let sine = if agrees { closed.sine } else { f64::NAN };
        (S::from_f64(sine), S::from_f64(2.0 * moved))
    }

    /// Where the kinematic coefficients predict a dependent coordinate.
    fn predicted(&self, j: usize, independents: &[S]) -> f64 {
        let mut value = self.position[j].to_f64();
        let columns = self.columns.chunks_exact(self.entry.dependents.len());
        for (column, (to, from)) in columns.zip(independents.iter().zip(&*self.independents)) {
            value += column[j].to_f64() * (*to - *from).to_f64();
        }
        value
    }
}
