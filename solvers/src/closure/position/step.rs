//! One step of a linkage of which no group is iterated.
//!
//! It is what [`Assembly::move_to`] spends its time with. Position and sines stand in local variables until the step is
//! accepted, so that the compiler keeps them in registers and writes them once.

use super::assembly::{Assembly, Position};
use crate::closure::linkage::problem::{Closure, Linkage};
use crate::scalar::Scalar;
use crate::shape::GroupKind;

/// A group before and after a step: its sine, what was expected of it, and the turns of its links.
pub(super) struct Passage<S> {
    pub before: S,
    pub sine: S,
    pub expected: S,
    pub turned: S,
}

impl<S: Scalar> Passage<S> {
    /// Whether the group has certainly kept its mode: see [`super::assembly`].
    #[inline(always)]
    pub fn certainly_keeps(self, kind: GroupKind) -> bool {
        let sum = (self.sine + self.before).abs();
        let missed = (self.sine - self.expected).abs();
        let two = S::from_f64(2.0);
        let certain = S::less(two * two.mul_add(missed, self.turned), sum);
        if let GroupKind::Rrr = kind {
            // The sine is that of the angle between both links, so that it cannot change by more than they turn.
            return S::holds(certain);
        }
        let change = (self.sine - self.before).abs();
        S::holds(S::and(certain, S::less(two * change, sum)))
    }
}

impl<L: Linkage, S: Scalar> Assembly<L, S> {
    /// Closes all groups, and goes there if they have certainly kept their modes.
    #[inline(always)]
    pub(super) fn step(&mut self, independents: &[S]) -> bool {
        let loops = &self.closure.0;
        let entry = loops.shape().loops();
        let groups = entry.groups.len();
        let instant = loops.instant(independents);
        let ratio = ratio(independents, &self.independents, &self.heading);
        let (mut position, mut sines) = (loops.zeros(), loops.zeros());
        let modes = &self.groups.modes.as_ref()[..groups];
        let found = &mut sines.as_mut()[..groups];
        loops.close_all(&instant, modes, &mut position, found, true);
        let mut certain = true;
        for index in 0..groups {
            certain &= self.keeps(index, sines.as_ref()[index], ratio, &mut position);
        }
        if certain {
            self.position = position;
            for index in 0..groups {
                let (sine, known) = (sines.as_ref()[index], &mut self.groups);
                known.changes.as_mut()[index] = sine - known.sines.as_ref()[index];
                known.sines.as_mut()[index] = sine;
            }
            self.head(independents);
            self.instant = instant;
        }
        certain
    }

    /// Takes other independent variables, and how they have changed.
    #[inline(always)]
    fn head(&mut self, independents: &[S]) {
        if self.closure.0.shape().drivers.len() == 1 {
            self.heading[0] = independents[0] - self.independents[0];
            self.independents[0] = independents[0];
            return;
        }
        let known = self.independents.iter_mut().zip(&mut self.heading);
        for (value, (kept, heading)) in independents.iter().zip(known) {
            *heading = *value - *kept;
            *kept = *value;
        }
    }

    /// Continues the angles of a group over whole turns, and says whether it has certainly kept its mode.
    #[inline(always)]
    fn keeps(&self, index: usize, sine: S, ratio: S, position: &mut Position<L, S>) -> bool {
        let entry = self.closure.0.shape().loops();
        let group = &entry.groups[index];
        let before = self.groups.sines.as_ref()[index];
        let mut turned = S::ZERO;
        if group.kind.has_modes() {
            let (position, last) = (position.as_mut(), self.position.as_ref());
            for &j in group.unknowns {
                if entry.angles[j] {
                    position[j] = position[j] + self.turns.as_ref()[j];
                    turned = turned + (position[j] - last[j]).abs();
                }
            }
        }
        let passage = Passage {
            before,
            sine,
            expected: self.groups.changes.as_ref()[index].mul_add(ratio, before),
            turned,
        };
        passage.certainly_keeps(group.kind)
    }
}

/// How often the last step goes into the one to these independent variables; NaN if its direction is another.
#[inline(always)]
pub(super) fn ratio<S: Scalar>(independents: &[S], known: &[S], heading: &[S]) -> S {
    if let ([to], [from], [heading]) = (independents, known, heading) {
        return (*to - *from) / *heading;
    }
    ratio_of_many(independents, known, heading)
}

/// The ratio for several independent variables.
fn ratio_of_many<S: Scalar>(independents: &[S], known: &[S], heading: &[S]) -> S {
    let (mut square, mut along, mut size) = (0.0, 0.0, 0.0);
    for (k, to) in independents.iter().enumerate() {
        let heading = heading[k].to_f64();
        let change = (*to - known[k]).to_f64();
        square += heading * heading;
        along += heading * change;
        size += change * change;
    }
    let aligned = along.abs() >= (1.0 - 1e-12) * (square * size).sqrt();
    S::from_f64(match (independents.is_empty(), aligned) {
        (true, _) => 0.0,
        (false, true) => along / square,
        (false, false) => f64::NAN,
    })
}
