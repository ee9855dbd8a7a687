//! Random errors by hand, and what a loop adds up of what comes out: moments, extremes, and how many fell into each class.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Classes of fixed width.
pub const CLASSES: usize = 4096;
/// 2⁶⁴ over the golden ratio, odd.
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// SplitMix64, as [`assur::tolerance`] draws.
pub struct Draw(u64);

impl Draw {
    /// From a place in the sequence of the seed 1 on.
    #[inline(always)]
    pub fn from(place: u64) -> Self {
        Self(mix(1u64.wrapping_add(GAMMA)).wrapping_add(place.wrapping_mul(GAMMA)))
    }

    /// The next error, uniform between bounds alike far from zero.
    #[inline(always)]
    pub fn error(&mut self, half_width: f64) -> f64 {
        self.0 = self.0.wrapping_add(GAMMA);
        let share = ((mix(self.0) >> 12) as f64 + 0.5) * f64::EPSILON;
        (2.0 * share - 1.0) * half_width
    }
}

#[inline(always)]
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// What the loop adds up at one place.
#[derive(Clone)]
pub struct Sums {
    reach: f64,
    count: u64,
    powers: [f64; 4],
    least: f64,
    greatest: f64,
    classes: Vec<u64>,
}

impl Sums {
    /// Nothing yet; classes reach so far from zero.
    pub fn new(reach: f64) -> Self {
        Self {
            reach,
            count: 0,
            powers: [0.0; 4],
            least: f64::INFINITY,
            greatest: f64::NEG_INFINITY,
            classes: vec![0; CLASSES],
        }
    }

    #[inline(always)]
    pub fn add(&mut self, error: f64) {
        let square = error * error;
        self.count += 1;
        self.powers[0] += error;
        self.powers[1] += square;
        self.powers[2] += square * error;
        self.powers[3] += square * square;
        self.least = self.least.min(error);
        self.greatest = self.greatest.max(error);
        let class = ((error + self.reach) * (CLASSES as f64 / (2.0 * self.reach))) as usize;
        self.classes[class.min(CLASSES - 1)] += 1;
    }

    fn join(&mut self, other: &Self) {
        self.count += other.count;
        for (sum, more) in self.powers.iter_mut().zip(other.powers) {
            *sum += more;
        }
        self.least = self.least.min(other.least);
        self.greatest = self.greatest.max(other.greatest);
        for (sum, more) in self.classes.iter_mut().zip(&other.classes) {
            *sum += more;
        }
    }

    /// Standard deviation of what the samples are drawn from.
    pub fn deviation(&self) -> f64 {
        let n = self.count as f64;
        ((self.powers[1] - self.powers[0].powi(2) / n) / (n - 1.0)).sqrt()
    }
}

/// Samples, and those of a block.
pub struct Blocks {
    pub samples: u64,
    pub size: u64,
}

/// Draws blocks on so many threads, each with its own sums; `draw` adds the samples between two numbers.
pub fn drawn(
    threads: u64,
    blocks: &Blocks,
    none: &[Sums],
    draw: impl Fn((u64, u64), &mut [Sums]) + Sync,
) -> Vec<Sums> {
    let next = AtomicU64::new(0);
    let all = Mutex::new(none.to_vec());
    let work = || {
        let mut sums = none.to_vec();
        loop {
            let from = next.fetch_add(blocks.size, Ordering::Relaxed);
            if from >= blocks.samples {
                break;
            }
            draw((from, blocks.samples.min(from + blocks.size)), &mut sums);
        }
        let mut all = all.lock().expect("no thread panics");
        for (sum, more) in all.iter_mut().zip(&sums) {
            sum.join(more);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    all.into_inner().expect("no thread panics")
}
