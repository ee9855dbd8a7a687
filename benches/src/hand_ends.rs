//! Where in a step of the hand-written loop the foot lifts off or lands.

use crate::hand_dop853::{self, Attempt, at_part};
use crate::hand_event::{first_fall, stays};
use crate::hand_foot::{FLIGHT, Foot, Ground, Guards};

/// Whether the foot cannot touch in a step: the compression or the force stays below zero.
#[inline(always)]
pub fn is_apart(begin: &Guards, end: &Guards) -> bool {
    (0..2).any(|k| stays(&begin[k].turned(), &end[k].turned()))
}

/// A step with its continuous solution.
pub struct Within<'a> {
    pub foot: &'a Foot,
    pub before: [f64; 2],
    pub dense: [[f64; 2]; 7],
    pub from: f64,
    pub h: f64,
    pub to: f64,
}

/// Where in a step a phase ends, and whether the force is zero there.
pub type Found = Option<(f64, bool)>;

impl Within<'_> {
    /// Computes the continuous solution.
    #[inline(always)]
    pub fn complete<const PHASE: u8, const KERNEL: bool>(
        &mut self,
        tried: &Attempt<2>,
        k13: &[f64; 2],
    ) {
        let times = hand_dop853::extra_times(self.from, self.h);
        let grounds = self.foot.grounds::<PHASE, KERNEL, 3>(times);
        let rate = |ground: &Ground, y: &[f64; 2]| self.foot.rate::<PHASE>(ground, y);
        self.dense = tried.dense(rate, &grounds, (&self.before, k13), self.h);
    }

    #[inline(always)]
    fn guards<const PHASE: u8, const KERNEL: bool>(&self, part: f64, passed: u32) -> Guards {
        let y = at_part(&self.before, &self.dense, part);
        let time = self.from + part * self.h;
        let ground = self.foot.ground::<PHASE, KERNEL>(time, passed);
        let [_, rate] = self.foot.rate::<PHASE>(&ground, &y);
        self.foot.guards(&ground, &y, rate, part, self.h)
    }

    /// Where the force falls to zero.
    #[inline(never)]
    pub fn lift_off<const PHASE: u8, const KERNEL: bool>(
        &self,
        begin: Guards,
        end: Guards,
    ) -> Found {
        let force = |part| self.guards::<PHASE, KERNEL>(part, 0)[1];
        first_fall(begin[1], end[1], 0, &force).map(|part| (part, true))
    }

    /// Where compression and force are both above zero again, stretch by stretch between kinks.
    #[inline(never)]
    pub fn landing<const KERNEL: bool>(&self, mut begin: Guards, passed: &mut u32) -> Found {
        loop {
            let kink = self.foot.pass(*passed);
            let part = if kink < self.to { (kink - self.from) / self.h } else { 1.0 };
            let end = self.guards::<FLIGHT, KERNEL>(part, *passed);
            let found = self.touch::<KERNEL>(begin, end, *passed);
            if found.is_some() || kink >= self.to {
                return found;
            }
            *passed += 1;
            begin = self.guards::<FLIGHT, KERNEL>(part, *passed);
            if begin.iter().all(|one| one.value > 0.0) {
                return Some((part, false));
            }
        }
    }

    /// The same in a stretch without kinks.
    #[inline(always)]
    fn touch<const KERNEL: bool>(&self, begin: Guards, end: Guards, passed: u32) -> Found {
        if is_apart(&begin, &end) {
            return None;
        }
        let by_gap = self.rise::<0, KERNEL>(begin, end, passed);
        // Before the gap closes the force is none.
        if by_gap.is_some() && begin[0].value <= 0.0 {
            return by_gap.map(|part| (part, false));
        }
        let by_force = self.rise::<1, KERNEL>(begin, end, passed);
        match (by_gap, by_force) {
            (Some(gap), Some(force)) if gap <= force => Some((gap, false)),
            (Some(gap), None) => Some((gap, false)),
            (_, force) => force.map(|part| (part, true)),
        }
    }

    /// Where one guard rises through zero while the other is above it.
    #[inline(always)]
    fn rise<const ONE: usize, const KERNEL: bool>(
        &self,
        begin: Guards,
        end: Guards,
        passed: u32,
    ) -> Option<f64> {
        let sample = |part| self.guards::<FLIGHT, KERNEL>(part, passed)[ONE].turned();
        let mut from = begin[ONE].turned();
        loop {
            let part = first_fall(from, end[ONE].turned(), 0, &sample)?;
            let there = self.guards::<FLIGHT, KERNEL>(part, passed);
            if there[1 - ONE].value > 0.0 {
                return Some(part);
            }
            from = there[ONE].turned();
            from.value = from.value.min(-f64::MIN_POSITIVE);
        }
    }
}
