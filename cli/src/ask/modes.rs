//! What stands behind `--mode`.

use assur::closure::Search;

use super::constants::Constants;
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::linkage::place;

/// The statement that puts a linkage together in the assembly mode of a number, as `assur modes` has it where the drivers
/// start.
///
/// # Errors
/// When the scene is no linkage, or there is no such mode.
pub fn start(constants: Constants, number: u64) -> Result<String, Failure> {
    let option = format!("--mode {number}");
    if constants.scene.linkage.is_none() {
        return Err(Failure::request(format!(
            "scene `{}` moves by its equations of motion, where start values pick the assembly mode",
            constants.scene.name
        ))
        .place(option)
        .remedy("say where a dependent coordinate starts, roughly: --start psi=100deg"));
    }
    let case = Case::new(constants)?;
    let place = place::start(&case)?;
    let listing = case.run().modes(&place.independents, &Search::default());
    let listing =
        listing.map_err(|error| case.tell(&error).failure("the modes cannot be listed"))?;
    let mode = usize::try_from(number - 1).ok().and_then(|index| listing.modes.get(index));
    let Some(mode) = mode else {
        let (name, count) = (case.constants.mechanism.name, listing.modes.len());
        let at = if place.label.is_empty() { "" } else { " at " };
        return Err(Failure::request(format!("there is no assembly mode {number}"))
            .place(option)
            .reason(format!("there are {count}{at}{}, where the drivers start", place.label))
            .remedy(format!("`assur modes {name} --scene {}` shows them", case.scene.name)));
    };
    let pairs = case.moved.entry.dependents.iter().zip(&mode.dependents);
    let starts = pairs.map(|(dependent, value)| {
        format!("{} = {:e} [{}]", dependent.name, value / dependent.factor, dependent.unit)
            .replace(" []", "")
    });
    Ok(format!("start {};", starts.collect::<Vec<_>>().join(", ")))
}
