//! The same mechanism stated in other units.
//!
//! A mechanism does not know in which units its values are given. Once all of them, the time and the state are numbers
//! of millimetres, grams and milliseconds, so are its derivative, its outputs and its drivers. A number with a unit that
//! hides in the equations, or a unit that is not what the table says, breaks that.
//!
//! A force is the same number in N and in g mm/ms², and so is a speed in m/s and in mm/ms. Therefore the mechanism is
//! also stated in centimetres, grams and seconds: only m³/(kg² s) and its powers are the same in all three systems.
//! Amperes, kelvins, moles and candelas stay what they are.
//!
//! No tolerance is chosen. Both ways are computed with the bound of their rounding errors ([`Bounded`]), and differ by no
//! more than the two bounds. A value of which rounding leaves nothing has an infinite bound and says nothing.
//!
//! The times are spread over the task; the states are those at which the Jacobian is checked too, from near the start to
//! far from it. They need not lie on the motion: a hidden number shows wherever its term is larger than rounding, some
//! 1e-13 of the value that it is a part of. So nothing is integrated, and a stiff scene costs no more than another.
//!
//! A scene with a number of its own (`x + 3 mm`, `250 rpm*time`, an empirical formula of `S/(1 mm)`) cannot be stated in
//! other units by its constants. It has no such test; its documentation names the first of these numbers.

mod closure;

pub use closure::closure_scaling;

use super::{Failed, places, rates};
use crate::registry::{Mechanism, SceneEntry};
use assur_solvers::problem::{Phase, Reports, Scene};
use assur_solvers::scalar::{Bounded, Scalar};
use assur_solvers::shape::{Constant, Quantity};

/// Exponents of the seven base units, as in [`Quantity::dimension`].
type Dimension = [(i8, i8); 7];

const TIME: Dimension = [(0, 1), (0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1)];

/// Units of length, mass and time.
struct Units {
    /// Their symbols.
    symbols: [&'static str; 3],
    /// How many digits a value in SI units gains.
    digits: [i32; 3],
}

/// The systems of units in which a mechanism is stated.
const SYSTEMS: [Units; 2] = [
    Units { symbols: ["mm", "g", "ms"], digits: [3, 3, 3] },
    Units { symbols: ["cm", "g", "s"], digits: [2, 3, 0] },
];

/// Checks at several times and states that a scene gives the same derivative, outputs and positions of the drivers when
/// its values are stated in other units.
///
/// # Errors
/// The first component that deviates, with both values and their unit; or that there was none to compare.
pub fn scaling<C: Scene>(
    mechanism: &Mechanism,
    scene: &str,
    from_values: &dyn Fn(&[f64]) -> Option<C>,
) -> Result<(), Failed> {
    let entry = mechanism.scenes.iter().find(|entry| entry.name == scene);
    let entry = entry.ok_or_else(|| Failed("there is no such scene".into()))?;
    // Past the ranges of the values, which are in SI units.
    let stated = |value: &dyn Fn(&Constant) -> f64| {
        let values: Vec<f64> = entry.constants.iter().map(value).collect();
        from_values(&values).ok_or_else(|| Failed("the scene has other constants".into()))
    };
    // Which of closures that depend on each other is left out where they contradict each other, as at places that no motion
    // comes to, depends on their sizes.
    if entry.augmented.is_some_and(|held| held.rank < held.loops.len()) {
        return Ok(());
    }
    let components = components(entry);
    let scene = stated(&|constant| constant.default)?;
    let mut compared = 0;
    for units in &SYSTEMS {
        let restated = stated(&|one| one.default * units.factor(&one.quantity.dimension))?;
        for (time, state) in places(&scene) {
            let there = units.place(entry, time, &state);
            let expected = values(&scene, time, &state);
            let found = values(&restated, there.0, &there.1);
            for ((component, expected), found) in components.iter().zip(expected).zip(found) {
                if expected.bound.is_finite() {
                    units.compare(component, expected, found, &there)?;
                    compared += 1;
                }
            }
        }
    }
    match compared {
        0 => Err(Failed("there is no value to compare".into())),
        _ => Ok(()),
    }
}

/// What a scene gives, in the order of [`values`].
fn components(entry: &SceneEntry) -> Vec<(String, Dimension)> {
    let rates = entry.states.iter().map(|state| {
        let mut dimension = state.dimension;
        dimension[2].0 -= dimension[2].1;
        (format!("rate of {}", state.name), dimension)
    });
    let named = |what: &'static str, list: &'static [Quantity]| {
        let name = move |one: &Quantity| (format!("{what} {}", one.name), one.dimension);
        list.iter().map(name)
    };
    rates.chain(named("output", entry.outputs)).chain(named("driver", entry.drivers)).collect()
}

/// Derivative of the state, outputs and positions of the drivers, with the bounds of their errors.
fn values<C: Scene>(scene: &C, time: f64, state: &[f64]) -> Vec<Bounded> {
    let (equations, shape) = (scene.prepare::<Bounded>(), scene.shape());
    let time = Bounded::from_f64(time);
    let here: Vec<Bounded> = state.iter().map(|value| Bounded::from_f64(*value)).collect();
    let (rates, _) = rates(&equations, shape.first, time, &here);
    let mut outputs = vec![Bounded::ZERO; shape.outputs.len()];
    equations.outputs(Phase::of(shape.first), time, &here, &mut outputs);
    let mut drivers = vec![Bounded::ZERO; shape.drivers.len()];
    equations.drivers(time, &mut drivers);
    [rates, outputs, drivers].concat()
}

impl Units {
    /// The number that one SI unit of a dimension is. At most a power of ten, exact up to 22 digits, and a root of one.
    fn factor(&self, dimension: &Dimension) -> f64 {
        let exponents = dimension.map(|(above, below)| (i64::from(above), i64::from(below)));
        let parts: i64 = exponents[..3].iter().map(|(_, below)| below).product();
        let digits: i64 = exponents
            .iter()
            .zip(self.digits)
            .map(|((above, below), digits)| i64::from(digits) * above * (parts / below))
            .sum();
        let (whole, rest) = (digits.div_euclid(parts), digits.rem_euclid(parts));
        let power = (0..whole.abs()).fold(1.0, |power, _| power * 10.0);
        let root = 10f64.powf(rest as f64 / parts as f64);
        match whole < 0 {
            true => root / power,
            false => root * power,
        }
    }

    /// A time and state in these units.
    fn place(&self, entry: &SceneEntry, time: f64, state: &[f64]) -> (f64, Vec<f64>) {
        let state = state.iter().zip(entry.states);
        let state = state.map(|(value, quantity)| value * self.factor(&quantity.dimension));
        (time * self.factor(&TIME), state.collect())
    }

    /// Compares a value in these units with the one in SI units.
    fn compare(
        &self,
        (name, dimension): &(String, Dimension),
        expected: Bounded,
        found: Bounded,
        (time, state): &(f64, Vec<f64>),
    ) -> Result<(), Failed> {
        let expected = expected * Bounded::from_f64(self.factor(dimension));
        let (off, rounding) = ((found.value - expected.value).abs(), found.bound + expected.bound);
        if off <= rounding && rounding.is_finite() {
            return Ok(());
        }
        let [length, mass, second] = self.symbols;
        let unit = self.symbol(dimension);
        let [found, expected, off, rounding] = [found.value, expected.value, off, rounding]
            .map(|value| format!("{value:e} {unit}").trim_end().to_owned());
        Err(Failed(format!(
            "{name} in {length}, {mass}, {second}, at time {time} {second}, state {state:?}: found {found}, expected \
             {expected} as in SI units; off by {off}, of which rounding explains {rounding}"
        )))
    }

    /// A unit as it is written, `g mm/ms^2`.
    fn symbol(&self, dimension: &Dimension) -> String {
        let [length, mass, second] = self.symbols;
        let bases = [mass, length, second, "A", "K", "mol", "cd"];
        let [first, second, rest @ ..] = dimension;
        let exponents = [second, first].into_iter().chain(rest);
        let mut sides = [Vec::new(), Vec::new()];
        for (base, (above, below)) in bases.into_iter().zip(exponents) {
            sides[usize::from(*above < 0)].push(match (above.unsigned_abs(), below) {
                (0, _) => continue,
                (1, 1) => base.to_owned(),
                (power, 1) => format!("{base}^{power}"),
                (power, root) => format!("{base}^({power}/{root})"),
            });
        }
        let [above, below] = sides;
        let (over, under) = (above.join(" "), below.join(" "));
        match (above.len(), below.len()) {
            (_, 0) => over,
            (0, 1) => format!("1/{under}"),
            (0, _) => format!("1/({under})"),
            (_, 1) => format!("{over}/{under}"),
            _ => format!("{over}/({under})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks what one SI unit with these exponents of m, kg, s and A is in mm, g and ms.
    #[track_caller]
    fn check(exponents: [(i8, i8); 4], factor: f64, symbol: &str) {
        let mut dimension = [(0, 1); 7];
        dimension[..4].copy_from_slice(&exponents);
        let found = SYSTEMS[0].factor(&dimension);
        assert!((found / factor - 1.0).abs() <= Bounded::GIVEN, "{found}");
        assert_eq!(SYSTEMS[0].symbol(&dimension), symbol);
    }

    #[test]
    fn units_are_converted_and_written() {
        check([(0, 1), (0, 1), (0, 1), (0, 1)], 1.0, "");
        check([(1, 1), (1, 1), (-2, 1), (0, 1)], 1.0, "g mm/ms^2");
        check([(2, 1), (1, 1), (-3, 1), (-1, 1)], 1.0, "g mm^2/(ms^3 A)");
        check([(-2, 1), (0, 1), (-2, 1), (0, 1)], 1e-12, "1/(mm^2 ms^2)");
        check([(0, 1), (0, 1), (-1, 1), (0, 1)], 1e-3, "1/ms");
        check([(1, 2), (0, 1), (-1, 1), (0, 1)], 0.03162277660168379, "mm^(1/2)/ms");
        check([(-1, 3), (1, 2), (0, 1), (0, 1)], 3.1622776601683795, "g^(1/2)/mm^(1/3)");
    }
}
