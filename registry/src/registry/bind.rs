//! Values of a scene, checked and fixed.

use assur_solvers::model::{Bound, Model};
use assur_solvers::problem::{Refused, Scene};
use assur_solvers::shape::{Constant, Quantity};

use super::unit::stated;

/// Checks the values of a scene and prepares it.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind<C: Scene>(scene: C) -> Result<Box<dyn Model>, Refused> {
    scene.check()?;
    Ok(Box::new(Bound::new(&scene)))
}

/// The scene with these values, SI units.
///
/// # Errors
/// If there are not as many as the scene has constants.
#[doc(hidden)]
pub fn with<C, const N: usize>(values: &[f64], make: fn(&[f64; N]) -> C) -> Result<C, Refused> {
    match values.try_into() {
        Ok(values) => Ok(make(values)),
        Err(_) => Err(Refused {
            name: "number of values".to_owned(),
            reason: format!("found {}, expected {N}", values.len()),
        }),
    }
}

/// Checks that values are finite and in their ranges.
///
/// # Errors
/// The first that is not, with the range in its unit.
pub fn check_values(constants: &[Constant], values: &[f64]) -> Result<(), Refused> {
    for (constant, value) in constants.iter().zip(values) {
        let quantity = &constant.quantity;
        let shown = |value: f64| shown(quantity, value);
        let (low, high) = constant.range;
        let expected = match (low.is_finite(), high.is_finite()) {
            _ if !value.is_finite() => "a finite value".to_string(),
            _ if (low..=high).contains(value) => continue,
            (true, true) => format!("{} to {}", shown(low), shown(high)),
            (true, false) => format!("{} or more", shown(low)),
            _ => format!("{} or less", shown(high)),
        };
        return Err(Refused {
            name: quantity.name.to_string(),
            reason: format!("found {}, expected {expected}", shown(*value)),
        });
    }
    Ok(())
}

/// That values do not meet a condition on them, `found R = 75 mm, l = 70 mm; expected R < l`: by its name, or else the
/// condition itself. The indices are of the constants that stand in it.
#[doc(hidden)]
pub fn unmet(
    constants: &[Constant],
    values: &[f64],
    indices: &[usize],
    (name, condition): (&str, &str),
) -> Refused {
    let found = indices.iter().filter_map(|index| {
        let quantity = &constants.get(*index)?.quantity;
        Some(format!("{} = {}", quantity.name, shown(quantity, *values.get(*index)?)))
    });
    let found: Vec<String> = found.collect();
    let found = match found.as_slice() {
        [] => String::new(),
        found => format!("found {}; ", found.join(", ")),
    };
    let name = if name.is_empty() { condition } else { name };
    Refused { name: name.to_owned(), reason: format!("{found}expected {condition}") }
}

/// A value in the unit of its quantity.
fn shown(quantity: &Quantity, value: f64) -> String {
    format!("{} {}", stated(value, quantity.factor), quantity.unit).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const MASS: Constant = Constant {
        quantity: Quantity {
            name: "m",
            summary: "",
            unit: "g",
            factor: 1e-3,
            dimension: [(0, 1); 7],
        },
        is_dimension: false,
        default: 1e-3,
        tolerance: 0.0,
        distribution: assur_solvers::shape::Distribution::Normal,
        range: (1e-6, 10.0),
    };

    #[track_caller]
    fn check(value: f64, expected: &str) {
        let refused = check_values(&[MASS], &[value]).unwrap_err();
        assert_eq!(refused.to_string(), expected);
    }

    #[test]
    fn values_outside_their_range_are_refused_in_their_unit() {
        check(-1e-3, "m: found -1 g, expected 0.001 g to 10000 g");
        check(f64::NAN, "m: found NaN g, expected a finite value");
        check(f64::INFINITY, "m: found inf g, expected a finite value");
        assert_eq!(check_values(&[MASS], &[2e-3]), Ok(()));
    }
}
