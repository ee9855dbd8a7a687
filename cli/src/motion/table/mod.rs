//! A motion as tables to read.

mod variables;

use std::path::Path;

use assur::answer::Method;
use assur::problem::Span;

use super::report::Report;
use super::{events, rest};
use crate::ask::settings::given_atol;
use crate::published;
use crate::show::measures;
use crate::show::number;
use crate::show::page::{Page, WIDTH};
use crate::show::text::{Align, Columns, wrap};
use crate::show::unit;

/// Change points that are named, at most.
const CHANGES: usize = 12;

/// All tables.
pub fn render(page: &mut Page, report: &Report, figure: Option<&Path>) {
    let constants = &report.case.constants;
    page.about(constants, &task(report));
    page.parameters(constants);
    if !report.curves.times.is_empty() {
        let heading = format!("At the start, {}", report.start.label);
        variables::snapshot(page, report, &report.start, &heading);
        variables::extremes(page, report);
        events::section(page, report);
        changes(page, report);
        measures::section(page, report.case.scene, &report.measures);
    }
    if let Some(rest) = report.motion.rest() {
        variables::snapshot(page, report, &report.start, "At rest");
        measures::section(page, report.case.scene, &report.measures);
        rest::section(page, report, rest);
    }
    for place in &report.places {
        let time = if place.label.starts_with("time") {
            String::new()
        } else {
            format!(", time = {} s", number::short(place.time))
        };
        variables::snapshot(page, report, place, &format!("At {}{time}", place.label));
    }
    published::section(page, &report.published);
    multipliers(page, report);
    page.figure(figure);
    page.line(&last_line(report));
}

/// The task in words.
fn task(report: &Report) -> String {
    let repeats = report.case.moved.repeats;
    match report.case.moved.task {
        Span::Periodic(_) if let Some((period, error)) = report.period() => format!(
            "steady state that repeats by itself, after {} s (± {})",
            number::with_error(period, error),
            number::error(error)
        ),
        Span::Periodic(all) if repeats > 1 => format!(
            "steady state that repeats after {} periods of {} s",
            repeats,
            number::short(all / repeats as f64)
        ),
        _ => report.case.task_in_words(),
    }
}

/// Where the motion might have gone on in several ways.
fn changes(page: &mut Page, report: &Report) {
    let shown = report.changes.iter().take(CHANGES);
    let shown: Vec<_> = shown.map(|time| number::short(number::rounded(*time, 7))).collect();
    if shown.is_empty() {
        return;
    }
    let more = if report.changes.len() > CHANGES { ", …" } else { "" };
    let line = format!(
        "change points at time = {}{more} s: closures depend on each other there for an instant, and the motion goes on by its momentum",
        shown.join(", ")
    );
    for (index, part) in wrap(&line, WIDTH - 4).iter().enumerate() {
        page.line(&format!("  {}{part}", if index == 0 { "" } else { "  " }));
    }
    page.line("");
}

fn multipliers(page: &mut Page, report: &Report) {
    if report.multipliers.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("modulus", Align::Point),
        ("± error", Align::Left),
        ("angle, deg", Align::Point),
        ("a disturbance", Align::Left),
    ]);
    let turn = report.case.turn();
    for multiplier in &report.multipliers {
        let angle = number::significant(multiplier.angle(), 6);
        table.row([
            format!("{:.9}", multiplier.modulus()),
            number::error(multiplier.error),
            if multiplier.pair { format!("±{angle}") } else { angle },
            multiplier.meaning(turn),
        ]);
    }
    let heading = format!("Floquet multipliers, what one {} does to a disturbance", turn.one());
    page.table(&heading, &table);
    for line in report.conclusions() {
        for (index, part) in wrap(&line, WIDTH - 4).iter().enumerate() {
            page.line(&format!("  {}{part}", if index == 0 { "" } else { "  " }));
        }
    }
    page.line("");
}

/// The price: estimated global error of what is printed, time spent, and what ten times more accuracy would cost.
fn last_line(report: &Report) -> String {
    let cost = &report.cost;
    if let Some(rest) = report.motion.rest() {
        return format!(
            "Errors are those of rounding. Found in {} by {} steps of Newton's method.",
            number::duration(cost.solve),
            number::count(rest.iterations)
        );
    }
    let error = match cost.worst {
        Some((index, share)) => {
            format!(
                "{}Estimated global error {} of the amplitude ({})",
                if report.is_inaccurate() { "INACCURATE. " } else { "" },
                number::error(share),
                report.case.variables[index].name
            )
        }
        None => "Estimated global error: rounding only".to_owned(),
    };
    let effort = report.motion.statistics();
    let work = if effort.evaluations > 0 {
        format!(
            "solved in {} by {} with rtol {:e}{} ({} steps{}, {} evaluations)",
            number::duration(cost.solve),
            report.motion.settings.method,
            report.motion.settings.rtol,
            atol_part(report),
            number::count(effort.steps),
            choice_part(report),
            number::count(effort.evaluations)
        )
    } else {
        format!("evaluated in {}", number::duration(cost.total))
    };
    let more = match cost.tenfold {
        _ if effort.rounded_steps > 0 => format!(
            "; in {} steps rounding is larger than the tolerance, so that a smaller --rtol gains nothing there",
            number::count(effort.rounded_steps)
        ),
        Some(factor) => {
            format!("; ten times more accuracy takes {factor:.2} times as many evaluations")
        }
        None if cost.is_cut_off => {
            "; the estimate with a tenth of the tolerance was cut off".to_owned()
        }
        None if effort.evaluations > 0 => {
            "; double precision has no room for ten times more accuracy".to_owned()
        }
        None => String::new(),
    };
    format!("{error}; {work}{more}.")
}

/// The absolute tolerances that are given.
fn atol_part(report: &Report) -> String {
    let given = given_atol(&report.motion.settings, report.case.scene);
    let parts = given.map(|(state, value)| {
        let value = unit::stated(value, state.factor);
        format!(", atol {value:e} {} of {}", state.unit, state.name)
    });
    parts.collect::<String>().replace("  ", " ")
}

/// What `auto` chose, and why.
fn choice_part(report: &Report) -> String {
    let motion = &report.motion;
    if motion.settings.method != Method::Auto {
        return String::new();
    }
    let took = motion.statistics();
    let switches = motion.switches();
    let from = |is: fn(Method) -> bool| {
        let first = switches.iter().find(|switch| is(switch.to));
        first.map(|switch| {
            format!("from t = {} s on", number::short(number::rounded(switch.time, 4)))
        })
    };
    let of_them = |steps: usize| match steps == took.steps {
        true => "all".to_owned(),
        false => format!("{} of them", number::count(steps)),
    };
    let stiff = of_them(took.stiff_steps);
    let stiff = match (took.stiff_steps, from(|to| to.stiff().is_some())) {
        (0, _) => String::new(),
        (_, Some(from)) => format!(", {stiff} stiff, {from}"),
        (_, None) => format!(", {stiff} stiff, on trial"),
    };
    let series = of_them(took.series_steps);
    let series = match (took.series_steps, from(|to| to == Method::Taylor)) {
        (0, _) => String::new(),
        (_, Some(from)) => format!(", {series} by Taylor series, which take less time {from}"),
        (_, None) => format!(", {series} by Taylor series, which take less time"),
    };
    match (series + &stiff, motion.task()) {
        // A steady state has no transient that would die out.
        (none, Span::Periodic(_)) if none.is_empty() => " by dop853".to_owned(),
        (none, _) if none.is_empty() => " by dop853, as nothing is stiff".to_owned(),
        (some, _) => some,
    }
}
