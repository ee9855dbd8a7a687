//! Symmetric positive matrices that are zero far from the diagonal, but perhaps in their last rows: those of splines, closed
//! ones too.

/// The lower triangle, each row from its first number that is not zero to the diagonal.
pub struct Profile {
    first: Vec<usize>,
    rows: Vec<Vec<f64>>,
}

impl Profile {
    /// A matrix of zeros.
    pub fn new(size: usize) -> Self {
        Self { first: (0..size).collect(), rows: vec![vec![0.0]; size] }
    }

    /// Adds to an entry and to its mirror image.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (row, column) = (i.max(j), i.min(j));
        while self.first[row] > column {
            self.rows[row].insert(0, 0.0);
            self.first[row] -= 1;
        }
        self.rows[row][column - self.first[row]] += value;
    }

    /// The solution for a right-hand side, by `L·D·Lᵀ`.
    pub fn solve(mut self, mut right: Vec<f64>) -> Vec<f64> {
        let size = right.len();
        let mut pivots: Vec<f64> = Vec::with_capacity(size);
        for i in 0..size {
            let (earlier, rest) = self.rows.split_at_mut(i);
            let (row, first) = (&mut rest[0], self.first[i]);
            for j in first..i {
                let (other, begin) = (&earlier[j], self.first[j].max(first));
                let known: f64 =
                    (begin..j).map(|k| row[k - first] * other[k - self.first[j]]).sum();
                row[j - first] -= known;
            }
            let mut pivot = row[i - first];
            for j in first..i {
                let factor = row[j - first] / pivots[j];
                pivot -= factor * row[j - first];
                row[j - first] = factor;
                right[i] -= factor * right[j];
            }
            pivots.push(pivot);
        }
        for i in (0..size).rev() {
            right[i] = if i < pivots.len() { right[i] / pivots[i] } else { f64::NAN };
        }
        for i in (0..size).rev() {
            for j in self.first[i]..i {
                right[j] -= self.rows[i][j - self.first[i]] * right[i];
            }
        }
        right
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_closed_band_is_solved() {
        const N: usize = 7;
        let entry = |i: usize, j: usize| match (i + N - j) % N {
            0 => 4.0 + 0.1 * i as f64,
            1 | 6 => -1.0,
            2 | 5 => 0.25,
            _ => 0.0,
        };
        let mut matrix = Profile::new(N);
        for i in 0..N {
            (0..=i).filter(|j| entry(i, *j) != 0.0).for_each(|j| matrix.add(j, i, entry(i, j)));
        }
        let exact: Vec<f64> = (0..N).map(|i| (1.3 * i as f64).sin()).collect();
        let right = (0..N).map(|i| (0..N).map(|j| entry(i, j) * exact[j]).sum()).collect();
        for (found, exact) in matrix.solve(right).iter().zip(exact) {
            assert!((found - exact).abs() < 1e-14);
        }
    }
}
