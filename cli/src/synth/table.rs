//! The answer as tables to read.

use std::path::Path;

use super::{Found, held};
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Most designs side by side.
const DESIGNS: usize = 6;

/// All tables.
pub fn render(page: &mut Page, found: &Found, figure: Option<&Path>) {
    page.about(&found.constants, "synthesis");
    problem(page, found);
    designs(page, found);
    held::render(page, found, DESIGNS);
    for (number, proposal) in (1..).zip(found.designs.iter().take(DESIGNS)) {
        page.line(&proposal.preset(found, number));
    }
    if found.designs.len() > DESIGNS {
        page.line(&format!("{} more are in --format json.", found.designs.len() - DESIGNS));
    }
    for (number, proposal) in (1..).zip(found.designs.iter().take(DESIGNS)) {
        if let Some(contradiction) = &proposal.contradiction {
            page.warn(&format!("Design {number} is put together {contradiction}."));
        }
    }
    if let Some(figure) = figure {
        page.line(&format!("Figure: {}", figure.display()));
    }
    page.line("");
    let seconds = number::duration(found.seconds);
    let each = number::duration(found.seconds / found.evaluations.max(1) as f64);
    let judged = number::count(found.evaluations as usize);
    page.line(&format!("{judged} designs were judged in {seconds}, {each} each."));
    if found.designs.iter().any(|one| !one.candidate.is_gathered) {
        page.line("Not every search had come to an end: --evaluations may find better ones.");
    }
}

/// The problem in words.
fn problem(page: &mut Page, found: &Found) {
    let objective = found.measure(found.synthesis.objective);
    page.line(&format!("Made small: {}", objective.name));
    if let Some(solved) = found.synthesis.solved {
        let names = found.varied().skip(found.synthesis.chosen()).map(|one| one.name);
        let names: Vec<&str> = names.collect();
        let text =
            format!("Solved for: {} from {}, by least squares", names.join(", "), solved.text);
        page.line(&format!("{text}; then polished with the others"));
    }
    for index in found.synthesis.conditions {
        let quantity = found.measure(*index);
        let text = if quantity.summary.is_empty() { "" } else { ", " };
        page.line(&format!("Kept:       {}{text}{}", quantity.name, quantity.summary));
    }
    for (index, cost) in found.synthesis.preferences {
        let quantity = found.measure(*index);
        let (cost, unit) = found.cost((*index, *cost));
        let cost = format!("{} {unit}", number::short(cost));
        let text = if quantity.summary.is_empty() { "" } else { ", " };
        let price = format!("else {} of what is missed is added", cost.trim_end());
        page.line(&format!("Preferred:  {}{text}{}; {price}", quantity.name, quantity.summary));
    }
    page.line("");
}

fn designs(page: &mut Page, found: &Found) {
    let shown: Vec<_> = found.designs.iter().take(DESIGNS).collect();
    let headings: Vec<String> =
        (1..=shown.len()).map(|number| format!("design {number}")).collect();
    let columns = |first: &[(&'static str, Align)]| {
        let own = headings.iter().map(|heading| (heading.as_str(), Align::Point));
        Columns::new(first.iter().copied().chain(own).collect::<Vec<_>>())
    };
    let mut table = columns(&[
        ("", Align::Left),
        ("from", Align::Point),
        ("to", Align::Point),
        ("", Align::Left),
    ]);
    for (place, (quantity, range)) in found.varied().zip(found.synthesis.varied).enumerate() {
        let end = |value: f64| number::short(value / quantity.factor);
        let values = shown.iter().map(|one| one.candidate.design[place] / quantity.factor);
        let values = values.map(|value| number::significant(value, 8));
        let first =
            [quantity.name.to_owned(), end(range.from), end(range.to), quantity.unit.to_owned()];
        table.row(first.into_iter().chain(values).collect::<Vec<_>>());
    }
    page.section("Designs", &table);
    let mut table = columns(&[("", Align::Left), ("", Align::Left)]);
    for (index, quantity) in found.measures() {
        let name = match index == found.synthesis.objective {
            true => quantity.name.to_owned(),
            false => format!("left of {}", quantity.name),
        };
        if found.synthesis.preferences.first().is_some_and(|one| one.0 == index) {
            let objective = found.measure(found.synthesis.objective);
            let worth = shown.iter().map(|one| {
                let measure = |index| one.measure(index).0;
                let worth = found.synthesis.worth(measure(found.synthesis.objective), measure);
                number::significant(worth / objective.factor, 6)
            });
            let first =
                ["with what is missed of preferences".to_owned(), objective.unit.to_owned()];
            table.row(first.into_iter().chain(worth).collect::<Vec<_>>());
        }
        let values = shown.iter().map(|one| {
            let (value, error) = one.measure(index);
            let (value, error) = (value / quantity.factor, error / quantity.factor);
            match (value.is_finite(), error.is_finite()) {
                (false, _) => "none".to_owned(),
                (true, false) => number::significant(value, 6),
                (true, true) => number::with_error(value, error),
            }
        });
        let first = [name, quantity.unit.to_owned()];
        table.row(first.into_iter().chain(values).collect::<Vec<_>>());
        if index == found.synthesis.objective && shown.iter().any(|one| one.made.is_some()) {
            let made = shown.iter().map(|one| {
                let made = one.made.map(|made| number::significant(made / quantity.factor, 6));
                made.unwrap_or_default()
            });
            let first = ["made within tolerances".to_owned(), quantity.unit.to_owned()];
            table.row(first.into_iter().chain(made).collect::<Vec<_>>());
        }
    }
    page.section("What they come to", &table);
}
