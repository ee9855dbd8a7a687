//! The layout of a figure: panels one below the other in one or two columns, with common positions marked.

use super::axis::Axis;
use super::curve;
use super::marks::{self, Mark};
use super::name::{self, Name};
use super::panels::{self, Line, Panel};
use super::scale::Scale;
use super::svg::{Anchor, Svg};
use crate::number;
use crate::report::Report;
use crate::text;
use crate::values::method_name;

/// Left of the plotting area of a column: numbers of the axis.
const LEFT: f64 = 66.0;
/// Width of the plotting area of a column.
const WIDTH: f64 = 452.0;
/// Width of the plotting area when there is one column only.
const WIDTH_ALONE: f64 = 620.0;
/// Right of the plotting area of a column.
const RIGHT: f64 = 24.0;
/// Height of the plotting area of a panel.
const HEIGHT: f64 = 148.0;
/// Above the plotting area of a panel: its heading.
const HEADING: f64 = 27.0;
/// Below the plotting area of a panel.
const BELOW: f64 = 17.0;
/// Below the last panel: numbers and title of the axis.
const FOOT: f64 = 50.0;
/// Height of a row of labels or of a legend.
const ROW: f64 = 16.0;
/// Width of a character at 12 pixels; rather too wide than too narrow.
const CHARACTER: f64 = 7.0;
/// Curves that can be told apart by colour.
const COLOURS: usize = 7;

const STYLE: &str = "\
text { font-family: 'Source Sans 3', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif; font-size: 12px; fill: #24292f; }
.paper { fill: #ffffff; }
.title { font-size: 20px; font-weight: 600; }
.lead { font-size: 13px; fill: #57606a; }
.heading { font-size: 13px; font-weight: 600; }
.unit { fill: #57606a; }
.number { fill: #57606a; font-size: 11.5px; }
.letter { font-style: italic; font-size: 13px; }
.mark { font-size: 11.5px; fill: #57606a; }
.named { font-size: 11.5px; fill: #9a3412; }
.frame { fill: none; stroke: #8c959f; stroke-width: 1; }
.grid { stroke: #e6e9ed; stroke-width: 1; }
.zero { stroke: #8c959f; stroke-width: 1; }
.dead { stroke: #8c959f; stroke-width: 1; stroke-dasharray: 2 3; }
.place { stroke: #c2410c; stroke-width: 1.1; stroke-dasharray: 6 3; }
.curve { fill: none; stroke-width: 1.8; stroke-linejoin: round; stroke-linecap: butt; }
.fact { fill: #ffffff; stroke-width: 1.5; }
.c { stroke: #24292f; }
.c0 { stroke: #0072b2; }
.c1 { stroke: #d55e00; stroke-dasharray: 9 3; }
.c2 { stroke: #009e73; stroke-dasharray: 14 3 3 3; }
.c3 { stroke: #aa4499; stroke-dasharray: 4 2.5; }
.c4 { stroke: #8a6d00; }
.c5 { stroke: #56b4e9; stroke-dasharray: 9 3; }
.c6 { stroke: #882255; stroke-dasharray: 14 3 3 3; }
.fact, .solid { stroke-dasharray: none; }
";

/// Draws the figure of a report.
pub fn draw(report: &Report) -> String {
    let across = Across::new(report);
    let abscissa = |time: f64| across.at(report, time);
    let positions: Vec<f64> = report
        .curves
        .times
        .iter()
        .map(|time| abscissa(*time))
        .collect();
    let panels = panels::choose(report, &abscissa);
    let marks = marks::find(report, &positions, &abscissa);
    let columns = arrange(panels);
    let width = if columns.len() == 1 {
        WIDTH_ALONE
    } else {
        WIDTH
    };
    let whole = columns.len().max(1) as f64 * (LEFT + width + RIGHT);
    let lead = lead(report, ((whole - LEFT - RIGHT) / CHARACTER) as usize);
    let top = 52.0 + 18.0 * lead.len() as f64;
    let mut sheets: Vec<Column<'_>> = Vec::new();
    for (index, panels) in columns.iter().enumerate() {
        let left = index as f64 * (LEFT + width + RIGHT) + LEFT;
        let (low, high) = across.ends(&positions);
        let scale = Scale {
            values: (low, high),
            pixels: (left, left + width),
        };
        sheets.push(Column {
            panels,
            scale,
            axis: across.axis(low, high, width),
            labels: stagger(&marks, &scale),
        });
    }
    let bottom = sheets
        .iter()
        .map(|sheet| sheet.height(top))
        .fold(top, f64::max);
    let mut svg = Svg::new(whole, bottom + 34.0);
    svg.rectangle("paper", (0.0, 0.0), (whole, bottom + 34.0));
    svg.text("title", (LEFT, 34.0), Anchor::Start, &title(report));
    for (index, line) in lead.iter().enumerate() {
        svg.text(
            "lead",
            (LEFT, 56.0 + 18.0 * index as f64),
            Anchor::Start,
            line,
        );
    }
    for sheet in &sheets {
        sheet.draw(&mut svg, top, &positions, &across.title);
    }
    foot(&mut svg, report, &columns, bottom + 16.0);
    svg.finish(&title(report), &lead.join(" "), STYLE)
}

/// The horizontal axis: the first driver where it advances steadily through a steady state, else the time.
struct Across {
    driver: bool,
    degrees: bool,
    factor: f64,
    title: String,
}

impl Across {
    fn new(report: &Report) -> Self {
        let driver = report.case.scene.drivers.first();
        let steady =
            report
                .curves
                .drivers
                .windows(2)
                .all(|pair| match (pair[0].first(), pair[1].first()) {
                    (Some(before), Some(after)) => before < after,
                    _ => false,
                });
        match driver.filter(|_| steady && report.is_cycle()) {
            Some(driver) => {
                let degrees = matches!(driver.unit, "rad" | "deg");
                let (unit, factor) = if degrees {
                    ("°".to_owned(), 1f64.to_radians())
                } else {
                    (name::unit(driver.unit), driver.factor)
                };
                let what = driver.summary.lines().next().unwrap_or("");
                let title = [what, &name::set(driver.name).text]
                    .join(" ")
                    .trim()
                    .to_owned();
                let title = if unit.is_empty() {
                    title
                } else {
                    format!("{title}, {unit}")
                };
                Self {
                    driver: true,
                    degrees,
                    factor,
                    title,
                }
            }
            None => Self {
                driver: false,
                degrees: false,
                factor: 1.0,
                title: "time, s".to_owned(),
            },
        }
    }

    fn at(&self, report: &Report, time: f64) -> f64 {
        let driven = if self.driver {
            report.case.drivers(time).first().copied()
        } else {
            None
        };
        driven.unwrap_or(time) / self.factor
    }

    fn ends(&self, positions: &[f64]) -> (f64, f64) {
        match (positions.first(), positions.last()) {
            (Some(first), Some(last)) if first < last => (*first, *last),
            (Some(first), _) => (*first, first + 1.0),
            _ => (0.0, 1.0),
        }
    }

    fn axis(&self, low: f64, high: f64, width: f64) -> Axis {
        let intervals = (width / 62.0) as usize;
        if self.degrees {
            Axis::degrees(low, high, intervals)
        } else {
            Axis::between(low, high, intervals)
        }
    }
}

/// Panels in one or two columns: translations on the left, rotations on the right, others where there is room.
fn arrange(panels: Vec<Panel>) -> Vec<Vec<Panel>> {
    let mut columns = vec![Vec::new(), Vec::new()];
    for panel in panels {
        let shorter = usize::from(columns[1].len() < columns[0].len());
        columns[panel.kind.rank().0.unwrap_or(shorter)].push(panel);
    }
    columns.retain(|column| !column.is_empty());
    columns
}

/// One column of panels above a common axis.
struct Column<'a> {
    panels: &'a [Panel],
    scale: Scale,
    axis: Axis,
    /// Marks with the row of their label; none where the label is left out.
    labels: Vec<(&'a Mark, usize)>,
}

impl Column<'_> {
    fn rows(&self) -> usize {
        self.labels
            .iter()
            .map(|(_, row)| row + 1)
            .max()
            .unwrap_or(0)
    }

    fn width(&self) -> f64 {
        self.scale.pixels.1 - self.scale.pixels.0
    }

    /// Where the column ends if it begins at this height.
    fn height(&self, top: f64) -> f64 {
        let panels = self
            .panels
            .iter()
            .map(|panel| HEADING + self.legend_rows(panel) as f64 * ROW + HEIGHT + BELOW);
        top + self.rows() as f64 * ROW + panels.sum::<f64>() - BELOW + FOOT
    }

    /// Rows that the legend needs below the heading; none if it fits beside it.
    fn legend_rows(&self, panel: &Panel) -> usize {
        let heading = (panel.title.chars().count() + panel.unit.chars().count() + 4) as f64
            * (CHARACTER + 1.2);
        let legend: f64 = panel.curves.iter().map(entry_width).sum();
        if heading + legend <= self.width() {
            0
        } else {
            (legend / self.width()).ceil().max(1.0) as usize
        }
    }

    fn draw(&self, svg: &mut Svg, top: f64, positions: &[f64], title: &str) {
        let mut y = top;
        for (index, panel) in self.panels.iter().enumerate() {
            svg.begin(&panel.title);
            let legend = self.legend_rows(panel);
            self.heading(svg, panel, y + 15.0, legend);
            y += HEADING + legend as f64 * ROW;
            if index == 0 {
                let rows = self.rows();
                self.mark_labels(svg, y, rows);
                y += rows as f64 * ROW;
            }
            self.panel(svg, panel, y, positions);
            svg.end();
            y += HEIGHT + BELOW;
        }
        let foot = y - BELOW;
        for tick in &self.axis.ticks {
            svg.text(
                "number",
                (self.scale.pixel(*tick), foot + 17.0),
                Anchor::Middle,
                &self.axis.label(*tick),
            );
        }
        let middle = (self.scale.pixels.0 + self.scale.pixels.1) / 2.0;
        svg.text("unit", (middle, foot + 38.0), Anchor::Middle, title);
    }

    fn heading(&self, svg: &mut Svg, panel: &Panel, y: f64, legend_rows: usize) {
        let (left, right) = self.scale.pixels;
        let heading = if panel.unit.is_empty() {
            panel.title.clone()
        } else {
            format!("{}, {}", panel.title, panel.unit)
        };
        svg.text("heading", (left, y), Anchor::Start, &heading);
        let total: f64 = panel.curves.iter().map(entry_width).sum();
        let (mut x, mut line) = if legend_rows == 0 {
            (right - total + 14.0, y)
        } else {
            (left, y + ROW)
        };
        for curve in &panel.curves {
            let width = entry_width(curve);
            if legend_rows > 0 && x + width > right && x > left {
                (x, line) = (left, line + ROW);
            }
            svg.line(
                &format!("curve {}", colour(curve.colour)),
                (x, line - 4.0),
                (x + 26.0, line - 4.0),
            );
            names(svg, (x + 31.0, line), &curve.names);
            x += width;
        }
    }

    fn mark_labels(&self, svg: &mut Svg, y: f64, rows: usize) {
        for (mark, row) in &self.labels {
            let (x, half) = (self.scale.pixel(mark.at), label_width(&mark.label) / 2.0);
            let middle = x.clamp(
                self.scale.pixels.0 + half,
                (self.scale.pixels.1 - half).max(self.scale.pixels.0 + half),
            );
            let base =
                y + (rows - 1 - row.min(&(rows - 1))) as f64 * 0.0 + *row as f64 * ROW + 10.0;
            svg.line(
                line_class(mark),
                (x, base + 3.0),
                (x, y + rows as f64 * ROW),
            );
            svg.text(
                if mark.asked { "named" } else { "mark" },
                (middle, base),
                Anchor::Middle,
                &mark.label,
            );
        }
    }

    fn panel(&self, svg: &mut Svg, panel: &Panel, top: f64, positions: &[f64]) {
        let (left, right) = self.scale.pixels;
        let bottom = top + HEIGHT;
        let values = panel
            .curves
            .iter()
            .flat_map(|line| line.values.iter().copied());
        let values = values
            .chain(panel.facts.iter().map(|fact| fact.1))
            .filter(|value| value.is_finite());
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let axis = Axis::around(low, high, 4);
        let up = Scale {
            values: axis.ends,
            pixels: (bottom, top),
        };
        for tick in &self.axis.ticks {
            let x = self.scale.pixel(*tick);
            svg.line("grid", (x, top), (x, bottom));
        }
        for tick in &axis.ticks {
            let y = up.pixel(*tick);
            svg.line(
                if *tick == 0.0 { "zero" } else { "grid" },
                (left, y),
                (right, y),
            );
            svg.text(
                "number",
                (left - 7.0, y + 4.0),
                Anchor::End,
                &axis.label(*tick),
            );
        }
        for (mark, _) in &self.labels {
            let x = self.scale.pixel(mark.at);
            svg.line(line_class(mark), (x, top), (x, bottom));
        }
        svg.rectangle("frame", (left, top), (right - left, HEIGHT));
        for line in &panel.curves {
            let points = positions
                .iter()
                .zip(&line.values)
                .map(|(x, y)| (self.scale.pixel(*x), up.pixel(*y)));
            let points: Vec<_> = points.collect();
            svg.path(
                &format!("curve {}", colour(line.colour)),
                &curve::simplify(&points),
            );
        }
        for (x, y, number) in &panel.facts {
            if self.scale.contains(*x) {
                svg.circle(
                    &format!("{} fact", colour(*number)),
                    (self.scale.pixel(*x), up.pixel(*y)),
                    3.6,
                );
            }
        }
    }
}

fn line_class(mark: &Mark) -> &'static str {
    if mark.asked { "place" } else { "dead" }
}

fn colour(number: Option<usize>) -> String {
    number.map_or("c".to_owned(), |number| format!("c{}", number % COLOURS))
}

fn label_width(label: &str) -> f64 {
    text::width(label) as f64 * CHARACTER
}

/// Width of an entry of a legend: a piece of the line, and the names.
fn entry_width(line: &Line) -> f64 {
    let characters: usize = line
        .names
        .iter()
        .map(|name| text::width(&name.text) + 2)
        .sum();
    31.0 + characters as f64 * (CHARACTER + 0.6) + 4.0
}

/// Names beside a piece of line.
fn names(svg: &mut Svg, place: (f64, f64), names: &[Name]) {
    let text = names
        .iter()
        .map(|name| name.text.as_str())
        .collect::<Vec<_>>()
        .join(", ");
    let class = if names.iter().all(|name| name.italic) {
        "letter"
    } else {
        "unit"
    };
    svg.text(class, place, Anchor::Start, &text);
}

/// Gives each mark a row for its label, so that labels do not touch.
fn stagger<'a>(marks: &'a [Mark], scale: &Scale) -> Vec<(&'a Mark, usize)> {
    let mut ends: Vec<f64> = Vec::new();
    let mut labels = Vec::new();
    for mark in marks.iter().filter(|mark| scale.contains(mark.at)) {
        let width = label_width(&mark.label);
        let middle = scale.pixel(mark.at).clamp(
            scale.pixels.0 + width / 2.0,
            (scale.pixels.1 - width / 2.0).max(scale.pixels.0 + width / 2.0),
        );
        let row = ends
            .iter()
            .position(|end| middle - width / 2.0 > end + 8.0)
            .unwrap_or(ends.len());
        if row == ends.len() {
            ends.push(0.0);
        }
        ends[row] = middle + width / 2.0;
        labels.push((mark, row));
    }
    labels
}

fn title(report: &Report) -> String {
    let what = if report.is_cycle() {
        "steady state over one period"
    } else {
        "motion"
    };
    format!("{}: {what}", report.mechanism.title)
}

/// What the scene is, and which values were changed, in lines of at most this many characters.
fn lead(report: &Report, limit: usize) -> Vec<String> {
    let scene = report.case.scene;
    let mut sentence = format!("Scene {}", scene.name);
    if let Some(line) = scene.summary.lines().next().filter(|line| !line.is_empty()) {
        sentence += &format!(": {}", line.trim_end_matches('.'));
    }
    let constants = &report.case.constants;
    let changed = scene
        .constants
        .iter()
        .enumerate()
        .filter(|(index, _)| constants.is_changed(*index))
        .map(|(index, constant)| {
            let quantity = &constant.quantity;
            let value = number::declared(constants.values[index] / quantity.factor);
            format!(
                "{} = {value} {}",
                name::set(quantity.name).text,
                name::unit(quantity.unit)
            )
            .trim_end()
            .to_owned()
        });
    let changed: Vec<_> = changed.collect();
    if !changed.is_empty() {
        sentence += &format!(". With {}", changed.join(", "));
    }
    text::wrap(&(sentence + "."), limit)
}

/// How the curves were made, and what the circles are.
fn foot(svg: &mut Svg, report: &Report, columns: &[Vec<Panel>], y: f64) {
    let mut x = LEFT;
    if columns
        .iter()
        .flatten()
        .any(|panel| !panel.facts.is_empty())
    {
        svg.circle("c fact", (x + 4.0, y - 4.0), 3.6);
        svg.text("unit", (x + 14.0, y), Anchor::Start, "published value");
        x += 132.0;
    }
    let mut made = format!(
        "{} with rtol {:e}",
        method_name(report.motion.settings.method),
        report.motion.settings.rtol
    );
    if let Some((_, share)) = report.cost.worst {
        made += &format!(
            ", estimated error {} of the amplitude",
            number::error(share)
        );
    }
    if report.motion.effort().evaluations == 0 {
        "closed form".clone_into(&mut made);
    }
    svg.text("number", (x, y), Anchor::Start, &made);
}
