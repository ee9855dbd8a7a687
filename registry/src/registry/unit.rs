//! Values in the units in which they are declared.

/// Whole numbers below it are floating-point numbers.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// A value in SI units as a number of units of this size: the shortest that means the same value, where there is one. So
/// a declared 10.4 mm is 10.4 again, and 30 deg are 30.
pub fn stated(value: f64, factor: f64) -> f64 {
    if factor == 1.0 {
        return value;
    }
    // A factor that is rounded itself, such as that of a degree, leaves a last place open.
    let (plain, slack) = match inverse(factor) {
        Some(parts) => (value * parts, 0.0),
        None => (value / factor, f64::EPSILON * value.abs()),
    };
    let short = format!("{plain:.14e}").parse().unwrap_or(plain);
    if (si(short, factor) - value).abs() <= slack { short } else { plain }
}

/// A number of units of this size in SI units, rounded once: as the language scales what a file declares.
pub fn si(number: f64, factor: f64) -> f64 {
    match inverse(factor) {
        Some(parts) => number / parts,
        None => number * factor,
    }
}

/// The whole number of parts of which such a unit is one: 1000 for a millimetre. A factor of a thousandth is not exact,
/// but its inverse is.
fn inverse(factor: f64) -> Option<f64> {
    let parts = (1.0 / factor).round();
    (parts > 1.0 && parts < EXACT && 1.0 / parts == factor).then_some(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_stated_means_the_value() {
        for k in 1..1000 {
            let value = (f64::from(k) * 0.37).sin();
            for factor in [1e-3, 1e-6, std::f64::consts::PI / 180.0, 1e3, 1.0] {
                let again = si(stated(value, factor), factor);
                assert!((again - value).abs() <= 5e-16 * value.abs(), "{value} {factor}");
            }
        }
        assert!(stated(f64::NAN, 1e-3).is_nan());
        assert_eq!(stated(0.0, 1e-3), 0.0);
        assert_eq!(stated(f64::INFINITY, 1e-3), f64::INFINITY);
    }
}
