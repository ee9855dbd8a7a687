//! How large the error is, and what the orders miss of it.

use assur::tolerance::{Corners, Estimate, Status};

use super::Sheet;
use crate::show::number;
use crate::show::text::{Align, Columns};
use crate::tolerance::answer::{MISSED, Second};
use crate::tolerance::arguments::Kind;

impl Sheet<'_> {
    /// The bands that are wanted.
    pub fn bands(&mut self) {
        let (kind, answer) = (self.question.kind, self.answer);
        let mut table =
            Columns::new([("", Align::Left), (self.unit.name, Align::Point), ("", Align::Left)]);
        let mut row = |name: &str, value: String, remark: String| {
            table.row([name.to_owned(), value, remark]);
        };
        if kind.wants(Kind::Worst) {
            let remark = "sum of all largest errors".to_owned();
            row("worst case", self.error(answer.linear.worst), remark);
        }
        if kind.wants(Kind::Rss) {
            let remark = "standard deviation".to_owned();
            row("root sum square", self.error(answer.linear.deviation), remark);
        }
        if let Some(second) = &answer.second {
            self.second(second, &mut row);
        }
        if let Some(made) = &answer.made {
            let place = &made.places[0];
            let pair = |estimate: Estimate| {
                format!("{} to {}", self.error(estimate.low), self.error(estimate.high))
            };
            let mean = format!("{}, with 95 % confidence", pair(place.mean));
            row("made at random, mean", self.error(place.mean.value), mean);
            let value = self.error(place.deviation.value);
            row("  standard deviation", value, pair(place.deviation));
            for quantile in &place.quantiles {
                let name = format!("  {} % below", number::short(100.0 * quantile.level));
                row(&name, self.error(quantile.estimate.value), pair(quantile.estimate));
            }
            let (made, _) = self.question.case.made_in_words();
            let share = number::error(100.0 * place.beyond);
            let beyond = format!("at most {share} % of the {made} lie lower");
            row("  least", self.error(place.least), beyond.clone());
            row("  greatest", self.error(place.greatest), beyond.replace("lower", "higher"));
        }
        self.page.section("Bands", &table);
        self.failures();
    }

    fn second(&self, second: &Second, row: &mut impl FnMut(&str, String, String)) {
        let moments = &second.moments;
        let skewness = format!("skewness {}", number::significant(moments.skewness, 3));
        row("second order, mean", self.error(moments.mean), "shift".to_owned());
        row("  standard deviation", self.error(moments.deviation), skewness);
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
        row("closed again, worst case", self.error(exact.worst()), remark(exact));
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
        let (made, succeed) = self.question.case.made_in_words();
        let line = match place.status {
            Status::Complete => format!(
                "All of {drawn} {made} made at random (seed {}) {succeed}.",
                self.question.sampling.seed
            ),
            Status::Conditional => self.page.style.warn(&format!(
                "{failed} of {drawn} {made} made at random ({} %, between {} and {} %) do not {succeed} in this mode: \
                 the numbers above are those of the others alone.",
                share(failures.value),
                share(failures.low),
                share(failures.high)
            )),
            Status::Empty => self
                .page
                .style
                .warn(&format!("Of {drawn} {made} made at random none {succeed} in this mode.")),
        };
        self.page.line(&line);
        self.page.line("");
    }

    /// What the linear sum misses.
    pub fn missed(&mut self) {
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
        for (name, one) in
            [("first order", differences.linear), ("second order", differences.quadratic)]
        {
            let share = 100.0 * one.rms / differences.errors.rms;
            table.row([
                name.to_owned(),
                self.error(one.rms),
                number::significant(share, 3),
                self.error(one.greatest),
            ]);
        }
        let (compared, made) =
            (differences.compared as usize, self.question.case.made_in_words().0);
        let heading = format!(
            "What each order misses, over {} {made} made at random",
            number::count(compared)
        );
        self.page.section(&heading, &table);
        let share = differences.linear.rms / differences.errors.rms;
        if share > MISSED {
            self.page.line(&self.page.style.warn(&format!(
                "The first order misses {} % of the error: worst case, standard deviation and shares above mislead here.",
                number::significant(100.0 * share, 2)
            )));
            self.page.line("");
        }
        if !second.is_trusted() {
            self.page.line(&self.page.style.warn(
                "The second order does not describe these errors, as near a dead point: trust what is closed again and \
                 made at random alone.",
            ));
            self.page.line("");
        }
    }
}
