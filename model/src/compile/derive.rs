//! The fourth phase: the equations of motion, written, derived from energies, or said by what stands still.

use super::Here;
use crate::diagnostic::Diagnostic;
use crate::expression::Symbol;
use crate::linkage::Linkage;
use crate::lower::Lowering;
use crate::modes;
use crate::motion::Equation;
use crate::statements::Parts;

/// The equations that hold in a mode.
pub fn equations(
    here: Here<'_>,
    parts: &mut Parts,
    still: &[usize],
    low: &mut Lowering<'_>,
) -> Vec<Equation> {
    let mut equations = parts.equations(low, low.names);
    modes::check_holds(low, low.names, here.phase());
    stand_still(here, still, &mut equations, low);
    equations
}

/// What a mode holds or does not have stands still; the equation of a coordinate that is held says what holds it.
fn stand_still(
    here: Here<'_>,
    still: &[usize],
    equations: &mut Vec<Equation>,
    low: &mut Lowering<'_>,
) {
    equations.retain(|equation| equation.lagrange.is_none_or(|one| !still.contains(&one)));
    let all: Vec<_> = low.names.coordinates.iter().chain(&low.names.states).collect();
    for index in still {
        if equations.len() + still.len() <= all.len() {
            break;
        }
        // Of the equations of all modes the one that determines what is held, and nothing else, gives way.
        let own = Symbol::Acceleration(*index as u32);
        let common = &here.phase().statements[..here.phase().common];
        let alone = |equation: &Equation| {
            if common.iter().all(|one| one.span != equation.span) {
                return false;
            }
            let symbols = low.graph.occurring(equation.residual);
            let mut highest = symbols.filter(|one| matches!(one, Symbol::Acceleration(_)));
            highest.next() == Some(own) && highest.next().is_none()
        };
        let mut found = (0..equations.len()).filter(|place| alone(&equations[*place]));
        if let (Some(place), None) = (found.next(), found.next()) {
            equations.remove(place);
        }
    }
    for index in still {
        let name = &all[*index].name;
        equations.push(Equation {
            residual: low.graph.symbol(Symbol::Acceleration(*index as u32)),
            name: format!("hold {}", name.text),
            span: name.span,
            lagrange: None,
        });
    }
}

/// Adds the forces of closures that are not solved for to Lagrange's equations, and the second and the third time derivatives
/// of these closures to all. What has neither mass nor force moves as the closures say.
pub fn hold(
    equations: &mut Vec<Equation>,
    linkage: &Linkage,
    still: &[usize],
    low: &mut Lowering<'_>,
) {
    let names = low.names;
    let residuals: Vec<_> = linkage.equations.iter().map(|one| one.residual).collect();
    let bound = low.graph.symbols(&residuals);
    let is_bound = |index: u32| bound.contains(&Symbol::Coordinate(index));
    let moves = |symbol| matches!(symbol, Symbol::Acceleration(index) if is_bound(index));
    let is_written = |one: &&Equation| {
        one.lagrange.is_none()
            && low.given_symbol(one.residual).is_none()
            && low.graph.depends_on(one.residual, moves)
    };
    if let Some(written) = equations.iter().find(is_written) {
        let message = format!(
            "`{}` is an equation of motion that is written out, and the closures here have no closed form: their forces belong into it",
            written.name
        );
        let report = Diagnostic::error(written.span, message);
        let hint = "state the inertia by `kinetic` and the forces by `potential`, `dissipation` and `force`";
        low.diagnostics.push(report.hint(hint));
        return;
    }
    let Some(direction) = low.direction() else { return };
    let graph = &mut low.graph;
    let forces = (0..residuals.len() as u32).map(Symbol::Reaction);
    let forces: Vec<_> = forces.map(|symbol| graph.symbol(symbol)).collect();
    let weighted: Vec<_> = residuals.iter().copied().zip(forces).collect();
    let moves = |index: &u32| is_bound(*index) && !still.contains(&(*index as usize));
    let moving: Vec<u32> = (0..names.coordinates.len() as u32).filter(moves).collect();
    let positions: Vec<_> = moving.iter().map(|index| Symbol::Coordinate(*index)).collect();
    let held = graph.gradient(&weighted, &positions);
    for (index, force) in moving.into_iter().map(|index| index as usize).zip(held) {
        let opposite = graph.neg(force);
        match equations.iter_mut().find(|one| one.lagrange == Some(index)) {
            Some(equation) => equation.residual = graph.add(equation.residual, opposite),
            None => equations.push(Equation {
                residual: opposite,
                name: format!("Lagrange's equation of {}", names.coordinates[index].name.text),
                span: names.coordinates[index].name.span,
                lagrange: Some(index),
            }),
        }
    }
    let once = graph.tangent(&residuals, &direction);
    let twice = graph.tangent(&once, &direction);
    let thrice = graph.tangent(&twice, &direction);
    let own = || linkage.equations.iter();
    let derived = own().zip(twice).chain(own().zip(thrice));
    equations.extend(derived.map(|(own, residual)| Equation { residual, ..own.clone() }));
}
