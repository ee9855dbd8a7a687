//! A figure of lines over two axes in powers of ten.

use super::labels::Labels;
use super::legend::{CHARACTER, colour};
use super::name::raise;
use super::scale::Scale;
use super::svg::{Anchor, Svg};
use crate::show::text;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 520.0;
/// The panel: left, right, top, bottom.
const PANEL: [f64; 4] = [76.0, 690.0, 70.0, 462.0];
/// Radius of a point.
const DOT: f64 = 2.6;

/// What is drawn.
pub struct Decades {
    /// The title.
    pub title: String,
    /// Name and unit along.
    pub along: String,
    /// Name and unit upwards.
    pub up: String,
    /// The lines.
    pub lines: Vec<Line>,
    /// The points that nothing is better than in both, in their order.
    pub front: Vec<(f64, f64)>,
    /// Points with names.
    pub labels: Vec<(String, (f64, f64))>,
    /// A place along with its name.
    pub mark: Option<(String, f64)>,
}

/// Points joined.
pub struct Line {
    /// What it is.
    pub name: String,
    /// The points; those without logarithms are left out.
    pub points: Vec<(f64, f64)>,
}

/// Draws them.
pub fn decades(figure: &Decades) -> String {
    let mut svg = Svg::new(WIDTH, HEIGHT);
    svg.rectangle("paper", (0.0, 0.0), (WIDTH, HEIGHT));
    svg.text("subject", (PANEL[0], 20.0), Anchor::Start, &figure.title);
    let logs = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let logs = points.iter().map(|(a, b)| (a.log10(), b.log10()));
        logs.filter(|(a, b)| a.is_finite() && b.is_finite()).collect()
    };
    let lines: Vec<(&str, Vec<(f64, f64)>)> =
        figure.lines.iter().map(|line| (line.name.as_str(), logs(&line.points))).collect();
    let labels: Vec<(f64, f64)> = figure.labels.iter().map(|label| label.1).collect();
    let (labelled, marked) = (logs(&labels), figure.mark.as_ref().map(|mark| mark.1.log10()));
    let all = || lines.iter().flat_map(|line| &line.1).chain(&labelled);
    let scale = |of: fn(&(f64, f64)) -> f64, pixels: (f64, f64)| {
        let more = marked.filter(|_| pixels.0 < pixels.1);
        let low = all().map(of).chain(more).fold(f64::INFINITY, f64::min).floor();
        let high = all().map(of).chain(more).fold(f64::NEG_INFINITY, f64::max).ceil();
        let values = if low < high { (low, high) } else { (low.min(0.0), low.min(0.0) + 1.0) };
        Scale { values, pixels }
    };
    let x = scale(|point| point.0, (PANEL[0], PANEL[1]));
    let y = scale(|point| point.1, (PANEL[3], PANEL[2]));
    grid(&mut svg, (&x, &y));
    svg.text("unit", (PANEL[1], PANEL[3] + 36.0), Anchor::End, &figure.along);
    svg.text("unit", (PANEL[0], PANEL[2] - 6.0), Anchor::Start, &figure.up);
    let pixels = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        points.iter().map(|(a, b)| (x.pixel(*a), y.pixel(*b))).collect()
    };
    svg.path("front", &pixels(&logs(&figure.front)));
    let mut place = PANEL[0];
    for (number, (name, points)) in lines.iter().enumerate() {
        let class = colour(Some(number));
        let points = pixels(points);
        svg.path(&format!("curve {class}"), &points);
        points.iter().for_each(|point| svg.circle(&class.replace('c', "f"), *point, DOT));
        svg.path(&format!("curve {class}"), &[(place, 38.0), (place + 24.0, 38.0)]);
        svg.text("unit", (place + 30.0, 42.0), Anchor::Start, name);
        place += 44.0 + text::width(name) as f64 * CHARACTER;
    }
    if let (Some(at), Some((name, _))) = (marked, &figure.mark) {
        let at = x.pixel(at);
        svg.line("place", (at, PANEL[2]), (at, PANEL[3]));
        svg.text("named", (at + 5.0, PANEL[2] + 14.0), Anchor::Start, name);
    }
    let named = figure.labels.iter().filter(|label| label.1.0 > 0.0 && label.1.1 > 0.0);
    let named: Vec<_> = named.zip(pixels(&labelled)).collect();
    let mut labels = Labels::default();
    for (_, at) in &named {
        svg.circle("f0", *at, DOT);
        labels.avoid(*at, DOT);
    }
    for ((name, _), at) in named.into_iter().filter(|one| !one.0.0.is_empty()) {
        let (anchor, at) = labels.place(at, name, (PANEL[0], PANEL[1]));
        svg.text("mark", at, anchor, name);
    }
    if !figure.front.is_empty() {
        svg.path("front", &[(place + 4.0, 38.0), (place + 20.0, 38.0)]);
        svg.text("unit", (place + 32.0, 42.0), Anchor::Start, "nothing cheaper is as good");
    }
    let size = (PANEL[1] - PANEL[0], PANEL[3] - PANEL[2]);
    svg.rectangle("frame", (PANEL[0], PANEL[2]), size);
    let names: Vec<&str> = lines.iter().map(|line| line.0).collect();
    svg.finish(&figure.title, &format!("{} over {}: {}", figure.up, figure.along, names.join(", ")))
}

/// A line and its power for each power of ten, at most some ten of them.
fn grid(svg: &mut Svg, (x, y): (&Scale, &Scale)) {
    let powers = |scale: &Scale| {
        let (low, high) = (scale.values.0 as i32, scale.values.1 as i32);
        let step = ((high - low) as usize).div_ceil(10).max(1);
        (low..=high).step_by(step)
    };
    let label = |power: i32| {
        let raised: String = power.to_string().chars().map(raise).collect();
        format!("10{raised}")
    };
    for power in powers(x) {
        let at = x.pixel(f64::from(power));
        svg.line("grid", (at, PANEL[2]), (at, PANEL[3]));
        svg.text("number", (at, PANEL[3] + 18.0), Anchor::Middle, &label(power));
    }
    for power in powers(y) {
        let at = y.pixel(f64::from(power));
        svg.line("grid", (PANEL[0], at), (PANEL[1], at));
        svg.text("number", (PANEL[0] - 6.0, at + 4.0), Anchor::End, &label(power));
    }
}
