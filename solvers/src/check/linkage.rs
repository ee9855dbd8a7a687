//! Derivatives of a linkage against dual numbers.

use super::Failed;
use super::resolve::resolved;
use crate::closure::{Assembly, Closure, Linkage, Variable};
use crate::dense::Lu;
use crate::problem::Storage;
use crate::scalar::Dual;

/// Largest residual of a loop, as a share of its largest coefficient.
const RESIDUAL: f64 = 1e-14;
/// Largest deviation of a derivative, as a share of the largest by the same variable.
const DEVIATION: f64 = 1e-10;
/// The same of a second derivative.
const SECOND: f64 = 1e-8;
/// What rounding leaves of a second derivative that is zero, as a part of the first one over the variable.
const ROUNDING: f64 = 1e-12;
/// Positions that are tried.
pub(super) const PLACES: usize = 7;

/// Checks at several positions that the loops are closed there, that the kinematic and influence coefficients are the
/// derivatives of positions and outputs, and that second derivatives are those of the first.
///
/// # Errors
/// The first value that deviates with what was expected, or why a position was not found.
pub fn closure<L: Linkage + Default>() -> Result<(), Failed> {
    let linkage = L::default();
    let mut assembly = Assembly::<L, f64>::new(&linkage);
    assembly
        .start()
        .map_err(|error| Failed(error.to_string()))?;
    for index in 0..PLACES {
        let place = place(&linkage, index)?;
        let (drivers, motion) = place.split_at(L::INDEPENDENTS);
        assembly
            .move_to(drivers)
            .map_err(|error| Failed(error.to_string()))?;
        Position::of(&linkage, &assembly, motion).check()?;
        resolved(&linkage, &assembly, motion)?;
    }
    Ok(())
}

/// A place in the range, or in the time of the task.
pub(super) fn place<L: Linkage>(linkage: &L, index: usize) -> Result<Vec<f64>, Failed> {
    let share = (index as f64 + 0.37) / PLACES as f64;
    if L::MOTION > 0 {
        let (from, to) = linkage.span().limits();
        let all = linkage.drive(from + (to - from) * share);
        return all.ok_or_else(|| Failed("the drivers do not move in time".into()));
    }
    let ranges = linkage.ranges();
    let at = |(k, range): (usize, &crate::closure::Range)| match range.from.is_finite() {
        true => range.from + (range.to - range.from) * (share + 0.618 * k as f64).fract(),
        false => range.start,
    };
    Ok(ranges.iter().enumerate().map(at).collect())
}

/// A position with everything that is differentiated there.
pub(super) struct Position<L: Linkage> {
    values: Vec<f64>,
    independents: Vec<f64>,
    motion: Vec<f64>,
    position: Vec<f64>,
    pub(super) influence: Vec<f64>,
    second: Vec<f64>,
    coefficients: Vec<Vec<f64>>,
    residual: Vec<f64>,
    linkage: std::marker::PhantomData<L>,
}

impl<L: Linkage> Position<L> {
    pub(super) fn of(linkage: &L, assembly: &Assembly<L, f64>, motion: &[f64]) -> Self {
        let closure = assembly.closure();
        let (independents, position) = (assembly.independents(), assembly.position());
        let instant = closure.moving(independents, motion);
        let variables = L::VARIABLES.len();
        let mut influence = vec![0.0; L::OUTPUTS * variables];
        closure.influence(&instant, position, &mut influence);
        let mut second =
            vec![0.0; usize::from(L::SECOND) * L::OUTPUTS * variables * (variables + 1) / 2];
        closure.second_influence(&instant, position, &mut second);
        let mut columns = vec![closure.zeros(); L::INDEPENDENTS];
        closure.coefficients(&instant, position, &mut columns);
        let mut residual = vec![0.0; L::DEPENDENTS];
        closure.residual(&instant, position, &mut residual);
        Self {
            values: linkage.values(),
            independents: independents.to_vec(),
            motion: motion.to_vec(),
            position: position.as_ref().to_vec(),
            influence,
            second,
            coefficients: columns
                .iter()
                .map(|column| column.as_ref()[..L::DEPENDENTS].to_vec())
                .collect(),
            residual,
            linkage: std::marker::PhantomData,
        }
    }

    fn check(&self) -> Result<(), Failed> {
        let mut slopes = Vec::new();
        for variable in L::VARIABLES {
            slopes.push(self.varied(*variable)?);
        }
        for driver in 0..L::INDEPENDENTS {
            let follow = self.varied(Variable::Driver(driver))?.dependents;
            compare(
                "kinematic coefficients",
                &self.coefficients[driver],
                &follow,
                DEVIATION,
                &self.independents,
            )?;
        }
        let count = L::VARIABLES.len();
        for (j, slope) in slopes.iter().enumerate() {
            let found: Vec<f64> = (0..L::OUTPUTS)
                .map(|i| self.influence[i * count + j])
                .collect();
            let what = format!("influence of {:?} on the outputs", L::VARIABLES[j]);
            compare(&what, &found, &slope.outputs, DEVIATION, &self.independents)?;
        }
        self.check_second(&slopes)
    }

    fn check_second(&self, slopes: &[Slopes]) -> Result<(), Failed> {
        let count = L::VARIABLES.len();
        let triangle = count * (count + 1) / 2;
        if !L::SECOND {
            return Ok(());
        }
        let expected = |output: usize, row: usize, column: usize| {
            slopes[column].influence[output * count + row]
        };
        let slope = |output: usize, row: usize| slopes[row].outputs[output].abs();
        for output in 0..L::OUTPUTS {
            for row in 0..count {
                for column in 0..=row {
                    let found = self.second[output * triangle + row * (row + 1) / 2 + column];
                    let wanted = expected(output, row, column);
                    let largest = |row: usize, column: usize| {
                        (0..L::OUTPUTS)
                            .map(|one| expected(one, row, column).abs())
                            .fold(0.0, f64::max)
                    };
                    let mean = (largest(row, row) * largest(column, column)).sqrt();
                    // One that is zero is found as the rounding of the slope that does not change.
                    let slope = slope(output, row);
                    let size = self.size(L::VARIABLES[column]);
                    let flat = if size > 0.0 { slope / size } else { 0.0 };
                    let scale = largest(row, column).max(mean);
                    if is_off(found, wanted, (SECOND * scale).max(ROUNDING * flat)) {
                        let (p, q) = (L::VARIABLES[row], L::VARIABLES[column]);
                        return Err(Failed(format!(
                            "second derivative of output {output} by {p:?} and {q:?} at {:?}: found {found}, expected {wanted}",
                            self.independents
                        )));
                    }
                }
            }
        }
        Ok(())
    }

    /// The absolute value of a variable.
    fn size(&self, variable: Variable) -> f64 {
        match variable {
            Variable::Constant(index) => self.values[index].abs(),
            Variable::Driver(index) => self.independents[index].abs(),
        }
    }

    /// How everything changes with one variable, by dual numbers: the loops are closed again in their derivatives.
    fn varied(&self, variable: Variable) -> Result<Slopes, Failed> {
        let dual = |list: &[f64], chosen: Option<usize>| -> Vec<Dual> {
            let one = |(index, value): (usize, &f64)| match Some(index) == chosen {
                true => Dual::variable(*value),
                false => Dual::constant(*value),
            };
            list.iter().enumerate().map(one).collect()
        };
        let (constant, driver) = match variable {
            Variable::Constant(index) => (Some(index), None),
            Variable::Driver(index) => (None, Some(index)),
        };
        let closure = L::prepare::<Dual>(&dual(&self.values, constant));
        let instant = closure.moving(&dual(&self.independents, driver), &dual(&self.motion, None));
        let mut position = closure.zeros();
        let entries = position.as_mut().iter_mut().zip(&self.position);
        entries.for_each(|(slot, value)| *slot = Dual::constant(*value));
        for group in 0..L::GROUPS.len() {
            self.close(&closure, group, &instant, &mut position)?;
        }
        let mut outputs = vec![Dual::default(); L::OUTPUTS];
        closure.outputs(&instant, &position, &mut outputs);
        let mut influence = vec![Dual::default(); self.influence.len()];
        closure.influence(&instant, &position, &mut influence);
        let slopes = |list: &[Dual]| list.iter().map(|one| one.slope).collect::<Vec<f64>>();
        Ok(Slopes {
            dependents: slopes(&position.as_ref()[..L::DEPENDENTS]),
            outputs: slopes(&outputs),
            influence: slopes(&influence),
        })
    }

    /// Gives the unknowns of a group the derivatives that keep its loops closed.
    fn close(
        &self,
        closure: &L::Closure<Dual>,
        group: usize,
        instant: &<L::Closure<Dual> as Closure<Dual>>::Instant,
        position: &mut <L::Closure<Dual> as Closure<Dual>>::Position,
    ) -> Result<(), Failed> {
        let unknowns = L::GROUPS[group].unknowns;
        let largest = L::GROUPS
            .iter()
            .map(|one| one.unknowns.len())
            .max()
            .unwrap_or(0);
        let mut residual = <L::Closure<Dual> as Closure<Dual>>::Row::zeros(largest);
        let mut jacobian = <L::Closure<Dual> as Closure<Dual>>::Matrix::zeros(largest * largest);
        closure.trial(group, instant, position, &mut residual, &mut jacobian);
        let count = unknowns.len();
        let entries: Vec<f64> = jacobian.as_ref()[..count * count]
            .iter()
            .map(|one| one.value)
            .collect();
        let scale = entries
            .iter()
            .fold(0.0_f64, |most, one| most.max(one.abs()));
        for (row, equation) in residual.as_ref()[..count]
            .iter()
            .zip(L::GROUPS[group].equations)
        {
            let (trial, own) = (row.value, self.residual[*equation]);
            if is_off(trial, 0.0, RESIDUAL * scale) || is_off(trial, own, RESIDUAL * scale) {
                return Err(Failed(format!(
                    "equation {equation} at {:?}: a residual of {trial:e} on trial and of {own:e} when asked for, expected 0",
                    self.independents
                )));
            }
        }
        let mut right: Vec<f64> = residual.as_ref()[..count]
            .iter()
            .map(|one| -one.slope)
            .collect();
        let factors =
            Lu::new(entries, count).map_err(|error| Failed(format!("group {group}: {error}")))?;
        factors.solve(&mut right);
        for (unknown, slope) in unknowns.iter().zip(right) {
            position.as_mut()[*unknown].slope = slope;
        }
        // Sines and cosines follow.
        closure.trial(group, instant, position, &mut residual, &mut jacobian);
        Ok(())
    }
}

/// Derivatives by one variable.
struct Slopes {
    dependents: Vec<f64>,
    outputs: Vec<f64>,
    influence: Vec<f64>,
}

/// Whether a value deviates; one that is no number does.
fn is_off(found: f64, expected: f64, tolerance: f64) -> bool {
    let deviation = (found - expected).abs();
    deviation.is_nan() || deviation > tolerance
}

pub(super) fn compare(
    what: &str,
    found: &[f64],
    expected: &[f64],
    share: f64,
    at: &[f64],
) -> Result<(), Failed> {
    let scale = expected
        .iter()
        .fold(0.0_f64, |most, one| most.max(one.abs()));
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        if is_off(*found, *expected, share * scale) {
            return Err(Failed(format!(
                "{what}, number {index}, at {at:?}: found {found}, expected {expected}"
            )));
        }
    }
    Ok(())
}
