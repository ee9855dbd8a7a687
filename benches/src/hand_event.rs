//! The first fall of a function through zero in a step, as one writes it by hand.
//!
//! A function with values and slopes at two points is taken for the cubic through them: where that stays above zero no
//! more is asked. Where it falls from one sign to the other without turning, Newton's method goes to the last bits;
//! everything else is halved.

/// A function at a part of the step, from 0 to 1; the slope is that by the part.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    pub part: f64,
    pub value: f64,
    pub slope: f64,
}

/// Halvings before a touch is taken for what it is.
const DEEPEST: u32 = 30;

impl Sample {
    /// The function with its sign turned.
    #[inline(always)]
    pub fn turned(self) -> Self {
        Self { value: -self.value, slope: -self.slope, ..self }
    }
}

/// The two inner numbers between which, and the values at the ends, the cubic lies.
#[inline(always)]
fn inner(from: &Sample, to: &Sample) -> (f64, f64) {
    let third = (to.part - from.part) / 3.0;
    (from.value + third * from.slope, to.value - third * to.slope)
}

/// Whether the cubic stays at or above zero.
#[inline(always)]
pub fn stays(from: &Sample, to: &Sample) -> bool {
    let (one, two) = inner(from, to);
    from.value >= 0.0 && one >= 0.0 && two >= 0.0 && to.value >= 0.0
}

/// The part of the step at which a function first falls below zero.
pub fn first_fall(
    from: Sample,
    to: Sample,
    depth: u32,
    sample: &impl Fn(f64) -> Sample,
) -> Option<f64> {
    if stays(&from, &to) {
        return None;
    }
    let (one, two) = inner(&from, &to);
    if from.value < 0.0 && one < 0.0 && two < 0.0 && to.value < 0.0 {
        return None;
    }
    let falls = from.value >= 0.0 && to.value < 0.0;
    if falls && (depth == DEEPEST || from.value >= one && one >= two && two >= to.value) {
        return Some(newton(from, to, sample));
    }
    if depth == DEEPEST {
        return None;
    }
    let middle = sample(0.5 * (from.part + to.part));
    let first = first_fall(from, middle, depth + 1, sample);
    first.or_else(|| first_fall(middle, to, depth + 1, sample))
}

/// The zero between two points of different sign: from that of the cubic by Newton's method, kept between the points
/// that enclose it.
fn newton(mut low: Sample, mut high: Sample, sample: &impl Fn(f64) -> Sample) -> f64 {
    let mut part = zero_of_cubic(&low, &high);
    loop {
        let here = sample(part);
        match here.value >= 0.0 {
            true => low = here,
            false => high = here,
        }
        let mut next = part - here.value / here.slope;
        if (next - part).abs() <= f64::EPSILON * part {
            return next.min(1.0);
        }
        if !(next > low.part && next < high.part) {
            next = 0.5 * (low.part + high.part);
            if next <= low.part || next >= high.part {
                return high.part;
            }
        }
        part = next;
    }
}

/// About where the cubic through two points is zero: the secant, improved twice.
fn zero_of_cubic(low: &Sample, high: &Sample) -> f64 {
    let width = high.part - low.part;
    let (start, end) = (width * low.slope, width * high.slope);
    let change = high.value - low.value;
    let square = 3.0 * change - 2.0 * start - end;
    let cube = start + end - 2.0 * change;
    let mut x = -low.value / change;
    for _ in 0..3 {
        let value = low.value + x * (start + x * (square + x * cube));
        let slope = start + x * (2.0 * square + 3.0 * x * cube);
        x = (x - value / slope).clamp(0.0, 1.0);
    }
    match x.is_nan() {
        true => low.part + 0.5 * width,
        false => low.part + x * width,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fall(value: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> Option<f64> {
        let sample = |part| Sample { part, value: value(part), slope: slope(part) };
        first_fall(sample(0.0), sample(1.0), 0, &sample)
    }

    #[test]
    fn a_fall_is_found_to_the_last_bits() {
        let found = fall(|x| 2.0 - x.exp(), |x| -x.exp()).unwrap();
        assert!((found - 2f64.ln()).abs() < 4e-16, "{found}");
    }

    #[test]
    fn the_first_of_two_crossings_within_a_step_is_found() {
        let found = fall(|x| (x - 0.3).powi(2) - 1e-4, |x| 2.0 * (x - 0.3)).unwrap();
        assert!((found - 0.29).abs() < 1e-14, "{found}");
    }

    #[test]
    fn a_rise_is_none() {
        assert_eq!(fall(|x| x - 0.5, |_| 1.0), None);
        assert_eq!(fall(|x| x, |_| 1.0), None);
    }
}
