//! The answer of `assur study --format csv`: one row a run, what was varied and the measures; an empty field where a
//! run does not have a measure.

use super::answer::Answer;
use super::question::{Question, Way};
use super::table::headed;
use crate::unit;

/// All rows, with the last line ended.
pub fn render(question: &Question, answer: &Answer) -> String {
    let constants = question.scene.constants;
    let varied: Vec<usize> = match &question.way {
        Way::Grid(ranges) => ranges.iter().map(|range| range.constant).collect(),
        Way::Random(drawn, ..) => {
            (0..drawn.len()).filter(|index| drawn[*index].tolerance > 0.0).collect()
        }
    };
    let quoted = |text: String| format!("\"{}\"", text.replace('"', "\"\""));
    let names = varied.iter().map(|index| headed(&constants[*index].quantity));
    let measures = question.measures.iter();
    let names = names.chain(measures.map(|index| headed(&question.scene.measures[*index])));
    let mut text = names.map(quoted).collect::<Vec<_>>().join(",") + ",\"failure\"\n";
    for run in 0..question.count() {
        let values = question.values(run);
        let given = varied
            .iter()
            .map(|index| unit::stated(values[*index], constants[*index].quantity.factor));
        let found = question.measures.iter();
        let found = found.map(|index| {
            unit::stated(answer.value(run, *index), question.scene.measures[*index].factor)
        });
        let cells = given.chain(found).map(|value| match value.is_finite() {
            true => format!("{value}"),
            false => String::new(),
        });
        let reason = answer.outcomes[run].as_ref().err().cloned().unwrap_or_default();
        text += &cells.collect::<Vec<_>>().join(",");
        text += &format!(",{}\n", if reason.is_empty() { reason } else { quoted(reason) });
    }
    text
}
