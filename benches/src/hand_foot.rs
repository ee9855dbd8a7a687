//! The equations of the presser foot as an engineer writes them by hand: three phases, of which two need no sine.
//!
//! Equations of `presser_foot.eqn`, scene `elliptic`. State: `[w, w']`. `hand_walk` follows the motion.

use assur::scalar::Scalar;

use crate::hand_event::Sample;

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
pub struct Ground {
    pub s: f64,
    pub ds: f64,
    pub dds: f64,
}

/// Compression of the fabric, and the force that it would have, as functions of the part of a step.
pub type Guards = [Sample; 2];

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

/// For the other libraries, which ask one by one.
#[cfg(feature = "peers")]
impl Foot {
    /// `y'`
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
                if ground.s > 0.0 { ground } else { Ground::default() }
            }
        };
        let [delta, force] = self.guards(&ground, y, 0.0, 0.0, 1.0).map(|one| one.value);
        match phase {
            // Newtons per metre make them comparable.
            FLIGHT => force.min(self.c2 * delta),
            _ => force,
        }
    }

    /// Height of the rack above the plate, below zero while it returns.
    #[inline]
    pub fn rack_at(&self, time: f64) -> f64 {
        self.rack::<true, 1>([time])[0].s
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
}

impl Foot {
    /// When the rack passes the plate, up and down in turn.
    #[inline(always)]
    pub fn pass(&self, number: u32) -> f64 {
        use std::f64::consts::PI;
        let side = if number.is_multiple_of(2) { -self.half } else { self.half };
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

    /// What the equations of a phase need of several times.
    #[inline(always)]
    pub fn grounds<const PHASE: u8, const KERNEL: bool, const K: usize>(
        &self,
        times: [f64; K],
    ) -> [Ground; K] {
        match PHASE {
            RACK => self.rack::<KERNEL, K>(times),
            _ => [Ground::default(); K],
        }
    }

    /// What the fabric lies on when the rack has passed the plate so often.
    #[inline(always)]
    pub fn ground<const PHASE: u8, const KERNEL: bool>(&self, time: f64, passed: u32) -> Ground {
        match PHASE == RACK || PHASE == FLIGHT && passed % 2 == 1 {
            true => self.rack::<KERNEL, 1>([time])[0],
            false => Ground::default(),
        }
    }

    /// `y'`
    #[inline(always)]
    pub fn rate<const PHASE: u8>(&self, ground: &Ground, y: &[f64; 2]) -> [f64; 2] {
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
    pub fn guards(&self, ground: &Ground, y: &[f64; 2], rate: f64, part: f64, h: f64) -> Guards {
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
}
