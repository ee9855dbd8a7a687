//! Dead points of a motion: where a group comes to the end of its reach, its independent coordinates no longer say how the
//! rest goes on.
//!
//! An integrator would creep up to such a point and stay there, or step over it and go back on the branch that it came from,
//! with numbers that look well. So it is an event that the sine of a group falls below a limit, above which speeds are still
//! known to ten digits and more.

use super::assembly::solved;
use super::{Group, Linkage, Places, angles};
use crate::checked::EventInfo;
use crate::expression::{Expression, Map, Symbol};
use crate::lower::Lowering;
use crate::program::{Event, Slopes};
use crate::syntax::tree::Direction;
use std::f64::consts::TAU;

/// Sine of a group below which it is at a dead point.
const DEAD: f64 = 1e-3;

impl Linkage {
    /// The events at which the groups that move with coordinates come to a dead point; the state after them is no number. For
    /// a mode of this index with so many states.
    pub fn dead_points(
        &self,
        low: &mut Lowering<'_>,
        states: usize,
        mode: usize,
    ) -> Vec<(Event<Expression>, EventInfo)> {
        let Some(direction) = low.direction() else {
            return Vec::new();
        };
        // The root of something negative: what does not exist is no number.
        let lost = {
            let time = low.graph.symbol(Symbol::Time);
            let (one, square) = (low.graph.one(), low.graph.powi(time, 2));
            let sum = low.graph.add(one, square);
            let negative = low.graph.neg(sum);
            low.graph.sqrt(negative)
        };
        let mut events = Vec::new();
        for (number, group) in self.groups.iter().enumerate() {
            let Some(closed) = &group.closed else { continue };
            if low.graph.as_number(closed.margin).is_some() || !moves_with_coordinates(group, low) {
                continue;
            }
            let graph = &mut low.graph;
            let sign = Map::from_iter([(Symbol::Mode(number as u32), graph.one())]);
            let sine = graph.substitute(&[closed.sine], &sign)[0];
            let square = graph.powi(sine, 2);
            let limit = graph.number(DEAD * DEAD);
            let guard = graph.sub(square, limit);
            let rate = graph.tangent(&[guard], &direction)[0];
            let event = Event {
                guard,
                rate,
                condition: None,
                after: vec![lost; states],
                slopes: Slopes::default(),
            };
            let name = self.names(group);
            let text = format!("{name} comes to a dead point");
            let span = self.equations[group.equations[0]].span;
            events.push((event, EventInfo::implied(text, Direction::Falls, mode, span)));
        }
        events
    }
}

/// Parts of a turn at which a linkage is looked at.
const PARTS: u32 = 720;

impl Linkage {
    /// Whether the groups that move with coordinates may come to a dead point. They do not where a crank that turns all round
    /// is the only coordinate that moves them.
    pub fn may_stop(&self, low: &mut Lowering<'_>, crank: Option<Symbol>) -> bool {
        let moving: Vec<&Group> = self
            .groups
            .iter()
            .filter(|group| {
                let closed = group.closed.as_ref();
                closed.is_some_and(|one| low.graph.as_number(one.margin).is_none())
                    && moves_with_coordinates(group, low)
            })
            .collect();
        let coordinates = 0..low.names.coordinates.len() as u32;
        let mut movers =
            coordinates.filter(|index| moving.iter().any(|group| moves_with(group, *index, low)));
        match (movers.next(), movers.next()) {
            (None, _) => false,
            (Some(index), None) => crank != Some(Symbol::Coordinate(index)),
            _ => true,
        }
    }

    /// The only thing that moves the loops, coordinate or driver, if it can turn all round with these assembly modes and the
    /// values of the file; and how often each dependent coordinate turns meanwhile, an angle from where it starts.
    pub fn turn(
        &self,
        low: &mut Lowering<'_>,
        given: &Places,
        signs: &[f64],
    ) -> Option<(Symbol, Vec<f64>)> {
        let residuals: Vec<_> = self.equations.iter().map(|one| one.residual).collect();
        let moves = |symbol: &Symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Driver(_));
        let symbols = low.graph.symbols(&residuals);
        let mut movers = symbols.into_iter().filter(moves);
        let (Some(crank), None) = (movers.next(), movers.next()) else { return None };
        if !angles::is_turn(&mut low.graph, &residuals, crank) {
            return None;
        }
        let (mut here, mut turned) = (given.clone(), vec![0.0; given.dependents.len()]);
        for part in 1..=PARTS {
            let before = here.dependents.clone();
            let angle = given.of(crank) + TAU * f64::from(part) / f64::from(PARTS);
            match crank {
                Symbol::Coordinate(index) => here.state[index as usize] = angle,
                Symbol::Driver(index) => here.drivers[index as usize] = angle,
                _ => return None,
            }
            self.close(low, &mut here, signs)?;
            for (index, turned) in turned.iter_mut().enumerate().filter(|one| self.angles[one.0]) {
                let step = (here.dependents[index] - before[index]) / TAU;
                *turned += step - step.round();
            }
        }
        Some((crank, turned.into_iter().map(f64::round).collect()))
    }

    /// Closes all groups; none if one of them does not close far from dead points.
    fn close(&self, low: &Lowering<'_>, here: &mut Places, signs: &[f64]) -> Option<()> {
        for (number, (group, sign)) in self.groups.iter().zip(signs).enumerate() {
            let closed = group.closed.as_ref()?;
            let mode = Symbol::Mode(number as u32);
            let at = |symbol: Symbol| if symbol == mode { *sign } else { here.of(symbol) };
            let numbers = low.graph.evaluate(&[closed.margin, closed.sine], &at);
            for (index, value) in solved(&low.graph, closed, here, (mode, *sign)) {
                here.dependents[index] = value;
            }
            if !(numbers[0] > 0.0 && numbers[1].abs() > 10.0 * DEAD) {
                return None;
            }
        }
        Some(())
    }
}

/// Whether coordinates move what a group closes: what drivers alone move is looked at as they move.
fn moves_with_coordinates(group: &Group, low: &mut Lowering<'_>) -> bool {
    (0..low.names.coordinates.len() as u32).any(|index| moves_with(group, index, low))
}

/// Whether a coordinate moves what a group closes.
fn moves_with(group: &Group, index: u32, low: &mut Lowering<'_>) -> bool {
    let zero = low.graph.zero();
    let Some(slopes) = &mut low.slopes else {
        return false;
    };
    let coefficients = slopes.by(&mut low.graph, Symbol::Coordinate(index));
    group.unknowns.iter().any(|unknown| coefficients[*unknown] != zero)
}
