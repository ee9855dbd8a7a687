//! Figures of studies: curves of points, and maps in colour.

use super::axis::Axis;
use super::contour::Field;
use super::curve::simplify;
use super::legend::CHARACTER;
use super::scale::Scale;
use super::svg::{Anchor, Svg};
use crate::show::text;

const WIDTH: f64 = 720.0;
const LEFT: f64 = 76.0;
/// Room for the scale of colours at the right.
const RIGHT: f64 = 110.0;
const TOP: f64 = 40.0;
/// Height of a panel, its axis apart.
const PANEL: f64 = 220.0;
/// Height of the axis and its name below a panel.
const BELOW: f64 = 56.0;
/// Radius of a point that stands for itself.
const DOT: f64 = 1.6;
/// Steps of the scale of colours.
const SHADES: usize = 9;

/// One panel.
pub enum Layer {
    /// Points joined.
    Curve(Sheet),
    /// Points, each for itself.
    Points(Sheet),
    /// Values over two others.
    Map(Map),
}

/// Points joined by a line; one that is not a number is a gap.
pub struct Sheet {
    /// Name and unit along.
    pub along: String,
    /// Name and unit upwards.
    pub up: String,
    /// The points.
    pub points: Vec<(f64, f64)>,
}

/// Values over two others.
pub struct Map {
    /// Name and unit along.
    pub along: String,
    /// Name and unit upwards.
    pub up: String,
    /// Name and unit of what is shown.
    pub name: String,
    /// Values along.
    pub columns: Vec<f64>,
    /// Values upwards.
    pub rows: Vec<f64>,
    /// What is shown, row by row; not a number where there is none.
    pub values: Vec<f64>,
    /// Margins over the same places with what is wrong where they are below zero.
    pub limits: Vec<(String, Vec<f64>)>,
}

/// Draws panels one below the other, under a title and some sentences.
pub fn sheets(title: &str, lead: &str, layers: &[Layer]) -> String {
    let lead = text::wrap(lead, ((WIDTH - LEFT) / CHARACTER) as usize);
    let begin = TOP + 18.0 * lead.len() as f64;
    let height = begin + layers.len() as f64 * (PANEL + BELOW);
    let mut svg = Svg::new(WIDTH, height);
    svg.rectangle("paper", (0.0, 0.0), (WIDTH, height));
    svg.text("subject", (LEFT, 20.0), Anchor::Start, title);
    for (index, line) in lead.iter().enumerate() {
        svg.text("lead", (LEFT, 40.0 + 18.0 * index as f64), Anchor::Start, line);
    }
    let mut names = Vec::new();
    for (index, layer) in layers.iter().enumerate() {
        let top = begin + index as f64 * (PANEL + BELOW);
        match layer {
            Layer::Curve(sheet) | Layer::Points(sheet) => {
                names.push(format!("{} over {}", sheet.up, sheet.along));
                let joined = matches!(layer, Layer::Curve(_));
                curve(&mut svg, sheet, top, joined);
            }
            Layer::Map(map) => {
                names.push(format!("{} over {} and {}", map.name, map.along, map.up));
                shades(&mut svg, map, top);
            }
        }
    }
    svg.finish(title, &names.join("; "))
}

fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|value| value.is_finite());
    finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}

/// The axes of a panel.
fn axes(
    svg: &mut Svg,
    (along, up): (&Axis, &Axis),
    names: (&str, &str),
    top: f64,
    grid: bool,
) -> (Scale, Scale) {
    let x = Scale { values: along.ends, pixels: (LEFT, WIDTH - RIGHT) };
    let y = Scale { values: up.ends, pixels: (top + PANEL, top + 14.0) };
    for tick in &up.ticks {
        let at = y.pixel(*tick);
        if grid {
            svg.line("grid", (LEFT, at), (WIDTH - RIGHT, at));
        }
        svg.text("number", (LEFT - 6.0, at + 4.0), Anchor::End, &up.label(*tick));
    }
    for tick in &along.ticks {
        let at = x.pixel(*tick);
        if grid {
            svg.line("grid", (at, y.pixels.1), (at, y.pixels.0));
        }
        svg.text("number", (at, y.pixels.0 + 16.0), Anchor::Middle, &along.label(*tick));
    }
    let below = (WIDTH - RIGHT, y.pixels.0 + 34.0);
    svg.text("unit", below, Anchor::End, names.0);
    svg.text("unit", (LEFT, y.pixels.1 - 5.0), Anchor::Start, names.1);
    (x, y)
}

fn frame(svg: &mut Svg, (x, y): (&Scale, &Scale)) {
    let size = (x.pixels.1 - x.pixels.0, y.pixels.0 - y.pixels.1);
    svg.rectangle("frame", (x.pixels.0, y.pixels.1), size);
}

fn curve(svg: &mut Svg, sheet: &Sheet, top: f64, joined: bool) {
    let (left, right) = ends(sheet.points.iter().map(|point| point.0));
    let (low, high) = ends(sheet.points.iter().map(|point| point.1));
    if low > high {
        svg.text("unit", (LEFT, top + 30.0), Anchor::Start, &format!("{}: none", sheet.up));
        return;
    }
    let (along, up) = (Axis::between(left, right, 7), Axis::around(low, high, 5));
    let (x, y) = axes(svg, (&along, &up), (&sheet.along, &sheet.up), top, true);
    let points = sheet.points.iter();
    let points: Vec<_> = points.map(|(a, b)| (x.pixel(*a), y.pixel(*b))).collect();
    match joined {
        true => svg.path("curve c0", &simplify(&points)),
        false => {
            let finite = points.iter().filter(|point| point.0.is_finite() && point.1.is_finite());
            finite.for_each(|point| svg.circle("f0", *point, DOT));
        }
    }
    frame(svg, (&x, &y));
}

fn shades(svg: &mut Svg, map: &Map, top: f64) {
    let (low, high) = ends(map.values.iter().copied());
    let half =
        |values: &[f64]| (values[values.len() - 1] - values[0]) / (values.len() - 1) as f64 / 2.0;
    let (wide, tall) = (half(&map.columns), half(&map.rows));
    let span = |values: &[f64], half: f64| {
        let (first, last) = (values[0] - half, values[values.len() - 1] + half);
        (first.min(last), first.max(last))
    };
    let ((left, right), (bottom, ceiling)) = (span(&map.columns, wide), span(&map.rows, tall));
    let along = Axis::between(left, right, 7);
    let up = Axis::between(bottom, ceiling, 5);
    let lacks = map.values.iter().any(|value| !value.is_finite());
    let white = if lacks { "; pale where there is none" } else { "" };
    let title = format!("{} (up), {} in colour{white}", map.up, map.name);
    let (x, y) = axes(svg, (&along, &up), (&map.along, &title), top, false);
    let shade = |value: f64| {
        let share = if high > low { (value - low) / (high - low) } else { 0.0 };
        ((share * SHADES as f64) as usize).min(SHADES - 1)
    };
    for (row, b) in map.rows.iter().enumerate() {
        for (column, a) in map.columns.iter().enumerate() {
            let value = map.values[row * map.columns.len() + column];
            let class = match value.is_finite() {
                true => format!("s{}", shade(value)),
                false => "none".to_owned(),
            };
            let (from, to) = (x.pixel(a - wide), x.pixel(a + wide));
            let (below, above) = (y.pixel(b - tall), y.pixel(b + tall));
            // A little larger, so that no paper shines through between neighbours.
            let size = ((to - from).abs() + 0.4, (below - above).abs() + 0.4);
            svg.rectangle(&class, (from.min(to), above.min(below)), size);
        }
    }
    frame(svg, (&x, &y));
    boundaries(svg, map, (&x, &y));
    if low > high {
        return;
    }
    let step = (y.pixels.0 - y.pixels.1) / SHADES as f64;
    for index in 0..SHADES {
        let at = y.pixels.0 - (index + 1) as f64 * step;
        svg.rectangle(&format!("s{index}"), (WIDTH - RIGHT + 14.0, at), (14.0, step + 0.4));
    }
    for (value, at) in [(low, y.pixels.0), (high, y.pixels.1 + 10.0)] {
        let text = crate::show::number::significant(value, 3);
        svg.text("number", (WIDTH - RIGHT + 34.0, at), Anchor::Start, &text);
    }
}

/// Where a condition begins not to hold, with what is wrong beyond.
fn boundaries(svg: &mut Svg, map: &Map, (x, y): (&Scale, &Scale)) {
    for (words, margins) in &map.limits {
        let field = Field { columns: &map.columns, rows: &map.rows, values: margins };
        let lines = field.contours(0.0).into_iter();
        let lines = lines.map(|line| {
            line.into_iter().map(|(a, b)| (x.pixel(a), y.pixel(b))).collect::<Vec<_>>()
        });
        let lines: Vec<Vec<(f64, f64)>> = lines.collect();
        lines.iter().for_each(|line| svg.path("boundary", line));
        let longest = lines.iter().max_by_key(|line| line.len());
        if let Some((at_x, at_y)) = longest.and_then(|line| line.get(line.len() / 2)) {
            let anchor = if at_x - x.pixels.0 > 0.5 * (x.pixels.1 - x.pixels.0) {
                (Anchor::End, -6.0)
            } else {
                (Anchor::Start, 6.0)
            };
            for class in ["behind", "named"] {
                svg.text(class, (at_x + anchor.1, at_y - 6.0), anchor.0, words);
            }
        }
    }
}
