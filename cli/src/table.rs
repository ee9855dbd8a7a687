//! The answer of `assur run` as tables to read.

use std::path::Path;

use crate::list::composition;
use crate::motion::Task;
use crate::multipliers::conclusions;
use crate::number;
use crate::report::{Report, Snapshot};
use crate::style::Style;
use crate::text::{Align, Columns, wrap};
use crate::values::method_name;

/// Widest line of prose.
const WIDTH: usize = 96;

/// All tables, with the last line ended.
pub fn render(report: &Report, figure: Option<&Path>, style: Style) -> String {
    let mut page = Page {
        text: String::new(),
        style,
    };
    head(&mut page, report);
    parameters(&mut page, report);
    if !report.curves.times.is_empty() {
        snapshot(
            &mut page,
            report,
            &report.start,
            &format!("At the start, {}", report.start.label),
        );
        extremes(&mut page, report);
    }
    for place in &report.places {
        let time = if place.label.starts_with("time") {
            String::new()
        } else {
            format!(", time = {} s", number::short(place.time))
        };
        snapshot(
            &mut page,
            report,
            place,
            &format!("At {}{time}", place.label),
        );
    }
    published(&mut page, report);
    multipliers(&mut page, report);
    if let Some(path) = figure {
        page.line(&format!("Figure: {}", path.display()));
    }
    page.line(&last_line(report));
    page.text
}

struct Page {
    text: String,
    style: Style,
}

impl Page {
    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    fn section(&mut self, heading: &str, table: &Columns) {
        let heading = self.style.heading(heading);
        self.line(&heading);
        for (index, line) in table.lines().iter().enumerate() {
            let line = if index == 0 {
                self.style.faint(line)
            } else {
                line.clone()
            };
            self.line(&line);
        }
    }
}

fn head(page: &mut Page, report: &Report) {
    let scene = report.case.scene;
    let (from, to) = report.case.task.limits();
    let task = match report.case.task {
        Task::Periodic(period) => format!(
            "steady state over one period of {} s",
            number::short(period)
        ),
        Task::Run(..) => format!(
            "motion from {} s to {} s",
            number::short(from),
            number::short(to)
        ),
        Task::Open => "positions".to_owned(),
    };
    let title = format!("{}, scene {}: {task}", report.mechanism.title, scene.name);
    page.line(&page.style.heading(&title));
    let mut about = composition(scene);
    if !scene.summary.is_empty() {
        about = format!("{} ({about})", scene.summary.lines().next().unwrap_or(""));
    }
    if !report.case.constants.preset.is_empty() {
        about += &format!(", preset {}", report.case.constants.preset);
    }
    page.line(&format!("  {about}"));
    page.line("");
}

fn parameters(page: &mut Page, report: &Report) {
    let constants = &report.case.constants;
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
    for (index, constant) in report.case.scene.constants.iter().enumerate() {
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
    let heading = if constants.changed() {
        "Parameters (* changed)"
    } else {
        "Parameters"
    };
    page.section(heading, &table);
    page.line("");
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or("").to_owned()
}

fn snapshot(page: &mut Page, report: &Report, snapshot: &Snapshot, heading: &str) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("± error", Align::Left),
        ("", Align::Left),
    ]);
    let rows = report
        .case
        .variables
        .iter()
        .zip(&snapshot.values)
        .zip(&report.errors);
    for ((variable, value), error) in rows {
        table.row([
            variable.name.clone(),
            number::with_error(variable.in_unit(*value), variable.in_unit(*error)),
            variable.unit.clone(),
            number::error(variable.in_unit(*error)),
            variable.summary.clone(),
        ]);
    }
    page.section(heading, &table);
    page.line("");
}

fn extremes(page: &mut Page, report: &Report) {
    let place = match report.case.scene.drivers.first() {
        Some(driver) if driver.unit.is_empty() => format!("at {}", driver.name),
        Some(driver) => format!("at {}, {}", driver.name, driver.unit),
        None => "at time, s".to_owned(),
    };
    let mut table = Columns::new([
        ("", Align::Left),
        ("smallest", Align::Point),
        (&place, Align::Point),
        ("largest", Align::Point),
        (&place, Align::Point),
        ("unit", Align::Left),
    ]);
    let time = |time: f64| {
        let position = report.case.drivers(time).first().copied();
        let shown = match (position, report.case.scene.drivers.first()) {
            (Some(position), Some(driver)) => position / driver.factor,
            _ => time,
        };
        number::short(number::significant(shown, 5).parse().unwrap_or(shown))
    };
    for ((variable, extreme), error) in report
        .case
        .variables
        .iter()
        .zip(&report.extremes)
        .zip(&report.errors)
    {
        let show = |value: f64| {
            number::with_error(
                variable.in_unit(value),
                variable.in_unit(error.max(1e-8 * extreme.amplitude())),
            )
        };
        table.row([
            variable.name.clone(),
            show(extreme.minimum.1),
            time(extreme.minimum.0),
            show(extreme.maximum.1),
            time(extreme.maximum.0),
            variable.unit.clone(),
        ]);
    }
    let over = if report.is_cycle() {
        "Over the period"
    } else {
        "Over the run"
    };
    page.section(over, &table);
    page.line("");
}

fn published(page: &mut Page, report: &Report) {
    if report.published.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("", Align::Left),
        ("where", Align::Left),
        ("published", Align::Point),
        ("computed", Align::Point),
        ("unit", Align::Left),
        ("deviation", Align::Left),
        ("", Align::Right),
        ("band", Align::Left),
        ("", Align::Left),
        ("", Align::Left),
    ]);
    let mut remarks: Vec<&str> = Vec::new();
    for comparison in &report.published {
        let variable = &report.case.variables[comparison.variable];
        let error = report.errors[comparison.variable].max(1e-7 * comparison.computed.abs());
        let note = if comparison.fact.remark.is_empty() {
            String::new()
        } else {
            let known = remarks
                .iter()
                .position(|remark| *remark == comparison.fact.remark);
            let number = known.unwrap_or_else(|| {
                remarks.push(comparison.fact.remark);
                remarks.len() - 1
            });
            format!("[{}]", number + 1)
        };
        table.row([
            variable.name.clone(),
            comparison.place.clone(),
            number::declared(variable.in_unit(comparison.fact.value)),
            number::with_error(
                variable.in_unit(comparison.computed),
                variable.in_unit(error),
            ),
            variable.unit.clone(),
            number::signed(variable.in_unit(comparison.deviation()), 2),
            number::percent(comparison.relative()),
            format!(
                "± {}",
                number::short(variable.in_unit(comparison.fact.tolerance))
            ),
            match comparison.within() {
                Some(true) => "within",
                Some(false) => "OUTSIDE",
                None => "-",
            }
            .to_owned(),
            note,
        ]);
    }
    page.section("Published values", &table);
    for (index, remark) in remarks.iter().enumerate() {
        for (line, part) in wrap(remark, WIDTH - 8).iter().enumerate() {
            let lead = if line == 0 {
                format!("[{}]", index + 1)
            } else {
                String::new()
            };
            let line = page.style.faint(&format!("  {lead:<5}{part}"));
            page.line(&line);
        }
    }
    if report
        .published
        .iter()
        .any(|comparison| !comparison.comparable)
    {
        let line = page
            .style
            .warn("  (-) published for other values than those of this run: not comparable");
        page.line(&line);
    }
    page.line("");
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
    for multiplier in &report.multipliers {
        let angle = number::significant(multiplier.angle(), 6);
        table.row([
            format!("{:.9}", multiplier.modulus()),
            if multiplier.pair {
                format!("±{angle}")
            } else {
                angle
            },
            multiplier.meaning(),
        ]);
    }
    page.section(
        "Floquet multipliers, what one period does to a disturbance",
        &table,
    );
    for line in conclusions(&report.multipliers) {
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
                "Estimated global error {} of the amplitude ({})",
                number::error(share),
                report.case.variables[index].name
            )
        }
        None => "Estimated global error: rounding only".to_owned(),
    };
    let effort = report.motion.effort();
    let work = if effort.evaluations > 0 {
        format!(
            "solved in {} by {} with rtol {:e} ({} steps, {} evaluations)",
            number::duration(cost.solve),
            method_name(report.motion.settings.method),
            report.motion.settings.rtol,
            number::count(effort.steps),
            number::count(effort.evaluations)
        )
    } else {
        format!("evaluated in {}", number::duration(cost.total))
    };
    let more = match cost.tenfold {
        Some(factor) => format!("; ten times more accuracy takes {factor:.2} times as long"),
        None if effort.evaluations > 0 => {
            "; double precision has no room for ten times more accuracy".to_owned()
        }
        None => String::new(),
    };
    format!("{error}; {work}{more}.")
}
