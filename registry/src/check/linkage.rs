//! Derivatives of a linkage against dual numbers.

use super::Failed;
use super::resolve::resolved;
use assur_solvers::closure::{Answers, AnyLinkage, Guide, Square, Variable};
use assur_solvers::dense::Lu;
use assur_solvers::scalar::Dual;
use assur_solvers::shape::LinkageEntry;

/// Largest residual of a loop, as a share of its largest coefficient.
const RESIDUAL: f64 = 1e-14;
/// Largest deviation of a derivative, as a share of the largest by the same variable.
const DEVIATION: f64 = 1e-10;
/// Largest deviation of a second derivative.
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
pub fn closure(linkage: &dyn AnyLinkage) -> Result<(), Failed> {
    let mut assembly = linkage.assemble();
    let started = assembly.guide().start();
    started.map_err(|error| Failed(error.to_string()))?;
    for index in 0..PLACES {
        let place = place(linkage, index)?;
        let (drivers, motion) = place.split_at(linkage.shape().drivers.len());
        assembly.move_to(drivers).map_err(|error| Failed(error.to_string()))?;
        let here = Position::of(linkage, &assembly.guide(), motion);
        here.check()?;
        resolved(linkage, &here)?;
    }
    Ok(())
}

/// A place in the range, or in the time of the task.
pub(super) fn place(linkage: &dyn AnyLinkage, index: usize) -> Result<Vec<f64>, Failed> {
    let share = (index as f64 + 0.37) / PLACES as f64;
    if linkage.shape().loops().motion > 0 {
        let (from, to) = linkage.span().limits();
        let all = linkage.drive(from + (to - from) * share);
        return all.ok_or_else(|| Failed("the drivers do not move in time".into()));
    }
    let ranges = linkage.ranges();
    let at = |(k, range): (usize, &assur_solvers::closure::Range)| match range.from.is_finite() {
        true => range.from + (range.to - range.from) * (share + 0.618 * k as f64).fract(),
        false => range.start,
    };
    Ok(ranges.iter().enumerate().map(at).collect())
}

/// A position with everything that is differentiated there.
pub(super) struct Position<'a> {
    linkage: &'a dyn AnyLinkage,
    entry: &'static LinkageEntry,
    values: Vec<f64>,
    pub(super) independents: Vec<f64>,
    pub(super) motion: Vec<f64>,
    pub(super) position: Vec<f64>,
    pub(super) influence: Vec<f64>,
    second: Vec<f64>,
    /// The outputs themselves.
    pub(super) reported: Vec<f64>,
    /// The columns of the drivers, one behind the other.
    coefficients: Vec<f64>,
    residual: Vec<f64>,
}

impl<'a> Position<'a> {
    pub(super) fn of(linkage: &'a dyn AnyLinkage, guide: &Guide<'_, f64>, motion: &[f64]) -> Self {
        let (loops, entry) = (guide.loops, linkage.shape().loops());
        let (independents, position) = (guide.independents.to_vec(), guide.position.to_vec());
        let instant = loops.instant_row(&independents, motion);
        let (outputs, variables) = (linkage.shape().outputs.len(), entry.variables.len());
        let mut influence = vec![0.0; outputs * variables];
        loops.influence(&instant, &position, &mut influence);
        let mut reported = vec![0.0; outputs];
        loops.outputs(&instant, &position, &mut reported);
        let triangle = variables * (variables + 1) / 2;
        let mut second = vec![0.0; usize::from(entry.second) * outputs * triangle];
        loops.second_influence(&instant, &position, &mut second);
        let dependents = entry.dependents.len();
        let mut coefficients = vec![0.0; independents.len() * dependents];
        loops.coefficients(&instant, &position, &mut coefficients);
        let mut residual = vec![0.0; dependents];
        loops.residual(&instant, &position, &mut residual);
        Self {
            linkage,
            entry,
            values: linkage.values(),
            independents,
            motion: motion.to_vec(),
            position,
            influence,
            second,
            reported,
            coefficients,
            residual,
        }
    }

    /// Number of outputs.
    pub(super) fn outputs(&self) -> usize {
        self.linkage.shape().outputs.len()
    }

    fn check(&self) -> Result<(), Failed> {
        let mut slopes = Vec::new();
        for variable in self.entry.variables {
            slopes.push(self.varied(*variable)?);
        }
        let dependents = self.entry.dependents.len();
        for driver in 0..self.independents.len() {
            let follow = self.varied(Variable::Driver(driver))?.dependents;
            compare(
                "kinematic coefficients",
                &self.coefficients[driver * dependents..][..dependents],
                &follow,
                (DEVIATION, &[]),
                &self.independents,
            )?;
        }
        let count = self.entry.variables.len();
        for (j, slope) in slopes.iter().enumerate() {
            let found: Vec<f64> =
                (0..self.outputs()).map(|i| self.influence[i * count + j]).collect();
            let what = format!("influence of {:?} on the outputs", self.entry.variables[j]);
            let floors = self.floors(ROUNDING * self.size(self.entry.variables[j]).recip());
            compare(&what, &found, &slope.outputs, (DEVIATION, &floors), &self.independents)?;
        }
        self.check_second(&slopes)
    }

    fn check_second(&self, slopes: &[Slopes]) -> Result<(), Failed> {
        let count = self.entry.variables.len();
        let triangle = count * (count + 1) / 2;
        if !self.entry.second {
            return Ok(());
        }
        let expected = |output: usize, row: usize, column: usize| {
            slopes[column].influence[output * count + row]
        };
        let slope = |output: usize, row: usize| slopes[row].outputs[output].abs();
        for output in 0..self.outputs() {
            let level = self.level(output);
            for row in 0..count {
                for column in 0..=row {
                    let found = self.second[output * triangle + row * (row + 1) / 2 + column];
                    let wanted = expected(output, row, column);
                    let largest = |row: usize, column: usize| {
                        (0..self.outputs())
                            .map(|one| expected(one, row, column).abs())
                            .fold(0.0, f64::max)
                    };
                    let mean = (largest(row, row) * largest(column, column)).sqrt();
                    // One that is zero is found as the rounding of the slope that does not change.
                    let slope = slope(output, row);
                    let size = self.size(self.entry.variables[column]);
                    let flat = if size > 0.0 { slope / size } else { 0.0 };
                    let area = size * self.size(self.entry.variables[row]);
                    let flat = if area > 0.0 { flat.max(level / area) } else { flat };
                    let scale = largest(row, column).max(mean);
                    if is_off(found, wanted, (SECOND * scale).max(ROUNDING * flat)) {
                        let (p, q) = (self.entry.variables[row], self.entry.variables[column]);
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

    /// The largest output of the same dimension: one that is nothing may be the difference of such.
    fn level(&self, output: usize) -> f64 {
        let outputs = self.linkage.shape().outputs;
        let alike = outputs.iter().map(|one| one.dimension == outputs[output].dimension);
        let values = self.reported.iter().zip(alike).filter(|(_, is_alike)| *is_alike);
        values.fold(0.0, |most, (value, _)| f64::max(most, value.abs()))
    }

    /// What rounding may leave of the change of each output, over the change of a variable: so many times the output.
    pub(super) fn floors(&self, share: f64) -> Vec<f64> {
        let share = if share.is_finite() { share } else { 0.0 };
        self.reported.iter().map(|value| share * value.abs()).collect()
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
        let loops = self.linkage.differentiate(&dual(&self.values, constant));
        let independents = dual(&self.independents, driver);
        let instant = loops.instant_row(&independents, &dual(&self.motion, None));
        let mut position = dual(&self.position, None);
        for group in 0..self.entry.groups.len() {
            self.close(&*loops, group, &instant, &mut position)?;
        }
        let mut outputs = vec![Dual::default(); self.outputs()];
        loops.outputs(&instant, &position, &mut outputs);
        let mut influence = vec![Dual::default(); self.influence.len()];
        loops.influence(&instant, &position, &mut influence);
        let slopes = |list: &[Dual]| list.iter().map(|one| one.slope).collect::<Vec<f64>>();
        Ok(Slopes {
            dependents: slopes(&position[..self.entry.dependents.len()]),
            outputs: slopes(&outputs),
            influence: slopes(&influence),
        })
    }

    /// Gives the unknowns of a group the derivatives that keep its loops closed.
    fn close(
        &self,
        loops: &dyn Answers<Dual>,
        group: usize,
        instant: &[Dual],
        position: &mut [Dual],
    ) -> Result<(), Failed> {
        let unknowns = self.entry.groups[group].unknowns;
        let mut square = Square::of(loops.shape());
        square.look(loops, group, instant, position);
        let count = unknowns.len();
        let entries: Vec<f64> =
            square.jacobian[..count * count].iter().map(|one| one.value).collect();
        let scale = entries.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
        for (row, equation) in
            square.residual[..count].iter().zip(self.entry.groups[group].equations)
        {
            let (trial, own) = (row.value, self.residual[*equation]);
            if is_off(trial, 0.0, RESIDUAL * scale) || is_off(trial, own, RESIDUAL * scale) {
                return Err(Failed(format!(
                    "equation {equation} at {:?}: a residual of {trial:e} on trial and of {own:e} when asked for, expected 0",
                    self.independents
                )));
            }
        }
        let mut right: Vec<f64> = square.residual[..count].iter().map(|one| -one.slope).collect();
        let factors =
            Lu::new(entries, count).map_err(|error| Failed(format!("group {group}: {error}")))?;
        factors.solve(&mut right);
        for (unknown, slope) in unknowns.iter().zip(right) {
            position[*unknown].slope = slope;
        }
        // Sines and cosines follow.
        square.look(loops, group, instant, position);
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
    (share, floors): (f64, &[f64]),
    at: &[f64],
) -> Result<(), Failed> {
    let scale = expected.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let floor = floors.get(index).copied().unwrap_or(0.0);
        if is_off(*found, *expected, (share * scale).max(floor)) {
            return Err(Failed(format!(
                "{what}, number {index}, at {at:?}: found {found}, expected {expected}"
            )));
        }
    }
    Ok(())
}
