//! A linkage that is carried along by a motion: its drivers move in time, and what it does acts on coordinates that move by
//! themselves. Its dependent coordinates are then functions of the time, put in as closed forms.

use super::assembly::{Begin, starts};
use super::forms::Forms;
use super::{Group, Linkage, Places, Slot};
use crate::checked::{LoopInfo, RequirementInfo};
use crate::declare::Drive;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Map, Symbol};
use crate::lower::Lowering;
use crate::program::Request;
use std::f64::consts::TAU;

/// What a motion carries along.
#[derive(Default)]
pub struct Carried {
    /// The groups that may fail to close.
    pub loops: Vec<LoopInfo>,
    /// Whether the motion may come to a dead point of one.
    pub may_stop: bool,
    /// That other values of the constants pick the same assembly modes.
    pub modes: Vec<RequirementInfo>,
}

impl Linkage {
    /// Binds the dependent coordinates to their closed forms, on the assembly modes that the declared start values pick
    /// with these values of the constants. Asks for the margins of the groups that may fail to close.
    pub fn carry(
        &self,
        low: &mut Lowering<'_>,
        (drives, starts_of_state): (&[Drive], &[f64]),
        constants: &[f64],
        request: &mut Request,
    ) -> Option<Carried> {
        let mut carried = Carried::default();
        if self.groups.is_empty() {
            return Some(carried);
        }
        let mut given = Places::of_state(low, drives, (constants, starts_of_state))?;
        let (mut forms, mut signs) = (Forms::default(), Vec::new());
        let mut begin = Begin::default();
        for (number, group) in self.groups.iter().enumerate() {
            let Some(closed) = &group.closed else {
                self.report(low, group, |name| {
                    format!("the loop `{name}` is closed by iteration, and in a scene with coordinates only loops with a closed form can be in this version of Assur")
                }, "state the linkage by links of two, or run it in a scene of its own");
                return None;
            };
            let declared = starts(low, group)?;
            let value = |start: &(usize, Expression)| (start.0, given.evaluate(low, start.1));
            let starts: Vec<_> = declared.iter().map(value).collect();
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
            let turns = |slot: Slot| closed.values.iter().any(|one| one.0 == slot);
            for (index, value) in values {
                let start = starts.iter().find(|one| one.0 == index).map_or(value, |one| one.1);
                let whole = if self.angles[index] { ((start - value) / TAU).round() } else { 0.0 };
                given.dependents[index] = value + whole * TAU;
                forms.starts.extend(turns(Slot::Cosine(index)).then_some((index, start)));
            }
            if let Some((condition, names)) =
                begin.stays(low, (self, closed, &given), (mode, sign), &declared)
            {
                request.results.requirements.push(condition);
                carried.modes.push(RequirementInfo {
                    text: "the assembly mode that the values of the file pick, which a scene with coordinates keeps".into(),
                    message: self.names(group),
                    names,
                });
            }
            let chosen = Map::from_iter([(mode, low.graph.number(sign))]);
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
                carried.loops.push(self.carried_info(group));
            }
        }
        given.check_starts(low)?;
        let turning = self.turn(low, &given, &signs);
        let crank = turning.as_ref().map(|(crank, _)| *crank);
        carried.may_stop = !carried.loops.is_empty() && self.may_stop(low, crank);
        if let Some((crank, turns)) = turning {
            forms.crank = Some((crank, given.of(crank)));
            forms.turns = turns;
        }
        forms.put_in(low, request);
        Some(carried)
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
}
