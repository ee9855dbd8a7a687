//! Derived Jacobians against dual numbers.

use super::{Failed, places, rates};
use assur_solvers::problem::{Equations, Phase, Scene};
use assur_solvers::scalar::{Dual, Scalar};
use assur_solvers::shape::Shape;

/// Largest deviation of an entry, as a share of its row.
const DEVIATION: f64 = 1e-9;
/// Derivatives of which only rounding is left differ by so many times what is seen of it.
const ROUNDINGS: f64 = 8.0;
/// Largest deviation between two ways to the same value, as a share of it.
const ROUNDING: f64 = 1e-12;

/// Checks at several times and states that in each mode the Jacobian and the variation of a scene are the derivatives of
/// its equations, and that all functions of the equations agree on the derivative of the state.
///
/// # Errors
/// The first entry that deviates, with both values; or that no state was found at which all are finite.
pub fn jacobian<C: Scene>(scene: &C) -> Result<(), Failed> {
    let (plain, dual) = (scene.prepare::<f64>(), scene.prepare::<Dual>());
    for mode in 0..scene.shape().modes.len().max(1) {
        let point = Point {
            plain: &plain,
            dual: &dual,
            shape: scene.shape(),
            mode,
            from: scene.span().limits().0,
        };
        let mut finite = 0;
        for (time, values) in places(scene) {
            finite += usize::from(point.check(time, &values)?);
        }
        if finite == 0 {
            return Err(Failed(format!(
                "the derivative is not finite at any state near the start{}",
                point.in_mode()
            )));
        }
    }
    Ok(())
}

/// A scene in a mode, on both kinds of numbers.
struct Point<'a> {
    shape: &'a Shape,
    mode: usize,
    /// A time of the task.
    from: f64,
    plain: &'a dyn Equations<f64>,
    dual: &'a dyn Equations<Dual>,
}

impl Point<'_> {
    /// Checks one time and state; false if the derivative is not finite there.
    fn check(&self, time: f64, here: &[f64]) -> Result<bool, Failed> {
        let (shape, states) = (self.shape, here.len());
        let place = format!("time {time} s, state {here:?}{}", self.in_mode());
        let (rate, instant) = rates(self.plain, self.mode, time, here);
        if !rate.iter().all(|value| value.is_finite()) {
            return Ok(false);
        }
        let mut slopes = vec![0.0; states * states];
        let phase = Phase::of(self.mode);
        self.plain.jacobian(phase, &instant, here, &mut slopes);
        let expected: Vec<Vec<Dual>> =
            (0..states).map(|column| self.dual_rate(time, here, column)).collect();
        for column in 0..states {
            for row in 0..states {
                let (found, wanted) = (slopes[column * states + row], expected[column][row].slope);
                let mut permitted = DEVIATION * self.row(&expected, row, column);
                if (found - wanted).abs() > permitted {
                    permitted += self.rounding(time, here, (row, column), wanted);
                }
                near(found, wanted, permitted, || {
                    let (of, to) = (shape.states[row].name, shape.states[column].name);
                    format!("Jacobian, rate of {of} with respect to {to}, at {place}")
                })?;
            }
        }
        let (varied, products) = self.variation(&instant, here, &slopes);
        let duals = expected.first().map_or(&[][..], Vec::as_slice);
        let again = self.several(time, here);
        for row in 0..states {
            let (wanted, name) = (rate[row], shape.states[row].name);
            for (found, way, share) in [
                (varied[row], "variation", ROUNDING),
                (duals[row].value, "dual numbers", DEVIATION),
                (again[row], "several instants", ROUNDING),
            ] {
                near(found, wanted, share * wanted.abs(), || {
                    format!("rate of {name} by {way}, at {place}")
                })?;
            }
            for (found, wanted) in &products[row] {
                let entries = (0..states).map(|column| slopes[column * states + row].abs());
                near(*found, *wanted, ROUNDING * entries.sum::<f64>(), || {
                    format!("product of the Jacobian in the row of {name}, at {place}")
                })?;
            }
        }
        Ok(true)
    }

    /// ` in the mode …`, where there are several.
    fn in_mode(&self) -> String {
        match self.shape.modes.get(self.mode) {
            Some(mode) if self.shape.modes.len() > 1 => format!(" in the mode {}", mode.name),
            _ => String::new(),
        }
    }

    /// The derivative of the state on dual numbers along one component.
    fn dual_rate(&self, time: f64, here: &[f64], column: usize) -> Vec<Dual> {
        let varied = here.iter().enumerate().map(|(index, value)| Dual {
            value: *value,
            slope: if index == column { 1.0 } else { 0.0 },
        });
        let here: Vec<Dual> = varied.collect();
        rates(self.dual, self.mode, Dual::from_f64(time), &here).0
    }

    /// What rounding makes of a slope in which all else vanishes, as where springs balance weights: it differs from those
    /// a few roundings beside the state.
    fn rounding(&self, time: f64, here: &[f64], (row, column): (usize, usize), slope: f64) -> f64 {
        let beside = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|share| {
            let aside = here.iter().map(|value| value * (1.0 + share * f64::EPSILON));
            let aside: Vec<f64> = aside.collect();
            (self.dual_rate(time, &aside, column)[row].slope - slope).abs()
        });
        ROUNDINGS * beside.into_iter().fold(0.0, f64::max)
    }

    /// The size of an entry, or of the largest of its row as far as the state's scales make them comparable.
    fn row(&self, slopes: &[Vec<Dual>], row: usize, column: usize) -> f64 {
        let scales = self.shape.scales;
        let sized = |other: usize| slopes[other][row].slope.abs() * scales[other];
        let largest = (0..scales.len()).map(sized).fold(0.0, f64::max);
        largest / scales[column]
    }

    /// The derivative as the variation gives it, and for each row the products with columns beside the expected ones.
    fn variation(
        &self,
        instant: &[f64],
        here: &[f64],
        slopes: &[f64],
    ) -> (Vec<f64>, Vec<Vec<(f64, f64)>>) {
        let states = here.len();
        // The unit columns, and after the last a mixture of all.
        let entry = |place: usize| match (place % states, place / states) {
            (row, column) if column == states => 1.0 / (1.0 + row as f64),
            (row, column) => f64::from(u8::from(row == column)),
        };
        let columns: Vec<f64> = (0..states * (1 + states)).map(entry).collect();
        let (mut rate, mut products) = (vec![0.0; states], columns.clone());
        let phase = Phase::of(self.mode);
        self.plain.variation(phase, instant, here, &mut rate, &columns, &mut products);
        let expected = |row: usize, column: usize| -> f64 {
            let terms = (0..states)
                .map(|other| slopes[other * states + row] * columns[column * states + other]);
            terms.sum()
        };
        let pair =
            |row: usize, column: usize| (products[column * states + row], expected(row, column));
        let rows = (0..states).map(|row| (0..=states).map(|column| pair(row, column)).collect());
        (rate, rows.collect())
    }

    /// The derivative of the state with the second of two instants that are computed together.
    fn several(&self, time: f64, here: &[f64]) -> Vec<f64> {
        let (phase, count) = (Phase::of(self.mode), self.plain.instant());
        let mut rows = vec![0.0; 2 * count];
        self.plain.instants(phase, &[self.from, time], &mut rows);
        let mut rate = vec![0.0; here.len()];
        self.plain.rates(phase, &rows[count..], here, &mut rate);
        rate
    }
}

fn near(found: f64, wanted: f64, tolerance: f64, place: impl Fn() -> String) -> Result<(), Failed> {
    if (found - wanted).abs() <= tolerance || !found.is_finite() && !wanted.is_finite() {
        return Ok(());
    }
    Err(Failed(format!("{}: found {found:e}, expected {wanted:e} to {tolerance:e}", place())))
}
