//! What stands behind `--over`.

use assur::registry::SceneEntry;

use crate::ask::lookup::suggestion;
use crate::ask::permitted::permitted;
use crate::ask::values::{quantity, split};
use crate::error::Failure;

/// Most values along one range.
const MOST: usize = 100_000;

/// Values that are gone through.
#[derive(Clone, Debug)]
pub struct Range {
    /// The constant, by index.
    pub constant: usize,
    /// The values, SI units.
    pub values: Vec<f64>,
}

/// The constant of a name, by index.
///
/// # Errors
/// When the scene has none; the nearest name is offered.
pub fn constant(scene: &SceneEntry, name: &str, option: &str) -> Result<usize, Failure> {
    let names: Vec<&str> = scene.constants.iter().map(|one| one.quantity.name).collect();
    names.iter().position(|one| *one == name).ok_or_else(|| {
        if scene.drivers.iter().any(|driver| driver.name == name) {
            return Failure::request(format!("`{name}` is a driver of scene `{}`", scene.name))
                .place(option.to_owned())
                .reason("a study goes over dimensions and parameters")
                .remedy(format!("let it stand where its value says: add --hold {name}"));
        }
        Failure::request(format!("scene `{}` has no dimension or parameter `{name}`", scene.name))
            .place(option.to_owned())
            .remedy(suggestion(name, &names))
    })
}

/// Reads an `--over`, of so many values unless it says how many.
///
/// # Errors
/// An unknown name, a wrong unit or number, a value out of its range.
pub fn read(scene: &SceneEntry, text: &str, unless_said: Option<usize>) -> Result<Range, Failure> {
    const EXAMPLE: &str = "'omega=200..400[1/s]:41'";
    let place = format!("--over {text}");
    let (name, rest) = split(text, "--over", EXAMPLE)?;
    let index = constant(scene, name, &place)?;
    let entry = &scene.constants[index];
    let usual = unless_said.map(|count| count.to_string());
    let parts = rest.rsplit_once(':').or_else(|| Some((rest, usual.as_deref()?)));
    let parts = parts.and_then(|(range, count)| {
        let (from, to) = range.split_once("..")?;
        Some((from.trim(), to.trim(), count.trim()))
    });
    let Some((from, to, count)) = parts else {
        let count = if usual.is_some() { "[:COUNT]" } else { ":COUNT" };
        return Err(Failure::request(format!("--over takes NAME=FROM..TO{count}"))
            .place(place)
            .remedy(format!("for example: --over {EXAMPLE}")));
    };
    let count: usize =
        count.parse().ok().filter(|count| (2..=MOST).contains(count)).ok_or_else(|| {
            Failure::request(format!("`{count}` is no number of values"))
                .place(place.clone())
                .remedy(format!("give a whole number from 2 to {MOST} after the colon"))
        })?;
    // `10..80N` means newtons on both sides.
    let is_number = |one: char| one.is_ascii_digit() || "+-.eE ".contains(one);
    let unit = to.trim_start_matches(is_number);
    let number = &to[..to.len() - unit.len()];
    let has_unit = !unit.is_empty() && number.contains(|one: char| one.is_ascii_digit());
    let from = match from.ends_with(is_number) && has_unit {
        true => format!("{from}{unit}"),
        false => from.to_owned(),
    };
    let mut ends = [0.0; 2];
    // The last end is read first: it may have the unit of both.
    for (end, text) in ends.iter_mut().zip([from.as_str(), to]).rev() {
        *end = quantity(text, &entry.quantity).map_err(|failure| {
            let failure = failure.place(place.clone());
            failure.remedy(format!("for example: --over {EXAMPLE}"))
        })?;
        permitted(entry, *end).map_err(|failure| failure.place(place.clone()))?;
    }
    let [from, to] = ends;
    if from == to {
        return Err(Failure::request("the range has no length")
            .place(place)
            .remedy("give two different ends, or use --set"));
    }
    let last = (count - 1) as f64;
    let value = |number: usize| match number as f64 == last {
        true => to,
        false => from + (to - from) * (number as f64 / last),
    };
    Ok(Range { constant: index, values: (0..count).map(value).collect() })
}
