//! Terms of points: short ones, each where it covers nothing.

use std::f64::consts::TAU;

use super::Picture;
use super::geometry::{Moves, Point};
use super::joints::{PIVOT, slides};
use super::sheet::Sheet;
use crate::plot::name;
use crate::plot::svg::{Svg, escape, short};

/// Directions that are tried for a name.
const DIRECTIONS: usize = 16;
/// Distances that are tried in each direction, the first one beside the pivot.
const DISTANCES: usize = 4;
/// What a distance is farther than the one before it.
const FARTHER: f64 = 9.0;
/// How often each name looks for a better place once the others have theirs.
const ROUNDS: usize = 3;
/// Half of the height of a name.
const HEIGHT: f64 = 8.0;
/// Width of a character, and of one of an index.
const CHARACTERS: (f64, f64) = (9.0, 7.0);
/// Room that links and pivots keep around their middle.
const LINK: f64 = 6.0;

/// A name and where its middle stands.
#[derive(Clone, Debug)]
pub struct Name {
    /// The point.
    pub index: usize,
    /// Letters, each with its index.
    pub words: Vec<(String, String)>,
    /// The middle.
    pub middle: Point,
}

/// The names of all points at a position in pixels; of points at one place the names together.
pub fn names(picture: &Picture<'_>, at: &[Point]) -> Vec<Name> {
    let mut names: Vec<Name> = Vec::new();
    for (index, &place) in at.iter().enumerate() {
        if !(place.0.is_finite() && place.1.is_finite()) {
            continue;
        }
        let words = words(&called(picture, at, index));
        let same = |one: &&mut Name| {
            Sheet::touch(at[one.index], place)
                && picture.geometry.moves[one.index] == picture.geometry.moves[index]
        };
        match names.iter_mut().find(same) {
            Some(known) if known.words.contains(&words) => {}
            Some(known) => known.words.push(words),
            None => names.push(Name { index, words: vec![words], middle: place }),
        }
    }
    let drawn = Drawn::new(picture, at);
    for round in 0..=ROUNDS {
        for number in 0..names.len() {
            // In the first round those without a place do not count.
            let others = match round {
                0 => &names[..number],
                _ => &names[..],
            };
            let others = others.iter().enumerate();
            let others = others.filter(|(other, _)| *other != number);
            let taken: Vec<_> = others.map(|(_, other)| room(other)).collect();
            names[number].middle = drawn.best(picture, at, &names[number], &taken);
        }
    }
    apart(names)
}

/// The names that find room beside those before them: on top of each other none could be read.
fn apart(names: Vec<Name>) -> Vec<Name> {
    let mut kept: Vec<Name> = Vec::new();
    for name in names {
        if kept.iter().all(|other| !meet(room(other), room(&name))) {
            kept.push(name);
        }
    }
    kept
}

/// What a point is called: without the part that it belongs to, unless another point elsewhere is called so too.
fn called(picture: &Picture<'_>, at: &[Point], index: usize) -> String {
    let points = picture.scene().points;
    let last = |index: usize| points[index].rsplit('.').next().unwrap_or(points[index]);
    let elsewhere =
        |&other: &usize| last(other) == last(index) && !Sheet::touch(at[other], at[index]);
    match (0..points.len()).find(elsewhere) {
        Some(_) => points[index].to_owned(),
        None => last(index).to_owned(),
    }
}

/// A name as a book sets it: `O_h` with an index, `K0` with a lowered digit.
fn words(text: &str) -> (String, String) {
    let (front, last) = match text.rsplit_once('.') {
        Some((front, last)) => (format!("{front}."), last),
        None => (String::new(), text),
    };
    match last.split_once('_') {
        Some((letter, below)) if letter.chars().count() == 1 => {
            (front + &name::set(letter).text, below.replace('_', " "))
        }
        _ => (front + &name::set(last).text, String::new()),
    }
}

/// A box: its middle, half of its width and height.
type Room = (Point, Point);

fn room(name: &Name) -> Room {
    let width = |(letters, below): &(String, String)| {
        letters.chars().count() as f64 * CHARACTERS.0 + below.chars().count() as f64 * CHARACTERS.1
    };
    let words: f64 = name.words.iter().map(width).sum();
    let gaps = (name.words.len() - 1) as f64 * CHARACTERS.0;
    (name.middle, ((words + gaps) / 2.0, HEIGHT))
}

/// What names should not cover.
struct Drawn {
    links: Vec<(Point, Point)>,
    grounds: Vec<Room>,
}

impl Drawn {
    fn new(picture: &Picture<'_>, at: &[Point]) -> Self {
        let links = picture.scene().links.iter();
        let pairs = links.flat_map(|link| link.points.windows(2));
        let stands = |index: &usize| picture.geometry.moves[*index] == Moves::Stands;
        let standing = (0..at.len()).filter(stands);
        Self {
            links: pairs.map(|pair| (at[pair[0]], at[pair[1]])).collect(),
            grounds: standing
                .map(|index| ((at[index].0, at[index].1 + 13.0), (16.0, 12.0)))
                .collect(),
        }
    }

    /// The best middle of a name among those that are taken already.
    fn best(&self, picture: &Picture<'_>, at: &[Point], name: &Name, taken: &[Room]) -> Point {
        let place = at[name.index];
        let (_, half) = room(name);
        let beside = PIVOT + 4.0 + slides(picture, name.index).map_or(0.0, |_| 9.0);
        let mut best = (f64::INFINITY, place);
        for step in 0..DISTANCES {
            for direction in 0..DIRECTIONS {
                let angle = TAU * direction as f64 / DIRECTIONS as f64;
                let (x, y) = (angle.cos(), -angle.sin());
                // From the middle of the box to its edge in this direction.
                let own = (half.0 / x.abs()).min(half.1 / y.abs());
                let reach = beside + own + FARTHER * step as f64;
                let middle = (place.0 + reach * x, place.1 + reach * y);
                // Near its point; of equal ones to the right, then upwards.
                let far = 8.0 * step as f64 + 0.1 * direction as f64;
                let cost = far + self.covered(at, (middle, half), taken);
                if cost < best.0 {
                    best = (cost, middle);
                }
            }
        }
        best.1
    }

    /// How much a box covers, the worst the most.
    fn covered(&self, at: &[Point], own: Room, taken: &[Room]) -> f64 {
        let names = taken.iter().filter(|other| meet(own, **other)).count();
        let links = self.links.iter();
        let links = links.filter(|(from, to)| crosses(own, *from, *to)).count();
        let pivots = at.iter().filter(|pivot| holds(own, **pivot)).count();
        let grounds = self.grounds.iter();
        let grounds = grounds.filter(|ground| meet(own, **ground)).count();
        1000.0 * names as f64 + 200.0 * (links + pivots) as f64 + 100.0 * grounds as f64
    }
}

fn meet(a: Room, b: Room) -> bool {
    (a.0.0 - b.0.0).abs() < a.1.0 + b.1.0 && (a.0.1 - b.0.1).abs() < a.1.1 + b.1.1
}

/// Whether a pivot lies in a box.
fn holds(room: Room, pivot: Point) -> bool {
    meet(room, (pivot, (LINK, LINK)))
}

/// Whether a link passes through a box: the part of it whose points lie within both pairs of edges is not empty.
fn crosses((middle, half): Room, from: Point, to: Point) -> bool {
    let mut part = (0.0_f64, 1.0_f64);
    let edges = [
        (from.0 - middle.0, to.0 - from.0, half.0 + LINK),
        (from.1 - middle.1, to.1 - from.1, half.1 + LINK),
    ];
    for (start, along, reach) in edges {
        if along.abs() < 1e-9 {
            if start.abs() > reach {
                return false;
            }
            continue;
        }
        let (a, b) = ((-reach - start) / along, (reach - start) / along);
        part = (part.0.max(a.min(b)), part.1.min(a.max(b)));
    }
    part.0 < part.1
}

/// Writes a name so that it can be read above lines.
pub fn write(svg: &mut Svg, name: &Name) {
    let mut text = String::new();
    let mut lowered = false;
    for (number, (letters, below)) in name.words.iter().enumerate() {
        let gap = if number > 0 { ", " } else { "" };
        let letters = escape(&format!("{gap}{letters}"));
        text += &match lowered {
            true => format!(r#"<tspan dy="-4">{letters}</tspan>"#),
            false => letters,
        };
        lowered = !below.is_empty();
        if lowered {
            text += &format!(r#"<tspan class="index" dy="4">{}</tspan>"#, escape(below));
        }
    }
    let (x, y) = (short(name.middle.0), short(name.middle.1 + 5.0));
    for class in ["halo", "point"] {
        svg.raw(&format!(
            r#"<text class="{class}" x="{x}" y="{y}" text-anchor="middle">{text}</text>"#
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_indices() {
        assert_eq!(words("O_h"), ("O".to_owned(), "h".to_owned()));
        assert_eq!(words("K0"), ("K₀".to_owned(), String::new()));
        assert_eq!(words("rack.A"), ("rack.A".to_owned(), String::new()));
    }

    #[test]
    fn a_link_passes_through_a_box_or_beside_it() {
        let room = ((0.0, 0.0), (10.0, 5.0));
        assert!(crosses(room, (-50.0, 3.0), (50.0, 3.0)));
        assert!(!crosses(room, (-50.0, 30.0), (50.0, 30.0)));
        // It ends before the box.
        assert!(!crosses(room, (-50.0, 3.0), (-30.0, 3.0)));
        assert!(!crosses(room, (0.0, 40.0), (40.0, 0.0)));
    }
}
