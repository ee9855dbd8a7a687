//! A linkage that is carried along by a motion: its drivers move in time, and what it does acts on coordinates that move by
//! themselves. Its dependent coordinates are then functions of the time, put in as closed forms.

use super::forms::Forms;
use super::{Closed, Group, Linkage, Places, Slot};
use crate::checked::LoopInfo;
use crate::declare::Drive;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::lower::Lowering;
use crate::program::Request;
use std::f64::consts::TAU;

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
        let mut forms = Forms::default();
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
            forms.starts.extend(starts.iter().filter(|one| turns(Slot::Cosine(one.0))).copied());
            for (slot, value) in &closed.values {
                forms.values.push((*slot, low.graph.substitute(&[*value], &chosen)[0]));
            }
            if let Some(links) = &closed.links {
                let mut links = links.clone();
                for unit in &mut links.units {
                    let chosen = low.graph.substitute(&unit[..], &chosen);
                    unit.copy_from_slice(&chosen);
                }
                let at = links.directions.map(|one| given.evaluate(low, one.argument));
                forms.relative.push((links, at));
            }
            if low.graph.as_number(closed.margin).is_none() {
                request.results.margins.push(closed.margin);
                carried.push(self.carried_info(group));
            }
        }
        given.check_starts(low)?;
        let turning = self.turn(low, &given, &signs);
        let crank = turning.as_ref().map(|(crank, _)| *crank);
        let may_stop = !carried.is_empty() && self.may_stop(low, crank);
        if let Some((crank, turns)) = turning {
            forms.crank = Some((crank, given.of(crank)));
            forms.turns = turns;
        }
        forms.put_in(low, request);
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
