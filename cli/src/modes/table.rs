//! The modes as tables to read.

use assur::closure::{GroupKind, Listed};

use super::{Found, Modes};
use crate::linkage::group;
use crate::show::number;
use crate::show::page::{Page, WIDTH};
use crate::show::text::{Align, Columns, wrap};

/// Digits of a value.
const DIGITS: usize = 7;
/// Beside values of the same kind this part of them is rounding.
const NOISE: f64 = 1e-14;

/// All tables.
pub fn render(page: &mut Page, answer: &Modes) {
    page.about(&answer.case.constants, "assembly modes");
    groups(page, answer);
    for found in &answer.found {
        modes(page, answer, found);
    }
    page.line(&format!("Found in {}.", number::duration(answer.seconds)));
}

/// The groups whose determinants have the signs below.
fn groups(page: &mut Page, answer: &Modes) {
    let entry = answer.case.moved.entry;
    let mut table = Columns::new([
        ("group", Align::Right),
        ("loops", Align::Left),
        ("for", Align::Left),
        ("solved as", Align::Left),
    ]);
    for (index, one) in entry.groups.iter().enumerate() {
        table.row([
            (index + 1).to_string(),
            group::equations(entry, one),
            group::unknowns(entry, one),
            group::kind(one.kind).to_owned(),
        ]);
    }
    page.section("Groups of loops, in the order of solution", &table);
}

fn modes(page: &mut Page, answer: &Modes, found: &Found) {
    let count = match found.listing.modes.len() {
        0 => "no assembly mode".to_owned(),
        1 => "1 assembly mode".to_owned(),
        count => format!("{count} assembly modes"),
    };
    let heading = format!("At {}: {count}", found.place.label);
    // As many columns as there are modes or variables, whichever is less.
    let table = match found.listing.modes.len() < answer.case.variables.len() {
        true => standing(answer, found),
        false => lying(answer, found),
    };
    page.table(&heading, &table);
    remarks(page, answer, found);
    page.line("");
}

/// What marks the mode that is meant.
const MEANT: &str = "declared";

/// A column for each mode.
fn standing(answer: &Modes, found: &Found) -> Columns {
    let entry = answer.case.moved.entry;
    let modes = &found.listing.modes;
    let numbers: Vec<_> = (1..=modes.len()).map(|number| number.to_string()).collect();
    let numbers = numbers.iter().map(|number| (number.as_str(), Align::Point));
    let columns = [("mode", Align::Left)].into_iter().chain(numbers);
    let mut table = Columns::new(columns.chain([("", Align::Left), ("", Align::Left)]));
    let mut row = |name: &str, cells: Vec<String>, unit: &str, remark: String| {
        let cells = [name.to_owned()].into_iter().chain(cells);
        table.row(cells.chain([unit.to_owned(), remark]));
    };
    let values: Vec<_> = modes.iter().map(|mode| texts(answer, mode)).collect();
    for (index, variable) in answer.case.variables.iter().enumerate() {
        let cells = values.iter().map(|texts| texts[index].clone());
        row(&variable.name, cells.collect(), &variable.unit, variable.summary.clone());
    }
    for (index, one) in entry.groups.iter().enumerate() {
        let signs = modes.iter().map(|mode| sign(mode.sines[index]).to_owned());
        let name = format!("sign {}", index + 1);
        row(&name, signs.collect(), "", group::equations(entry, one));
    }
    let angles = modes.iter().map(|mode| transmission(answer, mode));
    row("transmission", angles.collect(), "deg", String::new());
    let gaps = modes.iter().map(|mode| gap(answer, mode));
    row("gap left", gaps.collect(), "", String::new());
    let meant = (0..modes.len()).map(|index| match found.listing.declared == Some(index) {
        true => "yes".to_owned(),
        false => String::new(),
    });
    row("declared", meant.collect(), "", String::new());
    table
}

/// A row for each mode.
fn lying(answer: &Modes, found: &Found) -> Columns {
    let variables = answer.case.variables.iter();
    let headings = variables.map(|one| match one.unit.as_str() {
        "" => one.name.clone(),
        unit => format!("{}, {unit}", one.name),
    });
    let headings: Vec<_> = headings.collect();
    let columns = headings.iter().map(|heading| (heading.as_str(), Align::Point));
    let columns = [("", Align::Right), ("signs", Align::Left)].into_iter().chain(columns).chain([
        ("transmission, deg", Align::Point),
        ("gap left", Align::Left),
        ("", Align::Left),
    ]);
    let mut table = Columns::new(columns);
    for (index, mode) in found.listing.modes.iter().enumerate() {
        let signs: Vec<_> = mode.sines.iter().map(|sine| sign(*sine)).collect();
        let mut row = vec![(index + 1).to_string(), signs.join(" ")];
        row.extend(texts(answer, mode));
        row.extend([transmission(answer, mode), gap(answer, mode)]);
        row.push(match found.listing.declared == Some(index) {
            true => MEANT.to_owned(),
            false => String::new(),
        });
        table.row(row);
    }
    table
}

/// The values of a mode; what is rounding beside others of its kind is zero.
fn texts(answer: &Modes, mode: &Listed) -> Vec<String> {
    let variables = &answer.case.variables;
    let values = answer.values(mode);
    let size = |index: usize| (values[index] * variables[index].factor).abs();
    let text = |index: usize| {
        let alike = |other: &usize| variables[*other].dimension == variables[index].dimension;
        let others = (0..values.len()).filter(alike).map(size);
        match size(index) <= NOISE * others.fold(0.0, f64::max) {
            true => "0".to_owned(),
            false => number::significant(values[index], DIGITS),
        }
    };
    (0..values.len()).map(text).collect()
}

fn transmission(answer: &Modes, mode: &Listed) -> String {
    let angle = worst(answer, &mode.sines);
    angle.map_or(String::new(), |angle| format!("{angle:.3}"))
}

fn gap(answer: &Modes, mode: &Listed) -> String {
    let Some((index, gap)) = Modes::gap(mode) else {
        return String::new();
    };
    let of = &answer.case.moved.entry.loops[index];
    format!("{} {}", number::error(gap / of.factor), of.unit)
}

/// The smallest transmission angle, in degrees.
fn worst(answer: &Modes, sines: &[f64]) -> Option<f64> {
    let groups = answer.case.moved.entry.groups.iter().zip(sines);
    let transmitting = groups.filter(|(one, _)| group::transmits(one));
    transmitting.map(|(_, sine)| group::transmission(*sine)).reduce(f64::min)
}

/// Whether these are all, and what becomes of the mode that is meant.
fn remarks(page: &mut Page, answer: &Modes, found: &Found) {
    let listing = &found.listing;
    let said = match (listing.complete, listing.undecided) {
        (true, _) => format!("There is no other{}.", within(answer)),
        (false, 1) => "Perhaps not all: one place of the search could not be decided; modes meet there, or nearly."
            .to_owned(),
        (false, count) => format!(
            "Perhaps not all: {} places of the search could not be decided; modes meet there, or nearly.",
            number::count(count)
        ),
    };
    let mut lines = vec![(said, !listing.complete)];
    if let Some(told) = &found.unreached {
        lines.push((
            format!("The mode of the start values does not get here: {}.", told.reason),
            true,
        ));
    }
    lines.extend(found.place.outside.iter().map(|one| (one.clone(), true)));
    for (text, warns) in lines {
        for line in wrap(&text, WIDTH) {
            let line = match warns {
                true => page.style.warn(&format!("  {line}")),
                false => format!("  {line}"),
            };
            page.line(&line);
        }
    }
}

/// How far displacements of loops that are closed together were looked for.
fn within(answer: &Modes) -> String {
    let entry = answer.case.moved.entry;
    let mut searched = entry
        .groups
        .iter()
        .filter(|one| one.kind == GroupKind::General)
        .flat_map(|one| one.unknowns);
    let is_length = |index: &usize| entry.dependents[*index].dimension[0].0 != 0;
    match searched.any(is_length) {
        true => " with displacements within 10 m".to_owned(),
        false => String::new(),
    }
}

/// The sign of a determinant as a text.
fn sign(sine: f64) -> &'static str {
    match super::sign(sine) {
        1 => "+",
        -1 => "-",
        _ => "0",
    }
}
