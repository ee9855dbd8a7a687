//! Values of everything given where a motion begins.

use crate::declare::Drive;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::lower::Lowering;
use crate::token::Span;

/// Part of a start value that its rounding may change; less is not worth a word.
const ROUNDED: f64 = 1e-4;
const EXACT: f64 = 1e-14;

/// Values of everything given where a motion begins; what is not known is no number.
#[derive(Clone)]
pub struct Places {
    /// Constants.
    pub constants: Vec<f64>,
    /// Positions of the drivers.
    pub drivers: Vec<f64>,
    /// The state vector: coordinates, their speeds, states.
    pub state: Vec<f64>,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Dependent coordinates.
    pub dependents: Vec<f64>,
}

impl Places {
    /// With constants and a state; drivers where they say that they start, else where they are at time 0.
    pub fn of_state(
        low: &mut Lowering<'_>,
        drives: &[Drive],
        (constants, state): (&[f64], &[f64]),
    ) -> Option<Self> {
        let names = low.names;
        let mut places = Self {
            constants: constants.to_vec(),
            drivers: Vec::new(),
            state: state.to_vec(),
            coordinates: names.coordinates.len(),
            dependents: vec![f64::NAN; names.dependents.len()],
        };
        for (driver, drive) in names.drivers.iter().zip(drives) {
            let start = match (&driver.what.start, drive.position) {
                (Some(term), _) => low.fixed(term)?.0,
                (None, Some(position)) => places.evaluate(low, position),
                (None, None) => f64::NAN,
            };
            places.drivers.push(start);
        }
        Some(places)
    }

    /// The value of an expression there.
    pub fn evaluate(&self, low: &Lowering<'_>, expression: Expression) -> f64 {
        low.graph.evaluate(&[expression], &|symbol| self.of(symbol))[0]
    }

    /// The value of a symbol there.
    pub fn of(&self, symbol: Symbol) -> f64 {
        let at = |list: &[f64], index: usize| list.get(index).copied().unwrap_or(f64::NAN);
        match symbol {
            Symbol::Parameter(index) => at(&self.constants, index as usize),
            Symbol::Driver(index) => at(&self.drivers, index as usize),
            Symbol::Coordinate(index) => at(&self.state, index as usize),
            Symbol::Speed(index) => at(&self.state, self.coordinates + index as usize),
            Symbol::State(index) => at(&self.state, 2 * self.coordinates + index as usize),
            Symbol::Dependent(index) => at(&self.dependents, index as usize),
            Symbol::Time => 0.0,
            _ => f64::NAN,
        }
    }

    /// Compares the start values of coordinates that closures determine with what the closures say: what differs by the
    /// rounding of a data sheet is corrected and noted, anything more refused. Rates as well.
    pub fn check_starts(&self, low: &mut Lowering<'_>) -> Option<()> {
        let before = low.diagnostics.error_count();
        let names = low.names;
        for (index, declared) in &names.bound {
            let symbols = [Symbol::Dependent(*index as u32), Symbol::DependentRate(*index as u32)];
            let unit = low.unit_of(symbols[0]).map_or_else(String::new, |unit| unit.symbol);
            let factor = low.unit_of(symbols[0]).map_or(1.0, |unit| unit.scale());
            let terms = [&declared.start, &declared.start_rate];
            for (place, (symbol, term)) in symbols.into_iter().zip(terms).enumerate() {
                let Some((stated, _)) = term.as_ref().and_then(|term| low.scalar(term)) else {
                    continue;
                };
                let symbol = low.graph.symbol(symbol);
                let closed = low.written_out(&[symbol])[0];
                let [stated, closed] = [stated, closed].map(|one| self.evaluate(low, one) / factor);
                let name = &names.dependents[*index].name;
                let (name, unit) = match place {
                    0 => (name.text.clone(), unit.clone()),
                    _ => (format!("dot({})", name.text), format!("{unit}/s")),
                };
                let span = term.as_ref().map(|term| term.span).unwrap_or_default();
                compare(low, (&name, &unit), (stated, closed), span);
            }
        }
        (low.diagnostics.error_count() == before).then_some(())
    }
}

/// Notes that a start value is corrected, or refuses it.
pub fn compare(
    low: &mut Lowering<'_>,
    (name, unit): (&str, &str),
    (stated, closed): (f64, f64),
    span: Span,
) {
    let off = (stated - closed).abs();
    let size = stated.abs().max(closed.abs());
    if off <= EXACT * size.max(1.0) {
        return;
    }
    let message = format!(
        "`{name}` cannot start at {stated:.9} {unit}: the closures say {closed:.9} {unit}, {off:.1e} {unit} away"
    );
    let report = match off <= ROUNDED * size.max(1.0) {
        true => Diagnostic::note(span, message.replace("cannot start", "does not quite start")),
        false => Diagnostic::error(span, message)
            .hint("correct it, or leave it to the closures: `dependent` with a rough value"),
    };
    low.diagnostics.push_once(format!("start of {name}"), report);
}
