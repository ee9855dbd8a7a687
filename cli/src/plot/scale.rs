//! From values to pixels, and back.

/// A straight scale between values and pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Values at both ends.
    pub values: (f64, f64),
    /// Pixels at both ends; the first may be the larger one, as it is upwards.
    pub pixels: (f64, f64),
}

impl Scale {
    /// The pixel of a value.
    pub fn pixel(&self, value: f64) -> f64 {
        let share = (value - self.values.0) / (self.values.1 - self.values.0);
        self.pixels.0 + share * (self.pixels.1 - self.pixels.0)
    }

    /// Whether a value lies between the ends, rounding permitted.
    pub fn contains(&self, value: f64) -> bool {
        let slack = 1e-9 * (self.values.1 - self.values.0).abs();
        value >= self.values.0.min(self.values.1) - slack
            && value <= self.values.0.max(self.values.1) + slack
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_meet_ends() {
        let scale = Scale { values: (-1.0, 3.0), pixels: (100.0, 20.0) };
        assert_eq!((scale.pixel(-1.0), scale.pixel(3.0), scale.pixel(1.0)), (100.0, 20.0, 60.0));
        assert!(scale.contains(3.0) && !scale.contains(3.1));
    }
}
