//! The points of a linkage along its way: which stand, which move, which move straight.

use assur::registry::SceneEntry;
use assur::shape::Link;

/// A place on the drawing board, metres.
pub type Point = (f64, f64);

/// Part of the size of a linkage that counts as nothing.
const NOTHING: f64 = 1e-7;

/// The points of a linkage along its way.
pub struct Geometry {
    /// For each point its paths, one for each driver that moves.
    pub paths: Vec<Vec<Vec<Point>>>,
    /// How each point moves.
    pub moves: Vec<Moves>,
    /// Whether the way ends where it began.
    pub is_closed: bool,
    /// Lower left and upper right corner of all that is drawn.
    pub corners: (Point, Point),
}

/// How a point moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moves {
    /// It never moves.
    Stands,
    /// Along a straight line of this direction.
    Straight(Point),
    /// Anyhow.
    Free,
}

/// Where everything is at one position.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// The points, metres.
    pub points: Vec<Point>,
    /// Forces: where each acts, metres, and how large it is, newtons.
    pub forces: Vec<(Point, Point)>,
}

impl Frame {
    /// Of what a scene says of a position: places of points and forces, and its outputs.
    pub fn of(scene: &SceneEntry, places: &[f64], outputs: &[f64]) -> Self {
        let mut places = places.chunks_exact(2).map(|place| (place[0], place[1]));
        let points = places.by_ref().take(scene.points.len()).collect();
        let force = |first: &usize| (outputs[*first], outputs[*first + 1]);
        Self { points, forces: places.zip(scene.arrows.iter().map(force)).collect() }
    }

    fn point(&self, index: usize) -> Point {
        self.points.get(index).copied().unwrap_or((f64::NAN, f64::NAN))
    }
}

impl Geometry {
    /// The geometry of so many points with these positions along their ways, and others that are drawn as well.
    pub fn new<'a>(
        count: usize,
        ways: &[Vec<Frame>],
        others: impl Iterator<Item = &'a Frame>,
    ) -> Self {
        let others: Vec<_> = others.collect();
        let along = |way: &Vec<Frame>, index: usize| -> Vec<Point> {
            way.iter().map(|frame| frame.point(index)).collect()
        };
        let of_point = |index: usize| -> Vec<Vec<Point>> {
            ways.iter().map(|way| along(way, index)).collect()
        };
        let paths: Vec<_> = (0..count).map(of_point).collect();
        let all = |index: usize| {
            let shown = others.iter().map(|frame| frame.point(index));
            paths[index].iter().flatten().copied().chain(shown).collect::<Vec<_>>()
        };
        let places = (0..count).flat_map(all);
        let corners = corners(places.filter(is_finite));
        let nothing = NOTHING * distance(corners.0, corners.1);
        let back = |path: &Vec<Point>| match (path.first(), path.last()) {
            (Some(first), Some(last)) => distance(*first, *last) <= nothing,
            _ => false,
        };
        let is_closed = match ways {
            [way] => way.len() > 2 && paths.iter().flatten().all(back),
            _ => false,
        };
        let moves = |index: usize| match ways.iter().map(Vec::len).sum::<usize>() + others.len() {
            // Of one position nobody knows what moves.
            0 | 1 => Moves::Free,
            _ => moves(&all(index), nothing),
        };
        Self { moves: (0..count).map(moves).collect(), is_closed, corners, paths }
    }

    /// Whether all points of a link stand.
    pub fn is_frame(&self, points: &[usize]) -> bool {
        points.iter().all(|&index| self.moves[index] == Moves::Stands)
    }
}

/// Points that a link is drawn through.
pub fn neighbours(links: &[Link], index: usize) -> Vec<usize> {
    let pairs = links.iter().flat_map(|link| link.points.windows(2));
    let other = pairs.filter_map(|pair| match pair {
        [a, b] if *a == index => Some(*b),
        [a, b] if *b == index => Some(*a),
        _ => None,
    });
    other.collect()
}

fn is_finite(point: &Point) -> bool {
    point.0.is_finite() && point.1.is_finite()
}

/// How far two places are from each other.
pub fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn corners(points: impl Iterator<Item = Point>) -> (Point, Point) {
    let nothing = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    let (low, high) = points.fold(nothing, |(low, high), (x, y)| {
        ((low.0.min(x), low.1.min(y)), (high.0.max(x), high.1.max(y)))
    });
    match low.0 <= high.0 {
        true => (low, high),
        false => ((0.0, 0.0), (0.0, 0.0)),
    }
}

/// How a point with this path moves.
fn moves(path: &[Point], nothing: f64) -> Moves {
    let mut finite = path.iter().copied().filter(is_finite);
    let Some(first) = finite.next() else {
        return Moves::Stands;
    };
    let far = finite.clone().max_by(|a, b| distance(first, *a).total_cmp(&distance(first, *b)));
    let Some(far) = far.filter(|far| distance(first, *far) > nothing) else {
        return Moves::Stands;
    };
    let length = distance(first, far);
    let along = ((far.0 - first.0) / length, (far.1 - first.1) / length);
    let off = |point: Point| (along.0 * (point.1 - first.1) - along.1 * (point.0 - first.0)).abs();
    match path.len() > 2 && finite.all(|point| off(point) <= 10.0 * nothing) {
        true => Moves::Straight(along),
        false => Moves::Free,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_stand_or_move_straight_or_freely() {
        let circle: Vec<_> = (0..20).map(|k| (f64::from(k).cos(), f64::from(k).sin())).collect();
        assert_eq!(moves(&circle, 1e-7), Moves::Free);
        assert_eq!(moves(&[(1.0, 2.0); 5], 1e-7), Moves::Stands);
        let line: Vec<_> = (0..20).map(|k| (0.6 * f64::from(k), 0.8 * f64::from(k))).collect();
        let Moves::Straight((x, y)) = moves(&line, 1e-7) else {
            panic!("a straight path");
        };
        assert!((x - 0.6).abs() < 1e-12 && (y - 0.8).abs() < 1e-12);
        assert_eq!(moves(&[(f64::NAN, 0.0)], 1e-7), Moves::Stands);
    }
}
