//! The structure of a linkage as tables to read.

use super::Structure;
use crate::linkage::group;
use crate::show::number;
use crate::show::page::{Page, first_line};
use crate::show::text::{Align, Columns};
use crate::show::unit;

/// All tables.
pub fn render(page: &mut Page, structure: &Structure) {
    page.about(&structure.constants, "structure");
    page.line(&mobility(structure));
    if let Some(scene) = structure.constants.scene.unreduced
        && let Some(held) = scene.augmented
    {
        page.line(&format!(
            "Where a loop comes to a dead point the motion goes on with {} coordinates, held by {} closures.",
            held.coordinates,
            held.loops.len(),
        ));
    }
    if !structure.constants.scene.felt.is_empty() {
        page.line(&format!(
            "Friction depends on the forces of {}: they are found together.",
            structure.constants.scene.felt.join(", ")
        ));
    }
    page.line("");
    loops(page, structure);
    coordinates(page, structure);
    order(page, structure);
}

/// The degrees of freedom in words.
fn mobility(structure: &Structure) -> String {
    let (equations, unknowns, drivers) = structure.counts();
    if !structure.coordinates.is_empty() {
        return reduction(structure);
    }
    let many = |count: usize, what: &str| match count {
        1 => format!("1 {what}"),
        _ => format!("{count} {what}s"),
    };
    let freedom = match drivers {
        1 => "1 degree of freedom".to_owned(),
        _ => format!("{drivers} degrees of freedom"),
    };
    if equations == 0 {
        return format!(
            "{freedom}: {} and no loop; the outputs are formulas",
            many(drivers, "driver")
        );
    }
    let names: Vec<_> = structure.drivers.iter().map(|driver| driver.name).collect();
    let (moves, rest) = match drivers {
        0 => ("nothing moves it".to_owned(), "everything"),
        1 => (format!("{} moves it", names[0]), "the rest"),
        _ => (format!("{} move it", names.join(", ")), "the rest"),
    };
    format!(
        "{freedom} = {} + {} - {}: {moves}, the loops determine {rest}.",
        many(unknowns, "unknown"),
        many(drivers, "driver"),
        many(equations, "loop equation"),
    )
}

/// What is independent in a motion, in words.
fn reduction(structure: &Structure) -> String {
    let (equations, unknowns, _) = structure.counts();
    let free = structure.coordinates.len();
    let names: Vec<_> = structure.coordinates.iter().map(|(one, _)| one.name).collect();
    let (freedom, is) = match free {
        1 => ("1 degree of freedom".to_owned(), "is"),
        _ => (format!("{free} degrees of freedom"), "are"),
    };
    if !structure.held.is_empty() {
        let more = match structure.redundant.as_slice() {
            [] => String::new(),
            names => {
                format!(" ({} of {equations}: not {})", structure.independent, names.join(", "))
            }
        };
        return format!(
            "{freedom} = {} coordinates - {} independent loop equations{more}. They have no closed form: all positions are coordinates, which the loops hold by their forces.",
            free + structure.held.len(),
            structure.independent,
        );
    }
    let driven = match structure.drivers.is_empty() {
        true => String::new(),
        false => {
            let names: Vec<_> = structure.drivers.iter().map(|driver| driver.name).collect();
            format!(", {} prescribed", names.join(", "))
        }
    };
    format!(
        "{freedom} = {} coordinates - {equations} loop equations: {} {is} independent{driven}; the rest follows by kinematic coefficients.",
        free + unknowns,
        names.join(", "),
    )
}

fn loops(page: &mut Page, structure: &Structure) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("line", Align::Right),
        ("unit", Align::Left),
        ("", Align::Left),
    ]);
    let mut above = "";
    for (one, text) in structure.entry.loops.iter().zip(structure.texts()) {
        let text = text.map_or("", |text| plain(text.text));
        // The components of a vector equation share it.
        let shown = if text == above { "" } else { text };
        above = text;
        table.row([
            one.name.to_owned(),
            one.line.to_string(),
            one.unit.to_owned(),
            shown.to_owned(),
        ]);
    }
    if !structure.entry.loops.is_empty() {
        page.section("Loops", &table);
    }
}

/// A closure without its keyword and its name.
fn plain(text: &str) -> &str {
    let named = text.strip_prefix("closure ").and_then(|rest| rest.split_once(": "));
    named.map_or(text, |(_, equation)| equation).trim_end_matches(';')
}

fn coordinates(page: &mut Page, structure: &Structure) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("at the start", Align::Point),
        ("", Align::Left),
        ("", Align::Left),
        ("", Align::Left),
    ]);
    let sample = structure.sample();
    let unknown = if structure.coordinates.is_empty() { "unknown" } else { "follows" };
    for (index, driver) in structure.drivers.iter().enumerate() {
        let position = sample.and_then(|sample| sample.independents.get(index));
        let position =
            position.map(|position| number::short(unit::stated(*position, driver.factor)));
        table.row([
            driver.name.to_owned(),
            position.unwrap_or_default(),
            driver.unit.to_owned(),
            "driver".to_owned(),
            first_line(driver.summary).to_owned(),
        ]);
    }
    for (coordinate, start) in &structure.coordinates {
        table.row([
            coordinate.name.to_owned(),
            settled(unit::stated(*start, coordinate.factor)),
            coordinate.unit.to_owned(),
            if structure.held.is_empty() { "independent" } else { "kept at the start" }.to_owned(),
            first_line(coordinate.summary).to_owned(),
        ]);
    }
    for (coordinate, start) in &structure.held {
        table.row([
            coordinate.name.to_owned(),
            settled(unit::stated(*start, coordinate.factor)),
            coordinate.unit.to_owned(),
            "held".to_owned(),
            first_line(coordinate.summary).to_owned(),
        ]);
    }
    for (index, dependent) in structure.entry.dependents.iter().enumerate() {
        let value = sample.and_then(|sample| sample.dependents.get(index));
        let value = value.map(|value| settled(unit::stated(*value, dependent.factor)));
        table.row([
            dependent.name.to_owned(),
            value.unwrap_or_default(),
            dependent.unit.to_owned(),
            unknown.to_owned(),
            first_line(dependent.summary).to_owned(),
        ]);
    }
    page.section("Coordinates", &table);
}

/// A value to seven digits; what is left of zero is zero.
fn settled(value: f64) -> String {
    match value.abs() < 1e-12 {
        true => "0".to_owned(),
        false => number::significant(value, 7),
    }
}

fn order(page: &mut Page, structure: &Structure) {
    if structure.entry.groups.is_empty() {
        return;
    }
    let at = match structure.place.as_str() {
        "" => String::new(),
        place => format!(", at {place}"),
    };
    let heading = page.style.heading(&format!("Order of solution{at}"));
    page.line(&heading);
    for (index, of_group) in structure.entry.groups.iter().enumerate() {
        let found = structure.found(index, of_group);
        page.line(&format!(
            "  {}  {} for {}",
            index + 1,
            group::equations(&structure.entry, of_group),
            group::unknowns(&structure.entry, of_group)
        ));
        page.line(&format!(
            "     {}: {}; {}",
            group::kind(of_group.kind),
            group::links(of_group.kind),
            group::solved(of_group.kind)
        ));
        let picked =
            if found.assumed { "no start value, assumed" } else { "the start values pick" };
        let mode = found.mode.map(|mode| format!("{picked} assembly mode {mode:+}"));
        let angle = found.angle.map(|angle| {
            let angle = number::short(number::rounded(angle, 4));
            format!("transmission angle {angle} deg")
        });
        let both: Vec<_> = mode.into_iter().chain(angle).collect();
        if !both.is_empty() {
            let line = page.style.faint(&format!("     {}", both.join(", ")));
            page.line(&line);
        }
    }
}
