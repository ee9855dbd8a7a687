//! Coordinates that turn: a motion with one repeats though the coordinate does not come back. In a scene that seeks what
//! repeats such a coordinate is set back by its period wherever it is half a period away from its start.

use crate::checked::EventInfo;
use crate::expression::{Expression, Symbol};
use crate::linkage::period;
use crate::lower::Lowering;
use crate::program::{Event, Slopes};
use crate::syntax::tree::Direction;
use crate::token::Span;

/// The events that set turning coordinates back, in a mode of this index. `roots` is all that the motion depends on, `start`
/// the start values of the state; what starts at rest swings.
pub fn events(
    low: &mut Lowering<'_>,
    roots: &[Expression],
    start: &[Expression],
    mode: usize,
    scene: Span,
) -> Vec<(Event<Expression>, EventInfo)> {
    let names = low.names;
    let count = names.coordinates.len();
    let zero = low.graph.zero();
    let states: Vec<Expression> = (0..count as u32)
        .map(Symbol::Coordinate)
        .chain((0..count as u32).map(Symbol::Speed))
        .chain((0..names.states.len() as u32).map(Symbol::State))
        .map(|symbol| low.graph.symbol(symbol))
        .collect();
    let mut events = Vec::new();
    for (index, declared) in names.coordinates.iter().enumerate() {
        let moves = start.get(count + index).is_some_and(|rate| *rate != zero);
        let symbol = Symbol::Coordinate(index as u32);
        let Some(period) = period(&mut low.graph, roots, symbol).filter(|_| moves) else {
            continue;
        };
        let sides = [(1.0, Direction::Rises, declared.name.span), (-1.0, Direction::Falls, scene)];
        for (sign, direction, span) in sides {
            let (way, half) =
                (low.graph.number(sign * period), low.graph.number(sign * period / 2.0));
            let end = low.graph.add(start[index], half);
            let mut after = states.clone();
            after[index] = low.graph.sub(states[index], way);
            let event = Event {
                guard: low.graph.sub(states[index], end),
                rate: states[count + index],
                condition: None,
                after,
                slopes: Slopes::default(),
            };
            let text = format!("`{}` is set back by a turn", declared.name.text);
            events.push((event, EventInfo::implied(text, direction, mode, span)));
        }
    }
    events
}
