//! The figure of `assur tolerance`: what each source contributes over the range, one above the other.

use super::axis::Axis;
use super::name;
use super::scale::Scale;
use super::svg::{Anchor, Svg};

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 400.0;
const LEFT: f64 = 64.0;
/// Room for the names at the right.
const RIGHT: f64 = 150.0;
const TOP: f64 = 44.0;
const BOTTOM: f64 = 52.0;
/// Height of a name.
const ROW: f64 = 15.0;
/// Fills that can be told apart.
const FILLS: usize = 8;

/// What the figure shows.
#[derive(Clone)]
pub struct Chart {
    /// Heading.
    pub title: String,
    /// What else there is to say about it, in a few words.
    pub note: String,
    /// Name and unit along.
    pub abscissa: (String, String),
    /// Unit upwards.
    pub ordinate: String,
    /// Where the places are.
    pub places: Vec<f64>,
    /// What is stacked, from below.
    pub bands: Vec<Band>,
    /// The standard deviation.
    pub deviation: Vec<f64>,
}

/// One of the layers.
#[derive(Clone)]
pub struct Band {
    /// What it is.
    pub name: String,
    /// Its thickness at each place.
    pub values: Vec<f64>,
}

/// Draws the figure.
pub fn contributions(chart: &Chart) -> String {
    let chart = &with_rest(chart);
    let layers = stack(chart);
    let top = layers.last().map_or(&[][..], |layer| layer);
    let most = top.iter().copied().fold(0.0, f64::max);
    let low = chart.places.iter().copied().fold(f64::INFINITY, f64::min);
    let high = chart.places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let along = match chart.abscissa.1.as_str() {
        "deg" => Axis::degrees(low, high, 6),
        _ => Axis::between(low, high, 6),
    };
    let up = Axis::around(0.0, most, 5);
    let x = Scale { values: along.ends, pixels: (LEFT, WIDTH - RIGHT) };
    let y = Scale { values: up.ends, pixels: (HEIGHT - BOTTOM, TOP) };
    let mut svg = Svg::new(WIDTH, HEIGHT);
    svg.rectangle("paper", (0.0, 0.0), (WIDTH, HEIGHT));
    svg.text("subject", (LEFT, 20.0), Anchor::Start, &chart.title);
    let note = (WIDTH - RIGHT, TOP - 8.0);
    svg.text("unit", note, Anchor::End, &chart.note);
    fill(&mut svg, chart, &layers, (&x, &y));
    axes(&mut svg, chart, (&along, &up), (&x, &y));
    let deviation = chart.places.iter().zip(&chart.deviation);
    let line: Vec<_> = deviation.map(|(a, b)| (x.pixel(*a), y.pixel(*b))).collect();
    svg.path("deviation", &line);
    names(&mut svg, chart);
    let words = chart.bands.iter().map(|band| band.name.as_str());
    let description = format!(
        "Layers from below: {}; dashed: the standard deviation.",
        words.collect::<Vec<_>>().join(", ")
    );
    svg.finish(&chart.title, &description)
}

/// The chart with the smallest of many layers as one, so that each has a fill of its own.
fn with_rest(chart: &Chart) -> Chart {
    let mut bands = chart.bands.clone();
    if bands.len() > FILLS {
        let rest = bands.split_off(FILLS - 1);
        let sum = |place: usize| rest.iter().map(|band| band.values[place]).sum();
        bands.push(Band {
            name: format!("{} others", rest.len()),
            values: (0..chart.places.len()).map(sum).collect(),
        });
    }
    Chart { bands, ..chart.clone() }
}

/// The upper edges of the layers, below all of them zero.
fn stack(chart: &Chart) -> Vec<Vec<f64>> {
    let mut layers = vec![vec![0.0; chart.places.len()]];
    for band in &chart.bands {
        let below = layers.last().cloned().unwrap_or_default();
        layers.push(below.iter().zip(&band.values).map(|(a, b)| a + b).collect());
    }
    layers
}

fn fill(svg: &mut Svg, chart: &Chart, layers: &[Vec<f64>], (x, y): (&Scale, &Scale)) {
    for (index, pair) in layers.windows(2).enumerate() {
        let edge = |values: &[f64]| -> Vec<(f64, f64)> {
            let points = chart.places.iter().zip(values);
            points.map(|(a, b)| (x.pixel(*a), y.pixel(*b))).collect()
        };
        let mut outline = edge(&pair[1]);
        outline.extend(edge(&pair[0]).into_iter().rev());
        svg.begin(&chart.bands[index].name);
        svg.path(&format!("t{}", index % FILLS), &outline);
        svg.end();
    }
}

fn axes(svg: &mut Svg, chart: &Chart, (along, up): (&Axis, &Axis), (x, y): (&Scale, &Scale)) {
    let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
    for tick in &up.ticks {
        let at = y.pixel(*tick);
        svg.line("grid", (LEFT, at), (right, at));
        svg.text("number", (LEFT - 6.0, at + 4.0), Anchor::End, &up.label(*tick));
    }
    for tick in &along.ticks {
        let at = x.pixel(*tick);
        svg.line("axis", (at, bottom), (at, bottom + 4.0));
        svg.text("number", (at, bottom + 18.0), Anchor::Middle, &along.label(*tick));
    }
    svg.line("axis", (LEFT, bottom), (right, bottom));
    svg.line("axis", (LEFT, TOP), (LEFT, bottom));
    let (letter, unit) = &chart.abscissa;
    let label = format!("{letter}, {}", name::unit(unit));
    let label = label.trim_end_matches(", ");
    svg.text("unit", (right, HEIGHT - 14.0), Anchor::End, label);
    svg.text("unit", (LEFT, TOP - 8.0), Anchor::Start, &chart.ordinate);
}

/// The names, in the order of the layers.
fn names(svg: &mut Svg, chart: &Chart) {
    let left = WIDTH - RIGHT + 12.0;
    for (index, band) in chart.bands.iter().enumerate() {
        let y = TOP + 10.0 + ROW * (chart.bands.len() - 1 - index) as f64;
        svg.rectangle(&format!("t{}", index % FILLS), (left, y - 9.0), (10.0, 10.0));
        svg.text("name", (left + 16.0, y), Anchor::Start, &band.name);
    }
    let y = TOP + 10.0 + ROW * chart.bands.len() as f64;
    svg.path("deviation", &[(left, y - 4.0), (left + 12.0, y - 4.0)]);
    svg.text("name", (left + 16.0, y), Anchor::Start, "standard deviation");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_of_many_layers_are_one() {
        let band = |index: usize| Band { name: format!("l{index}"), values: vec![1.0] };
        let chart = with_rest(&Chart {
            title: String::new(),
            note: String::new(),
            abscissa: ("phi4".to_owned(), "deg".to_owned()),
            ordinate: "mrad".to_owned(),
            places: vec![60.0],
            bands: (0..10).map(band).collect(),
            deviation: vec![0.4],
        });
        assert_eq!(chart.bands.len(), FILLS);
        assert_eq!(chart.bands[FILLS - 1].name, "3 others");
        assert_eq!(chart.bands[FILLS - 1].values, [3.0]);
    }

    #[test]
    fn layers_lie_on_each_other() {
        let band =
            |name: &str, values: [f64; 2]| Band { name: name.to_owned(), values: values.to_vec() };
        let chart = Chart {
            title: "a & b".to_owned(),
            note: String::new(),
            abscissa: ("phi4".to_owned(), "deg".to_owned()),
            ordinate: "mrad".to_owned(),
            places: vec![60.0, 120.0],
            bands: vec![band("l5", [1.0, 2.0]), band("s", [0.5, 0.25])],
            deviation: vec![0.4, 0.5],
        };
        assert_eq!(stack(&chart), [[0.0, 0.0], [1.0, 2.0], [1.5, 2.25]]);
        let drawn = contributions(&chart);
        assert!(drawn.contains("a &amp; b") && drawn.contains(r#"aria-label="l5""#));
        assert!(!drawn.contains("NaN"));
    }
}
