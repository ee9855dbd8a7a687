//! The answer as tables to read.

use std::path::Path;

use assur::registry::Distribution;
use assur::tolerance::{Corners, Estimate, Limit, Status};

use super::answer::{Answer, Second, Unit, label, place_text};
use super::arguments::Kind;
use super::question::{Question, Wanted};
use crate::number;
use crate::style::Style;
use crate::text::{Align, Columns};

/// Digits of an error.
const DIGITS: usize = 5;
/// Share of the error above which what the first order misses is pointed out.
const MISSED: f64 = 0.05;

/// All tables, with the last line ended.
pub fn render(question: &Question, answer: &Answer, figure: Option<&Path>, style: Style) -> String {
    let page = Page {
        text: String::new(),
        style,
        question,
        answer,
        unit: Unit::of(question),
    };
    page.whole(figure)
}

struct Page<'a> {
    text: String,
    style: Style,
    question: &'a Question,
    answer: &'a Answer,
    unit: Unit,
}

impl Page<'_> {
    fn whole(mut self, figure: Option<&Path>) -> String {
        let question = self.question;
        let title = format!(
            "{}, scene {}: how {} errs",
            question.mechanism.title,
            question.scene.name,
            question.output().name
        );
        self.line(&self.style.heading(&title));
        if !question.changed.is_empty() {
            self.line(&format!("  with {}", question.changed));
        }
        let others = question.other_outputs();
        let others = match others.is_empty() {
            true => String::new(),
            false => format!("--output {}", others.join(", --output ")),
        };
        if !question.is_named && !others.is_empty() {
            let output = question.output().name;
            self.line(&format!(
                "  {output} is the last output of the scene; for another one: {others}"
            ));
        }
        self.line("");
        self.contributions();
        self.bands();
        self.missed();
        self.range();
        self.allocation();
        if let Some(path) = figure {
            self.line(&format!("Figure: {}", path.display()));
        }
        if question.is_named && !others.is_empty() {
            self.line(&format!("Other outputs: {others}."));
        }
        self.line(&format!(
            "Found in {}.",
            number::duration(self.answer.seconds)
        ));
        self.text
    }

    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    fn section(&mut self, heading: &str, table: &Columns) {
        let heading = self.style.heading(heading);
        self.line(&heading);
        self.text += &table.render(self.style);
        self.line("");
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
                distribution(source.distribution).to_owned(),
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
        self.section(&heading, &table);
    }

    fn bands(&mut self) {
        let (kind, answer) = (self.question.kind, self.answer);
        let mut table = Columns::new([
            ("", Align::Left),
            (self.unit.name, Align::Point),
            ("", Align::Left),
        ]);
        let mut row = |name: &str, value: String, remark: String| {
            table.row([name.to_owned(), value, remark]);
        };
        if kind.wants(Kind::Worst) {
            let remark = "sum of all largest errors".to_owned();
            row("worst case", self.error(answer.linear.worst), remark);
        }
        if kind.wants(Kind::Rss) {
            let remark = "standard deviation".to_owned();
            row(
                "root sum square",
                self.error(answer.linear.deviation),
                remark,
            );
        }
        if let Some(second) = &answer.second {
            self.second(second, &mut row);
        }
        if let Some(made) = &answer.made {
            let place = &made.places[0];
            let pair = |estimate: Estimate| {
                format!(
                    "{} to {}",
                    self.error(estimate.low),
                    self.error(estimate.high)
                )
            };
            let mean = format!("{}, with 95 % confidence", pair(place.mean));
            row("made at random, mean", self.error(place.mean.value), mean);
            let value = self.error(place.deviation.value);
            row("  standard deviation", value, pair(place.deviation));
            for quantile in &place.quantiles {
                let name = format!("  {} % below", number::short(100.0 * quantile.level));
                row(
                    &name,
                    self.error(quantile.estimate.value),
                    pair(quantile.estimate),
                );
            }
            let beyond = format!(
                "at most {} % of the linkages lie lower",
                number::error(100.0 * place.beyond)
            );
            row("  least", self.error(place.least), beyond.clone());
            row(
                "  greatest",
                self.error(place.greatest),
                beyond.replace("lower", "higher"),
            );
        }
        self.section("Bands", &table);
        self.failures();
    }

    fn second(&self, second: &Second, row: &mut impl FnMut(&str, String, String)) {
        let moments = &second.moments;
        let skewness = format!("skewness {}", number::significant(moments.skewness, 3));
        row(
            "second order, mean",
            self.error(moments.mean),
            "shift".to_owned(),
        );
        row(
            "  standard deviation",
            self.error(moments.deviation),
            skewness,
        );
        let Some(extremes) = &second.extremes else {
            return;
        };
        let remark = |corners: &Corners| {
            format!(
                "{} to {} over {} extremes{}",
                self.error(corners.least),
                self.error(corners.greatest),
                number::count(corners.tried),
                match corners.failed {
                    0 => String::new(),
                    failed => format!(", {} of which do not assemble", number::count(failed)),
                }
            )
        };
        let (form, exact) = (&extremes.quadratic, &extremes.exact);
        row("  worst case", self.error(form.worst()), remark(form));
        row(
            "closed again, worst case",
            self.error(exact.worst()),
            remark(exact),
        );
    }

    /// Linkages that do not assemble are never passed over.
    fn failures(&mut self) {
        let Some(made) = &self.answer.made else {
            return;
        };
        let place = &made.places[0];
        let drawn = number::count(place.drawn as usize);
        let failed = number::count((place.drawn - place.assembled) as usize);
        let share = |share: f64| number::significant(100.0 * share, 3);
        let failures = place.failures;
        let line = match place.status {
            Status::Complete => format!(
                "All of {drawn} linkages made at random (seed {}) assemble.",
                self.question.sampling.seed
            ),
            Status::Conditional => self.style.warn(&format!(
                "{failed} of {drawn} linkages made at random ({} %, between {} and {} %) do not assemble in this mode: \
                 the numbers above are those of the others alone.",
                share(failures.value),
                share(failures.low),
                share(failures.high)
            )),
            Status::Empty => self
                .style
                .warn(&format!("None of {drawn} linkages made at random assembles in this mode.")),
        };
        self.line(&line);
        self.line("");
    }

    /// What the linear sum misses.
    fn missed(&mut self) {
        let Some(second) = &self.answer.second else {
            return;
        };
        let differences = &second.differences;
        let mut table = Columns::new([
            ("", Align::Left),
            (&self.headed("rms"), Align::Point),
            ("of the error, %", Align::Point),
            (&self.headed("greatest"), Align::Point),
        ]);
        for (name, one) in [
            ("first order", differences.linear),
            ("second order", differences.quadratic),
        ] {
            let share = 100.0 * one.rms / differences.errors.rms;
            table.row([
                name.to_owned(),
                self.error(one.rms),
                number::significant(share, 3),
                self.error(one.greatest),
            ]);
        }
        let heading = format!(
            "What each order misses, over {} linkages made at random",
            number::count(differences.compared as usize)
        );
        self.section(&heading, &table);
        let share = differences.linear.rms / differences.errors.rms;
        if share > MISSED {
            self.line(&self.style.warn(&format!(
                "The first order misses {} % of the error: worst case, standard deviation and shares above mislead here.",
                number::significant(100.0 * share, 2)
            )));
            self.line("");
        }
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
                    true => format!(
                        "at {}",
                        place_text(question, &question.study.places[rank.place])
                    ),
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
        self.section(&heading, &table);
    }

    fn allocation(&mut self) {
        let (Some(found), Some(wanted)) = (&self.answer.allocation, &self.question.allocation)
        else {
            return;
        };
        self.chosen(found, wanted);
        let unit = self.unit;
        self.line(&format!(
            "Cost {} against {} for those of the file; the error is at most {}, at {}.",
            number::significant(found.cost, 4),
            number::significant(present(wanted), 4),
            unit.text(found.greatest),
            place_text(self.question, &found.greatest_at)
        ));
        let binding = found.active.iter().map(|one| {
            let place = place_text(self.question, &one.at);
            format!("{place} ({:.0} %)", 100.0 * one.share)
        });
        let binding: Vec<_> = binding.collect();
        if !binding.is_empty() {
            self.line(&format!("It binds at {}.", binding.join("; ")));
        }
        self.line(&format!(
            "A band wider by 1 % saves {}.",
            number::significant(0.01 * found.price, 3)
        ));
        self.line("");
    }

    fn chosen(&mut self, found: &assur::tolerance::Allocation, wanted: &Wanted) {
        let question = self.question;
        let mut table = Columns::new([
            ("", Align::Left),
            ("tolerance", Align::Point),
            ("", Align::Left),
            ("now", Align::Point),
            ("cost", Align::Point),
            ("", Align::Left),
        ]);
        let own = question.labels.iter().zip(&question.study.sources);
        let own = own.filter(|(label, _)| !label.is_play);
        for (index, (label, source)) in own.enumerate() {
            let quantity = label.quantity;
            let tolerance = found.tolerances[index];
            table.row([
                quantity.name.to_owned(),
                number::significant(tolerance / quantity.factor, 4),
                quantity.unit.to_owned(),
                number::significant(source.half_width / quantity.factor, 4),
                number::significant(wanted.candidates[index].cost.of(tolerance), 3),
                match found.limits[index] {
                    Limit::None => String::new(),
                    Limit::Least => "at its lower limit".to_owned(),
                    Limit::Most => "at its upper limit".to_owned(),
                },
            ]);
        }
        let what = match wanted.rule {
            assur::tolerance::Rule::Worst => "worst case",
            _ => "standard deviation",
        };
        let heading = format!(
            "Tolerances of least cost that keep the {what} within {} over the range",
            self.unit.text(wanted.band)
        );
        self.section(&heading, &table);
    }
}

/// What the tolerances of the file cost.
fn present(wanted: &Wanted) -> f64 {
    let weights = wanted.candidates.iter();
    weights
        .map(|one| one.cost.of(one.cost.factor))
        .sum::<f64>()
        .max(0.0)
}

/// A distribution in a word.
pub fn distribution(distribution: Distribution) -> &'static str {
    match distribution {
        Distribution::Uniform => "uniform",
        Distribution::Normal => "normal",
        Distribution::Truncated => "truncated",
    }
}
