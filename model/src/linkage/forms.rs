//! Closed forms in the place of the dependent coordinates.

use super::relative::{Links, turned_by};
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
    /// What turns all round and moves everything, and where it starts.
    pub crank: Option<(Symbol, f64)>,
    /// How often each dependent coordinate turns meanwhile.
    pub turns: Vec<f64>,
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
                let turns = self.turns_of(graph, direction.argument);
                let angle = self.angle(graph, pair, (at[link], turns));
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
                None => {
                    let turns = self.turns.get(index).copied().unwrap_or(0.0);
                    self.angle(graph, pair, (start, turns))
                }
            };
            request.bindings.insert(Symbol::Dependent(index as u32), angle);
        }
    }

    /// How often a direction turns while the crank turns once.
    fn turns_of(&self, graph: &mut Graph, direction: Expression) -> f64 {
        let Some((crank, _)) = self.crank else { return 0.0 };
        let own = (0..self.turns.len() as u32).map(|index| (Symbol::Dependent(index), index));
        let along = own.map(|(symbol, index)| (symbol, self.turns[index as usize]));
        let along: Vec<_> = along.chain([(crank, 1.0)]).collect();
        let along = along.into_iter().map(|(symbol, turns)| (symbol, graph.number(turns)));
        let along: Map<_, _> = along.collect();
        let turns = graph.tangent(&[direction], &along)[0];
        graph.as_number(turns).unwrap_or(0.0)
    }

    /// The angle of a unit vector that is at an angle at the start, and turns so often while the crank turns once: what it does
    /// beside that stays within half a turn of the right angle that is next to its start, so that nothing jumps by a turn.
    fn angle(
        &self,
        graph: &mut Graph,
        unit: [Symbol; 2],
        (start, turns): (f64, f64),
    ) -> Expression {
        let unit = unit.map(|symbol| graph.symbol(symbol));
        match self.crank {
            Some((crank, from)) if turns != 0.0 => {
                let (crank, from) = (graph.symbol(crank), graph.number(-from));
                let turned = graph.add(crank, from);
                let turned = graph.scale(turns, turned);
                let back = [Function::Cos, Function::Sin].map(|one| graph.call(one, &[turned]));
                let beside = turned_by(graph, &[unit, back], [1, -1]);
                let beside = around(graph, beside, start);
                graph.add(turned, beside)
            }
            _ => around(graph, unit, start),
        }
    }
}

/// The angle of a unit vector within half a turn of the right angle that is next to its start.
fn around(graph: &mut Graph, [cosine, sine]: [Expression; 2], start: f64) -> Expression {
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
