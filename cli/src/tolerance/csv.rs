//! The bands over the range as comma-separated values: drivers, output, worst case, standard deviation, contributions.

use super::answer::{Answer, Unit, label};
use super::question::Question;
use crate::show::csv::{cell, cells, line, title, titles};
use crate::show::unit;

/// The whole table.
pub fn render(question: &Question, answer: &Answer) -> String {
    let (unit, output) = (Unit::of(question.output()), question.output());
    let drivers = &question.case.drivers;
    let errors = ["worst case", "standard deviation"].map(|name| title(name, unit.name));
    let sources = 0..question.study.sources.len();
    let sources = sources.map(|source| title(&label(question, source), unit.name));
    let heading = titles(drivers).chain([title(output.name, output.unit)]);
    let mut text = line(heading.chain(errors).chain(sources));
    for (place, linear) in question.study.places.iter().zip(&answer.range) {
        let contributions = linear.contributions.iter().map(|one| one.worst);
        let errors = [linear.worst, linear.deviation].into_iter().chain(contributions);
        let errors = errors.map(|error| cell(unit::stated(error, unit.factor)));
        let value = cell(unit::stated(linear.value, output.factor));
        text += &line(cells(drivers, place).chain([value]).chain(errors));
    }
    text
}
