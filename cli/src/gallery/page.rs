//! The whole page: a list of contents, and a section for each mechanism.

use assur::registry::SceneEntry;

use super::article::Article;
use super::facts::{Computed, recalled};
use super::markdown::{anchor, cells};
use crate::error::Failure;
use crate::published::Stated;

/// What stands before the title of each section.
const HEADING: &str = "## ";

/// A page in sections.
pub struct Page(Vec<Section>);

/// A part of the page with a heading; the first one has the title of the page.
pub struct Section {
    title: String,
    body: String,
}

impl Page {
    /// The page of some mechanisms, with links to their files.
    ///
    /// # Errors
    /// When a mechanism refuses its own values.
    pub fn new(articles: &[Article], files: Option<&str>) -> Result<Self, Failure> {
        let mut sections =
            vec![Section { title: "its beginning".to_owned(), body: head(articles) }];
        for article in articles {
            let title = article.mechanism.title.to_owned();
            sections.push(Section { title, body: format!("\n{}", article.text(files)?) });
        }
        Ok(Self(sections))
    }

    /// A page that was written before.
    pub fn read(text: &str) -> Self {
        let mut sections = vec![Section { title: "its beginning".to_owned(), body: String::new() }];
        for line in text.lines() {
            if let Some(title) = line.strip_prefix(HEADING) {
                sections.push(Section { title: title.to_owned(), body: String::new() });
            } else if let Some(last) = sections.last_mut() {
                last.body += &format!("{line}\n");
            }
        }
        Self(sections)
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let sections = self.0.iter().enumerate().map(|(index, section)| match index {
            0 => section.body.clone(),
            _ => format!("{HEADING}{}\n{}", section.title, section.body),
        });
        sections.collect::<String>().trim_end().to_owned() + "\n"
    }

    /// The section of a title; an empty one if there is none.
    pub fn section(&self, title: &str) -> &Section {
        const NONE: &Section = &Section { title: String::new(), body: String::new() };
        self.0[1..].iter().find(|section| section.title == title).unwrap_or(NONE)
    }

    /// The sections in which another page differs, and the first line that does, in words; none if the texts are the same.
    pub fn differences(&self, other: &Self) -> Option<(Vec<String>, String)> {
        let (text, others) = (self.text(), other.text());
        let (mut lines, mut renewed) = (text.lines(), others.lines());
        let count = text.lines().count().max(others.lines().count());
        let pairs = (1..=count).map(|line| (line, lines.next(), renewed.next()));
        let (line, found, expected) = pairs.into_iter().find(|(_, a, b)| a != b)?;
        let shown =
            |text: Option<&str>| text.map_or("its end".to_owned(), |text| format!("`{text}`"));
        let first = format!("line {line}: found {}, expected {}", shown(found), shown(expected));
        let has = |page: &Self, one: &Section| {
            let mut sections = page.0.iter();
            sections.any(|other| other.title == one.title && other.body.trim() == one.body.trim())
        };
        let missing = self.0.iter().filter(|one| !has(other, one));
        let missing = missing.chain(other.0.iter().filter(|one| !has(self, one)));
        let mut titles: Vec<_> = missing.map(|one| one.title.clone()).collect();
        if titles.is_empty() {
            titles.push("the order of the mechanisms".to_owned());
        }
        titles.sort();
        titles.dedup();
        Some((titles, first))
    }
}

impl Computed for Section {
    fn text(&self, scene: &SceneEntry, stated: &Stated) -> Option<String> {
        let rows: Vec<_> = self.body.lines().filter_map(cells).collect();
        recalled(&rows, scene, stated)
    }
}

/// What stands before the first mechanism.
fn head(articles: &[Article]) -> String {
    let scenes: usize = articles.iter().map(|article| article.mechanism.scenes.len()).sum();
    let rows = articles.iter().flat_map(|article| &article.rows);
    let (all, within) = (rows.clone().count(), rows.filter(|row| row.is_within()).count());
    let contents = articles.iter().map(|article| {
        let title = article.mechanism.title;
        format!("- [{title}](#{}): {}\n", anchor(title), article.summary())
    });
    let contents: String = contents.collect();
    format!(
        "# Mechanisms\n\n\
         {} mechanisms with {scenes} scenes. Of {all} published numbers {within} lie within the bands of their files.\n\n\
         For each mechanism: its picture, its equations as they stand in its file and without all that they refer to, its \
         scenes with the commands that run them, and the published numbers beside the computed ones. A computed number has \
         one digit more than its band touches; the deviation is the computed number less the published one.\n\n\
         This page is written by `assur gallery`.\n\n\
         {contents}\n",
        articles.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# Mechanisms\n\n- [A](#a)\n\n## A\n\nFirst.\n\n## B\n\nSecond.\n";

    #[test]
    fn a_page_is_written_as_it_is_read() {
        let page = Page::read(PAGE);
        assert_eq!(page.text(), PAGE);
        assert!(page.differences(&Page::read(PAGE)).is_none());
        assert_eq!(page.section("B").body.trim(), "Second.");
    }

    #[track_caller]
    fn check(renewed: &str, titles: &[&str], first: &str) {
        let (found, line) = Page::read(PAGE).differences(&Page::read(renewed)).expect("another");
        assert_eq!(found, titles);
        assert_eq!(line, first);
    }

    #[test]
    fn sections_that_differ_are_named() {
        let changed = PAGE.replace("Second", "Third");
        check(&changed, &["B"], "line 11: found `Second.`, expected `Third.`");
        let longer = format!("{PAGE}\n## C\n");
        check(&longer, &["C"], "line 12: found its end, expected ``");
    }
}
