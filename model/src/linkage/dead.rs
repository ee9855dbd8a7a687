//! Dead points of a motion: where a group comes to the end of its reach, its independent coordinates no longer say how the
//! rest goes on.
//!
//! An integrator would creep up to such a point and stay there, or step over it and go back on the branch that it came from,
//! with numbers that look well. So it is an event that the sine of a group falls below a limit, above which speeds are still
//! known to ten digits and more.

use super::{Group, Linkage};
use crate::checked::EventInfo;
use crate::expression::{Expression, Map, Symbol};
use crate::lower::Lowering;
use crate::program::{Event, Slopes};
use crate::syntax::tree::Direction;

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
            // The root of something negative: what does not exist is no number.
            let lost = {
                let size = graph.powi(guard, 2);
                let one = graph.one();
                let sum = graph.add(one, size);
                let negative = graph.neg(sum);
                graph.sqrt(negative)
            };
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

/// Whether coordinates move what a group closes: what drivers alone move is looked at as they move.
fn moves_with_coordinates(group: &Group, low: &mut Lowering<'_>) -> bool {
    let zero = low.graph.zero();
    let Some(slopes) = &mut low.slopes else {
        return false;
    };
    (0..low.names.coordinates.len() as u32).any(|index| {
        let coefficients = slopes.by(&mut low.graph, Symbol::Coordinate(index));
        group.unknowns.iter().any(|unknown| coefficients[*unknown] != zero)
    })
}
