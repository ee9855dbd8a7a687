//! What the page says of one mechanism.

use assur::registry::Mechanism;

use super::facts::{self, Row};
use super::markdown::{code, inline, paragraphs};
use super::picture::Picture;
use super::{PICTURES, equations, scenes};
use crate::error::Failure;

/// What the page says of one mechanism.
pub struct Article {
    /// The mechanism.
    pub mechanism: &'static Mechanism,
    /// Its picture, if there is anything to show.
    pub picture: Option<Picture>,
    /// Its published numbers beside the computed ones.
    pub rows: Vec<Row>,
}

impl Article {
    /// The text below the heading.
    ///
    /// # Errors
    /// When the mechanism refuses its own values.
    pub fn text(&self, files: Option<&str>) -> Result<String, Failure> {
        let mechanism = self.mechanism;
        let mut text = paragraphs(mechanism.summary);
        text += &origin(mechanism, files);
        text += &self.illustration();
        let equations = equations::excerpt(mechanism);
        if !equations.is_empty() {
            text += &format!("**Equations**\n\n```text\n{equations}```\n\n");
        }
        text += &format!("**Scenes**\n\n{}\n", scenes::table(mechanism)?);
        if !self.rows.is_empty() {
            text += &format!("**Published numbers**\n\n{}\n", facts::table(&self.rows));
        }
        Ok(text)
    }

    /// The first sentence of its documentation.
    pub fn summary(&self) -> String {
        let first = self.mechanism.summary.split("\n\n").next().unwrap_or_default();
        let line = first.split_whitespace().collect::<Vec<_>>().join(" ");
        let sentence = line.split(". ").next().unwrap_or_default();
        inline(sentence.trim_end_matches('.'))
    }

    fn illustration(&self) -> String {
        let Some(picture) = &self.picture else {
            return String::new();
        };
        let Mechanism { name, title, .. } = self.mechanism;
        let (scene, command) = (code(picture.scene.name), code(&picture.command()));
        format!("![{title}]({PICTURES}/{name}.svg)\n\nScene {scene}: {command}\n\n")
    }
}

/// Where it comes from: the source that it cites, and its equation file.
fn origin(mechanism: &Mechanism, files: Option<&str>) -> String {
    let mut lines = Vec::new();
    if !mechanism.source.is_empty() {
        lines.push(format!("Source: {}", inline(mechanism.source)));
    }
    let file = code(mechanism.file);
    match files {
        _ if mechanism.file.is_empty() => {}
        Some(files) => {
            let link = format!("{}/{}", files.trim_end_matches('/'), mechanism.file);
            lines.push(format!("Equation file: [{file}]({link})"));
        }
        None => lines.push(format!("Equation file: {file}")),
    }
    let lines: Vec<_> = lines.iter().map(|line| format!("{line}\n")).collect();
    // A backslash ends a line without ending the paragraph.
    lines.join("").trim_end().replace('\n', "\\\n") + "\n\n"
}
