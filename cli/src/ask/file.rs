//! Mechanisms from equation files, which run without being compiled.

use std::path::Path;

use assur::registry::Mechanism;
use assur_interpreter::Origin;
use assur_model::asked::{Asked, CHANGES};

use super::lookup;
use crate::error::Failure;
use crate::show::output::complain;
use crate::show::style;
use crate::source::{STANDARD_INPUT, Source, Wanted};

/// Ending of the name of an equation file.
const ENDING: &str = "eqn";

/// Whether a name is that of a file and not of a mechanism: by its ending, or since it is a path.
pub fn is_file(name: &str) -> bool {
    let path = Path::new(name);
    name == STANDARD_INPUT
        || path.extension().is_some_and(|end| end == ENDING)
        || name.contains('/')
}

/// What the files that are written about a mechanism are called after.
pub fn stem(mechanism: &Mechanism) -> &str {
    match mechanism.name {
        STANDARD_INPUT => "standard-input",
        name if is_file(name) => {
            Path::new(name).file_stem().and_then(|stem| stem.to_str()).unwrap_or("mechanism")
        }
        name => name,
    }
}

/// A mechanism with all scenes of its file, of which others may have been left out; itself where it has no text.
pub fn whole(of: &'static Mechanism) -> &'static Mechanism {
    match assur_interpreter::again(of, Asked::All) {
        Ok(Some(whole)) => Box::leak(Box::new(whole)),
        _ => of,
    }
}

/// Reads an equation file, `-` being standard input.
///
/// # Errors
/// When it cannot be read.
pub fn read(name: &str) -> Result<Source, Failure> {
    match name {
        STANDARD_INPUT => Source::standard_input(),
        name => Source::read(Path::new(name)),
    }
}

/// The mechanism of an equation file with those scenes that are asked for.
///
/// # Errors
/// When it has an error; all messages about it are printed then.
pub fn mechanism(source: &Source, asked: Wanted<'_>) -> Result<&'static Mechanism, Failure> {
    let style = style::stderr();
    let said = |messages: String| {
        complain(&messages);
        Failure::said()
    };
    let checked = source.compile_asked(asked, style).map_err(&said)?;
    // A scene that is not there is told with all those that are.
    let is_missing = |name: &&str| !checked.compiled.scene_names.iter().any(|one| one == name);
    let missing = match asked {
        Wanted::Scenes(Asked::Some(names)) => names.iter().copied().find(is_missing),
        Wanted::Changed(Some(name), _) => Some(name).filter(is_missing),
        _ => None,
    };
    if let Some(missing) = missing {
        let whole = mechanism(source, Wanted::Scenes(Asked::All))?;
        lookup::scene(whole, Some(missing))?;
    }
    let Some(model) = &checked.compiled.model else {
        return Err(said(checked.messages(style)));
    };
    let name = source.called();
    let file = Path::new(name).file_name().and_then(|file| file.to_str());
    let parts = checked.compiled.parts.iter().filter(|part| part.path != CHANGES);
    let parts = parts.map(|part| (part.path.as_str(), checked.text(&part.path)));
    let origin = Origin {
        name,
        file: file.unwrap_or(name),
        text: source.text(),
        parts: parts.collect(),
        lines: &|span| checked.line(span),
    };
    Ok(Box::leak(Box::new(assur_interpreter::mechanism(model, &origin))))
}
