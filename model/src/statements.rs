//! What the statements of a scene say of its motion: energies, forces, written equations, conditions.

use std::collections::BTreeMap;

use crate::checked::{EquationInfo, RequirementInfo};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, describe};
use crate::lagrange::{self, Energies};
use crate::lower::{Kind, Limit, Lowering, Moved, Typed, second};
use crate::motion::Equation;
use crate::resolve::Names;
use crate::syntax::print;
use crate::syntax::tree::{EnergyKind, Statement, StatementKind, Term};
use crate::token::Span;
use crate::unit::Unit;
use crate::unroll::equation_name;

/// Energies, equations and conditions, read from the statements.
#[derive(Default)]
pub struct Parts {
    /// Energies and forces.
    pub energies: Energies,
    /// Where they stand.
    pub energy_places: Vec<Span>,
    /// The force that moves each position as it moves, as if nothing bound it; without those of which none is stated.
    pub forces: BTreeMap<Symbol, Expression>,
    /// Equations of motion that are written out.
    pub written: Vec<Equation>,
    /// Conditions on the values.
    pub conditions: Vec<Expression>,
    /// The conditions as text, in the order of the statements.
    pub requirements: Vec<RequirementInfo>,
    /// All equations as text.
    pub texts: Vec<EquationInfo>,
}

impl Parts {
    /// Takes up a statement; those that say nothing of the motion are passed over.
    pub fn read(&mut self, statement: &Statement, low: &mut Lowering<'_>) {
        let span = statement.span;
        match &statement.kind {
            StatementKind::Energy { kind, value } => {
                self.energy(*kind, value, span, statement, low)
            }
            StatementKind::Force { value, on } => self.force(value, on, statement, low),
            StatementKind::Motion { label, left, right } => {
                let name = equation_name(label, (left, right), low.diagnostics);
                if let Some((residuals, kind)) = low.balance(left, right)
                    && low.is_given(&residuals, span)
                {
                    for residual in residuals {
                        self.written.push(Equation {
                            residual,
                            name: name.clone(),
                            span,
                            lagrange: None,
                        });
                    }
                    self.text(statement, kind);
                }
            }
            StatementKind::Require { condition, text } => {
                let Some(value) = low.aside(|low| low.condition(condition)) else {
                    return;
                };
                let moving = |symbol| !matches!(symbol, Symbol::Parameter(_));
                if low.graph.depends_on(value, moving) && low.moved == Moved::Swept {
                    let message = text.clone().unwrap_or_default();
                    low.limits.push(Limit { value, condition: condition.clone(), message });
                    return;
                }
                if low.graph.depends_on(value, moving) {
                    low.diagnostics.push(
                        Diagnostic::error(condition.span, "a condition on moving quantities is not available in this version of Assur")
                            .hint("in a scene that moves in time `require` speaks of dimensions and parameters"),
                    );
                    return;
                }
                let symbols = low.graph.symbols(&[value]).into_iter();
                let names = symbols.filter_map(|symbol| match symbol {
                    Symbol::Parameter(index) => Some(index as usize),
                    _ => None,
                });
                let names = names.collect();
                self.conditions.push(value);
                self.requirements.push(RequirementInfo {
                    text: print::term(condition),
                    message: text.clone().unwrap_or_default(),
                    names,
                });
            }
            _ => {}
        }
    }

    fn text(&mut self, statement: &Statement, kind: Kind) {
        let unit = Unit::for_dimension(&kind.dimension()).symbol;
        self.texts.push(EquationInfo {
            text: print::statement(statement),
            unit,
            span: statement.span,
        });
    }

    fn energy(
        &mut self,
        kind: EnergyKind,
        value: &Term,
        span: Span,
        statement: &Statement,
        low: &mut Lowering<'_>,
    ) {
        let Some((expression, found)) = low.scalar(value) else {
            return;
        };
        let joule = crate::unit::parse_unit_text("J").map(|unit| unit.dimension);
        let Ok(mut expected) = joule else { return };
        let mut word = "this has to be an energy (J)";
        if kind == EnergyKind::Dissipation
            && let Some(watt) = expected.div(&second())
        {
            (expected, word) = (watt, "a dissipation function is a power (W)");
        }
        // A coordinate may have any unit, but an energy is an energy.
        if agree(found, Kind::Of(expected)).is_none() {
            let message = format!("{word}, and this is {}", describe(found.dimension()));
            let hint = match kind {
                EnergyKind::Kinetic => {
                    "of a mass it is `m*dot(x)^2/2`, of a moment of inertia `J*dot(phi)^2/2`"
                }
                EnergyKind::Potential => "of a spring it is `c*x^2/2`, of a weight `m*g*y`",
                EnergyKind::Dissipation => "of a damper it is `d*dot(x)^2/2`",
            };
            low.diagnostics.push(Diagnostic::error(value.span, message).hint(hint));
            return;
        }
        if !low.is_given(&[expression], span) || !low.has_forces(kind, expression, value, span) {
            return;
        }
        let list = match kind {
            EnergyKind::Kinetic => &mut self.energies.kinetic,
            EnergyKind::Potential => &mut self.energies.potential,
            EnergyKind::Dissipation => &mut self.energies.dissipation,
        };
        list.push(expression);
        self.energy_places.push(span);
        self.text(statement, Kind::Of(expected));
    }

    fn force(&mut self, value: &Term, on: &Term, statement: &Statement, low: &mut Lowering<'_>) {
        let (force, position) = (low.term(value), low.term(on));
        let (force, position) = match (force, position) {
            (Typed::Wrong, _) | (_, Typed::Wrong) => return,
            (Typed::Quantity(force), Typed::Quantity(position)) if force.is_like(&position) => {
                (force, position)
            }
            (a, b) => {
                let message =
                    format!("the force is {} and its position is {}", a.describe(), b.describe());
                low.diagnostics.push(Diagnostic::error(statement.span, message));
                return;
            }
        };
        let work = crate::homogeneity::times(force.kind, position.kind);
        let joule = crate::unit::parse_unit_text("J").map(|unit| unit.dimension);
        if let (Some(work), Ok(joule)) = (work, joule)
            && agree(work, Kind::Of(joule)).is_none()
        {
            let message = format!(
                "a force times its position has to be an energy (J), and this is {}",
                describe(work.dimension())
            );
            low.diagnostics.push(
                Diagnostic::error(statement.span, message)
                    .hint("a force in N works on a position in m, a moment in N m on an angle"),
            );
            return;
        }
        let felt = force.values().iter().map(|one| low.feel(*one, value.span));
        let Some(forces) = felt.collect::<Option<Vec<_>>>() else { return };
        let all = [&forces, position.values()].concat();
        if !low.is_given(&all, statement.span) {
            return;
        }
        if !low.has_directions(position.values(), on, statement.span) {
            return;
        }
        let pairs = forces.iter().zip(position.values());
        let pairs = pairs.map(|(force, position)| (*force, *position));
        self.energies.forces.extend(pairs);
        self.energy_places.push(statement.span);
        self.text(statement, force.kind);
    }

    /// All equations: those written, and Lagrange's for the coordinates that occur in energies, or that move something that
    /// does.
    pub fn equations(&mut self, low: &mut Lowering<'_>, names: &Names) -> Vec<Equation> {
        let mut equations = std::mem::take(&mut self.written);
        for equation in &mut equations {
            equation.residual = low.written_out(&[equation.residual])[0];
        }
        let Some(place) = self.energy_places.first().copied() else {
            return equations;
        };
        let Some(direction) = low.direction() else {
            return equations;
        };
        let positions: Vec<Symbol> = self.energies.concern(&low.graph).into_iter().collect();
        let rates = std::mem::take(&mut low.rates);
        let residuals =
            lagrange::residuals(&mut low.graph, &self.energies, &positions, &direction, &|e| {
                rates.contains(&e)
            });
        low.rates = rates;
        self.forces = positions.into_iter().zip(residuals).collect();
        for (coordinate, residual) in self.reduced(low) {
            let name =
                format!("Lagrange's equation of {}", names.coordinates[coordinate].name.text);
            let residual = low.written_out(&[residual])[0];
            equations.push(Equation { residual, name, span: place, lagrange: Some(coordinate) });
        }
        equations
    }

    /// The equations of the coordinates that are concerned. What moves with a coordinate counts with its kinematic
    /// coefficient: the forces of the closures do no work on what they let move.
    fn reduced(&self, low: &mut Lowering<'_>) -> Vec<(usize, Expression)> {
        let zero = low.graph.zero();
        let mut reduced = Vec::new();
        for index in 0..low.names.coordinates.len() {
            let symbol = Symbol::Coordinate(index as u32);
            let own = self.forces.get(&symbol).copied();
            let mut terms: Vec<Expression> = own.into_iter().collect();
            let coefficients = match &mut low.slopes {
                Some(slopes) => slopes.by(&mut low.graph, symbol),
                None => Vec::new(),
            };
            for (dependent, coefficient) in coefficients.into_iter().enumerate() {
                let force = self.forces.get(&Symbol::Dependent(dependent as u32));
                if let Some(force) = force.filter(|_| coefficient != zero) {
                    terms.push(low.graph.mul(coefficient, *force));
                }
            }
            if !terms.is_empty() {
                reduced.push((index, low.graph.sum(&terms)));
            }
        }
        reduced
    }
}
