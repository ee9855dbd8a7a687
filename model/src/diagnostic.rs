//! What the compiler has to say about an equation file: one mistake, one message.

use crate::token::Span;

/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// The file means nothing until this is mended.
    Error,
    /// The file works, but probably not as meant.
    Warning,
    /// The file may well be meant like this. `assur check` says it, a build does not.
    Note,
}

/// One message: what was found, where, what explains it, and what to do.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Diagnostic {
    /// How serious it is.
    pub severity: Severity,
    /// The place.
    pub span: Span,
    /// What was found and what was expected.
    pub message: String,
    /// A second place that explains it, with a few words on it.
    pub related: Option<(Span, String)>,
    /// What to do about it.
    pub hint: Option<String>,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, span, message: message.into(), related: None, hint: None }
    }

    /// A warning at a place.
    pub fn warning(span: Span, message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(span, message) }
    }

    /// A note on a place.
    pub fn note(span: Span, message: impl Into<String>) -> Self {
        Self { severity: Severity::Note, ..Self::error(span, message) }
    }

    /// Adds the second place.
    #[must_use]
    pub fn related(mut self, span: Span, words: impl Into<String>) -> Self {
        self.related = Some((span, words.into()));
        self
    }

    /// Adds what to do.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// Adds the name that is likely meant, or else what to do.
    #[must_use]
    pub fn meant(self, near: Option<&str>, otherwise: impl Into<String>) -> Self {
        match near {
            Some(near) => self.hint(format!("did you mean `{near}`?")),
            None => self.hint(otherwise),
        }
    }
}

/// So many errors in one file are read by nobody.
const CROWD: usize = 20;

/// Collects messages; a message that is already there is not added again.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    seen: std::collections::HashSet<(Span, String)>,
    errors: usize,
}

impl Diagnostics {
    /// Adds a message unless the same one stands at the same place.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let mistake = diagnostic.message.clone();
        self.push_once(mistake, diagnostic);
    }

    /// Adds a message unless one about the same mistake stands at the same place: where the message names the scene,
    /// the mistake is what it says without it.
    pub fn push_once(&mut self, mistake: String, diagnostic: Diagnostic) {
        self.errors += usize::from(diagnostic.severity == Severity::Error);
        if self.seen.insert((diagnostic.span, mistake)) {
            self.list.push(diagnostic);
        }
    }

    /// Adds all messages of another collection.
    pub fn extend(&mut self, others: impl IntoIterator<Item = Diagnostic>) {
        others.into_iter().for_each(|diagnostic| self.push(diagnostic));
    }

    /// Number of errors so far; one that was met in an earlier scene counts again.
    pub fn error_count(&self) -> usize {
        self.errors
    }

    /// Whether there are so many errors that it pays no more to look for what each name may have meant.
    pub fn is_crowded(&self) -> bool {
        self.errors >= CROWD
    }

    /// Whether an error is among them.
    pub fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// The messages in the order of the file.
    pub fn into_sorted(mut self) -> Vec<Diagnostic> {
        self.list.sort_by_key(|diagnostic| (diagnostic.span.first, diagnostic.severity));
        self.list
    }
}
