//! Forces as arrows, the largest of them of a given length.

use super::Picture;
use super::geometry::{Frame, Point};
use super::sheet::Sheet;
use crate::plot::svg::Svg;
use crate::show::number;

/// Length of the largest arrow, pixels.
const LONGEST: f64 = 80.0;
/// Length and half of the width of a head, half of the width of a shaft.
const HEAD: (f64, f64) = (11.0, 4.5);
const SHAFT: f64 = 1.1;

/// The largest force.
pub fn largest<'a>(frames: impl Iterator<Item = &'a Frame>) -> f64 {
    let forces = frames.flat_map(|frame| &frame.forces);
    let sizes = forces.map(|(_, (x, y))| x.hypot(*y));
    sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
}

/// What the arrows mean, in words; empty where there are none.
pub fn legend(picture: &Picture<'_>) -> String {
    match picture.force > 0.0 {
        true => format!(
            " Arrows: forces of the closures, the longest {} N.",
            number::short(number::rounded(picture.force, 3))
        ),
        false => String::new(),
    }
}

/// Draws those of a position.
pub fn still(svg: &mut Svg, picture: &Picture<'_>, sheet: &Sheet, frame: &Frame) {
    for force in &frame.forces {
        svg.polygon("force", &arrow(picture, sheet, *force));
    }
}

/// For each force its arrow in every frame.
pub fn arrows(picture: &Picture<'_>, sheet: &Sheet, frames: &[Frame]) -> Vec<Vec<Vec<Point>>> {
    let count = frames.first().map_or(0, |frame| frame.forces.len());
    let of = |index: usize| {
        let frames = frames.iter().map(|frame| arrow(picture, sheet, frame.forces[index]).to_vec());
        frames.collect()
    };
    (0..count).map(of).collect()
}

/// The corners of an arrow that begins where a force acts. One that is too small for its head is as small as it is.
fn arrow(picture: &Picture<'_>, sheet: &Sheet, (place, force): (Point, Point)) -> [Point; 7] {
    let from = sheet.pixel(place);
    let share = LONGEST / picture.force.max(f64::MIN_POSITIVE);
    // Upwards is downwards in pixels.
    let along = (force.0 * share, -force.1 * share);
    let length = along.0.hypot(along.1);
    if length.is_nan() || length <= 0.0 {
        return [from; 7];
    }
    let unit = (along.0 / length, along.1 / length);
    let small = (length / (2.0 * HEAD.0)).min(1.0);
    let neck = length - small * HEAD.0;
    let corner =
        |a: f64, b: f64| (from.0 + a * unit.0 - b * unit.1, from.1 + a * unit.1 + b * unit.0);
    let (shaft, head) = (small * SHAFT, small * HEAD.1);
    [
        corner(0.0, shaft),
        corner(neck, shaft),
        corner(neck, head),
        corner(length, 0.0),
        corner(neck, -head),
        corner(neck, -shaft),
        corner(0.0, -shaft),
    ]
}
