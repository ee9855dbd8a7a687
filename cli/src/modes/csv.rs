//! The modes as comma-separated values: one heading with names and units, one row a mode. Columns: the drivers, every
//! variable, the sign of the determinant and the transmission angle of each group, what is left of each loop equation,
//! and 1 in the row of the mode that the start values pick.

use super::{Answer, Found, sign};
use crate::csv::{cell, title};
use crate::linkage::group;
use crate::unit;
use assur::registry::Listed;

/// The whole table.
pub fn render(answer: &Answer) -> String {
    let (case, entry) = (&answer.case, answer.case.entry);
    let drivers = case.drivers.iter();
    let mut heading: Vec<_> = drivers.map(|one| title(one.name, one.unit)).collect();
    heading.extend(case.variables.iter().map(|one| title(&one.name, &one.unit)));
    for one in entry.groups {
        let loops = group::equations(entry, one);
        heading.push(title(&format!("sign({loops})"), ""));
        heading.push(title(&format!("transmission({loops})"), "deg"));
    }
    let loops = entry.loops.iter();
    heading.extend(loops.map(|of| title(&format!("gap({})", of.name), of.unit)));
    heading.push("declared".to_owned());
    let mut text = heading.join(",") + "\n";
    for found in &answer.found {
        for (index, mode) in found.listing.modes.iter().enumerate() {
            let declared = found.listing.declared == Some(index);
            text += &row(answer, found, mode, declared);
        }
    }
    text
}

fn row(answer: &Answer, found: &Found, mode: &Listed, declared: bool) -> String {
    let case = &answer.case;
    let drivers = case.drivers.iter().zip(&found.place.independents);
    let mut cells: Vec<_> =
        drivers.map(|(driver, position)| cell(unit::stated(*position, driver.factor))).collect();
    cells.extend(answer.values(mode).into_iter().map(cell));
    for (one, sine) in case.entry.groups.iter().zip(&mode.sines) {
        let sign = match sign(*sine) {
            "+" => "1",
            "-" => "-1",
            _ => "0",
        };
        cells.push(sign.to_owned());
        let angle = group::transmits(one).then(|| group::transmission(*sine));
        cells.push(cell(angle.unwrap_or(f64::NAN)));
    }
    let left = case.entry.loops.iter().zip(&mode.residuals);
    cells.extend(left.map(|(of, left)| cell(unit::stated(*left, of.factor))));
    cells.push(u8::from(declared).to_string());
    cells.join(",") + "\n"
}
