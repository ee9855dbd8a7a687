//! What stands behind `--tolerance` of a study.

use assur::registry::SceneEntry;
use assur::shape::{Constant, Distribution};

use super::range;
use crate::ask::constants::Constants;
use crate::ask::values::{once, quantity, split};
use crate::error::Failure;

/// Gives constants the tolerances that are asked for, normally distributed.
///
/// # Errors
/// An unknown name, one that is given twice, or what is no tolerance.
pub fn give(
    constants: &mut [Constant],
    texts: &[String],
    scene: &SceneEntry,
    values: &Constants,
) -> Result<(), Failure> {
    let mut given = Vec::new();
    for text in texts {
        let place = format!("--tolerance {text}");
        let (name, width) = split(text, "--tolerance", "J2=10%")?;
        let index = range::constant(scene, name, &place)?;
        let what = format!("the tolerance of `{name}`");
        once(&mut given, index, &what, &place)?;
        let tolerance = read(width, &constants[index], values.values[index]);
        constants[index].tolerance = tolerance.map_err(|failure| failure.place(place))?;
        constants[index].distribution = Distribution::Normal;
    }
    Ok(())
}

/// A tolerance, SI units: a part of the value in percent, or a value with its unit.
fn read(width: &str, constant: &Constant, nominal: f64) -> Result<f64, Failure> {
    let name = constant.quantity.name;
    let above = |value: f64| match value.is_finite() && value > 0.0 {
        true => Ok(value),
        false => Err(none(width, name)),
    };
    if let Some(share) = width.strip_suffix('%') {
        let share: f64 = share.trim().parse().map_err(|_| none(width, name))?;
        return above(share / 100.0 * nominal.abs());
    }
    if let Ok(bare) = width.parse() {
        // That its unit lacks is not what to say of a zero.
        above(bare)?;
    }
    quantity(width, &constant.quantity).and_then(above)
}

fn none(width: &str, name: &str) -> Failure {
    Failure::request(format!("`{width}` is no tolerance of `{name}`"))
        .remedy("give a part, `10%`, or a value with its unit, above zero")
}
