//! Which of its assembly modes a linkage is on, where it is carried along: the one that its declared start values are nearest to.

use super::{Closed, Group, Linkage, Places, Slot};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Function, Graph, Map, Relation, Symbol};
use crate::lower::Lowering;

impl Linkage {
    /// The assembly mode of a group that comes closest to the declared start values, and its values, if it assembles.
    pub fn assembly(
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

/// Where the dependent coordinates of a group are declared to start; one at least has to be.
pub fn starts(low: &mut Lowering<'_>, group: &Group) -> Option<Vec<(usize, Expression)>> {
    let names = low.names;
    let mut starts = Vec::new();
    for index in &group.unknowns {
        let declared = &names.dependents[*index];
        let Some(term) = &declared.what.start else { continue };
        let (value, _) = match names.bound.contains_key(index) {
            true => low.scalar(term)?,
            false => low.start(term)?,
        };
        starts.push((*index, value));
    }
    if starts.is_empty()
        && let Some(index) = group.unknowns.first()
    {
        let declared = &names.dependents[*index];
        let message = format!("nothing says where `{}` starts", declared.name.text);
        let hint = match names.bound.contains_key(index) {
            true => {
                "closures determine it, and its start value says how the links are put together"
            }
            false => "write roughly where: `dependent psi ~ 30 deg;`",
        };
        low.diagnostics.push(Diagnostic::error(declared.name.span, message).hint(hint));
        return None;
    }
    Some(starts)
}

/// What moves, where the motion begins, by the constants.
#[derive(Default)]
pub struct Begin {
    dependents: Map<Symbol, Expression>,
}

impl Begin {
    /// That the declared start values are no nearer to the other assembly mode of a group, where they follow from constants; and
    /// which of these say it.
    pub fn stays(
        &mut self,
        low: &mut Lowering<'_>,
        (linkage, closed, given): (&Linkage, &Closed, &Places),
        (mode, sign): (Symbol, f64),
        starts: &[(usize, Expression)],
    ) -> Option<(Expression, Vec<usize>)> {
        let values = closed.values.iter().filter_map(|(slot, value)| match slot {
            Slot::Value(index) => Some((*index, *value)),
            _ => None,
        });
        let (indices, values): (Vec<_>, Vec<_>) = values.unzip();
        let on = |low: &mut Lowering<'_>, sign: f64, list: &[Expression]| {
            let mut at = self.dependents.clone();
            at.insert(mode, low.graph.number(sign));
            for symbol in low.graph.symbols(list) {
                let is_kept = matches!(symbol, Symbol::Parameter(_)) || at.contains_key(&symbol);
                if !is_kept {
                    at.insert(symbol, low.graph.number(given.of(symbol)));
                }
            }
            low.graph.substitute(list, &at)
        };
        let (kept, other) = (on(low, sign, &values), on(low, -sign, &values));
        let (places, starts): (Vec<_>, Vec<_>) = starts.iter().copied().unzip();
        let starts = on(low, sign, &starts);
        let symbols = indices.iter().map(|index| Symbol::Dependent(*index as u32));
        self.dependents.extend(symbols.zip(kept.iter().copied()));
        let said = constants(&low.graph, &starts);
        if said.is_empty() {
            return None;
        }
        let also = constants(&low.graph, &values);
        let alone: Vec<_> = said.iter().copied().filter(|one| !also.contains(one)).collect();
        let graph = &mut low.graph;
        let distances = [kept, other].map(|values| {
            let terms = places.iter().zip(&starts).filter_map(|(index, start)| {
                let place = indices.iter().position(|one| one == index)?;
                let apart = graph.sub(values[place], *start);
                let apart = match linkage.angles[*index] {
                    true => {
                        let half = graph.scale(0.5, apart);
                        let sine = graph.call(Function::Sin, &[half]);
                        graph.scale(2.0, sine)
                    }
                    false => apart,
                };
                Some(graph.powi(apart, 2))
            });
            let terms: Vec<_> = terms.collect();
            graph.sum(&terms)
        });
        let nearer = graph.compare(Relation::Less, distances[1], distances[0]);
        Some((graph.not(nearer), if alone.is_empty() { said } else { alone }))
    }
}

/// The constants that expressions depend on.
fn constants(graph: &Graph, expressions: &[Expression]) -> Vec<usize> {
    let symbols = graph.symbols(expressions).into_iter();
    let constants = symbols.filter_map(|symbol| match symbol {
        Symbol::Parameter(index) => Some(index as usize),
        _ => None,
    });
    constants.collect()
}

/// The dependent coordinates that a group closes, on one assembly mode.
pub fn solved(
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
