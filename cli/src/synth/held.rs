//! What holds the designs, as tables to read.

use super::{Found, Proposal};
use assur::study::Polish;
use assur::synthesis::End;

use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// What is known of the designs as best ones, and what holds the first.
pub fn render(page: &mut Page, found: &Found, most: usize) {
    let mut table = Columns::new([
        ("design", Align::Point),
        ("places", Align::Point),
        ("conditions", Align::Point),
        ("bounds", Align::Point),
        ("free", Align::Point),
        ("least curvature", Align::Point),
        ("", Align::Left),
    ]);
    for (number, proposal) in (1..).zip(found.designs.iter().take(most)) {
        let mut row = vec![number.to_string()];
        match &proposal.polish {
            Some(polish) => row.extend(counts(found, polish)),
            None => row.extend(["", "", "", "", ""].map(str::to_owned)),
        }
        row.push(verdict(proposal).to_owned());
        table.row(row);
    }
    page.section("What holds them", &table);
    if let Some(polish) = found.designs.first().and_then(|best| best.polish.as_ref()) {
        best(page, found, polish);
    }
}

/// How many places and conditions hold a design, how many values are at a bound, what these leave free.
fn counts(found: &Found, polish: &Polish) -> [String; 5] {
    let is_place = |measure: usize| measure == found.synthesis.objective;
    let places = polish.held.iter().filter(|one| is_place(one.measure)).count();
    let conditions = polish.held.len() - places;
    let curvature = polish.curvature.map(|one| number::significant(one, 3));
    [
        places.to_string(),
        conditions.to_string(),
        polish.bounds.len().to_string(),
        polish.free.to_string(),
        curvature.unwrap_or_default(),
    ]
}

/// Whether a design is a best one, in words.
pub fn verdict(proposal: &Proposal) -> &'static str {
    let Some(polish) = &proposal.polish else {
        return "not polished: its neighbours are not known or no better, or it was stopped";
    };
    if !proposal.candidate.score.is_kept() {
        return "misses conditions, and nothing near by was found that keeps them";
    }
    match (polish.end, polish.free, polish.curvature) {
        (End::Looks, ..) => "more could be gained: it was not polished to the end",
        (End::Stuck, ..) => "polished as far as slopes can be trusted",
        (_, 0, _) => "no neighbour is better: held in all directions",
        (_, _, Some(curvature)) if curvature > 0.0 => "no neighbour is better",
        (_, _, Some(_)) => "level in some direction, or better farther on",
        _ => "no neighbour is better to first order",
    }
}

/// What holds the best design.
fn best(page: &mut Page, found: &Found, polish: &Polish) {
    let way = found.way;
    let head = way.map_or_else(|| "at".to_owned(), |way| format!("{} [{}]", way.name, way.unit));
    let mut table = Columns::new([
        ("", Align::Left),
        (head.as_str(), Align::Point),
        ("multiplier", Align::Point),
        ("", Align::Left),
    ]);
    for one in &polish.held {
        let quantity = found.measure(one.measure);
        let at = one.at.map(|at| number::significant(at / way.map_or(1.0, |way| way.factor), 7));
        let (multiplier, unit) = match one.measure == found.synthesis.objective {
            true => (one.multiplier, String::new()),
            false => found.cost((one.measure, one.multiplier)),
        };
        let multiplier = number::significant(multiplier, 4);
        table.row([quantity.name.to_owned(), at.unwrap_or_default(), multiplier, unit]);
    }
    for (place, gain) in &polish.bounds {
        let Some(quantity) = found.varied().nth(*place) else { continue };
        let end = if *gain > 0.0 { "upper" } else { "lower" };
        table.row([
            format!("{} at its {end} bound", quantity.name),
            String::new(),
            String::new(),
            String::new(),
        ]);
    }
    if !(polish.held.is_empty() && polish.bounds.is_empty()) {
        page.section("What holds the first one", &table);
    }
}
