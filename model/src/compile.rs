//! One mode of a scene from statements to program: declare, lower, derive, solve, report.

mod asked;
mod checks;
mod quantities;

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use asked::{conservative, energy, give_drivers, jacobian, kept_constants};
use quantities::{driver_quantities, state_quantities, state_symbols, unknown_names};

use crate::checked::{ConstantInfo, SceneModel, SpanKind};
use crate::declare::Moved;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Budget, STEPS, Symbol};
use crate::facts;
use crate::linkage::{Geometry, Linkage, Loops, Ranges};
use crate::lower::{Kind, Lowering};
use crate::measures::{self, Measures};
use crate::modes::{self, EventInfo, Phase, Phases};
use crate::motion::{self, Equation};
use crate::parts::Parts;
use crate::program::{self, Input, Request};
use crate::published;
use crate::resolve::{Names, Role};
use crate::scene::{Selected, Survey};
use crate::syntax::tree::{File, Scene, SceneItem, StatementKind, Term};
use crate::token::Span;
use crate::unit::Unit;

/// Absolute tolerance per unit of relative tolerance, as a part of the unit that a quantity is declared in: what is
/// declared in metres is right to a micrometre at `rtol = 1e-3`, and to 1e-12 m at `rtol = 1e-9`.
const SCALE: f64 = 1e-3;

/// What is to be compiled.
pub struct Task<'a> {
    /// The file.
    pub file: &'a File,
    /// Its effects, choices and scenes.
    pub survey: &'a Survey<'a>,
    /// What is switched on.
    pub selected: &'a Selected,
    /// The scene; none when the selection is compiled only to check branches that no scene shows.
    pub scene: Option<(&'a Scene, &'a [String])>,
    /// Whether it is the first scene, to which facts without a scene belong.
    pub is_first: bool,
}

impl Task<'_> {
    /// Whether the scene is a motion over a stretch of time, of which there are measures.
    fn runs(&self) -> bool {
        let mut items = self.scene.iter().flat_map(|(scene, _)| &scene.items);
        items.any(|item| matches!(item, SceneItem::Run { .. } | SceneItem::Periodic { .. }))
    }
}

/// What compiling a scene tells about the file.
pub struct Seen {
    /// What the expressions of all scenes may cost.
    pub budget: Rc<Budget>,
    /// Names that something refers to.
    pub used: BTreeSet<String>,
    /// Declared constants and abbreviations with their places.
    pub declared: Vec<(String, Span)>,
    /// Names of all constants with their kinds.
    pub constants: HashMap<String, (Kind, Span)>,
}

impl Seen {
    /// Nothing yet.
    pub fn new() -> Self {
        Self {
            budget: Rc::new(Budget::new(STEPS)),
            used: BTreeSet::new(),
            declared: Vec::new(),
            constants: HashMap::new(),
        }
    }
}

/// A mode, compiled.
pub struct Compiled {
    /// The scene as if it had no other mode.
    pub scene: SceneModel,
    /// Indices of the constants that it depends on, among all of the file.
    pub kept: Vec<usize>,
    /// Its events.
    pub events: Vec<EventInfo>,
    /// Speeds that are zero in it, by their places in the state vector.
    pub held: Vec<usize>,
    /// Which of its outputs, and measures, are zero here, and so of any kind.
    pub free: [Vec<bool>; 2],
}

/// The constants of a compiled mode.
#[derive(Clone, Copy)]
pub enum Keep<'a> {
    /// Those that it depends on.
    Own,
    /// These, which it and its neighbours depend on.
    These(&'a [usize]),
    /// They are what is asked for: the mode gets no program.
    Ask,
}

/// Compiles a scene as if it had one mode alone.
pub fn phase(
    task: &Task<'_>,
    phases: &Phases,
    here: usize,
    keep: Keep<'_>,
    seen: &mut Seen,
    diagnostics: &mut Diagnostics,
) -> Option<Compiled> {
    let before = diagnostics.error_count();
    let phase = &phases.all[here];
    let statements = &phase.statements;
    let mut names = Names::of(statements, diagnostics);
    names.absent = phase.absent.clone();
    let shared_outputs = names.outputs.len();
    for item in task.scene.iter().flat_map(|(scene, _)| &scene.items) {
        if let SceneItem::Output(output) = item {
            names.declare_output(output, String::new(), diagnostics);
        }
    }
    // A scene that says what it reports reports only that.
    let own_outputs = names.outputs.len() > shared_outputs;
    let reported = if own_outputs { shared_outputs.. } else { 0.. };

    let mut low = Lowering::new(
        &names,
        task.survey,
        task.selected,
        diagnostics,
        seen.budget.clone(),
    );
    let constants: Vec<Option<ConstantInfo>> = names
        .constants
        .iter()
        .enumerate()
        .map(|(index, declared)| low.aside(|low| low.constant(index as u32, declared)))
        .collect();
    let coordinates = names.coordinates.len();
    let mut units: Vec<Option<Unit>> = Vec::new();
    let mut dependent_units: Vec<Option<Unit>> = Vec::new();
    for (index, declared) in names.coordinates.iter().enumerate() {
        units.push(low.unknown(Symbol::Coordinate(index as u32), declared));
    }
    for (index, declared) in names.states.iter().enumerate() {
        units.push(low.unknown(Symbol::State(index as u32), declared));
    }
    for (index, declared) in names.dependents.iter().enumerate() {
        dependent_units.push(low.dependent(index as u32, declared));
    }
    low.moved = moved(&mut low, &names, task.scene.map(|(scene, _)| scene));
    let drives = low.drivers(&names, low.moved);
    let mut place = task.scene.map_or_else(
        || task.selected.describe(),
        |(scene, _)| format!("in the scene `{}`", scene.name.text),
    );
    if !phase.name.is_empty() {
        place += &format!(", mode `{}`,", phase.name);
    }
    let loops = Loops::read(statements, &mut low);
    let loop_texts = loops.texts.clone();
    let linkage = if low.diagnostics.error_count() == before && task.file.unread.is_empty() {
        Linkage::of(loops, &names, &place, &mut low)
    } else {
        None
    };

    low.loops_are_wrong = linkage.is_none();

    // Abbreviations in the order of the file, used or not, so that each mistake is found.
    for statement in statements {
        if let StatementKind::Let {
            target,
            arguments: None,
            ..
        } = &statement.kind
            && let Some(name) = crate::unroll::target_name(target, low.diagnostics)
            && let Some(Role::Let(_)) = names.table.get(&name.text).map(|entry| &entry.role)
        {
            low.begin(Some(statement.span));
            let used = low.used.contains(&name.text);
            let term = Term {
                span: name.span,
                kind: crate::syntax::tree::TermKind::Name(name.text.clone()),
            };
            low.aside(|low| low.term(&term));
            if !used {
                low.used.remove(&name.text);
            }
        }
    }

    let mut parts = Parts {
        texts: loop_texts,
        ..Parts::default()
    };
    for statement in statements {
        low.begin(Some(statement.span));
        parts.read(statement, &mut low);
    }
    low.begin(None);
    let mut equations = parts.equations(&mut low, &names);
    modes::check_holds(&mut low, &names, phase);
    stand_still(&mut low, &names, phase, &mut equations);
    let unknowns = unknown_names(&names);
    let given = state_symbols(&names);
    // Equations of statements that could not be read are missing in the balance.
    let solved = if low.diagnostics.error_count() == before && task.file.unread.is_empty() {
        motion::solve(
            &mut low.graph,
            &equations,
            &unknowns,
            &given,
            &place,
            low.diagnostics,
        )
    } else {
        None
    };

    let events = modes::read(&mut low, &names, phases, here);
    let outputs = facts::outputs(&mut low, &names.outputs[reported]);
    let literal = low.literal.take();
    let measures = match task.runs() {
        true => {
            let modes = phases.all.iter().map(|phase| phase.name.clone());
            let moments = (modes.collect(), phases.event_names());
            measures::read(&mut low, &names, moments)
        }
        false => Measures::default(),
    };
    let mut span = facts::task(&mut low, task.scene.map(|(scene, _)| scene));
    if low.moved == Moved::Swept {
        span.kind = SpanKind::Sweep;
    }
    let is_clock = span.kind == SpanKind::Periodic && span.values.is_empty();
    let is_still = names.coordinates.is_empty() && names.states.is_empty();
    if let Some((scene, _)) = task.scene.filter(|_| is_clock && is_still) {
        low.diagnostics.push(
            Diagnostic::error(scene.name.span, "nothing in this scene moves by itself")
                .hint("state the period: `periodic over 2*pi/n;`"),
        );
    }
    let free = [outputs.free, measures.free()];
    let is_linkage = low.moved != Moved::InTime;
    let geometry = Geometry::read(statements, &names, &mut low);
    let ranges = Ranges::read(&names, task.scene.map(|(scene, _)| scene), &mut low);
    let still = modes::still(&names, phase);
    let begins = here == phases.first;
    let start = facts::start(
        &mut low,
        &names,
        task.scene.map(|(scene, _)| scene),
        (span.kind == SpanKind::Run || is_clock) && begins,
        if begins { &still } else { &[] },
    );

    for (name, entry) in &names.table {
        if matches!(
            entry.role,
            Role::Constant(_) | Role::Let(_) | Role::Function(..)
        ) {
            seen.declared.push((name.clone(), entry.span));
        }
        if let Role::Constant(index) = entry.role {
            seen.constants.insert(
                name.clone(),
                (low.kind_of(Symbol::Parameter(index)), entry.span),
            );
        }
    }
    // An output that names its own value is used by being reported.
    let reported_names = names.outputs.iter().map(|output| output.name.text.clone());
    seen.used
        .extend(low.used.iter().cloned().chain(reported_names));

    if low.diagnostics.error_count() > before {
        return None;
    }
    let (solved, linkage) = (solved?, linkage?);
    let (scene, documentation) = task.scene?;
    let preset = facts::preset(&mut low, task.file, scene);
    let values: Vec<f64> = names
        .constants
        .iter()
        .zip(&constants)
        .map(|(declared, info)| {
            let chosen = preset.iter().flat_map(|(_, values)| values);
            let mut chosen = chosen.filter(|(name, _)| *name == declared.name.text);
            let default = info.as_ref().map_or(f64::NAN, |info| info.default);
            chosen.next().map_or(default, |(_, value)| *value)
        })
        .collect();
    let system = (&solved, equations.as_slice(), unknowns.as_slice());
    checks::masses(&mut low, &names, system, &values);
    let stretch = match span.kind {
        SpanKind::Run => checks::stretch(&low, &span.values, &values),
        _ => None,
    };
    let mut model = SceneModel {
        name: scene.name.text.clone(),
        summary: summary(scene.text.as_deref(), documentation),
        effects: task.selected.effects.iter().cloned().collect(),
        choices: task.selected.choices.clone().into_iter().collect(),
        preset: preset
            .as_ref()
            .map_or(String::new(), |(name, _)| name.clone()),
        constants: Vec::new(),
        drivers: driver_quantities(&low, &names),
        states: state_quantities(&names, &units),
        outputs: outputs.quantities,
        measures: measures.info(),
        primitives: measures.primitives,
        coordinates,
        scales: Vec::new(),
        equations: parts.texts,
        requirements: parts.requirements,
        span: span.kind,
        conservative: false,
        literal,
        marks: published::marks(&mut low, statements),
        expectations: Vec::new(),
        linkage: None,
        carried: Vec::new(),
        modes: Vec::new(),
        first: 0,
        program: program::Program::default(),
    };
    model.scales = model
        .states
        .iter()
        .map(|state| SCALE * state.factor)
        .collect();
    model.conservative = conservative(&mut low, &parts.energies, &equations);

    let mut request = Request {
        derivative: (0..coordinates)
            .map(|index| match still.contains(&index) {
                true => low.graph.zero(),
                false => low.graph.symbol(Symbol::Speed(index as u32)),
            })
            .collect(),
        outputs: outputs.values,
        measured: measures.looked_at,
        measures: measures.values,
        drivers: match low.moved {
            Moved::Swept => (0..names.drivers.len() as u32)
                .map(|index| low.graph.symbol(Symbol::Driver(index)))
                .collect(),
            _ => drives.iter().filter_map(|drive| drive.position).collect(),
        },
        mass: solved.mass.clone(),
        energy: energy(&mut low, &parts.energies),
        requirements: parts.conditions.clone(),
        span: span.values,
        start,
        states: 2 * coordinates + names.states.len(),
        surfaces: model.span == SpanKind::Run || phases.is_hybrid(),
        cycle: model.span == SpanKind::Periodic && phases.is_hybrid(),
        events: events.iter().map(|(event, _)| event.clone()).collect(),
        ..Request::default()
    };
    let highest: Vec<_> = (0..solved.derivatives.len() as u32)
        .map(|index| low.graph.symbol(Symbol::Acceleration(index)))
        .collect();
    request.derivative.extend(highest);
    request.jacobian = jacobian(&mut low, coordinates, &still, &solved);
    for (index, value) in solved.derivatives.iter().enumerate() {
        request
            .bindings
            .insert(Symbol::Acceleration(index as u32), *value);
    }
    if is_linkage {
        give_drivers(&mut request, names.drivers.len());
    } else {
        let positions = drives.iter().map(|drive| drive.position);
        for (index, position) in positions.enumerate() {
            let driver = Symbol::Driver(index as u32);
            request
                .bindings
                .extend(position.map(|value| (driver, value)));
        }
    }
    if !is_linkage {
        model.carried = linkage.carry(&mut low, &names, &drives, &values, &mut request)?;
    }
    for (index, symbol) in given.iter().enumerate() {
        request.inputs.insert(*symbol, Input::State(index as u32));
    }
    request.inputs.insert(Symbol::Time, Input::Time);
    for index in 0..model.primitives.len() as u32 {
        let found = (Symbol::Measured(index), Input::Measured(index));
        request.inputs.extend([found]);
    }
    if is_linkage {
        request.closing = linkage.closing(&mut low, &mut request, &geometry, &drives);
    }
    let kept = match keep {
        Keep::These(kept) => kept.to_vec(),
        Keep::Own | Keep::Ask => kept_constants(&low, &request),
    };
    if matches!(keep, Keep::Ask) {
        return Some(Compiled {
            scene: model,
            kept,
            events: Vec::new(),
            held: Vec::new(),
            free,
        });
    }
    for (new, old) in kept.iter().enumerate() {
        request
            .inputs
            .insert(Symbol::Parameter(*old as u32), Input::Parameter(new as u32));
        if let Some(info) = &constants[*old] {
            let mut info = info.clone();
            let fixed = preset
                .iter()
                .flat_map(|(_, values)| values)
                .find(|(name, _)| *name == info.quantity.name);
            if let Some((_, value)) = fixed {
                info.default = *value;
            }
            model.constants.push(info);
        }
    }
    request.parameters = kept.len();
    for requirement in &mut model.requirements {
        requirement.names = requirement
            .names
            .iter()
            .filter_map(|old| kept.iter().position(|one| one == old))
            .collect();
    }
    if is_linkage {
        let variables = linkage.variables(&names, &constants, &kept);
        linkage.differentiate(&mut low, &mut request, &variables, &kept);
        model.linkage = Some(linkage.info(
            &mut low,
            &names,
            &dependent_units,
            geometry,
            ranges,
            variables,
        ));
    }
    model.expectations = published::expectations(&mut low, task, &model, &measures.kinds, stretch);
    if low.diagnostics.error_count() > before {
        return None;
    }
    model.program = program::build(&mut low.graph, &request);
    let surfaces = model.program.surfaces.iter().enumerate();
    let place = scene.name.span;
    let surfaces = surfaces.map(|(index, guard)| EventInfo::surface(index, guard, here, place));
    let own = events.into_iter().map(|(_, info)| info);
    let speeds = still.iter().filter(|index| **index < coordinates);
    Some(Compiled {
        free,
        held: speeds.map(|index| coordinates + index).collect(),
        events: own.chain(surfaces).collect(),
        scene: model,
        kept,
    })
}

/// What a mode holds or does not have stands still; the equation of a coordinate that is held says what holds it.
fn stand_still(
    low: &mut Lowering<'_>,
    names: &Names,
    phase: &Phase,
    equations: &mut Vec<Equation>,
) {
    let still = modes::still(names, phase);
    equations.retain(|equation| equation.lagrange.is_none_or(|one| !still.contains(&one)));
    let unknowns = names.coordinates.len() + names.states.len();
    for index in &still {
        if equations.len() + still.len() <= unknowns {
            break;
        }
        // Of the equations of all modes the one that determines what is held, and nothing else, gives way.
        let own = Symbol::Acceleration(*index as u32);
        let common = &phase.statements[..phase.common];
        let alone = |equation: &Equation| {
            if common.iter().all(|one| one.span != equation.span) {
                return false;
            }
            let symbols = low.graph.symbols_of(equation.residual).iter();
            let mut highest = symbols.filter(|one| matches!(one, Symbol::Acceleration(_)));
            highest.next() == Some(&own) && highest.next().is_none()
        };
        let mut found = (0..equations.len()).filter(|place| alone(&equations[*place]));
        if let (Some(place), None) = (found.next(), found.next()) {
            equations.remove(place);
        }
    }
    let all: Vec<_> = names.coordinates.iter().chain(&names.states).collect();
    for index in still {
        let name = &all[index].name;
        equations.push(Equation {
            residual: low.graph.symbol(Symbol::Acceleration(index as u32)),
            name: format!("hold {}", name.text),
            span: name.span,
            lagrange: None,
        });
    }
}

/// What moves the drivers. A scene without states that closes loops, or sweeps, is a linkage.
fn moved(low: &mut Lowering<'_>, names: &Names, scene: Option<&Scene>) -> Moved {
    let items = || scene.iter().flat_map(|scene| &scene.items);
    let sweeps = items().any(|item| matches!(item, SceneItem::Sweep { .. }));
    let timed =
        items().any(|item| matches!(item, SceneItem::Run { .. } | SceneItem::Periodic { .. }));
    let state = names.coordinates.iter().chain(&names.states).next();
    match (state, names.dependents.first()) {
        (Some(_), _) if !sweeps => Moved::InTime,
        (None, None) if !sweeps => Moved::InTime,
        (None, _) if sweeps || !timed => Moved::Swept,
        (None, _) => Moved::Given,
        (Some(state), _) => {
            let message =
                "a scene with coordinates or states moves in time and has nothing to sweep";
            let place = scene.map_or(state.name.span, |scene| scene.name.span);
            low.diagnostics.push(
                Diagnostic::error(place, message).related(state.name.span, "this moves by itself"),
            );
            Moved::InTime
        }
    }
}

fn summary(text: Option<&str>, documentation: &[String]) -> String {
    let lines = documentation.join("\n").trim().to_string();
    match (text, lines.is_empty()) {
        (Some(text), true) => text.to_string(),
        (Some(text), false) => format!("{text}\n{lines}"),
        (None, _) => lines,
    }
}
