//! The answer as tables to read.

mod allocation;
mod bands;

use std::path::Path;

use super::answer::{Answer, Unit, label, place_text};
use super::question::Question;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Digits of an error.
const DIGITS: usize = 5;

/// All tables.
pub fn render(page: &mut Page, question: &Question, answer: &Answer, figure: Option<&Path>) {
    Sheet { page, question, answer, unit: Unit::of(question.output()) }.whole(figure);
}

/// The page with what stands on it.
struct Sheet<'a> {
    page: &'a mut Page,
    question: &'a Question,
    answer: &'a Answer,
    unit: Unit,
}

impl Sheet<'_> {
    fn whole(mut self, figure: Option<&Path>) {
        let question = self.question;
        let title = format!(
            "{}, scene {}: how {} errs",
            question.case.constants.mechanism.title,
            question.case.scene.name,
            question.output().name
        );
        let page = &mut *self.page;
        page.line(&page.style.heading(&title));
        if !question.changed.is_empty() {
            page.line(&format!("  with {}", question.changed));
        }
        for note in &question.notes {
            page.warn(note);
        }
        let others = question.other_outputs();
        let others = match others.is_empty() {
            true => String::new(),
            false => format!("--output {}", others.join(", --output ")),
        };
        if !question.is_named && !others.is_empty() {
            let output = question.output().name;
            page.line(&format!(
                "  {output} is the last output of the scene; for another one: {others}"
            ));
        }
        page.line("");
        self.contributions();
        self.bands();
        self.missed();
        self.range();
        self.allocation();
        self.page.figure(figure);
        if question.is_named && !others.is_empty() {
            self.page.line(&format!("Other outputs: {others}."));
        }
        self.page.line(&format!("Found in {}.", number::duration(self.answer.seconds)));
    }

    /// An error of the output in its unit.
    fn error(&self, value: f64) -> String {
        number::significant(value / self.unit.factor, DIGITS)
    }

    /// A heading with the unit of the errors.
    fn headed(&self, name: &str) -> String {
        match self.unit.name {
            "" => name.to_owned(),
            unit => format!("{name}, {unit}"),
        }
    }

    fn contributions(&mut self) {
        let (question, linear) = (self.question, &self.answer.linear);
        let mut order: Vec<usize> = (0..linear.contributions.len()).collect();
        let worst = |index: &usize| linear.contributions[*index].worst;
        order.sort_by(|a, b| worst(b).total_cmp(&worst(a)));
        let mut table = Columns::new([
            ("", Align::Left),
            ("tolerance", Align::Point),
            ("", Align::Left),
            ("", Align::Left),
            ("influence", Align::Point),
            ("", Align::Left),
            (&self.headed("contribution"), Align::Point),
            ("share, %", Align::Point),
            ("of the variance, %", Align::Point),
        ]);
        for index in order {
            let source = &question.study.sources[index];
            let quantity = question.labels[index].quantity;
            let one = &linear.contributions[index];
            let per_unit = one.influence / self.unit.factor * quantity.factor;
            table.row([
                label(question, index),
                number::significant(source.half_width / quantity.factor, DIGITS),
                quantity.unit.to_owned(),
                source.distribution.name().to_owned(),
                number::significant(per_unit, 6),
                self.unit.per(quantity.unit),
                self.error(one.worst),
                number::significant(100.0 * one.share, 3),
                number::significant(100.0 * one.variance_share, 3),
            ]);
        }
        let place = place_text(question, &self.answer.place);
        let heading = match question.at {
            Some(_) => format!("At {place}"),
            None => format!("At {place}, where the error is greatest"),
        };
        self.page.section(&heading, &table);
    }

    fn range(&mut self) {
        let (question, answer) = (self.question, self.answer);
        let mut table = Columns::new([
            ("", Align::Left),
            ("mean share, %", Align::Point),
            ("largest, %", Align::Point),
            ("", Align::Left),
        ]);
        for rank in &answer.ranking {
            table.row([
                label(question, rank.source),
                number::significant(100.0 * rank.mean, 3),
                number::significant(100.0 * rank.largest, 3),
                match rank.largest > 0.0 {
                    true => {
                        format!("at {}", place_text(question, &question.study.places[rank.place]))
                    }
                    false => String::new(),
                },
            ]);
        }
        let worst = assur::tolerance::worst_place(&answer.range);
        let range = match question.along {
            Some(_) => "grid",
            None => "range",
        };
        let heading = format!(
            "Over the {range} of {} places: worst case up to {} at {}",
            answer.range.len(),
            self.unit.text(answer.range[worst].worst),
            place_text(question, &question.study.places[worst])
        );
        self.page.section(&heading, &table);
    }
}
