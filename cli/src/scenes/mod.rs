//! `assur scenes`: how large the scenes of a mechanism are, what they cost, and what each effect changes.

mod advice;
mod against;
mod combination;
mod contrast;
mod effects;
mod within;

use assur::answer::Settings;
use assur::closure::ClosureError;
use assur::problem::Span;
use assur::registry::{Mechanism, SceneEntry};
use assur::shape::LinkageEntry;

use crate::arguments::ScenesArguments;
use crate::ask::For;
use crate::ask::constants::Constants;
use crate::ask::lookup::{self, Registry};
use crate::error::Failure;
use crate::linkage::line::{Grid, Line};
use crate::linkage::{self, group};
use crate::list::composition;
use crate::motion::case::Case;
use crate::show::number;
use crate::show::output::{self, Destination};
use crate::show::page::Page;
use crate::show::progress::Progress;
use crate::show::style::{self, Style};
use crate::show::text::{Align, Columns};
use effects::Cycle;
use within::Advice;

/// Evaluations in one measurement of the time that they take.
const CALLS: usize = 5000;
/// Measurements, of which the shortest counts: the others were disturbed.
const REPEATS: usize = 5;
/// Seconds after which a measurement is not repeated.
const LONG: f64 = 0.1;

/// The scene, or where it comes to a dead point the same with all positions as coordinates.
fn going_on(case: Case, settings: &Settings) -> Result<Case, Failure> {
    match case.scene.unreduced {
        Some(scene) if case.solve(settings).is_err_and(|failure| failure.is_lost()) => {
            Case::new(case.constants.in_scene(scene))
        }
        _ => Ok(case),
    }
}

/// Compares the scenes of a mechanism.
///
/// # Errors
/// A wrong request; or a scene that does not come out, after the others have been printed.
pub fn execute(options: &ScenesArguments, registry: Registry) -> Result<(), Failure> {
    let destination = options.plot.as_deref().map(Destination::figure).transpose()?;
    let mechanism = registry.mechanism(options.name.as_deref(), "scenes", For::All)?;
    let base = fullest(mechanism, options.against.as_deref())?;
    if !options.within.is_empty() {
        return advise(options, mechanism, destination.as_ref());
    }
    let settings = Settings::default();
    let of_kind = |linkages: bool| {
        let scenes = mechanism.scenes.iter();
        scenes.filter(move |scene| scene.linkage.is_some() == linkages)
    };
    let cases = of_kind(false)
        .map(|scene| going_on(Case::new(constants(mechanism, scene, options)?)?, &settings))
        .collect::<Result<Vec<_>, _>>()?;
    let linkages = of_kind(true)
        .map(|scene| linkage::case::Case::new(constants(mechanism, scene, options)?))
        .collect::<Result<Vec<_>, _>>()?;
    let parts = mechanism.scenes.len() as u64;
    let progress = Progress::start(format!("{}, all scenes", mechanism.name), parts);
    let mut measured = Vec::new();
    for case in &cases {
        measured.push(Measured::of(case, settings.clone()));
        progress.advance();
    }
    let mut moved = Vec::new();
    for case in &linkages {
        moved.push(Moved::of(case));
        progress.advance();
    }
    drop(progress);
    let style = style::stdout();
    let mut text = format!("{}\n", style.heading(&format!("{}: scenes", mechanism.title)));
    if !cases.is_empty() {
        text += &sizes(&cases, &measured, style);
    }
    if !linkages.is_empty() {
        text += &positions(&linkages, &moved, style);
    }
    let cycles = measured.iter().filter_map(|one| one.cycle.as_ref());
    let cycles = cycles.chain(moved.iter().filter_map(|one| one.cycle.as_ref()));
    text += &effects::render(mechanism, &cycles.collect::<Vec<_>>(), style);
    let compared =
        { measured.iter() }.filter_map(|one| Some((one.cycle.as_ref()?, one.seconds))).chain(
            moved.iter().filter_map(|one| Some((one.cycle.as_ref()?, Some(one.position * 1e-9)))),
        );
    let compared: Vec<_> = compared.collect();
    if let Some(fullest) = compared.iter().find(|one| std::ptr::eq(one.0.scene, base)) {
        let all = against::compare(&compared, fullest);
        let name = fullest.0.scene.name;
        if !all.is_empty() {
            let heading = format!("What the scenes save, and how far they are from {name}");
            text += &format!("\n{}\n", style.heading(&heading));
            text += &against::table(&all, fullest).render(style);
            let note = "  the largest difference of an output, of its amplitude in the scene where that is larger; scenes with the same task";
            text += &format!("{}\n", style.faint(note));
        }
        if let Some(destination) = &destination {
            let title = format!(
                "{}: what its scenes cost, and how far they are from {name}",
                mechanism.title
            );
            let own = cases.iter().find(|case| std::ptr::eq(case.scene, base));
            let solver = own.and_then(|own| against::by_tolerance(own, fullest.0));
            destination.write(against::figure(title, &all, fullest, solver).as_bytes())?;
            text += &format!("\nFigure: {}\n", destination.path().display());
        }
    }
    output::print(&text)?;
    let failures = measured.into_iter().filter_map(|one| one.failure);
    let mut failures = failures.chain(moved.into_iter().filter_map(|one| one.failure));
    failures.next().map_or(Ok(()), Err)
}

/// The scene that others are compared with: that of a name, or the one with most effects; of several the first with most
/// states.
///
/// # Errors
/// When there is no scene of this name.
fn fullest(
    mechanism: &'static Mechanism,
    name: Option<&str>,
) -> Result<&'static SceneEntry, Failure> {
    let rank = |scene: &SceneEntry| (scene.effects.len(), scene.states.len());
    if let Some(name) = name {
        let known: Vec<&str> = mechanism.scenes.iter().map(|scene| scene.name).collect();
        let found = mechanism.scenes.iter().find(|scene| scene.name == name);
        return found.ok_or_else(|| {
            Failure::request(format!("`{}` has no scene `{name}`", mechanism.name))
                .place(format!("--against {name}"))
                .remedy(lookup::suggestion(name, &known))
        });
    }
    let scenes = mechanism.scenes.iter().rev();
    scenes
        .max_by_key(|scene| rank(scene))
        .ok_or_else(|| Failure::request(format!("`{}` has no scenes", mechanism.name)))
}

/// Says which combination to take.
fn advise(
    options: &ScenesArguments,
    mechanism: &'static Mechanism,
    figure: Option<&Destination>,
) -> Result<(), Failure> {
    let advice = Advice::find(options, mechanism)?;
    let mut page = Page::new(style::stdout());
    advice::render(&mut page, &advice);
    if let Some(destination) = figure {
        destination.write(advice::figure(&advice).as_bytes())?;
        page.line("");
        page.figure(Some(destination.path()));
    }
    output::print(&page.text)
}

/// The values of a scene: of those given, the ones that it has.
///
/// # Errors
/// A wrong value, or a name that no scene has.
fn constants(
    mechanism: &'static Mechanism,
    scene: &'static SceneEntry,
    options: &ScenesArguments,
) -> Result<Constants, Failure> {
    let has = |scene: &SceneEntry, text: &str| {
        let name = text.split('=').next().unwrap_or("").trim();
        let mut constants = scene.constants.iter();
        constants.any(|constant| constant.quantity.name == name)
    };
    let sets =
        options.values.set.iter().filter(|text| {
            has(scene, text) || !mechanism.scenes.iter().any(|other| has(other, text))
        });
    let sets: Vec<_> = sets.cloned().collect();
    Constants::from_options(mechanism, scene, options.values.preset.as_deref(), &sets)
}

/// What was found out about one scene.
struct Measured<'a> {
    /// Nanoseconds of one evaluation.
    evaluation: f64,
    /// Seconds of following the motion over one cycle.
    seconds: Option<f64>,
    cycle: Option<Cycle<'a>>,
    failure: Option<Failure>,
}

impl<'a> Measured<'a> {
    fn of(case: &'a Case, settings: Settings) -> Self {
        let evaluation =
            (0..REPEATS).map(|_| case.run().time_evaluation(CALLS)).fold(f64::INFINITY, f64::min);
        let mut measured = Self { evaluation, seconds: None, cycle: None, failure: None };
        let outcome = case.solve(&settings).and_then(|motion| {
            let moves = !matches!(case.moved.task, Span::Open | Span::Rest);
            if !case.scene.states.is_empty() && moves {
                let mut best = f64::INFINITY;
                for _ in 0..REPEATS {
                    let seconds = case.time_cycle(&motion)?;
                    best = best.min(seconds);
                    if seconds > LONG {
                        break;
                    }
                }
                measured.seconds = Some(best);
            }
            measured.cycle = Cycle::of(case, &motion);
            Ok(())
        });
        measured.failure =
            outcome.err().map(|failure| failure.place(format!("scene {}", case.scene.name)));
        measured
    }
}

/// The table of sizes and times.
fn sizes(cases: &[Case], measured: &[Measured<'_>], style: Style) -> String {
    let mut table = Columns::new([
        ("", Align::Left),
        ("states", Align::Right),
        ("equations", Align::Right),
        ("operations", Align::Right),
        ("evaluation", Align::Right),
        ("cycle", Align::Right),
        ("of", Align::Left),
        ("with", Align::Left),
    ]);
    for (case, measured) in cases.iter().zip(measured) {
        let scene = case.scene;
        let has_states = !scene.states.is_empty();
        let operations = scene.operations.instant + scene.operations.derivative;
        let time = |seconds: Option<f64>| seconds.map_or("-".to_owned(), number::duration);
        table.row([
            scene.name.to_owned(),
            scene.states.len().to_string(),
            scene.equations.len().to_string(),
            number::count(operations),
            time(has_states.then_some(measured.evaluation * 1e-9)),
            time(measured.seconds),
            match case.moved.task {
                Span::Open => "no task".to_owned(),
                Span::Rest => "position of rest".to_owned(),
                Span::Autonomous => "own period".to_owned(),
                Span::Periodic(period) => format!("{} s", number::short(period)),
                Span::Run(from, to) => format!("{} s, whole run", number::short(to - from)),
            },
            composition(scene),
        ]);
    }
    let mut text = table.render(style);
    text += &style.faint(
        "  operations and measured time of one evaluation of the derivative; measured time of following one cycle\n",
    );
    text
}

/// What was found out about one linkage.
struct Moved<'a> {
    /// Nanoseconds of one position.
    position: f64,
    cycle: Option<Cycle<'a>>,
    failure: Option<Failure>,
}

impl<'a> Moved<'a> {
    fn of(case: &'a linkage::case::Case) -> Self {
        let position =
            (0..REPEATS).map(|_| case.run().time_position(CALLS)).fold(f64::INFINITY, f64::min);
        let told = |error: &ClosureError, what: &str| {
            let failure = case.tell(error).failure(what);
            failure.place(format!("scene {}", case.scene.name))
        };
        let (cycle, failure) = match case.grid(&Grid::fine(case)) {
            Ok(lines) => {
                let stop = lines.iter().find_map(|line| line.stops.first());
                let what = "the linkage does not reach the whole task";
                (cycle(case, &lines), stop.map(|error| told(error, what)))
            }
            Err(error) => (None, Some(told(&error, "the linkage cannot be put together"))),
        };
        Self { position, cycle, failure }
    }
}

/// The outputs along the task.
fn cycle<'a>(case: &'a linkage::case::Case, lines: &[Line]) -> Option<Cycle<'a>> {
    let samples = lines.iter().flat_map(|line| &line.samples);
    let nothing = || vec![f64::NAN; case.variables.len()];
    let values = samples.map(|sample| sample.as_ref().map_or_else(nothing, |one| case.values(one)));
    let axes = case.axes();
    let axes = axes.iter().map(|axis| (axis.quantity.name, axis.from, axis.to));
    (!lines.is_empty()).then(|| Cycle {
        scene: case.scene,
        variables: &case.variables,
        task: format!("{:?}", axes.collect::<Vec<_>>()),
        samples: values.collect(),
    })
}

/// The table of linkages: sizes, how they are solved, and times.
fn positions(cases: &[linkage::case::Case], moved: &[Moved<'_>], style: Style) -> String {
    let mut table = Columns::new([
        ("", Align::Left),
        ("loops", Align::Right),
        ("unknowns", Align::Right),
        ("operations", Align::Right),
        ("position", Align::Right),
        ("solved as", Align::Left),
        ("of", Align::Left),
        ("with", Align::Left),
    ]);
    for (case, moved) in cases.iter().zip(moved) {
        let operations = case.scene.operations;
        let time = match moved.position.is_finite() {
            true => number::duration(moved.position * 1e-9),
            false => "-".to_owned(),
        };
        table.row([
            case.scene.name.to_owned(),
            case.moved.entry.loops.len().to_string(),
            case.moved.entry.dependents.len().to_string(),
            number::count(operations.instant + operations.derivative),
            time,
            kinds(case.moved.entry),
            case.task_in_words(),
            composition(case.scene),
        ]);
    }
    let mut text = table.render(style);
    text += &style.faint(
        "  operations of one position, coupled equations being iterated once; measured time of one position\n",
    );
    text
}

/// The kinds of the groups, `2 RRR dyad + linear`.
fn kinds(entry: &LinkageEntry) -> String {
    let mut counted: Vec<(&str, usize)> = Vec::new();
    for of_group in entry.groups {
        let kind = group::kind(of_group.kind);
        match counted.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, count)) => *count += 1,
            None => counted.push((kind, 1)),
        }
    }
    let parts = counted.into_iter().map(|(kind, count)| match count {
        1 => kind.to_owned(),
        _ => format!("{count} {kind}"),
    });
    let parts: Vec<_> = parts.collect();
    if parts.is_empty() { "formulas".to_owned() } else { parts.join(" + ") }
}
