//! A program on numbers: what the emitted Rust computes, without compiling it.

use super::{Form, Function, Input, OperationKind, Program, Relation, Value};

/// Values of all operations at one instant and state.
#[derive(Clone, Debug)]
pub struct Values {
    numbers: Vec<f64>,
}

/// Where a linkage is evaluated.
#[derive(Clone, Copy, Debug, Default)]
pub struct Place<'a> {
    /// Positions of the drivers, and their speeds and accelerations where these are given.
    pub drivers: &'a [f64],
    /// Dependent coordinates, then cosines and sines of those that are angles.
    pub position: &'a [f64],
    /// Assembly modes of the groups.
    pub modes: &'a [f64],
}

impl Values {
    /// The value of an operation; conditions are 1 or 0.
    pub fn get(&self, value: Value) -> f64 {
        self.numbers[value.0 as usize]
    }

    /// The values of several.
    pub fn all(&self, values: &[Value]) -> Vec<f64> {
        values.iter().map(|value| self.get(*value)).collect()
    }
}

impl Program {
    /// Evaluates all operations. Shapes: `parameters`, `states`; inputs that are missing are NaN.
    pub fn evaluate(&self, parameters: &[f64], time: f64, state: &[f64]) -> Values {
        self.evaluate_all(parameters, time, state, &Place::default())
    }

    /// Evaluates all operations of a linkage at a place.
    pub fn evaluate_linkage(&self, parameters: &[f64], time: f64, linkage: &Place<'_>) -> Values {
        self.evaluate_all(parameters, time, &[], linkage)
    }

    fn evaluate_all(
        &self,
        parameters: &[f64],
        time: f64,
        state: &[f64],
        linkage: &Place<'_>,
    ) -> Values {
        let given =
            |list: &[f64], index: u32| list.get(index as usize).copied().unwrap_or(f64::NAN);
        let mut numbers: Vec<f64> = Vec::with_capacity(self.operations.len());
        let mut solutions: std::collections::HashMap<u32, Vec<f64>> =
            std::collections::HashMap::new();
        for (index, operation) in self.operations.iter().enumerate() {
            let at = |value: &Value| numbers[value.0 as usize];
            let truth = |held: bool| if held { 1.0 } else { 0.0 };
            let number = match &operation.kind {
                OperationKind::Number(number) => *number,
                OperationKind::Input(Input::Parameter(index)) => given(parameters, *index),
                OperationKind::Input(Input::State(index)) => given(state, *index),
                OperationKind::Input(Input::Time) => time,
                OperationKind::Input(Input::Driver(index)) => given(linkage.drivers, *index),
                OperationKind::Input(Input::Position(index)) => given(linkage.position, *index),
                OperationKind::Input(Input::Mode(index)) => given(linkage.modes, *index),
                OperationKind::Input(Input::Side(_)) => 0.0,
                OperationKind::Input(Input::Measured(_)) => f64::NAN,
                OperationKind::Add(a, b) => at(a) + at(b),
                OperationKind::Subtract(a, b) => at(a) - at(b),
                OperationKind::Multiply(a, b) => at(a) * at(b),
                OperationKind::Divide(a, b) => at(a) / at(b),
                OperationKind::Negate(a) => -at(a),
                OperationKind::MultiplyAdd(a, b, c) => at(a) * at(b) + at(c),
                OperationKind::MultiplySubtract(a, b, c) => at(a) * at(b) - at(c),
                OperationKind::NegateMultiplyAdd(a, b, c) => at(c) - at(a) * at(b),
                OperationKind::Call(function, list) => {
                    function.apply(&list.iter().map(at).collect::<Vec<_>>())
                }
                OperationKind::Compare(Relation::Less, a, b) => truth(at(a) < at(b)),
                OperationKind::Compare(Relation::LessEqual, a, b) => truth(at(a) <= at(b)),
                OperationKind::Compare(Relation::Equal, a, b) => truth(at(a) == at(b)),
                OperationKind::And(a, b) => truth(at(a) != 0.0 && at(b) != 0.0),
                OperationKind::Or(a, b) => truth(at(a) != 0.0 || at(b) != 0.0),
                OperationKind::Not(a) => truth(at(a) == 0.0),
                OperationKind::Select {
                    condition,
                    then,
                    otherwise,
                } => {
                    if at(condition) != 0.0 {
                        at(then)
                    } else {
                        at(otherwise)
                    }
                }
                OperationKind::Factor { .. } => f64::NAN,
                OperationKind::Solve { factor, right } => {
                    if let OperationKind::Factor { form, entries, .. } =
                        &self.operations[factor.0 as usize].kind
                    {
                        let entries: Vec<f64> = entries.iter().map(at).collect();
                        let right: Vec<f64> = right.iter().map(at).collect();
                        solutions.insert(index as u32, solve(*form, &entries, &right));
                    }
                    f64::NAN
                }
                OperationKind::Element { solution, index } => solutions
                    .get(&solution.0)
                    .and_then(|list| list.get(*index as usize))
                    .copied()
                    .unwrap_or(f64::NAN),
            };
            numbers.push(number);
        }
        Values { numbers }
    }
}

/// Solves a linear system.
pub(crate) fn solve(form: Form, entries: &[f64], right: &[f64]) -> Vec<f64> {
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
            factor[at(row, column)] = if row == column {
                value
            } else {
                value / factor[at(column, column)]
            };
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

impl Function {
    /// The value of a function of one or two numbers.
    pub fn apply(self, x: &[f64]) -> f64 {
        let second = || x.get(1).copied().unwrap_or(f64::NAN);
        let Some(first) = x.first().copied() else {
            return f64::NAN;
        };
        match self {
            Self::Sin => first.sin(),
            Self::Cos => first.cos(),
            Self::Tan => first.tan(),
            Self::Asin => first.asin(),
            Self::Acos => first.acos(),
            Self::Atan => first.atan(),
            Self::Atan2 => first.atan2(second()),
            Self::Sinh => first.sinh(),
            Self::Cosh => first.cosh(),
            Self::Tanh => first.tanh(),
            Self::Exp => first.exp(),
            Self::Ln => first.ln(),
            Self::Log10 => first.log10(),
            Self::Sqrt => first.sqrt(),
            Self::Hypot => first.hypot(second()),
            Self::Erf => error_function(first),
            Self::NormalCdf => normal(first),
            Self::Floor => first.floor(),
            Self::Abs => first.abs(),
            Self::Sign => f64::from(i8::from(first > 0.0) - i8::from(first < 0.0)),
            Self::Max => {
                if first < second() {
                    second()
                } else {
                    first
                }
            }
            Self::Min => {
                if second() < first {
                    second()
                } else {
                    first
                }
            }
            Self::Power => first.powf(second()),
            Self::ExpM1 => first.exp_m1(),
            Self::Ln1p => first.ln_1p(),
        }
    }
}

/// The error function: its series, and for larger arguments Lentz's continued fraction of the complement.
fn error_function(x: f64) -> f64 {
    if x.is_nan() || x.abs() > 6.0 {
        return if x.is_nan() { x } else { x.signum() };
    }
    if x.abs() > 2.0 {
        return x.signum() * (1.0 - complement(x.abs()));
    }
    let (mut term, mut sum) = (x, x);
    for k in 1..200 {
        let k = f64::from(k);
        term *= -x * x / k;
        let share = term / (2.0 * k + 1.0);
        sum += share;
        if share.abs() <= 1e-17 * sum.abs() {
            break;
        }
    }
    sum * std::f64::consts::FRAC_2_SQRT_PI
}

/// `1 - erf(x)` for `x > 2`.
fn complement(x: f64) -> f64 {
    // erfc(x) = exp(-x²)/√π · 1/(x + (1/2)/(x + 1/(x + (3/2)/(x + …))))
    let mut fraction = 0.0;
    for k in (1..=200).rev() {
        fraction = f64::from(k) / 2.0 / (x + fraction);
    }
    (-x * x).exp() * std::f64::consts::FRAC_2_SQRT_PI / 2.0 / (x + fraction)
}

/// The normal distribution, accurate in its lower tail.
fn normal(x: f64) -> f64 {
    let scaled = -x * std::f64::consts::FRAC_1_SQRT_2;
    if scaled > 2.0 {
        complement(scaled) / 2.0
    } else {
        (1.0 - error_function(scaled)) / 2.0
    }
}
