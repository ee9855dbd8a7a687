//! What is stored between the stages of a program: computed when the values are bound, or once for each instant.

use std::collections::BTreeSet;

use super::{OperationKind, Program, Stage, Value};

/// The values that are stored between stages.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Staging {
    /// What is stored when the values are bound.
    pub prepared: BTreeSet<Value>,
    /// What is stored for each instant.
    pub timed: BTreeSet<Value>,
}

/// When nothing that an instant stores is wanted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Idle {
    /// Whether it never is.
    pub always: bool,
    /// While which switching surface, by index, is on which side, 1 or −1.
    pub sides: Vec<(u32, f64)>,
}

impl Program {
    /// What is stored between stages.
    pub fn staging(&self) -> Staging {
        Staging { prepared: self.frontier(&self.asked(), Stage::Instant), timed: self.timed() }
    }

    /// All that is asked of bound values.
    fn asked(&self) -> Vec<Value> {
        let results = &self.results;
        let rest = [
            &results.outputs,
            &results.drivers,
            &results.mass,
            &results.energy,
            &results.measured,
            &results.measures,
            &results.margins,
            &results.points,
        ];
        let evaluated = results.derivative.iter().copied().chain(results.slopes());
        let asked = evaluated
            .chain(rest.into_iter().flatten().copied())
            .chain(results.closing.all())
            .chain(results.events.iter().flat_map(|event| event.all()));
        asked.collect()
    }

    /// What an instant stores: what the derivative needs of the time, and the functions of the time that the Jacobian
    /// needs beside it. The rest of the Jacobian is computed where it is asked for, so that a plain run does not pay for
    /// it; so is all that events need.
    ///
    /// Of a linkage: what closing needs of the drivers, and the functions of them that the rest needs beside it.
    fn timed(&self) -> BTreeSet<Value> {
        let results = &self.results;
        let closing = &results.closing;
        let slopes = closing.slopes.iter().map(|entry| entry.2);
        let mut first: Vec<Value> = results.derivative.clone();
        first.extend(closing.residuals.iter().copied().chain(slopes));
        for closed in closing.groups.iter().flatten() {
            first.extend(closed.values.iter().map(|entry| entry.1).chain([closed.sine]));
        }
        let mut timed = self.frontier(&first, Stage::State);
        timed.retain(|value| self.stage(*value) == Stage::Instant);
        let mut open: Vec<Value> = results.slopes().collect();
        if !closing.cosines.is_empty() || closing != &Default::default() {
            open.extend(results.outputs.iter().chain(&results.measured).copied());
            open.extend(closing.all());
        }
        let mut seen: BTreeSet<Value> = BTreeSet::new();
        while let Some(value) = open.pop() {
            if !seen.insert(value) {
                continue;
            }
            let kind = self.kind(value);
            if self.stage(value) < Stage::Instant || timed.contains(&value) {
                continue;
            }
            let function = matches!(kind, OperationKind::Call(..) | OperationKind::Input(_));
            if function && self.stage(value) == Stage::Instant {
                timed.insert(value);
            } else {
                open.extend(kind.operands());
            }
        }
        timed
    }

    /// When nothing that an instant stores is wanted: where a branch that reads the time is not the one that holds.
    pub fn idle(&self) -> Idle {
        let results = &self.results;
        let rates: Vec<Value> =
            results.derivative.iter().copied().chain(results.slopes()).collect();
        let is_idle = |side: Option<(u32, f64)>| {
            let resting = self.resting(&rates, side);
            resting.into_iter().all(|value| self.stage(value) != Stage::Instant)
        };
        let surfaces = 0..self.surfaces.len() as u32;
        let sides = surfaces.flat_map(|surface| [(surface, -1.0), (surface, 1.0)]);
        Idle { always: is_idle(None), sides: sides.filter(|side| is_idle(Some(*side))).collect() }
    }
}
