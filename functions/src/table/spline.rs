//! A spline from its points.

use std::fmt;
use std::hash::{Hash, Hasher};

use super::Table;
use super::smooth::Smoothing;

/// How a spline ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The third derivative is continuous at the second knot and at the last but one as well ("not a knot"), so that it is as
    /// accurate there as elsewhere.
    Open,
    /// It goes on periodically.
    Periodic,
}

/// A cubic spline through or near points, with its own numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    /// It in the words of the file.
    pub what: String,
    knots: Vec<f64>,
    pieces: Vec<[f64; 4]>,
    density: f64,
    starts: Vec<u32>,
    is_periodic: bool,
}

/// Why there is no spline. Points are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableFault {
    /// There are fewer than two points.
    Few(usize),
    /// A point whose abscissa or ordinate is no finite number.
    NotFinite(usize),
    /// A point with the same abscissa as the one before.
    Equal(usize),
    /// A point with a smaller abscissa than the one before.
    Falling(usize),
    /// A period does not end with the ordinate that it begins with.
    Open {
        /// The first ordinate.
        first: f64,
        /// The last one.
        last: f64,
    },
    /// The standard error is not above zero.
    Error(f64),
}

impl Spline {
    /// A spline through points, or near them if their ordinates have a standard error: then the second derivative is zero at the
    /// ends of an open one. Two points make a straight line, three a parabola.
    ///
    /// # Errors
    /// Points that make no curve.
    pub fn new(
        what: &str,
        points: &[(f64, f64)],
        ends: Ends,
        error: Option<f64>,
    ) -> Result<Self, TableFault> {
        check(points, ends, error)?;
        let steps: Vec<f64> = points.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        let mut y: Vec<f64> = points.iter().map(|point| point.1).collect();
        let mut moments = vec![0.0; y.len()];
        let is_closed = ends == Ends::Periodic;
        let smoothing = Smoothing { steps: &steps, is_closed };
        match (error, ends) {
            (Some(error), _) if y.len() > 2 => {
                if is_closed {
                    y[0] = 0.5 * (y[0] + y[y.len() - 1]);
                }
                let own = y.len() - usize::from(is_closed);
                let (bent, smooth) = smoothing.near(&y[..own], error);
                moments[..own].copy_from_slice(&bent);
                y[..own].copy_from_slice(&smooth);
            }
            (None, Ends::Periodic) => {
                let bent = smoothing.through(&y[..y.len() - 1]);
                moments[..bent.len()].copy_from_slice(&bent);
            }
            (None, Ends::Open) => moments = not_a_knot(&steps, &y),
            (Some(_), _) => {}
        }
        if let (true, Some(last)) = (is_closed, y.len().checked_sub(1)) {
            (y[last], moments[last]) = (y[0], moments[0]);
        }
        let knots: Vec<f64> = points.iter().map(|point| point.0).collect();
        let pieces = (0..steps.len())
            .map(|i| piece(steps[i], (y[i], y[i + 1]), (moments[i], moments[i + 1])));
        let (density, starts) = starts(&knots);
        Ok(Self {
            what: what.to_string(),
            pieces: pieces.collect(),
            knots,
            density,
            starts,
            is_periodic: is_closed,
        })
    }

    /// It ready to be looked up in.
    pub fn table(&self) -> Table<'_> {
        Table {
            what: &self.what,
            knots: &self.knots,
            pieces: &self.pieces,
            density: self.density,
            starts: &self.starts,
            is_periodic: self.is_periodic,
        }
    }

    /// A number that tells it from others.
    pub fn fingerprint(&self) -> u64 {
        /// The 64-bit prime of Fowler, Noll and Vo.
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        let numbers = self.knots.iter().chain(self.pieces.as_flattened()).map(|one| one.to_bits());
        let all =
            numbers.chain(self.what.bytes().map(u64::from)).chain([u64::from(self.is_periodic)]);
        all.fold(0xcbf2_9ce4_8422_2325, |hash, word| {
            let mixed = (hash ^ word).wrapping_mul(PRIME);
            mixed ^ (mixed >> 29)
        })
    }
}

impl Eq for Spline {}

impl Hash for Spline {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.fingerprint().hash(state);
    }
}

/// Whether points make a curve.
fn check(points: &[(f64, f64)], ends: Ends, error: Option<f64>) -> Result<(), TableFault> {
    /// Part of the range of the ordinates by which a period may fail to close: rounding in a file.
    const CLOSED: f64 = 1e-9;
    /// Standard errors of the difference of two ordinates by which a smoothed one may.
    const LIKELY: f64 = 4.0;
    if points.len() < 2 {
        return Err(TableFault::Few(points.len()));
    }
    let is_number = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
    if let Some(at) = points.iter().position(|point| !is_number(point)) {
        return Err(TableFault::NotFinite(at));
    }
    if let Some(at) = points.windows(2).position(|pair| pair[1].0 <= pair[0].0) {
        let is_equal = points[at].0 == points[at + 1].0;
        return Err(if is_equal { TableFault::Equal(at + 1) } else { TableFault::Falling(at + 1) });
    }
    if let Some(error) = error.filter(|error| !(*error > 0.0 && error.is_finite())) {
        return Err(TableFault::Error(error));
    }
    let (first, last) = (points[0].1, points[points.len() - 1].1);
    let of = |pick: fn(f64, f64) -> f64| points.iter().map(|point| point.1).reduce(pick);
    let height = of(f64::max).zip(of(f64::min)).map_or(0.0, |(high, low)| high - low);
    let open = CLOSED * height + error.map_or(0.0, |error| LIKELY * error * 2f64.sqrt());
    if ends == Ends::Periodic && (last - first).abs() > open {
        return Err(TableFault::Open { first, last });
    }
    Ok(())
}

/// Second derivatives at the knots of the spline through points whose first two pieces are one cubic, and whose last two.
fn not_a_knot(steps: &[f64], y: &[f64]) -> Vec<f64> {
    let last = steps.len();
    let slope = |i: usize| (y[i + 1] - y[i]) / steps[i];
    match last {
        1 => return vec![0.0; 2],
        2 => return vec![2.0 * (slope(1) - slope(0)) / (steps[0] + steps[1]); 3],
        _ => {}
    }
    // The moment at an end is that next to it, and `ratio` times its difference from the one behind.
    let (begin, end) = (steps[0] / steps[1], steps[last - 1] / steps[last - 2]);
    let mut upper = vec![0.0; last];
    let mut moments = vec![0.0; last + 1];
    for i in 1..last {
        let (mut below, mut above) = (steps[i - 1], steps[i]);
        let mut here = 2.0 * (below + above);
        if i == 1 {
            (here, above) = (here + below * (1.0 + begin), above - below * begin);
            below = 0.0;
        }
        if i == last - 1 {
            let beyond = steps[i];
            (here, below) = (here + beyond * (1.0 + end), below - beyond * end);
            above = 0.0;
        }
        let pivot = here - below * upper[i - 1];
        upper[i] = above / pivot;
        moments[i] = (6.0 * (slope(i) - slope(i - 1)) - below * moments[i - 1]) / pivot;
    }
    for i in (1..last - 1).rev() {
        moments[i] -= upper[i] * moments[i + 1];
    }
    moments[0] = moments[1] + begin * (moments[1] - moments[2]);
    moments[last] = moments[last - 1] + end * (moments[last - 1] - moments[last - 2]);
    moments
}

/// The factors of a piece from its step, its ordinates and its second derivatives.
fn piece(step: f64, y: (f64, f64), moments: (f64, f64)) -> [f64; 4] {
    let slope = (y.1 - y.0) / step - step * (2.0 * moments.0 + moments.1) / 6.0;
    [y.0, slope, 0.5 * moments.0, (moments.1 - moments.0) / (6.0 * step)]
}

/// Equal parts of the range in a unit of the abscissa, and the piece at the begin of each. They are shorter than the shortest
/// piece, so that at most one knot lies inside, unless that would be too many.
fn starts(knots: &[f64]) -> (f64, Vec<u32>) {
    /// Part of a step by which knots may be off and count as evenly apart.
    const EVEN: f64 = 1e-6;
    /// Most parts for each piece.
    const MOST: f64 = 16.0;
    let pieces = knots.len() - 1;
    let (first, last) = (knots[0], knots[pieces]);
    let even = pieces as f64 / (last - first);
    let is_even = |(i, knot): (usize, &f64)| ((knot - first) * even - i as f64).abs() < EVEN;
    if knots.iter().enumerate().all(is_even) {
        return (even, Vec::new());
    }
    let steps = knots.windows(2).map(|pair| pair[1] - pair[0]);
    let shortest = steps.fold(f64::INFINITY, f64::min);
    let parts = ((last - first) / shortest).min(MOST * pieces as f64).ceil() as usize + 1;
    let density = parts as f64 / (last - first);
    // What is looked up is found by the same rounded numbers; whole ones may count to the part before.
    let place = |knot: f64| (knot - first) * density;
    let of = |part: usize| knots[..pieces].partition_point(|knot| place(*knot) <= part as f64);
    let starts = (0..=parts).map(|part| of(part).saturating_sub(1) as u32);
    let mut starts: Vec<u32> = starts.collect();
    starts[parts] = pieces as u32 - 1;
    (density, starts)
}

impl fmt::Display for TableFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Few(0) => write!(f, "there are no points; a curve has at least two"),
            Self::Few(_) => write!(f, "there is one point only; a curve has at least two"),
            Self::NotFinite(_) => write!(f, "this is no finite number"),
            Self::Equal(_) => write!(f, "the abscissa is the same as that of the point before"),
            Self::Falling(_) => write!(f, "the abscissa is smaller than that of the point before"),
            Self::Open { .. } => write!(f, "the period does not end as it begins"),
            Self::Error(_) => write!(f, "the standard error of the ordinates has to be above zero"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(at: impl Iterator<Item = f64>, f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        at.map(|x| (x, f(x))).collect()
    }

    fn spline(points: &[(f64, f64)], ends: Ends) -> Spline {
        Spline::new("table", points, ends, None).unwrap()
    }

    #[test]
    fn few_points_and_cubics_are_exact() {
        let line = spline(&[(1.0, 2.0), (3.0, 8.0)], Ends::Open);
        assert_eq!((line.table().value(2.0, 0), line.table().value(2.0, 1)), (5.0, 3.0));
        let parabola = spline(&points([0.0, 1.0, 4.0].into_iter(), |x| x * x - x), Ends::Open);
        assert!((parabola.table().value(3.0, 0) - 6.0).abs() < 1e-14);
        let cubic = |x: f64| ((0.3 * x - 1.0) * x + 0.5) * x - 2.0;
        for uneven in [0.0, 0.3] {
            let at = (0..9).map(|i| f64::from(i) + uneven * (1.7 * f64::from(i)).sin());
            let spline = spline(&points(at, cubic), Ends::Open);
            for x in [0.1, 2.7, 5.5, 7.9] {
                assert!((spline.table().value(x, 0) - cubic(x)).abs() < 1e-12, "{uneven} {x}");
                assert!((spline.table().value(x, 2) - (1.8 * x - 2.0)).abs() < 1e-11);
                assert!((spline.table().value(x, 3) - 1.8).abs() < 1e-9);
            }
        }
    }

    /// Halving the steps takes a sixteenth of the error: up to the ends, over the ends of a period.
    #[test]
    fn the_error_is_of_fourth_order() {
        let error = |count: i32, ends| {
            let at = (0..=count).map(|i| std::f64::consts::TAU * f64::from(i) / f64::from(count));
            let mut list = points(at, |x| (x + 0.4).sin());
            list[count as usize].1 = list[0].1;
            let spline = spline(&list, ends);
            let at = (0..1000).map(|i| std::f64::consts::TAU * f64::from(i) / 1000.0);
            at.map(|x| (spline.table().value(x, 0) - (x + 0.4).sin()).abs()).fold(0.0, f64::max)
        };
        for ends in [Ends::Open, Ends::Periodic] {
            let order = (error(40, ends) / error(80, ends)).log2();
            assert!((3.8..4.3).contains(&order), "{ends:?}: {order}");
        }
    }

    #[test]
    fn derivatives_are_continuous_everywhere() {
        let at = [0.0, 0.2, 0.9, 1.0, 2.5, 2.6, 4.0];
        let mut list = points(at.into_iter(), |x| (3.0 * x).cos());
        list[6].1 = list[0].1;
        for ends in [Ends::Open, Ends::Periodic] {
            let spline = spline(&list, ends);
            let table = spline.table();
            let inner = at.len() - 1;
            for knot in &at[usize::from(ends == Ends::Open)..inner] {
                for order in 0..3 {
                    let sides = [-1e-9, 1e-9].map(|by| table.value(knot + by, order));
                    assert!((sides[0] - sides[1]).abs() < 1e-5, "{ends:?} {knot} {order}");
                }
                let found = table.value(*knot, 0);
                assert!((found - list.iter().find(|one| one.0 == *knot).unwrap().1).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn every_piece_is_found() {
        let at: Vec<f64> = (0..200).map(|i| 1.07f64.powi(i)).collect();
        let spline = spline(&points(at.iter().copied(), f64::ln), Ends::Open);
        let table = spline.table();
        for pair in at.windows(2) {
            for x in [pair[0], 0.5 * (pair[0] + pair[1]), pair[1].next_down()] {
                assert_eq!(table.at(x).0, pair[0], "{x}");
            }
        }
    }

    /// At and beside its knots, over many periods, a curve has the value of the pieces there.
    #[test]
    fn rounding_leads_to_no_other_piece() {
        for uneven in [0.0, 0.3] {
            let at = (0..=30)
                .map(|i| f64::from(i) + uneven * (f64::from(i) * std::f64::consts::PI / 1.5).sin());
            let list: Vec<(f64, f64)> =
                at.map(|x| (x, (x * std::f64::consts::TAU / 30.0).sin())).collect();
            let (begin, end) = (list[0].0, list[30].0);
            let mut list = list;
            list[30].1 = list[0].1;
            let spline = spline(&list, Ends::Periodic);
            for turns in [-1e9, -7.0, -1.0, 0.0, 1.0, 3.0, 1e6, 1e9] {
                for (x, y) in &list {
                    for x in [x.next_down(), *x, x.next_up()].map(|x| x + turns * (end - begin)) {
                        let found = spline.table().value(x, 0);
                        let within = 1e-12 + 4.0 * f64::EPSILON * x.abs();
                        assert!((found - y).abs() < within, "{uneven} {turns}: {x}: {found}, {y}");
                    }
                }
            }
        }
    }

    #[test]
    fn outside_there_is_nothing_unless_periodic() {
        let list = [(0.0, 1.0), (1.0, 2.0), (3.0, 0.0), (4.0, 1.0)];
        let open = spline(&list, Ends::Open);
        crate::fault::take();
        assert!(open.table().value(4.0 + 1e-13, 0).is_finite() && crate::fault::take().is_none());
        assert!(open.table().value(4.5, 0).is_nan());
        let told = crate::fault::take().unwrap().to_string();
        assert_eq!(
            told,
            "`table` is looked up at 4.500000e0, its points reach from 0.000000e0 to 4.000000e0 in SI units"
        );
        let closed = spline(&list, Ends::Periodic);
        for x in [0.3, 1.7, 3.9] {
            for periods in [-3.0, 1.0, 12.0] {
                let moved = closed.table().value(x + 4.0 * periods, 0);
                assert!((moved - closed.table().value(x, 0)).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn points_that_make_no_curve_are_named() {
        let new = |points: &[(f64, f64)], ends| Spline::new("", points, ends, None).map(|_| ());
        let open = |points: &[(f64, f64)]| new(points, Ends::Open);
        assert_eq!(open(&[(0.0, 1.0)]), Err(TableFault::Few(1)));
        assert_eq!(open(&[(0.0, 1.0), (1.0, 1.0), (1.0, 2.0)]), Err(TableFault::Equal(2)));
        assert_eq!(open(&[(0.0, 1.0), (1.0, 1.0), (0.5, 2.0)]), Err(TableFault::Falling(2)));
        assert_eq!(open(&[(0.0, 1.0), (1.0, f64::NAN)]), Err(TableFault::NotFinite(1)));
        let period = [(0.0, 1.0), (1.0, 3.0), (2.0, 1.5)];
        assert_eq!(new(&period, Ends::Periodic), Err(TableFault::Open { first: 1.0, last: 1.5 }));
        let error = Spline::new("", &period, Ends::Open, Some(0.0)).map(|_| ());
        assert_eq!(error, Err(TableFault::Error(0.0)));
    }

    /// Noise of which the error is known: the curve is nearer to the truth than the points are.
    #[test]
    fn smoothing_takes_away_what_the_error_explains() {
        let truth = |x: f64| (x).sin();
        for ends in [Ends::Open, Ends::Periodic] {
            let mut state = 1_u64;
            let mut noise = || {
                // Twelve numbers of a linear congruence come near the normal distribution.
                let mut sum = -6.0;
                for _ in 0..12 {
                    state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    sum += (state >> 11) as f64 / (1_u64 << 53) as f64;
                }
                0.05 * sum
            };
            let mut list: Vec<_> = (0..=100)
                .map(|i| std::f64::consts::TAU * f64::from(i) / 100.0)
                .map(|x| (x, truth(x) + noise()))
                .collect();
            list[100].1 = list[0].1;
            let smooth = Spline::new("", &list, ends, Some(0.05)).unwrap();
            let rms = |of: &dyn Fn(f64, f64) -> f64| {
                (list.iter().map(|(x, y)| of(*x, *y).powi(2)).sum::<f64>() / 101.0).sqrt()
            };
            let taken = rms(&|x, y| smooth.table().value(x, 0) - y);
            let left = rms(&|x, _| smooth.table().value(x, 0) - truth(x));
            assert!((taken / 0.05 - 1.0).abs() < 0.02, "{ends:?}: {taken}");
            assert!(left < 0.02, "{ends:?}: {left}");
            let (begin, end) =
                (smooth.table().value(0.0, 1), smooth.table().value(std::f64::consts::TAU, 1));
            if ends == Ends::Periodic {
                assert!((begin - end).abs() < 1e-12);
            }
        }
        let line = [(0.0, 0.1), (1.0, 0.9), (2.0, 2.1), (3.0, 2.9)];
        let straight = Spline::new("", &line, Ends::Open, Some(10.0)).unwrap();
        assert!((straight.table().value(0.5, 1) - 0.96).abs() < 1e-9, "the line by least squares");
    }
}
