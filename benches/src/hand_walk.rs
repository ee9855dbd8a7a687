//! The motion of the presser foot by hand: DOP853 written out, from phase to phase.
//!
//! The instants at which the rack passes the plate are known beforehand. What else ends a phase is looked for by the
//! cubic through the ends of a step, so the continuous solution is computed where something happens alone, or where the
//! motion is kept.

use crate::hand_dop853::{self, at_part, attempt};
use crate::hand_ends::{Within, is_apart};
use crate::hand_event::stays;
use crate::hand_foot::{FLIGHT, Foot, Ground, PLATE, RACK, SCALE};

/// A step that is kept.
#[derive(Clone, Copy, Debug)]
pub struct Kept {
    pub flying: bool,
    pub from: f64,
    pub length: f64,
    /// Where it ends: before its whole length if something happens in it.
    pub to: f64,
    pub before: [f64; 2],
    pub dense: [[f64; 2]; 7],
}

/// A motion under way, and what a run gives.
#[derive(Clone, Debug)]
pub struct Walk {
    pub time: f64,
    pub state: [f64; 2],
    pub flying: bool,
    pub evaluations: usize,
    /// How often the foot lifted off or landed, and the rack passed the plate below it.
    pub changes: usize,
    /// Times and states at which the phases change.
    pub events: Vec<(f64, [f64; 2])>,
    pub steps: Vec<Kept>,
    /// Length of the next step.
    step: f64,
    /// How often the rack has passed the plate.
    passed: u32,
    /// Whether the force is zero here because an event says so.
    is_zero: bool,
}

/// Follows the foot from time 0 in the air to `end`, with the sine of Assur (`KERNEL`) or of the standard library, and
/// keeps the motion (`KEEP`) or not.
#[inline(never)]
pub fn run<const KERNEL: bool, const KEEP: bool>(
    foot: &Foot,
    start: [f64; 2],
    end: f64,
    rtol: f64,
) -> Walk {
    let room = if KEEP { 64 } else { 0 };
    let mut walk = Walk {
        time: 0.0,
        state: start,
        flying: true,
        evaluations: 0,
        changes: 0,
        events: Vec::with_capacity(room / 8),
        steps: Vec::with_capacity(room),
        step: 2e-4,
        passed: 0,
        is_zero: false,
    };
    while walk.time < end {
        let next = foot.pass(walk.passed);
        if walk.flying {
            walk.phase::<FLIGHT, KERNEL, KEEP>(foot, end, rtol);
            continue;
        }
        match walk.passed % 2 {
            0 => walk.phase::<PLATE, KERNEL, KEEP>(foot, next.min(end), rtol),
            _ => walk.phase::<RACK, KERNEL, KEEP>(foot, next.min(end), rtol),
        }
        if walk.time == next {
            walk.passed += 1;
            walk.changes += 1;
        }
    }
    walk
}

impl Walk {
    /// Whether the foot is in the air, and the state, at a time of a motion that was kept.
    pub fn at(&self, time: f64) -> (bool, [f64; 2]) {
        let passed = self.steps.partition_point(|step| step.to <= time);
        match self.steps.get(passed) {
            Some(step) => {
                let part = (time - step.from) / step.length;
                (step.flying, at_part(&step.before, &step.dense, part))
            }
            None => (self.flying, self.state),
        }
    }

    /// One phase, up to `stop` or to its end.
    #[inline(always)]
    fn phase<const PHASE: u8, const KERNEL: bool, const KEEP: bool>(
        &mut self,
        foot: &Foot,
        stop: f64,
        rtol: f64,
    ) {
        let rate = |ground: &Ground, y: &[f64; 2]| foot.rate::<PHASE>(ground, y);
        let mut ground = foot.ground::<PHASE, KERNEL>(self.time, self.passed);
        let mut k1 = rate(&ground, &self.state);
        self.evaluations += 1;
        let mut largest = 6.0;
        while self.time < stop {
            let (from, wanted) = (self.time, self.step);
            let is_last = from + 1.01 * wanted >= stop;
            let to = if is_last { stop } else { from + wanted };
            let h = to - from;
            let grounds = foot.grounds::<PHASE, KERNEL, 11>(hand_dop853::times(from, h));
            let tried = attempt(rate, &grounds, (&self.state, &k1), h, (rtol, SCALE));
            self.evaluations += 11;
            let factor = 0.9 / tried.error.sqrt().sqrt().sqrt();
            if tried.error.is_nan() || tried.error > 1.0 {
                self.step = h * factor.max(1.0 / 3.0);
                largest = 1.0;
                continue;
            }
            let k13 = rate(&grounds[10], &tried.end);
            self.evaluations += 1;
            let mut within = Within { foot, before: self.state, dense: [[0.0; 2]; 7], from, h, to };
            if KEEP {
                within.complete::<PHASE, KERNEL>(&tried, &k13);
                self.evaluations += 3;
            }
            let mut begin = foot.guards(&ground, &self.state, k1[1], 0.0, h);
            if std::mem::take(&mut self.is_zero) {
                begin[1].value = 0.0;
            }
            ground = match PHASE {
                FLIGHT => foot.ground::<PHASE, KERNEL>(to, self.passed),
                _ => grounds[10],
            };
            let end = foot.guards(&ground, &tried.end, k13[1], 1.0, h);
            let is_clear = match PHASE {
                FLIGHT => foot.pass(self.passed) >= to && is_apart(&begin, &end),
                _ => stays(&begin[1], &end[1]),
            };
            if !is_clear {
                if !KEEP {
                    within.complete::<PHASE, KERNEL>(&tried, &k13);
                    self.evaluations += 3;
                }
                let found = match PHASE {
                    FLIGHT => within.landing::<KERNEL>(begin, &mut self.passed),
                    _ => within.lift_off::<PHASE, KERNEL>(begin, end),
                };
                if let Some(found) = found {
                    return self.change::<KEEP>(&within, found);
                }
                if PHASE == FLIGHT {
                    ground = foot.ground::<PHASE, KERNEL>(to, self.passed);
                }
            }
            if KEEP {
                self.keep(&within, to);
            }
            (self.time, self.state, k1) = (to, tried.end, k13);
            self.step = h * factor.clamp(1.0 / 3.0, largest);
            if is_last {
                self.step = self.step.max(wanted);
            }
            largest = 6.0;
        }
    }

    /// The foot lifts off or lands within a step.
    #[inline(always)]
    fn change<const KEEP: bool>(&mut self, within: &Within<'_>, (part, by_force): (f64, bool)) {
        self.time = within.from + part * within.h;
        self.state = at_part(&within.before, &within.dense, part);
        if KEEP {
            self.keep(within, self.time);
            self.events.push((self.time, self.state));
        }
        self.flying = !self.flying;
        self.changes += 1;
        self.is_zero = by_force;
        self.step = within.h;
    }

    /// Keeps a step up to a time.
    #[inline(always)]
    fn keep(&mut self, within: &Within<'_>, to: f64) {
        self.steps.push(Kept {
            flying: self.flying,
            from: within.from,
            length: within.h,
            to,
            before: within.before,
            dense: within.dense,
        });
    }
}
