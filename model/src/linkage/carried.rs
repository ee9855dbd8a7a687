//! A linkage that is carried along by a motion: its drivers move in time, and what it does acts on coordinates that move by
//! themselves. Its dependent coordinates are then functions of the time, put in as closed forms.

use super::relative::Links;
use super::{Closed, Group, Linkage, Places, Slot, angles};
use crate::checked::LoopInfo;
use crate::declare::Drive;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::lower::Lowering;
use crate::program::{Function, Request};
use std::f64::consts::{FRAC_PI_2, TAU};

impl Linkage {
    /// Binds the dependent coordinates to their closed forms, on the assembly modes that the declared start values pick
    /// with these values of the constants. Asks for the margins of the groups that may fail to close, and names these; says
    /// whether the motion may come to a dead point of one.
    pub fn carry(
        &self,
        low: &mut Lowering<'_>,
        (drives, starts_of_state): (&[Drive], &[f64]),
        constants: &[f64],
        request: &mut Request,
    ) -> Option<(Vec<LoopInfo>, bool)> {
        if self.groups.is_empty() {
            return Some((Vec::new(), false));
        }
        let mut given = Places::of_state(low, drives, (constants, starts_of_state))?;
        let (mut values_of, mut relative, mut around) = (Vec::new(), Vec::new(), Vec::new());
        let (mut carried, mut signs) = (Vec::new(), Vec::new());
        for (number, group) in self.groups.iter().enumerate() {
            let Some(closed) = &group.closed else {
                self.report(low, group, |name| {
                    format!("the loop `{name}` is closed by iteration, and in a scene with coordinates only loops with a closed form can be in this version of Assur")
                }, "state the linkage by links of two, or run it in a scene of its own");
                return None;
            };
            let starts = starts(low, &given, group)?;
            let mode = Symbol::Mode(number as u32);
            let Some((sign, values)) = self.assembly(&low.graph, closed, &given, mode, &starts)
            else {
                self.report(
                    low,
                    group,
                    |name| format!("the loop `{name}` does not close where the motion begins"),
                    "change the dimensions or the start values, or say with `~` where the drivers start",
                );
                return None;
            };
            signs.push(sign);
            for (index, value) in values {
                let turns = starts.iter().find(|one| one.0 == index && self.angles[index]);
                let turns = turns.map_or(0.0, |(_, start)| ((start - value) / TAU).round());
                given.dependents[index] = value + turns * TAU;
            }
            let chosen = Map::from_iter([(mode, low.graph.number(sign))]);
            let turns = |slot: Slot| closed.values.iter().any(|one| one.0 == slot);
            around.extend(starts.iter().filter(|one| turns(Slot::Cosine(one.0))).copied());
            for (slot, value) in &closed.values {
                values_of.push((*slot, low.graph.substitute(&[*value], &chosen)[0]));
            }
            if let Some(links) = &closed.links {
                let mut links = links.clone();
                for unit in &mut links.units {
                    let chosen = low.graph.substitute(&unit[..], &chosen);
                    unit.copy_from_slice(&chosen);
                }
                let at = links.directions.map(|one| given.evaluate(low, one.argument));
                relative.push((links, at));
            }
            if low.graph.as_number(closed.margin).is_none() {
                request.results.margins.push(closed.margin);
                carried.push(self.carried_info(group));
            }
        }
        given.check_starts(low)?;
        let may_stop = !carried.is_empty() && self.may_stop(low, given, &signs);
        put_in(low, (&values_of, &relative), &around, request);
        Some((carried, may_stop))
    }

    /// Reports a group at the first of its equations.
    fn report(
        &self,
        low: &mut Lowering<'_>,
        group: &Group,
        message: impl Fn(&str) -> String,
        hint: &str,
    ) {
        let place = &self.equations[group.equations[0]];
        let report = Diagnostic::error(place.span, message(&place.name));
        low.diagnostics.push(report.hint(hint));
    }

    /// The assembly mode of a group that comes closest to the declared start values, and its values, if it assembles.
    fn assembly(
        &self,
        graph: &Graph,
        closed: &Closed,
        given: &Places,
        mode: Symbol,
        starts: &[(usize, f64)],
    ) -> Option<(f64, Vec<(usize, f64)>)> {
        let tried = [1.0, -1.0].map(|sign| {
            let values = solved(graph, closed, given, (mode, sign));
            (self.distance(&values, starts), sign, values)
        });
        let [first, second] = tried;
        let (distance, sign, values) = match second.0 < first.0 {
            true => second,
            false => first,
        };
        distance.is_finite().then_some((sign, values))
    }

    /// What a group says of itself: the names of all its equations.
    fn carried_info(&self, group: &Group) -> LoopInfo {
        LoopInfo { name: self.names(group), ..self.loop_info(group.equations[0]) }
    }

    /// The names of the equations of a group.
    pub fn names(&self, group: &Group) -> String {
        let names = group.equations.iter();
        let names: Vec<&str> = names.map(|index| self.equations[*index].name.as_str()).collect();
        names.join(", ")
    }

    /// How far values are from the declared ones; angles are the same after a turn.
    fn distance(&self, values: &[(usize, f64)], starts: &[(usize, f64)]) -> f64 {
        let difference = |(index, start): &(usize, f64)| {
            let value = values.iter().find(|one| one.0 == *index);
            let difference = value.map_or(f64::NAN, |one| one.1 - start);
            match self.angles[*index] {
                true => 2.0 * (difference / 2.0).sin(),
                false => difference,
            }
        };
        let squares: f64 = starts.iter().map(|one| difference(one).powi(2)).sum();
        match squares.is_nan() {
            true => f64::INFINITY,
            false => squares,
        }
    }
}

/// Puts closed forms in: of coordinates, and of the directions of links that are sums of them, which are at these angles at
/// the start. Cosine and sine of an angle are those of its link, never those of the angle. `starts` says of the angles
/// where they start.
fn put_in(
    low: &mut Lowering<'_>,
    (values, relative): (&[(Slot, Expression)], &[(Links, [f64; 2])]),
    starts: &[(usize, f64)],
    request: &mut Request,
) {
    let graph = &mut low.graph;
    let symbols: Vec<_> = (0..low.names.dependents.len() as u32).map(Symbol::Dependent).collect();
    let (mut calls, mut units, mut angles_of) = (Map::default(), Vec::new(), Map::default());
    for (group, (links, at)) in relative.iter().enumerate() {
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
    let (slots, values): (Vec<_>, Vec<_>) = values.iter().copied().unzip();
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
    for &(index, start) in starts {
        let pair = [Symbol::Argument(2 * index as u32), Symbol::Argument(2 * index as u32 + 1)];
        let angle = match angles_of.get(&index) {
            Some(angle) => *angle,
            None => around(graph, pair, start),
        };
        request.bindings.insert(Symbol::Dependent(index as u32), angle);
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

/// Where the dependent coordinates of a group are declared to start.
fn starts(low: &mut Lowering<'_>, given: &Places, group: &Group) -> Option<Vec<(usize, f64)>> {
    let names = low.names;
    let mut starts = Vec::new();
    for index in &group.unknowns {
        let declared = &names.dependents[*index];
        let Some(term) = &declared.what.start else {
            let message = format!("nothing says where `{}` starts", declared.name.text);
            let hint = match names.bound.contains_key(index) {
                true => {
                    "closures determine it, and its start value says how the links are put together"
                }
                false => "write roughly where: `dependent psi ~ 30 deg;`",
            };
            low.diagnostics.push(Diagnostic::error(declared.name.span, message).hint(hint));
            return None;
        };
        let start = match names.bound.contains_key(index) {
            true => {
                let (value, _) = low.scalar(term)?;
                given.evaluate(low, value)
            }
            false => low.fixed(term)?.0,
        };
        starts.push((*index, start));
    }
    Some(starts)
}

/// The dependent coordinates that a group closes, on one assembly mode.
pub(super) fn solved(
    graph: &Graph,
    closed: &Closed,
    given: &Places,
    (mode, sign): (Symbol, f64),
) -> Vec<(usize, f64)> {
    let of = |symbol: Symbol| match symbol == mode {
        true => sign,
        false => given.of(symbol),
    };
    let values: Vec<Expression> = closed.values.iter().map(|one| one.1).collect();
    let numbers = graph.evaluate(&values, &of);
    let pairs = closed.values.iter().zip(numbers);
    pairs
        .filter_map(|((slot, _), number)| match slot {
            Slot::Value(index) => Some((*index, number)),
            _ => None,
        })
        .collect()
}
