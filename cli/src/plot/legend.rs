//! The heading of a panel with its legend.

use super::name::Name;
use super::panels::{Line, Panel};
use super::svg::{Anchor, Svg};
use crate::show::text;

/// Width of a character at 12 pixels; rather too wide than too narrow.
pub const CHARACTER: f64 = 7.0;
/// Height of a row of labels or of a legend.
pub const ROW: f64 = 16.0;
/// Curves that can be told apart by colour.
const COLOURS: usize = 7;

/// The class of a curve.
pub fn colour(number: Option<usize>) -> String {
    number.map_or("c".to_owned(), |number| format!("c{}", number % COLOURS))
}

/// Width of a text at 12 pixels.
pub fn text_width(label: &str) -> f64 {
    text::width(label) as f64 * CHARACTER
}

/// Rows that the legend needs below the heading; none if it fits beside it.
pub fn rows(panel: &Panel, width: f64) -> usize {
    let heading = (text::width(&heading(panel)) + 2) as f64 * (CHARACTER + 1.2);
    let legend: f64 = panel.curves.iter().map(entry_width).sum();
    if heading + legend <= width {
        return 0;
    }
    let (mut rows, mut x) = (1, 0.0);
    for entry in panel.curves.iter().map(entry_width) {
        if x + entry > width && x > 0.0 {
            (rows, x) = (rows + 1, 0.0);
        }
        x += entry;
    }
    rows
}

fn heading(panel: &Panel) -> String {
    if panel.unit.is_empty() {
        panel.title.clone()
    } else {
        format!("{}, {}", panel.title, panel.unit)
    }
}

/// Draws the heading, and the legend beside it or in rows below it.
pub fn draw(svg: &mut Svg, panel: &Panel, (left, right): (f64, f64), y: f64) {
    svg.text("heading", (left, y), Anchor::Start, &heading(panel));
    let below = rows(panel, right - left) > 0;
    let total: f64 = panel.curves.iter().map(entry_width).sum();
    let (mut x, mut line) = if below { (left, y + ROW) } else { (right - total + 14.0, y) };
    for curve in &panel.curves {
        let width = entry_width(curve);
        if below && x + width > right && x > left {
            (x, line) = (left, line + ROW);
        }
        let class = format!("curve {}", colour(curve.colour));
        svg.line(&class, (x, line - 4.0), (x + 26.0, line - 4.0));
        names(svg, (x + 31.0, line), &curve.names);
        x += width;
    }
}

/// Width of an entry of a legend: a piece of the line, and the names.
fn entry_width(line: &Line) -> f64 {
    let characters = line.names.iter().map(|name| text::width(&name.text) + 2);
    31.0 + characters.sum::<usize>() as f64 * (CHARACTER + 0.6) + 4.0
}

/// Names beside a piece of line.
fn names(svg: &mut Svg, place: (f64, f64), names: &[Name]) {
    let text: Vec<_> = names.iter().map(|name| name.text.as_str()).collect();
    let letters = names.iter().all(|name| name.italic);
    let class = if letters { "letter" } else { "unit" };
    svg.text(class, place, Anchor::Start, &text.join(", "));
}
