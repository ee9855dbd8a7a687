//! Lines along which values over a grid have one level.

/// Values over two axes, row by row; not a number where there is none.
#[derive(Clone, Copy)]
pub struct Field<'a> {
    /// Values along.
    pub columns: &'a [f64],
    /// Values upwards.
    pub rows: &'a [f64],
    /// What is over them.
    pub values: &'a [f64],
}

type Point = (f64, f64);

impl Field<'_> {
    /// The lines of a level, straight within each cell; those that go round end where they begin.
    pub fn contours(&self, level: f64) -> Vec<Vec<Point>> {
        let cells = (1..self.rows.len())
            .flat_map(|row| (1..self.columns.len()).map(move |column| (row, column)));
        let pieces = cells.flat_map(|(row, column)| self.pieces(row, column, level));
        // A line that goes through a corner of the grid has nothing in the cells that only touch it.
        join(pieces.filter(|[from, to]| from != to).collect())
    }

    /// The pieces of the lines in the cell below and left of a place, by marching squares: where all four edges are crossed the
    /// middle of the cell says which belong together.
    fn pieces(&self, row: usize, column: usize, level: f64) -> Vec<[Point; 2]> {
        let corner = |up: usize, along: usize| {
            let (row, column) = (row - 1 + up, column - 1 + along);
            let value = self.values[row * self.columns.len() + column] - level;
            ((self.columns[column], self.rows[row]), value)
        };
        // Around the cell, so that neighbours share an edge.
        let corners = [corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)];
        if corners.iter().any(|(_, value)| !value.is_finite()) {
            return Vec::new();
        }
        let crossed = (0..4).filter_map(|edge| {
            let ((from, low), (to, high)) = (corners[edge], corners[(edge + 1) % 4]);
            if (low >= 0.0) == (high >= 0.0) {
                return None;
            }
            // From one and the same end, so that both cells of an edge find one and the same point.
            let ((from, low), (to, high)) =
                if low < high { ((from, low), (to, high)) } else { ((to, high), (from, low)) };
            let share = low / (low - high);
            Some((from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1)))
        });
        let crossed: Vec<Point> = crossed.collect();
        match *crossed {
            [a, b] => vec![[a, b]],
            [a, b, c, d] => {
                let middle = corners.iter().map(|(_, value)| value).sum::<f64>() >= 0.0;
                let is_first = middle == (corners[0].1 >= 0.0);
                if is_first { vec![[a, b], [c, d]] } else { vec![[d, a], [b, c]] }
            }
            _ => Vec::new(),
        }
    }
}

/// Pieces whose ends meet as one line.
fn join(mut pieces: Vec<[Point; 2]>) -> Vec<Vec<Point>> {
    let mut lines = Vec::new();
    while let Some([first, last]) = pieces.pop() {
        let mut line = std::collections::VecDeque::from([first, last]);
        loop {
            let (front, back) = (line[0], line[line.len() - 1]);
            let next = pieces.iter().position(|piece| {
                piece.contains(&back) || (piece.contains(&front) && front != back)
            });
            let Some(next) = next else { break };
            let [a, b] = pieces.swap_remove(next);
            match () {
                () if a == back => line.push_back(b),
                () if b == back => line.push_back(a),
                () if a == front => line.push_front(b),
                () => line.push_front(a),
            }
        }
        lines.push(line.into());
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(of: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>) {
        let axis: Vec<f64> = (0..=40).map(|index| -1.0 + 0.05 * f64::from(index)).collect();
        let values = axis.iter().flat_map(|y| axis.iter().map(|x| of(*x, *y))).collect();
        (axis, values)
    }

    fn contours(axis: &[f64], values: &[f64], level: f64) -> Vec<Vec<Point>> {
        Field { columns: axis, rows: axis, values }.contours(level)
    }

    #[test]
    fn a_circle_goes_round() {
        let (axis, values) = grid(|x, y| x * x + y * y);
        let lines = contours(&axis, &values, 0.5);
        let [line] = lines.as_slice() else { panic!("{} lines", lines.len()) };
        assert_eq!(line.first(), line.last());
        assert!(line.len() > 80);
        assert!(line.iter().all(|(x, y)| (x.hypot(*y) - 0.5f64.sqrt()).abs() < 1e-3));
    }

    #[test]
    fn branches_stay_apart_and_gaps_are_left() {
        let (axis, values) = grid(|x, y| x * y);
        assert_eq!(contours(&axis, &values, 0.0101).len(), 2);
        let (axis, values) = grid(|x, y| if x.abs() < 0.1 { f64::NAN } else { y });
        let lines = contours(&axis, &values, 0.01);
        assert_eq!(lines.len(), 2);
        assert!(lines.iter().flatten().all(|(x, y)| x.abs() > 0.09 && (y - 0.01).abs() < 1e-12));
        assert!(contours(&axis, &values, 3.0).is_empty());
    }
}
