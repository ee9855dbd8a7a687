//! The bands over the range as comma-separated values: drivers, output, worst case, standard deviation, contributions.

use super::answer::{Answer, Unit, label};
use super::question::Question;
use crate::csv::{cell, title};
use crate::unit;

/// The whole table.
pub fn render(question: &Question, answer: &Answer) -> String {
    let unit = Unit::of(question);
    let drivers = &question.drivers;
    let output = question.output();
    let mut heading: Vec<String> = drivers.iter().map(|one| title(one.name, one.unit)).collect();
    heading.push(title(output.name, output.unit));
    heading.push(title("worst case", unit.name));
    heading.push(title("standard deviation", unit.name));
    let sources = 0..question.study.sources.len();
    heading.extend(sources.map(|source| title(&label(question, source), unit.name)));
    let mut text = heading.join(",") + "\n";
    for (place, linear) in question.study.places.iter().zip(&answer.range) {
        let mut cells: Vec<f64> = drivers
            .iter()
            .zip(place)
            .map(|(driver, value)| unit::stated(*value, driver.factor))
            .collect();
        cells.push(unit::stated(linear.value, output.factor));
        cells.push(unit::stated(linear.worst, unit.factor));
        cells.push(unit::stated(linear.deviation, unit.factor));
        cells.extend(linear.contributions.iter().map(|one| unit::stated(one.worst, unit.factor)));
        let cells: Vec<String> = cells.into_iter().map(cell).collect();
        text += &(cells.join(",") + "\n");
    }
    text
}
