//! Modest colour, only on a terminal and never under `NO_COLOR`.

use std::io::IsTerminal;

/// Whether and how text is emphasised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    colour: bool,
}

impl Style {
    /// No emphasis at all.
    pub const PLAIN: Self = Self { colour: false };
    /// Emphasis by the escape codes of terminals.
    const COLOUR: Self = Self { colour: true };

    /// Whether colour is used.
    pub fn is_coloured(self) -> bool {
        self.colour
    }

    /// A heading.
    pub fn heading(self, text: &str) -> String {
        self.wrap("1", text)
    }

    /// A word that the eye should find.
    pub fn accent(self, text: &str) -> String {
        self.wrap("36", text)
    }

    /// The word before an error message.
    pub fn error(self, text: &str) -> String {
        self.wrap("1;31", text)
    }

    /// Something that deserves a second look.
    pub fn warn(self, text: &str) -> String {
        self.wrap("33", text)
    }

    /// What may be skipped.
    pub fn faint(self, text: &str) -> String {
        self.wrap("2", text)
    }

    fn wrap(self, code: &str, text: &str) -> String {
        if self.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }
}

/// The style of standard output.
pub fn stdout() -> Style {
    choose(std::io::stdout().is_terminal())
}

/// The style of standard error.
pub fn stderr() -> Style {
    choose(std::io::stderr().is_terminal())
}

fn choose(terminal: bool) -> Style {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    if terminal && !refused && !dumb { Style::COLOUR } else { Style::PLAIN }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_text_stays_plain() {
        assert_eq!(Style::PLAIN.heading("a"), "a");
        assert_eq!(Style::COLOUR.heading("a"), "\x1b[1ma\x1b[0m");
    }
}
