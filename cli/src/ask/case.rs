//! A scene with its values, as it is shown, and what moves it.

use assur::problem::Refused;
use assur::registry::SceneEntry;
use assur::shape::Quantity;

use super::constants::Constants;
use super::variables::Variable;
use crate::error::Failure;
use crate::show::number;

/// A scene with its values, moved by `M`: [`crate::motion::case::Course`] or [`crate::linkage::case::Moves`].
pub struct Case<M> {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// Its dimensions and parameters.
    pub constants: Constants,
    /// What is reported.
    pub variables: Vec<Variable>,
    /// The drivers, in the units in which they are shown.
    pub drivers: Vec<Quantity>,
    /// What moves it.
    pub moved: M,
}

impl<M> Case<M> {
    /// A position of a driver in words, `phi4 = 90 deg`; empty if there is no such driver.
    pub fn driver_at(&self, index: usize, position: f64) -> String {
        let driver = self.drivers.get(index);
        driver.map_or_else(String::new, |driver| amount_of(driver, position))
    }

    /// Positions of the drivers in words, `phi4 = 90 deg`.
    pub fn label(&self, positions: &[f64]) -> String {
        label(&self.drivers, positions)
    }
}

/// Positions of drivers in words, `phi4 = 90 deg`.
pub fn label(drivers: &[Quantity], positions: &[f64]) -> String {
    let pairs = drivers.iter().zip(positions);
    pairs.map(|(driver, position)| amount_of(driver, *position)).collect::<Vec<_>>().join(", ")
}

/// A value of a quantity with its name, `phi4 = 90 deg`.
pub fn amount_of(quantity: &Quantity, value: f64) -> String {
    format!("{} = {}", quantity.name, amount(quantity, value))
}

/// A value with its unit, `90 deg`.
pub fn amount(quantity: &Quantity, value: f64) -> String {
    let number = number::short(value / quantity.factor);
    format!("{number} {}", quantity.unit).trim_end().to_owned()
}

/// What to say when the mechanism refuses values.
pub fn refused(constants: &Constants, refused: &Refused) -> Failure {
    Failure::request(format!("scene `{}` does not accept these values", constants.scene.name))
        .place(match constants.given_names().as_slice() {
            [] => "the values of the file".to_owned(),
            names => format!("--set {}", names.join(", --set ")),
        })
        .reason(format!("{}: {}", refused.name, refused.reason))
        .remedy("change the value with --set, or leave it out for the default")
}
