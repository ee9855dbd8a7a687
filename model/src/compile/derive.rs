//! The fourth phase: the equations of motion, written, derived from energies, or said by what stands still.

use super::Here;
use crate::expression::Symbol;
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
