//! What a scene's program is asked for, beside its outputs.

use crate::expression::{Expression, Symbol};
use crate::lagrange::Energies;
use crate::lower::Lowering;
use crate::motion::{Equation, Solved};
use crate::program::{Input, Request};

/// Positions of drivers, and their speeds and accelerations, come from outside.
pub fn give_drivers(request: &mut Request, count: usize) {
    let count = count as u32;
    for index in 0..count {
        request.inputs.extend([
            (Symbol::Driver(index), Input::Driver(index)),
            (Symbol::DriverRate(index), Input::Driver(count + index)),
            (
                Symbol::DriverAcceleration(index),
                Input::Driver(2 * count + index),
            ),
        ]);
    }
}

/// The nonzero entries of the Jacobian.
pub fn jacobian(
    low: &mut Lowering<'_>,
    coordinates: usize,
    still: &[usize],
    solved: &Solved,
) -> Vec<(u32, u32, Expression)> {
    let one = low.graph.one();
    let mut entries: Vec<_> = (0..coordinates)
        .filter(|index| !still.contains(index))
        .map(|index| (index as u32, (coordinates + index) as u32, one))
        .collect();
    entries.extend(
        solved
            .partials
            .iter()
            .map(|(row, column, value)| ((coordinates + row) as u32, *column as u32, *value)),
    );
    entries
}

/// Kinetic and potential energy, if any is stated.
pub fn energy(low: &mut Lowering<'_>, energies: &Energies) -> Vec<Expression> {
    if energies.kinetic.is_empty() && energies.potential.is_empty() {
        return Vec::new();
    }
    vec![
        low.graph.sum(&energies.kinetic),
        low.graph.sum(&energies.potential),
    ]
}

/// Whether the sum of the energies stays constant.
pub fn conservative(low: &mut Lowering<'_>, energies: &Energies, equations: &[Equation]) -> bool {
    let stated = !energies.kinetic.is_empty()
        && energies.dissipation.is_empty()
        && energies.forces.is_empty();
    let derived = equations.iter().all(|equation| equation.lagrange.is_some());
    let driven = |symbol| matches!(symbol, Symbol::Time | Symbol::Driver(_));
    let fixed = energies
        .kinetic
        .iter()
        .chain(&energies.potential)
        .all(|term| !low.graph.depends_on(*term, driven));
    stated && derived && fixed
}

/// Indices of the constants that anything in the program depends on.
pub fn kept_constants(low: &Lowering<'_>, request: &Request) -> Vec<usize> {
    let mut all: Vec<Expression> = Vec::new();
    all.extend(&request.derivative);
    all.extend(request.jacobian.iter().map(|entry| entry.2));
    for list in [
        &request.outputs,
        &request.drivers,
        &request.mass,
        &request.energy,
        &request.requirements,
        &request.span,
        &request.start,
        &request.measured,
        &request.measures,
        &request.margins,
    ] {
        all.extend(list);
    }
    all.extend(request.bindings.values());
    all.extend(request.closing.all());
    all.extend(request.events.iter().flat_map(|event| event.all()));
    let symbols = low.graph.symbols(&all);
    (0..low.names.constants.len())
        .filter(|index| symbols.contains(&Symbol::Parameter(*index as u32)))
        .collect()
}
