//! The answer of `assur run` as tables to read.

pub mod published;
mod variables;

use std::path::Path;

use assur::problem::Span;
use assur::registry::Method;

use crate::constants::Constants;
use crate::events;
use crate::list::composition;
use crate::measures;
use crate::number;
use crate::report::Report;
use crate::settings::given_atol;
use crate::style::Style;
use crate::text::{Align, Columns, wrap};

/// Widest line of prose.
pub const WIDTH: usize = 96;

/// All tables, with the last line ended.
pub fn render(report: &Report, figure: Option<&Path>, style: Style) -> String {
    let mut page = Page::new(style);
    head(&mut page, report);
    parameters(&mut page, &report.case.constants);
    if !report.curves.times.is_empty() {
        variables::snapshot(
            &mut page,
            report,
            &report.start,
            &format!("At the start, {}", report.start.label),
        );
        variables::extremes(&mut page, report);
        events::section(&mut page, report);
        measures::section(&mut page, report);
    }
    for place in &report.places {
        let time = if place.label.starts_with("time") {
            String::new()
        } else {
            format!(", time = {} s", number::short(place.time))
        };
        variables::snapshot(&mut page, report, place, &format!("At {}{time}", place.label));
    }
    published::section(&mut page, &report.published);
    multipliers(&mut page, report);
    if let Some(path) = figure {
        page.line(&format!("Figure: {}", path.display()));
    }
    page.line(&last_line(report));
    page.text
}

/// A text under construction.
pub struct Page {
    /// What is written so far.
    pub text: String,
    /// How it is emphasised.
    pub style: Style,
}

impl Page {
    /// An empty page.
    pub fn new(style: Style) -> Self {
        Self { text: String::new(), style }
    }

    /// Adds a line.
    pub fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    /// Adds a table under its heading.
    pub fn section(&mut self, heading: &str, table: &Columns) {
        let heading = self.style.heading(heading);
        self.line(&heading);
        self.text += &table.render(self.style);
    }
}

fn head(page: &mut Page, report: &Report) {
    let scene = report.case.scene;
    let task = match report.case.task {
        Span::Periodic(_) if let Some((period, error)) = report.period() => format!(
            "steady state that repeats by itself, after {} s (± {})",
            number::with_error(period, error),
            number::error(error)
        ),
        Span::Periodic(all) if report.case.repeats > 1 => format!(
            "steady state that repeats after {} periods of {} s",
            report.case.repeats,
            number::short(all / report.case.repeats as f64)
        ),
        Span::Periodic(period) => {
            format!("steady state over one period of {} s", number::short(period))
        }
        Span::Run(from, to) => {
            format!("motion from {} s to {} s", number::short(from), number::short(to))
        }
        Span::Open | Span::Autonomous => "positions".to_owned(),
    };
    let title = format!("{}, scene {}: {task}", report.mechanism.title, scene.name);
    about(page, &title, &report.case.constants);
}

/// The title, and what is in the scene.
pub fn about(page: &mut Page, title: &str, constants: &Constants) {
    let scene = constants.scene;
    page.line(&page.style.heading(title));
    let mut about = composition(scene);
    if !scene.summary.is_empty() {
        about = format!("{} ({about})", scene.summary.lines().next().unwrap_or(""));
    }
    if !constants.preset.is_empty() {
        about += &format!(", preset {}", constants.preset);
    }
    page.line(&format!("  {about}"));
    page.line("");
}

/// The dimensions and parameters with their values.
pub fn parameters(page: &mut Page, constants: &Constants) {
    if constants.values.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("", Align::Left),
        ("", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("default", Align::Point),
        ("", Align::Left),
    ]);
    for (index, constant) in constants.scene.constants.iter().enumerate() {
        let quantity = &constant.quantity;
        let changed = constants.is_changed(index);
        let default = if changed {
            number::declared(constant.default / quantity.factor)
        } else {
            String::new()
        };
        table.row([
            if changed { "*" } else { "" }.to_owned(),
            quantity.name.to_owned(),
            number::declared(constants.values[index] / quantity.factor),
            quantity.unit.to_owned(),
            default,
            first_line(quantity.summary),
        ]);
    }
    let heading = if constants.changed() { "Parameters (* changed)" } else { "Parameters" };
    page.section(heading, &table);
    page.line("");
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or("").to_owned()
}

fn multipliers(page: &mut Page, report: &Report) {
    if report.multipliers.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("modulus", Align::Point),
        ("angle, deg", Align::Point),
        ("a disturbance", Align::Left),
    ]);
    let turn = report.case.turn();
    for multiplier in &report.multipliers {
        let angle = number::significant(multiplier.angle(), 6);
        table.row([
            format!("{:.9}", multiplier.modulus()),
            if multiplier.pair { format!("±{angle}") } else { angle },
            multiplier.meaning(turn),
        ]);
    }
    let heading = format!("Floquet multipliers, what one {} does to a disturbance", turn.one());
    page.section(&heading, &table);
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
            stiff_part(report),
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
        Some(factor) => format!("; ten times more accuracy takes {factor:.2} times as long"),
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
    let parts = given.into_iter();
    let parts = parts.map(|(name, unit, value)| format!(", atol {value:e} {unit} of {name}"));
    parts.collect::<String>().replace("  ", " ")
}

/// How many of the steps were stiff ones, where `auto` chose.
fn stiff_part(report: &Report) -> String {
    if report.motion.settings.method != Method::Auto {
        return String::new();
    }
    let stiff = number::count(report.motion.statistics().stiff_steps);
    match report.motion.switches().first() {
        Some(first) => format!(", {stiff} of them stiff, from t = {:.3e} s on", first.time),
        None => format!(", {stiff} of them stiff"),
    }
}
