//! Values and ranges of dimensions and parameters as people read them.

use assur_model::checked::{ConstantInfo, QuantityInfo};

use crate::docs::plain;

/// Documentation of a field: `Crank radius. 75 mm ± 0.05 mm; here in SI units.`
pub fn field(constant: &ConstantInfo) -> String {
    let summary = plain(constant.quantity.summary.trim()).trim_end_matches('.').to_owned();
    let summary = if summary.is_empty() {
        if constant.is_dimension { "Dimension".to_owned() } else { "Parameter".to_owned() }
    } else {
        summary
    };
    let mut text = format!("{summary}: `{}`", value(constant));
    let range = range(constant);
    if !range.is_empty() {
        text += &format!(", `{range}`");
    }
    match constant.quantity.factor {
        1.0 => text + ".",
        factor => {
            text + &format!(
                "; stored in SI units, `{}` is {}.",
                constant.quantity.unit,
                neat(factor)
            )
        }
    }
}

/// `75 mm ± 0.05 mm`
pub fn value(constant: &ConstantInfo) -> String {
    let shown = |value: f64| shown(&constant.quantity, value);
    let mut text = shown(constant.default);
    if constant.tolerance != 0.0 {
        text += &format!(" ± {}", shown(constant.tolerance));
    }
    text
}

/// `in 60 mm .. 90 mm`, nothing when both ends are open.
pub fn range(constant: &ConstantInfo) -> String {
    let (low, high) = constant.range;
    if low.is_infinite() && high.is_infinite() {
        return String::new();
    }
    let shown = |value: f64| shown(&constant.quantity, value);
    format!("in {} .. {}", shown(low), shown(high))
}

/// A value in the unit of its quantity.
fn shown(quantity: &QuantityInfo, value: f64) -> String {
    let text = format!("{} {}", neat(value / quantity.factor), quantity.unit);
    text.trim_end().to_owned()
}

/// A number with at most twelve digits, so that `0.075/0.001` is 75.
fn neat(value: f64) -> String {
    let rounded = format!("{value:.11e}").parse().unwrap_or(value);
    let size = f64::abs(rounded);
    if size == 0.0 || (1e-4..1e7).contains(&size) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}
