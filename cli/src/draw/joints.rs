//! Pivots and slides at one position, in pixels.

use super::Picture;
use super::geometry::{Moves, Point, neighbours};
use crate::plot::svg::Svg;

/// Radius of a pivot.
pub const PIVOT: f64 = 5.0;
/// Half of the length and of the width of a slide.
const SLIDE: Point = (14.0, 8.5);
/// A point of the frame: a triangle on hatched ground.
pub fn ground(svg: &mut Svg, (x, y): Point) {
    let base = y + 17.0;
    svg.polygon("ground", &[(x, y), (x - 10.0, base), (x + 10.0, base)]);
    svg.line("symbol", (x - 16.0, base), (x + 16.0, base));
    for step in 0..5 {
        let right = x - 11.0 + 6.5 * f64::from(step);
        svg.line("symbol", (right, base), (right - 5.0, base + 6.0));
    }
}

/// The corners of a slide that moves in a direction.
pub fn slide(at: Point, along: Point) -> [Point; 4] {
    // Upwards is downwards in pixels.
    let (u, v) = ((along.0, -along.1), (along.1, along.0));
    let corner = |a: f64, b: f64| {
        (at.0 + a * SLIDE.0 * u.0 + b * SLIDE.1 * v.0, at.1 + a * SLIDE.0 * u.1 + b * SLIDE.1 * v.1)
    };
    [corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]
}

/// Whether a point is drawn as a slide: it moves straight, and no other that does so is linked to it.
pub fn slides(picture: &Picture<'_>, index: usize) -> Option<Point> {
    let Moves::Straight(along) = picture.geometry.moves[index] else {
        return None;
    };
    let linked = neighbours(picture.scene().links, index);
    let mut others = linked.iter().map(|&other| picture.geometry.moves[other]);
    let alike = others.any(|other| matches!(other, Moves::Straight(_)));
    (!linked.is_empty() && !alike).then_some(along)
}

/// The line that a slide moves on, somewhat longer than its path.
pub fn guide(svg: &mut Svg, path: &[Point], along: Point) {
    let u = (along.0, -along.1);
    let share = |point: &Point| point.0 * u.0 + point.1 * u.1;
    let low = path.iter().min_by(|a, b| share(a).total_cmp(&share(b)));
    let high = path.iter().max_by(|a, b| share(a).total_cmp(&share(b)));
    if let (Some(low), Some(high)) = (low, high) {
        let from = (low.0 - 30.0 * u.0, low.1 - 30.0 * u.1);
        let to = (high.0 + 30.0 * u.0, high.1 + 30.0 * u.1);
        svg.line("guide", from, to);
    }
}
