//! Tables in plain text: columns as wide as their contents, numbers with point under point.

use crate::show::style::Style;

/// How a column is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Words.
    Left,
    /// Whole numbers.
    Right,
    /// Numbers, aligned at their decimal points.
    Point,
}

/// A table under construction.
#[derive(Clone, Debug)]
pub struct Columns {
    align: Vec<Align>,
    rows: Vec<Vec<String>>,
}

/// Set before every row.
const INDENT: &str = "  ";
/// Set between columns.
const GAP: &str = "  ";

impl Columns {
    /// A table with a heading for each column.
    pub fn new<'a>(columns: impl IntoIterator<Item = (&'a str, Align)>) -> Self {
        let (headings, align) =
            columns.into_iter().map(|(heading, align)| (heading.to_owned(), align)).unzip();
        Self { align, rows: vec![headings] }
    }

    /// Adds a row; missing cells are empty.
    pub fn row<I: IntoIterator<Item = String>>(&mut self, cells: I) {
        self.rows.push(cells.into_iter().collect());
    }

    /// The whole table, each line ended, the headings faint.
    pub fn render(&self, style: Style) -> String {
        let headed = self.is_headed();
        let mut text = String::new();
        for (index, line) in self.lines().iter().enumerate() {
            text += &if index == 0 && headed { style.faint(line) } else { line.clone() };
            text.push('\n');
        }
        text
    }

    /// Whether any column has a heading.
    fn is_headed(&self) -> bool {
        self.rows[0].iter().any(|heading| !heading.is_empty())
    }

    /// The lines, the headings first unless all of them are empty; columns without any contents are left out.
    fn lines(&self) -> Vec<String> {
        let cell =
            |row: usize, column: usize| self.rows[row].get(column).map_or("", String::as_str);
        let used: Vec<_> = (0..self.align.len())
            .filter(|column| (1..self.rows.len()).any(|row| !cell(row, *column).is_empty()))
            .collect();
        let shapes: Vec<_> = used.iter().map(|column| self.shape(*column)).collect();
        let first = usize::from(!self.is_headed());
        let mut lines = Vec::new();
        for row in first..self.rows.len() {
            let mut line = INDENT.to_owned();
            for (column, shape) in used.iter().zip(&shapes) {
                if line.len() > INDENT.len() {
                    line += GAP;
                }
                line += &shape.set(cell(row, *column), row == 0);
            }
            lines.push(line.trim_end().to_owned());
        }
        lines
    }

    fn shape(&self, column: usize) -> Shape {
        let mut shape = Shape { align: self.align[column], width: 0, before: 0 };
        let mut after = 0;
        for (index, row) in self.rows.iter().enumerate() {
            let cell = row.get(column).map_or("", String::as_str);
            shape.width = shape.width.max(width(cell));
            if index > 0 && shape.align == Align::Point {
                let (front, back) = parts(cell);
                shape.before = shape.before.max(front);
                after = after.max(back);
            }
        }
        shape.width = shape.width.max(shape.before + after);
        shape
    }
}

struct Shape {
    align: Align,
    width: usize,
    /// Characters before the decimal point.
    before: usize,
}

impl Shape {
    fn set(&self, cell: &str, heading: bool) -> String {
        let left = match self.align {
            Align::Left => 0,
            Align::Right => self.width - width(cell),
            Align::Point if heading => self.before.saturating_sub(1).min(self.width - width(cell)),
            Align::Point => self.before - parts(cell).0,
        };
        let text = " ".repeat(left) + cell;
        let missing = self.width.saturating_sub(width(&text));
        text + &" ".repeat(missing)
    }
}

/// Characters before the decimal point, and from it on.
fn parts(number: &str) -> (usize, usize) {
    let before = number.find(['.', 'e']).map_or(width(number), |place| width(&number[..place]));
    (before, width(number) - before)
}

/// Characters of a text; marks that stand over the character before them take no room.
pub fn width(text: &str) -> usize {
    text.chars().filter(|character| !('\u{300}'..='\u{36f}').contains(character)).count()
}

/// Breaks a text into lines of at most this many characters, at spaces.
pub fn wrap(text: &str, limit: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let Some(line) = lines.last_mut() else { break };
        if line.is_empty() {
            line.push_str(word);
        } else if width(line) + 1 + width(word) <= limit {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_stand_under_points() {
        let mut table =
            Columns::new([("name", Align::Left), ("value", Align::Point), ("unit", Align::Left)]);
        table.row(["a", "1.25", "mm"].map(String::from));
        table.row(["long", "-300.5", ""].map(String::from));
        table.row(["c", "2e-12", "s"].map(String::from));
        assert_eq!(
            table.lines(),
            [
                "  name     value  unit",
                "  a        1.25   mm",
                "  long  -300.5",
                "  c        2e-12  s"
            ]
            .map(String::from)
        );
    }

    #[test]
    fn empty_columns_and_headings_are_left_out() {
        let mut table = Columns::new([("", Align::Left), ("", Align::Left), ("", Align::Right)]);
        table.row(["a", "", "10"].map(String::from));
        table.row(["b", "", "9"].map(String::from));
        assert_eq!(table.lines(), ["  a  10", "  b   9"].map(String::from));
    }

    #[test]
    fn long_text_is_wrapped() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"].map(String::from));
    }
}
