//! Constants that follow from a condition while designs are sought.
//!
//! `solve for x, y: left = right;` is a polynomial in `x` and `y` whose coefficients move, and the constants are those for which
//! the squares of its values along the way add up to least. One of them may stand in powers or products with the others, and one
//! in a term alone that does not move: the rest is linear.

use crate::checked::{SolvedInfo, TermInfo};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::linkage::Linkage;
use crate::lower::Lowering;
use crate::syntax::print;
use crate::syntax::tree::{Among, Name, Scene, SceneItem, Varied};
use crate::token::Span;
use crate::unroll::target_name;

/// A condition that constants follow from.
pub struct Condition {
    unknowns: Vec<(Name, usize)>,
    terms: Vec<TermInfo>,
    /// Coefficients, in the order of the terms.
    coefficients: Vec<Expression>,
    text: String,
    place: Span,
}

/// The constants that a scene solves for.
pub fn constants(scene: &Scene) -> impl Iterator<Item = &Varied> {
    scene.items.iter().flat_map(|item| match item {
        SceneItem::Solve { constants, .. } => constants.as_slice(),
        _ => &[],
    })
}

/// Lowers the condition of a scene, and adds its coefficients to what is looked at.
pub fn read(
    scene: &Scene,
    looked_at: &mut Vec<Expression>,
    low: &mut Lowering<'_>,
) -> Option<Condition> {
    let mut all = scene.items.iter().filter_map(|item| match item {
        SceneItem::Solve { constants, left, right } => Some((constants, left, right)),
        _ => None,
    });
    let (constants, left, right) = all.next()?;
    let place = left.span.to(right.span);
    if let Some((_, second, _)) = all.next() {
        let report = Diagnostic::error(second.span, "constants follow from one condition");
        low.diagnostics.push(report.related(place, "the first one"));
        return None;
    }
    if !low.names.coordinates.is_empty() || !low.names.states.is_empty() {
        let message =
            "constants follow from a condition on positions, and this scene moves by itself";
        low.diagnostics.push(Diagnostic::error(place, message).hint("vary them"));
        return None;
    }
    let (residuals, _) = low.aside(|low| low.balance(left, right))?;
    let [residual] = residuals[..] else {
        let report = Diagnostic::error(place, "a condition to be solved is between two numbers");
        let hint = "of points take the square of their distance: `inner(C - D, C - D) = l^2`";
        low.diagnostics.push(report.hint(hint));
        return None;
    };
    let mut unknowns = Vec::new();
    for one in constants {
        let name = target_name(&one.constant, low.diagnostics)?;
        // What is no constant is reported where it is varied.
        let mut known = low.names.constants.iter();
        let index = known.position(|constant| constant.name.text == name.text)?;
        if matches!(one.among, Among::Values(_)) {
            let message = format!("`{}` is solved for, and so has a range", name.text);
            let report = Diagnostic::error(name.span, message);
            low.diagnostics.push(report.hint("vary what is chosen from single values"));
            return None;
        }
        unknowns.push((name, index));
    }
    let symbols: Vec<Symbol> =
        unknowns.iter().map(|(_, index)| Symbol::Parameter(*index as u32)).collect();
    let Some(polynomial) = low.graph.polynomial(residual, &symbols) else {
        let message = "this is no polynomial in the constants that are solved for, or a long one";
        let hint = "squares of lengths are polynomials, lengths and angles are not";
        low.diagnostics.push(Diagnostic::error(place, message).hint(hint));
        return None;
    };
    let (mut terms, mut coefficients) = (Vec::new(), Vec::new());
    for (powers, coefficient) in polynomial {
        let symbols = low.graph.symbols(&[coefficient]);
        let is_place = |symbol: &Symbol| {
            matches!(symbol, Symbol::Driver(_) | Symbol::Dependent(_) | Symbol::Time)
        };
        let is_constant = |symbol: &Symbol| matches!(symbol, Symbol::Parameter(_));
        if !symbols.iter().all(|symbol| is_place(symbol) || is_constant(symbol)) {
            let report = Diagnostic::error(place, "this speaks of more than positions");
            let hint = "constants follow from a condition on the positions of a linkage";
            low.diagnostics.push(report.hint(hint));
            return None;
        }
        let moves = symbols.iter().any(is_place);
        terms.push(TermInfo { quantity: looked_at.len(), powers, moves });
        looked_at.push(coefficient);
        coefficients.push(coefficient);
    }
    let text = format!("{} = {}", print::term(left), print::term(right));
    Some(Condition { unknowns, terms, coefficients, text, place })
}

impl Condition {
    /// How the constants follow, these being the last of all that are varied.
    pub fn solved(
        self,
        varied: usize,
        linkage: &Linkage,
        low: &mut Lowering<'_>,
    ) -> Option<SolvedInfo> {
        let count = self.unknowns.len();
        let stands = |unknown: usize, moves: bool| {
            let mut terms = self.terms.iter();
            terms.any(|term| term.moves == moves && term.powers[unknown] > 0)
        };
        let mut free = None;
        for (unknown, (name, _)) in self.unknowns.iter().enumerate() {
            if stands(unknown, true) {
                continue;
            }
            let own = self.terms.iter().filter(|term| term.powers[unknown] > 0);
            let alone =
                own.clone().all(|term| term.powers.iter().sum::<u32>() == term.powers[unknown]);
            let message = match (own.count(), free) {
                (0, _) => "this does not say what it is",
                (1, None) if alone => {
                    free = Some(unknown);
                    continue;
                }
                (1, Some(_)) if alone => {
                    "its terms do not move, nor do those of another: nothing tells the two apart"
                }
                _ => {
                    "its terms do not move, and there is more than one, or it is multiplied by others"
                }
            };
            let report = Diagnostic::error(
                name.span,
                format!("`{}` does not follow from the condition", name.text),
            );
            low.diagnostics.push(report.related(self.place, message).hint("vary it"));
            return None;
        }
        let stays = |term: &TermInfo| !term.moves && term.powers.iter().any(|power| *power > 0);
        if free.is_none()
            && let Some(term) = self.terms.iter().find(|term| stays(term))
        {
            let unknown = term.powers.iter().position(|power| *power > 0).unwrap_or(0);
            let message = format!(
                "a term with `{}` does not move, and no unknown stands in such terms alone",
                self.unknowns[unknown].0.text
            );
            let hint = "solve for a length that makes up for it: `inner(C - D, C - D) = l^2`, for `l` as well";
            low.diagnostics.push(Diagnostic::error(self.place, message).hint(hint));
            return None;
        }
        let is_linear = |without: Option<usize>| {
            let degree = |term: &TermInfo| {
                let all = term.powers.iter().enumerate().filter(|one| Some(one.0) != without);
                all.map(|one| one.1).sum::<u32>()
            };
            self.terms.iter().filter(|term| term.moves).all(|term| degree(term) <= 1)
        };
        let scanned = match is_linear(None) {
            true => None,
            false => match (0..count).find(|unknown| is_linear(Some(*unknown))) {
                Some(unknown) => Some(unknown),
                None => {
                    let message = "more than one constant enters this in powers or products";
                    let hint = "vary one of them: all that are solved for but one enter terms that move linearly";
                    low.diagnostics.push(Diagnostic::error(self.place, message).hint(hint));
                    return None;
                }
            },
        };
        let groups = self.groups(linkage, low)?;
        let unknowns = (varied - count..varied).collect();
        Some(SolvedInfo { text: self.text, unknowns, terms: self.terms, scanned, free, groups })
    }

    /// The groups of loops that the coefficients depend on, each behind those that it depends on.
    fn groups(&self, linkage: &Linkage, low: &mut Lowering<'_>) -> Option<Vec<usize>> {
        let mut groups = Vec::new();
        let mut waiting = self.coefficients.clone();
        while let Some(next) = waiting.pop() {
            for symbol in low.graph.symbols(&[next]) {
                let own = self
                    .unknowns
                    .iter()
                    .find(|(_, index)| symbol == Symbol::Parameter(*index as u32));
                let needed = match symbol {
                    Symbol::Dependent(index) => {
                        let mut all = linkage.groups.iter();
                        all.position(|group| group.unknowns.contains(&(index as usize)))
                    }
                    _ => None,
                };
                let (message, hint) = match (own, needed.map(|group| &linkage.groups[group].closed))
                {
                    (Some((name, _)), _) => (
                        format!("this depends on `{}` through the loops as well", name.text),
                        "say it by points that do not: by where a joint is, and where it has to be",
                    ),
                    (None, Some(None)) => (
                        "this depends on loops that are closed by iteration".to_owned(),
                        "state the linkage by links of two",
                    ),
                    _ => {
                        if let Some(group) = needed.filter(|group| !groups.contains(group)) {
                            groups.push(group);
                            let closed = linkage.groups[group].closed.iter();
                            waiting.extend(
                                closed.flat_map(|closed| closed.values.iter().map(|one| one.1)),
                            );
                        }
                        continue;
                    }
                };
                low.diagnostics.push(Diagnostic::error(self.place, message).hint(hint));
                return None;
            }
        }
        groups.sort_unstable();
        Some(groups)
    }
}
