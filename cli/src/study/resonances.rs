//! `assur study --resonances`: where free motions repeat with what drives them, and where they grow, over a range.

use std::path::Path;
use std::time::Instant;

use assur::periodic::Multiplier;
use assur::problem::Span;
use assur::study::{self, GROWTH, Meets, Resonance, Unstable, resonances, spectrum};
use serde::Serialize;

use super::question::{Plan, Question};
use super::table::headed;
use crate::answer::Answer;
use crate::error::Failure;
use crate::plot::{self, Layer, Sheet};
use crate::show::csv::{cell, line, quoted, title};
use crate::show::json::{self, About, Number, Settings, number as finite};
use crate::show::page::Page;
use crate::show::progress::Progress;
use crate::show::text::{Align, Columns};
use crate::show::{number, unit};

/// Most rows of a table.
const ROWS: usize = 120;

/// Most gaps that are told.
const GAPS: usize = 12;

/// What a range has.
pub struct Resonances {
    question: Question,
    found: study::Resonances,
    seconds: f64,
}

/// The answer as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Object {
    /// `assur-resonances/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    settings: Settings,
    /// The value that is gone through.
    over: &'static str,
    unit: &'static str,
    resonances: Vec<One>,
    unstable: Vec<Range>,
    /// Values between which multipliers could not be followed.
    gaps: Vec<[f64; 2]>,
    /// Values at which there are none, and why.
    lost: Vec<Lost>,
    /// Values at which multipliers were computed.
    values: usize,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// Where a multiplier is nearest to what it meets.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct One {
    value: f64,
    estimated_error: Number,
    /// `1` of a resonance, `-1` where a free motion repeats after twice the time, `another` of two that grow together.
    meets: &'static str,
    /// How near it comes.
    distance: Number,
    /// Angle of the multiplier in degrees.
    angle: Number,
    /// The largest modulus of all multipliers there, for a period.
    growth: Number,
}

/// A range in which motions grow.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Range {
    from: f64,
    to: f64,
    /// Whether the range that was asked for ends before, at either end.
    cut: [bool; 2],
    /// The largest modulus of the multipliers that was found in it, for a period, and where.
    growth: Number,
    at: f64,
}

/// A value without multipliers.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Lost {
    value: f64,
    reason: String,
}

impl Resonances {
    /// Looks for them.
    ///
    /// # Errors
    /// A scene without a motion that repeats, or multipliers at none of the values.
    pub fn find(question: Question) -> Result<Self, Failure> {
        let clock = Instant::now();
        let (scene, base) = (question.scene, &question.constants.values);
        let repeats = scene
            .bind
            .motion(base)
            .is_ok_and(|model| matches!(model.span(), Span::Periodic(_) | Span::Autonomous));
        if !repeats {
            return Err(Failure::request(format!(
                "scene `{}` has no motion that repeats, so it has no multipliers",
                scene.name
            ))
            .remedy("name a scene that has one, or add --periodic PERIOD"));
        }
        let Plan::Grid(ranges) = &question.way else {
            return Err(Failure::request("resonances are looked for over one range"));
        };
        let constant = ranges[0].constant;
        let at = |value: f64| {
            let mut values = base.clone();
            values[constant] = value;
            spectrum(&scene.bind, &values, value, &question.settings)
        };
        let values = question.over().1;
        let what = format!("{}, resonances", question.constants.mechanism.name);
        let bar = Progress::start(what, 4 * values.len() as u64 + 3);
        let progress = |more: u64| bar.advance_by(more);
        let found = resonances(&at, values, question.threads, &progress);
        drop(bar);
        if found.spectra.is_empty() {
            let reason = found.lost.first().map(|(_, reason)| reason.clone());
            return Err(Failure::numerical("there are multipliers at none of these values")
                .reason(reason.unwrap_or_default())
                .remedy("look at one of them with `assur run`"));
        }
        if found.spectra.iter().all(|one| one.multipliers.is_empty()) {
            return Err(Failure::request(format!(
                "nothing in scene `{}` can move freely, so it has no multipliers",
                scene.name
            ))
            .remedy("name a scene with states"));
        }
        Ok(Self { question, found, seconds: clock.elapsed().as_secs_f64() })
    }

    /// A value of the range in its unit.
    fn stated(&self, value: f64) -> f64 {
        unit::stated(value, self.question.over().0.factor)
    }

    /// A value in its unit, to the digits that are known.
    fn known(&self, value: f64, error: f64) -> String {
        let factor = self.question.over().0.factor;
        number::with_error(value / factor, error / factor)
    }

    /// What is not known between two values between which multipliers were not known again.
    fn changed(&self, from: f64, to: f64) -> String {
        let [before, after] = [from, to].map(|value| {
            let at = self.found.spectra.iter().find(|one| one.value == value);
            at.map_or(1, |one| one.periods)
        });
        let between = format!(
            "between {} and {} {}",
            number::significant(self.stated(from), 8),
            number::significant(self.stated(to), 8),
            self.question.over().0.unit
        );
        match before == after {
            true => format!(
                "{between} multipliers change too fast to be followed, or the motion is another one"
            ),
            false => format!(
                "{between} a motion that repeats after {before} periods gives way to one after {after}"
            ),
        }
    }

    fn resonances(&self, page: &mut Page) {
        let over = self.question.over().0;
        let heads = [
            (headed(over), Align::Point),
            ("estimated error".to_owned(), Align::Point),
            ("a multiplier meets".to_owned(), Align::Right),
            ("distance".to_owned(), Align::Point),
            ("largest modulus".to_owned(), Align::Point),
        ];
        let mut table = Columns::new(heads.iter().map(|(head, align)| (head.as_str(), *align)));
        for one in self.found.all.iter().take(ROWS) {
            table.row([
                self.known(one.value, one.error),
                number::error(one.error / over.factor),
                match one.meets {
                    Meets::Another => {
                        format!("another at {} deg", number::significant(angle(one), 4))
                    }
                    meets => met(meets).to_owned(),
                },
                number::error(one.distance),
                number::significant(one.growth, 9),
            ]);
        }
        if !self.found.all.is_empty() {
            page.section("Where multipliers meet", &table);
        }
        let ones = self.found.all.iter().filter(|one| one.meets == Meets::One);
        let (distance, value) = self.found.nearest;
        page.line(&match ones.count() {
            0 => format!(
                "No multiplier passes 1 in this range; the nearest to it comes to a distance of {}, at {} {}.",
                number::significant(distance, 4),
                number::significant(self.stated(value), 6),
                over.unit
            ),
            1 => "One resonance.".to_owned(),
            count => format!("{count} resonances."),
        });
        if self.found.all.len() > ROWS {
            page.line(&format!(
                "{} rows in all: --format csv has them.",
                number::count(self.found.all.len())
            ));
        }
    }

    fn unstable(&self, page: &mut Page) {
        let over = self.question.over().0;
        if self.found.unstable.is_empty() {
            page.line(&format!(
                "At none of these values, nor where multipliers meet between them, small disturbances grow by more than {GROWTH:e} a period."
            ));
            return;
        }
        let heads = [
            (format!("from, {}", over.unit), Align::Point),
            (format!("to, {}", over.unit), Align::Point),
            ("largest modulus".to_owned(), Align::Point),
            (format!("at, {}", over.unit), Align::Point),
        ];
        let heads = heads.map(|(head, align)| (head.trim_end_matches(", ").to_owned(), align));
        let mut table = Columns::new(heads.iter().map(|(head, align)| (head.as_str(), *align)));
        for one in self.found.unstable.iter().take(ROWS) {
            let end = |value: f64, is_cut: bool| {
                let value = number::significant(self.stated(value), 10);
                if is_cut { format!("{value} or beyond") } else { value }
            };
            table.row([
                end(one.range.0, one.is_cut.0),
                end(one.range.1, one.is_cut.1),
                number::significant(one.growth, 9),
                number::significant(self.stated(one.at), 8),
            ]);
        }
        page.section("Where small disturbances grow", &table);
    }
}

/// What a multiplier meets.
fn met(meets: Meets) -> &'static str {
    match meets {
        Meets::One => "1",
        Meets::MinusOne => "-1",
        Meets::Another => "another",
    }
}

/// The angle of the multiplier in degrees, to either side.
fn angle(one: &Resonance) -> f64 {
    one.multiplier.im.abs().atan2(one.multiplier.re).to_degrees()
}

impl Answer for Resonances {
    fn figure(&self) -> Option<String> {
        let (over, along) = (self.question.over().0, || headed(self.question.over().0));
        let title = format!(
            "{}, scene {}: Floquet multipliers",
            self.question.constants.mechanism.title, self.question.scene.name
        );
        let all = || {
            let spectra = self.found.spectra.iter();
            spectra
                .flat_map(|one| one.multipliers.iter().map(move |it| (one.value / over.factor, it)))
        };
        let upper = all().filter(|(_, one)| one.im >= 0.0);
        let angles = upper.map(|(at, one)| (at, one.im.atan2(one.re).to_degrees())).collect();
        // What is nothing but rounding would fill the panel.
        let modulus = |one: &Multiplier| match one.modulus() {
            modulus if (modulus - 1.0).abs() <= GROWTH.max(one.error) => 1.0,
            modulus => modulus,
        };
        let moduli = all().map(|(at, one)| (at, modulus(one))).collect();
        let sheet =
            |up: &str, points| Layer::Points(Sheet { along: along(), up: up.to_owned(), points });
        let layers = [sheet("angle of multipliers, deg", angles), sheet("modulus", moduli)];
        Some(plot::sheets(
            &title,
            "A resonance is where an angle is zero at a modulus of 1; motions grow where a modulus exceeds 1.",
            &layers,
        ))
    }

    fn table(&self, page: &mut Page, figure: Option<&Path>) {
        let values = self.found.spectra.len();
        page.about(
            &self.question.constants,
            &format!("multipliers of the motion that repeats, at {} values", number::count(values)),
        );
        self.resonances(page);
        self.unstable(page);
        page.line("Meeting 1: the free motion repeats with what drives it; meeting -1: after twice the time, and whatever changes the system with the period may make it grow; meeting another: two free motions may grow together.");
        for (from, to) in self.found.gaps.iter().take(GAPS) {
            page.warn(&self.changed(*from, *to));
        }
        if let Some((value, reason)) = self.found.lost.first() {
            page.warn(&format!(
                "no multipliers at {}; at {} {}: {reason}",
                match self.found.lost.len() {
                    1 => "one value".to_owned(),
                    count => format!("{} values", number::count(count)),
                },
                number::significant(self.stated(*value), 8),
                self.question.over().0.unit
            ));
        }
        page.figure(figure);
        page.line(&format!("It took {}.", number::duration(self.seconds)));
    }

    fn csv(&self) -> String {
        let over = self.question.over().0;
        let names = [
            title(over.name, over.unit),
            title(&format!("error({})", over.name), over.unit),
            quoted("meets"),
            quoted("distance"),
            title("angle", "deg"),
            quoted("growth"),
        ];
        let mut text = line(names);
        for one in &self.found.all {
            text += &line([
                cell(self.stated(one.value)),
                cell(self.stated(one.error)),
                met(one.meets).to_owned(),
                cell(one.distance),
                cell(angle(one)),
                cell(one.growth),
            ]);
        }
        text
    }

    fn json(&self, figure: Option<&Path>) -> impl Serialize {
        let over = self.question.over().0;
        let one = |one: &Resonance| One {
            value: self.stated(one.value),
            estimated_error: finite(self.stated(one.error)),
            meets: met(one.meets),
            distance: finite(one.distance),
            angle: finite(angle(one)),
            growth: finite(one.growth),
        };
        let range = |one: &Unstable| Range {
            from: self.stated(one.range.0),
            to: self.stated(one.range.1),
            cut: [one.is_cut.0, one.is_cut.1],
            growth: finite(one.growth),
            at: self.stated(one.at),
        };
        let lost = |(value, reason): &(f64, String)| Lost {
            value: self.stated(*value),
            reason: reason.clone(),
        };
        Object {
            format: "assur-resonances/1",
            about: About::of(&self.question.constants),
            settings: Settings::of(&self.question.settings, self.question.scene),
            over: over.name,
            unit: over.unit,
            resonances: self.found.all.iter().map(one).collect(),
            unstable: self.found.unstable.iter().map(range).collect(),
            gaps: self.found.gaps.iter().map(|(a, b)| [self.stated(*a), self.stated(*b)]).collect(),
            lost: self.found.lost.iter().map(lost).collect(),
            values: self.found.spectra.len(),
            seconds: self.seconds,
            figure: json::path(figure),
        }
    }
}
