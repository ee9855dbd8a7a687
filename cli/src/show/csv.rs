//! Comma-separated values (RFC 4180).

use assur::shape::Quantity;

use super::unit;

/// A heading: a name with its unit.
pub fn title(name: &str, unit: &str) -> String {
    let title = if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
    quoted(&title)
}

/// The headings of quantities.
pub fn titles(quantities: &[Quantity]) -> impl Iterator<Item = String> {
    quantities.iter().map(|one| title(one.name, one.unit))
}

/// The cells of values of quantities, each in its unit.
pub fn cells(quantities: &[Quantity], values: &[f64]) -> impl Iterator<Item = String> {
    quantities.iter().zip(values).map(|(one, value)| cell(unit::stated(*value, one.factor)))
}

/// A line with these cells.
pub fn line(cells: impl IntoIterator<Item = String>) -> String {
    cells.into_iter().collect::<Vec<_>>().join(",") + "\n"
}

/// A text as a cell.
pub fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// A number with all the digits of a double; an empty cell where there is none.
pub fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { String::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_with_commas_are_quoted() {
        assert_eq!(title("inner(u, v)", "m"), "\"inner(u, v) [m]\"");
        assert_eq!(title("x3", ""), "x3");
        assert_eq!(quoted("say \"a\"\nb"), "\"say \"\"a\"\"\nb\"");
    }

    #[test]
    fn missing_numbers_are_empty() {
        assert_eq!(cell(f64::NAN), "");
        assert_eq!(cell(0.1), "0.1");
    }
}
