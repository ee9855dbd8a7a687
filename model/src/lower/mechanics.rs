//! What only the motion as a whole determines: forces of closures and of drivers, energies.

use std::ops::Range;

use super::{Kind, Lowering, Moved, Quantity, Typed, is_of_motion, second};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Function, Graph, Map, Node, Symbol};
use crate::homogeneity::over;
use crate::nearest::nearest;
use crate::resolve::Role;
use crate::syntax::print;
use crate::syntax::tree::{Name, Term, TermKind};
use crate::token::Span;

/// A closure by its name.
#[derive(Clone, Debug)]
pub struct Closure {
    /// Its name.
    pub name: String,
    /// Its scalar equations.
    pub equations: Range<usize>,
    /// Kind of its two sides.
    pub kind: Kind,
    /// Where it is, if it joins two places in the plane: what stands on its left side.
    pub place: Option<[Expression; 2]>,
}

/// What `energy(…)` may be asked for, in the order of [`Symbol::Energy`].
const ENERGIES: [&str; 3] = ["kinetic", "potential", "dissipation"];

/// What a length is never less than, so that it has a slope: beside it rounding is large, in SI units.
const NOTHING: f64 = 1e-30;

impl Lowering<'_> {
    /// `reaction(closure)`, `effort(driver)`, `energy(kinetic)`; none for any other function.
    pub(super) fn of_motion(
        &mut self,
        name: &Name,
        arguments: &[Term],
        span: Span,
    ) -> Option<Typed> {
        // In a part every name has its prefix: `left.energy(left.kinetic)` is what its file calls `energy(kinetic)`.
        let (part, own) = name.text.split_at(name.text.rfind('.').map_or(0, |dot| dot + 1));
        if !matches!(own, "reaction" | "effort" | "energy") {
            return None;
        }
        if !self.count(name, arguments.len(), 1, span) {
            return Some(Typed::Wrong);
        }
        let argument = &arguments[0];
        let wanted = print::term(argument);
        let of_part = wanted.strip_prefix(part)?;
        Some(match own {
            "reaction" => self.reaction(argument),
            "effort" => self.effort(argument),
            _ => self.energy(of_part, argument.span),
        })
    }

    /// The force of a closure on what stands on its left side, a vector where the closure is one.
    fn reaction(&mut self, argument: &Term) -> Typed {
        let wanted = print::term(argument);
        if self.loops_are_wrong {
            return Typed::Wrong;
        }
        let Some(closure) = self.closures.iter().find(|one| one.name == wanted).cloned() else {
            let message =
                format!("there is no closure `{wanted}`, and only closures have reactions");
            let known = self.closures.iter().map(|one| one.name.as_str());
            let near = nearest(&wanted, known);
            let otherwise = "give a closure a name: `closure pin: A = B;`";
            return self.error(Diagnostic::error(argument.span, message).meant(near, otherwise));
        };
        let Some(kind) = self.energy_kind(0).and_then(|energy| over(energy, closure.kind)) else {
            return Typed::Wrong;
        };
        let symbols = closure.equations.map(|index| Symbol::Reaction(index as u32));
        let values: Vec<_> = symbols.map(|symbol| self.graph.symbol(symbol)).collect();
        Quantity::of(&values, kind).into()
    }

    /// The force or torque by which a driver is moved as it is.
    fn effort(&mut self, argument: &Term) -> Typed {
        let TermKind::Name(name) = &argument.kind else {
            return self.no_driver(&print::term(argument), argument.span);
        };
        let names = self.names;
        let Some(Role::Driver(index)) = names.table.get(name).map(|entry| &entry.role) else {
            return self.no_driver(name, argument.span);
        };
        self.used.insert(name.clone());
        let symbol = Symbol::Driver(*index);
        let moves = self.driver_motions[*index as usize].is_some() || self.moved == Moved::Given;
        if !moves {
            let message = format!(
                "nothing says how fast the driver `{name}` moves, so what moves it is not known"
            );
            let hint = format!("state its motion, as in `driver {name} = n*time;`");
            return self.error(Diagnostic::error(argument.span, message).hint(hint));
        }
        let position = self.kind_of(symbol);
        match self.energy_kind(0).and_then(|energy| over(energy, position)) {
            Some(kind) => Typed::scalar(self.graph.symbol(Symbol::Effort(*index)), kind),
            None => Typed::Wrong,
        }
    }

    fn no_driver(&mut self, name: &str, span: Span) -> Typed {
        let role = self.names.table.get(name).map(|entry| &entry.role);
        let (message, hint) = match role {
            Some(Role::Coordinate(_) | Role::Dependent(_)) => (
                format!("`{name}` moves freely: nothing but the forces in the file acts on it"),
                "the force of a closure is `reaction(closure)`; only a `driver` takes an effort",
            ),
            _ => (
                format!("`{name}` is no driver, and only drivers take an effort"),
                "name a driver: `effort(phi)`",
            ),
        };
        self.error(Diagnostic::error(span, message).hint(hint))
    }

    /// An energy of the whole, or the power that it loses.
    fn energy(&mut self, wanted: &str, span: Span) -> Typed {
        let Some(index) = ENERGIES.iter().position(|one| *one == wanted) else {
            let message = format!("there is no energy `{wanted}`");
            let report = Diagnostic::error(span, message);
            return self.error(report.hint(
                "it is `energy(kinetic)`, `energy(potential)`, or the lost power `energy(dissipation)`",
            ));
        };
        match self.energy_kind(index) {
            Some(kind) => Typed::scalar(self.graph.symbol(Symbol::Energy(index as u32)), kind),
            None => Typed::Wrong,
        }
    }

    /// Whether what the motion is made of is free of what only its solution determines; else that is reported.
    pub fn is_given(&mut self, values: &[Expression], span: Span) -> bool {
        let held = values.iter().any(|one| self.graph.depends_on(*one, is_of_motion));
        if held {
            let message = "what makes the motion cannot depend on an `effort` or an `energy`, and on a `reaction` only as a `force`";
            self.diagnostics.push(Diagnostic::error(span, message).hint(
                "they can be reported, measured and watched by events; friction is a `force` that depends on a `reaction`",
            ));
        }
        !held
    }

    /// The kind of an energy, or of a power for the last of [`ENERGIES`].
    fn energy_kind(&self, index: usize) -> Option<Kind> {
        let joule = crate::unit::parse_unit_text("J").ok()?.dimension;
        match index {
            2 => Some(Kind::Of(joule.div(&second())?)),
            _ => Some(Kind::Of(joule)),
        }
    }

    /// A force that depends on those of closures, with these as what is felt. None, which is reported, where it jumps or bends
    /// with them.
    pub fn feel(&mut self, force: Expression, span: Span) -> Option<Expression> {
        let felt = |symbol: Symbol| matches!(symbol, Symbol::Reaction(_));
        if !self.graph.depends_on(force, felt) {
            return Some(force);
        }
        let mut new: Map<Expression, Expression> = Map::default();
        for old in self.graph.reachable(&[force]) {
            if !self.graph.depends_on(old, felt) {
                continue;
            }
            let node = self.graph.node(old).clone();
            let value = match &node {
                Node::Symbol(Symbol::Reaction(index)) => self.graph.symbol(Symbol::Felt(*index)),
                // Its slope jumps where it is zero; as a length it is followed through that place.
                Node::Call(Function::Abs, arguments) => {
                    let inner = new[&arguments[0]];
                    length(&mut self.graph, inner)
                }
                Node::Call(Function::Sign | Function::Max | Function::Min | Function::Floor, _)
                | Node::Select(..)
                | Node::Compare(..) => {
                    let message = "a force jumps or bends where that of a closure changes its sign";
                    self.diagnostics.push(Diagnostic::error(span, message).hint(
                        "take `abs` or `norm` of it; what holds for one sign alone belongs in a `mode`",
                    ));
                    return None;
                }
                _ => self.graph.rebuild_with(&node, &new),
            };
            new.insert(old, value);
        }
        Some(new[&force])
    }
}

/// `|x|`, as `sqrt(x^2)` that is never exactly zero.
fn length(graph: &mut Graph, value: Expression) -> Expression {
    let square = graph.powi(value, 2);
    let least = graph.number(NOTHING * NOTHING);
    let sum = graph.add(square, least);
    graph.call(Function::Sqrt, &[sum])
}
