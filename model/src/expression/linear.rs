//! Linear systems on numbers.

/// What kind of matrix is factored, and so which of its entries are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Form {
    /// Symmetric and positive: the lower triangle, row by row.
    Symmetric,
    /// Any with an inverse: all entries, row by row. It is factored with pivoting.
    General,
    /// `[A Jᵀ; J 0]`, symmetric: the lower triangle, row by row. So many unknowns have masses `A` and are bound by closures
    /// `J`, of which at most a number are independent. Behind them stand as many rows that say what the closures do not where
    /// these depend on each other for an instant; they count only then.
    Bound {
        /// Rows of `A`.
        unknowns: u32,
        /// Most independent rows of `J`.
        rank: u32,
    },
}

impl Form {
    /// Where an entry of a matrix with so many rows stands among those given.
    pub fn place(self, size: usize, row: usize, column: usize) -> usize {
        match self {
            Self::Symmetric | Self::Bound { .. } => {
                let (row, column) = (row.max(column), row.min(column));
                row * (row + 1) / 2 + column
            }
            Self::General => row * size + column,
        }
    }
}

/// Solves a linear system.
pub fn solve(form: Form, entries: &[f64], right: &[f64]) -> Vec<f64> {
    let size = right.len();
    match form {
        Form::Symmetric => solve_symmetric(size, entries, right),
        Form::General => solve_pivoted(form, entries, right, size),
        Form::Bound { unknowns, rank } => {
            let (n, rank) = (unknowns as usize, rank as usize);
            let lasting = n + (size - n) / 2;
            let mut solution = solve_pivoted(form, entries, &right[..lasting], n + rank);
            solution.resize(size, 0.0);
            solution
        }
    }
}

/// Solves a system by elimination with complete pivoting, up to a rank: what is left of the unknowns is zero.
fn solve_pivoted(form: Form, entries: &[f64], right: &[f64], rank: usize) -> Vec<f64> {
    let size = right.len();
    let row = |row: usize| (0..size).map(|column| entries[form.place(size, row, column)]).collect();
    let mut rows: Vec<Vec<f64>> = (0..size).map(row).collect();
    let mut rest = right.to_vec();
    let mut columns: Vec<usize> = (0..size).collect();
    for at in 0..rank {
        let places = (at..size).flat_map(|row| (at..size).map(move |column| (row, column)));
        let larger =
            |a: &(usize, usize), b: &(usize, usize)| rows[a.0][a.1].abs() < rows[b.0][b.1].abs();
        let best =
            places.fold((at, at), |best, place| if larger(&best, &place) { place } else { best });
        rows.swap(at, best.0);
        rest.swap(at, best.0);
        columns.swap(at, best.1);
        rows.iter_mut().for_each(|row| row.swap(at, best.1));
        let (above, below) = rows.split_at_mut(at + 1);
        let pivot = &above[at];
        for (row, other) in below.iter_mut().enumerate() {
            let multiple = other[at] / pivot[at];
            for (entry, above) in other.iter_mut().zip(pivot) {
                *entry -= multiple * above;
            }
            rest[at + 1 + row] -= multiple * rest[at];
        }
    }
    let mut solution = vec![0.0; size];
    for row in (0..rank).rev() {
        let known = row + 1..rank;
        let sum: f64 = known.map(|column| rows[row][column] * solution[columns[column]]).sum();
        solution[columns[row]] = (rest[row] - sum) / rows[row][row];
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
