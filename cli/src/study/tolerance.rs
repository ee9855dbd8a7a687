//! What stands behind `--tolerance` of a study.

use assur::registry::SceneEntry;
use assur::shape::Constant;

use crate::ask::constants::Constants;
use crate::ask::range;
use crate::ask::tolerances::{Given, named_in};
use crate::ask::values::once;
use crate::error::Failure;

/// The constants of a scene as they are made: with the tolerances that are asked for, about the values that they have.
///
/// # Errors
/// An unknown name, one that is given twice, or what is no tolerance.
pub fn made(
    texts: &[String],
    scene: &SceneEntry,
    values: &Constants,
) -> Result<Vec<Constant>, Failure> {
    let mut constants = scene.constants.to_vec();
    let mut given = Vec::new();
    for text in texts {
        let place = format!("--tolerance {text}");
        let (name, width) = named_in(text)?;
        let index = range::constant(scene, name, &place)?;
        let what = format!("the tolerance of `{name}`");
        once(&mut given, index, &what, &place)?;
        let constant = &mut constants[index];
        let asked = Given::read(width, &constant.quantity, values.values[index])
            .map_err(|failure| failure.place(place))?;
        constant.tolerance = asked.half_width;
        constant.distribution = asked.distribution.unwrap_or(constant.distribution);
    }
    for (constant, value) in constants.iter_mut().zip(&values.values) {
        constant.distribution = constant.distribution.about(constant.tolerance, *value);
    }
    Ok(constants)
}
