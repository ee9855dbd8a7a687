//! What only the motion as a whole determines: the forces of closures and drivers, energies and lost power.
//!
//! Lagrange's equations as if nothing were bound say which force moves each position as it moves. On a dependent
//! coordinate that force comes from the closures, `(∂F/∂z)ᵀ·λ`: their own rows give it, from the last group to the first.
//! What is left on a driver is what its motion takes. `λ` acts on what stands on the left side of a closure, because it
//! does the work `λ·δF` and `F` is the left side less the right one.

use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Map, Symbol};
use crate::lagrange::Energies;
use crate::linkage::{Augmented, Linkage, named};
use crate::lower::Lowering;
use crate::motion::{Equation, Solved};
use crate::statements::Parts;
use crate::token::Span;

/// What the highest derivatives, rates of dependent coordinates, forces and energies stand for.
pub fn bindings(
    parts: &Parts,
    linkage: &Linkage,
    solved: &Solved,
    low: &mut Lowering<'_>,
) -> Map<Symbol, Expression> {
    let highest = (0..).map(Symbol::Acceleration).zip(solved.derivatives.iter().copied());
    let mut bindings: Map<Symbol, Expression> = highest.collect();
    bindings.extend(low.followed.iter().map(|(symbol, value)| (*symbol, *value)));
    energies(&parts.energies, low, &mut bindings);
    let zero = low.graph.zero();
    let force = |symbol: Symbol| parts.forces.get(&symbol).copied().unwrap_or(zero);
    let residuals: Vec<_> = linkage.equations.iter().map(|one| one.residual).collect();
    let (reactions, written) = match &low.slopes {
        Some(slopes) => {
            let dependents = 0..low.names.dependents.len() as u32;
            let right: Vec<_> = dependents.map(|index| force(Symbol::Dependent(index))).collect();
            let reactions = slopes.solve_transposed(&mut low.graph, &right);
            match &linkage.combined {
                Some(combined) => (reactions.clone(), combined.back(&mut low.graph, &reactions)),
                None => (reactions.clone(), reactions),
            }
        }
        None => (solved.reactions.clone(), solved.reactions.clone()),
    };
    for (index, reaction) in written.into_iter().enumerate() {
        bindings.insert(Symbol::Reaction(index as u32), reaction);
    }
    let weighted: Vec<_> = residuals.into_iter().zip(reactions).collect();
    let drivers: Vec<_> = (0..low.names.drivers.len() as u32).map(Symbol::Driver).collect();
    let by_closures = low.graph.gradient(&weighted, &drivers);
    for (index, (driver, share)) in drivers.iter().zip(by_closures).enumerate() {
        let effort = low.graph.sub(force(*driver), share);
        bindings.insert(Symbol::Effort(index as u32), effort);
    }
    bindings
}

/// Reports forces that are asked for of closures that share them with others.
pub fn check_determined(
    low: &mut Lowering<'_>,
    (asked, place): (&[Expression], Span),
    augmented: &Augmented,
    linkage: &Linkage,
) {
    let shared = |symbol: Symbol| matches!(symbol, Symbol::Reaction(index) if augmented.undetermined.contains(&(index as usize)));
    if !asked.iter().any(|one| low.graph.depends_on(*one, shared)) {
        return;
    }
    let is_determined = |index: &usize| !augmented.undetermined.contains(index);
    let determined: Vec<usize> = (0..augmented.closures).filter(is_determined).collect();
    let message = format!(
        "a reaction is asked for that is not determined: only {} of the {} scalar closures are independent, and {} share their forces",
        augmented.rank,
        augmented.closures,
        named(&linkage.equations, &augmented.undetermined),
    );
    let hint = match determined.is_empty() {
        true => {
            "leave a closure out that follows from the others: what it holds is elastic in truth"
                .to_string()
        }
        false => format!("determined are those of {}", named(&linkage.equations, &determined)),
    };
    low.diagnostics.push_once(message.clone(), Diagnostic::error(place, message).hint(hint));
}

/// Reports forces that are asked for where an equation of motion is written out, which does not say which force moves what,
/// and where nothing makes any.
pub fn check_asked(
    low: &mut Lowering<'_>,
    (asked, place): (&[Expression], Span),
    (parts, equations): (&Parts, &[Equation]),
) {
    let forces = |symbol: Symbol| matches!(symbol, Symbol::Reaction(_) | Symbol::Effort(_));
    if !asked.iter().any(|one| low.graph.depends_on(*one, forces)) {
        return;
    }
    let coordinates = low.names.coordinates.len() as u32;
    let moves =
        |symbol: Symbol| matches!(symbol, Symbol::Acceleration(index) if index < coordinates);
    // What is held is no equation of its own.
    let is_held = |one: &Equation| low.given_symbol(one.residual).is_some();
    let mut written = equations.iter().filter(|one| one.lagrange.is_none() && !is_held(one));
    let (message, place) = match written.find(|one| low.graph.depends_on(one.residual, moves)) {
        Some(equation) => {
            let name = &equation.name;
            (
                format!(
                    "`{name}` is an equation of motion that is written out, so that forces of closures and drivers are not known"
                ),
                equation.span,
            )
        }
        None if parts.energy_places.is_empty() => {
            let message =
                "a force of a closure or a driver is asked for, and nothing has mass or force";
            (message.to_string(), place)
        }
        None => return,
    };
    low.diagnostics.push_once(
        message.clone(),
        Diagnostic::error(place, message)
            .hint("state the inertia by `kinetic` and the forces by `potential`, `dissipation` and `force`"),
    );
}

/// Kinetic and potential energy, and the power that the dissipation function takes: its slope along the speeds.
fn energies(energies: &Energies, low: &mut Lowering<'_>, bindings: &mut Map<Symbol, Expression>) {
    let graph = &mut low.graph;
    let kinds = [&energies.kinetic, &energies.potential, &energies.dissipation];
    let [kinetic, potential, dissipation] = kinds.map(|terms| graph.sum(terms));
    let speed = |symbol: &Symbol| {
        matches!(symbol, Symbol::Speed(_) | Symbol::DependentRate(_) | Symbol::DriverRate(_))
    };
    let speeds: Vec<_> = graph.symbols(&[dissipation]).into_iter().filter(speed).collect();
    let one = graph.one();
    let slopes = graph.gradient(&[(dissipation, one)], &speeds);
    let products = speeds.iter().zip(slopes).map(|(speed, slope)| {
        let speed = graph.symbol(*speed);
        graph.mul(slope, speed)
    });
    let products: Vec<_> = products.collect();
    let lost = graph.sum(&products);
    for (index, value) in [kinetic, potential, lost].into_iter().enumerate() {
        bindings.insert(Symbol::Energy(index as u32), value);
    }
}
