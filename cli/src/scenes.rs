//! `assur scenes`: how large the scenes of a mechanism are, what they cost, and what each effect changes.

use assur::problem::Span;
use assur::registry::{Mechanism, SceneEntry, Settings};

use crate::arguments::ScenesArguments;
use crate::case::Case;
use crate::constants::Constants;
use crate::effects::{self, Cycle};
use crate::error::Failure;
use crate::list::composition;
use crate::lookup;
use crate::number;
use crate::output;
use crate::progress::Progress;
use crate::settings::{DEFAULT_RTOL, method};
use crate::style::{self, Style};
use crate::text::{Align, Columns};

/// Evaluations in one measurement of the time that they take.
const CALLS: usize = 5000;
/// Measurements, of which the shortest counts: the others were disturbed.
const REPEATS: usize = 5;
/// Seconds after which a measurement is not repeated.
const LONG: f64 = 0.1;

/// Compares the scenes of a mechanism.
///
/// # Errors
/// A wrong request; or a scene that does not come out, after the others have been printed.
pub fn execute(options: &ScenesArguments) -> Result<(), Failure> {
    let Some(name) = &options.name else {
        return Err(lookup::no_mechanism("scenes"));
    };
    let mechanism = lookup::mechanism(name)?;
    let settings = Settings {
        method: method(None)?,
        rtol: DEFAULT_RTOL,
    };
    let cases = mechanism
        .scenes
        .iter()
        .map(|scene| Case::new(constants(mechanism, scene, options)?))
        .collect::<Result<Vec<_>, _>>()?;
    let progress = Progress::start(format!("{name}, all scenes"), cases.len() as u64);
    let mut measured = Vec::new();
    for case in &cases {
        measured.push(Measured::of(case, settings));
        progress.advance();
    }
    drop(progress);
    let style = style::stdout();
    let mut text = format!(
        "{}\n{}",
        style.heading(&format!("{}: scenes", mechanism.title)),
        sizes(&cases, &measured, style)
    );
    let cycles: Vec<_> = measured
        .iter()
        .filter_map(|one| one.cycle.as_ref())
        .collect();
    text += &effects::render(mechanism, &cycles, style);
    output::print(&text)?;
    measured
        .into_iter()
        .find_map(|one| one.failure)
        .map_or(Ok(()), Err)
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
    let sets = options
        .set
        .iter()
        .filter(|text| has(scene, text) || !mechanism.scenes.iter().any(|other| has(other, text)));
    let sets: Vec<_> = sets.cloned().collect();
    Constants::from_options(mechanism, scene, options.preset.as_deref(), &sets)
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
        let evaluation = (0..REPEATS)
            .map(|_| case.run().time_evaluation(CALLS))
            .fold(f64::INFINITY, f64::min);
        let mut measured = Self {
            evaluation,
            seconds: None,
            cycle: None,
            failure: None,
        };
        let outcome = case.solve(settings).and_then(|motion| {
            if !case.scene.states.is_empty() && case.task != Span::Open {
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
        measured.failure = outcome
            .err()
            .map(|failure| failure.place(format!("scene {}", case.scene.name)));
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
            match case.task {
                Span::Open => "no task".to_owned(),
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
