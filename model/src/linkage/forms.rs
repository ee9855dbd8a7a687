//! Closed forms in the place of the dependent coordinates.

use super::relative::Links;
use super::{Slot, angles};
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::lower::Lowering;
use crate::program::{Function, Request};
use std::f64::consts::FRAC_PI_2;

/// What groups are closed by, on the assembly modes that are chosen.
#[derive(Default)]
pub struct Forms {
    /// Of coordinates.
    pub values: Vec<(Slot, Expression)>,
    /// Of the directions of links that are sums of coordinates, with the angles at which these start.
    pub relative: Vec<(Links, [f64; 2])>,
    /// Where angles are declared to start.
    pub starts: Vec<(usize, f64)>,
}

impl Forms {
    /// Puts them in. Cosine and sine of an angle are those of its link, never those of the angle.
    pub fn put_in(&self, low: &mut Lowering<'_>, request: &mut Request) {
        let graph = &mut low.graph;
        let symbols: Vec<_> =
            (0..low.names.dependents.len() as u32).map(Symbol::Dependent).collect();
        let (mut calls, mut units, mut angles_of) = (Map::default(), Vec::new(), Map::default());
        for (group, (links, at)) in self.relative.iter().enumerate() {
            let bare = [0, 1].map(|link| {
                let direction = links.directions[link];
                let first = 2 * (symbols.len() + 2 * group + link) as u32;
                let pair = [Symbol::Argument(first), Symbol::Argument(first + 1)];
                for (place, function) in [Function::Cos, Function::Sin].into_iter().enumerate() {
                    let call = graph.call(function, &[direction.argument]);
                    calls.insert(call, graph.symbol(pair[place]));
                    units.push((pair[place], links.units[link][place]));
                }
                let angle = around(graph, pair, at[link]);
                graph.sub(angle, direction.rest)
            });
            for (index, factors) in links.coordinates {
                let terms = [0, 1].map(|link| graph.scale(f64::from(factors[link]), bare[link]));
                angles_of.insert(index, graph.sum(&terms));
            }
        }
        let apart = |graph: &mut Graph, list: &[Expression]| {
            let replaced = angles::replace(graph, list, &calls);
            let expanded = angles::expand(graph, &replaced);
            angles::free_of(graph, &expanded, &symbols)
        };
        let results = apart(graph, &request.results.all());
        request.results = request.results.with(results);
        let (names, bound): (Vec<_>, Vec<_>) =
            std::mem::take(&mut request.bindings).into_iter().unzip();
        request.bindings = names.into_iter().zip(apart(graph, &bound)).collect();
        for (index, symbol) in symbols.iter().enumerate() {
            let angle = graph.symbol(*symbol);
            for (place, function) in [Function::Cos, Function::Sin].into_iter().enumerate() {
                let value = graph.call(function, &[angle]);
                request.bindings.insert(Symbol::Argument((2 * index + place) as u32), value);
            }
        }
        let (slots, values): (Vec<_>, Vec<_>) = self.values.iter().copied().unzip();
        for (slot, value) in slots.into_iter().zip(apart(graph, &values)) {
            let symbol = match slot {
                Slot::Value(index) => Symbol::Dependent(index as u32),
                Slot::Cosine(index) => Symbol::Argument(2 * index as u32),
                Slot::Sine(index) => Symbol::Argument(2 * index as u32 + 1),
            };
            request.bindings.insert(symbol, value);
        }
        let (names, units): (Vec<_>, Vec<_>) = units.into_iter().unzip();
        request.bindings.extend(names.into_iter().zip(apart(graph, &units)));
        for &(index, start) in &self.starts {
            let pair = [Symbol::Argument(2 * index as u32), Symbol::Argument(2 * index as u32 + 1)];
            let angle = match angles_of.get(&index) {
                Some(angle) => *angle,
                None => around(graph, pair, start),
            };
            request.bindings.insert(Symbol::Dependent(index as u32), angle);
        }
    }
}

/// The angle of a unit vector within half a turn of the right angle that is next to its start, so that what swings does
/// not jump by a turn.
fn around(graph: &mut Graph, unit: [Symbol; 2], start: f64) -> Expression {
    let [cosine, sine] = unit.map(|symbol| graph.symbol(symbol));
    let quarters = (start / FRAC_PI_2).round();
    let (x, y) = match quarters.rem_euclid(4.0) as u8 {
        0 => (cosine, sine),
        1 => (sine, graph.neg(cosine)),
        2 => (graph.neg(cosine), graph.neg(sine)),
        _ => (graph.neg(sine), cosine),
    };
    let angle = graph.call(Function::Atan2, &[y, x]);
    let from = graph.number(quarters * FRAC_PI_2);
    graph.add(from, angle)
}
