//! Units and values as a user types them on a command line: `300rpm`, `0.1 [kg m^2]`, `20980 N m/rad`.

use super::{Dimension, Unit, hint, read, table};
use crate::diagnostic::Diagnostics;
use crate::lexer;
use crate::syntax::parser;

/// Why a text is no unit or no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    /// What is wrong.
    pub reason: String,
    /// What to do, if there is something to say.
    pub hint: Option<String>,
}

impl std::fmt::Display for UnitError {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.reason)?;
        self.hint.iter().try_for_each(|hint| write!(formatter, "; {hint}"))
    }
}

impl std::error::Error for UnitError {}

/// A number with its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// The number as it is written.
    pub number: f64,
    /// Its unit; none for a bare number.
    pub unit: Option<Unit>,
}

impl Value {
    /// The value in SI units.
    pub fn si(&self) -> f64 {
        self.unit.as_ref().map_or(self.number, |unit| unit.to_si(self.number))
    }
}

/// A unit without its brackets: `N m/rad`.
///
/// # Errors
/// What cannot be read, or is no unit.
pub fn parse_unit_text(text: &str) -> Result<Unit, UnitError> {
    read_text(text, true)
}

/// Reads a unit; a product of angles, which has no unit either, is refused where it is not `wanted`.
fn read_text(text: &str, wanted: bool) -> Result<Unit, UnitError> {
    let error = |reason: String| UnitError { reason, hint: None };
    let lexed = lexer::lex_plain(text).map_err(|_| error(format!("`{text}` is not a unit")))?;
    let mut diagnostics = Diagnostics::default();
    let Some(written) = parser::parse_unit(&lexed.tokens, &mut diagnostics) else {
        let first = diagnostics.into_sorted().into_iter().next();
        return Err(UnitError {
            reason: first
                .as_ref()
                .map_or_else(|| format!("`{text}` is not a unit"), |one| one.message.clone()),
            hint: first.and_then(|one| one.hint),
        });
    };
    let angles = written.factors.iter().filter(|(name, exponent)| {
        let pure = table::find(&name.text).is_some_and(|(unit, _)| unit == Dimension::NONE);
        pure && exponent.0 > 0
    });
    if !wanted && angles.count() > 1 {
        return Err(UnitError {
            reason: format!("`{text}` is a product of angles"),
            hint: Some("write one unit, or the product in brackets, as in `[deg^2]`".into()),
        });
    }
    read(&written.factors).map_err(|(name, reason)| UnitError {
        reason,
        hint: name.and_then(|name| hint(&name.text)),
    })
}

/// A number with or without a unit: `300rpm`, `300 rpm`, `0.1 [kg m^2]`, `1.9198`.
///
/// # Errors
/// What cannot be read, or is no unit.
pub fn parse_value(text: &str) -> Result<Value, UnitError> {
    let text = text.trim();
    let (number, rest) = split(text).ok_or_else(|| UnitError {
        reason: format!("`{text}` does not begin with a number"),
        hint: Some("write a number and its unit, as in `300rpm` or `0.1 [kg m^2]`".into()),
    })?;
    let rest = rest.trim();
    let bracketed = rest.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let inner = bracketed.unwrap_or(rest).trim();
    let unit = if inner.is_empty() { None } else { Some(read_text(inner, bracketed.is_some())?) };
    Ok(Value { number, unit })
}

/// The longest number at the beginning, and the rest. `inf` and `nan` are numbers, which whoever asks refuses.
fn split(text: &str) -> Option<(f64, &str)> {
    let ends = text.char_indices().map(|(index, character)| index + character.len_utf8());
    let mut found = None;
    for end in ends.take_while(|end| *end <= 64) {
        let part = &text[..end];
        let begins =
            part.chars().next_back().is_some_and(|last| last.is_ascii_digit() || last == '.');
        let word = matches!(
            part.trim_start_matches(['+', '-']).to_ascii_lowercase().as_str(),
            "inf" | "infinity" | "nan"
        );
        if let (true, Ok(number)) = (begins || word, part.parse::<f64>()) {
            found = Some((number, &text[end..]));
        }
    }
    found
}
