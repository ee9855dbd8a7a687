//! `assur study --sensitivity`: how each measure changes with each dimension and parameter.

use std::path::Path;
use std::time::Instant;

use assur::shape::Quantity;
use assur::study::{Slope, each, slopes};
use serde::Serialize;

use super::question::Question;
use super::table::shown;
use crate::answer::Answer;
use crate::error::Failure;
use crate::show::csv::{cell, line, title};
use crate::show::json::{About, Number, number as finite};
use crate::show::page::Page;
use crate::show::progress::Progress;
use crate::show::text::{Align, Columns};
use crate::show::{number, unit};

/// How each measure changes with each constant.
pub struct Sensitivity {
    question: Question,
    /// The measures with the values as they are, SI units.
    values: Vec<f64>,
    /// For each constant that of each measure.
    slopes: Vec<Vec<Option<Slope>>>,
    seconds: f64,
}

/// The answer as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Object {
    /// `assur-sensitivity/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    measures: Vec<Measure>,
    seconds: f64,
}

/// A measure with what changes it.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Measure {
    name: &'static str,
    unit: &'static str,
    value: Number,
    by: Vec<By>,
}

/// A derivative by a dimension or parameter.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct By {
    name: &'static str,
    /// Units of both.
    unit: String,
    /// Null where the measure does not exist beside the value.
    value: Number,
    estimated_error: Number,
    /// Per cent for each per cent of the value; null where one of both is zero.
    relative: Number,
}

impl Sensitivity {
    /// Finds all derivatives.
    ///
    /// # Errors
    /// When there are no measures with the values as they are.
    pub fn find(question: Question) -> Result<Self, Failure> {
        let clock = Instant::now();
        let measures = |values: &[f64]| {
            let found = question.measures_with(values)?;
            let chosen = question.measures.iter();
            Ok(chosen.map(|index| found[*index].unwrap_or(f64::NAN)).collect::<Vec<f64>>())
        };
        let base = question.constants.values.clone();
        let values = measures(&base).map_err(|reason: String| {
            Failure::numerical("there are no measures that could change").reason(reason)
        })?;
        let constants = question.scene.constants;
        let what = format!("{}, sensitivities", question.constants.mechanism.name);
        let bar = Progress::start(what, constants.len() as u64);
        let progress = |more: u64| bar.advance_by(more);
        let slopes = each(constants.len(), question.threads, &progress, &|index| {
            let at = |value: f64| {
                let (low, high) = constants[index].range;
                let is_permitted = (low..=high).contains(&value);
                let changed = || {
                    let mut changed = base.clone();
                    changed[index] = value;
                    measures(&changed).ok()
                };
                is_permitted.then(changed).flatten()
            };
            slopes(&at, (base[index], constants[index].quantity.factor), values.len())
        });
        drop(bar);
        Ok(Self { question, values, slopes, seconds: clock.elapsed().as_secs_f64() })
    }

    fn measures(&self) -> impl Iterator<Item = (usize, &'static Quantity)> {
        let measures = self.question.scene.measures;
        self.question.measures.iter().enumerate().map(|(place, index)| (place, &measures[*index]))
    }

    /// The constants with their derivatives of a measure, those first that change it most.
    fn ranked(&self, place: usize) -> Vec<(usize, Option<Slope>, f64)> {
        let all = self.slopes.iter().enumerate().map(|(constant, slopes)| {
            let slope = slopes[place];
            let relative = slope.map_or(f64::NAN, |slope| {
                slope.value * self.question.constants.values[constant] / self.values[place]
            });
            (constant, slope, if relative.is_finite() { relative } else { f64::NAN })
        });
        let mut all: Vec<_> = all.collect();
        let size =
            |one: &(usize, Option<Slope>, f64)| if one.2.is_nan() { -1.0 } else { one.2.abs() };
        all.sort_by(|a, b| size(b).total_cmp(&size(a)));
        all
    }
}

/// The unit of a derivative.
fn per(of: &Quantity, by: &Quantity) -> String {
    let wrapped = |unit: &str| match unit.contains(['/', ' ', '*']) {
        true => format!("({unit})"),
        false => unit.to_owned(),
    };
    match (of.unit, by.unit) {
        (unit, "") => unit.to_owned(),
        ("", unit) => format!("1/{}", wrapped(unit)),
        (own, unit) => format!("{}/{}", wrapped(own), wrapped(unit)),
    }
}

impl Answer for Sensitivity {
    fn table(&self, page: &mut Page, _: Option<&Path>) {
        page.about(&self.question.constants, "how measures change with dimensions and parameters");
        for (place, measure) in self.measures() {
            let mut table = Columns::new([
                ("by", Align::Left),
                ("value", Align::Point),
                ("", Align::Left),
                ("derivative", Align::Point),
                ("unit", Align::Left),
                ("estimated error", Align::Point),
                ("% for 1 %", Align::Point),
            ]);
            for (index, slope, relative) in self.ranked(place) {
                let constant = &self.question.scene.constants[index].quantity;
                let factor = measure.factor / constant.factor;
                let value = number::short(self.question.constants.values[index] / constant.factor);
                let (derivative, error) = match slope {
                    Some(slope) => (
                        number::with_error(slope.value / factor, slope.error / factor),
                        number::error(slope.error / factor),
                    ),
                    None => ("none".to_owned(), String::new()),
                };
                table.row([
                    constant.name.to_owned(),
                    value,
                    constant.unit.to_owned(),
                    derivative,
                    per(measure, constant),
                    error,
                    if relative.is_nan() {
                        String::new()
                    } else {
                        number::significant(relative, 4)
                    },
                ]);
            }
            let heading = format!(
                "{} = {} {}",
                measure.name,
                shown(self.values[place], measure),
                measure.unit
            );
            page.section(heading.trim_end(), &table);
        }
        page.line("None: the measure does not exist beside the value, or the value must not change to both sides.");
        page.line(&format!("It took {}.", number::duration(self.seconds)));
    }

    fn csv(&self) -> String {
        let constants = self.question.scene.constants;
        let names =
            ["by".to_owned()].into_iter().chain(self.measures().flat_map(|(_, measure)| {
                [
                    title(measure.name, &format!("{} per SI unit", measure.unit)),
                    title(&format!("error({})", measure.name), measure.unit),
                ]
            }));
        let mut text = line(names);
        for (constant, slopes) in constants.iter().zip(&self.slopes) {
            let cells = self.measures().flat_map(|(place, measure)| {
                let slope = slopes[place].unwrap_or(Slope { value: f64::NAN, error: f64::NAN });
                [slope.value, slope.error].map(|one| cell(unit::stated(one, measure.factor)))
            });
            text += &line([constant.quantity.name.to_owned()].into_iter().chain(cells));
        }
        text
    }

    fn json(&self, _: Option<&Path>) -> impl Serialize {
        let measure = |(place, measure): (usize, &'static Quantity)| Measure {
            name: measure.name,
            unit: measure.unit,
            value: finite(unit::stated(self.values[place], measure.factor)),
            by: {
                let by = |(index, slope, relative): (usize, Option<Slope>, f64)| {
                    let constant = &self.question.scene.constants[index].quantity;
                    let factor = measure.factor / constant.factor;
                    By {
                        name: constant.name,
                        unit: per(measure, constant),
                        value: slope.and_then(|slope| finite(slope.value / factor)),
                        estimated_error: slope.and_then(|slope| finite(slope.error / factor)),
                        relative: finite(relative),
                    }
                };
                self.ranked(place).into_iter().map(by).collect()
            },
        };
        Object {
            format: "assur-sensitivity/1",
            about: About::of(&self.question.constants),
            measures: self.measures().map(measure).collect(),
            seconds: self.seconds,
        }
    }
}
