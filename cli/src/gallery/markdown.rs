//! Markdown as forges show it: texts in which nothing is markup by accident, and tables that can be read as they are.

/// Characters that are markup outside of code.
const MARKUP: [char; 8] = ['\\', '*', '_', '<', '[', ']', '|', '#'];

/// A text of a file in one line. What it has between back quotes stays code.
pub fn inline(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let parts = line.split('`').collect::<Vec<_>>();
    // The last of an even number of parts follows a back quote that opens nothing.
    let is_code = |index: usize| index % 2 == 1 && index + 1 < parts.len();
    let parts = parts.iter().enumerate().map(|(index, part)| match is_code(index) {
        true => code(part),
        false if index % 2 == 1 => format!("\\`{}", plain(part)),
        false => plain(part),
    });
    parts.collect()
}

fn plain(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        if MARKUP.contains(&character) {
            safe.push('\\');
        }
        safe.push(character);
    }
    safe
}

/// A text as code, fit for a cell of a table; nothing for nothing.
pub fn code(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("`{}`", text.replace('|', "\\|")) }
}

/// A text in paragraphs.
pub fn paragraphs(text: &str) -> String {
    let lines = text.lines().map(str::trim).collect::<Vec<_>>().join("\n");
    let paragraphs = lines.split("\n\n").filter(|paragraph| !paragraph.trim().is_empty());
    paragraphs.map(|paragraph| inline(paragraph) + "\n\n").collect()
}

/// The anchor of a heading.
pub fn anchor(heading: &str) -> String {
    let lower = heading.to_lowercase();
    let kept = |character: &char| character.is_alphanumeric() || matches!(character, '-' | '_');
    lower.replace(' ', "-").chars().filter(kept).collect()
}

/// A table, its columns as wide as their contents but for the last one.
pub struct Table {
    right: Vec<bool>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these columns, some of which stand at their right ends.
    pub fn new(columns: &[&str], right: &[&str]) -> Self {
        Self {
            right: columns.iter().map(|column| right.contains(column)).collect(),
            rows: vec![columns.iter().map(|column| (*column).to_owned()).collect()],
        }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The table, each line ended; nothing without rows. Columns without contents are left out.
    pub fn render(mut self) -> String {
        let used = |column: usize| self.rows[1..].iter().any(|row| !row[column].is_empty());
        let used: Vec<_> = (0..self.right.len()).map(used).collect();
        self.right = kept(&self.right, &used);
        self.rows = self.rows.iter().map(|row| kept(row, &used)).collect();
        let (heading, rows) = self.rows.split_at(1);
        if rows.is_empty() {
            return String::new();
        }
        let rule = self.right.iter().enumerate().map(|(column, right)| {
            let line = "-".repeat(self.width(column).max(3) - usize::from(*right));
            if *right { line + ":" } else { line }
        });
        let rule: Vec<_> = rule.collect();
        let lines = heading.iter().chain([&rule]).chain(rows);
        lines.map(|cells| self.line(cells)).collect()
    }

    fn line(&self, cells: &[String]) -> String {
        let last = cells.len() - 1;
        let set = |(column, cell): (usize, &String)| {
            let missing = self.width(column).max(3).saturating_sub(width(cell));
            match (self.right[column], column == last) {
                (true, _) => " ".repeat(missing) + cell,
                (false, true) => cell.clone(),
                (false, false) => cell.clone() + &" ".repeat(missing),
            }
        };
        let cells: Vec<_> = cells.iter().enumerate().map(set).collect();
        format!("| {} |\n", cells.join(" | "))
    }

    fn width(&self, column: usize) -> usize {
        let cells = self.rows.iter().map(|row| width(&row[column]));
        cells.max().unwrap_or(0)
    }
}

/// What stands in the columns that are used.
fn kept<T: Clone>(row: &[T], used: &[bool]) -> Vec<T> {
    let pairs = row.iter().zip(used);
    pairs.filter(|(_, used)| **used).map(|(one, _)| one.clone()).collect()
}

fn width(text: &str) -> usize {
    crate::show::text::width(text)
}

/// The cells of a line of a table; none for other lines.
pub fn cells(line: &str) -> Option<Vec<String>> {
    let inner = line.trim().strip_prefix('|')?.strip_suffix('|')?;
    // A stroke behind a backslash is no border.
    let parts = inner.replace("\\|", "\u{0}");
    Some(parts.split('|').map(|cell| cell.trim().replace('\u{0}', "\\|")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_by_accident_is_none() {
        assert_eq!(inline("a_b*c\nwith `x_1*|y|` [N]"), r"a\_b\*c with `x_1*\|y\|` \[N\]");
        assert_eq!(inline("5` of"), r"5\` of");
    }

    #[test]
    fn tables_can_be_read_as_they_are() {
        let mut table = Table::new(&["name", "none", "n", "more"], &["n"]);
        table.row(["a", "", "10", "x"].map(String::from).to_vec());
        table.row([code("a|b"), String::new(), "-3.5".into(), String::new()].to_vec());
        let text = table.render();
        assert_eq!(text.lines().nth(1), Some("| ------ | ---: | ---- |"));
        let last = text.lines().last().expect("two rows");
        assert_eq!(cells(last).expect("a row"), [r"`a\|b`", "-3.5", ""]);
    }

    #[test]
    fn headings_have_anchors() {
        assert_eq!(anchor("HealdLinkage"), "healdlinkage");
        assert_eq!(anchor("Four bar, two"), "four-bar-two");
    }
}
