//! Groups whose angles count from each other: the direction of a link is then a sum of coordinates, `φ₁ + φ₂`.
//!
//! The group is solved for the directions, which are as many as the coordinates; these are their differences.

use super::{Closed, Slot, angles};
use crate::expression::{Expression, Graph, Map, Node, Symbol};
use crate::program::Function;

/// Directions as sums of two angles: row by row the coefficients of the angles in a direction, 0, 1 or −1.
pub struct Relative {
    unknowns: [usize; 2],
    directions: [[i8; 2]; 2],
}

impl Relative {
    /// Reads the directions, and gives the equations with each direction in the place of one of the coordinates. None where
    /// each direction is a coordinate, or where they are not two.
    pub fn of(
        graph: &mut Graph,
        residuals: &[Expression],
        unknowns: &[usize],
        angle: &[bool],
    ) -> Option<(Self, Vec<Expression>)> {
        let &[a, b] = unknowns else { return None };
        if !(angle[a] && angle[b]) {
            return None;
        }
        let unknowns = [a, b];
        let symbols = unknowns.map(|unknown| Symbol::Dependent(unknown as u32));
        let mut found: Vec<(Expression, [i8; 2], Expression)> = Vec::new();
        for one in graph.reachable(residuals) {
            let Node::Call(Function::Sin | Function::Cos, arguments) = graph.node(one) else {
                continue;
            };
            let argument = arguments[0];
            if !graph.depends_on(argument, |symbol| symbols.contains(&symbol)) {
                continue;
            }
            if found.iter().all(|other| other.0 != argument) {
                let (direction, rest) = split(graph, argument, symbols)?;
                found.push((argument, direction, rest));
            }
        }
        let mut directions: Vec<[i8; 2]> = Vec::new();
        for (_, direction, _) in &found {
            let turned = direction.map(|one| -one);
            if !directions.contains(direction) && !directions.contains(&turned) {
                directions.push(*direction);
            }
        }
        let directions: [[i8; 2]; 2] = directions.try_into().ok()?;
        let [[p, q], [r, s]] = directions;
        let alone = directions.iter().all(|one| one.contains(&0));
        if alone || (p * s - q * r).abs() != 1 {
            return None;
        }
        let mut map = Map::default();
        for (argument, direction, rest) in found {
            let place = directions.iter().position(|one| *one == direction);
            let (place, sign) = match place {
                Some(place) => (place, 1.0),
                None => (directions.iter().position(|one| one.map(|one| -one) == direction)?, -1.0),
            };
            let symbol = graph.symbol(symbols[place]);
            let signed = graph.scale(sign, symbol);
            let value = graph.sum(&[signed, rest]);
            for function in [Function::Sin, Function::Cos] {
                let (old, new) =
                    (graph.call(function, &[argument]), graph.call(function, &[value]));
                map.insert(old, new);
            }
        }
        let replaced = angles::replace(graph, residuals, &map);
        Some((Self { unknowns, directions }, angles::expand(graph, &replaced)))
    }

    /// The determinant of the directions by the coordinates, 1 or −1.
    fn determinant(&self) -> i8 {
        let [[p, q], [r, s]] = self.directions;
        p * s - q * r
    }

    /// The closed form of the coordinates from that of the directions.
    pub fn back(&self, graph: &mut Graph, closed: &Closed, mode: u32) -> Option<Closed> {
        let determinant = self.determinant();
        // The mode is the sign of the determinant of the equations by the coordinates.
        let symbol = Symbol::Mode(mode);
        let own = graph.symbol(symbol);
        let turned = graph.scale(f64::from(determinant), own);
        let map = Map::from_iter([(symbol, turned)]);
        let wanted = |slot: Slot| closed.values.iter().find(|one| one.0 == slot).map(|one| one.1);
        let mut units = Vec::new();
        for unknown in self.unknowns {
            let pair = [wanted(Slot::Cosine(unknown))?, wanted(Slot::Sine(unknown))?];
            units.push(graph.substitute(&pair, &map));
        }
        let [[p, q], [r, s]] = self.directions;
        let mut values = Vec::new();
        // The inverse of a matrix of whole numbers with this determinant.
        for (unknown, [along, across]) in self.unknowns.into_iter().zip([[s, -q], [-r, p]]) {
            let factors = [along * determinant, across * determinant];
            let [cosine, sine] = turned_by(graph, &units, factors);
            let angle = graph.call(Function::Atan2, &[sine, cosine]);
            values.push((Slot::Value(unknown), angle));
            values.push((Slot::Cosine(unknown), cosine));
            values.push((Slot::Sine(unknown), sine));
        }
        let sine = graph.substitute(&[closed.sine], &map)[0];
        let sine = graph.scale(f64::from(determinant), sine);
        Some(Closed { values, sine, margin: closed.margin })
    }
}

/// An argument as coefficients of two angles and the rest.
fn split(
    graph: &mut Graph,
    argument: Expression,
    symbols: [Symbol; 2],
) -> Option<([i8; 2], Expression)> {
    let terms: Vec<Expression> = match graph.node(argument) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![argument],
    };
    let (mut direction, mut rest) = ([0; 2], Vec::new());
    for term in terms {
        let (coefficient, inner) = graph.split_coefficient(term);
        let place = match graph.node(inner) {
            Node::Symbol(symbol) => symbols.iter().position(|one| one == symbol),
            _ => None,
        };
        match place {
            Some(place) if coefficient.abs() == 1.0 => direction[place] = coefficient as i8,
            Some(_) => return None,
            None if graph.depends_on(term, |symbol| symbols.contains(&symbol)) => return None,
            None => rest.push(term),
        }
    }
    Some((direction, graph.sum(&rest)))
}

/// Cosine and sine of a sum of directions, each taken once with a sign, or not at all.
fn turned_by(graph: &mut Graph, units: &[Vec<Expression>], factors: [i8; 2]) -> [Expression; 2] {
    let mut unit = [graph.one(), graph.zero()];
    for (own, factor) in units.iter().zip(factors) {
        if factor == 0 {
            continue;
        }
        let [cosine, sine] = [own[0], graph.scale(f64::from(factor), own[1])];
        let products = [
            graph.mul(unit[0], cosine),
            graph.mul(unit[1], sine),
            graph.mul(unit[1], cosine),
            graph.mul(unit[0], sine),
        ];
        unit = [graph.sub(products[0], products[1]), graph.add(products[2], products[3])];
    }
    unit
}
