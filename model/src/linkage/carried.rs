//! A linkage that is carried along by a motion: its drivers move in time, and what it does acts on coordinates that move by
//! themselves. Its dependent coordinates are then functions of the time, put in as closed forms.

use super::{Closed, Group, Linkage, Slot};
use crate::checked::LoopInfo;
use crate::declare::Drive;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::lower::Lowering;
use crate::program::Request;
use crate::resolve::Names;

impl Linkage {
    /// Binds the dependent coordinates to their closed forms, on the assembly modes that the declared start values pick
    /// with these values of the constants. Asks for the margins of the groups that may fail to close, and names these.
    pub fn carry(
        &self,
        low: &mut Lowering<'_>,
        names: &Names,
        drives: &[Drive],
        constants: &[f64],
        request: &mut Request,
    ) -> Option<Vec<LoopInfo>> {
        let mut given = Given::at_start(low, names, drives, constants)?;
        let mut carried = Vec::new();
        for (number, group) in self.groups.iter().enumerate() {
            let Some(closed) = &group.closed else {
                self.report(low, group, |name| {
                    format!("the loop `{name}` is closed by iteration, and beside coordinates that move by themselves only loops with a closed form can be")
                }, "state the linkage by links of two, or run it in a scene of its own");
                return None;
            };
            let starts = starts(low, names, group)?;
            let mode = Symbol::Mode(number as u32);
            let Some((sign, values)) = self.assembly(&low.graph, closed, &given, mode, &starts)
            else {
                self.report(
                    low,
                    group,
                    |name| format!("the loop `{name}` does not close where the drivers start"),
                    "change the dimensions, or say with `~` where the drivers start",
                );
                return None;
            };
            for (index, value) in values {
                given.dependents[index] = value;
            }
            let chosen = Map::from_iter([(mode, low.graph.number(sign))]);
            for (slot, value) in &closed.values {
                if let Slot::Value(index) = slot {
                    let fixed = low.graph.substitute(&[*value], &chosen)[0];
                    let symbol = Symbol::Dependent(*index as u32);
                    request.bindings.insert(symbol, fixed);
                }
            }
            if low.graph.as_number(closed.margin).is_none() {
                request.results.margins.push(closed.margin);
                carried.push(self.carried_info(group));
            }
        }
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

    /// The assembly mode of a group that comes closest to the declared start values, and its values, if it assembles.
    fn assembly(
        &self,
        graph: &Graph,
        closed: &Closed,
        given: &Given,
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
        let names = group.equations.iter();
        let names: Vec<&str> = names.map(|index| self.equations[*index].name.as_str()).collect();
        LoopInfo { name: names.join(", "), ..self.loop_info(group.equations[0]) }
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
fn starts(low: &mut Lowering<'_>, names: &Names, group: &Group) -> Option<Vec<(usize, f64)>> {
    let mut starts = Vec::new();
    for index in &group.unknowns {
        let declared = &names.dependents[*index];
        let Some(term) = &declared.what.start else {
            let message = format!("nothing says where `{}` starts", declared.name.text);
            low.diagnostics.push(
                Diagnostic::error(declared.name.span, message)
                    .hint("write roughly where: `dependent psi ~ 30 deg;`"),
            );
            return None;
        };
        starts.push((*index, low.fixed(term)?.0));
    }
    Some(starts)
}

/// The dependent coordinates that a group closes, on one assembly mode.
fn solved(
    graph: &Graph,
    closed: &Closed,
    given: &Given,
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

/// What is known where the drivers start.
struct Given {
    constants: Vec<f64>,
    drivers: Vec<f64>,
    dependents: Vec<f64>,
}

impl Given {
    /// Constants and drivers; no coordinate is known yet.
    fn at_start(
        low: &mut Lowering<'_>,
        names: &Names,
        drives: &[Drive],
        constants: &[f64],
    ) -> Option<Self> {
        let dependents = vec![f64::NAN; names.dependents.len()];
        let mut given = Self { constants: constants.to_vec(), drivers: Vec::new(), dependents };
        for (driver, drive) in names.drivers.iter().zip(drives) {
            let start = match (&driver.what.start, drive.position) {
                (Some(term), _) => low.fixed(term)?.0,
                (None, Some(position)) => {
                    low.graph.evaluate(&[position], &|symbol| given.of(symbol))[0]
                }
                (None, None) => f64::NAN,
            };
            given.drivers.push(start);
        }
        Some(given)
    }

    fn of(&self, symbol: Symbol) -> f64 {
        let at = |list: &[f64], index: u32| list.get(index as usize).copied().unwrap_or(f64::NAN);
        match symbol {
            Symbol::Parameter(index) => at(&self.constants, index),
            Symbol::Driver(index) => at(&self.drivers, index),
            Symbol::Dependent(index) => at(&self.dependents, index),
            Symbol::Time => 0.0,
            _ => f64::NAN,
        }
    }
}
