//! The paper of a drawing: scale, title, legend, scale bar.

use super::Picture;
use super::forces;
use super::geometry::{Point, distance};
use crate::plot::figure::lead;
use crate::plot::legend::text_width;
use crate::plot::svg::{Anchor, Svg};
use crate::show::number;
use crate::show::text::wrap;

/// Left and right of the drawing: room for names of points.
const MARGIN: f64 = 70.0;
/// Below the drawing: room for the symbols of the frame and the scale bar.
const FOOT: f64 = 92.0;
/// Largest width and height of the drawing itself.
const LARGEST: (f64, f64) = (680.0, 520.0);
/// Smallest width of the paper: room for the title.
const NARROWEST: f64 = 520.0;
/// Colours of links that can be told apart.
const COLOURS: usize = 14;

/// The paper with its scale.
pub struct Sheet {
    /// Width and height of the paper.
    pub size: Point,
    /// Pixels of a metre.
    scale: f64,
    /// Pixel of the lower left corner of the drawing.
    origin: Point,
    /// The lower left corner in metres.
    corner: Point,
    lead: Vec<String>,
    legend: Vec<Entry>,
}

/// A link in the legend.
struct Entry {
    class: String,
    text: String,
    at: Point,
}

impl Sheet {
    /// Lays out the paper for a picture.
    pub fn new(picture: &Picture<'_>, sentence: &str) -> Self {
        let (low, high) = picture.geometry.corners;
        let size = (high.0 - low.0, high.1 - low.1);
        let fit = |room: f64, size: f64| {
            if size > 0.0 { room / size } else { f64::INFINITY }
        };
        let scale = fit(LARGEST.0, size.0).min(fit(LARGEST.1, size.1));
        let scale = if scale.is_finite() { scale } else { 1e3 };
        let width = (size.0 * scale + 2.0 * MARGIN).max(NARROWEST);
        let said = format!("{} {sentence}{}", lead(picture.constants), forces::legend(picture));
        let lead = wrap(&said, ((width - 60.0) / 7.2) as usize);
        let top = 56.0 + 18.0 * lead.len() as f64;
        let legend = legend(picture, width, top + 2.0);
        let below = legend.last().map_or(top - 8.0, |entry| entry.at.1);
        let height = below + 44.0 + size.1 * scale + FOOT;
        Self {
            size: (width, height),
            scale,
            origin: ((width - size.0 * scale) / 2.0, height - FOOT),
            corner: low,
            lead,
            legend,
        }
    }

    /// The pixel of a place.
    pub fn pixel(&self, point: Point) -> Point {
        (
            self.origin.0 + (point.0 - self.corner.0) * self.scale,
            self.origin.1 - (point.1 - self.corner.1) * self.scale,
        )
    }

    /// An empty picture with title, legend and scale bar.
    pub fn begin(&self, title: &str) -> Svg {
        let mut svg = Svg::new(self.size.0, self.size.1);
        svg.rectangle("paper", (0.0, 0.0), self.size);
        svg.text("title", (30.0, 34.0), Anchor::Start, title);
        for (index, line) in self.lead.iter().enumerate() {
            let y = 56.0 + 18.0 * index as f64;
            svg.text("lead", (30.0, y), Anchor::Start, line);
        }
        for entry in &self.legend {
            let (x, y) = entry.at;
            svg.line(&format!("link {}", entry.class), (x + 4.0, y - 4.0), (x + 24.0, y - 4.0));
            svg.text("unit", (x + 34.0, y), Anchor::Start, &entry.text);
        }
        scale_bar(&mut svg, self.size, self.scale);
        svg
    }

    /// The whole file.
    pub fn finish(&self, svg: Svg, title: &str) -> String {
        svg.finish(title, &self.lead.join(" "))
    }

    /// Whether two pixels are so near that their names would touch.
    pub fn touch(a: Point, b: Point) -> bool {
        distance(a, b) < 4.0
    }
}

/// A round length of about a fifth of the width of the paper, at this many pixels of a metre.
pub fn scale_bar(svg: &mut Svg, (width, height): Point, scale: f64) {
    let wanted = 0.2 * width / scale;
    let power = 10f64.powf(wanted.log10().floor());
    let factors = [5.0, 2.0, 1.0].into_iter();
    let factor = factors.clone().find(|factor| factor * power <= wanted);
    let length = factor.unwrap_or(1.0) * power;
    let (left, y) = (30.0, height - 24.0);
    let right = left + length * scale;
    svg.line("bar", (left, y), (right, y));
    for x in [left, right] {
        svg.line("bar", (x, y - 4.0), (x, y + 4.0));
    }
    let text = format!("{} mm", number::short(number::rounded(length * 1e3, 3)));
    svg.text("unit", (right + 9.0, y + 4.0), Anchor::Start, &text);
}

/// The class of the colour of a link; links of the frame are grey.
pub fn colour(picture: &Picture<'_>, link: usize) -> String {
    let links = picture.scene().links;
    if picture.geometry.is_frame(links[link].points) {
        return "k".to_owned();
    }
    let moving = links[..link].iter().filter(|link| !picture.geometry.is_frame(link.points));
    format!("c{}", moving.count() % COLOURS)
}

/// Terms of the links in rows, those of each part of the mechanism on rows of their own.
fn legend(picture: &Picture<'_>, width: f64, top: f64) -> Vec<Entry> {
    let mut at = (30.0, top);
    let mut entries: Vec<Entry> = Vec::new();
    let mut before = None;
    for (index, link) in picture.scene().links.iter().enumerate() {
        if link.text.is_empty() {
            continue;
        }
        let part = part(picture, link.points);
        let begins = before != Some(part);
        before = Some(part);
        let text = match begins && !part.is_empty() {
            true => format!("{part}: {}", link.text),
            false => link.text.to_owned(),
        };
        let needed = 34.0 + text_width(&text) + 22.0;
        let full = at.0 + needed > width;
        if (full || begins) && at.0 > 30.0 {
            at = (30.0, at.1 + 19.0);
        }
        entries.push(Entry { class: colour(picture, index), text, at });
        at.0 += needed;
    }
    entries
}

/// The part of the mechanism that a link belongs to, as its points are named; empty if to none.
fn part(picture: &Picture<'_>, points: &[usize]) -> &'static str {
    let name = points.first().map(|&index| picture.scene().points[index]);
    let part = name.and_then(|name| name.rsplit_once('.'));
    part.map_or("", |(part, _)| part)
}
