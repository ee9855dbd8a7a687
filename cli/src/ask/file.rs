//! Mechanisms from equation files, which run without being compiled.

use std::path::Path;

use assur::registry::Mechanism;
use assur_interpreter::Origin;

use crate::error::Failure;
use crate::show::output::complain;
use crate::show::style;
use crate::source::{STANDARD_INPUT, Source};

/// Ending of the name of an equation file.
const ENDING: &str = "eqn";

/// Whether a name is that of a file and not of a mechanism: by its ending, or since it is a path.
pub fn is_file(name: &str) -> bool {
    let path = Path::new(name);
    name == STANDARD_INPUT || path.extension().is_some_and(|end| end == ENDING) || name.contains('/')
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

/// The mechanism of an equation file, `-` being standard input.
///
/// # Errors
/// When it cannot be read, or has an error; all messages about it are printed then.
pub fn mechanism(name: &str) -> Result<&'static Mechanism, Failure> {
    let source = match name {
        STANDARD_INPUT => Source::standard_input()?,
        name => Source::read(Path::new(name))?,
    };
    let style = style::stderr();
    let said = |messages: String| {
        complain(&messages);
        Failure::said()
    };
    let checked = source.compile(style).map_err(said)?;
    let Some(model) = &checked.compiled.model else {
        return Err(said(checked.messages(style)));
    };
    let file = Path::new(name).file_name().and_then(|file| file.to_str());
    let parts = checked.compiled.parts.iter();
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
