//! The run-up of the table drive by hand: its equations, DOP853 written out, and the four phases.
//!
//! Equations of `table_drive.eqn`, scene `table_1`. State: `[twist, phi2, twist', phi2']`.

use crate::hand_dop853::{at_part, attempt};
use crate::hand_event::{Sample, first_fall, stays};

/// The link is wound up, both move, the table has come to rest again, the table is pulled back.
const WIND: u8 = 0;
const RUN: u8 = 1;
const STICK: u8 = 2;
const BACK: u8 = 3;
/// Absolute tolerance of all states per unit of the relative one.
const SCALE: f64 = 1e-3;

/// The parameters.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    pub j1: f64,
    pub j2: f64,
    pub c: f64,
    pub beta: f64,
    pub mc: f64,
    pub ms: f64,
    pub omega: f64,
}

impl Default for Drive {
    fn default() -> Self {
        Self { j1: 5e-4, j2: 5e-4, c: 710.0, beta: 0.980_665, mc: 0.2, ms: 17.2, omega: 157.0 }
    }
}

/// A step that is kept.
#[derive(Clone, Copy, Debug)]
pub struct Kept {
    pub phase: u8,
    pub from: f64,
    pub length: f64,
    pub before: [f64; 4],
    pub dense: [[f64; 4]; 7],
}

/// What a run gives.
#[derive(Clone, Debug)]
pub struct RunUp {
    pub end: [f64; 4],
    pub evaluations: usize,
    /// When the phases change.
    pub events: Vec<f64>,
    pub steps: Vec<Kept>,
    time: f64,
    step: f64,
    phase: u8,
}

/// Follows the drive from rest to `end`, and keeps the motion.
#[inline(never)]
pub fn run(drive: &Drive, end: f64, rtol: f64) -> RunUp {
    let mut run = RunUp {
        end: [0.0; 4],
        evaluations: 0,
        events: Vec::with_capacity(8),
        steps: Vec::with_capacity(128),
        time: 0.0,
        step: 1e-4,
        phase: WIND,
    };
    while run.time < end {
        match run.phase {
            WIND => run.phase::<WIND>(drive, end, rtol),
            RUN => run.phase::<RUN>(drive, end, rtol),
            STICK => run.phase::<STICK>(drive, end, rtol),
            _ => run.phase::<BACK>(drive, end, rtol),
        }
    }
    run
}

impl Drive {
    /// What the link transmits.
    #[inline(always)]
    fn torque(&self, y: &[f64; 4]) -> f64 {
        self.c * y[0] + self.beta * y[2]
    }

    /// `y'`
    #[inline(always)]
    fn rate<const PHASE: u8>(&self, y: &[f64; 4]) -> [f64; 4] {
        let torque = self.torque(y);
        let motor = self.ms * (1.0 - (y[2] + y[3]) / self.omega);
        let table = match PHASE {
            RUN => (torque - self.mc) / self.j2,
            BACK => (torque + self.mc) / self.j2,
            _ => 0.0,
        };
        [y[2], y[3], (motor - torque) / self.j1 - table, table]
    }

    /// What falls through zero where the phase ends, one way and the other, with the state changing by `rate`.
    #[inline(always)]
    fn guards<const PHASE: u8>(
        &self,
        y: &[f64; 4],
        rate: &[f64; 4],
        part: f64,
        h: f64,
    ) -> [Sample; 2] {
        let (torque, slope) = (self.torque(y), self.torque(rate));
        let pairs = match PHASE {
            WIND => [(self.mc - self.c * y[0], -self.c * rate[0]), (torque + self.mc, slope)],
            STICK => [(self.mc - torque, -slope), (torque + self.mc, slope)],
            RUN => [(y[3], rate[3]), (1.0, 0.0)],
            _ => [(-y[3], -rate[3]), (1.0, 0.0)],
        };
        pairs.map(|(value, slope)| Sample { part, value, slope: h * slope })
    }

    /// The phase that follows when a guard has fallen.
    #[inline(always)]
    fn next<const PHASE: u8>(&self, guard: usize, y: &[f64; 4]) -> u8 {
        let torque = self.torque(y);
        match PHASE {
            RUN if torque >= -self.mc => STICK,
            BACK if torque <= self.mc => STICK,
            RUN => BACK,
            BACK => RUN,
            _ if guard == 0 => RUN,
            _ => BACK,
        }
    }
}

impl RunUp {
    /// Whether the table moves, and the state, at a time.
    pub fn at(&self, time: f64) -> (bool, [f64; 4]) {
        let passed = self.steps.partition_point(|step| step.from <= time);
        let step = &self.steps[passed.max(1) - 1];
        let moves = step.phase == RUN || step.phase == BACK;
        let part = (time - step.from) / step.length;
        (moves, at_part(&step.before, &step.dense, part))
    }

    /// One phase, up to `stop` or to its end.
    #[inline(always)]
    fn phase<const PHASE: u8>(&mut self, drive: &Drive, stop: f64, rtol: f64) {
        let rate = |(): &(), y: &[f64; 4]| drive.rate::<PHASE>(y);
        let mut k1 = rate(&(), &self.end);
        self.evaluations += 1;
        let mut largest = 6.0;
        while self.time < stop {
            let (from, before) = (self.time, self.end);
            let is_last = from + 1.01 * self.step >= stop;
            let to = if is_last { stop } else { from + self.step };
            let h = to - from;
            let tried = attempt(rate, &[(); 11], (&before, &k1), h, (rtol, SCALE));
            self.evaluations += 11;
            let factor = 0.9 / tried.error.sqrt().sqrt().sqrt();
            if tried.error.is_nan() || tried.error > 1.0 {
                self.step = h * factor.max(1.0 / 3.0);
                largest = 1.0;
                continue;
            }
            let k13 = rate(&(), &tried.end);
            let dense = tried.dense(rate, &[(); 3], (&before, &k13), h);
            self.evaluations += 4;
            self.steps.push(Kept { phase: PHASE, from, length: h, before, dense });
            let begin = drive.guards::<PHASE>(&before, &k1, 0.0, h);
            let end = drive.guards::<PHASE>(&tried.end, &k13, 1.0, h);
            let mut found: Option<(f64, usize)> = None;
            for guard in 0..2 {
                if stays(&begin[guard], &end[guard]) {
                    continue;
                }
                let sample = |part| {
                    let y = at_part(&before, &dense, part);
                    drive.guards::<PHASE>(&y, &rate(&(), &y), part, h)[guard]
                };
                let part = first_fall(begin[guard], end[guard], 0, &sample);
                found = match (found, part) {
                    (Some(earlier), Some(part)) if earlier.0 <= part => Some(earlier),
                    (_, Some(part)) => Some((part, guard)),
                    (earlier, None) => earlier,
                };
            }
            if let Some((part, guard)) = found {
                self.time = from + part * h;
                self.end = at_part(&before, &dense, part);
                self.phase = drive.next::<PHASE>(guard, &self.end);
                if PHASE == RUN || PHASE == BACK {
                    self.end[3] = 0.0;
                }
                self.step = h;
                self.events.push(self.time);
                return;
            }
            (self.time, self.end, k1) = (to, tried.end, k13);
            self.step = h * factor.clamp(1.0 / 3.0, largest);
            largest = 6.0;
        }
    }
}
