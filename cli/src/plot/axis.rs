//! Round numbers along an axis.

use super::name::raise;

/// Ticks at round numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Ends of the axis.
    pub ends: (f64, f64),
    /// Values of the ticks.
    pub ticks: Vec<f64>,
    /// Decimals that the ticks need.
    decimals: usize,
}

impl Axis {
    /// An axis that contains all values, its ends at round numbers, with about this many intervals.
    pub fn around(low: f64, high: f64, intervals: usize) -> Self {
        let (low, high) = widen(low, high);
        let step = round_step((high - low) / intervals as f64);
        // A value that passes a tick by a hair does not cost a whole interval.
        let slack = 0.02 * step;
        let first = ((low + slack) / step).floor();
        let last = ((high - slack) / step).ceil();
        let mut axis = Self::with_step(first * step, last * step, step);
        axis.ends = (low.min(axis.ends.0), high.max(axis.ends.1));
        axis
    }

    /// An axis with exactly these ends.
    pub fn between(low: f64, high: f64, intervals: usize) -> Self {
        let (low, high) = widen(low, high);
        Self::with_step(low, high, round_step((high - low) / intervals as f64))
    }

    /// An axis of an angle in degrees with exactly these ends.
    pub fn degrees(low: f64, high: f64, intervals: usize) -> Self {
        let (low, high) = widen(low, high);
        let wanted = (high - low) / intervals as f64;
        let steps = [5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0, 720.0];
        let step = steps.into_iter().find(|step| *step >= 0.8 * wanted).filter(|_| wanted >= 4.0);
        Self::with_step(low, high, step.unwrap_or_else(|| round_step(wanted)))
    }

    fn with_step(low: f64, high: f64, step: f64) -> Self {
        let slack = 1e-9 * (high - low);
        let first = ((low - slack) / step).ceil() as i64;
        let last = ((high + slack) / step).floor() as i64;
        Self {
            ends: (low, high),
            ticks: (first..=last).take(100).map(|index| index as f64 * step).collect(),
            decimals: (-(step * 1.0001).log10().floor()).clamp(0.0, 12.0) as usize,
        }
    }

    /// The text of a tick, with a proper minus sign and thousands set apart.
    pub fn label(&self, value: f64) -> String {
        if value.abs() >= 1e6 {
            let text = format!("{value:e}").replace('-', "−");
            return text.split_once('e').map_or(text.clone(), |(front, power)| {
                format!("{front}·10{}", superscript(power))
            });
        }
        let text = format!("{:.*}", self.decimals, value.abs());
        let (whole, fraction) = text.split_at(text.find('.').unwrap_or(text.len()));
        let mut grouped = String::new();
        for (index, digit) in whole.chars().enumerate() {
            if index > 0 && whole.len() > 4 && (whole.len() - index) % 3 == 0 {
                grouped.push('\u{2009}');
            }
            grouped.push(digit);
        }
        let zero = text.chars().all(|character| matches!(character, '0' | '.'));
        format!("{}{grouped}{fraction}", if value < 0.0 && !zero { "−" } else { "" })
    }
}

/// Two different finite ends.
fn widen(low: f64, high: f64) -> (f64, f64) {
    if !(low.is_finite() && high.is_finite()) {
        return (0.0, 1.0);
    }
    if high - low > 1e-12 * low.abs().max(high.abs()) {
        return (low, high);
    }
    let room = if low == 0.0 { 1.0 } else { 0.1 * low.abs() };
    (low - room, high + room)
}

/// 1, 2 or 5 times a power of ten, the first that is no smaller than wanted.
fn round_step(wanted: f64) -> f64 {
    let power = 10f64.powf(wanted.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    let factor = steps.into_iter().find(|factor| factor * power >= wanted * 0.999).unwrap_or(10.0);
    factor * power
}

fn superscript(power: &str) -> String {
    power.chars().map(raise).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(axis: &Axis, labels: &[&str]) {
        let found: Vec<_> = axis.ticks.iter().map(|tick| axis.label(*tick)).collect();
        assert_eq!(found, labels);
    }

    #[test]
    fn ticks_are_round() {
        check(&Axis::around(-2.1, 2.05, 4), &["−4", "−2", "0", "2", "4"]);
        check(&Axis::around(0.0, 150.67, 4), &["0", "50", "100", "150"]);
        check(&Axis::around(-0.0037, 0.0037, 4), &["−0.004", "−0.002", "0.000", "0.002", "0.004"]);
    }

    #[test]
    fn degrees_have_their_own_round_numbers() {
        check(&Axis::degrees(0.0, 360.0, 6), &["0", "60", "120", "180", "240", "300", "360"]);
        check(
            &Axis::degrees(0.0, 720.0, 8),
            &["0", "90", "180", "270", "360", "450", "540", "630", "720"],
        );
    }

    #[test]
    fn nothing_and_absurdities_have_an_axis_too() {
        check(&Axis::around(0.0, 0.0, 2), &["−1", "0", "1"]);
        assert!(!Axis::around(f64::NAN, 1.0, 4).ticks.is_empty());
        check(&Axis::around(0.0, 2e7, 2), &["0", "1·10⁷", "2·10⁷"]);
        check(&Axis::around(0.0, 20000.0, 2), &["0", "10\u{2009}000", "20\u{2009}000"]);
    }
}
