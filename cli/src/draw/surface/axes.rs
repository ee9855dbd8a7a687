//! The box that a surface stands in: three walls behind it with lines at round numbers, which are written along its edges.

use super::vector::Vector;
use super::view::View;
use crate::draw::geometry::distance;
use crate::plot::axis::Axis;
use crate::plot::legend::text_width;
use crate::plot::svg::{Anchor, Svg};

/// Intervals along the longest side, about.
const INTERVALS: f64 = 6.0;
/// Room around the surface, as a part of the longest side.
const ROOM: f64 = 0.04;
/// Length of a tick, and from its end to its number, pixels.
const TICK: f64 = 5.0;
const GAP: f64 = 4.0;
/// Height of a number, and of the row with the name of an axis.
const HEIGHT: f64 = 11.0;
const ROW: f64 = 19.0;
/// Edges shorter than this have no numbers: they are looked along. Pixels.
const SHORT: f64 = 24.0;
/// Least distance of numbers from each other and from the ends of an edge, pixels.
const APART: f64 = 30.0;
const END: f64 = 9.0;

/// The box, in millimetres.
pub struct Frame {
    axes: [Axis; 3],
}

impl Frame {
    /// The box around the corners of a surface.
    pub fn around((low, high): (Vector, Vector)) -> Self {
        let sides = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        let longest = sides.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let room = ROOM * longest;
        let axis = |axis: usize| {
            let intervals = (INTERVALS * sides[axis] / longest).ceil().max(4.0);
            Axis::between(low[axis] - room, high[axis] + room, intervals as usize)
        };
        Self { axes: [axis(0), axis(1), axis(2)] }
    }

    /// Its eight corners.
    pub fn corners(&self) -> impl Iterator<Item = Vector> {
        (0..8).map(|number| [0, 1, 2].map(|axis| self.end(axis, number >> axis & 1 == 1)))
    }

    fn end(&self, axis: usize, is_high: bool) -> f64 {
        let (low, high) = self.axes[axis].ends;
        if is_high { high } else { low }
    }

    /// Draws the walls behind the surface, and the numbers.
    pub fn draw(&self, svg: &mut Svg, view: &View, pixel: &impl Fn(Vector) -> (f64, f64)) {
        let sides = Sides { frame: self, view, pixel };
        svg.begin("axes");
        for axis in 0..3 {
            sides.wall(svg, axis);
        }
        for axis in 0..3 {
            sides.edge(svg, axis);
        }
        svg.end();
    }
}

/// The sides of a box as they are seen.
struct Sides<'a, P> {
    frame: &'a Frame,
    view: &'a View,
    pixel: &'a P,
}

impl<P: Fn(Vector) -> (f64, f64)> Sides<'_, P> {
    /// Where the side of an axis is that is turned away from the viewer, or the opposite one.
    fn side(&self, axis: usize, is_back: bool) -> f64 {
        let towards = self.view.axes[2][axis] > 0.0;
        self.frame.end(axis, towards != is_back)
    }

    /// The side across an axis at the back, with lines at the ticks of the two others.
    fn wall(&self, svg: &mut Svg, axis: usize) {
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let place = |along: f64, up: f64| {
            let mut place = [self.side(axis, true); 3];
            (place[a], place[b]) = (along, up);
            (self.pixel)(place)
        };
        let (ends_a, ends_b) = (self.frame.axes[a].ends, self.frame.axes[b].ends);
        let corners = [
            (ends_a.0, ends_b.0),
            (ends_a.1, ends_b.0),
            (ends_a.1, ends_b.1),
            (ends_a.0, ends_b.1),
        ];
        svg.polygon("wall", &corners.map(|(along, up)| place(along, up)));
        for tick in &self.frame.axes[a].ticks {
            svg.line("grid", place(*tick, ends_b.0), place(*tick, ends_b.1));
        }
        for tick in &self.frame.axes[b].ticks {
            svg.line("grid", place(ends_a.0, *tick), place(ends_a.1, *tick));
        }
    }

    /// The edge along an axis that carries its numbers: one between a side at the back and one at the front, so that it is
    /// on the outline of the box. Of the two the lower one, of edges that stand the left one.
    fn edge(&self, svg: &mut Svg, axis: usize) {
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let edge = |is_back: bool| {
            let mut place = [0.0; 3];
            (place[a], place[b]) = (self.side(a, is_back), self.side(b, !is_back));
            move |value: f64| {
                let mut at = place;
                at[axis] = value;
                at
            }
        };
        let ends = self.frame.axes[axis].ends;
        let middle = |is_back: bool| (self.pixel)(edge(is_back)((ends.0 + ends.1) / 2.0));
        let (one, other) = (middle(true), middle(false));
        let is_back = if axis == 2 { one.0 <= other.0 } else { one.1 >= other.1 };
        self.numbers(svg, axis, edge(is_back), if is_back { b } else { a });
    }

    /// The numbers along an edge, on its outer side: that to which it is the front of another axis.
    fn numbers(&self, svg: &mut Svg, axis: usize, edge: impl Fn(f64) -> Vector, outer: usize) {
        let scale = &self.frame.axes[axis];
        let ends = [scale.ends.0, scale.ends.1];
        let [from, to] = ends.map(|end| (self.pixel)(edge(end)));
        let length = distance(from, to);
        if length < SHORT {
            return;
        }
        svg.line("axis", from, to);
        let out = self.outwards(edge(scale.ends.0), outer);
        let at = |(x, y): (f64, f64), far: f64| (x + far * out.0, y + far * out.1);
        let per_pixel = (ends[1] - ends[0]) / length;
        let is_apart = |tick: &&f64| ends.iter().all(|end| (**tick - end).abs() > END * per_pixel);
        let apart =
            scale.ticks.windows(2).next().map_or(length, |pair| (pair[1] - pair[0]) / per_pixel);
        let every = (APART / apart).ceil() as usize;
        let mut widest = 0.0_f64;
        for tick in scale.ticks.iter().step_by(every).filter(is_apart) {
            let place = (self.pixel)(edge(*tick));
            svg.line("axis", place, at(place, TICK));
            let label = scale.label(*tick);
            write(svg, "number", at(place, TICK + GAP), out, &label);
            widest = widest.max(text_width(&label));
        }
        let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
        // Beyond the numbers, as they reach out from the edge.
        let far = TICK + GAP + widest * out.0.abs() + ROW * out.1.abs() + 8.0;
        write(svg, "heading", at(middle, far), out, &format!("{}, mm", ["x", "y", "z"][axis]));
    }

    /// The direction in the picture from the back of an axis to its front.
    fn outwards(&self, mut place: Vector, axis: usize) -> (f64, f64) {
        let mut seen = [true, false].map(|is_back| {
            place[axis] = self.side(axis, is_back);
            (self.pixel)(place)
        });
        // An axis that is looked along leads nowhere.
        if distance(seen[0], seen[1]) < 1.0 {
            seen = [(0.0, 0.0), (0.0, 1.0)];
        }
        let [from, to] = seen;
        let length = distance(from, to);
        ((to.0 - from.0) / length, (to.1 - from.1) / length)
    }
}

/// Writes a text that begins at a place and reaches into a direction.
fn write(svg: &mut Svg, class: &str, place: (f64, f64), out: (f64, f64), text: &str) {
    let anchor = match out.0 {
        right if right > 0.4 => Anchor::Start,
        left if left < -0.4 => Anchor::End,
        _ => Anchor::Middle,
    };
    let base = place.1 + HEIGHT * (0.4 + 0.5 * out.1);
    svg.text(class, (place.0, base), anchor, text);
}
