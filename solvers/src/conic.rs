//! Conic programmes, solved by Clarabel (P. Goulart, Y. Chen: *Clarabel: an interior-point solver for conic programs with
//! quadratic objectives*, 2024, arXiv:2405.12762).

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};

/// Relative accuracy of a solution.
const ACCURACY: f64 = 1e-9;

/// Rows `A x + s = b` with `s` in a product of cones.
#[derive(Default)]
pub(crate) struct Rows {
    entries: (Vec<usize>, Vec<usize>, Vec<f64>),
    right: Vec<f64>,
    pub cones: Vec<SupportedConeT<f64>>,
}

impl Rows {
    /// Adds `s = constant + Σ coefficient x`.
    pub fn row(&mut self, constant: f64, coefficients: &[(usize, f64)]) {
        let row = self.right.len();
        for (column, coefficient) in coefficients {
            self.entries.0.push(row);
            self.entries.1.push(*column);
            self.entries.2.push(-coefficient);
        }
        self.right.push(constant);
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.right.len()
    }
}

/// Why there is no solution.
#[cfg_attr(not(feature = "allocation"), expect(dead_code))]
pub(crate) struct Stop {
    /// How the solver describes that.
    pub status: String,
    /// Iterations spent.
    pub iterations: u32,
}

/// The unknowns that make `½ xᵀ P x + c·x` least, and the multipliers of the rows. Of the symmetric matrix `P` those
/// entries are given, row, column and value, that stand on its diagonal or above.
pub(crate) fn minimise(
    linear: &[f64],
    quadratic: &[(usize, usize, f64)],
    rows: Rows,
) -> Result<(Vec<f64>, Vec<f64>), Stop> {
    let (m, n) = (rows.right.len(), linear.len());
    let (i, j, v) = rows.entries;
    let matrix = CscMatrix::new_from_triplets(m, n, i, j, v);
    let part = |take: fn(&(usize, usize, f64)) -> usize| quadratic.iter().map(take).collect();
    let values = quadratic.iter().map(|entry| entry.2).collect();
    let quadratic =
        CscMatrix::new_from_triplets(n, n, part(|entry| entry.0), part(|entry| entry.1), values);
    let settings = DefaultSettings {
        verbose: false,
        max_threads: 1,
        tol_gap_abs: ACCURACY,
        tol_gap_rel: ACCURACY,
        tol_feas: ACCURACY,
        ..DefaultSettings::default()
    };
    let mut solver =
        DefaultSolver::new(&quadratic, linear, &matrix, &rows.right, &rows.cones, settings);
    solver.solve();
    let solution = solver.solution;
    match solution.status {
        SolverStatus::Solved | SolverStatus::AlmostSolved => Ok((solution.x, solution.z)),
        status => Err(Stop { status: format!("{status:?}"), iterations: solution.iterations }),
    }
}
