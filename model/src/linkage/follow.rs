//! How the dependent coordinates move with what drives them: `ż = P·q̇` and `z̈ = P·q̈ + b`, group after group.

use crate::expression::{Expression, Map, Symbol};
use crate::lower::Lowering;

/// What the dependent coordinates follow: a position with its first and second time derivative.
struct Mover {
    position: Symbol,
    rate: Expression,
    acceleration: Expression,
}

/// Says what the time derivatives of the dependent coordinates stand for, in terms of those of coordinates and drivers.
/// The closures have to be ordered, and the motions of the drivers read.
pub fn follow(low: &mut Lowering<'_>) {
    let Some(mut slopes) = low.slopes.take() else {
        return;
    };
    let movers = movers(low);
    let graph = &mut low.graph;
    let residuals = slopes.residuals().to_vec();
    let count = low.names.dependents.len();
    let mut along: Map<Symbol, Expression> = Map::default();
    along.extend(movers.iter().map(|mover| (mover.position, mover.rate)));
    for index in 0..count as u32 {
        let rate = graph.symbol(Symbol::DependentRate(index));
        along.insert(Symbol::Dependent(index), rate);
    }
    // What is left of the second derivative of the closures where all accelerations are zero.
    let once = graph.tangent(&residuals, &along);
    let twice = graph.tangent(&once, &along);
    let right: Vec<_> = twice.iter().map(|one| graph.neg(*one)).collect();
    let bias = slopes.solve(graph, &right);
    let mut rates = vec![Vec::new(); count];
    let mut accelerations: Vec<Vec<Expression>> = bias.into_iter().map(|one| vec![one]).collect();
    for mover in &movers {
        let coefficients = slopes.by(graph, mover.position);
        for (index, coefficient) in coefficients.into_iter().enumerate() {
            rates[index].push(graph.mul(coefficient, mover.rate));
            accelerations[index].push(graph.mul(coefficient, mover.acceleration));
        }
    }
    for (index, (rate, acceleration)) in rates.iter().zip(&accelerations).enumerate() {
        let (rate, acceleration) = (graph.sum(rate), graph.sum(acceleration));
        low.followed.insert(Symbol::DependentRate(index as u32), rate);
        low.followed.insert(Symbol::DependentAcceleration(index as u32), acceleration);
    }
    low.slopes = Some(slopes);
}

/// Coordinates, and drivers whose speed is known.
fn movers(low: &mut Lowering<'_>) -> Vec<Mover> {
    let mut movers = Vec::new();
    for index in 0..low.names.coordinates.len() as u32 {
        let highest = [Symbol::Speed(index), Symbol::Acceleration(index)];
        let [rate, acceleration] = highest.map(|symbol| low.graph.symbol(symbol));
        movers.push(Mover { position: Symbol::Coordinate(index), rate, acceleration });
    }
    let time = Map::from_iter([(Symbol::Time, low.graph.one())]);
    for (index, motion) in low.driver_motions.clone().into_iter().enumerate() {
        let Some((_, rate)) = motion else { continue };
        let index = index as u32;
        let acceleration = match low.given_symbol(rate) {
            Some(Symbol::DriverRate(_)) => low.graph.symbol(Symbol::DriverAcceleration(index)),
            _ => low.graph.tangent(&[rate], &time)[0],
        };
        movers.push(Mover { position: Symbol::Driver(index), rate, acceleration });
    }
    movers
}
