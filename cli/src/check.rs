//! `assur check`: every mistake of an equation file, without compiling any Rust.

use std::path::Path;

use assur_model::checked::{Model, SceneModel};
use assur_model::diagnostic::Severity;
use assur_model::program::Stage;

use crate::arguments::CheckArguments;
use crate::ask::file;
use crate::error::Failure;
use crate::show::number;
use crate::show::output::{complain, print};
use crate::show::style;
use crate::show::text::{Align, Columns};

/// Checks each file: messages go to standard error, what a right file holds to standard output.
///
/// # Errors
/// When a file has an error, after all files have been looked at.
pub fn execute(options: &CheckArguments) -> Result<(), Failure> {
    let mut wrong = false;
    for path in &options.files {
        if let Err(failure) = check(path) {
            complain(&failure.render(style::stderr()));
            wrong = true;
        }
    }
    if wrong { Err(Failure::said()) } else { Ok(()) }
}

fn check(path: &Path) -> Result<(), Failure> {
    let source = file::read(&path.display().to_string())?;
    let style = style::stderr();
    let name = source.name();
    let checked = source.compile(style).map_err(|message| {
        complain(&message);
        complain(&format!("{name}: 1 error\n"));
        Failure::said()
    })?;
    complain(&checked.messages(style));
    let count = [
        (checked.count(Severity::Error), "error"),
        (checked.count(Severity::Warning), "warning"),
        (checked.count(Severity::Note), "note"),
    ]
    .into_iter()
    .filter(|(count, _)| *count > 0)
    .map(|(count, what)| format!("{count} {what}{}", if count == 1 { "" } else { "s" }))
    .collect::<Vec<_>>()
    .join(", ");
    let Some(model) = &checked.compiled.model else {
        complain(&format!("{name}: {count}\n"));
        return Err(Failure::said());
    };
    let verdict =
        if count.is_empty() { "no error".to_owned() } else { format!("no error, {count}") };
    print(&format!("{name}: {verdict}\n{}", summary(model)))
}

/// The scenes with their size.
fn summary(model: &Model) -> String {
    let mut table = Columns::new([
        (model.name.as_str(), Align::Left),
        ("states", Align::Right),
        ("equations", Align::Right),
        ("unknowns", Align::Right),
        ("groups", Align::Right),
        ("operations", Align::Right),
        ("outputs", Align::Right),
        ("parameters", Align::Right),
    ]);
    for scene in &model.scenes {
        let sizes = match &scene.linkage {
            Some(linkage) => [
                String::new(),
                linkage.loops.len().to_string(),
                linkage.dependents.len().to_string(),
                linkage.groups.len().to_string(),
            ],
            None => [
                scene.states.len().to_string(),
                scene.equations.len().to_string(),
                String::new(),
                String::new(),
            ],
        };
        let rest = [
            number::count(operations(scene)),
            scene.outputs.len().to_string(),
            scene.constants.len().to_string(),
        ];
        table.row([scene.name.clone()].into_iter().chain(sizes).chain(rest));
    }
    table.render(style::stdout())
}

/// Operations of one evaluation of the derivative with the time-only values that it and the Jacobian need; of a linkage
/// those of one position.
fn operations(scene: &SceneModel) -> usize {
    let program = &scene.program;
    let results = &program.results;
    if let Some(linkage) = &scene.linkage {
        let closed = results.closing.of_position(&linkage.groups);
        return program.count(&closed, Stage::Instant) + program.count(&closed, Stage::State);
    }
    let evaluated: Vec<_> = results.derivative.iter().copied().chain(results.slopes()).collect();
    program.count(&evaluated, Stage::Instant) + program.count(&results.derivative, Stage::State)
}
