//! Derived Jacobians against dual numbers.

use super::{Failed, State, places, state};
use crate::problem::{Equations, Scene, Storage};
use crate::scalar::{Dual, Scalar};

/// Largest deviation of an entry, as a share of its row.
const DEVIATION: f64 = 1e-9;
/// Largest deviation between two ways to the same value, as a share of it.
const ROUNDING: f64 = 1e-12;

/// The state of a scene on dual numbers.
type DualState<C> = <<C as Scene>::Equations<Dual> as Equations<Dual>>::State;

/// Checks at several times and states that the Jacobian and the variation of a scene are the derivatives of its
/// equations, and that all functions of the equations agree on the derivative of the state.
///
/// # Errors
/// The first entry that deviates, with both values; or that no state was found at which all are finite.
pub fn jacobian<C: Scene + Default>() -> Result<(), Failed> {
    let scene = C::default();
    let point = Point {
        plain: scene.prepare::<f64>(),
        dual: scene.prepare::<Dual>(),
        scene: &scene,
    };
    let mut finite = 0;
    for (time, values) in places(&scene) {
        finite += usize::from(point.check(time, &values)?);
    }
    match finite {
        0 => Err(Failed(
            "the derivative is not finite at any state near the start".into(),
        )),
        _ => Ok(()),
    }
}

/// A scene on both kinds of numbers.
struct Point<'a, C: Scene> {
    scene: &'a C,
    plain: C::Equations<f64>,
    dual: C::Equations<Dual>,
}

impl<C: Scene> Point<'_, C> {
    /// Checks one time and state; false if the derivative is not finite there.
    fn check(&self, time: f64, values: &[f64]) -> Result<bool, Failed> {
        let place = format!("time {time} s, state {values:?}");
        let here = state::<C>(values);
        let zeros = || State::<C>::zeros(C::shape().states.len());
        let mut rate = zeros();
        let instant = self.plain.instant(time);
        self.plain.derivative(&instant, &here, &mut rate);
        if !rate.as_ref().iter().all(|value| value.is_finite()) {
            return Ok(false);
        }
        let mut slopes = vec![zeros(); C::shape().states.len()];
        self.plain.jacobian(&instant, &here, &mut slopes);
        let expected: Vec<Vec<Dual>> = (0..C::shape().states.len())
            .map(|column| self.dual_rate(time, values, column))
            .collect();
        for column in 0..C::shape().states.len() {
            for row in 0..C::shape().states.len() {
                let (found, wanted) = (slopes[column].as_ref()[row], expected[column][row].slope);
                let scale = self.row(&expected, row, column);
                near(found, wanted, DEVIATION * scale, || {
                    let (of, to) = (C::shape().states[row].name, C::shape().states[column].name);
                    format!("Jacobian, rate of {of} with respect to {to}, at {place}")
                })?;
            }
        }
        let (varied, products) = self.variation(&instant, &here, &slopes);
        let duals = expected.first().map_or(&[][..], Vec::as_slice);
        let again = self.several(time, &here);
        for row in 0..C::shape().states.len() {
            let (wanted, name) = (rate.as_ref()[row], C::shape().states[row].name);
            for (found, way, share) in [
                (varied.as_ref()[row], "variation", ROUNDING),
                (duals[row].value, "dual numbers", DEVIATION),
                (again.as_ref()[row], "several instants", ROUNDING),
            ] {
                near(found, wanted, share * wanted.abs(), || {
                    format!("rate of {name} by {way}, at {place}")
                })?;
            }
            for (found, wanted) in &products[row] {
                let scale: f64 = slopes.iter().map(|column| column.as_ref()[row].abs()).sum();
                near(*found, *wanted, ROUNDING * scale, || {
                    format!("product of the Jacobian in the row of {name}, at {place}")
                })?;
            }
        }
        Ok(true)
    }

    /// The derivative of the state on dual numbers along one component.
    fn dual_rate(&self, time: f64, values: &[f64], column: usize) -> Vec<Dual> {
        let mut here = DualState::<C>::zeros(C::shape().states.len());
        for (index, (slot, value)) in here.as_mut().iter_mut().zip(values).enumerate() {
            let slope = if index == column { 1.0 } else { 0.0 };
            *slot = Dual {
                value: *value,
                slope,
            };
        }
        let mut rate = DualState::<C>::zeros(C::shape().states.len());
        let instant = self.dual.instant(Dual::from_f64(time));
        self.dual.derivative(&instant, &here, &mut rate);
        rate.as_ref().to_vec()
    }

    /// The size of an entry, or of the largest of its row as far as the state's scales make them comparable.
    fn row(&self, slopes: &[Vec<Dual>], row: usize, column: usize) -> f64 {
        let sized = |other: usize| slopes[other][row].slope.abs() * C::shape().scales[other];
        let largest = (0..C::shape().states.len()).map(sized).fold(0.0, f64::max);
        largest / C::shape().scales[column]
    }

    /// The derivative as the variation gives it, and for each row the products with columns beside the expected ones.
    fn variation(
        &self,
        instant: &<C::Equations<f64> as Equations<f64>>::Instant,
        here: &State<C>,
        slopes: &[State<C>],
    ) -> (State<C>, Vec<Vec<(f64, f64)>>) {
        let columns: Vec<State<C>> = (0..=C::shape().states.len())
            .map(unit_column::<C>)
            .collect();
        let mut rate = State::<C>::zeros(C::shape().states.len());
        let mut products = columns.clone();
        self.plain
            .variation(instant, here, &mut rate, &columns, &mut products);
        let expected = |row: usize, column: &State<C>| {
            let terms = slopes.iter().zip(column.as_ref());
            terms
                .map(|(slope, factor)| slope.as_ref()[row] * factor)
                .sum()
        };
        let rows = (0..C::shape().states.len()).map(|row| {
            let pairs = columns.iter().zip(&products);
            pairs
                .map(|(column, product)| (product.as_ref()[row], expected(row, column)))
                .collect()
        });
        (rate, rows.collect())
    }

    /// The derivative of the state with the second of two instants that are computed together.
    fn several(&self, time: f64, here: &State<C>) -> State<C> {
        let (from, _) = self.scene.span().limits();
        let [_, instant] = self.plain.instants([from, time]);
        let mut rate = State::<C>::zeros(C::shape().states.len());
        self.plain.derivative(&instant, here, &mut rate);
        rate
    }
}

/// A column of the unit matrix, and after the last a mixture of all.
fn unit_column<C: Scene>(column: usize) -> State<C> {
    let entry = |row: usize| match column {
        _ if column == C::shape().states.len() => 1.0 / (1.0 + row as f64),
        _ if column == row => 1.0,
        _ => 0.0,
    };
    state::<C>(
        &(0..C::shape().states.len())
            .map(entry)
            .collect::<Vec<f64>>(),
    )
}

fn near(found: f64, wanted: f64, tolerance: f64, place: impl Fn() -> String) -> Result<(), Failed> {
    if (found - wanted).abs() <= tolerance || !found.is_finite() && !wanted.is_finite() {
        return Ok(());
    }
    Err(Failed(format!(
        "{}: found {found:e}, expected {wanted:e} to {tolerance:e}",
        place()
    )))
}
