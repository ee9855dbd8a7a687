//! The presser foot as an engineer writes it by hand: three phases, of which two need no sine, DOP853 written out, and
//! the instants at which the rack passes the plate known beforehand.
//!
//! Equations of `presser_foot.eqn`, scene `elliptic`. State: `[w, w']`. What ends a phase is looked for by the cubic
//! through the ends of a step, so the continuous solution is computed where something happens alone, or where the motion
//! is kept.

use assur::scalar::Scalar;

use crate::hand_dop853::{self, at_part, attempt};
use crate::hand_event::{Sample, first_fall, stays};

/// The foot on the fabric, that on the plate or on the rack, and the foot in the air.
pub const PLATE: u8 = 0;
pub const RACK: u8 = 1;
pub const FLIGHT: u8 = 2;
/// Absolute tolerance of both states per unit of the relative one.
pub const SCALE: f64 = 1e-3;

/// What the equations need of the parameters. Forces are divided by the mass.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    c2: f64,
    c3: f64,
    mu2: f64,
    c1: f64,
    mu1: f64,
    preload: f64,
    omega: f64,
    /// Half the angle during which the rack is above the plate, its cosine, and the scale of the path.
    half: f64,
    edge: f64,
    height: f64,
}

/// What the fabric lies on: its height with two rates.
#[derive(Clone, Copy, Debug, Default)]
struct Ground {
    s: f64,
    ds: f64,
    dds: f64,
}

/// Compression of the fabric, and the force that it would have, as functions of the part of a step.
type Guards = [Sample; 2];

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

impl Default for Foot {
    fn default() -> Self {
        let m = 0.15;
        let half = 60f64.to_radians();
        Self {
            c2: 1e5 / m,
            c3: 0.0,
            mu2: 30.0 / m,
            c1: 2000.0 / m,
            mu1: 2.0 / m,
            preload: 40.0 / m + 9.80665,
            omega: 300.0,
            half,
            edge: half.cos(),
            height: 1e-3 / (1.0 - half.cos()),
        }
    }
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
            foot.phase::<FLIGHT, KERNEL, KEEP>(&mut walk, end, rtol);
            continue;
        }
        match walk.passed % 2 {
            0 => foot.phase::<PLATE, KERNEL, KEEP>(&mut walk, next.min(end), rtol),
            _ => foot.phase::<RACK, KERNEL, KEEP>(&mut walk, next.min(end), rtol),
        }
        if walk.time == next {
            walk.passed += 1;
            walk.changes += 1;
        }
    }
    walk
}

impl Foot {
    /// `y'` for those who ask one by one.
    #[inline]
    pub fn rate_in(&self, phase: u8, time: f64, y: &[f64; 2]) -> [f64; 2] {
        match phase {
            RACK => self.rate::<RACK>(&self.ground::<RACK, true>(time, 1), y),
            PLATE => self.rate::<PLATE>(&Ground::default(), y),
            _ => self.rate::<FLIGHT>(&Ground::default(), y),
        }
    }

    /// What is below zero in the air and above it on the fabric: in the air the smaller one of compression and force, as
    /// both have to be above zero.
    #[inline]
    pub fn touch_in(&self, phase: u8, time: f64, y: &[f64; 2]) -> f64 {
        let ground = match phase {
            PLATE => Ground::default(),
            RACK => self.ground::<RACK, true>(time, 1),
            _ => {
                let ground = self.ground::<RACK, true>(time, 1);
                if ground.s > 0.0 {
                    ground
                } else {
                    Ground::default()
                }
            }
        };
        let [delta, force] = self.guards(&ground, y, 0.0, 0.0, 1.0).map(|one| one.value);
        match phase {
            // Newtons per metre make them comparable.
            FLIGHT => force.min(self.c2 * delta),
            _ => force,
        }
    }

    /// `∂y''/∂w` and `∂y''/∂w'`.
    #[inline]
    pub fn slopes_in(&self, phase: u8, time: f64, y: &[f64; 2]) -> [f64; 2] {
        if phase == FLIGHT {
            return [-self.c1, -self.mu1];
        }
        let ground = match phase {
            RACK => self.ground::<RACK, true>(time, 1),
            _ => Ground::default(),
        };
        let delta = ground.s - y[0];
        let stiffness = self.c2 + 3.0 * self.c3 * delta * delta;
        [-self.c1 - stiffness, -self.mu1 - self.mu2]
    }

    /// When the rack passes the plate, up and down in turn.
    #[inline(always)]
    pub fn pass(&self, number: u32) -> f64 {
        use std::f64::consts::PI;
        let side = if number % 2 == 0 {
            -self.half
        } else {
            self.half
        };
        (PI * f64::from(2 * (number / 2) + 1) + side) / self.omega
    }

    /// The rack at several times at once.
    #[inline(always)]
    fn rack<const KERNEL: bool, const K: usize>(&self, times: [f64; K]) -> [Ground; K] {
        let angles = times.map(|time| self.omega * time);
        let pairs = match KERNEL {
            true => {
                let (sines, cosines) = f64::sin_cos_all(angles);
                std::array::from_fn(|k| (sines[k], cosines[k]))
            }
            false => angles.map(f64::sin_cos),
        };
        // The shaft is half a turn behind.
        pairs.map(|(sine, cosine)| Ground {
            s: self.height * (-cosine - self.edge),
            ds: self.height * self.omega * sine,
            dds: self.height * self.omega * self.omega * cosine,
        })
    }

    /// What the fabric lies on when the rack has passed the plate so often.
    #[inline(always)]
    fn ground<const PHASE: u8, const KERNEL: bool>(&self, time: f64, passed: u32) -> Ground {
        match PHASE == RACK || PHASE == FLIGHT && passed % 2 == 1 {
            true => self.rack::<KERNEL, 1>([time])[0],
            false => Ground::default(),
        }
    }

    /// `y'`
    #[inline(always)]
    fn rate<const PHASE: u8>(&self, ground: &Ground, y: &[f64; 2]) -> [f64; 2] {
        let [w, v] = *y;
        let free = -self.preload - self.c1 * w - self.mu1 * v;
        if PHASE == FLIGHT {
            return [v, free];
        }
        let delta = ground.s - w;
        let fabric = (self.c2 + self.c3 * delta * delta) * delta + self.mu2 * (ground.ds - v);
        [v, fabric + free]
    }

    /// Compression and force at a part of a step of length `h`, where the speed changes by `rate`.
    #[inline(always)]
    fn guards(&self, ground: &Ground, y: &[f64; 2], rate: f64, part: f64, h: f64) -> Guards {
        let (delta, slope) = (ground.s - y[0], ground.ds - y[1]);
        let stiffness = self.c3 * delta * delta;
        let force = (self.c2 + stiffness) * delta + self.mu2 * slope;
        let change = (self.c2 + 3.0 * stiffness) * slope + self.mu2 * (ground.dds - rate);
        [(delta, slope), (force, change)].map(|(value, slope)| Sample {
            part,
            value,
            slope: h * slope,
        })
    }

    /// One phase, up to `stop` or to its end.
    #[inline(always)]
    fn phase<const PHASE: u8, const KERNEL: bool, const KEEP: bool>(
        &self,
        walk: &mut Walk,
        stop: f64,
        rtol: f64,
    ) {
        let rate = |ground: &Ground, y: &[f64; 2]| self.rate::<PHASE>(ground, y);
        let mut ground = self.ground::<PHASE, KERNEL>(walk.time, walk.passed);
        let mut k1 = rate(&ground, &walk.state);
        walk.evaluations += 1;
        let mut largest = 6.0;
        while walk.time < stop {
            let (from, wanted) = (walk.time, walk.step);
            let is_last = from + 1.01 * wanted >= stop;
            let to = if is_last { stop } else { from + wanted };
            let h = to - from;
            let grounds = match PHASE {
                RACK => self.rack::<KERNEL, 11>(hand_dop853::times(from, h)),
                _ => [Ground::default(); 11],
            };
            let tried = attempt(rate, &grounds, (&walk.state, &k1), h, (rtol, SCALE));
            walk.evaluations += 11;
            let factor = 0.9 / tried.error.sqrt().sqrt().sqrt();
            if tried.error.is_nan() || tried.error > 1.0 {
                walk.step = h * factor.max(1.0 / 3.0);
                largest = 1.0;
                continue;
            }
            let k13 = rate(&grounds[10], &tried.end);
            walk.evaluations += 1;
            let mut within = Within {
                foot: self,
                before: walk.state,
                dense: [[0.0; 2]; 7],
                from,
                h,
                to,
            };
            let dense = |walk: &mut Walk| {
                walk.evaluations += 3;
                let grounds = match PHASE {
                    RACK => self.rack::<KERNEL, 3>(hand_dop853::extra_times(from, h)),
                    _ => [Ground::default(); 3],
                };
                tried.dense(rate, &grounds, (&within.before, &k13), h)
            };
            if KEEP {
                within.dense = dense(walk);
            }
            let mut begin = self.guards(&ground, &walk.state, k1[1], 0.0, h);
            if std::mem::take(&mut walk.is_zero) {
                begin[1].value = 0.0;
            }
            ground = match PHASE {
                FLIGHT => self.ground::<PHASE, KERNEL>(to, walk.passed),
                _ => grounds[10],
            };
            let end = self.guards(&ground, &tried.end, k13[1], 1.0, h);
            let is_clear = match PHASE {
                FLIGHT => self.pass(walk.passed) >= to && is_apart(&begin, &end),
                _ => stays(&begin[1], &end[1]),
            };
            let mut found = None;
            if !is_clear {
                if !KEEP {
                    within.dense = dense(walk);
                }
                found = match PHASE {
                    FLIGHT => within.landing::<KERNEL>(begin, &mut walk.passed),
                    _ => within.lift_off::<PHASE, KERNEL>(begin, end),
                };
            }
            let (time, state) = match found {
                Some((part, _)) => (
                    from + part * h,
                    at_part(&within.before, &within.dense, part),
                ),
                None => (to, tried.end),
            };
            if KEEP {
                walk.steps.push(Kept {
                    flying: walk.flying,
                    from,
                    length: h,
                    to: time,
                    before: within.before,
                    dense: within.dense,
                });
            }
            (walk.time, walk.state) = (time, state);
            if let Some((_, by_force)) = found {
                walk.flying = !walk.flying;
                walk.changes += 1;
                walk.is_zero = by_force;
                walk.step = h;
                if KEEP {
                    walk.events.push((time, state));
                }
                return;
            }
            if PHASE == FLIGHT && !is_clear {
                ground = self.ground::<PHASE, KERNEL>(to, walk.passed);
            }
            k1 = k13;
            walk.step = h * factor.clamp(1.0 / 3.0, largest);
            if is_last {
                walk.step = walk.step.max(wanted);
            }
            largest = 6.0;
        }
    }
}

/// Whether the foot cannot touch in a step: the compression or the force stays below zero.
#[inline(always)]
fn is_apart(begin: &Guards, end: &Guards) -> bool {
    (0..2).any(|k| stays(&begin[k].turned(), &end[k].turned()))
}

/// A step with its continuous solution.
struct Within<'a> {
    foot: &'a Foot,
    before: [f64; 2],
    dense: [[f64; 2]; 7],
    from: f64,
    h: f64,
    to: f64,
}

/// Where in a step a phase ends, and whether the force is zero there.
type Found = Option<(f64, bool)>;

impl Within<'_> {
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
    fn lift_off<const PHASE: u8, const KERNEL: bool>(&self, begin: Guards, end: Guards) -> Found {
        let force = |part| self.guards::<PHASE, KERNEL>(part, 0)[1];
        first_fall(begin[1], end[1], 0, &force).map(|part| (part, true))
    }

    /// Where compression and force are both above zero again, stretch by stretch between kinks.
    #[inline(never)]
    fn landing<const KERNEL: bool>(&self, mut begin: Guards, passed: &mut u32) -> Found {
        loop {
            let kink = self.foot.pass(*passed);
            let part = if kink < self.to {
                (kink - self.from) / self.h
            } else {
                1.0
            };
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
