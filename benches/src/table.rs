//! Tables as Markdown with aligned columns, and the numbers in them.

/// A table: the first column holds names, the others numbers.
pub struct Table {
    title: String,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// An empty table with the names of its columns, units included.
    pub fn new(title: &str, columns: &[&str]) -> Self {
        let header = columns.iter().map(|column| column.to_string()).collect();
        Self { title: title.to_owned(), rows: vec![header] }
    }

    /// Adds a row. Missing cells at its end are empty.
    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        let mut row: Vec<String> = cells.into_iter().collect();
        assert!(row.len() <= self.rows[0].len(), "more cells than columns: {row:?}");
        row.resize(self.rows[0].len(), String::new());
        self.rows.push(row);
    }

    /// Prints the table.
    pub fn print(&self) {
        println!("\n### {}\n\n{}", self.title, self.text());
    }

    /// The table as text, without its title.
    fn text(&self) -> String {
        let columns = self.rows[0].len();
        let widths: Vec<usize> = (0..columns)
            .map(|column| {
                let cells = self.rows.iter().map(|row| row[column].chars().count());
                cells.max().unwrap_or(0).max(2)
            })
            .collect();
        let mut text = String::new();
        for (number, row) in self.rows.iter().enumerate() {
            for (column, cell) in row.iter().enumerate() {
                let width = widths[column];
                text += &match column {
                    0 => format!("| {cell:<width$} "),
                    _ => format!("| {cell:>width$} "),
                };
            }
            text += "|\n";
            if number == 0 {
                for (column, width) in widths.iter().enumerate() {
                    let end = if column == 0 { "-" } else { ":" };
                    text += &format!("|{}{end}", "-".repeat(width + 1));
                }
                text += "|\n";
            }
        }
        text
    }
}

/// A number with about four digits; a dash if there is none.
pub fn number(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(value) if value.abs() >= 999.5 => grouped(value),
        Some(value) => {
            let before = value.abs().max(1.0).log10().floor() as usize + 1;
            format!("{value:.*}", 4 - before)
        }
    }
}

/// A large number, rounded to a whole one, its thousands set apart.
fn grouped(value: f64) -> String {
    let digits = format!("{:.0}", value.abs());
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    if value < 0.0 {
        text.insert(0, '-');
    }
    text
}

/// A small number with its power of ten, `3.1e-12`.
pub fn power(value: f64) -> String {
    format!("{value:.1e}")
}

/// How many times as large a value is as another.
pub fn ratio(value: Option<f64>, reference: Option<f64>) -> String {
    match (value, reference) {
        (Some(value), Some(reference)) => format!("{:.2}", value / reference),
        _ => "–".to_owned(),
    }
}

/// Prints whether a ratio keeps its goal.
pub fn verdict(what: &str, value: Option<f64>, reference: Option<f64>, goal: f64) {
    let (Some(value), Some(reference)) = (value, reference) else {
        println!("- {what}: not measured (goal {goal})");
        return;
    };
    let found = value / reference;
    let word = if found <= goal { "pass" } else { "FAIL" };
    println!("- {what}: {found:.3} (goal {goal}) {word}");
}

/// Prints whether something is so many times as large as something else.
pub fn at_least(what: &str, value: Option<f64>, reference: Option<f64>, goal: f64) {
    let (Some(value), Some(reference)) = (value, reference) else {
        println!("- {what}: not measured (goal at least {goal})");
        return;
    };
    let found = value / reference;
    let word = if found >= goal { "pass" } else { "FAIL" };
    println!("- {what}: {found:.3} (goal at least {goal}) {word}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned() {
        let mut table = Table::new("none", &["name", "ns"]);
        table.row(["a".to_owned(), "12.5".to_owned()]);
        table.row(["longer".to_owned()]);
        let expected =
            "| name   |   ns |\n|--------|-----:|\n| a      | 12.5 |\n| longer |      |\n";
        assert_eq!(table.text(), expected);
    }

    #[test]
    fn numbers_have_four_digits() {
        assert_eq!(number(None), "–");
        assert_eq!(number(Some(0.1234)), "0.123");
        assert_eq!(number(Some(12.344)), "12.34");
        assert_eq!(number(Some(163.0)), "163.0");
        assert_eq!(number(Some(4_567_890.2)), "4 567 890");
        assert_eq!(number(Some(-1234.0)), "-1 234");
        assert_eq!(power(3.14e-12), "3.1e-12");
        assert_eq!(ratio(Some(3.0), Some(2.0)), "1.50");
        assert_eq!(ratio(None, Some(2.0)), "–");
    }
}
