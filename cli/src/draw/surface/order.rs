//! Which cells hide which: an order in which each is painted after all that it hides.
//!
//! Of two cells that overlap in the picture the nearer one is found where they do, so that the order is right however long
//! or slanted they are. Only cells that pass through each other have none; they are ordered as a whole.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use super::vector::{Vector, inner, sum};

/// Side of the squares in which overlapping cells are sought, pixels.
const SQUARE: f64 = 16.0;
/// Overlaps below this area are nothing to see, square pixels.
const VISIBLE: f64 = 0.01;

/// Corners of a cell in pixels to the right, upwards and towards the viewer.
pub type Cell = [Vector; 4];

/// The cells by their indices, each behind all that follow.
pub fn back_to_front(cells: &[Cell]) -> Vec<usize> {
    let mut sorted: Vec<usize> = (0..cells.len()).collect();
    sorted.sort_by(|a, b| depth(&cells[*a]).total_cmp(&depth(&cells[*b])));
    let places: Vec<Cell> = sorted.iter().map(|&index| cells[index]).collect();
    let order = Hiding::new(&places).order();
    order.into_iter().map(|place| sorted[place]).collect()
}

/// Four times how near a cell is.
fn depth(cell: &Cell) -> f64 {
    cell.iter().map(|corner| corner[2]).sum()
}

/// Which cells lie before and behind each, the cells being sorted roughly.
struct Hiding {
    before: Vec<Vec<usize>>,
    behind: Vec<Vec<usize>>,
}

impl Hiding {
    fn new(cells: &[Cell]) -> Self {
        let triangles: Vec<_> = cells.iter().map(triangles).collect();
        let boxes: Vec<_> = cells.iter().map(bounds).collect();
        let mut squares: HashMap<(i64, i64), Vec<usize>> = HashMap::new();
        let mut hiding =
            Self { before: vec![Vec::new(); cells.len()], behind: vec![Vec::new(); cells.len()] };
        for (index, bounds) in boxes.iter().enumerate() {
            let [left, low, right, high] = bounds.map(|pixel| (pixel / SQUARE).floor() as i64);
            for square in (left..=right).flat_map(|x| (low..=high).map(move |y| (x, y))) {
                let others = squares.entry(square).or_default();
                for &other in others.iter() {
                    // Cells that share several squares meet in the first one of them.
                    let first = [0, 1].map(|side| boxes[other][side].max(bounds[side]));
                    let first = first.map(|pixel| (pixel / SQUARE).floor() as i64);
                    if (first[0], first[1]) == square {
                        let nearer = nearer(&triangles[index], &triangles[other]);
                        if nearer > 0.0 {
                            hiding.add(other, index);
                        } else if nearer < 0.0 {
                            hiding.add(index, other);
                        }
                    }
                }
                others.push(index);
            }
        }
        hiding
    }

    fn add(&mut self, behind: usize, before: usize) {
        self.before[behind].push(before);
        self.behind[before].push(behind);
    }

    /// What nothing waits for comes first, the farthest of it first.
    fn order(&self) -> Vec<usize> {
        let count = self.before.len();
        let mut waits: Vec<usize> = self.behind.iter().map(Vec::len).collect();
        let mut ready: BinaryHeap<_> =
            (0..count).filter(|one| waits[*one] == 0).map(Reverse).collect();
        let (mut order, mut placed, mut first) = (Vec::new(), vec![false; count], 0);
        while order.len() < count {
            let next = ready.pop().map(|Reverse(one)| one).unwrap_or_else(|| {
                first += placed[first..].iter().take_while(|placed| **placed).count();
                self.of_circle(first, &placed)
            });
            if std::mem::replace(&mut placed[next], true) {
                continue;
            }
            order.push(next);
            for &one in &self.before[next] {
                waits[one] -= 1;
                if waits[one] == 0 && !placed[one] {
                    ready.push(Reverse(one));
                }
            }
        }
        order
    }

    /// The farthest cell of a circle of cells each of which hides the next one; this cell waits for it.
    fn of_circle(&self, cell: usize, placed: &[bool]) -> usize {
        let (mut way, mut steps) = (vec![cell], HashMap::from([(cell, 0)]));
        loop {
            let last = way[way.len() - 1];
            let Some(&next) = self.behind[last].iter().filter(|one| !placed[**one]).min() else {
                return last;
            };
            if let Some(&step) = steps.get(&next) {
                return way[step..].iter().copied().min().unwrap_or(next);
            }
            steps.insert(next, way.len());
            way.push(next);
        }
    }
}

/// A triangle of a cell, anticlockwise in the picture.
type Triangle = [Vector; 3];

/// The triangles of a cell that are seen from anywhere but their edges.
fn triangles([a, b, c, d]: &Cell) -> Vec<Triangle> {
    let turned = |[a, b, c]: Triangle| match side(a, b, c) {
        area if area > 2.0 * VISIBLE => Some([a, b, c]),
        area if area < -2.0 * VISIBLE => Some([a, c, b]),
        _ => None,
    };
    [[*a, *b, *c], [*a, *c, *d]].into_iter().filter_map(turned).collect()
}

/// Left, low, right, high.
fn bounds(cell: &Cell) -> [f64; 4] {
    let along = |axis: usize| cell.iter().map(move |corner| corner[axis]);
    let low = |axis| along(axis).fold(f64::INFINITY, f64::min);
    let high = |axis| along(axis).fold(f64::NEG_INFINITY, f64::max);
    [low(0), low(1), high(0), high(1)]
}

/// Above zero where the first cell is the nearer one, below where the second is; zero where they do not overlap.
fn nearer(first: &[Triangle], second: &[Triangle]) -> f64 {
    let pairs = first.iter().flat_map(|one| second.iter().map(move |other| (one, other)));
    pairs.map(|(one, other)| between(one, other)).sum()
}

/// The volume between two triangles where they overlap.
fn between(one: &Triangle, other: &Triangle) -> f64 {
    let common = clipped(one, other);
    let Some((start, rest)) = common.split_first() else { return 0.0 };
    let (mut area, mut volume) = (0.0, 0.0);
    for pair in rest.windows(2) {
        let part = side(*start, pair[0], pair[1]) / 2.0;
        let middle = sum(sum(*start, 1.0, pair[0]), 1.0, pair[1]).map(|component| component / 3.0);
        area += part;
        volume += part * (middle[2] - height(other, middle));
    }
    if area > VISIBLE { volume } else { 0.0 }
}

/// The part of a triangle that lies over or under another one (Sutherland and Hodgman).
fn clipped(one: &Triangle, other: &Triangle) -> Vec<Vector> {
    let mut corners = one.to_vec();
    for (index, from) in other.iter().enumerate() {
        let to = other[(index + 1) % 3];
        let mut kept = Vec::new();
        for (number, corner) in corners.iter().enumerate() {
            let next = corners[(number + 1) % corners.len()];
            let sides = [side(*from, to, *corner), side(*from, to, next)];
            if sides[0] >= 0.0 {
                kept.push(*corner);
            }
            if (sides[0] > 0.0 && sides[1] < 0.0) || (sides[0] < 0.0 && sides[1] > 0.0) {
                let share = sides[0] / (sides[0] - sides[1]);
                kept.push(sum(sum(*corner, -share, *corner), share, next));
            }
        }
        corners = kept;
    }
    corners
}

/// Twice the area of a triangle in the picture, above zero if it is anticlockwise.
fn side(a: Vector, b: Vector, c: Vector) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// How near the plane of a triangle is at a place of the picture.
fn height(triangle: &Triangle, place: Vector) -> f64 {
    let [a, b, c] = *triangle;
    let shares = [side(b, c, place), side(c, a, place), side(a, b, place)];
    inner(shares, [a[2], b[2], c[2]]) / side(a, b, c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::surface::mesh::Mesh;
    use crate::draw::surface::patch::Patch;
    use crate::draw::surface::view::View;

    /// How near a cell is at a place of the picture; none where it is not.
    fn depth_at(cell: &Cell, place: Vector) -> Option<f64> {
        let holds = |one: &&Triangle| {
            (0..3).all(|index| side(one[index], one[(index + 1) % 3], place) > 0.0)
        };
        let triangles = triangles(cell);
        let depths = triangles.iter().filter(holds).map(|one| height(one, place));
        depths.max_by(f64::total_cmp)
    }

    /// What is painted last at each place is what is nearest there; some places have something behind it.
    #[track_caller]
    fn check_picture(cells: &[Cell]) {
        let order = back_to_front(cells);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..cells.len()), "each cell is painted once");
        let bounds: Vec<_> = cells.iter().map(bounds).collect();
        let ends = |axis: usize| {
            let low = bounds.iter().map(|bounds| bounds[axis]).fold(f64::INFINITY, f64::min);
            let high = bounds.iter().map(|bounds| bounds[axis + 2]).fold(low, f64::max);
            (low, high)
        };
        let (x, y) = (ends(0), ends(1));
        let (mut hidden, share) = (0, |index: usize| (index as f64 + 0.37) / 120.0);
        for (column, row) in (0..120).flat_map(|column| (0..120).map(move |row| (column, row))) {
            let place = [x.0 + (x.1 - x.0) * share(column), y.0 + (y.1 - y.0) * share(row), 0.0];
            let depths = order.iter().filter_map(|&index| depth_at(&cells[index], place));
            let depths: Vec<_> = depths.collect();
            let Some(last) = depths.last() else { continue };
            hidden += usize::from(depths.len() > 1);
            let nearest = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            // Less than that of an overlap which is too small to see.
            assert!(nearest - last < 0.3, "{place:?}: {last} is painted over {nearest}");
        }
        assert!(hidden > 100, "{hidden}");
    }

    fn seen(patches: &[Patch], view: (f64, f64), scale: f64) -> Vec<Cell> {
        let (mesh, view) = (Mesh::new(patches, &[]), View::at(view.0, view.1));
        let pixel = |corner: usize| view.seen(mesh.corners[corner]).map(|one| scale * one);
        let cells = mesh.parts.iter().flat_map(|part| &part.cells);
        cells.map(|cell| cell.map(pixel)).collect()
    }

    #[test]
    fn nothing_hidden_is_seen_of_what_folds_before_itself() {
        for view in [(35.0, 25.0), (0.0, 0.0), (-70.0, 5.0), (120.0, -40.0), (0.0, 90.0)] {
            check_picture(&seen(&[Patch::torus([31, 17])], view, 60.0));
        }
        // Cells that are long in depth, and two waves that nearly touch.
        let waves = |shift: f64| {
            Patch::made([25, 3], move |u, v| [6.0 * u, 9.0 * v, (9.0 * u).sin() + v * u + shift])
        };
        for view in [(35.0, 25.0), (10.0, 4.0), (70.0, 12.0), (200.0, -12.0)] {
            check_picture(&seen(&[waves(0.0), waves(0.1)], view, 80.0));
        }
    }

    /// A cell that is long in depth: its middle is farther than that of the small one behind its near end.
    #[test]
    fn what_is_nearer_where_both_are_hides_whatever_the_middles_are() {
        let long: Cell =
            [[0.0, 0.0, -300.0], [100.0, 0.0, 100.0], [100.0, 20.0, 100.0], [0.0, 20.0, -300.0]];
        let small = |depth: f64| -> Cell {
            [[90.0, 5.0, depth], [99.0, 5.0, depth], [99.0, 15.0, depth], [90.0, 15.0, depth]]
        };
        assert!(depth(&long) < depth(&small(10.0)));
        for depth in [10.0, 200.0] {
            let hides = usize::from(depth > 100.0);
            assert_eq!(back_to_front(&[long, small(depth)])[1], hides);
            assert_eq!(back_to_front(&[small(depth), long])[1], 1 - hides);
        }
    }

    /// Three bars of which each lies over the next one at one end have no order, and are painted all the same.
    #[test]
    fn a_circle_of_cells_is_painted() {
        let bar = |from: [f64; 2], to: [f64; 2]| -> Cell {
            let length = (to[0] - from[0]).hypot(to[1] - from[1]);
            let (x, y) = (4.0 * (from[1] - to[1]) / length, 4.0 * (to[0] - from[0]) / length);
            [
                [from[0] - x, from[1] - y, 0.0],
                [to[0] - x, to[1] - y, 10.0],
                [to[0] + x, to[1] + y, 10.0],
                [from[0] + x, from[1] + y, 0.0],
            ]
        };
        let corners = [[0.0, 0.0], [60.0, 0.0], [30.0, 50.0]];
        let mut cells: Vec<_> =
            (0..3).map(|index| bar(corners[index], corners[(index + 1) % 3])).collect();
        let far = |depth: f64| -> Cell {
            [[-9.0, -9.0, depth], [80.0, -9.0, depth], [80.0, 80.0, depth], [-9.0, 80.0, depth]]
        };
        cells.extend([far(50.0), far(-50.0)]);
        let order = back_to_front(&cells);
        assert_eq!((order.len(), order[0], order[4]), (5, 4, 3));
    }
}
