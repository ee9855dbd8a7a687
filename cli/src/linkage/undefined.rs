//! Why an output of a formula sheet is no number: its equations once more, operation by operation.

use assur_model::program::Configuration;

use super::case::Case;
use crate::show::style::Style;
use crate::source::Source;

/// Which operation has no value at a place, in words; none where the equations are not at hand or do not tell.
pub fn tell(case: &Case, place: &[f64]) -> Option<String> {
    let mechanism = case.constants.mechanism;
    if mechanism.text.is_empty() {
        return None;
    }
    let source = Source::new(mechanism.file, mechanism.text, mechanism.parts);
    let checked = source.compile(Style::PLAIN).ok()?;
    let model = checked.compiled.model.as_ref()?;
    let scene = model.scenes.iter().find(|scene| scene.name == case.scene.name)?;
    let at = Configuration { drivers: place, ..Configuration::default() };
    let values = scene.program.evaluate_linkage(&case.constants.values, 0.0, &at);
    let outputs = scene.program.results.outputs.iter().zip(&scene.outputs);
    let mut lacking = outputs.filter(|(value, _)| values.get(**value).is_nan());
    let (value, output) = lacking.next()?;
    let undefined = scene.program.undefined(&values, *value)?;
    let of = match undefined.quantity.filter(|name| *name != output.name) {
        Some(quantity) => format!("`{}` needs `{quantity}`, and that", output.name),
        None => format!("`{}`", output.name),
    };
    let what = output.summary.lines().next().unwrap_or("").trim_end_matches('.');
    let what = if what.is_empty() { String::new() } else { format!(" ({what})") };
    Some(format!("{of}{what} has no value: {} is no number", undefined.operation))
}
