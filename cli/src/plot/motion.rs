//! The figure of a motion.

use assur::shape::At;

use super::across::Across;
use super::bands::Band;
use super::figure::{Figure, lead};
use super::marks::{self, Mark};
use super::panels::{self, Data, Published};
use super::selection::Selection;
use crate::motion::events;
use crate::motion::report::Report;
use crate::show::number;

/// Draws the figure of a report.
pub fn draw(report: &Report, selection: &Selection) -> String {
    let across = Across::new(report);
    let abscissa = |time: f64| across.at(report, time);
    let times = report.curves.times.iter();
    let positions: Vec<f64> = times.map(|time| abscissa(*time)).collect();
    let known = report.published.iter().filter(|comparison| comparison.comparable);
    let published = known.filter_map(|comparison| {
        Some(Published {
            variable: comparison.variable?,
            at: comparison.time.map(abscissa),
            value: comparison.fact.value,
            is_extreme: matches!(comparison.fact.at, At::Maximum | At::Minimum | At::Amplitude),
        })
    });
    let data = Data {
        variables: &report.case.variables,
        values: &report.curves.values,
        errors: &report.errors,
        published: published.collect(),
    };
    let panels = panels::choose(&data, selection);
    let marks = marks(report, &positions, &abscissa);
    let bands = events::bands(report).into_iter().map(|band| Band {
        ends: (abscissa(band.from), abscissa(band.to)),
        mode: band.mode,
        name: band.name.to_owned(),
    });
    let bands = bands.collect();
    Figure {
        bands,
        title: title(report),
        lead: lead(&report.case.constants),
        panels,
        beside: Vec::new(),
        marks,
        made: made(report),
        positions,
        across,
    }
    .draw()
}

fn title(report: &Report) -> String {
    let what = if report.is_cycle() {
        format!("steady state over one {}", report.case.turn().one())
    } else {
        "motion".to_owned()
    };
    format!("{}: {what}", report.case.constants.mechanism.title)
}

/// The marks of the equation file and those that were asked for.
fn marks(report: &Report, positions: &[f64], abscissa: &dyn Fn(f64) -> f64) -> Vec<Mark> {
    let case = &report.case;
    let stated = case.scene.marks.iter().filter_map(|mark| {
        let time = match mark.at {
            At::Time(time) => case.moved.task.reduce(time)?,
            At::Driver(driver, position) => case.run().time_of(driver, position).ok()?,
            _ => return None,
        };
        Some(Mark { at: abscissa(time), label: mark.text.to_owned(), asked: false })
    });
    let asked = report.places.iter().map(|place| Mark {
        at: abscissa(place.time),
        label: place.label.clone(),
        asked: true,
    });
    marks::sort(stated.chain(asked), positions)
}

/// How the curves were made.
fn made(report: &Report) -> String {
    if report.motion.statistics().evaluations == 0 {
        return "closed form".to_owned();
    }
    let mut made =
        format!("{} with rtol {:e}", report.motion.settings.method, report.motion.settings.rtol);
    if let Some((_, share)) = report.cost.worst {
        made += &format!(", estimated error {} of the amplitude", number::error(share));
    }
    made
}
