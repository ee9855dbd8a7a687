//! An equation file: read, compiled, and its messages with an excerpt of the places that they are about.

use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use assur_model::checked::Compiled;
use assur_model::diagnostic::{Diagnostic, Severity};
use assur_model::lexer::{self, Lexed, Unreadable};
use assur_model::token::Span;

use crate::error::Failure;
use crate::style::Style;

/// Messages that are printed of one file; the rest is counted.
const SHOWN: usize = 50;

/// A file that may hold equations.
pub struct Source {
    /// The path as it was given.
    name: String,
    text: String,
}

impl Source {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, or is no text of a sensible size.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let bytes = read(path).map_err(|error| {
            Failure::request(format!("cannot read `{name}`"))
                .reason(error.to_string())
                .remedy("name an equation file: assur check FILE.eqn")
        })?;
        let text = lexer::text(&bytes).map_err(|unreadable| {
            // Of a longer file only the beginning was read.
            let message = match path.metadata().map(|data| data.len()) {
                Ok(size) if size > bytes.len() as u64 => format!(
                    "the file has {:.1} MiB; an equation file has at most 1 MiB",
                    size as f64 / f64::from(1 << 20)
                ),
                _ => unreadable.message,
            };
            let failure = Failure::request(message).place(&name);
            unreadable
                .hint
                .iter()
                .fold(failure, |failure, hint| failure.remedy(hint))
        })?;
        Ok(Self::new(name, text))
    }

    /// A text that is at hand.
    pub fn new(name: impl Into<String>, text: &str) -> Self {
        Self {
            name: name.into(),
            text: text.to_owned(),
        }
    }

    /// The path as it was given.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Compiles the file.
    ///
    /// # Errors
    /// The message, with its excerpt, about the place where the tokens of the file end being tokens.
    pub fn compile(&self, style: Style) -> Result<Checked<'_>, String> {
        let lexed = lexer::lex_file(&self.text).map_err(|error| self.unreadable(&error, style))?;
        let compiled = assur_model::compile(&lexed.tokens);
        Ok(Checked {
            source: self,
            lexed,
            compiled,
        })
    }

    fn unreadable(&self, error: &Unreadable, style: Style) -> String {
        self.excerpt(
            Severity::Error,
            &error.message,
            &[(error.range.clone(), "")],
            error.hint.as_deref(),
            style,
        )
    }

    /// A message with its places underlined, the first of them being what it is about.
    fn excerpt(
        &self,
        severity: Severity,
        message: &str,
        places: &[(Range<usize>, &str)],
        hint: Option<&str>,
        style: Style,
    ) -> String {
        let level = match severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let annotations = places.iter().enumerate().map(|(index, (range, words))| {
            let kind = if index == 0 {
                AnnotationKind::Primary
            } else {
                AnnotationKind::Context
            };
            let annotation = kind.span(range.clone());
            if words.is_empty() {
                annotation
            } else {
                annotation.label(*words)
            }
        });
        let snippet = Snippet::source(self.text.as_str())
            .path(self.name.as_str())
            .annotations(annotations);
        let help = hint.map(|hint| Level::HELP.message(hint));
        let group = level.primary_title(message).element(snippet).elements(help);
        let renderer = if style.is_coloured() {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        renderer.render(&[group]) + "\n\n"
    }
}

fn read(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?
        .take(lexer::LARGEST_FILE as u64 + 1)
        .read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What the compiler made of a file.
pub struct Checked<'a> {
    source: &'a Source,
    lexed: Lexed,
    /// The model and the messages.
    pub compiled: Compiled,
}

impl Checked<'_> {
    /// Messages of this severity.
    pub fn count(&self, severity: Severity) -> usize {
        let list = &self.compiled.diagnostics;
        list.iter().filter(|one| one.severity == severity).count()
    }

    /// All messages with their excerpts, errors and warnings in the order of the file.
    pub fn messages(&self, style: Style) -> String {
        let list = &self.compiled.diagnostics;
        let mut text: String = list
            .iter()
            .take(SHOWN)
            .map(|one| self.message(one, style))
            .collect();
        if list.len() > SHOWN {
            text += &format!("{} more messages are not shown\n\n", list.len() - SHOWN);
        }
        text
    }

    fn message(&self, diagnostic: &Diagnostic, style: Style) -> String {
        let mut places = vec![(self.range(diagnostic.span), "")];
        if let Some((span, words)) = &diagnostic.related {
            places.push((self.range(*span), words));
        }
        let hint = diagnostic.hint.as_deref();
        self.source.excerpt(
            diagnostic.severity,
            &diagnostic.message,
            &places,
            hint,
            style,
        )
    }

    /// Where a range of tokens stands in the text; the end of the text where there is no such token.
    fn range(&self, span: Span) -> Range<usize> {
        let end = self.source.text.trim_end().len();
        let of = |index: u32| self.lexed.ranges.get(index as usize).cloned();
        let first = of(span.first).unwrap_or(end..end);
        let last = of(span.last).unwrap_or(first.clone());
        first.start..last.end.max(first.end)
    }

    /// The line of a place, from 1.
    pub fn line(&self, span: Span) -> u32 {
        let before = &self.source.text[..self.range(span).start];
        before.matches('\n').count() as u32 + 1
    }
}
