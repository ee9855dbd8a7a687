//! Turns terms into typed expressions: names get their meaning, kinds of quantities are checked, time derivatives are
//! taken.

mod ambiguous;
mod arithmetic;
mod breaks;
mod call;
mod condition;
mod derivative;
mod literal;
mod measure;
mod mechanics;
mod notation;
mod search;
mod table;
mod turns;
mod typed;
mod vector;
mod written;

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

pub use derivative::is_of_motion;
pub use measure::Measuring;
pub use mechanics::Closure;
use typed::Key;
pub use typed::{Quantity, Typed};
use written::Written;

use crate::checked::LiteralInfo;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Budget, Expression, Graph, Map, Set, Symbol};
pub use crate::homogeneity::Kind;
use crate::homogeneity::{agree, unlike};
use crate::nearest::nearest;
use crate::resolve::{Names, Role};
use crate::scene::{Selected, Survey};
use crate::slopes::Slopes;
use crate::syntax::tree::{Name, Term, TermKind};
use crate::syntax::words::{FUNCTIONS, QUANTITIES};
use crate::token::Span;
use crate::unit::{Dimension, Unit};
use crate::unroll::{bounds, whole_number, with_index};

/// Functions may call functions this deep.
const DEPTH: usize = 64;

/// Abbreviations may refer to each other this deep when they stand in the wrong order.
const MOST_NESTED: usize = 400;

/// Most terms that the sums of a scene may come to.
const SUMMANDS: usize = 100_000;

/// Dimension of a time.
pub fn second() -> Dimension {
    Dimension::base(2)
}

/// What moves the drivers of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moved {
    /// The time, in equations of motion.
    InTime,
    /// The time, but positions and speeds are given to the linkage.
    Given,
    /// They are set from outside.
    Swept,
}

/// A condition on what is swept.
pub struct Limit {
    /// Whether it holds.
    pub value: Expression,
    /// As it is written.
    pub condition: Term,
    /// What the file says about it.
    pub message: String,
}

/// What a name or a call means, and the first number in it that depends on the units.
type Meaning = (Typed, Option<LiteralInfo>);

/// Everything that lowering a scene's terms needs and remembers.
pub struct Lowering<'a> {
    /// The expressions.
    pub graph: Graph,
    /// Messages.
    pub diagnostics: &'a mut Diagnostics,
    /// Names of the scene.
    pub names: &'a Names,
    /// Names that something refers to.
    pub used: BTreeSet<String>,
    /// Position of each driver and its time derivative: the position must have been lowered.
    pub driver_motions: Vec<Option<(Expression, Expression)>>,
    /// Expressions that are time derivatives of something that depends on positions and time alone.
    pub rates: Set<Expression>,
    /// Expressions that are derivatives, in time or by something given.
    pub derived: Set<Expression>,
    /// How the dependent coordinates change, once the closures are read.
    pub slopes: Option<Slopes>,
    /// What the time derivatives of dependent coordinates, and of drivers where these are symbols, stand for.
    pub followed: Map<Symbol, Expression>,
    /// What everything stands for that is not given, once the equations are solved.
    pub bound: Map<Symbol, Expression>,
    /// The closures by name, with the indices of their scalar equations and their kinds.
    pub closures: Vec<Closure>,
    /// Whether energies depend on speeds, so that those of drivers are symbols: their forces are derivatives by them.
    pub has_speeds: bool,
    /// Whether the loops cannot be closed, which has been reported.
    pub loops_are_wrong: bool,
    /// What moves the drivers.
    pub moved: Moved,
    /// The first number with a length, mass or time in its unit in what has been lowered, abbreviations included.
    pub literal: Option<LiteralInfo>,
    /// Conditions on what is swept: beyond them the outputs have no values.
    pub limits: Vec<Limit>,
    /// What measures have asked for.
    pub measured: Measuring,
    /// Names that are known to hold no product of a frequency in hertz and a time.
    angles: BTreeSet<String>,
    survey: &'a Survey<'a>,
    selected: &'a Selected,
    /// Kind of each given quantity with the unit in which it is printed.
    kinds: Map<Symbol, (Kind, Unit)>,
    done: HashMap<String, Meaning>,
    open: Vec<(String, Span)>,
    locals: Vec<HashMap<String, Typed>>,
    written: Written,
    calls: HashMap<(String, Vec<Key>), Meaning>,
    arguments: u32,
    summands: usize,
    drivers_read: bool,
}

impl<'a> Lowering<'a> {
    /// Begins with a scene's names, whose kinds are declared one by one.
    pub fn new(
        names: &'a Names,
        survey: &'a Survey<'a>,
        selected: &'a Selected,
        diagnostics: &'a mut Diagnostics,
        budget: Rc<Budget>,
    ) -> Self {
        Self {
            graph: Graph::within(budget),
            diagnostics,
            names,
            used: BTreeSet::new(),
            driver_motions: vec![None; names.drivers.len()],
            rates: Set::default(),
            derived: Set::default(),
            slopes: None,
            followed: Map::default(),
            bound: Map::default(),
            closures: Vec::new(),
            has_speeds: false,
            loops_are_wrong: false,
            moved: Moved::InTime,
            literal: None,
            limits: Vec::new(),
            measured: Measuring::default(),
            angles: BTreeSet::new(),
            survey,
            selected,
            kinds: Map::default(),
            done: HashMap::new(),
            open: Vec::new(),
            locals: Vec::new(),
            calls: HashMap::new(),
            written: Written::default(),
            arguments: 0,
            summands: 0,
            drivers_read: false,
        }
    }

    /// What a term means. Mistakes are reported once and give [`Typed::Wrong`].
    pub fn term(&mut self, term: &Term) -> Typed {
        let typed = self.lower(term);
        self.take_up(term, &typed);
        if let Typed::Quantity(one) = &typed
            && let (true, [value]) = (one.rate, one.values())
        {
            let negated = self.graph.neg(*value);
            self.rates.extend([*value, negated]);
        }
        typed
    }

    fn lower(&mut self, term: &Term) -> Typed {
        match &term.kind {
            TermKind::Number { value, unit } => self.literal(*value, unit.as_ref(), term),
            TermKind::Name(name) => self.name(name, term.span),
            TermKind::Index { name, index } => match whole_number(index, self.diagnostics) {
                Some(number) => self.name(&format!("{}[{number}]", name.text), term.span),
                None => Typed::Wrong,
            },
            TermKind::Member { base, name } => match self.selected.decide(term, self.survey) {
                Some(held) => Typed::Decided(held),
                None if self.has_components(base, name) => self.component(base, name),
                None if self.survey.speaks_of_unread(term) => Typed::Wrong,
                None => self.error(self.survey.explain(term).unwrap_or_else(|| {
                    Diagnostic::error(term.span, "a name stands before `.alternative`")
                })),
            },
            TermKind::Vector(items) => self.vector(items, term.span),
            TermKind::Unary(operator, inner) => self.unary(*operator, inner),
            TermKind::Binary(operator, left, right) => self.binary(*operator, left, right),
            TermKind::Call { name, arguments } => self.call(name, arguments, term.span),
            TermKind::If { condition, then, otherwise } => self.branch(condition, then, otherwise),
            TermKind::Sum { index, from, to, body } => self.sum(index, (from, to), body),
            TermKind::Search { name, variable, from, to, body } => {
                self.search(name, variable, (from, to), body, term)
            }
            TermKind::Table(table) => self.table(table, term),
            TermKind::Bound { name, value, instead } => self.bound(name, value, instead),
        }
    }

    /// From now on a statement is read, or none: whoever needs too many steps is named.
    pub fn begin(&self, statement: Option<Span>) {
        self.graph.budget().begin(statement);
    }

    /// A scalar with its kind; anything else is reported.
    pub fn scalar(&mut self, term: &Term) -> Option<(Expression, Kind)> {
        let typed = self.term(term);
        let number = typed.as_number();
        if number.is_none() && !matches!(typed, Typed::Wrong) {
            let message = format!("a number is expected here, and this is {}", typed.describe());
            let report = Diagnostic::error(term.span, message);
            self.diagnostics.push(match typed {
                Typed::Quantity(_) => {
                    report.hint("its length is `norm(v)`, its components are `v.x` and `v.y`")
                }
                _ => report,
            });
        }
        number
    }

    /// A condition; anything else is reported.
    pub fn condition(&mut self, term: &Term) -> Option<Expression> {
        match self.term(term) {
            Typed::Condition(value) => Some(value),
            Typed::Decided(held) => {
                let (zero, one) = (self.graph.zero(), self.graph.one());
                let (a, b) = if held { (zero, one) } else { (one, zero) };
                Some(self.graph.compare(crate::program::Relation::Less, a, b))
            }
            Typed::Wrong => None,
            other => {
                let message =
                    format!("a condition is expected here, and this is {}", other.describe());
                self.diagnostics.push(
                    Diagnostic::error(term.span, message)
                        .hint("compare two quantities, as in `a < b`"),
                );
                None
            }
        }
    }

    /// Whether a name that is missing may have been declared by a statement that could not be read.
    pub fn is_unread(&self, name: &str) -> bool {
        self.survey.is_unread(name)
    }

    /// Whether any statement of the file could not be read.
    pub fn is_incomplete(&self) -> bool {
        self.survey.is_incomplete()
    }

    /// From now on a driver without a position is a mistake that has been reported.
    pub fn drivers_read(&mut self) {
        self.drivers_read = true;
    }

    /// Reports a mistake.
    fn error(&mut self, diagnostic: Diagnostic) -> Typed {
        self.diagnostics.push(diagnostic);
        Typed::Wrong
    }

    /// Kind of a given quantity.
    pub fn kind_of(&self, symbol: Symbol) -> Kind {
        self.kinds.get(&symbol).map_or(Kind::NUMBER, |(kind, _)| *kind)
    }

    /// Declares the kind of a given quantity and the unit in which it is printed.
    pub fn declare_kind(&mut self, symbol: Symbol, kind: Kind, unit: &Unit) {
        self.kinds.insert(symbol, (kind, unit.clone()));
    }

    /// Unit in which a given quantity is printed.
    pub fn unit_of(&self, symbol: Symbol) -> Option<Unit> {
        self.kinds.get(&symbol).map(|(_, unit)| unit.clone())
    }

    fn name(&mut self, name: &str, span: Span) -> Typed {
        if let Some(local) = self.locals.last().and_then(|scope| scope.get(name)) {
            return local.clone();
        }
        let names = self.names;
        let Some(entry) = names.table.get(name) else {
            return self.builtin(name, span);
        };
        self.used.insert(name.to_string());
        if let Some(mode) = names.absent.get(name) {
            let report = Diagnostic::error(span, format!("only the mode `{mode}` has `{name}`"));
            return self.error(report.related(entry.span, "declared here"));
        }
        let symbol = match &entry.role {
            Role::Constant(index) => Symbol::Parameter(*index),
            Role::Driver(index) => Symbol::Driver(*index),
            Role::Dependent(index) => Symbol::Dependent(*index),
            Role::Coordinate(index) => Symbol::Coordinate(*index),
            Role::State(index) => Symbol::State(*index),
            Role::Let(value) => return self.abbreviation(name, value, span),
            Role::Measure(value) if self.measured.is_open => {
                return self.abbreviation(name, value, span);
            }
            Role::Measure(_) => {
                return self.error(
                    Diagnostic::error(
                        span,
                        format!("`{name}` is a number of a whole run, and this holds at one time"),
                    )
                    .related(entry.span, "declared here"),
                );
            }
            Role::Part(mechanism) => {
                return self.error(
                    Diagnostic::error(span, format!("`{name}` is a part, a `{mechanism}`"))
                        .related(entry.span, "declared here")
                        .hint(format!("name something of it: `{name}.…`")),
                );
            }
            Role::Function(arguments, _) => {
                let shape: Vec<_> = arguments.iter().map(|one| one.text.as_str()).collect();
                return self.error(
                    Diagnostic::error(span, format!("`{name}` is a function"))
                        .related(entry.span, "declared here")
                        .hint(format!("give it its arguments: `{name}({})`", shape.join(", "))),
                );
            }
        };
        if self.wrong(symbol) {
            return Typed::Wrong;
        }
        let value = self.graph.symbol(symbol);
        self.graph.name(value, name);
        Typed::scalar(value, self.kind_of(symbol))
    }

    /// What a quantity of a part is given, of the kind of what it stands for.
    fn bound(&mut self, name: &str, value: &Term, instead: &Term) -> Typed {
        let Some((given, found)) = self.scalar(value) else {
            return Typed::Wrong;
        };
        let Some((_, expected)) = self.aside(|low| low.scalar(instead)) else {
            return Typed::Wrong;
        };
        match agree(found, expected) {
            Some(kind) => Typed::scalar(given, kind),
            None => {
                let message = unlike(&format!("`{name}`"), expected, found);
                self.error(
                    Diagnostic::error(value.span, message)
                        .related(instead.span, "what its file says"),
                )
            }
        }
    }

    /// Whether the declaration of a quantity was a mistake.
    fn wrong(&self, symbol: Symbol) -> bool {
        !self.kinds.contains_key(&symbol)
    }

    fn builtin(&mut self, name: &str, span: Span) -> Typed {
        match name {
            "pi" => return Typed::number(self.graph.number(std::f64::consts::PI)),
            "time" => {
                let value = self.graph.symbol(Symbol::Time);
                return Typed::scalar(value, Kind::Of(second()));
            }
            _ => {}
        }
        let as_name = Term { span, kind: TermKind::Name(name.into()) };
        if let Some(held) = self.selected.decide(&as_name, self.survey) {
            return Typed::Decided(held);
        }
        if self.survey.is_unread(name) {
            return Typed::Wrong;
        }
        let mut report = Diagnostic::error(span, format!("there is no `{name}` here"));
        if self.diagnostics.is_crowded() {
            return self.error(report);
        }
        let functions = FUNCTIONS.contains(&name);
        let indexed = self
            .names
            .table
            .keys()
            .any(|one| one.split('[').next() == Some(name) && one.contains('['));
        let locals =
            self.locals.last().into_iter().flat_map(|scope| scope.keys().map(String::as_str));
        let known = self
            .names
            .table
            .keys()
            .map(String::as_str)
            .chain(QUANTITIES.iter().copied())
            .chain(locals);
        let of_part = name.contains('.');
        if let Some(hint) = notation::elsewhere(name) {
            report = report.hint(hint);
        } else if let Some(hint) = self.derivative_named(name) {
            report = report.hint(hint);
        } else if functions {
            report =
                report.hint(format!("`{name}` is a function: give it its argument in parentheses"));
        } else if indexed {
            report = report.hint(format!("`{name}` has an index: `{name}[1]`"));
        } else if let Some(place) = self.survey.hidden.get(name) {
            report = report
                .related(*place, "declared in a block that does not hold here")
                .hint("it is declared in a block that does not hold here: say in `else` what takes its place");
        } else if let Some(near) = nearest(name, known) {
            report = report.hint(format!("did you mean `{near}`?"));
        } else if let Some(hint) = notation::unit_name(name) {
            report = report.hint(hint);
        } else if of_part {
            report = report.hint("a part has the names that its file declares; what comes from outside is bound in `part … { … }`");
        } else {
            report = report.hint("declare it with `parameter`, `dimension`, `coordinate` or `let`");
        }
        self.error(report)
    }

    fn abbreviation(&mut self, name: &str, value: &Term, span: Span) -> Typed {
        if let Some((done, literal)) = self.done.get(name).cloned() {
            self.note(literal);
            return done;
        }
        if let Some(at) = self.open.iter().position(|(one, _)| one == name) {
            let circle: Vec<_> =
                self.open[at..].iter().map(|(one, _)| one.as_str()).chain([name]).collect();
            let report = Diagnostic::error(
                span,
                format!("`{name}` is defined by itself: {}", circle.join(" -> ")),
            );
            let declared = self.names.table.get(name).map(|entry| entry.span);
            return self.error(match declared {
                Some(place) => report.related(place, "declared here"),
                None => report,
            });
        }
        if self.open.len() >= MOST_NESTED {
            let message = format!(
                "`{name}` stands at the end of a chain of more than {} abbreviations",
                MOST_NESTED
            );
            return self.error(Diagnostic::error(span, message));
        }
        self.open.push((name.to_string(), span));
        // An abbreviation sees the file's names, not the arguments of whoever uses it.
        self.locals.push(HashMap::new());
        let (typed, literal) = self.apart(|low| low.term(value));
        self.locals.pop();
        self.open.pop();
        if let Some((value, _)) = typed.as_number() {
            self.graph.name(value, name);
        }
        self.done.insert(name.to_string(), (typed.clone(), literal.clone()));
        self.note(literal);
        typed
    }

    /// A function of the file, applied: its body with the arguments in their places.
    fn apply(
        &mut self,
        name: &Name,
        parameters: &[Name],
        body: &Term,
        arguments: Vec<Typed>,
        span: Span,
    ) -> Typed {
        if arguments.iter().any(|one| matches!(one, Typed::Wrong)) {
            return Typed::Wrong;
        }
        let key = (name.text.clone(), arguments.iter().map(Typed::key).collect::<Vec<_>>());
        // In a measure each call looks for numbers of its own, see `look_at`.
        let known = self.calls.get(&key).filter(|_| !self.measured.is_open);
        if let Some((done, literal)) = known.cloned() {
            self.note(literal);
            return done;
        }
        if let Some(at) = self.open.iter().position(|(one, _)| *one == name.text) {
            let circle: Vec<_> = self.open[at..]
                .iter()
                .map(|(one, _)| one.as_str())
                .chain([name.text.as_str()])
                .collect();
            return self.error(
                Diagnostic::error(
                    span,
                    format!("`{}` calls itself: {}", name.text, circle.join(" -> ")),
                )
                .hint("write a repetition with `for` or `sum`"),
            );
        }
        if self.locals.len() > DEPTH {
            return self.error(Diagnostic::error(
                span,
                format!("functions call each other more than {DEPTH} deep"),
            ));
        }
        self.open.push((name.text.clone(), span));
        self.locals.push(parameters.iter().map(|one| one.text.clone()).zip(arguments).collect());
        let (typed, literal) = self.apart(|low| low.term(body));
        self.locals.pop();
        self.open.pop();
        self.calls.insert(key, (typed.clone(), literal.clone()));
        self.note(literal);
        typed
    }

    fn sum(&mut self, index: &Name, (from, to): (&Term, &Term), body: &Term) -> Typed {
        let Some((first, last)) = bounds(from, to, self.diagnostics) else {
            return Typed::Wrong;
        };
        let mut total = Typed::scalar(self.graph.zero(), Kind::Any);
        for value in first..=last {
            self.summands += 1;
            if self.summands > SUMMANDS {
                let message = format!("the sums up to here come to more than {SUMMANDS} terms");
                self.diagnostics.push_once("sums".into(), Diagnostic::error(body.span, message));
                return Typed::Wrong;
            }
            let item = self.term(&with_index(body, &index.text, value));
            total = self.add(total, body.span, item, body.span);
            if matches!(total, Typed::Wrong) {
                return total;
            }
        }
        total
    }
}
