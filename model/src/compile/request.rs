//! What the program of a mode is asked for.

use super::Mode;
use crate::checked::{AugmentedInfo, LinkageInfo, SpanKind};
use crate::expression::{Expression, Symbol};
use crate::linkage::Carried;
use crate::lower::{Lowering, Moved};
use crate::program::{self, Input, Request, Results};

use super::quantities::state_symbols;

/// Everything but what the loops compute.
pub fn of(mode: &Mode<'_>, low: &mut Lowering<'_>) -> Request {
    let (asked, solved, phases) = (&mode.asked, &mode.solved, mode.here.phases);
    let points = match mode.declared.is_linkage() {
        true => Vec::new(),
        false => asked.geometry.points.clone(),
    };
    let mut results = Results {
        points,
        derivative: speeds(mode, low),
        outputs: asked.outputs.values.clone(),
        measured: asked.measures.looked_at.clone(),
        measures: asked.measures.values.clone(),
        drivers: drivers(mode, low),
        mass: solved.mass.clone(),
        energy: energy(mode, low),
        requirements: mode.parts.conditions.clone(),
        span: asked.span.values.clone(),
        start: asked.start.clone(),
        events: asked.events.iter().map(|(event, _)| event.clone()).collect(),
        ..Results::default()
    };
    let highest = (0..solved.derivatives.len() as u32).map(Symbol::Acceleration);
    let rates = highest.map(|symbol| low.graph.symbol(symbol));
    results.derivative.extend(rates);
    match mode.is_along {
        false => results.jacobian = jacobian(mode, low),
        true => results.along = along(mode, low),
    }
    let span = asked.span.kind;
    let is_hybrid = phases.is_hybrid() || !asked.events.is_empty();
    let mut request = Request {
        states: results.start.len(),
        results,
        surfaces: matches!(span, SpanKind::Run | SpanKind::Rest) || is_hybrid,
        cycle: span == SpanKind::Periodic && is_hybrid,
        ..Request::default()
    };
    let inputs = &mut request.inputs;
    for (index, symbol) in state_symbols(low.names).into_iter().enumerate() {
        inputs.insert(symbol, Input::State(index as u32));
    }
    let changes = 0..request.states as u32;
    inputs.extend(changes.map(|index| (Symbol::Change(index), Input::Change(index))));
    inputs.insert(Symbol::Time, Input::Time);
    let found = 0..asked.measures.primitives.len() as u32;
    inputs.extend(found.map(|index| (Symbol::Measured(index), Input::Measured(index))));
    follow(mode, &mut request, low);
    request
}

/// Says what symbols stand for that are not given; a linkage, of which derivatives by its
/// dimensions are taken, has them written out.
fn follow(mode: &Mode<'_>, request: &mut Request, low: &mut Lowering<'_>) {
    let bindings = std::mem::take(&mut low.bound);
    if mode.declared.is_linkage() {
        let results = &request.results;
        let written = program::bind(&mut low.graph, &results.all(), &bindings);
        request.results = results.with(written);
    } else {
        request.bindings = bindings;
    }
}

/// Rates of the coordinates.
fn speeds(mode: &Mode<'_>, low: &mut Lowering<'_>) -> Vec<Expression> {
    let coordinates = 0..low.names.coordinates.len();
    let speed = |index: usize| match mode.still.contains(&index) {
        true => low.graph.zero(),
        false => low.graph.symbol(Symbol::Speed(index as u32)),
    };
    coordinates.map(speed).collect()
}

/// Positions of the drivers.
fn drivers(mode: &Mode<'_>, low: &mut Lowering<'_>) -> Vec<Expression> {
    let drives = &mode.declared.drives;
    match mode.declared.moved {
        Moved::Swept => {
            let symbols = (0..drives.len() as u32).map(Symbol::Driver);
            symbols.map(|symbol| low.graph.symbol(symbol)).collect()
        }
        _ => drives.iter().filter_map(|drive| drive.position).collect(),
    }
}

/// Kinetic and potential energy, if any is stated.
fn energy(mode: &Mode<'_>, low: &mut Lowering<'_>) -> Vec<Expression> {
    let energies = &mode.parts.energies;
    if energies.kinetic.is_empty() && energies.potential.is_empty() {
        return Vec::new();
    }
    let kinds = [&energies.kinetic, &energies.potential];
    kinds.map(|terms| low.graph.sum(terms)).into()
}

/// The nonzero entries of the Jacobian.
fn jacobian(mode: &Mode<'_>, low: &mut Lowering<'_>) -> Vec<(u32, u32, Expression)> {
    let coordinates = low.names.coordinates.len();
    let one = low.graph.one();
    let moving = (0..coordinates).filter(|index| !mode.still.contains(index));
    let own = moving.map(|index| (index as u32, (coordinates + index) as u32, one));
    let partials = mode.solved.partials.iter();
    own.chain(
        partials.map(|(row, column, value)| ((coordinates + row) as u32, *column as u32, *value)),
    )
    .collect()
}

/// The product of the Jacobian with a column.
fn along(mode: &Mode<'_>, low: &mut Lowering<'_>) -> Vec<Expression> {
    let coordinates = low.names.coordinates.len();
    let own = (0..coordinates).map(|index| match mode.still.contains(&index) {
        true => low.graph.zero(),
        false => low.graph.symbol(Symbol::Change((coordinates + index) as u32)),
    });
    let mut products: Vec<_> = own.collect();
    products.resize(coordinates + mode.solved.derivatives.len(), low.graph.zero());
    for (row, _, value) in &mode.solved.partials {
        products[coordinates + row] = *value;
    }
    products
}

/// Adds what the loops compute. A motion carries them along in closed form, and names those that may fail to close.
pub fn loops(
    mode: &Mode<'_>,
    values: &[f64],
    request: &mut Request,
    low: &mut Lowering<'_>,
) -> Option<Carried> {
    let (declared, linkage) = (&mode.declared, &mode.linkage);
    let drives = &declared.drives;
    if declared.is_linkage() {
        give_drivers(request, drives.len());
        request.results.closing = linkage.closing(low, request, &mode.asked.geometry, drives);
        let drivers = (&mode.asked.ranges, &drives[..]);
        request.results.start = linkage.starts(low, drivers, &request.results.span);
        return Some(Carried::default());
    }
    for (index, drive) in drives.iter().enumerate() {
        let position = drive.position;
        let driver = Symbol::Driver(index as u32);
        request.bindings.extend(position.map(|value| (driver, value)));
    }
    if mode.augmented.is_some() {
        request.results.closing = linkage.closures(low);
        return Some(Carried::default());
    }
    let starts = low.graph.evaluate(&mode.asked.start, &|symbol| match symbol {
        Symbol::Parameter(index) => values[index as usize],
        _ => f64::NAN,
    });
    linkage.carry(low, (drives, &starts), values, request)
}

/// Positions of drivers, and their speeds and accelerations, come from outside.
fn give_drivers(request: &mut Request, count: usize) {
    let count = count as u32;
    for index in 0..count {
        request.inputs.extend([
            (Symbol::Driver(index), Input::Driver(index)),
            (Symbol::DriverRate(index), Input::Driver(count + index)),
            (Symbol::DriverAcceleration(index), Input::Driver(2 * count + index)),
        ]);
    }
}

/// The closures that hold the coordinates of a motion, unless they are solved for.
pub fn augmented(mode: &Mode<'_>) -> Option<AugmentedInfo> {
    let augmented = mode.augmented.as_ref()?;
    let loops = (0..augmented.closures).map(|index| mode.linkage.loop_info(index));
    Some(AugmentedInfo {
        loops: loops.collect(),
        rank: augmented.rank,
        sizes: augmented.sizes.clone(),
        kept: augmented.kept.clone(),
        redundant: augmented.redundant.clone(),
    })
}

/// The loops by which a motion is reduced to its independent coordinates.
pub fn reduced(mode: &Mode<'_>, low: &mut Lowering<'_>) -> LinkageInfo {
    let (declared, linkage) = (&mode.declared, &mode.linkage);
    linkage.info(low, low.names, &declared.dependent_units, &mode.asked.ranges, Vec::new())
}

/// Adds the influence coefficients of a linkage, and says what it is.
pub fn influences(
    mode: &Mode<'_>,
    kept: &[usize],
    request: &mut Request,
    low: &mut Lowering<'_>,
) -> LinkageInfo {
    let (declared, linkage) = (&mode.declared, &mode.linkage);
    let variables = linkage.variables(low.names, &declared.constants, kept);
    let ranges = &mode.asked.ranges;
    linkage.influence(low, request, &variables, kept);
    let constants = kept.iter().filter_map(|old| declared.constants[*old].as_ref());
    let mut constants = constants.map(|constant| constant.tolerance);
    // What is made exactly has no error of second order. Tolerances that are given later find them by dual numbers.
    if constants.any(|tolerance| tolerance > 0.0) || ranges.have_tolerances() {
        linkage.curve(low, request, &variables, kept);
    }
    linkage.info(low, low.names, &declared.dependent_units, ranges, variables)
}
