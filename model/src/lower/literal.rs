//! Numbers, and which of them keep a scene from being stated in other units.
//!
//! The constants of a scene can be given in millimetres, grams and milliseconds; a `3 mm` inside an equation cannot. So
//! the first such number is kept for everything that is lowered, abbreviations and functions with what they refer to.

use super::{Kind, Lowering, Typed};
use crate::checked::LiteralInfo;
use crate::diagnostic::Diagnostic;
use crate::syntax::print;
use crate::syntax::tree::{Term, UnitTerm};
use crate::unit;

impl Lowering<'_> {
    /// Lowers what says nothing of the motion (a range, a task, a place in the motion): its numbers may have units.
    pub fn aside<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        self.apart(work).0
    }

    /// Lowers something by itself, and gives the first number in it that depends on the units.
    pub(super) fn apart<T>(
        &mut self,
        work: impl FnOnce(&mut Self) -> T,
    ) -> (T, Option<LiteralInfo>) {
        let outer = self.literal.take();
        let done = work(self);
        (done, std::mem::replace(&mut self.literal, outer))
    }

    /// Notes a number that depends on the units, if it is the first of the file.
    pub(super) fn note(&mut self, literal: Option<LiteralInfo>) {
        let place = |one: &Option<LiteralInfo>| one.as_ref().map_or(u32::MAX, |one| one.span.first);
        if place(&literal) < place(&self.literal) {
            self.literal = literal;
        }
    }

    pub(super) fn literal(&mut self, value: f64, unit: Option<&UnitTerm>, term: &Term) -> Typed {
        let (value, kind) = match unit {
            None if value == 0.0 => (value, Kind::Any),
            None => (value, Kind::NUMBER),
            Some(written) if self.is_factor(written) => {
                let factor = &written.factors[0].0.text;
                let message = format!("`{factor}` is a quantity of the file, and no unit");
                let report = Diagnostic::error(written.span, message);
                return self.error(report.hint(format!("a product needs `*`: `{value}*{factor}`")));
            }
            Some(written) => match unit::resolve(written, self.diagnostics) {
                Some(unit) => {
                    // Zero is zero in all units.
                    if value != 0.0 && unit.dimension.is_mechanical() {
                        self.note(Some(LiteralInfo { text: print::term(term), span: term.span }));
                    }
                    (unit.to_si(value), Kind::Of(unit.dimension))
                }
                None => return Typed::Wrong,
            },
        };
        Typed::scalar(self.graph.number(value), kind)
    }

    /// Whether what stands behind a number is a quantity, and the `*` before it is missing.
    fn is_factor(&self, written: &UnitTerm) -> bool {
        let [(name, (1, 1))] = written.factors.as_slice() else {
            return false;
        };
        !unit::is_unit(&name.text) && self.names.table.contains_key(&name.text)
    }
}
