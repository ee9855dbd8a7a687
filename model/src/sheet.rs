//! Files of measured values: a line of heads with units, then a line of numbers for each point, between commas, semicolons or
//! tabs; `#` begins a remark.

use crate::lexer::Unreadable;

/// What stands in a file of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Its columns.
    pub columns: Vec<Column>,
    /// The line of each row in the file, from 1.
    pub lines: Vec<usize>,
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its head without the unit.
    pub name: String,
    /// The unit as it is written; empty for pure numbers.
    pub unit: String,
    /// The values in that unit.
    pub values: Vec<f64>,
}

/// How a file of values begins.
const HEADS: &str = "the first line names the columns with their units: `lift [mm], F [N]`";

impl Sheet {
    /// Reads a file.
    ///
    /// # Errors
    /// The first line that makes no sense.
    pub fn read(text: &str) -> Result<Self, Unreadable> {
        let lines = text.lines().map(str::trim).enumerate().map(|(index, line)| (index + 1, line));
        let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let Some((number, heads)) = lines.next() else {
            return Err(wrong(0, "there is nothing in it".into(), HEADS));
        };
        let separator = [';', '\t', ','].into_iter().find(|one| heads.contains(*one));
        let Some(separator) = separator else {
            let message = "there is one column only, and a curve needs two".into();
            return Err(wrong(number, message, HEADS));
        };
        let columns = heads.split(separator).map(|text| head(text, number));
        let mut sheet = Self { columns: columns.collect::<Result<_, _>>()?, lines: Vec::new() };
        for (number, line) in lines {
            sheet.row(number, line, separator)?;
        }
        Ok(sheet)
    }

    /// Reads a row.
    fn row(&mut self, number: usize, line: &str, separator: char) -> Result<(), Unreadable> {
        let cells: Vec<&str> = line.split(separator).map(str::trim).collect();
        if cells.len() != self.columns.len() {
            let message = format!(
                "there are {} values here, and {} columns",
                cells.len(),
                self.columns.len()
            );
            return Err(wrong(
                number,
                message,
                "give each column a value, separated as the heads are",
            ));
        }
        for (cell, column) in cells.into_iter().zip(&mut self.columns) {
            let name = &column.name;
            if cell.is_empty() {
                let message = format!("`{name}` has a gap here");
                return Err(wrong(
                    number,
                    message,
                    "take the line away, or fill in what was measured",
                ));
            }
            let value: f64 = cell.parse().map_err(|_| {
                let hint = match cell.contains(',') {
                    true => "a decimal number is written with a point: `1.5`",
                    false => "write a number without its unit, which stands in the head",
                };
                wrong(number, format!("`{cell}` of `{name}` is no number"), hint)
            })?;
            if !value.is_finite() {
                let message = format!("`{cell}` of `{name}` is no finite number");
                return Err(wrong(
                    number,
                    message,
                    "take the line away, or fill in what was measured",
                ));
            }
            column.values.push(value);
        }
        self.lines.push(number);
        Ok(())
    }

    /// The column with a head, its name alone or with the unit.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| {
            let whole = name.split('[').next().unwrap_or(name).trim();
            column.name == whole
        })
    }
}

/// A head: `F [N]`.
fn head(text: &str, line: usize) -> Result<Column, Unreadable> {
    let text = text.trim().trim_matches('"').trim();
    let (name, unit) = match text.split_once('[') {
        Some((name, rest)) => (name.trim(), rest.trim_end().strip_suffix(']')),
        None => (text, Some("")),
    };
    let unit = unit.ok_or_else(|| wrong(line, format!("`{text}` has no `]`"), HEADS))?;
    if name.is_empty() || name.parse::<f64>().is_ok() {
        return Err(wrong(line, format!("found `{text}`, expected a head"), HEADS));
    }
    Ok(Column { name: name.to_string(), unit: unit.trim().to_string(), values: Vec::new() })
}

fn wrong(line: usize, message: String, hint: &str) -> Unreadable {
    let message = if line > 0 { format!("line {line}: {message}") } else { message };
    Unreadable { range: 0..0, message, hint: Some(hint.to_string()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_read() {
        for separator in [",", ";", "\t", " , "] {
            let text = ["# measured", "lift [mm],F [N],n", "", "0,1e1,-1", "2.5,30,4"].join("\n");
            let sheet = Sheet::read(&text.replace(',', separator)).unwrap();
            assert_eq!(sheet.lines, [4, 5]);
            let lift = sheet.column("lift").unwrap();
            assert!(lift.values[1] == 2.5 && lift.unit == "mm");
            assert_eq!(sheet.column("F [N]").unwrap().values, [10.0, 30.0]);
            assert_eq!(sheet.column("n").unwrap().values, [-1.0, 4.0]);
            assert_eq!(sheet.column("m"), None);
        }
    }

    #[test]
    fn lines_that_make_no_sense_are_named() {
        let check = |text: &str, expected: &str| {
            assert_eq!(Sheet::read(text).unwrap_err().message, expected, "{text}");
        };
        check("# nothing", "there is nothing in it");
        check("a [mm]\n1", "line 1: there is one column only, and a curve needs two");
        check("0, 1\n1, 2", "line 1: found `0`, expected a head");
        check("a [mm, b\n1, 2", "line 1: `a [mm` has no `]`");
        check("a, b\n1, 2\n\n1, 2, 3", "line 4: there are 3 values here, and 2 columns");
        check("a, b\n1,\n", "line 2: `b` has a gap here");
        check("a; b\n1; 2,5", "line 2: `2,5` of `b` is no number");
        check("a, b\n1, NaN", "line 2: `NaN` of `b` is no finite number");
    }
}
