//! One column of panels above a common axis.

use super::axis::Axis;
use super::bands::{Band, Bands};
use super::curve;
use super::legend::{self, ROW};
use super::marks::{self, Label, Mark};
use super::panels::Panel;
use super::scale::Scale;
use super::svg::{Anchor, Svg};

/// Height of the plotting area of a panel.
const HEIGHT: f64 = 156.0;
/// Above the plotting area of a panel: its heading.
const HEADING: f64 = 27.0;
/// Below the plotting area of a panel.
const BELOW: f64 = 19.0;
/// Below the last panel: numbers and title of the axis.
const FOOT: f64 = 50.0;

/// One column of panels above a common axis.
pub struct Column<'a> {
    panels: &'a [Panel],
    scale: Scale,
    axis: Axis,
    labels: Vec<Label<'a>>,
    bands: Bands<'a>,
}

impl<'a> Column<'a> {
    /// A column of these panels; `scale` is horizontal.
    pub fn new(
        panels: &'a [Panel],
        scale: Scale,
        axis: Axis,
        marks: &'a [Mark],
        bands: &'a [Band],
    ) -> Self {
        let labels = marks::labels(marks, &scale);
        Self { panels, scale, axis, labels, bands: Bands::new(bands, scale) }
    }

    /// Height of the labels of marks.
    fn label_height(&self) -> f64 {
        let rows = self.labels.iter().map(|label| label.row + 1).max();
        rows.map_or(0.0, |rows| rows as f64 * ROW + 5.0)
    }

    fn heading_height(&self, panel: &Panel) -> f64 {
        let (left, right) = self.scale.pixels;
        HEADING + legend::rows(panel, right - left) as f64 * ROW
    }

    /// Where the column ends if it begins at this height.
    pub fn bottom(&self, top: f64) -> f64 {
        let panels = self.panels.iter().map(|panel| self.heading_height(panel) + HEIGHT + BELOW);
        let modes = self.bands.strip_height() + self.bands.legend_height();
        top + self.label_height() + panels.sum::<f64>() - BELOW + modes + FOOT
    }

    /// Draws the column from this height downwards, `title` below its axis.
    pub fn draw(&self, svg: &mut Svg, top: f64, positions: &[f64], title: &str) {
        let (left, right) = self.scale.pixels;
        let mut y = top;
        for (index, panel) in self.panels.iter().enumerate() {
            svg.begin(&panel.title);
            legend::draw(svg, panel, (left, right), y + 15.0);
            y += self.heading_height(panel);
            if index == 0 {
                self.draw_labels(svg, y);
                y += self.label_height();
            }
            self.panel(svg, panel, y, positions);
            svg.end();
            y += HEIGHT + BELOW;
        }
        self.bands.strip(svg, y - BELOW + 5.0);
        let foot = y - BELOW + self.bands.strip_height();
        for tick in &self.axis.ticks {
            let place = (self.scale.pixel(*tick), foot + 17.0);
            svg.text("number", place, Anchor::Middle, &self.axis.label(*tick));
        }
        let middle = ((left + right) / 2.0, foot + 38.0);
        svg.text("unit", middle, Anchor::Middle, title);
        self.bands.legend(svg, foot + FOOT - 4.0);
    }

    /// Labels of the marks, each with a line down to the panel below.
    fn draw_labels(&self, svg: &mut Svg, y: f64) {
        let frame = y + self.label_height();
        for label in &self.labels {
            let base = frame - 9.0 - label.row as f64 * ROW;
            let x = self.scale.pixel(label.mark.at);
            svg.line(line_class(label.mark), (x, base + 3.0), (x, frame));
            let class = if label.mark.asked { "named" } else { "mark" };
            svg.text(class, (label.left, base), Anchor::Start, &label.mark.label);
        }
    }

    fn panel(&self, svg: &mut Svg, panel: &Panel, top: f64, positions: &[f64]) {
        let (left, right) = self.scale.pixels;
        let bottom = top + HEIGHT;
        let axis = vertical(panel);
        let up = Scale { values: axis.ends, pixels: (bottom, top) };
        self.bands.behind(svg, (top, HEIGHT));
        self.grid(svg, &axis, &up);
        svg.rectangle("frame", (left, top), (right - left, HEIGHT));
        for line in &panel.curves {
            let points = positions
                .iter()
                .zip(&line.values)
                .map(|(x, y)| (self.scale.pixel(*x), up.pixel(*y)));
            let points: Vec<_> = points.collect();
            let class = format!("curve {}", legend::colour(line.colour));
            svg.path(&class, &curve::simplify(&points));
        }
        for fact in &panel.facts {
            let colour = panel.curves.get(fact.curve).and_then(|line| line.colour);
            if self.scale.contains(fact.at) {
                let class = format!("{} fact", legend::colour(colour));
                let centre = (self.scale.pixel(fact.at), up.pixel(fact.value));
                svg.circle(&class, centre, 3.6);
            }
        }
    }

    /// Lines at the ticks and at the marks, with the numbers of the vertical axis.
    fn grid(&self, svg: &mut Svg, axis: &Axis, up: &Scale) {
        let ((left, right), (bottom, top)) = (self.scale.pixels, up.pixels);
        for tick in &self.axis.ticks {
            let x = self.scale.pixel(*tick);
            svg.line("grid", (x, top), (x, bottom));
        }
        for tick in &axis.ticks {
            let y = up.pixel(*tick);
            let class = if *tick == 0.0 { "zero" } else { "grid" };
            svg.line(class, (left, y), (right, y));
            svg.text("number", (left - 7.0, y + 4.0), Anchor::End, &axis.label(*tick));
        }
        for label in &self.labels {
            let x = self.scale.pixel(label.mark.at);
            svg.line(line_class(label.mark), (x, top), (x, bottom));
        }
    }
}

fn vertical(panel: &Panel) -> Axis {
    let curves = panel.curves.iter().flat_map(|line| line.values.iter().copied());
    let values = curves.chain(panel.facts.iter().map(|fact| fact.value));
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
    Axis::around(low, high, 4)
}

fn line_class(mark: &Mark) -> &'static str {
    if mark.asked { "place" } else { "stated" }
}
