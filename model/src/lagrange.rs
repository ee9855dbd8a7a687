//! Equations of motion from energies.
//!
//! Lagrange's equations of the second kind, in Kane's form wherever a kinetic term is `c·v²/2` with a true velocity `v`:
//! its share in equation `k` is `c·a·∂v/∂u_k` with the acceleration `a = dv/dt`. All shares are gathered by one reverse
//! sweep over the shared expressions, so that the equations of a chain of `n` links cost `O(n)` operations. What is
//! not such a square is treated by Lagrange's rule as it stands.
//!
//! T. R. Kane, D. A. Levinson, "Dynamics: Theory and Applications" (1985), section 4.

use std::collections::BTreeSet;

use crate::expression::{Expression, Graph, Map, Node, Symbol};

/// The energies and forces of a scene.
#[derive(Clone, Debug, Default)]
pub struct Energies {
    /// Kinetic energy, term by term.
    pub kinetic: Vec<Expression>,
    /// Potential energy, term by term.
    pub potential: Vec<Expression>,
    /// Dissipation function, term by term.
    pub dissipation: Vec<Expression>,
    /// Forces with the positions on which they do work.
    pub forces: Vec<(Expression, Expression)>,
}

impl Energies {
    /// The positions that occur in them, or whose rates do.
    pub fn concern(&self, graph: &Graph) -> BTreeSet<Symbol> {
        let single = self.kinetic.iter().chain(&self.potential).chain(&self.dissipation);
        let forces = self.forces.iter().flat_map(|(force, on)| [force, on]);
        let all: Vec<Expression> = single.chain(forces).copied().collect();
        let position = |symbol| match symbol {
            Symbol::Coordinate(_) | Symbol::Dependent(_) | Symbol::Driver(_) => Some(symbol),
            Symbol::Speed(index) => Some(Symbol::Coordinate(index)),
            Symbol::DependentRate(index) => Some(Symbol::Dependent(index)),
            Symbol::DriverRate(index) => Some(Symbol::Driver(index)),
            _ => None,
        };
        graph.symbols(&all).into_iter().filter_map(position).collect()
    }
}

/// The symbol of the time derivative of a position.
fn rate_of(position: Symbol) -> Symbol {
    match position {
        Symbol::Coordinate(index) => Symbol::Speed(index),
        Symbol::Dependent(index) => Symbol::DependentRate(index),
        Symbol::Driver(index) => Symbol::DriverRate(index),
        other => other,
    }
}

/// A kinetic term `coefficient·velocity²/2`.
struct Square {
    coefficient: Expression,
    velocity: Expression,
}

/// The residuals of Lagrange's equations for some positions as if nothing bound them,
/// `d/dt ∂T/∂u − ∂T/∂q + ∂V/∂q + ∂D/∂u − Q`: the force that moves them as they move, zero for what moves freely.
///
/// `direction` says how everything moves with time; `is_rate` whether an expression is certainly the time derivative
/// of something that depends on positions and time alone.
pub fn residuals(
    graph: &mut Graph,
    energies: &Energies,
    positions: &[Symbol],
    direction: &Map<Symbol, Expression>,
    is_rate: &dyn Fn(Expression) -> bool,
) -> Vec<Expression> {
    let speeds: Vec<_> = positions.iter().map(|position| rate_of(*position)).collect();
    let one = graph.one();

    // Weights of the two reverse sweeps: over ∂/∂u and over ∂/∂q.
    let mut by_speed: Vec<(Expression, Expression)> = Vec::new();
    let mut by_position: Vec<(Expression, Expression)> = Vec::new();
    let mut whole: Vec<Expression> = Vec::new();
    for term in energies.kinetic.iter().flat_map(|term| split(graph, *term)).collect::<Vec<_>>() {
        match square(graph, term) {
            Some(Square { coefficient, velocity }) if is_rate(velocity) => {
                let rates = graph.tangent(&[velocity, coefficient], direction);
                let inertia = graph.mul(coefficient, rates[0]);
                let growth = graph.mul(rates[1], velocity);
                by_speed.push((velocity, graph.add(inertia, growth)));
                let varies = graph.depends_on(coefficient, |symbol| positions.contains(&symbol));
                if varies {
                    let (half, square) = (graph.number(-0.5), graph.powi(velocity, 2));
                    by_position.push((coefficient, graph.mul(half, square)));
                }
            }
            _ => whole.push(term),
        }
    }
    by_position.extend(energies.potential.iter().map(|term| (*term, one)));
    by_speed.extend(energies.dissipation.iter().map(|term| (*term, one)));
    for (force, on) in &energies.forces {
        by_position.push((*on, graph.neg(*force)));
    }

    let from_speeds = graph.gradient(&by_speed, &speeds);
    let from_positions = graph.gradient(&by_position, positions);
    let mut residuals: Vec<_> =
        from_speeds.iter().zip(&from_positions).map(|(a, b)| graph.add(*a, *b)).collect();
    if !whole.is_empty() {
        let weighted: Vec<_> = whole.iter().map(|term| (*term, one)).collect();
        let momenta = graph.gradient(&weighted, &speeds);
        let rates = graph.tangent(&momenta, direction);
        let slopes = graph.gradient(&weighted, positions);
        for (residual, (rate, slope)) in residuals.iter_mut().zip(rates.iter().zip(&slopes)) {
            let share = graph.sub(*rate, *slope);
            *residual = graph.add(*residual, share);
        }
    }
    residuals
}

/// The terms of a sum.
fn split(graph: &Graph, term: Expression) -> Vec<Expression> {
    graph.budget().spend(1);
    match graph.node(term) {
        Node::Sum(terms) => terms.iter().flat_map(|one| split(graph, *one)).collect(),
        _ => vec![term],
    }
}

/// Reads a term as `coefficient·velocity²/2`.
fn square(graph: &mut Graph, term: Expression) -> Option<Square> {
    let factors: Vec<Expression> = match graph.node(term) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![term],
    };
    let moves = |graph: &Graph, e: Expression| {
        use Symbol::{DependentRate, DriverRate, Speed};
        graph.depends_on(e, |symbol| matches!(symbol, Speed(_) | DependentRate(_) | DriverRate(_)))
    };
    let at = factors.iter().position(|factor| match graph.node(*factor) {
        Node::Power(base, exponent) => {
            graph.as_number(*exponent) == Some(2.0) && moves(graph, *base)
        }
        _ => false,
    })?;
    let Node::Power(velocity, _) = *graph.node(factors[at]) else {
        return None;
    };
    let mut rest: Vec<_> =
        factors.iter().enumerate().filter(|(index, _)| *index != at).map(|(_, one)| *one).collect();
    if rest.iter().any(|factor| moves(graph, *factor)) {
        return None;
    }
    rest.push(graph.number(2.0));
    Some(Square { coefficient: graph.product(&rest), velocity })
}
