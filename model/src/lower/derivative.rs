//! Derivatives that a file asks for: `dot(x)`, `ddot(x)` in time and `diff(f, x)`.

use super::breaks::Wanted;
use super::{Kind, Lowering, Moved, Quantity, Typed, second};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::homogeneity::over;
use crate::syntax::tree::{Name, Term, TermKind};
use crate::token::Span;

impl Lowering<'_> {
    pub(super) fn derivative(&mut self, name: &Name, arguments: &[Term], span: Span) -> Typed {
        let expected = if name.text == "diff" { 2 } else { 1 };
        if !self.count(name, arguments.len(), expected, span) {
            return Typed::Wrong;
        }
        match name.text.as_str() {
            "diff" => self.partial(&arguments[0], &arguments[1], span),
            "dot" => self.dot(&arguments[0], span),
            _ => {
                let once = self.dot(&arguments[0], span);
                self.dot_of(once, &arguments[0], span)
            }
        }
    }

    fn dot(&mut self, term: &Term, span: Span) -> Typed {
        let typed = self.term(term);
        self.dot_of(typed, term, span)
    }

    /// The time derivative of a value, which a term came to.
    fn dot_of(&mut self, typed: Typed, term: &Term, span: Span) -> Typed {
        let quantity = match typed {
            Typed::Quantity(quantity) => quantity,
            Typed::Wrong => return Typed::Wrong,
            other => {
                return self.error(Diagnostic::error(
                    span,
                    format!("{} has no time derivative", other.describe()),
                ));
            }
        };
        let values = quantity.values();
        if self.is_found(values, span) {
            return Typed::Wrong;
        }
        let Some(kind) = over(quantity.kind, Kind::Of(second())) else {
            return Typed::Wrong;
        };
        let values = &self.without_highest(values);
        let moving = |symbol: Symbol| {
            use Symbol::{Acceleration, DependentRate, Speed, State};
            matches!(symbol, Speed(_) | State(_) | Acceleration(_) | DependentRate(_))
        };
        let rate = !values.iter().any(|value| self.graph.depends_on(*value, moving));
        if values.iter().any(|value| {
            self.graph.depends_on(*value, |symbol| matches!(symbol, Symbol::Acceleration(_)))
        }) {
            return self.error(
                Diagnostic::error(span, "this is a derivative of an acceleration, which no equation determines")
                    .hint("at most the second derivative of a coordinate and the first of a state can be used"),
            );
        }
        if self.has_no_speed(values, span) {
            return Typed::Wrong;
        }
        let given = self.graph.symbols(values).into_iter().collect();
        let Some(direction) = self.direction_of(given) else {
            return Typed::Wrong;
        };
        let moves = |symbol| direction.contains_key(&symbol);
        if !self.is_differentiable(values, &moves, &Wanted::explicitly(term, span)) {
            return Typed::Wrong;
        }
        let values = self.graph.tangent(values, &direction);
        self.derived.extend(&values);
        Quantity::of(&values, kind).rated(rate)
    }

    /// Whether a number of the whole run, or what follows from the motion as a whole, is among some values; that is
    /// reported.
    fn is_found(&mut self, values: &[Expression], span: Span) -> bool {
        let has = |wanted: fn(Symbol) -> bool| {
            values.iter().any(|one| self.graph.depends_on(*one, wanted))
        };
        let report = match () {
            () if has(|symbol| matches!(symbol, Symbol::Measured(_))) => {
                let message = "a number of the whole run has no derivative: it does not change";
                Diagnostic::error(span, message)
                    .hint("differentiate what is looked at, as in `peak(dot(x))`")
            }
            () if has(is_of_motion) => Diagnostic::error(
                span,
                "forces of closures and drivers, and energies of the whole, have no derivative here",
            )
            .hint("report the quantity itself: its curve shows how it changes"),
            () => return false,
        };
        self.diagnostics.push(report);
        true
    }

    /// Values with the accelerations of dependent coordinates written out, if they hold any: what follows from the motion of
    /// drivers alone can be differentiated again.
    fn without_highest(&mut self, values: &[Expression]) -> Vec<Expression> {
        let highest = |symbol: Symbol| matches!(symbol, Symbol::DependentAcceleration(_));
        match values.iter().any(|one| self.graph.depends_on(*one, highest)) {
            true => self.written_out(values),
            false => values.to_vec(),
        }
    }

    /// Values with the time derivatives of dependent coordinates written out.
    pub fn written_out(&mut self, values: &[Expression]) -> Vec<Expression> {
        let once = self.graph.substitute(values, &self.followed);
        // Accelerations are made of rates.
        self.graph.substitute(&once, &self.followed)
    }

    /// How everything given moves with time: `dq/dt = u`, `du/dt = a`. None when the motion of a driver is wrong.
    pub fn direction(&mut self) -> Option<Map<Symbol, Expression>> {
        let index = |count: usize| 0..count as u32;
        let names = self.names;
        let coordinates = index(names.coordinates.len());
        let all = coordinates
            .clone()
            .map(Symbol::Coordinate)
            .chain(coordinates.map(Symbol::Speed))
            .chain(index(names.states.len()).map(Symbol::State))
            .chain(index(names.dependents.len()).map(Symbol::Dependent))
            .chain(index(names.dependents.len()).map(Symbol::DependentRate));
        self.direction_of(all.collect())
    }

    /// How the time, all drivers and some other things given move with time.
    fn direction_of(&mut self, given: Vec<Symbol>) -> Option<Map<Symbol, Expression>> {
        let coordinates = self.names.coordinates.len() as u32;
        let mut direction = Map::default();
        direction.insert(Symbol::Time, self.graph.one());
        for symbol in &given {
            let rate = match *symbol {
                Symbol::Coordinate(index) => Symbol::Speed(index),
                Symbol::Speed(index) => Symbol::Acceleration(index),
                Symbol::State(index) => Symbol::Acceleration(coordinates + index),
                Symbol::Dependent(index) => Symbol::DependentRate(index),
                Symbol::DependentRate(index) => Symbol::DependentAcceleration(index),
                _ => continue,
            };
            direction.insert(*symbol, self.graph.symbol(rate));
        }
        for index in 0..self.names.drivers.len() {
            match self.driver_motions[index] {
                Some((_, rate)) => {
                    let driver = index as u32;
                    direction.insert(Symbol::Driver(driver), rate);
                    if self.given_symbol(rate) == Some(Symbol::DriverRate(driver)) {
                        let acceleration = self.graph.symbol(Symbol::DriverAcceleration(driver));
                        direction.insert(Symbol::DriverRate(driver), acceleration);
                    }
                }
                None if self.moved == Moved::Swept => {}
                // While positions are read, no other driver can occur in them; afterwards this one is a mistake, which
                // has been reported.
                None if !self.drivers_read => {}
                None => return None,
            }
        }
        Some(direction)
    }

    /// Reports a time derivative of what moves with a driver of which no speed is stated, or that is not there.
    fn has_no_speed(&mut self, values: &[Expression], span: Span) -> bool {
        let occurs = |graph: &Graph, wanted: &dyn Fn(Symbol) -> bool| {
            values.iter().any(|value| graph.depends_on(*value, wanted))
        };
        if occurs(&self.graph, &|symbol| matches!(symbol, Symbol::DriverAcceleration(_))) {
            let message = "this is the derivative of an acceleration, which is not available";
            self.error(Diagnostic::error(span, message));
            return true;
        }
        let dependent = occurs(&self.graph, &|symbol| {
            matches!(symbol, Symbol::Dependent(_) | Symbol::DependentRate(_))
        });
        if dependent && self.loops_are_wrong {
            return true;
        }
        if dependent && self.slopes.is_none() {
            let message = "a closure binds positions, and this is a time derivative";
            self.error(Diagnostic::error(span, message));
            return true;
        }
        if self.moved != Moved::Swept {
            return false;
        }
        let still = (0..self.names.drivers.len()).find(|index| {
            let own = Symbol::Driver(*index as u32);
            self.driver_motions[*index].is_none()
                && self.drivers_read
                && (dependent || occurs(&self.graph, &|symbol| symbol == own))
        });
        let Some(index) = still else { return false };
        let driver = &self.names.drivers[index];
        let name = &driver.name.text;
        let report = match &driver.what.motion {
            Some(motion) => Diagnostic::error(
                span,
                format!("the speed of the driver `{name}` changes with time, and this scene sweeps its position"),
            )
            .related(motion.span, "its motion")
            .hint("let the scene run over the time instead: `run time a .. b;`"),
            None => Diagnostic::error(
                span,
                format!("this is a time derivative, and nothing says how fast the driver `{name}` moves"),
            )
            .related(driver.name.span, "declared here")
            .hint(format!(
                "state its motion, as in `driver {name} = n*time;`, or take the derivative by its position: `diff(…, {name})`"
            )),
        };
        self.error(report);
        true
    }

    /// `diff(f, x)`: the partial derivative with everything else given fixed; dependent coordinates follow.
    fn partial(&mut self, function: &Term, variable: &Term, span: Span) -> Typed {
        if let TermKind::Name(name) = &variable.kind
            && let Some(local) = self.locals.last().and_then(|scope| scope.get(name))
            && let Some(variable) = local.as_number()
        {
            return self.partial_in_argument(function, name, variable, span);
        }
        let Some((value, kind)) = self.scalar(variable) else {
            return Typed::Wrong;
        };
        let given = match self.graph.node(value) {
            crate::expression::Node::Symbol(symbol) => *symbol,
            _ => {
                return self.error(
                    Diagnostic::error(variable.span, "`diff` needs something given as its variable, and this is computed")
                        .hint("a coordinate, a driver, the time, a parameter, `dot` of a coordinate, or an argument of the function it stands in"),
                );
            }
        };
        if let Symbol::Dependent(_) = given {
            return self.error(
                Diagnostic::error(
                    variable.span,
                    "a dependent coordinate is not given: closures determine it",
                )
                .hint("take the derivative by a driver or a dimension"),
            );
        }
        let typed = self.term(function);
        if self.is_found(typed.values(), span) {
            return Typed::Wrong;
        }
        // What is constant passes through no jump.
        let fixed = matches!(given, Symbol::Parameter(_));
        let moves = |symbol| !fixed && (symbol == given || matches!(symbol, Symbol::Dependent(_)));
        let wanted = Wanted::explicitly(function, span);
        if !self.is_differentiable(typed.values(), &moves, &wanted) {
            return Typed::Wrong;
        }
        self.quotient(typed, given, kind, function.span)
    }

    /// The variable is an argument of the function around: it is varied by itself, then replaced by its value.
    fn partial_in_argument(
        &mut self,
        function: &Term,
        name: &str,
        (value, kind): (Expression, Kind),
        span: Span,
    ) -> Typed {
        let symbol = Symbol::Argument(self.arguments);
        self.arguments += 1;
        let free = Typed::scalar(self.graph.symbol(symbol), kind);
        let mut scope = self.locals.last().cloned().unwrap_or_default();
        scope.insert(name.to_string(), free);
        self.locals.push(scope);
        let typed = self.term(function);
        self.locals.pop();
        let is_fixed = self.is_fixed(value);
        let moves = |other| other == symbol && !is_fixed;
        let wanted = Wanted::explicitly(function, span);
        if !self.is_differentiable(typed.values(), &moves, &wanted) {
            return Typed::Wrong;
        }
        let varied = self.quotient(typed, symbol, kind, function.span);
        let map = Map::from_iter([(symbol, value)]);
        let put = |graph: &mut Graph, one| graph.substitute(&[one], &map)[0];
        self.written.substitute(&mut self.graph, symbol, &put);
        match varied {
            Typed::Quantity(one) => {
                let values = self.graph.substitute(one.values(), &map);
                Quantity::of(&values, one.kind).into()
            }
            other => other,
        }
    }

    fn quotient(&mut self, typed: Typed, given: Symbol, kind: Kind, span: Span) -> Typed {
        let direction = match self.slopes.as_mut() {
            Some(slopes) => slopes.direction(&mut self.graph, given),
            None => Map::from_iter([(given, self.graph.one())]),
        };
        match typed {
            Typed::Quantity(one) => match over(one.kind, kind) {
                Some(kind) => {
                    let values = self.written_out(one.values());
                    let values = self.graph.tangent(&values, &direction);
                    self.derived.extend(&values);
                    Quantity::of(&values, kind).into()
                }
                None => Typed::Wrong,
            },
            Typed::Wrong => Typed::Wrong,
            other => self
                .error(Diagnostic::error(span, format!("{} has no derivative", other.describe()))),
        }
    }
}

/// Whether a symbol stands for what only the whole motion determines.
pub fn is_of_motion(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Reaction(_) | Symbol::Effort(_) | Symbol::Energy(_))
}
