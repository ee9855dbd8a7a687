//! From the expressions of a scene to its program.

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::emit::Emitter;
use super::{
    Input, OperationKind, Program, Results, Stage, Value, collect, order, sensitivity, share,
    surfaces,
};
use crate::expression::{Expression, Graph, Map, Symbol};

/// What a program is to compute.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// What its functions return.
    pub results: Results<Expression>,
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
    /// The symbols that the results need, those of what they are bound to among them.
    pub fn needed(&self, graph: &Graph) -> BTreeSet<Symbol> {
        let mut open: Vec<Symbol> = graph.symbols(&self.results.all()).into_iter().collect();
        let mut needed = BTreeSet::new();
        while let Some(symbol) = open.pop() {
            if let (true, Some(value)) = (needed.insert(symbol), self.bindings.get(&symbol)) {
                open.extend(graph.symbols(&[*value]));
            }
        }
        needed
    }

    /// How often a symbol changes.
    pub(super) fn stage_of(&self, symbol: Symbol) -> Stage {
        match self.inputs.get(&symbol) {
            Some(Input::Parameter(_)) => Stage::Parameter,
            Some(Input::Time | Input::Driver(_)) => Stage::Instant,
            _ if matches!(symbol, Symbol::Bound(_)) => Stage::Trial,
            _ => Stage::State,
        }
    }

    /// How often an expression changes.
    pub(super) fn stage(&self, graph: &Graph, expression: Expression) -> Stage {
        let found = || graph.occurring(expression).map(|symbol| self.stage_of(symbol));
        let mut stages = self.stages.borrow_mut();
        let stage = stages.entry(graph.support(expression));
        *stage.or_insert_with(|| found().max().unwrap_or(Stage::Constant))
    }
}

/// Builds the program: puts in what symbols stand for, simplifies, collects by stages, and writes the operations down.
pub fn build(graph: &mut Graph, request: &Request) -> Program {
    let mut request = request.clone();
    if request.cycle {
        vary(graph, &mut request);
    }
    let bound = bind(graph, &request.results.all(), &request.bindings);
    request.results = request.results.with(bound);
    let mut program =
        Program { parameters: request.parameters, states: request.states, ..Program::default() };
    if request.surfaces {
        freeze(graph, &mut request, &mut program);
    }
    let (request, results) = (&request, &request.results);
    let often = results.often();
    let simple = graph.simplify(&results.all(), often);
    let collected = collect::collect(graph, &simple, often, request);
    let collected = share::share(graph, &collected, &results.functions(), request);
    let mut emitter = Emitter::new(graph, request, &collected, often);
    let values = collected.iter().map(|root| emitter.value(*root)).collect();
    program.results = results.with(values);
    program.operations = emitter.operations;
    order::sort(&mut program);
    drop_zeros(&mut program);
    program.linear = is_linear(&program);
    program
}

/// Adds their slopes to the events.
fn vary(graph: &mut Graph, request: &mut Request) {
    let rates = bind(graph, &request.results.derivative, &request.bindings);
    let mut events = std::mem::take(&mut request.results.events);
    for event in &mut events {
        let mut bound = bind(graph, &event.all(), &request.bindings).into_iter();
        *event = event.map(|old| bound.next().unwrap_or(old));
    }
    sensitivity::add(graph, &mut events, &rates, request);
    request.results.events = events;
}

/// Makes the sides of switching surfaces inputs. Surfaces, kinks of guards and angles that turn in them become events.
fn freeze(graph: &mut Graph, request: &mut Request, program: &mut Program) {
    let bound = request.results.all();
    let derivative = request.results.derivative.clone();
    let often = request.results.often();
    let reported = request.results.reported();
    let asked: Vec<Expression> = reported.iter().map(|place| bound[*place]).collect();
    let mut frozen = surfaces::freeze(graph, &bound[..often], &asked, &derivative, request);
    if request.cycle {
        let rates = &frozen.roots[..derivative.len()];
        sensitivity::add(graph, &mut frozen.surfaces, rates, request);
    }
    let mut guards: Vec<_> = request.results.events.iter().map(|event| event.guard).collect();
    let kinks = surfaces::kinks(graph, &guards, &derivative, &frozen.surfaces, request);
    guards.extend(frozen.surfaces.iter().chain(&kinks).map(|one| one.guard));
    let turns = surfaces::turns(graph, &guards, &derivative, request);
    (program.kinks, program.turns) = (kinks.len(), turns.len());
    program.surfaces = frozen.texts;
    let mut roots = bound;
    roots[..often].copy_from_slice(&frozen.roots);
    for (place, value) in reported.into_iter().zip(frozen.asked) {
        roots[place] = value;
    }
    request.results = request.results.with(roots);
    let events = &mut request.results.events;
    events.extend(frozen.surfaces.into_iter().chain(kinks).chain(turns));
}

/// Expressions with every bound symbol replaced by what it stands for, which may contain others.
pub fn bind(
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
    let Some(value) = bindings.get(&symbol).copied().filter(|_| !closed.contains_key(&symbol))
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
    let slopes = program.results.slopes().all(|slope| stage(&slope) < Stage::State);
    let arithmetic = order::reach(program, &program.results.derivative).into_iter().all(|value| {
        let operation = &program.operations[value.0 as usize];
        let branches = matches!(
            operation.kind,
            OperationKind::Call(..)
                | OperationKind::Compare(..)
                | OperationKind::Select { .. }
                | OperationKind::Factor { .. }
                | OperationKind::Search { .. }
                | OperationKind::Table { .. }
        );
        operation.stage < Stage::State || !branches
    });
    slopes && arithmetic
}
