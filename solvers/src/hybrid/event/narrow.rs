//! Where a guard whose ends of a stretch have different signs passes zero, to the last bits of the time.

use super::cubic::{Reading, hull, root};

/// How many times what a zero of a cubic is probably wrong by it is pushed. A quartic that agrees with a cubic at both ends
/// of a stretch, in values and slopes, differs from it by `c (p - a)² (p - b)²`. Where it was found to be wrong by `e` the
/// next cubic ends, and is wrong by about `e³` over the square of the distance to its other end, which is at least half of
/// the way to it.
const WRONG: f64 = 16.0;
/// How many times farther it is pushed the next time if that was not enough.
const FARTHER: f64 = 4.0;
/// How often that is tried.
const MISSES: u32 = 3;
/// A guard whose rate says that it has passed zero within so many roundings of the time is not looked at again.
const NEXT: f64 = 2.0;

/// The parts of a step that are different times on this machine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instants {
    from: f64,
    length: f64,
    /// Parts of the step in a second.
    parts: f64,
}

impl Instants {
    /// Of a step from a time on, of a length above zero.
    #[inline(always)]
    pub fn new(from: f64, length: f64) -> Self {
        Self { from, length, parts: 1.0 / length }
    }

    /// The time at a part.
    fn time(&self, part: f64) -> f64 {
        self.from + part * self.length
    }

    /// The part nearest to another one that is a time.
    fn nearest(&self, part: f64) -> f64 {
        (self.time(part) - self.from) * self.parts
    }

    /// How far it is from such a part to the next.
    fn apart(&self, part: f64) -> f64 {
        let time = self.time(part).abs();
        (time.next_up() - time) * self.parts
    }

    /// Parts between two samples of a guard which had a sign before, where it passes zero: the last one that has that sign,
    /// and the guard at the first one that has the other. They are as near to each other as times can be told apart, or its
    /// rate says that they are.
    pub fn narrow(
        &self,
        look: &mut dyn FnMut(f64) -> Reading,
        (mut low, mut high): (Reading, Reading),
        before: f64,
    ) -> (f64, Reading) {
        // Zero on the way belongs to what was before.
        let has_passed = |sample: &Reading| sample.value * before < 0.0;
        let blur = f64::EPSILON * self.time(1.0).abs() * self.parts;
        let (next, begin) = (NEXT * blur, low.part);
        // Where a kink is zero what bends there may be on its other side already.
        let last = |low: &Reading, part: f64| match low.value * before > 0.0 {
            true => low.part.max(part),
            false => begin.max(part.min(low.part - 2.0 * next)),
        };
        let (mut guessed, mut push, mut misses) = (f64::NAN, 0.0, 0);
        loop {
            let width = high.part - low.part;
            let (middle, inverse) = (low.part + 0.5 * width, 1.0 / width);
            if middle <= low.part || middle >= high.part || width <= blur {
                return (last(&low, low.part), high);
            }
            // The zero of the cubic, pushed across by what it is wrong so that the end moves in that is far. How wrong the
            // last one was tells that; where it was not enough, more is, and halving if all else fails.
            let root = low.part + width * root(&hull(&low, &high));
            let moved = root - guessed;
            guessed = root;
            let wrong = WRONG * moved.abs() * (moved * inverse).powi(2);
            let apart = self.apart(root);
            push = wrong.max(0.5 * apart).max(FARTHER * push);
            let is_low = root < middle;
            let guess = self.nearest(match is_low {
                true => (root + push).max(low.part + apart),
                false => (root - push).min(high.part - apart),
            });
            let is_tried = misses < MISSES && guess > low.part && guess < high.part;
            let part = if is_tried { guess } else { middle };
            let sample = look(part);
            let has_passed = has_passed(&sample);
            if has_passed {
                if sample.value.abs() <= next * sample.slope.abs() {
                    return (last(&low, part - 2.0 * next), sample);
                }
                high = sample;
            } else {
                low = sample;
            }
            (push, misses) = match is_tried && has_passed != is_low {
                true => (push, misses + 1),
                false if is_tried => (0.0, 0),
                // Then every other time.
                false => (0.0, MISSES - 1),
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The time at which a guard passes zero in a step from 2 s on, by how much it is wrong in roundings of the time, and
    /// how often the guard was looked at.
    fn passed(length: f64, zero: f64, guard: impl Fn(f64) -> (f64, f64)) -> (f64, usize) {
        let instants = Instants::new(2.0, length);
        let mut looks = 0;
        let mut look = |part: f64| {
            looks += 1;
            let (value, rate) = guard(2.0 + part * length);
            Reading { part, value, slope: rate * length }
        };
        let ends = (look(0.0), look(1.0));
        assert!(ends.0.value < 0.0 && ends.1.value > 0.0);
        let (before, at) = instants.narrow(&mut look, ends, -1.0);
        assert!(before <= at.part && at.value > 0.0, "{before} {at:?}");
        assert!(guard(2.0 + before * length).0 <= 0.0, "{before} {at:?}");
        let off = (instants.time(at.part) - zero) / (f64::EPSILON * zero);
        (off, looks - 2)
    }

    /// Halving takes as many looks as the length has bits, some fifty.
    #[test]
    fn few_looks_find_the_last_bits() {
        for number in 1..1000 {
            let (zero, bend) = (2.0 + f64::from(number) * 1e-4, 3.0);
            let guard = |time: f64| {
                let since = time - zero;
                ((bend * since).sinh(), bend * (bend * since).cosh())
            };
            let (off, looks) = passed(0.1, zero, guard);
            assert!(off.abs() < 4.0 && looks <= 5, "{number}: {off} {looks}");
            // It bends more than a cubic.
            let guard = |time: f64| {
                let since = 40.0 * (time - zero);
                (since.exp_m1(), 40.0 * since.exp())
            };
            let (off, looks) = passed(0.1, zero, guard);
            assert!(off.abs() < 4.0 && looks <= 9, "{number}: {off} {looks}");
        }
    }

    /// The guard is the difference of two large numbers: its rounding is that of thousands of instants.
    #[test]
    fn a_guard_of_much_rounding_has_other_signs_on_both_sides() {
        for number in 1..100 {
            let zero = 2.0 + f64::from(number) * 1e-3;
            let guard = |time: f64| ((1e4 + (time - zero)) - 1e4, 1.0);
            let (off, looks) = passed(0.1, zero, guard);
            assert!(off.abs() < 1e4 && looks < 100, "{number}: {off} {looks}");
        }
    }

    /// It is zero at a time that the machine has. There `max` and `if` may be on their other side already, so that this is
    /// no time before.
    #[test]
    fn where_a_guard_is_zero_is_not_before_it_passes() {
        for number in 1..1000 {
            let zero = 2.0 + f64::from(number) / 16384.0;
            let instants = Instants::new(2.0, 0.1);
            let mut look = |part: f64| Reading {
                part,
                value: instants.time(part) - zero,
                slope: instants.length,
            };
            let ends = (look(0.0), look(1.0));
            let (before, at) = instants.narrow(&mut look, ends, -1.0);
            assert!(look(before).value < 0.0, "{number}: {before} {at:?}");
            assert!(at.value > 0.0 && at.part - before < 1e-13, "{number}: {before} {at:?}");
        }
    }

    /// It jumps, and its rates say that it never gets to zero.
    #[test]
    fn a_jump_is_halved() {
        let guard = |time: f64| {
            if time < 2.0432 { (-1.0, 0.0) } else { (1.0, 0.0) }
        };
        let (off, looks) = passed(0.1, 2.0432, guard);
        assert!(off.abs() < 2.0 && looks < 210, "{off} {looks}");
    }
}
