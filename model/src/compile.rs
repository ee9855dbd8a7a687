//! One mode of a scene from statements to program, in phases:
//!
//! ```text
//! declare -> close -> lower -> derive -> solve -> ask -> report -> request -> choose constants -> build
//! ```
//!
//! Each phase takes what the ones before it have found, and none looks ahead.

mod ask;
mod begin;
mod checks;
mod choose;
mod close;
mod declare;
mod derive;
mod felt;
mod forces;
mod lower;
mod quantities;
mod report;
mod request;

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use crate::checked::{EventInfo, SceneModel, SpanKind};
use crate::diagnostic::Diagnostics;
use crate::expression::{Budget, STEPS, Symbol};
use crate::linkage::{Augmented, Linkage};
use crate::lower::{Kind, Lowering};
use crate::modes::{self, Phase, Phases};
use crate::motion::{self, Columns, Equation, Solved, UnknownName};
use crate::program;
use crate::resolve::Role;
use crate::scene::{Selected, Survey};
use crate::statements::Parts;
use crate::syntax::tree::{File, Scene};
use crate::synthesis;
use crate::token::Span;

use ask::Asked;
use declare::Declared;

/// More coordinates than these that closures hold have a Jacobian of many entries, each solved for.
const SEVERAL: usize = 8;

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
    /// Whether closures that bind coordinates are not solved for, though they can be.
    pub is_unreduced: bool,
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

    fn take_up(&mut self, low: &Lowering<'_>) {
        for (name, entry) in &low.names.table {
            if let Role::Constant(index) = entry.role {
                let kind = low.kind_of(Symbol::Parameter(index));
                self.constants.insert(name.clone(), (kind, entry.span));
            }
            if let Role::Constant(_) | Role::Let(_) | Role::Function(..) = entry.role {
                self.declared.push((name.clone(), entry.span));
            }
        }
        // An output that names its own value is used by being reported.
        let outputs = low.names.outputs.iter();
        let reported = outputs.map(|output| output.name.text.clone());
        self.used.extend(low.used.iter().cloned().chain(reported));
    }
}

/// The mode of a scene that is compiled.
#[derive(Clone, Copy)]
pub struct Here<'a> {
    /// The scene.
    pub task: &'a Task<'a>,
    /// Its modes.
    pub phases: &'a Phases,
    /// Which of them.
    pub index: usize,
    /// Constants that it has in any case, by their indices among all of the file.
    pub constants: &'a [usize],
}

impl<'a> Here<'a> {
    fn phase(self) -> &'a Phase {
        &self.phases.all[self.index]
    }

    fn scene(self) -> Option<&'a Scene> {
        self.task.scene.map(|(scene, _)| scene)
    }

    /// Where this is, for messages.
    fn place(self) -> String {
        let place = match self.scene() {
            Some(scene) => format!("in the scene `{}`", scene.name.text),
            None => self.task.selected.describe(),
        };
        match self.phase().name.as_str() {
            "" => place,
            mode => format!("{place}, mode `{mode}`,"),
        }
    }
}

/// What the phases have found of a mode before anything is asked for.
struct Mode<'a> {
    here: Here<'a>,
    declared: Declared,
    linkage: Linkage,
    /// How the closures hold the coordinates, where they are not solved for.
    augmented: Option<Augmented>,
    parts: Parts,
    equations: Vec<Equation>,
    unknowns: Vec<UnknownName>,
    solved: Solved,
    /// Coordinates and states that stand still.
    still: Vec<usize>,
    /// Whether the motion is differentiated along a column instead of by each component of the state.
    is_along: bool,
    asked: Asked,
}

impl Mode<'_> {
    /// A motion ends where loops that move with it come to a dead point.
    fn end(&mut self, low: &mut Lowering<'_>) {
        if !self.declared.is_linkage() {
            let states = self.asked.start.len();
            let events = self.linkage.dead_points(low, states, self.here.index);
            self.asked.events.extend(events);
        }
    }

    /// Where a motion is sought that repeats, coordinates that turn are set back.
    fn turn(&mut self, low: &mut Lowering<'_>) {
        let Some(scene) = self.here.scene().filter(|_| self.asked.span.kind == SpanKind::Periodic)
        else {
            return;
        };
        let loops = self.linkage.equations.iter().map(|one| one.residual);
        let events = self.asked.events.iter().flat_map(|(event, _)| event.all());
        let roots: Vec<_> =
            self.solved.derivatives.iter().copied().chain(loops).chain(events).collect();
        let (start, index) = (&self.asked.start, self.here.index);
        self.asked.events.extend(modes::turning(low, &roots, start, index, scene.name.span));
    }
}

/// A mode, compiled.
pub struct Compiled {
    /// The scene as if it had no other mode.
    pub scene: SceneModel,
    /// Indices of its constants among all of the file.
    pub kept: Vec<usize>,
    /// Its events.
    pub events: Vec<EventInfo>,
    /// Speeds that are zero in it, by their places in the state vector.
    pub held: Vec<usize>,
    /// Which of its outputs, and measures, are zero here, and so of any kind.
    pub free: [Vec<bool>; 2],
}

/// Compiles a mode as if the scene had no other one.
pub fn mode(here: Here<'_>, seen: &mut Seen, diagnostics: &mut Diagnostics) -> Option<Compiled> {
    let before = diagnostics.error_count();
    let is_right = |low: &Lowering<'_>| low.diagnostics.error_count() == before;
    // Equations of statements that could not be read are missing in the balance.
    let is_complete = |low: &Lowering<'_>| is_right(low) && here.task.file.unread.is_empty();

    let (mut names, reported) = declare::names(here, diagnostics);
    let augmented = close::bind(here, &mut names, seen.budget.clone(), diagnostics);
    let (survey, selected) = (here.task.survey, here.task.selected);
    let budget = seen.budget.clone();
    let low = &mut Lowering::new(&names, survey, selected, diagnostics, budget);
    let declared = declare::quantities(here, low);
    let (texts, linkage) = close::close(here, low, augmented.is_some(), is_complete);
    let mut parts = lower::parts(here, texts, low);
    let still = modes::still(&names, here.phase());
    let mut equations = derive::equations(here, &mut parts, &still, low);
    if let (Some(_), Some(linkage)) = (&augmented, &linkage) {
        derive::hold(&mut equations, linkage, &still, low);
    }
    let unknowns = quantities::unknown_names(&names);
    let felt = felt::of(&parts, low);
    let is_along = augmented.is_some() && felt.is_empty() && names.coordinates.len() > SEVERAL;
    let mut solved = is_complete(low).then(|| {
        let felt = felt.iter().map(|index| Symbol::Felt(*index));
        let given: Vec<_> = quantities::state_symbols(&names).into_iter().chain(felt).collect();
        let (graph, place) = (&mut low.graph, here.place());
        let columns = match is_along {
            false => Columns::Each(&given),
            true => Columns::Along(&given),
        };
        let given = (columns, low.slopes.as_mut());
        let held = augmented.as_ref().map_or((0, &[][..]), |one| (one.rank, &one.sizes[..]));
        let unknowns = (&unknowns[..], held);
        motion::solve(graph, &equations, unknowns, given, &place, low.diagnostics)
    });
    if let (Some(Some(solved)), Some(linkage)) = (&mut solved, &linkage) {
        let mut bound = forces::bindings(&parts, linkage, solved, low);
        felt::settle(&felt::of(&parts, low), solved, &mut bound, low);
        low.bound = bound;
    }
    let asked = Asked::read(here, reported, &still, low);
    let place = here.task.scene.map_or(here.task.file.name.span, |(scene, _)| scene.name.span);
    let closures = augmented.as_ref().map_or(0, |one| 2 * one.closures);
    let own = &equations[..equations.len().saturating_sub(closures)];
    let felt = felt::of(&parts, low).into_iter().map(Symbol::Reaction);
    let felt: Vec<_> = felt.map(|symbol| low.graph.symbol(symbol)).collect();
    let forces = [asked.all(), felt].concat();
    forces::check_asked(low, (&forces, place), (&parts, own));
    if let (Some(augmented), Some(linkage)) = (&augmented, &linkage) {
        forces::check_determined(low, (&forces, place), augmented, linkage);
    }
    seen.take_up(low);
    if !is_right(low) {
        return None;
    }
    let mode = Mode {
        here,
        declared,
        linkage: linkage?,
        augmented,
        parts,
        equations,
        unknowns,
        solved: solved.flatten()?,
        still,
        is_along,
        asked,
    };
    program_of(mode, low)
}

/// What a mode without mistakes computes.
fn program_of(mut mode: Mode<'_>, low: &mut Lowering<'_>) -> Option<Compiled> {
    let before = low.diagnostics.error_count();
    mode.turn(low);
    mode.end(low);
    let (scene, documentation) = mode.here.task.scene?;
    let chosen = choose::values(mode.here, &mode.declared, low);
    checks::masses(low, &mode, &chosen.values);
    checks::freedoms(low, &mode, &chosen.values);
    checks::rest(low, &mode);
    let stretch = checks::stretch(low, &mode.asked.span, &chosen.values);
    let mut model = report::scene(&mode, scene, documentation, low);
    let mut request = request::of(&mode, low);
    let carried = request::loops(&mode, &chosen.values, &mut request, low)?;
    (model.carried, model.may_stop) = (carried.loops, carried.may_stop);
    let modes = carried.modes.len();
    model.requirements.extend(carried.modes);
    if !mode.declared.is_linkage() && !low.names.dependents.is_empty() {
        model.reduced = Some(request::reduced(&mode, low));
    }
    model.augmented = request::augmented(&mode);
    let kept = choose::constants(&mode, &chosen, &mut model, &mut request, low);
    if mode.declared.is_linkage() {
        model.linkage = Some(request::influences(&mode, &kept, &mut request, low));
    }
    model.synthesis = {
        let asked = (mode.asked.condition.take(), std::mem::take(&mut mode.asked.squares));
        synthesis::read(scene, &model, (&mode.declared.constants, &mode.linkage), asked, low)
    };
    synthesis::check_modes(&model, modes, low);
    let kinds = &mode.asked.measures.kinds;
    let file = (mode.here.task.file, mode.here.task.is_first);
    model.expectations = crate::published::expectations(low, file, &model, kinds, stretch);
    if low.diagnostics.error_count() > before {
        return None;
    }
    model.program = program::build(&mut low.graph, &request);
    Some(report::compiled(mode, model, kept))
}
