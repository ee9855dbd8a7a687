//! `assur study --attractors`: what attracts at each value of a range, and where one motion gives way to others.

use std::path::Path;
use std::time::Instant;

use assur::shape::Quantity;
use assur::study::{Attractor, Found, Look, attractors};
use serde::Serialize;

use super::question::Question;
use super::table::{headed, shown};
use crate::answer::Answer;
use crate::error::Failure;
use crate::plot::{self, Layer, Sheet};
use crate::show::csv::{cell, line, quoted, title};
use crate::show::json::{self, About, Number, Settings, number as finite};
use crate::show::page::Page;
use crate::show::progress::Progress;
use crate::show::text::{Align, Columns};
use crate::show::{number, unit};

/// Most rows of the table.
const ROWS: usize = 120;

/// What attracts at each value.
pub struct Attractors {
    question: Question,
    found: Vec<Found>,
    seconds: f64,
}

/// The answer as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Object {
    /// `assur-attractors/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    settings: Settings,
    /// The value that is gone through.
    over: &'static str,
    unit: &'static str,
    values: Vec<Value>,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// What attracts at a value.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Value {
    value: f64,
    attractors: Vec<One>,
    /// Starts that were tried.
    starts: usize,
    /// Why starts lead to none.
    lost: Vec<String>,
}

/// A motion that attracts.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct One {
    /// Periods after which it repeats; null of an irregular motion.
    periods: Option<usize>,
    /// By what factor small disturbances change in a period.
    growth: Number,
    /// The largest Lyapunov exponent, 1/s.
    exponent: Number,
    /// Starts that lead to it.
    starts: usize,
    measures: Vec<json::Amount>,
}

impl Attractors {
    /// Looks for them.
    ///
    /// # Errors
    /// A request that is no range, or nothing that attracts.
    pub fn find(question: Question, starts: usize, seed: u64) -> Result<Self, Failure> {
        let clock = Instant::now();
        if question.scene.linkage.is_some() {
            return Err(Failure::request("a linkage has positions, which attract nothing")
                .remedy("name a scene with a motion that repeats"));
        }
        let values: Vec<Vec<f64>> = (0..question.count()).map(|run| question.values(run)).collect();
        let what = format!("{}, attractors", question.constants.mechanism.name);
        let bar = Progress::start(what, 3 * values.len() as u64);
        let (settings, threads) = (&question.settings, question.threads);
        let look = Look { starts, seed, settings, threads };
        let progress = |more: u64| bar.advance_by(more);
        let found = attractors(&question.scene.bind, &values, look, &progress);
        drop(bar);
        if found.iter().all(|one| one.attractors.is_empty()) {
            let reason = found.iter().flat_map(|one| &one.lost).next().cloned();
            return Err(Failure::numerical("nothing attracts at any of these values")
                .reason(reason.unwrap_or_default())
                .remedy("look at one of them with `assur run`"));
        }
        Ok(Self { question, found, seconds: clock.elapsed().as_secs_f64() })
    }

    /// Each value with each motion that attracts there.
    fn rows(&self) -> impl Iterator<Item = (f64, &Found, &Attractor)> {
        let values = self.question.over().1.iter().zip(&self.found);
        values
            .flat_map(|(value, found)| found.attractors.iter().map(move |one| (*value, found, one)))
    }

    fn measure(&self, of: &Attractor, index: usize) -> f64 {
        of.measures.get(index).and_then(|one| one.ok()).unwrap_or(f64::NAN)
    }
}

impl Answer for Attractors {
    fn figure(&self) -> Option<String> {
        let scene = self.question.scene;
        let title = format!(
            "{}, scene {}: what attracts",
            self.question.constants.mechanism.title, scene.name
        );
        let (constant, _) = self.question.over();
        let layers = self.question.measures.iter().map(|index| {
            let measure = &scene.measures[*index];
            let point = |(value, _, one): (f64, &Found, &Attractor)| {
                (value / constant.factor, self.measure(one, *index) / measure.factor)
            };
            let points = self.rows().map(point).collect();
            Layer::Points(Sheet { along: headed(constant), up: headed(measure), points })
        });
        Some(plot::sheets(&title, "", &layers.collect::<Vec<_>>()))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        let (scene, (constant, values)) = (self.question.scene, self.question.over());
        page.about(&self.question.constants, &format!("what attracts at {} values", values.len()));
        let measures =
            || self.question.measures.iter().map(|index| (*index, &scene.measures[*index]));
        let heads = [
            (headed(constant), Align::Point),
            ("repeats after".to_owned(), Align::Right),
            ("growth".to_owned(), Align::Point),
            ("exponent, 1/s".to_owned(), Align::Point),
            ("starts".to_owned(), Align::Right),
        ];
        let heads: Vec<_> =
            heads.into_iter().chain(measures().map(|one| (headed(one.1), Align::Point))).collect();
        let mut table = Columns::new(heads.iter().map(|(head, align)| (head.as_str(), *align)));
        for (value, found, one) in self.rows().take(ROWS) {
            let cells = [
                number::short(value / constant.factor),
                one.periods.map_or("irregular".to_owned(), |periods| periods.to_string()),
                number::significant(one.growth, 5),
                number::significant(one.exponent, 4),
                format!("{} of {}", one.starts, found.starts),
            ];
            let own = measures().map(|(index, measure)| shown(self.measure(one, index), measure));
            table.row(cells.into_iter().chain(own));
        }
        page.section("What attracts", &table);
        let (rows, lost) = (self.rows().count(), self.found.iter().map(|one| one.lost.len()).sum());
        if rows > ROWS {
            page.line(&format!("{rows} rows in all: --format csv has them."));
        }
        let several = self.found.iter().filter(|one| one.attractors.len() > 1).count();
        page.line(&format!("At {several} of {} values several motions attract.", values.len()));
        if let (1.., Some(reason)) = (lost, self.found.iter().flat_map(|one| &one.lost).next()) {
            let reason: &String = reason;
            page.line(&format!(
                "{} starts lead to none of them; the first: {reason}",
                number::count(lost)
            ));
        }
        page.line("Growth: of small disturbances in a period, below 1 where the motion attracts; no finite number of starts finds everything.");
        page.figure(figure);
        page.line(&format!("It took {}.", number::duration(self.seconds)));
    }

    fn csv(&self) -> String {
        let (scene, (constant, _)) = (self.question.scene, self.question.over());
        let measures =
            || self.question.measures.iter().map(|index| (*index, &scene.measures[*index]));
        let names = [
            title(constant.name, constant.unit),
            "periods".to_owned(),
            "growth".to_owned(),
            title("exponent", "1/s"),
            "starts".to_owned(),
            quoted("tried"),
        ];
        let mut text =
            line(names.into_iter().chain(measures().map(|one| title(one.1.name, one.1.unit))));
        for (value, found, one) in self.rows() {
            let cells = [
                cell(unit::stated(value, constant.factor)),
                one.periods.map_or(String::new(), |periods| periods.to_string()),
                cell(one.growth),
                cell(one.exponent),
                one.starts.to_string(),
                found.starts.to_string(),
            ];
            let own = measures().map(|(index, measure)| {
                cell(unit::stated(self.measure(one, index), measure.factor))
            });
            text += &line(cells.into_iter().chain(own));
        }
        text
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        let (scene, (constant, values)) = (self.question.scene, self.question.over());
        let quantities: Vec<Quantity> =
            self.question.measures.iter().map(|index| scene.measures[*index]).collect();
        let one = |one: &Attractor| One {
            periods: one.periods,
            growth: finite(one.growth),
            exponent: finite(one.exponent),
            starts: one.starts,
            measures: {
                let found = self.question.measures.iter().map(|index| self.measure(one, *index));
                json::Amount::all(&quantities, &found.collect::<Vec<_>>())
            },
        };
        let value = |(value, found): (&f64, &Found)| Value {
            value: unit::stated(*value, constant.factor),
            attractors: found.attractors.iter().map(one).collect(),
            starts: found.starts,
            lost: found.lost.clone(),
        };
        Object {
            format: "assur-attractors/1",
            about: About::of(&self.question.constants),
            settings: Settings::of(&self.question.settings, scene),
            over: constant.name,
            unit: constant.unit,
            values: values.iter().zip(&self.found).map(value).collect(),
            seconds: self.seconds,
            figure: json::path(figure),
        }
    }
}
