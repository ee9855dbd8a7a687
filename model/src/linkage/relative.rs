//! Groups whose angles count from each other or from what is given: the direction of a link is then a sum, `φ₁ + φ₂`.
//!
//! The group is solved for the directions, which are as many as the coordinates; these are their differences.

use super::{Closed, Slot, angles};
use crate::expression::{Expression, Graph, Map, Node, Symbol};
use crate::program::Function;

/// Directions as sums of two angles and what else is given.
pub struct Relative {
    unknowns: [usize; 2],
    directions: [Direction; 2],
}

/// Two links with the coordinates that count from them.
#[derive(Clone, Debug)]
pub struct Links {
    /// Their directions.
    pub directions: [Direction; 2],
    /// Cosine and sine of each.
    pub units: [[Expression; 2]; 2],
    /// For each coordinate how it follows from the directions without their rests, 0, 1 or −1.
    pub coordinates: [(usize, [i8; 2]); 2],
}

/// The direction of a link.
#[derive(Clone, Copy, Debug)]
pub struct Direction {
    /// The argument of its sines and cosines.
    pub argument: Expression,
    /// Coefficients of the two angles in it, 0, 1 or −1.
    along: [i8; 2],
    /// What is left.
    pub rest: Expression,
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
        let mut found: Vec<Direction> = Vec::new();
        for one in graph.reachable(residuals) {
            let Node::Call(Function::Sin | Function::Cos, arguments) = graph.node(one) else {
                continue;
            };
            let argument = arguments[0];
            if !graph.depends_on(argument, |symbol| symbols.contains(&symbol)) {
                continue;
            }
            if found.iter().all(|other| other.argument != argument) {
                found.push(split(graph, argument, symbols)?);
            }
        }
        let mut directions: Vec<Direction> = Vec::new();
        for one in &found {
            if !directions.iter().any(|other| one.turns_with(other).is_some()) {
                directions.push(*one);
            }
        }
        let directions: [Direction; 2] = directions.try_into().ok()?;
        let is_coordinate =
            |one: &Direction| one.along.contains(&0) && graph.as_number(one.rest).is_some();
        let relative = Self { unknowns, directions };
        if directions.iter().all(is_coordinate) || relative.determinant().abs() != 1 {
            return None;
        }
        let mut map = Map::default();
        for one in found {
            let signs = directions.iter().map(|other| one.turns_with(other));
            let (place, sign) = signs.enumerate().find_map(|(place, sign)| Some((place, sign?)))?;
            let symbol = graph.symbol(symbols[place]);
            let (signed, other) =
                (graph.scale(sign, symbol), graph.scale(-sign, directions[place].rest));
            let value = graph.sum(&[signed, one.rest, other]);
            for function in [Function::Sin, Function::Cos] {
                let (old, new) =
                    (graph.call(function, &[one.argument]), graph.call(function, &[value]));
                map.insert(old, new);
            }
        }
        let replaced = angles::replace(graph, residuals, &map);
        Some((relative, angles::expand(graph, &replaced)))
    }

    /// The determinant of the directions by the coordinates, 1 or −1.
    fn determinant(&self) -> i8 {
        let [[p, q], [r, s]] = self.directions.map(|one| one.along);
        p * s - q * r
    }

    /// The closed form of the coordinates from that of the directions, which it keeps.
    pub fn back(&self, graph: &mut Graph, closed: &Closed, mode: u32) -> Option<Closed> {
        let determinant = self.determinant();
        // The mode is the sign of the determinant of the equations by the coordinates.
        let symbol = Symbol::Mode(mode);
        let own = graph.symbol(symbol);
        let turned = graph.scale(f64::from(determinant), own);
        let map = Map::from_iter([(symbol, turned)]);
        let wanted = |slot: Slot| closed.values.iter().find(|one| one.0 == slot).map(|one| one.1);
        let mut units = [[own; 2]; 2];
        for (unknown, unit) in self.unknowns.into_iter().zip(&mut units) {
            let pair = [wanted(Slot::Cosine(unknown))?, wanted(Slot::Sine(unknown))?];
            unit.copy_from_slice(&graph.substitute(&pair, &map));
        }
        let bare = [0, 1].map(|link| {
            let rest = self.directions[link].rest;
            let rest = [Function::Cos, Function::Sin].map(|one| graph.call(one, &[rest]));
            turned_by(graph, &[units[link], rest], [1, -1])
        });
        let [[p, q], [r, s]] = self.directions.map(|one| one.along);
        // The inverse of a matrix of whole numbers with this determinant.
        let [a, b] = [[s, -q], [-r, p]].map(|row| row.map(|one| one * determinant));
        let coordinates = [(self.unknowns[0], a), (self.unknowns[1], b)];
        let mut values = Vec::new();
        for (unknown, factors) in coordinates {
            let [cosine, sine] = turned_by(graph, &bare, factors);
            let angle = graph.call(Function::Atan2, &[sine, cosine]);
            values.push((Slot::Value(unknown), angle));
            values.push((Slot::Cosine(unknown), cosine));
            values.push((Slot::Sine(unknown), sine));
        }
        let sine = graph.substitute(&[closed.sine], &map)[0];
        let sine = graph.scale(f64::from(determinant), sine);
        let links = Some(Links { directions: self.directions, units, coordinates });
        Some(Closed { values, links, sine, margin: closed.margin })
    }
}

impl Direction {
    /// The sign with which it turns as another one does, if it does.
    fn turns_with(&self, other: &Self) -> Option<f64> {
        let turned = other.along.map(|one| -one);
        match self.along {
            along if along == other.along => Some(1.0),
            along if along == turned => Some(-1.0),
            _ => None,
        }
    }
}

/// An argument as coefficients of two angles and the rest.
fn split(graph: &mut Graph, argument: Expression, symbols: [Symbol; 2]) -> Option<Direction> {
    let terms = angles::terms(graph, argument);
    let (mut along, mut rest) = ([0; 2], Vec::new());
    for term in terms {
        let (coefficient, inner) = graph.split_coefficient(term);
        let place = match graph.node(inner) {
            Node::Symbol(symbol) => symbols.iter().position(|one| one == symbol),
            _ => None,
        };
        match place {
            Some(place) if coefficient.abs() == 1.0 => along[place] = coefficient as i8,
            Some(_) => return None,
            None if graph.depends_on(term, |symbol| symbols.contains(&symbol)) => return None,
            None => rest.push(term),
        }
    }
    Some(Direction { argument, along, rest: graph.sum(&rest) })
}

/// Cosine and sine of a sum of directions, each taken once with a sign, or not at all.
pub fn turned_by(
    graph: &mut Graph,
    units: &[[Expression; 2]],
    factors: [i8; 2],
) -> [Expression; 2] {
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
