//! `assur list`: what there is.

use std::fs;
use std::path::PathBuf;

use assur::registry::Mechanism;
use assur_model::asked::Asked;

use crate::arguments::ListArguments;
use crate::ask::file;
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::output;
use crate::show::style;
use crate::show::text::{Align, Columns, wrap};
use crate::source::Wanted;

/// Widest line of prose.
const WIDTH: usize = 96;

/// Prints every mechanism with its source and its scenes.
///
/// # Errors
/// A file or a directory that cannot be read; a file with an error, after the others have been printed. Or standard output
/// cannot be written.
pub fn execute(options: &ListArguments, registry: Registry) -> Result<(), Failure> {
    if options.paths.is_empty() {
        let text: String = registry.0.iter().map(described).collect();
        let end = match registry.0.first() {
            Some(first) => format!("run one:  assur run {}\n", first.name),
            None => "there is no mechanism yet: add a file to equations/\n".to_owned(),
        };
        return output::print(&(text + &end));
    }
    let mut wrong = None;
    for path in &files(&options.paths)? {
        let listed = file::read(&path.display().to_string())
            .and_then(|source| file::mechanism(&source, Wanted::Scenes(Asked::All)));
        match listed {
            Ok(mechanism) => output::print(&described(mechanism))?,
            Err(failure) => {
                output::complain(&failure.render(style::stderr()));
                wrong = Some(Failure::said());
            }
        }
    }
    wrong.map_or(Ok(()), Err)
}

/// The files that are meant: of a directory all equation files in it, in the order of their names.
fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for path in paths {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let cannot = |error: std::io::Error| {
            Failure::request(format!("cannot read the directory `{}`", path.display()))
                .reason(error.to_string())
        };
        let entries = fs::read_dir(path).map_err(cannot)?;
        let entries = entries.map(|entry| entry.map(|entry| entry.path()));
        let mut own: Vec<PathBuf> = entries.collect::<Result<_, _>>().map_err(cannot)?;
        own.retain(|path| path.extension().is_some_and(|end| end == "eqn") && path.is_file());
        own.sort();
        if own.is_empty() {
            return Err(Failure::request(format!("`{}` has no equation file", path.display()))
                .remedy(
                    "equation files end in `.eqn`; `assur new NAME` writes one to begin with",
                ));
        }
        files.extend(own);
    }
    Ok(files)
}

/// A mechanism with its source and its scenes.
fn described(mechanism: &Mechanism) -> String {
    let style = style::stdout();
    let mut text = format!("{}\n", style.heading(mechanism.name));
    for line in wrap(mechanism.summary, WIDTH) {
        text += &format!("  {line}\n");
    }
    if !mechanism.source.is_empty() {
        text += &format!("  {}\n", style.faint(&format!("source: {}", mechanism.source)));
    }
    let mut table = Columns::new([("", Align::Left); 3]);
    for (index, scene) in mechanism.scenes.iter().enumerate() {
        let lead = if index == 0 { "scenes" } else { "" };
        table.row([lead.to_owned(), scene.name.to_owned(), describe(scene)]);
    }
    for (index, preset) in mechanism.presets.iter().enumerate() {
        let lead = if index == 0 { "presets" } else { "" };
        table.row([lead.to_owned(), preset.name.to_owned(), preset.summary.to_owned()]);
    }
    text + &table.render(style) + "\n"
}

/// A scene in a few words: its own, or what is in it.
pub fn describe(scene: &assur::registry::SceneEntry) -> String {
    if let Some(line) = scene.summary.lines().next().filter(|line| !line.is_empty()) {
        return line.to_owned();
    }
    let drivers: Vec<_> = scene.drivers.iter().map(|driver| driver.name).collect();
    match scene.linkage.is_some() && !drivers.is_empty() {
        true => format!("{}, moved by {}", composition(scene), drivers.join(" and ")),
        false => composition(scene),
    }
}

/// Effects and choices of a scene, `torsion + bending + crank.exact`.
pub fn composition(scene: &assur::registry::SceneEntry) -> String {
    let effects = scene.effects.iter().map(|effect| (*effect).to_owned());
    let choices = scene.choices.iter().map(|(choice, made)| format!("{choice}.{made}"));
    let parts: Vec<_> = effects.chain(choices).collect();
    if parts.is_empty() { "no effect".to_owned() } else { parts.join(" + ") }
}
