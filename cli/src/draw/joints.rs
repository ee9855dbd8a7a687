//! Links, pivots, slides and names at one position, in pixels.

use std::f64::consts::TAU;

use super::Picture;
use super::geometry::{Moves, Point, distance, neighbours};
use super::sheet::{Sheet, point_name};
use crate::plot::svg::{Anchor, Svg};

/// Radius of a pivot.
pub const PIVOT: f64 = 5.0;
/// Half of the length and of the width of a slide.
const SLIDE: Point = (14.0, 8.5);
/// Directions that are tried for a name.
const DIRECTIONS: i32 = 16;
/// Room for a name that is enough.
const ENOUGH: f64 = 15.0;
/// Distance of a name from its point.
const NAME: f64 = 19.0;

/// A point of the frame: a triangle on hatched ground.
pub fn ground(svg: &mut Svg, (x, y): Point) {
    let base = y + 17.0;
    svg.polygon("ground", &[(x, y), (x - 10.0, base), (x + 10.0, base)]);
    svg.line("frame", (x - 16.0, base), (x + 16.0, base));
    for step in 0..5 {
        let right = x - 11.0 + 6.5 * f64::from(step);
        svg.line("frame", (right, base), (right - 5.0, base + 6.0));
    }
}

/// The corners of a slide that moves in a direction.
pub fn slide(at: Point, along: Point) -> [Point; 4] {
    // Upwards is downwards in pixels.
    let (u, v) = ((along.0, -along.1), (along.1, along.0));
    let corner = |a: f64, b: f64| {
        (
            at.0 + a * SLIDE.0 * u.0 + b * SLIDE.1 * v.0,
            at.1 + a * SLIDE.0 * u.1 + b * SLIDE.1 * v.1,
        )
    };
    [
        corner(1.0, 1.0),
        corner(-1.0, 1.0),
        corner(-1.0, -1.0),
        corner(1.0, -1.0),
    ]
}

/// Whether a point is drawn as a slide: it moves straight, and no other that does so is linked to it.
pub fn slides(picture: &Picture<'_>, index: usize) -> Option<Point> {
    let Moves::Straight(along) = picture.geometry.moves[index] else {
        return None;
    };
    let linked = neighbours(picture.case.entry, index);
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

/// Where the name of each point stands, with the name; of points at one place the names together. Of some directions each
/// takes the one with the most room.
pub fn names(picture: &Picture<'_>, at: &[Point]) -> Vec<(usize, Point, String)> {
    let mut names: Vec<(usize, Point, String)> = Vec::new();
    for (index, &place) in at.iter().enumerate() {
        if !(place.0.is_finite() && place.1.is_finite()) {
            continue;
        }
        let same = |one: &&mut (usize, Point, String)| {
            Sheet::touch(at[one.0], place)
                && picture.geometry.moves[one.0] == picture.geometry.moves[index]
        };
        if let Some(known) = names.iter_mut().find(same) {
            known.2 += &format!(", {}", point_name(picture, index));
            continue;
        }
        let reach = match slides(picture, index) {
            Some(_) => NAME + 9.0,
            None => NAME,
        };
        let candidates = (0..DIRECTIONS).map(|k| {
            let angle = TAU * f64::from(k) / f64::from(DIRECTIONS);
            (place.0 + reach * angle.cos(), place.1 - reach * angle.sin())
        });
        let room = |centre: &Point| room(picture, at, &names, *centre);
        // Of equal room the first one: to the right, then upwards.
        let best = candidates.reduce(|best, other| match room(&other) > room(&best) + 1.0 {
            true => other,
            false => best,
        });
        let (x, y) = best.unwrap_or(place);
        names.push((index, (x, y + 5.0), point_name(picture, index)));
    }
    names
}

/// Distance of a name from all that is drawn, as far as it matters.
fn room(
    picture: &Picture<'_>,
    at: &[Point],
    names: &[(usize, Point, String)],
    centre: Point,
) -> f64 {
    let links = picture.case.entry.links.iter();
    let pairs = links.flat_map(|link| link.points.windows(2));
    let bars = pairs.map(|pair| beside(centre, at[pair[0]], at[pair[1]]) - 4.0);
    let pivots = at.iter().map(|other| distance(centre, *other) - PIVOT);
    let grounds = at
        .iter()
        .enumerate()
        .filter(|(index, _)| picture.geometry.moves[*index] == Moves::Stands);
    let grounds = grounds.map(|(_, place)| {
        beside(
            centre,
            (place.0 - 10.0, place.1 + 17.0),
            (place.0 + 10.0, place.1 + 17.0),
        ) - 4.0
    });
    let known = names
        .iter()
        .map(|(_, place, _)| distance(centre, (place.0, place.1 - 5.0)) - 8.0);
    let all = bars.chain(pivots).chain(grounds).chain(known);
    all.filter(|distance| distance.is_finite())
        .fold(ENOUGH, f64::min)
}

/// Distance of a place from a line between two others.
fn beside(place: Point, from: Point, to: Point) -> f64 {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let square = x * x + y * y;
    let share = ((place.0 - from.0) * x + (place.1 - from.1) * y) / square;
    let share = if square > 0.0 {
        share.clamp(0.0, 1.0)
    } else {
        0.0
    };
    distance(place, (from.0 + share * x, from.1 + share * y))
}

/// Writes a name so that it can be read above lines.
pub fn write(svg: &mut Svg, place: Point, name: &str) {
    svg.text("halo", place, Anchor::Middle, name);
    svg.text("point", place, Anchor::Middle, name);
}
