//! The answer as tables to read.

use std::path::Path;

use assur::study::cost::{MadeTrial, Way};

use super::{Cost, Errs, name};
use crate::ask::wanted::Wanted;
use crate::cost::table::spread;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Adds the tables to a page.
pub fn render(page: &mut Page, cost: &Cost, figure: Option<&Path>) {
    let case = &cost.case;
    page.about(&case.constants, &format!("what accuracy costs: {}", case.task_in_words()));
    if cost.position.is_finite() {
        let time = number::duration(cost.position);
        page.line(&match case.is_sheet() {
            true => format!("A set of values takes {time}, to rounding."),
            false => {
                format!("A position takes {time}, at any accuracy: loops are closed to rounding.")
            }
        });
        page.line("");
    }
    roundings(page, cost);
    match &cost.errs {
        Some(errs) => spreads(page, cost, errs),
        None => {
            page.line(
                "Nothing has a tolerance in this scene; with one, `dimension l4 = 90 mm +- 0.05 mm;`, it is told what the spread of an output takes.",
            );
            if let Some(wanted) = &cost.wanted {
                rounded(page, cost, wanted);
            }
        }
    }
    page.figure(figure);
    page.line(&format!("It took {}.", number::duration(cost.seconds)));
}

/// What roundings make of each output.
fn roundings(page: &mut Page, cost: &Cost) {
    let mut table =
        Columns::new([("", Align::Left), ("by roundings", Align::Left), ("unit", Align::Left)]);
    let outputs = cost.case.scene.outputs.iter().zip(&cost.roundings);
    for (output, rounding) in outputs {
        let text = match rounding.error.is_finite() {
            true => number::error(rounding.error / output.factor),
            false => "not known".to_owned(),
        };
        table.row([output.name.to_owned(), text, output.unit.to_owned()]);
    }
    page.section(
        "How far outputs may be off as values are rounded, at most over the range",
        &table,
    );
}

/// Whether roundings leave the accuracy that is asked for: there is but one way to an output.
fn rounded(page: &mut Page, cost: &Cost, wanted: &Wanted) {
    let words = wanted.words(&[cost.case.scene.outputs[cost.output]]);
    let share = cost.rounded(wanted);
    let times = number::significant(share, 2);
    match share {
        share if share.is_nan() => page.warn(&format!("of {words} nothing is known")),
        share if share > 1.0 => page.warn(&format!(
            "nothing reaches {words}: roundings make {times} times what is permitted"
        )),
        _ => page.line(&format!(
            "For {words}: every value, at the cost above; roundings make {times} of what is permitted."
        )),
    }
}

/// What it takes to find how an output errs.
fn spreads(page: &mut Page, cost: &Cost, errs: &Errs) {
    let mut table = Columns::new([
        ("way", Align::Left),
        ("linkages", Align::Right),
        ("time", Align::Right),
        ("middle half", Align::Right),
        ("mean", Align::Point),
        ("standard deviation", Align::Point),
        ("error", Align::Left),
        ("error, %", Align::Left),
        ("", Align::Left),
    ]);
    let deviation = errs.made.reference.1.deviation;
    let front = errs.front();
    for (index, trial) in errs.made.trials.iter().enumerate() {
        let error = errs.error(trial);
        let own = |value: f64| number::significant(value / errs.unit.factor, 5);
        table.row([
            name(trial.way).to_owned(),
            linkages(trial.way),
            number::duration(trial.times.median),
            spread(&trial.times),
            own(trial.found.mean),
            own(trial.found.deviation),
            number::error(error / errs.unit.factor),
            number::error(100.0 * error / deviation),
            if front.contains(&index) { "*" } else { "" }.to_owned(),
        ]);
    }
    let at = cost.case.label(&errs.place);
    let heading = format!(
        "How {} errs by the tolerances at {at}, where it errs most, {}",
        errs.output.name, errs.unit.name
    );
    page.section(&heading, &table);
    let (way, _) = errs.made.reference;
    let from = match way {
        Way::Made(_) => format!("{} linkages made at random", linkages(way)),
        _ => format!("the {}", name(way)),
    };
    page.line(&format!(
        "Errors are differences of mean or standard deviation from {from}, which is known to {}; of linkages made at random at least their confidence of 95 %. Times are medians of {} rounds in turns, with the middle half of them.",
        format!("{} {}", number::error(errs.made.doubt / errs.unit.factor), errs.unit.name).trim_end(),
        errs.made.rounds
    ));
    if let Some(wanted) = &cost.wanted {
        answer(page, errs, wanted);
    }
    page.line(&format!(
        "As it is made, {} errs by {} (standard deviation), at worst by {}: positions more accurate than that are of no use.",
        errs.output.name,
        errs.unit.text(deviation),
        errs.unit.text(errs.linear.worst)
    ));
}

fn linkages(way: Way) -> String {
    match way {
        Way::Made(linkages) => number::count(linkages as usize),
        _ => String::new(),
    }
}

/// What is cheapest for the accuracy that is asked for.
fn answer(page: &mut Page, errs: &Errs, wanted: &Wanted) {
    let words = wanted.words(&[*errs.output]);
    let called = |trial: &MadeTrial| match trial.way {
        Way::Made(_) => format!("{} linkages made at random", linkages(trial.way)),
        way => format!("the {}", name(way)),
    };
    match errs.cheapest(wanted, 1.0) {
        Some(found) => {
            page.line(&format!(
                "For the spread of {words}: {}, with an error of {} of what is permitted, in {}.",
                called(found),
                number::significant(errs.share(wanted, errs.error(found)), 2),
                number::duration(found.times.median)
            ));
            match errs.cheapest(wanted, 0.1) {
                Some(finer) if finer.way != found.way => page.line(&format!(
                    "Ten times more accuracy takes {:.2} times as long: {} in {}.",
                    finer.times.median / found.times.median,
                    called(finer),
                    number::duration(finer.times.median)
                )),
                Some(_) => page.line("Ten times more accuracy takes the same."),
                None => page.line("Nothing that was tried is ten times more accurate."),
            }
        }
        None => page.warn(&match errs.nearest() {
            Some(nearest) => format!(
                "nothing reaches the spread of {words}; nearest is {}, to {} times what is permitted",
                called(nearest),
                number::significant(errs.share(wanted, errs.error(nearest)), 3)
            ),
            None => format!("of {words} nothing is known"),
        }),
    }
}
