//! The quantities of a scene: what is unknown, what is given, how it is called and printed.

use crate::checked::QuantityInfo;
use crate::declare::{per_second, quantity};
use crate::expression::Symbol;
use crate::lower::Lowering;
use crate::motion::UnknownName;
use crate::resolve::{Declared, Names};
use crate::syntax::tree::Unknown;
use crate::unit::Unit;

/// What equations of motion determine: the highest derivatives.
pub fn unknown_names(names: &Names) -> Vec<UnknownName> {
    let second_order = names
        .coordinates
        .iter()
        .map(|one| UnknownName { name: format!("ddot({})", one.name.text), span: one.name.span });
    let first_order = names
        .states
        .iter()
        .map(|one| UnknownName { name: format!("dot({})", one.name.text), span: one.name.span });
    second_order.chain(first_order).collect()
}

/// The symbols of the state vector, in its order.
pub fn state_symbols(names: &Names) -> Vec<Symbol> {
    let coordinates = names.coordinates.len() as u32;
    let speeds = (0..coordinates).map(Symbol::Speed);
    (0..coordinates)
        .map(Symbol::Coordinate)
        .chain(speeds)
        .chain((0..names.states.len() as u32).map(Symbol::State))
        .collect()
}

/// Names and units of the drivers.
pub fn driver_quantities(low: &Lowering<'_>, names: &Names) -> Vec<QuantityInfo> {
    let one = |(index, driver): (usize, &Declared<_>)| {
        let unit = low.unit_of(Symbol::Driver(index as u32))?;
        Some(quantity(&driver.name.text, &driver.summary, &unit.dimension, &unit))
    };
    names.drivers.iter().enumerate().filter_map(one).collect()
}

/// Names and units of the state vector.
pub fn state_quantities(names: &Names, units: &[Option<Unit>]) -> Vec<QuantityInfo> {
    let (coordinates, states) = units.split_at(names.coordinates.len());
    let described = |(declared, unit): (&Declared<Unknown>, &Option<Unit>)| {
        let unit = unit.as_ref()?;
        Some(quantity(&declared.name.text, &declared.summary, &unit.dimension, unit))
    };
    let speed = |(declared, unit): (&Declared<Unknown>, &Option<Unit>)| {
        let unit = unit.as_ref().and_then(per_second)?;
        Some(quantity(&format!("dot({})", declared.name.text), "", &unit.dimension, &unit))
    };
    let coordinates = || names.coordinates.iter().zip(coordinates);
    let positions = coordinates().filter_map(described);
    let states = names.states.iter().zip(states).filter_map(described);
    positions.chain(coordinates().filter_map(speed)).chain(states).collect()
}
