//! Which values a dimension or parameter may take.

use assur::shape::Constant;

use crate::ask::variables::Dimension;
use crate::error::Failure;
use crate::show::number;

/// Whether a constant may take a value: its declared range decides; where none is declared, masses, lengths and speeds
/// stay above zero if the file has them above zero.
pub fn permitted(constant: &Constant, value: f64) -> Result<(), Failure> {
    let quantity = &constant.quantity;
    let show = |value: f64| {
        format!("{} {}", number::short(value / quantity.factor), quantity.unit)
            .trim_end()
            .to_owned()
    };
    let (low, high) = constant.range;
    if value < low || value > high {
        let range = match (low.is_finite(), high.is_finite()) {
            (true, true) => format!("from {} to {}", show(low), show(high)),
            (true, false) => format!("{} or more", show(low)),
            _ => format!("{} or less", show(high)),
        };
        return Err(Failure::request(format!("`{}` cannot be {}", quantity.name, show(value)))
            .reason(format!("the file permits {range}"))
            .remedy(format!("give a value {range}")));
    }
    let declared = low.is_finite() || high.is_finite();
    if value <= 0.0 && constant.default > 0.0 && !declared {
        let kind = kind(quantity.dimension, constant.is_dimension);
        if let Some(kind) = kind {
            return Err(Failure::request(format!("`{}` cannot be {}", quantity.name, show(value)))
                .reason(format!("{kind} is positive"))
                .remedy(format!(
                    "give a value above zero; the default is {}",
                    show(constant.default)
                )));
        }
    }
    Ok(())
}

/// What a quantity is that cannot be zero or negative.
fn kind(dimension: Dimension, is_dimension: bool) -> Option<&'static str> {
    let exponents: Vec<_> =
        dimension.iter().map(|(up, down)| f64::from(*up) / f64::from((*down).max(1))).collect();
    match exponents[..3] {
        [0.0, 1.0, 0.0] => Some("a mass"),
        [2.0, 1.0, 0.0] => Some("a moment of inertia"),
        [1.0, 0.0, 0.0] if is_dimension => Some("a length"),
        [0.0, 0.0, -1.0] | [1.0, 0.0, -1.0] => Some("a speed"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::style::Style;
    use assur::shape::{Distribution, Quantity};

    /// A decay rate of 30 1/s.
    fn rate(range: (f64, f64)) -> Constant {
        Constant {
            quantity: Quantity {
                name: "lambda1",
                summary: "",
                unit: "1/s",
                factor: 1.0,
                dimension: [(0, 1), (0, 1), (-1, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
            },
            is_dimension: false,
            default: 30.0,
            tolerance: 0.0,
            distribution: Distribution::Uniform,
            range,
        }
    }

    #[test]
    fn a_declared_range_decides_alone() {
        let rate = rate((0.0, 1e6));
        assert_eq!(permitted(&rate, 0.0), Ok(()));
        let refused = permitted(&rate, -1.0).expect_err("below the range");
        let text = refused.render(Style::PLAIN);
        assert!(text.contains("the file permits from 0 1/s to 1000000 1/s"), "{text}");
    }

    #[test]
    fn without_a_range_a_speed_is_positive() {
        let refused = permitted(&rate((f64::NEG_INFINITY, f64::INFINITY)), 0.0);
        let text = refused.expect_err("no range").render(Style::PLAIN);
        assert!(text.contains("a speed is positive"), "{text}");
    }
}
