//! The sixth phase: what a scene asks for, as expressions.

use super::Here;
use crate::checked::{EventInfo, LiteralInfo, Measured, SpanKind};
use crate::diagnostic::Diagnostic;
use crate::expression::Expression;
use crate::facts::{self, Outputs, TaskValues};
use crate::linkage::{Geometry, Ranges};
use crate::lower::{Lowering, Moved};
use crate::measures::{self, Measures};
use crate::modes;
use crate::program::Event;
use crate::syntax::tree::{Scene, SceneItem};
use crate::synthesis::{self, Condition};

/// What is asked for.
pub struct Asked {
    /// The events of the mode.
    pub events: Vec<(Event<Expression>, EventInfo)>,
    /// The reported quantities.
    pub outputs: Outputs,
    /// The first number that depends on the units, in the motion or an output.
    pub literal: Option<LiteralInfo>,
    /// Numbers of a whole run.
    pub measures: Measures,
    /// What constants follow from while designs are sought.
    pub condition: Option<Condition>,
    /// The measures of whose squares what is made small is the sum.
    pub squares: Vec<usize>,
    /// The task with its times.
    pub span: TaskValues,
    /// What is drawn.
    pub geometry: Geometry,
    /// Where the drivers go.
    pub ranges: Ranges,
    /// Start values of the state vector.
    pub start: Vec<Expression>,
}

impl Asked {
    /// Lowers all of it; outputs are reported from the given one on.
    pub fn read(here: Here<'_>, reported: usize, still: &[usize], low: &mut Lowering<'_>) -> Self {
        let (names, scene) = (low.names, here.scene());
        let events = modes::read(low, names, here.phases, here.index);
        let outputs = facts::outputs(low, &names.outputs[reported..]);
        let literal = low.literal.take();
        let mut measures = match measured(low, scene) {
            Some(task) => {
                let modes = here.phases.all.iter().map(|phase| phase.name.clone());
                let moments = (modes.collect(), here.phases.event_names());
                let scenes = here.task.survey.scenes.iter();
                let tasks = scenes.filter_map(|(scene, _)| task_of(scene)).collect();
                measures::read(low, names, moments, (task, tasks))
            }
            None => Measures::default(),
        };
        let squares =
            scene.map_or_else(Vec::new, |scene| synthesis::squares(scene, &mut measures, low));
        let condition =
            scene.and_then(|scene| synthesis::condition(scene, &mut measures.looked_at, low));
        let span = task(here, low);
        let geometry = Geometry::read(&here.phase().statements, names, &outputs.values, low);
        let ranges = Ranges::read(names, scene, low);
        let begins = here.index == here.phases.first;
        let goes = matches!(span.kind, SpanKind::Run | SpanKind::Rest) || span.is_clock();
        let needed = begins && goes;
        let held = if begins { still } else { &[] };
        Self {
            events,
            outputs,
            literal,
            measures,
            condition,
            squares,
            span,
            geometry,
            ranges,
            start: facts::start(low, names, scene, needed, held),
        }
    }

    /// What is asked for of the motion.
    pub fn all(&self) -> Vec<Expression> {
        let events = self.events.iter().flat_map(|(event, _)| event.all());
        let outputs = self.outputs.values.iter().chain(&self.measures.looked_at).copied();
        outputs.chain(events).collect()
    }
}

/// What measures look at in a scene; none where drivers go over a grid, or nothing is done.
fn measured(low: &Lowering<'_>, scene: Option<&Scene>) -> Option<Measured> {
    let task = scene.and_then(task_of);
    match low.moved {
        Moved::InTime => task,
        Moved::Given => task.map(|_| Measured::Positions),
        Moved::Swept => {
            let items = scene.into_iter().flat_map(|scene| &scene.items);
            let swept = items.filter_map(|item| match item {
                SceneItem::Sweep { drivers } => Some(drivers.len()),
                _ => None,
            });
            let swept: usize = swept.sum();
            // A linkage without a task sweeps all its drivers.
            let all = low.names.drivers.len();
            (swept == 1 || swept == 0 && all == 1).then_some(Measured::Positions)
        }
    }
}

/// What a scene does.
fn task_of(scene: &Scene) -> Option<Measured> {
    scene.items.iter().find_map(|item| match item {
        SceneItem::Run { .. } => Some(Measured::Run),
        SceneItem::Periodic { .. } => Some(Measured::Periodic),
        SceneItem::Rest { .. } => Some(Measured::Rest),
        SceneItem::Sweep { .. } => Some(Measured::Positions),
        _ => None,
    })
}

fn task(here: Here<'_>, low: &mut Lowering<'_>) -> TaskValues {
    let mut span = facts::task(low, here.scene());
    if low.moved == Moved::Swept {
        span.kind = SpanKind::Sweep;
    }
    let is_still = low.names.coordinates.is_empty() && low.names.states.is_empty();
    let rests = span.kind == SpanKind::Rest;
    let is_read = here.task.file.unread.is_empty();
    let asks = is_still && is_read && (span.is_clock() || rests);
    if let Some(scene) = here.scene().filter(|_| asks) {
        let hint = match rests {
            true => {
                "state the position: `sweep phi 0 deg .. 10 deg;`, or what moves by `coordinate`"
            }
            false => "state the period: `periodic over 2*pi/n;`",
        };
        let report = Diagnostic::error(scene.name.span, "nothing in this scene moves by itself");
        low.diagnostics.push(report.hint(hint));
    }
    span
}
