//! Curves in pixels: as few points as the eye needs.

/// Points whose loss moves the line by less than this many pixels are left out.
const TOLERANCE: f64 = 0.08;

/// Leaves out points without moving the line visibly (Ramer, Douglas and Peucker), piece by piece between gaps.
pub fn simplify(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let finite = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
    let mut kept = Vec::new();
    for piece in points.split(|point| !finite(point)) {
        if piece.is_empty() {
            continue;
        }
        if !kept.is_empty() {
            kept.push((f64::NAN, f64::NAN));
        }
        kept.extend(piece_of(piece));
    }
    kept
}

fn piece_of(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut keep = vec![false; points.len()];
    let last = points.len() - 1;
    (keep[0], keep[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let farthest = (from + 1..to)
            .map(|index| (index, distance(points[index], points[from], points[to])))
            .max_by(|(_, a), (_, b)| a.total_cmp(b));
        if let Some((index, far)) = farthest.filter(|(_, far)| *far > TOLERANCE) {
            debug_assert!(far.is_finite());
            keep[index] = true;
            open.push((from, index));
            open.push((index, to));
        }
    }
    points.iter().zip(keep).filter(|(_, keep)| *keep).map(|(point, _)| *point).collect()
}

/// Distance of a point from a line through two others.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (along, up) = (to.0 - from.0, to.1 - from.1);
    let (x, y) = (point.0 - from.0, point.1 - from.1);
    let length = along.hypot(up);
    if length == 0.0 { x.hypot(y) } else { (along * y - up * x).abs() / length }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_keeps_its_ends() {
        let points: Vec<_> =
            (0..100).map(|index| (f64::from(index), 2.0 * f64::from(index))).collect();
        assert_eq!(simplify(&points), [(0.0, 0.0), (99.0, 198.0)]);
    }

    #[test]
    fn a_sine_stays_a_sine() {
        let wave = |x: f64| 80.0 * (x / 40.0).sin();
        let points: Vec<_> =
            (0..2000).map(|index| f64::from(index) / 5.0).map(|x| (x, wave(x))).collect();
        let few = simplify(&points);
        assert!(few.len() < 120, "{}", few.len());
        for pair in few.windows(2) {
            let middle = ((pair[0].0 + pair[1].0) / 2.0, (pair[0].1 + pair[1].1) / 2.0);
            // Up to 0.08 across the line is up to 0.18 upwards where the line is steepest.
            assert!((middle.1 - wave(middle.0)).abs() < 0.19);
        }
    }

    #[test]
    fn gaps_stay_gaps() {
        let nothing = (f64::NAN, 0.0);
        let few = simplify(&[(0.0, 0.0), (1.0, 0.0), nothing, nothing, (2.0, 0.0)]);
        assert_eq!(few.iter().filter(|point| point.0.is_nan()).count(), 1);
        assert!(simplify(&[]).is_empty());
    }
}
