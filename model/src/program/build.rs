//! From the expressions of a scene to its program.

use std::cell::RefCell;

use super::emit::Emitter;
use super::{
    Closing, Event, Input, OperationKind, Program, Results, Stage, Value, collect, order,
    sensitivity, share, surfaces,
};
use crate::expression::{Expression, Graph, Map, Symbol};

/// The function that computes events, by number.
const EVENTS: usize = 12;

/// What a program is to compute.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// `y'`.
    pub derivative: Vec<Expression>,
    /// Entries of `∂y'/∂y`: row, column, value.
    pub jacobian: Vec<(u32, u32, Expression)>,
    /// Outputs.
    pub outputs: Vec<Expression>,
    /// Positions of the drivers.
    pub drivers: Vec<Expression>,
    /// Lower triangle of the mass matrix.
    pub mass: Vec<Expression>,
    /// Kinetic and potential energy.
    pub energy: Vec<Expression>,
    /// Conditions on the values.
    pub requirements: Vec<Expression>,
    /// Period, or start and end time.
    pub span: Vec<Expression>,
    /// Start values.
    pub start: Vec<Expression>,
    /// What measures look at.
    pub measured: Vec<Expression>,
    /// The measures, from what has been found of a run.
    pub measures: Vec<Expression>,
    /// By how much the loops that are carried along close.
    pub margins: Vec<Expression>,
    /// What a linkage computes.
    pub closing: Closing<Expression>,
    /// What events compute.
    pub events: Vec<Event<Expression>>,
    /// Where symbols come from.
    pub inputs: Map<Symbol, Input>,
    /// What the other symbols stand for.
    pub bindings: Map<Symbol, Expression>,
    /// Number of parameters.
    pub parameters: usize,
    /// Length of the state vector.
    pub states: usize,
    /// Whether the sides of switching surfaces are inputs.
    pub surfaces: bool,
    /// Whether variations of the motion pass through its events.
    pub cycle: bool,
    /// How often what has some symbols changes, by the number of their set: found once the inputs are known.
    pub stages: RefCell<Map<u32, Stage>>,
}

impl Request {
    /// How often a symbol changes.
    pub(super) fn stage_of(&self, symbol: Symbol) -> Stage {
        match self.inputs.get(&symbol) {
            Some(Input::Parameter(_)) => Stage::Parameter,
            Some(Input::Time | Input::Driver(_)) => Stage::Instant,
            _ => Stage::State,
        }
    }

    /// How often an expression changes.
    pub(super) fn stage(&self, graph: &Graph, expression: Expression) -> Stage {
        let found = || {
            graph
                .occurring(expression)
                .map(|symbol| self.stage_of(symbol))
        };
        let mut stages = self.stages.borrow_mut();
        let stage = stages.entry(graph.support(expression));
        *stage.or_insert_with(|| found().max().unwrap_or(Stage::Constant))
    }

    /// All expressions in one list.
    pub(crate) fn roots(&self) -> Vec<Expression> {
        let slopes = self.jacobian.iter().map(|entry| entry.2);
        let mut roots: Vec<Expression> = self.derivative.iter().copied().chain(slopes).collect();
        for list in [
            &self.outputs,
            &self.drivers,
            &self.mass,
            &self.energy,
            &self.requirements,
            &self.span,
            &self.start,
            &self.measured,
            &self.measures,
            &self.margins,
        ] {
            roots.extend(list);
        }
        roots.extend(self.closing.all());
        roots.extend(self.events.iter().flat_map(Event::all));
        roots
    }

    /// For each of all expressions but those of events the function that computes it, as a number.
    fn functions(&self) -> Vec<usize> {
        let lists = [
            self.derivative.len(),
            self.jacobian.len(),
            self.outputs.len(),
            self.drivers.len(),
            self.mass.len(),
            self.energy.len(),
            self.requirements.len(),
            self.span.len(),
            self.start.len(),
            self.measured.len(),
            self.measures.len(),
            self.margins.len(),
        ];
        let lists = lists.into_iter().enumerate();
        let mut functions: Vec<usize> = lists
            .flat_map(|(function, count)| std::iter::repeat_n(function, count))
            .collect();
        functions.extend(self.closing.functions(EVENTS + 1));
        functions
    }
}

/// Builds the program: puts in what symbols stand for, simplifies, collects by stages, and writes the operations down.
pub fn build(graph: &mut Graph, request: &Request) -> Program {
    let often = request.derivative.len() + request.jacobian.len();
    let mut request = request.clone();
    if request.cycle {
        let rates = bind(graph, &request.derivative, &request.bindings);
        let mut events = std::mem::take(&mut request.events);
        for event in &mut events {
            let all: Vec<Expression> = event.all().collect();
            let mut bound = bind(graph, &all, &request.bindings).into_iter();
            *event = event.map(|old| bound.next().unwrap_or(old));
        }
        sensitivity::add(graph, &mut events, &rates, &request);
        request.events = events;
    }
    let mut bound = bind(graph, &request.roots(), &request.bindings);
    let (mut surfaces, mut kinks, mut turns) = (Vec::new(), Vec::new(), Vec::new());
    let mut texts = Vec::new();
    if request.surfaces {
        let derivative = bound[..request.derivative.len()].to_vec();
        let mut frozen = surfaces::freeze(graph, &bound[..often], &derivative, &mut request);
        if request.cycle {
            let rates = frozen.roots[..derivative.len()].to_vec();
            sensitivity::add(graph, &mut frozen.surfaces, &rates, &request);
        }
        let ends: usize = request.events.iter().map(|event| event.all().count()).sum();
        let mut place = bound.len() - ends;
        let guards = request.events.iter().map(|event| {
            let guard = bound[place];
            place += event.all().count();
            guard
        });
        let guards: Vec<Expression> = guards.collect();
        kinks = surfaces::kinks(graph, &guards, &derivative, &frozen.surfaces, &request);
        bound[..often].copy_from_slice(&frozen.roots);
        let others = frozen.surfaces.iter().chain(&kinks);
        let guards: Vec<Expression> = guards
            .into_iter()
            .chain(others.map(|one| one.guard))
            .collect();
        turns = surfaces::turns(graph, &guards, &derivative, &request);
        let all = frozen.surfaces.iter().chain(&kinks).chain(&turns);
        bound.extend(all.flat_map(Event::all));
        surfaces = frozen.surfaces;
        texts = frozen.texts;
    }
    let request = &request;
    let simple = graph.simplify(&bound, often);
    let collected = collect::collect(graph, &simple, often, request);
    let mut functions = request.functions();
    functions.resize(collected.len(), EVENTS);
    let collected = share::share(graph, &collected, &functions, request);
    let mut emitter = Emitter::new(graph, request, &collected, often);
    let values: Vec<Value> = collected.iter().map(|root| emitter.value(*root)).collect();
    let mut rest = values.into_iter();
    let mut take = |count: usize| rest.by_ref().take(count).collect::<Vec<Value>>();
    let derivative = take(request.derivative.len());
    let slopes = take(request.jacobian.len());
    let jacobian = request
        .jacobian
        .iter()
        .zip(slopes)
        .map(|((row, column, _), value)| (*row, *column, value));
    let results = Results {
        derivative,
        jacobian: jacobian.collect(),
        outputs: take(request.outputs.len()),
        drivers: take(request.drivers.len()),
        mass: take(request.mass.len()),
        energy: take(request.energy.len()),
        requirements: take(request.requirements.len()),
        span: take(request.span.len()),
        start: take(request.start.len()),
        measured: take(request.measured.len()),
        measures: take(request.measures.len()),
        margins: take(request.margins.len()),
        closing: {
            let mut closing = take(request.closing.all().len()).into_iter();
            request.closing.map(|_| closing.next().unwrap_or(Value(0)))
        },
        events: {
            let mut events = request
                .events
                .iter()
                .chain(&surfaces)
                .chain(&kinks)
                .chain(&turns);
            let mut map = |event: &Event<Expression>| {
                let mut values = take(event.all().count()).into_iter();
                event.map(|_| values.next().unwrap_or(Value(0)))
            };
            events.by_ref().map(&mut map).collect()
        },
    };
    let mut program = Program {
        operations: emitter.operations,
        results,
        parameters: request.parameters,
        states: request.states,
        linear: false,
        surfaces: texts,
        kinks: kinks.len(),
        turns: turns.len(),
    };
    order::sort(&mut program);
    drop_zeros(&mut program);
    program.linear = is_linear(&program);
    program
}

/// Expressions with every bound symbol replaced by what it stands for, which may contain others.
fn bind(
    graph: &mut Graph,
    roots: &[Expression],
    bindings: &Map<Symbol, Expression>,
) -> Vec<Expression> {
    let mut closed: Map<Symbol, Expression> = Map::default();
    for symbol in graph.symbols(roots) {
        close(graph, symbol, bindings, &mut closed);
    }
    graph.substitute(roots, &closed)
}

fn close(
    graph: &mut Graph,
    symbol: Symbol,
    bindings: &Map<Symbol, Expression>,
    closed: &mut Map<Symbol, Expression>,
) {
    let Some(value) = bindings
        .get(&symbol)
        .copied()
        .filter(|_| !closed.contains_key(&symbol))
    else {
        return;
    };
    for other in graph.symbols(&[value]) {
        close(graph, other, bindings, closed);
    }
    let value = graph.substitute(&[value], closed)[0];
    closed.insert(symbol, value);
}

/// Entries of the Jacobian that turn out to be zero only when everything is put in.
fn drop_zeros(program: &mut Program) {
    let operations = &program.operations;
    program
        .results
        .jacobian
        .retain(|entry| operations[entry.2.0 as usize].kind != OperationKind::Number(0.0));
}

/// Whether `y'` is affine in the state: it is made of it by sums and products alone, with slopes that do not contain it.
fn is_linear(program: &Program) -> bool {
    let stage = |value: &Value| program.operations[value.0 as usize].stage;
    let slopes = program
        .results
        .jacobian
        .iter()
        .all(|entry| stage(&entry.2) < Stage::State);
    let arithmetic = order::reach(program, &program.results.derivative)
        .into_iter()
        .all(|value| {
            let operation = &program.operations[value.0 as usize];
            let branches = matches!(
                operation.kind,
                OperationKind::Call(..)
                    | OperationKind::Compare(..)
                    | OperationKind::Select { .. }
                    | OperationKind::Factor { .. }
            );
            operation.stage < Stage::State || !branches
        });
    slopes && arithmetic
}
