//! The modes as comma-separated values: one row a mode. Columns: the drivers, every variable, the sign of the determinant and
//! the transmission angle of each group, what is left of each loop equation, and 1 in the row of the mode that the start values
//! pick.

use assur::closure::Listed;

use super::{Found, Modes, sign};
use crate::linkage::group;
use crate::show::csv::{cell, cells, line, title, titles};
use crate::show::unit;

/// The whole table.
pub fn render(answer: &Modes) -> String {
    let (case, entry) = (&answer.case, answer.case.moved.entry);
    let variables = case.variables.iter().map(|one| title(&one.name, &one.unit));
    let groups = entry.groups.iter().flat_map(|one| {
        let loops = group::equations(entry, one);
        let of = |what: &str, unit: &str| title(&format!("{what}({loops})"), unit);
        [of("sign", ""), of("transmission", "deg")]
    });
    let loops = entry.loops.iter().map(|of| title(&format!("gap({})", of.name), of.unit));
    let heading = titles(&case.drivers).chain(variables).chain(groups).chain(loops);
    let mut text = line(heading.chain(["declared".to_owned()]));
    for found in &answer.found {
        for (index, mode) in found.listing.modes.iter().enumerate() {
            let declared = found.listing.declared == Some(index);
            text += &row(answer, found, mode, declared);
        }
    }
    text
}

fn row(answer: &Modes, found: &Found, mode: &Listed, declared: bool) -> String {
    let (case, entry) = (&answer.case, answer.case.moved.entry);
    let groups = entry.groups.iter().zip(&mode.sines).flat_map(|(one, sine)| {
        let angle = group::transmits(one).then(|| group::transmission(*sine));
        [sign(*sine).to_string(), cell(angle.unwrap_or(f64::NAN))]
    });
    let left = entry.loops.iter().zip(&mode.residuals);
    let left = left.map(|(of, left)| cell(unit::stated(*left, of.factor)));
    let values = answer.values(mode).into_iter().map(cell);
    let start = cells(&case.drivers, &found.place.independents).chain(values);
    line(start.chain(groups).chain(left).chain([u8::from(declared).to_string()]))
}
