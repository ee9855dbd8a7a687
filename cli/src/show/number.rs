//! Numbers as people read them: as many digits as are known, points under points.

/// Significant digits of a result whose error is far below them.
const DIGITS: i32 = 10;

/// A value with the digits that its error leaves standing, at most ten; `0` when the error is larger than the value.
pub fn with_error(value: f64, error: f64) -> String {
    if !value.is_finite() {
        return "none".to_owned();
    }
    if value == 0.0 || (error.is_finite() && value.abs() < error) {
        return "0".to_owned();
    }
    // One digit more than the error touches.
    let known = if error > 0.0 { exponent(value) - exponent(error) + 2 } else { DIGITS };
    significant(value, known.clamp(1, DIGITS) as usize)
}

/// A value with this many significant digits; plain from 1e-4 to 1e9, else with an exponent.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "none".to_owned();
    }
    let rounded = format!("{value:.*e}", digits.saturating_sub(1));
    let exponent: i32 =
        rounded.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0);
    if (-4..9).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0);
        format!("{value:.*}", decimals as usize)
    } else {
        rounded
    }
}

/// A value rounded to this many significant digits.
pub fn rounded(value: f64, digits: usize) -> f64 {
    significant(value, digits).parse().unwrap_or(value)
}

/// The shortest text that means this value to six digits: for values that a person has chosen.
pub fn short(value: f64) -> String {
    let text = significant(value, 6);
    let (mantissa, power) = match text.split_once('e') {
        Some((mantissa, power)) => (mantissa, format!("e{power}")),
        None => (text.as_str(), String::new()),
    };
    if !mantissa.contains('.') {
        return text;
    }
    format!("{}{power}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// A declared value: as many digits as it was written with, at most fifteen; a tiny or huge one with an exponent and at
/// least three digits.
pub fn declared(value: f64) -> String {
    let tidy: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    let plain = format!("{tidy}");
    let tiny = tidy != 0.0 && exponent(tidy) < -4;
    if plain.len() <= 12 && !tiny {
        return plain;
    }
    let shortest = format!("{tidy:e}");
    let digits = shortest.split('e').next().unwrap_or("");
    let digits = digits.chars().filter(char::is_ascii_digit).count();
    format!("{tidy:.*e}", digits.max(3) - 1)
}

/// An error with one or two digits: `3e-12`, `0.05`.
pub fn error(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "unknown".to_owned();
    }
    if (-3..3).contains(&exponent(value)) {
        short(significant(value, 2).parse().unwrap_or(value))
    } else {
        format!("{value:.0e}")
    }
}

/// A duration: `26 ns`, `1.3 ms`, `4.2 s`.
pub fn duration(seconds: f64) -> String {
    let (factor, unit) = match seconds {
        s if s >= 1.0 => (1.0, "s"),
        s if s >= 1e-3 => (1e3, "ms"),
        s if s >= 1e-6 => (1e6, "µs"),
        _ => (1e9, "ns"),
    };
    format!(
        "{} {unit}",
        short(significant(seconds * factor, 2).parse().unwrap_or(seconds * factor))
    )
}

/// A whole number with its thousands set apart by thin gaps.
pub fn count(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) && digits.len() > 4 {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A share in percent, with its sign.
pub fn percent(share: f64) -> String {
    if !share.is_finite() {
        return String::new();
    }
    format!("{} %", signed(share * 100.0, 2))
}

/// A number with its sign and this many digits.
pub fn signed(value: f64, digits: usize) -> String {
    let text = significant(value, digits);
    if value > 0.0 && value.is_finite() { format!("+{text}") } else { text }
}

/// The power of ten of a number: 2 for 314.
pub fn exponent(value: f64) -> i32 {
    value.abs().log10().floor() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_end_where_the_error_begins() {
        assert_eq!(with_error(1.234567890123, 1e-14), "1.234567890");
        assert_eq!(with_error(1.234567890123, 3e-4), "1.23457");
        assert_eq!(with_error(3e-17, 1e-15), "0");
        assert_eq!(with_error(f64::NAN, 0.0), "none");
    }

    #[test]
    fn large_and_small_numbers_have_exponents() {
        assert_eq!(significant(20980.0, 10), "20980.00000");
        assert_eq!(significant(3.8e-6, 3), "3.80e-6");
        assert_eq!(significant(0.9999999, 3), "1.00");
        assert_eq!(short(1.22e-6), "1.22e-6");
        assert_eq!(short(250.0), "250");
    }

    #[test]
    fn declared_values_are_as_written() {
        let rpm = std::f64::consts::PI / 30.0;
        assert_eq!(declared(250.0 * rpm / rpm), "250");
        assert_eq!(declared(0.1004), "0.1004");
        assert_eq!(declared(3.8e-6), "3.80e-6");
        assert_eq!(declared(1.22e-6), "1.22e-6");
        assert_eq!(declared(-0.00037819), "-0.00037819");
        assert_eq!(declared(1e-30), "1.00e-30");
    }

    #[test]
    fn times_and_counts() {
        assert_eq!(duration(26e-9), "26 ns");
        assert_eq!(duration(0.00134), "1.3 ms");
        assert_eq!(duration(120.0), "120 s");
        assert_eq!(count(1234), "1234");
        assert_eq!(count(1234567), "1 234 567");
        assert_eq!(error(3.4e-12), "3e-12");
        assert_eq!(error(0.052), "0.052");
        assert_eq!(percent(0.0123), "+1.2 %");
    }
}
