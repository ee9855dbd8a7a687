//! The figure of a study: curves over one value, a map over two, or the shares of runs made at random.

use super::answer::Answer;
use super::question::{Plan, Question};
use super::table::headed;
use crate::ask::range::Range;
use crate::plot::{self, Layer, Map, Sheet};

/// Draws it: a panel for each measure, one below the other.
pub fn draw(question: &Question, answer: &Answer) -> String {
    let title = format!("{}, scene {}", question.constants.mechanism.title, question.scene.name);
    let panels = question.measures.iter().map(|index| match &question.way {
        Plan::Grid(ranges) => match ranges.as_slice() {
            [along, up] => Layer::Map(map(question, answer, (along, up), *index)),
            ranges => Layer::Curve(curve(question, answer, &ranges[0], *index)),
        },
        Plan::Random(_, count, _) => Layer::Curve(shares(question, answer, *count, *index)),
    });
    plot::sheets(&title, "", &panels.collect::<Vec<_>>())
}

fn scaled(question: &Question, range: &Range) -> (String, Vec<f64>) {
    let quantity = &question.scene.constants[range.constant].quantity;
    let values = range.values.iter().map(|value| value / quantity.factor);
    (headed(quantity), values.collect())
}

fn curve(question: &Question, answer: &Answer, range: &Range, index: usize) -> Sheet {
    let (along, positions) = scaled(question, range);
    let measure = &question.scene.measures[index];
    let values = (0..positions.len()).map(|run| answer.value(run, index) / measure.factor);
    Sheet { along, up: headed(measure), points: positions.iter().copied().zip(values).collect() }
}

/// The share of runs below each value.
fn shares(question: &Question, answer: &Answer, count: usize, index: usize) -> Sheet {
    let measure = &question.scene.measures[index];
    let values = (0..count).map(|run| answer.value(run, index) / measure.factor);
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let whole = values.len() as f64;
    let points = values.iter().enumerate();
    Sheet {
        along: headed(measure),
        up: "share of the runs below".to_owned(),
        points: points.map(|(place, value)| (*value, (place as f64 + 0.5) / whole)).collect(),
    }
}

fn map(question: &Question, answer: &Answer, (along, up): (&Range, &Range), index: usize) -> Map {
    let measure = &question.scene.measures[index];
    let (x, columns) = scaled(question, along);
    let (y, rows) = scaled(question, up);
    let runs = 0..columns.len() * rows.len();
    Map {
        along: x,
        up: y,
        name: headed(measure),
        values: runs.map(|run| answer.value(run, index) / measure.factor).collect(),
        limits: Vec::new(),
        columns,
        rows,
    }
}
