//! A page of tables to read.

use std::path::Path;

use super::number;
use super::style::Style;
use super::text::{Align, Columns, wrap};
use crate::ask::constants::Constants;
use crate::list::composition;

/// Widest line of prose.
pub const WIDTH: usize = 96;

/// A page under construction.
pub struct Page {
    /// What is written so far, each line ended.
    pub text: String,
    /// How it is emphasised.
    pub style: Style,
}

impl Page {
    /// An empty page.
    pub fn new(style: Style) -> Self {
        Self { text: String::new(), style }
    }

    /// Adds a line.
    pub fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    /// Adds a sentence that deserves a second look, in as many lines as it takes.
    pub fn warn(&mut self, sentence: &str) {
        for line in wrap(sentence, WIDTH - 2) {
            let line = self.style.warn(&format!("  {line}"));
            self.line(&line);
        }
    }

    /// Adds a table under its heading; what belongs to it may follow.
    pub fn table(&mut self, heading: &str, table: &Columns) {
        let heading = self.style.heading(heading);
        self.line(&heading);
        self.text += &table.render(self.style);
    }

    /// Adds a table under its heading that stands for itself.
    pub fn section(&mut self, heading: &str, table: &Columns) {
        self.table(heading, table);
        self.line("");
    }

    /// Says where the figure is, if one was drawn.
    pub fn figure(&mut self, figure: Option<&Path>) {
        if let Some(path) = figure {
            self.line(&format!("Figure: {}", path.display()));
        }
    }

    /// Adds the title, the task in it, and what is in the scene.
    pub fn about(&mut self, constants: &Constants, task: &str) {
        let scene = constants.scene;
        let title = format!("{}, scene {}: {task}", constants.mechanism.title, scene.name);
        self.line(&self.style.heading(&title));
        let mut about = composition(scene);
        if !scene.summary.is_empty() {
            about = format!("{} ({about})", first_line(scene.summary));
        }
        if !constants.preset.is_empty() {
            about += &format!(", preset {}", constants.preset);
        }
        self.line(&format!("  {about}"));
        if !constants.changes.is_empty() {
            self.line(&format!("  changed: {}", constants.changes.join(" ")));
        }
        self.line("");
    }

    /// Adds the dimensions and parameters with their values.
    pub fn parameters(&mut self, constants: &Constants) {
        if constants.values.is_empty() {
            return;
        }
        let mut table = Columns::new([
            ("", Align::Left),
            ("", Align::Left),
            ("value", Align::Point),
            ("unit", Align::Left),
            ("default", Align::Point),
            ("", Align::Left),
        ]);
        for (index, constant) in constants.scene.constants.iter().enumerate() {
            let quantity = &constant.quantity;
            let declared = |value: f64| number::declared(value / quantity.factor);
            let (mark, default) = match constants.is_changed(index) {
                true => ("*", declared(constant.default)),
                false => ("", String::new()),
            };
            table.row([
                mark.to_owned(),
                quantity.name.to_owned(),
                declared(constants.values[index]),
                quantity.unit.to_owned(),
                default,
                first_line(quantity.summary).to_owned(),
            ]);
        }
        let heading = if constants.changed() { "Parameters (* changed)" } else { "Parameters" };
        self.section(heading, &table);
    }
}

/// What a documentation says in its first line.
pub fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}
