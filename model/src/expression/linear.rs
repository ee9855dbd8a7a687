//! Linear systems on numbers.

/// What kind of matrix is factored, and so which of its entries are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Form {
    /// Symmetric and positive: the lower triangle, row by row.
    Symmetric,
    /// Any with an inverse: all entries, row by row. It is factored with pivoting.
    General,
}

impl Form {
    /// Where an entry of a matrix with so many rows stands among those given.
    pub fn place(self, size: usize, row: usize, column: usize) -> usize {
        match self {
            Self::Symmetric => {
                let (row, column) = (row.max(column), row.min(column));
                row * (row + 1) / 2 + column
            }
            Self::General => row * size + column,
        }
    }
}

/// Solves a linear system.
pub fn solve(form: Form, entries: &[f64], right: &[f64]) -> Vec<f64> {
    match form {
        Form::Symmetric => solve_symmetric(right.len(), entries, right),
        Form::General => solve_general(entries, right),
    }
}

/// Solves a system with all entries given row by row, by elimination with partial pivoting.
fn solve_general(entries: &[f64], right: &[f64]) -> Vec<f64> {
    let size = right.len();
    let mut rows: Vec<Vec<f64>> = entries.chunks(size).map(<[f64]>::to_vec).collect();
    let mut solution = right.to_vec();
    for column in 0..size {
        let larger = |a: &usize, b: &usize| rows[*a][column].abs() < rows[*b][column].abs();
        let best = (column..size).fold(column, |best, row| match larger(&best, &row) {
            true => row,
            false => best,
        });
        rows.swap(column, best);
        solution.swap(column, best);
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for (row, other) in below.iter_mut().enumerate() {
            let multiple = other[column] / pivot[column];
            for (entry, above) in other.iter_mut().zip(pivot) {
                *entry -= multiple * above;
            }
            solution[column + 1 + row] -= multiple * solution[column];
        }
    }
    for row in (0..size).rev() {
        for column in row + 1..size {
            solution[row] -= rows[row][column] * solution[column];
        }
        solution[row] /= rows[row][row];
    }
    solution
}

/// Solves a symmetric system, given by its lower triangle row by row, by `L·D·Lᵀ`.
fn solve_symmetric(size: usize, lower: &[f64], right: &[f64]) -> Vec<f64> {
    let at = |row: usize, column: usize| row * (row + 1) / 2 + column;
    let mut factor = lower.to_vec();
    for row in 0..size {
        for column in 0..=row {
            let mut value = factor[at(row, column)];
            for k in 0..column {
                value -= factor[at(row, k)] * factor[at(column, k)] * factor[at(k, k)];
            }
            factor[at(row, column)] =
                if row == column { value } else { value / factor[at(column, column)] };
        }
    }
    let mut solution = right.to_vec();
    for row in 0..size {
        for column in 0..row {
            solution[row] -= factor[at(row, column)] * solution[column];
        }
    }
    for row in (0..size).rev() {
        solution[row] /= factor[at(row, row)];
        for below in row + 1..size {
            solution[row] -= factor[at(below, row)] * solution[below];
        }
    }
    solution
}
