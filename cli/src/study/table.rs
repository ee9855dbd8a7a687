//! The answer as tables to read.

use std::path::Path;

use assur::shape::Quantity;
use assur::study;

use super::answer::{Answer, CONFIDENCE};
use super::question::{Plan, Question};
use crate::ask::range::Range;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Most rows of a table.
const ROWS: usize = 60;

/// All tables.
pub fn render(page: &mut Page, question: &Question, answer: &Answer, figure: Option<&Path>) {
    page.about(&question.constants, &format!("{} runs", question.count()));
    match &question.way {
        Plan::Grid(ranges) => match ranges.as_slice() {
            [along, up] => maps(page, question, answer, (along, up)),
            ranges => curves(page, question, answer, &ranges[0]),
        },
        Plan::Random(..) => spreads(page, question, answer),
    }
    failures(page, question, answer);
    page.figure(figure);
    let seconds = number::duration(answer.seconds);
    page.line(&format!(
        "{} runs took {seconds}, without estimates of their errors: `assur run` with a value has these.",
        question.count()
    ));
}

/// A name with its unit.
pub fn headed(quantity: &Quantity) -> String {
    match quantity.unit {
        "" => quantity.name.to_owned(),
        unit => format!("{}, {unit}", quantity.name),
    }
}

fn percent(share: f64) -> String {
    format!("{} %", number::short((1e3 * share).round() / 10.0))
}

/// A value of a measure.
pub fn shown(value: f64, quantity: &Quantity) -> String {
    match value.is_finite() {
        true => number::significant(value / quantity.factor, 6),
        false => "none".to_owned(),
    }
}

/// A row for each value.
fn curves(page: &mut Page, question: &Question, answer: &Answer, range: &Range) {
    let constant = &question.scene.constants[range.constant].quantity;
    let all = question.scene.measures;
    let headings: Vec<String> = std::iter::once(headed(constant))
        .chain(question.measures.iter().map(|index| headed(&all[*index])))
        .collect();
    let columns = headings.iter().map(|heading| (heading.as_str(), Align::Point));
    let mut table = Columns::new(columns);
    let stride = range.values.len().div_ceil(ROWS);
    for (run, value) in range.values.iter().enumerate().step_by(stride) {
        let measures = question.measures.iter();
        let cells = measures.map(|index| shown(answer.value(run, *index), &all[*index]));
        table.row(std::iter::once(number::short(value / constant.factor)).chain(cells));
    }
    let heading = match stride {
        1 => "Measures".to_owned(),
        _ => format!("Measures, every {stride}th run (--format csv has all)"),
    };
    page.section(&heading, &table);
}

/// For each measure a table with one value along and one down.
fn maps(page: &mut Page, question: &Question, answer: &Answer, (along, down): (&Range, &Range)) {
    let constants = question.scene.constants;
    let quantities = [along, down].map(|range| &constants[range.constant].quantity);
    let skip = (along.values.len().div_ceil(12), down.values.len().div_ceil(ROWS));
    for index in &question.measures {
        let measure = &question.scene.measures[*index];
        let first = format!("{} \\ {}", headed(quantities[1]), headed(quantities[0]));
        let tops = along.values.iter().step_by(skip.0);
        let tops: Vec<String> =
            tops.map(|value| number::short(value / quantities[0].factor)).collect();
        let columns = std::iter::once((first.as_str(), Align::Point))
            .chain(tops.iter().map(|top| (top.as_str(), Align::Point)));
        let mut table = Columns::new(columns);
        for (row, value) in down.values.iter().enumerate().step_by(skip.1) {
            let runs = (0..along.values.len()).step_by(skip.0);
            let cells = runs.map(|column| {
                let value = answer.value(row * along.values.len() + column, *index);
                match value.is_finite() {
                    true => number::significant(value / measure.factor, 4),
                    false => "none".to_owned(),
                }
            });
            let cells = cells.collect::<Vec<_>>();
            table.row(std::iter::once(number::short(value / quantities[1].factor)).chain(cells));
        }
        page.section(&headed(measure), &table);
    }
}

/// What the values of each measure say together.
fn spreads(page: &mut Page, question: &Question, answer: &Answer) {
    let mut table = Columns::new([
        ("measure", Align::Left),
        ("mean", Align::Point),
        ("±", Align::Point),
        ("deviation", Align::Point),
        ("least", Align::Point),
        ("10 %", Align::Point),
        ("median", Align::Point),
        ("90 %", Align::Point),
        ("greatest", Align::Point),
        ("unit", Align::Left),
        ("runs", Align::Right),
    ]);
    for (index, spread) in question.measures.iter().zip(&answer.spreads) {
        let measure = &question.scene.measures[*index];
        let Some(spread) = spread else {
            table.row([measure.name.to_owned(), "none".to_owned()]);
            continue;
        };
        let show = |value: f64| shown(value, measure);
        let half = (spread.mean.high - spread.mean.low) / 2.0;
        table.row([
            measure.name.to_owned(),
            show(spread.mean.value),
            number::error(half / measure.factor),
            number::error(spread.deviation / measure.factor),
            show(spread.least),
            show(spread.quantiles[1].1),
            show(spread.quantiles[2].1),
            show(spread.quantiles[3].1),
            show(spread.greatest),
            measure.unit.to_owned(),
            number::count(spread.count),
        ]);
    }
    let heading = format!("Measures (± {} of the mean)", number::percent(CONFIDENCE));
    page.section(&heading, &table);
}

/// Runs that did not come out.
fn failures(page: &mut Page, question: &Question, answer: &Answer) {
    let Some((first, reason)) = answer.first_failure() else {
        return;
    };
    let (failed, count) = (answer.failures(), question.count());
    let share = study::share(failed, count, CONFIDENCE);
    let values = question.values(first);
    let given: Vec<String> = match &question.way {
        Plan::Grid(ranges) => ranges
            .iter()
            .map(|range| {
                let quantity = &question.scene.constants[range.constant].quantity;
                let value = number::short(values[range.constant] / quantity.factor);
                format!("{} = {value} {}", quantity.name, quantity.unit).trim_end().to_owned()
            })
            .collect(),
        Plan::Random(..) => vec![format!("run {first}")],
    };
    page.line(&format!(
        "{failed} of {count} runs did not come out ({}, with 95 % between {} and {}). The first, {}: {reason}",
        percent(share.value),
        percent(share.low),
        percent(share.high),
        given.join(", ")
    ));
}
