//! The groups of a linkage as comma-separated values: one row a group, in the order of solution.

use super::Structure;
use crate::linkage::group;
use crate::show::csv::{cell, line, quoted};

/// The whole table.
pub fn render(structure: &Structure) -> String {
    let entry = &structure.entry;
    let heading = ["loops", "unknowns", "kind", "assembly mode", "transmission [deg]"];
    let mut text = line(heading.map(str::to_owned));
    for (index, of_group) in entry.groups.iter().enumerate() {
        let found = structure.found(index, of_group);
        let number = |value: Option<f64>| cell(value.unwrap_or(f64::NAN));
        text += &line([
            quoted(&group::equations(entry, of_group)),
            quoted(&group::unknowns(entry, of_group)),
            group::kind(of_group.kind).to_owned(),
            number(found.mode),
            number(found.angle),
        ]);
    }
    text
}
