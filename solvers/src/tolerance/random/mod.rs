//! Random numbers that are found from their place in the sequence.
//!
//! SplitMix64 (G. Steele, D. Lea, C. Flood: *Fast splittable pseudorandom number generators*, OOPSLA 2014; S. Vigna's
//! `splitmix64.c`) adds a constant and mixes: its `n`-th number needs none of those before it. A sample is therefore the
//! same whichever thread draws it.

pub(super) mod distribution;
pub(super) mod normal;

/// 2⁶⁴ over the golden ratio, odd.
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// A sequence of random numbers.
#[derive(Clone, Copy, Debug)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The sequence of a seed, from its number `index` on.
    #[inline(always)]
    pub fn new(seed: u64, index: u64) -> Self {
        // Sequences of neighbouring seeds begin far from each other.
        let state = mix(seed.wrapping_add(GAMMA));
        Self { state: state.wrapping_add(index.wrapping_mul(GAMMA)) }
    }

    /// The number `ahead` places after the next one.
    #[inline(always)]
    pub fn ahead(&self, ahead: u64) -> f64 {
        let steps = ahead.wrapping_add(1);
        fraction(self.state.wrapping_add(steps.wrapping_mul(GAMMA)))
    }

    /// The next number, uniform between 0 and 1 without both ends.
    #[inline(always)]
    pub fn uniform(&mut self) -> f64 {
        self.state = self.state.wrapping_add(GAMMA);
        fraction(self.state)
    }
}

/// A number between 0 and 1 from the state: `(k + 1/2)/2⁵²`, with `k` its first 52 bits, which are made the digits of a
/// number between 1 and 2. The difference is exact.
#[inline(always)]
fn fraction(state: u64) -> f64 {
    const ONE: u64 = 1.0f64.to_bits();
    f64::from_bits(ONE | (mix(state) >> 12)) - (1.0 - 0.5 * f64::EPSILON)
}

/// Mixes all bits of a number.
#[inline(always)]
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_numbers() {
        // The first outputs of `splitmix64.c` for the state 1234567.
        let mut state: u64 = 1_234_567;
        for expected in
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]
        {
            state = state.wrapping_add(GAMMA);
            assert_eq!(mix(state), expected);
        }
    }

    #[test]
    fn any_number_is_found_from_its_place() {
        let mut all = Random::new(7, 0);
        let numbers: Vec<f64> = (0..100).map(|_| all.uniform()).collect();
        for (index, number) in numbers.iter().enumerate() {
            assert_eq!(Random::new(7, index as u64).uniform(), *number);
            assert_eq!(Random::new(7, 0).ahead(index as u64), *number);
            assert!(*number > 0.0 && *number < 1.0);
        }
        assert_ne!(Random::new(8, 0).uniform(), numbers[0]);
    }

    #[test]
    fn moments_are_those_of_the_uniform_distribution() {
        let mut random = Random::new(1, 0);
        let (mut mean, mut square, mut lagged, mut last) = (0.0, 0.0, 0.0, 0.5);
        let count = 1_000_000;
        for _ in 0..count {
            let number = random.uniform() - 0.5;
            mean += number;
            square += number * number;
            lagged += number * last;
            last = number;
        }
        let n = f64::from(count);
        // Four standard errors.
        assert!((mean / n).abs() < 4.0 * (1.0 / 12.0 / n).sqrt());
        assert!((square / n - 1.0 / 12.0).abs() < 4.0 * (1.0 / 180.0 / n).sqrt());
        assert!((lagged / n).abs() < 4.0 / 12.0 / n.sqrt());
    }
}
