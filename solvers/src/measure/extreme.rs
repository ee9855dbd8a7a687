//! Extremes of a quantity. Where they may lie is noted while the run is gone through, and only what may lie further out
//! than everything else is closed in on afterwards.

use assur_functions::{Sense, Top, top};

use super::grid::{Grid, Sampler};

/// Hills that are kept before those are dropped which are too low.
const MANY: usize = 256;
/// Hills that are climbed at most. A quantity that is nothing but rounding has one at every other point.
const MOST: usize = 500;
/// Places are about as far out as the extreme that are less far out by no more than this, over the size of the quantity.
const RIVAL: f64 = 1e-3;
/// Roundings of a value: what rises by less is no hill.
const ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// The smallest or largest value of a quantity along a run, SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The value. Not a number where the quantity is none somewhere.
    pub value: f64,
    /// When.
    pub time: f64,
    /// How far the time may be wrong because nearby values cannot be told apart: large where the quantity is flat.
    pub blur: f64,
}

impl From<Top> for Extreme {
    fn from(Top { value, place: time, blur }: Top) -> Self {
        Self { value, time, blur }
    }
}

/// Smallest and largest value of a quantity along a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Extremes {
    /// The smallest.
    pub lowest: Extreme,
    /// The largest.
    pub highest: Extreme,
    /// Other places at which it is about as small, in no order.
    pub low_rivals: Vec<Extreme>,
    /// Other places at which it is about as large, in no order.
    pub high_rivals: Vec<Extreme>,
}

impl Extremes {
    /// The largest absolute value.
    pub fn amplitude(&self) -> f64 {
        self.furthest().value.abs()
    }

    /// The one with the largest absolute value.
    pub fn furthest(&self) -> Extreme {
        match self.lowest.value.abs() > self.highest.value.abs() {
            true => self.lowest,
            false => self.highest,
        }
    }
}

/// A point of a quantity along the run: time and value.
pub(super) type Point = (f64, f64);

/// A stretch in which the quantity may lie further out than at any point.
#[derive(Clone, Copy, Debug)]
struct Hill {
    piece: usize,
    times: (f64, f64),
    /// How far out it lies on a parabola.
    guess: f64,
    /// How far out it may lie.
    reach: f64,
    /// How much it rises between the points.
    rise: f64,
}

/// The search for an extreme of a quantity.
#[derive(Clone, Debug)]
pub(super) struct Hunt {
    index: usize,
    sense: Sense,
    best: Option<Extreme>,
    /// The largest absolute value.
    size: f64,
    /// Rises that are no larger are none.
    noise: f64,
    hills: Vec<Hill>,
    /// Tops of hills, and ends of stretches.
    tops: Vec<Extreme>,
    /// Hills up to which all were kept.
    room: usize,
    /// The piece in which the last points lie.
    piece: usize,
    /// The last points, at most three, and how many of this stretch there were before.
    points: Vec<Point>,
    before: usize,
}

impl Hunt {
    pub(super) fn new(index: usize, sense: Sense) -> Self {
        Self {
            index,
            sense,
            best: None,
            size: 0.0,
            noise: 0.0,
            hills: Vec::new(),
            tops: Vec::new(),
            room: MANY,
            piece: 0,
            points: Vec::with_capacity(3),
            before: 0,
        }
    }

    /// Looks at a part of a step.
    pub(super) fn look(
        &mut self,
        (from, to): (f64, f64),
        grid: &Grid<'_>,
        sampler: &mut Sampler<'_>,
    ) {
        self.noise = sampler.noise(self.index);
        let column = grid.column(self.index);
        let points = || grid.times.into_iter().zip(column);
        let mut end = |time: f64| match points().find(|point| point.0 == time) {
            Some(point) => point,
            None => (time, sampler.at(grid.piece, time)[self.index]),
        };
        let (first, last) = (end(from), end(to));
        let goes_on = self.piece == grid.number && self.points.last().is_some_and(|p| p.0 == from);
        if !goes_on {
            self.close();
            self.piece = grid.number;
            self.point(first);
            self.end_at(first);
        }
        for point in points().filter(|point| point.0 > from && point.0 < to) {
            self.point(point);
        }
        self.point(last);
    }

    /// The next point of the stretch.
    fn point(&mut self, (time, value): Point) {
        self.size = self.size.max(value.abs());
        let blur = 0.0;
        self.reached(Extreme { value, time, blur });
        if self.points.len() == 3 {
            self.points.remove(0);
            self.before += 1;
        }
        self.points.push((time, value));
        let [before, here, after] = self.points[..] else {
            return;
        };
        if self.before == 0 {
            self.beside([before, here, after]);
        }
        if !self.sense.better(before.1, here.1) && !self.sense.better(after.1, here.1) {
            let rise = f64::max((here.1 - before.1).abs(), (here.1 - after.1).abs());
            let guess = vertex(before, here, after);
            self.hill((before.0, after.0), (here.1, guess), rise);
        }
    }

    /// Ends the stretch.
    fn close(&mut self) {
        if let Some(last) = self.points.last() {
            self.end_at(*last);
        }
        match self.points[..] {
            [first, second, third] => self.beside([third, second, first]),
            [first, second] => {
                let further = match self.sense.better(first.1, second.1) {
                    true => first.1,
                    false => second.1,
                };
                let rise = (first.1 - second.1).abs();
                self.hill((first.0, second.0), (further, further), rise);
            }
            _ => {}
        }
        self.points.clear();
        self.before = 0;
    }

    /// An end of a stretch, which is as good as a top.
    fn end_at(&mut self, (time, value): Point) {
        let blur = 0.0;
        self.tops.push(Extreme { value, time, blur });
        let count = self.tops.len();
        if count > MANY && count.is_power_of_two() {
            self.drop_low_tops();
        }
    }

    fn drop_low_tops(&mut self) {
        let Some(best) = self.best else { return };
        let near = RIVAL * self.size;
        self.tops.retain(|top| (top.value - best.value).abs() <= near);
    }

    /// An extreme beside an end of the stretch has no point on its other side that would show it.
    fn beside(&mut self, [end, next, third]: [Point; 3]) {
        if self.sense.better(end.1, next.1) && turns_beside(end, next, third) {
            let rise = (end.1 - next.1).abs().max((next.1 - third.1).abs());
            let times = (end.0.min(next.0), end.0.max(next.0));
            self.hill(times, (end.1, end.1), rise);
        }
    }

    /// Notes that between two times the quantity may lie further out than at the points, by no more than it rises between
    /// them.
    fn hill(&mut self, times: (f64, f64), (top, guess): (f64, f64), rise: f64) {
        let reach = match self.sense {
            Sense::Largest => top + rise,
            Sense::Smallest => top - rise,
        };
        if !(reach.is_finite() && self.rises(rise) && self.may_count(reach)) {
            return;
        }
        let piece = self.piece;
        self.hills.push(Hill { piece, times, guess, reach, rise });
        if self.hills.len() > self.room {
            let hills = std::mem::take(&mut self.hills);
            let high = hills.into_iter().filter(|hill| self.may_count(hill.reach));
            self.hills = high.collect();
            self.room = MANY.max(2 * self.hills.len());
        }
    }

    /// Whether a rise is more than rounding.
    fn rises(&self, rise: f64) -> bool {
        rise > f64::max(ROUNDINGS * self.size, self.noise)
    }

    fn may_count(&self, reach: f64) -> bool {
        self.best.is_none_or(|best| self.sense.better(reach, best.value))
    }

    fn reached(&mut self, extreme: Extreme) {
        if self.may_count(extreme.value) {
            self.best = Some(extreme);
        }
    }

    /// The extreme, once all of the run has been looked at, and other places at which the quantity is about as far out. None
    /// if there was nothing to look at.
    pub(super) fn finish(mut self, sampler: &mut Sampler<'_>) -> Option<(Extreme, Vec<Extreme>)> {
        self.close();
        let mut hills = std::mem::take(&mut self.hills);
        let sign = match self.sense {
            Sense::Largest => -1.0,
            Sense::Smallest => 1.0,
        };
        hills.sort_by(|a, b| (sign * a.guess).total_cmp(&(sign * b.guess)));
        // What looked like a hill beside nothing may be rounding beside what came later.
        hills.retain(|hill| self.rises(hill.rise));
        for hill in hills.into_iter().take(MOST) {
            if !self.may_count(hill.reach) {
                continue;
            }
            let index = self.index;
            let mut at = |time: f64| sampler.one(hill.piece, time, index);
            let top = Extreme::from(top(self.sense, hill.times, &mut at));
            self.reached(top);
            self.tops.push(top);
        }
        self.drop_low_tops();
        Some((self.best?, self.tops))
    }
}

/// The value of a parabola through three points, of which the middle one is furthest out, where it turns.
fn vertex(before: Point, here: Point, after: Point) -> f64 {
    let (back, ahead) = (here.0 - before.0, after.0 - here.0);
    let (left, right) = ((here.1 - before.1) / back, (after.1 - here.1) / ahead);
    let bend = (right - left) / (back + ahead);
    let slope = left + bend * back;
    match bend == 0.0 {
        true => here.1,
        false => here.1 - slope * slope / (4.0 * bend),
    }
}

/// Whether a parabola through three points, of which the first is further out than the second, turns between these two,
/// or so little before the first that the quantity itself may turn between them.
fn turns_beside(end: Point, next: Point, third: Point) -> bool {
    if third.0 == next.0 {
        return true;
    }
    let chord = |a: Point, b: Point| (b.1 - a.1) / (b.0 - a.0);
    let bend = (chord(next, third) - chord(end, next)) / (third.0 - end.0);
    let slope = chord(end, next) - bend * (next.0 - end.0);
    let turn = -slope / (2.0 * bend * (next.0 - end.0));
    turn > -0.5 && turn < 1.0
}
