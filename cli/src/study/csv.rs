//! A study as comma-separated values: one row a run, what was varied and the measures; an empty field where a run does not have
//! a measure.

use super::answer::Answer;
use super::question::{Plan, Question};
use crate::show::csv::{cell, line, quoted, title};
use crate::show::unit;

/// All rows.
pub fn render(question: &Question, answer: &Answer) -> String {
    let (constants, measures) = (question.scene.constants, question.scene.measures);
    let varied: Vec<usize> = match &question.way {
        Plan::Grid(ranges) => ranges.iter().map(|range| range.constant).collect(),
        Plan::Random(drawn, ..) => {
            (0..drawn.len()).filter(|index| drawn[*index].tolerance > 0.0).collect()
        }
    };
    let of_constants = varied.iter().map(|index| &constants[*index].quantity);
    let of_measures = question.measures.iter().map(|index| &measures[*index]);
    let names = of_constants.chain(of_measures).map(|one| title(one.name, one.unit));
    let mut text = line(names.chain(["failure".to_owned()]));
    for run in 0..question.count() {
        let values = question.values(run);
        let given = varied
            .iter()
            .map(|index| unit::stated(values[*index], constants[*index].quantity.factor));
        let found = question.measures.iter();
        let found =
            found.map(|index| unit::stated(answer.value(run, *index), measures[*index].factor));
        let reason = answer.outcomes[run].as_ref().err().map_or("", String::as_str);
        text += &line(given.chain(found).map(cell).chain([quoted(reason)]));
    }
    text
}
