//! What is found of a formula over a range: `integral`, `root`, `solve`, `peak`, `lowest` and where these are.

use super::{Kind, Lowering, Typed};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Search, Symbol};
use crate::homogeneity::{agree, describe, disagreement, times};
use crate::syntax::print;
use crate::syntax::tree::{Name, Term};

impl Lowering<'_> {
    pub(super) fn search(
        &mut self,
        name: &Name,
        variable: &Name,
        (from, to): (&Term, &Term),
        body: &Term,
        term: &Term,
    ) -> Typed {
        let (Some((low, low_kind)), Some((high, high_kind))) = (self.scalar(from), self.scalar(to))
        else {
            return Typed::Wrong;
        };
        let Some(range_kind) = agree(low_kind, high_kind) else {
            return self.error(disagreement(
                "the ends of the range are",
                (from.span, low_kind),
                (to.span, high_kind),
            ));
        };
        let range_kind = if range_kind == Kind::Any { Kind::NUMBER } else { range_kind };
        let x = Symbol::Argument(self.arguments);
        self.arguments += 1;
        let free = Typed::scalar(self.graph.symbol(x), range_kind);
        let mut scope = self.locals.last().cloned().unwrap_or_default();
        scope.insert(variable.text.clone(), free);
        self.locals.push(scope);
        let found = self.scalar(body);
        self.locals.pop();
        let Some((formula, kind)) = found else {
            return Typed::Wrong;
        };
        let range = (low, high);
        self.know_ends(x, range);
        match name.text.as_str() {
            "integral" => {
                let Some(product) = times(kind, range_kind) else {
                    let message = format!(
                        "the integral of {} over {} has no simple unit",
                        describe(kind.dimension()),
                        describe(range_kind.dimension())
                    );
                    return self.error(Diagnostic::error(body.span, message));
                };
                let (length, mean) = self.graph.integral(formula, x, range);
                self.graph.name_switch(mean, print::term(term));
                Typed::scalar(self.graph.mul(length, mean), product)
            }
            "peak" => Typed::scalar(self.highest(formula, x, range), kind),
            "lowest" => {
                let negated = self.graph.neg(formula);
                let value = self.highest(negated, x, range);
                Typed::scalar(self.graph.neg(value), kind)
            }
            "root" | "solve" => {
                if !self.graph.depends_on(formula, |symbol| symbol == x) {
                    let message =
                        format!("`{}` does not occur in what is solved for it", variable.text);
                    return self.error(Diagnostic::error(body.span, message));
                }
                let share = self.graph.found_between(Search::Root, formula, x, range);
                self.graph.name_switch(share, print::term(term));
                Typed::scalar(self.graph.between(range, share), range_kind)
            }
            "peak_at" => self.found_at(Search::HighestPlace, formula, x, range, range_kind),
            _ => {
                let negated = self.graph.neg(formula);
                self.found_at(Search::HighestPlace, negated, x, range, range_kind)
            }
        }
    }

    /// Knows what jumps or bends in a formula also where the place is counted from either end of the range.
    fn know_ends(&mut self, x: Symbol, (low, high): (Expression, Expression)) {
        let level = self.graph.symbol(Symbol::Bound(0));
        for place in self.graph.from_both_ends((low, high), level) {
            let put = |graph: &mut Graph, one| graph.at_place(one, x, place);
            self.written.substitute(&mut self.graph, x, &put);
        }
    }

    fn highest(
        &mut self,
        formula: Expression,
        x: Symbol,
        range: (Expression, Expression),
    ) -> Expression {
        self.graph.found_between(Search::Highest, formula, x, range)
    }

    fn found_at(
        &mut self,
        search: Search,
        formula: Expression,
        x: Symbol,
        range: (Expression, Expression),
        kind: Kind,
    ) -> Typed {
        let share = self.graph.found_between(search, formula, x, range);
        Typed::scalar(self.graph.between(range, share), kind)
    }
}
