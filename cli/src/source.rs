//! An equation file: read, compiled, and its messages with an excerpt of the places that they are about.

use std::fs;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use assur::registry::Mechanism;
use assur_model::asked::{Asked, CHANGES};
use assur_model::checked::Compiled;
use assur_model::diagnostic::{Diagnostic, Severity};
use assur_model::lexer::{self, Lexed, Unreadable};
use assur_model::texts::{Location, Texts};
use assur_model::token::Span;

use crate::error::Failure;
use crate::show::style::Style;

/// The name of standard input.
pub const STANDARD_INPUT: &str = "-";

/// Messages that are printed of one file; the rest is counted.
const SHOWN: usize = 50;

/// A file that may hold equations.
pub struct Source {
    /// The path as it was given.
    name: String,
    called: Option<String>,
    text: String,
    parts: Parts,
}

/// What is compiled of a file.
#[derive(Clone, Copy)]
pub enum Wanted<'a> {
    /// Some of its scenes.
    Scenes(Asked<'a>),
    /// The scene of a name, or the first one, with changes that are statements of the language.
    Changed(Option<&'a str>, &'a str),
}

/// Where the files of parts are.
enum Parts {
    /// In a folder, or below it.
    Folder(PathBuf),
    /// At hand, path and text.
    Texts(&'static [(&'static str, &'static str)]),
}

/// One place, of those that a message names.
type Annotated<'a> = (Range<usize>, &'a str);

impl Source {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, or is no text of a sensible size.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let cannot = Failure::request(format!("cannot read `{name}`"));
        if path.is_dir() {
            return Err(cannot.reason("it is a directory").remedy(format!(
                "name one of its equation files; `assur list {name}` shows them with their scenes"
            )));
        }
        // Of a pipe nobody may ever write the end.
        if path.metadata().is_ok_and(|data| !data.is_file()) {
            return Err(cannot.reason("it is no file").remedy(
                "what a program writes comes in through standard input: PROGRAM | assur run -",
            ));
        }
        let bytes = read(path).map_err(|error| {
            cannot
                .reason(error.to_string())
                .remedy("name an equation file that is there, as FILE.eqn")
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
            unreadable.hint.iter().fold(failure, |failure, hint| failure.remedy(hint))
        })?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { text: text.to_owned(), name, called: None, parts: Parts::Folder(folder) })
    }

    /// A text that is at hand, with those of the files of its parts.
    pub fn new(
        name: impl Into<String>,
        text: &str,
        parts: &'static [(&'static str, &'static str)],
    ) -> Self {
        Self { name: name.into(), called: None, text: text.to_owned(), parts: Parts::Texts(parts) }
    }

    /// Reads standard input; files of parts are looked for in the current directory.
    ///
    /// # Errors
    /// When it cannot be read, or is no text of a sensible size.
    pub fn standard_input() -> Result<Self, Failure> {
        let mut bytes = Vec::new();
        let input = std::io::stdin().lock().take(lexer::LARGEST_FILE as u64 + 1);
        { input }.read_to_end(&mut bytes).map_err(|error| {
            Failure::request("cannot read standard input").reason(error.to_string())
        })?;
        let text = lexer::text(&bytes).map_err(|unreadable| {
            let failure = Failure::request(unreadable.message).place("standard input");
            unreadable.hint.iter().fold(failure, |failure, hint| failure.remedy(hint))
        })?;
        let parts = Parts::Folder(PathBuf::new());
        let (name, called) = ("standard input".to_owned(), Some(STANDARD_INPUT.to_owned()));
        Ok(Self { text: text.to_owned(), name, called, parts })
    }

    /// That of a mechanism.
    ///
    /// # Errors
    /// When it has none.
    pub fn of(mechanism: &Mechanism) -> Result<Self, Failure> {
        if mechanism.text.is_empty() {
            return Err(Failure::request(format!(
                "`{}` is written inside a Rust file and has no equation file",
                mechanism.name
            ))
            .remedy("name a mechanism with a file of its own, as `assur list` shows them"));
        }
        Ok(Self::new(mechanism.file, mechanism.text, mechanism.parts))
    }

    /// What the mechanism is called by: the name under which it was asked for.
    pub fn called(&self) -> &str {
        self.called.as_deref().unwrap_or(&self.name)
    }

    /// The same, called by another name.
    pub fn call(self, name: &str) -> Self {
        Self { called: Some(name.to_owned()), ..self }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
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
        self.compile_asked(Wanted::Scenes(Asked::All), style)
    }

    /// Compiles some of its scenes, or one that is made of another.
    ///
    /// # Errors
    /// As [`Source::compile`].
    pub fn compile_asked(&self, wanted: Wanted<'_>, style: Style) -> Result<Checked<'_>, String> {
        let lexed = lexer::lex_file(&self.text).map_err(|error| self.unreadable(&error, style))?;
        let mut texts = Texts::default();
        let tokens;
        let asked = match wanted {
            Wanted::Scenes(asked) => asked,
            Wanted::Changed(base, changes) => {
                let read = texts.lex_statements(CHANGES, changes);
                tokens = read.map_err(|error| unreadable(CHANGES, changes, &error, style))?;
                Asked::Changed(base, &tokens)
            }
        };
        let compiled = assur_model::compile_asked(&lexed.tokens, asked, &mut |wanted| {
            let path = &wanted.path;
            match &self.parts {
                Parts::Folder(folder) => texts.read(folder, wanted),
                Parts::Texts(list) => {
                    let found = list.iter().find(|(one, _)| one == path);
                    texts.lex(wanted, found.map_or("", |(_, text)| text).as_bytes())
                }
            }
        });
        Ok(Checked { source: self, lexed, texts, compiled })
    }

    /// The path of the file of a part, as it would be given.
    fn beside(&self, path: &str) -> String {
        match &self.parts {
            _ if path == CHANGES => path.to_owned(),
            Parts::Folder(folder) => folder.join(path).display().to_string(),
            Parts::Texts(_) => path.to_owned(),
        }
    }

    fn unreadable(&self, error: &Unreadable, style: Style) -> String {
        unreadable(&self.name, &self.text, error, style)
    }
}

/// Why a text is none of tokens.
fn unreadable(name: &str, text: &str, error: &Unreadable, style: Style) -> String {
    let places = vec![(error.range.clone(), "")];
    let file = File { name: name.to_owned(), text, places };
    excerpt(Severity::Error, &error.message, &[file], error.hint.as_deref(), style)
}

/// A file with the places in it that a message names.
struct File<'a> {
    name: String,
    text: &'a str,
    places: Vec<Annotated<'a>>,
}

/// A message with its places underlined, the first of them being what it is about.
fn excerpt(
    severity: Severity,
    message: &str,
    files: &[File<'_>],
    hint: Option<&str>,
    style: Style,
) -> String {
    let level = match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let mut kind = AnnotationKind::Primary;
    let snippets = files.iter().map(|file| {
        let annotations = file.places.iter().map(|(range, words)| {
            let annotation =
                std::mem::replace(&mut kind, AnnotationKind::Context).span(range.clone());
            if words.is_empty() { annotation } else { annotation.label(*words) }
        });
        let annotations: Vec<_> = annotations.collect();
        Snippet::source(file.text).path(file.name.as_str()).annotations(annotations)
    });
    let snippets: Vec<_> = snippets.collect();
    let help = hint.map(|hint| Level::HELP.message(hint));
    let group = level.primary_title(message).elements(snippets).elements(help);
    let renderer = if style.is_coloured() { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&[group]) + "\n\n"
}

fn read(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    fs::File::open(path)?.take(lexer::LARGEST_FILE as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What the compiler made of a file.
pub struct Checked<'a> {
    source: &'a Source,
    lexed: Lexed,
    texts: Texts,
    /// The model and the messages.
    pub compiled: Compiled,
}

impl Checked<'_> {
    /// Messages of this severity.
    pub fn count(&self, severity: Severity) -> usize {
        let list = &self.compiled.diagnostics;
        list.iter().filter(|one| one.severity == severity).count()
    }

    /// All messages with their excerpts, errors, warnings and notes in the order of the file.
    pub fn messages(&self, style: Style) -> String {
        let list = &self.compiled.diagnostics;
        let mut text: String =
            list.iter().take(SHOWN).map(|one| self.message(one, style)).collect();
        if list.len() > SHOWN {
            text += &format!("{} more messages are not shown\n\n", list.len() - SHOWN);
        }
        text
    }

    fn message(&self, diagnostic: &Diagnostic, style: Style) -> String {
        let mut files = vec![self.file(diagnostic.span, "")];
        if let Some((span, words)) = &diagnostic.related {
            let other = self.file(*span, words);
            match files.iter_mut().find(|file| file.name == other.name) {
                Some(file) => file.places.extend(other.places),
                None => files.push(other),
            }
        }
        let hint = diagnostic.hint.as_deref();
        excerpt(diagnostic.severity, &diagnostic.message, &files, hint, style)
    }

    /// A place, with some words on it, in its file.
    fn file<'b>(&'b self, span: Span, words: &'b str) -> File<'b> {
        match self.part(span) {
            Some(place) => File {
                name: self.source.beside(place.path),
                text: place.text,
                places: vec![(place.range, words)],
            },
            None => File {
                name: self.source.name.clone(),
                text: &self.source.text,
                places: vec![(self.range(span), words)],
            },
        }
    }

    /// The text of the file of a part.
    pub fn text(&self, path: &str) -> &str {
        self.texts.text(path).unwrap_or_default()
    }

    /// Where a range of tokens stands, if in the file of a part.
    pub fn part(&self, span: Span) -> Option<Location<'_>> {
        self.texts.place(&self.compiled.parts, span)
    }

    /// Where a range of tokens stands in the text; the end of the text where there is no such token.
    fn range(&self, span: Span) -> Range<usize> {
        let end = self.source.text.trim_end().len();
        let of = |index: u32| self.lexed.ranges.get(index as usize).cloned();
        let first = of(span.first).unwrap_or(end..end);
        let last = of(span.last).unwrap_or(first.clone());
        first.start..last.end.max(first.end)
    }

    /// The line of a place, from 1; of the part that is meant, if it is in the file of one.
    pub fn line(&self, span: Span) -> u32 {
        let span = self.part(span).map_or(span, |place| place.part);
        let before = &self.source.text[..self.range(span).start];
        before.matches('\n').count() as u32 + 1
    }
}
