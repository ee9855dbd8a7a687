//! The answer of `assur modes --format json`: one object.
//!
//! | field | contents |
//! |---|---|
//! | `format` | `"assur-modes/1"` |
//! | `mechanism`, `scene`, `parameters` | as in [`crate::json`] |
//! | `status` | `"complete"` when all lists are certainly complete, else `"incomplete"` |
//! | `places` | each `place` in words, `drivers`, `outside`, `complete`, `undecided` (places of the search), `boxes`, `modes`, `declared` (index of the mode that the start values pick, or null), `unreached` (why that mode does not get there, or null) |
//!
//! A mode has `declared`, `results` (`name`, `unit`, `value`), `groups` (`loops`, `unknowns`, `kind`, `sign` of the
//! determinant as 1, -1 or 0, `sine`, `transmission`, `unit`) and `residuals` (`loop`, `value`, `unit`).

use serde_json::{Value, json};

use super::{Answer, Found, sign};
use crate::json::{mechanism, parameters, scene};
use crate::linkage::group;
use crate::unit;
use assur::registry::Listed;

/// The object, with its last line ended.
pub fn render(answer: &Answer) -> String {
    let case = &answer.case;
    let complete = answer.found.iter().all(|found| found.listing.complete);
    let places = answer.found.iter().map(|found| place(answer, found));
    let object = json!({
        "format": "assur-modes/1",
        "mechanism": mechanism(answer.mechanism),
        "scene": scene(&case.constants),
        "parameters": parameters(&case.constants),
        "status": if complete { "complete" } else { "incomplete" },
        "places": places.collect::<Vec<_>>(),
        "statistics": { "seconds": answer.seconds },
    });
    // A `Value` has only text keys and finite numbers, so printing it cannot fail.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

fn place(answer: &Answer, found: &Found) -> Value {
    let listing = &found.listing;
    let drivers = answer.case.drivers.iter().zip(&found.place.independents);
    let drivers = drivers.map(|(driver, position)| {
        json!({ "name": driver.name, "unit": driver.unit, "value": unit::stated(*position, driver.factor) })
    });
    let modes = listing.modes.iter().enumerate();
    let modes = modes.map(|(index, one)| mode(answer, one, listing.declared == Some(index)));
    json!({
        "place": found.place.label,
        "drivers": drivers.collect::<Vec<_>>(),
        "outside": found.place.outside,
        "complete": listing.complete,
        "undecided": listing.undecided,
        "boxes": listing.boxes,
        "modes": modes.collect::<Vec<_>>(),
        "declared": listing.declared,
        "unreached": found.unreached.as_ref().map(|told| told.reason.as_str()),
    })
}

fn mode(answer: &Answer, mode: &Listed, declared: bool) -> Value {
    let (case, entry) = (&answer.case, answer.case.entry);
    let results = case.variables.iter().zip(answer.values(mode));
    let results = results.map(
        |(variable, value)| json!({ "name": variable.name, "unit": variable.unit, "value": value }),
    );
    let groups = entry.groups.iter().zip(&mode.sines).map(|(one, sine)| {
        json!({
            "loops": group::equations(entry, one),
            "unknowns": group::unknowns(entry, one),
            "kind": group::kind(one.kind),
            "sign": match sign(*sine) { "+" => 1, "-" => -1, _ => 0 },
            "sine": sine,
            "transmission": group::transmits(one).then(|| group::transmission(*sine)),
            "unit": "deg",
        })
    });
    let residuals = entry.loops.iter().zip(&mode.residuals);
    let residuals = residuals
        .map(|(of, left)| json!({ "loop": of.name, "value": unit::stated(*left, of.factor), "unit": of.unit }));
    json!({
        "declared": declared,
        "results": results.collect::<Vec<_>>(),
        "groups": groups.collect::<Vec<_>>(),
        "residuals": residuals.collect::<Vec<_>>(),
    })
}
