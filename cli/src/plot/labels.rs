//! Names beside points, so that none covers another.

use super::legend::CHARACTER;
use super::svg::Anchor;
use crate::show::text;

/// Where a name may stand beside its point: which end of it, right and down.
const PLACES: [(Anchor, f64, f64); 10] = [
    (Anchor::Start, 6.0, 4.0),
    (Anchor::End, -6.0, 4.0),
    (Anchor::Start, 6.0, -7.0),
    (Anchor::Start, 6.0, 15.0),
    (Anchor::End, -6.0, -7.0),
    (Anchor::End, -6.0, 15.0),
    (Anchor::Middle, 0.0, -9.0),
    (Anchor::Middle, 0.0, 19.0),
    (Anchor::Middle, 0.0, -22.0),
    (Anchor::Middle, 0.0, 32.0),
];
/// Height of a line above and below its place.
const ABOVE: f64 = 10.0;
const BELOW: f64 = 3.0;

/// Where names stand already.
#[derive(Default)]
pub struct Labels {
    /// Left, right, top, bottom of each.
    taken: Vec<[f64; 4]>,
}

impl Labels {
    /// Keeps a place free around a point.
    pub fn avoid(&mut self, (x, y): (f64, f64), radius: f64) {
        self.taken.push([x - radius, x + radius, y - radius, y + radius]);
    }

    /// The first place for a name beside a point that is free, between a left and a right end; of none that covers least.
    pub fn place(
        &mut self,
        (x, y): (f64, f64),
        name: &str,
        (left, right): (f64, f64),
    ) -> (Anchor, (f64, f64)) {
        let width = text::width(name) as f64 * CHARACTER;
        let extent = |&(anchor, right, down): &(Anchor, f64, f64)| {
            let begin = x + right
                - width
                    * match anchor {
                        Anchor::Start => 0.0,
                        Anchor::Middle => 0.5,
                        Anchor::End => 1.0,
                    };
            [begin, begin + width, y + down - ABOVE, y + down + BELOW]
        };
        let covered = |place: &(Anchor, f64, f64)| {
            let own = extent(place);
            let beyond = (left - own[0]).max(0.0) + (own[1] - right).max(0.0);
            let others = self.taken.iter().map(|other| overlap(&own, other)).sum::<f64>();
            others + beyond * (ABOVE + BELOW)
        };
        let free = PLACES.iter().find(|place| covered(place) == 0.0);
        let least = || PLACES.iter().min_by(|a, b| covered(a).total_cmp(&covered(b)));
        let chosen = free.or_else(least).unwrap_or(&PLACES[0]);
        let (place, end) = (extent(chosen), (x + chosen.1, y + chosen.2));
        self.taken.push(place);
        (chosen.0, end)
    }
}

/// The area that two rectangles share.
fn overlap(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    let along = (a[1].min(b[1]) - a[0].max(b[0])).max(0.0);
    along * (a[3].min(b[3]) - a[2].max(b[2])).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_points_close_by_do_not_cover_each_other() {
        let mut labels = Labels::default();
        for index in 0..6 {
            labels.place((100.0 + 3.0 * f64::from(index), 200.0), "uncoupled", (0.0, 700.0));
        }
        for (index, one) in labels.taken.iter().enumerate() {
            for other in &labels.taken[..index] {
                assert_eq!(overlap(one, other), 0.0, "{one:?} {other:?}");
            }
        }
    }
}
