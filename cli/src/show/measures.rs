//! Numbers of the whole task.

use assur::measure::Missing;
use assur::registry::SceneEntry;
use assur::shape::Quantity;
use serde::Serialize;

use super::json::{Reading, number as finite};
use super::page::{Page, first_line};
use super::text::{Align, Columns};
use super::{number, unit};

/// A number of the whole task.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Name and unit.
    pub quantity: &'static Quantity,
    /// Its value, SI units, or why there is none.
    pub value: Result<f64, Missing>,
    /// Its estimated error, SI units; NaN where there is none.
    pub error: f64,
}

/// A measure as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Measure {
    #[serde(flatten)]
    pub found: Reading,
    /// Why there is no value.
    #[serde(skip_serializing_if = "Option::is_none")]
    missing: Option<String>,
}

/// The measures of a scene with what was found of them and its errors.
pub fn of(
    scene: &SceneEntry,
    found: impl IntoIterator<Item = (Result<f64, Missing>, f64)>,
) -> Vec<Measured> {
    let measures = scene.measures.iter().zip(found);
    measures.map(|(quantity, (value, error))| Measured { quantity, value, error }).collect()
}

/// The table of all measures.
pub fn section(page: &mut Page, scene: &SceneEntry, measures: &[Measured]) {
    if measures.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("measure", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("estimated error", Align::Point),
        ("", Align::Left),
    ]);
    for measure in measures {
        let quantity = measure.quantity;
        let (value, error, text) = match measure.value {
            Ok(value) => (
                number::with_error(
                    unit::stated(value, quantity.factor),
                    unit::stated(measure.error.max(1e-10 * value.abs()), quantity.factor),
                ),
                number::error(unit::stated(measure.error, quantity.factor)),
                first_line(quantity.summary).to_owned(),
            ),
            Err(missing) => {
                ("none".to_owned(), String::new(), format!("since {}", text(scene, missing)))
            }
        };
        table.row([quantity.name.to_owned(), value, quantity.unit.to_owned(), error, text]);
    }
    page.section("Measures of the whole task", &table);
}

/// All measures as objects.
pub fn objects(scene: &SceneEntry, measures: &[Measured]) -> Vec<Measure> {
    let one = measures.iter().map(|measure| {
        let quantity = measure.quantity;
        let stated = |value: f64| finite(unit::stated(value, quantity.factor));
        Measure {
            found: Reading {
                name: quantity.name.to_owned(),
                unit: quantity.unit.to_owned(),
                value: measure.value.ok().and_then(stated),
                estimated_error: stated(measure.error),
            },
            missing: measure.value.err().map(|missing| text(scene, missing)),
        }
    });
    one.collect()
}

/// Why there is none, with the names of the modes.
fn text(scene: &SceneEntry, missing: Missing) -> String {
    let modes: Vec<_> = scene.modes.iter().map(|mode| mode.name).collect();
    missing.text(&modes)
}
