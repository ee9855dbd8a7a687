//! How events depend on the state: what the variations of a motion do where it jumps.

use super::build::Request;
use super::{Event, Input, Slopes};
use crate::expression::{Expression, Graph, Map, Symbol};

/// Adds their slopes to events. Everything is bound, and `rates` are the rates of the state.
pub fn add(
    graph: &mut Graph,
    events: &mut [Event<Expression>],
    rates: &[Expression],
    request: &Request,
) {
    let mut states: Vec<(u32, Symbol)> = Vec::new();
    for (symbol, input) in &request.inputs {
        if let Input::State(index) = input {
            states.push((*index, *symbol));
        }
    }
    states.sort_unstable_by_key(|(index, _)| *index);
    let one = graph.one();
    let mut along = Map::from_iter([(Symbol::Time, one)]);
    along.extend(states.iter().map(|(index, symbol)| (*symbol, rates[*index as usize])));
    for event in events {
        let mut slopes = Slopes::default();
        for (_, symbol) in &states {
            let direction = Map::from_iter([(*symbol, one)]);
            slopes.guard.extend(graph.tangent(&[event.guard], &direction));
            slopes.after.extend(graph.tangent(&event.after, &direction));
        }
        slopes.rate = graph.tangent(&event.after, &along);
        event.slopes = slopes;
    }
}
